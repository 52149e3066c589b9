/* The visit: long walks at random, with what must hold at every step. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "random.h"
#include "visit.h"

static const uint64_t S = 1000000, START = 1000000000;
enum { IDLE = 60, COUNTDOWN = 15, THANKS = 8, WASH = 6 };

static struct exhibit an_exhibit(int wake)
{
    struct exhibit exhibit = {.wake = wake};
    exhibit.visit = (struct exhibit_visit){.idle = IDLE, .countdown = COUNTDOWN, .thanks = THANKS, .wash = WASH};
    return exhibit;
}

/* What the kiosk would make of the orders. */
struct seen {
    bool palette, attract, power, status, washing;
    int kept; /* of this sheet */
    bool painted;
};

static void look(struct visit *visit, struct seen *seen)
{
    struct visit_order order;
    int count = 0;
    while (visit_order(visit, &order)) {
        assert_true(++count <= ORDER_KINDS);
        switch (order.kind) {
        case ORDER_KEEP:
            assert_true(seen->painted);
            assert_int_equal(seen->kept++, 0);
            break;
        case ORDER_SHEET:
            seen->kept = 0;
            seen->painted = seen->washing = false;
            break;
        case ORDER_WASH:
            assert_true(seen->painted && !seen->washing);
            seen->washing = true;
            break;
        case ORDER_PALETTE:
            assert_true(seen->palette != order.on);
            seen->palette = order.on;
            break;
        case ORDER_ATTRACT:
            seen->attract = order.on;
            break;
        case ORDER_POWER:
            seen->power = order.on;
            break;
        case ORDER_STATUS:
            assert_true(seen->status != order.on);
            seen->status = order.on;
            break;
        default:
            break;
        }
    }
    assert_true(seen->attract == (visit->state == VISIT_ATTRACT));
    assert_true(seen->palette ==
                (visit->state == VISIT_PAINTING || visit->state == VISIT_COUNTDOWN || visit->state == VISIT_CLOSING));
    assert_true(seen->power == (visit->state != VISIT_CLOSED || visit->status));
    assert_true(seen->status == visit->status);
    assert_false(seen->palette && seen->attract);
    assert_false(seen->washing && visit->state != VISIT_WASHING);
}

static void walks_at_random_end_in_attract(void **state)
{
    (void)state;
    uint64_t reached[VISIT_STATES] = {0};
    for (uint32_t walk = 0; walk < 400; walk++) {
        struct exhibit exhibit = an_exhibit(walk % 3 ? 0 : 2);
        struct visit visit;
        struct seen seen = {.power = true};
        uint64_t now = START, last = START;
        bool open = true;
        visit_init(&visit, &exhibit, now);
        look(&visit, &seen);
        for (int step = 0; step < 1000; step++) {
            uint32_t dice = random_bits(step, (int)walk, 1, RANDOM_XI);
            static const enum visit_event often[] = {VISIT_INPUT, VISIT_PAINT, VISIT_HOLD, VISIT_PAINT};
            enum visit_event event = (enum visit_event)(dice % VISIT_EVENTS);
            event = dice >> 8 & 3 ? often[dice >> 10 & 3] : event == VISIT_TIME ? VISIT_HOLD : event;
            now += (dice >> 12 & 7) == 0 ? (uint64_t)(dice >> 16) * 1500 : (uint64_t)(dice >> 16) * 60;
            if (event == VISIT_PAINT && !visit_paints(&visit)) {
                event = VISIT_INPUT;
            }
            seen.painted |= event == VISIT_PAINT;
            last = event == VISIT_INPUT || event == VISIT_PAINT || event == VISIT_STAFF ? now : last;
            open = event == VISIT_OPEN || (open && event != VISIT_CLOSE);
            visit_feel(&visit, event, now);
            look(&visit, &seen);
            visit_run(&visit, now);
            look(&visit, &seen);
            reached[visit.state]++;
        }
        if (visit.status) {
            visit_feel(&visit, VISIT_STAFF, now);
        }
        /* Nobody any more, but a hand that was forgotten; the wash is never over. */
        uint64_t end = last + (VISIT_HOLD_S + IDLE + COUNTDOWN + THANKS + 2 * WASH + VISIT_WASH_S + 1) * S;
        end = end > now ? end : now;
        end += (uint64_t)(visit.wake_s + VISIT_STATUS_S) * S; /* that the staff's view stood, and what was woken */
        while (now < end) {
            now += S / 2;
            visit_feel(&visit, VISIT_HOLD, now);
            visit_run(&visit, now);
            look(&visit, &seen);
        }
        assert_int_equal(visit.state, open ? VISIT_ATTRACT : VISIT_CLOSED);
        assert_int_equal(visit_timeout_ms(&visit, now), -1);
    }
    for (int i = 0; i < VISIT_STATES; i++) {
        assert_true(reached[i] > 500);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(walks_at_random_end_in_attract)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
