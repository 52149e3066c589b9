/* The staff's gesture: the chain, what breaks it, and whether visitors call it by chance. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "random.h"
#include "staff.h"

static const uint64_t MS = 1000;
static const float CORNER_X = 0.08f, CORNER_Y = 0.12f;

/* Top left, top right, bottom right, bottom left: held for three seconds. */
static struct staff a_staff(void)
{
    struct exhibit_staff def = {.taps = {0, 1, 2, 3}, .tap_count = 4, .within = 2, .hold = 3};
    struct staff staff;
    staff_init(&staff, &def, CORNER_X, CORNER_Y);
    return staff;
}

static void feel(struct staff *staff, enum event_kind kind, int slot, float x, float y, uint64_t ms)
{
    struct event event = {.kind = kind, .source = SOURCE_TOUCH, .slot = slot, .x = x, .y = y, .time_us = ms * MS};
    staff_feel(staff, &event);
}

static const float corners[4][2] = {{0.02f, 0.03f}, {0.98f, 0.02f}, {0.97f, 0.95f}, {0.05f, 0.99f}};

static void tap(struct staff *staff, int corner, uint64_t ms)
{
    feel(staff, EVENT_DOWN, 0, corners[corner][0], corners[corner][1], ms);
    feel(staff, EVENT_UP, 0, corners[corner][0], corners[corner][1], ms + 100);
}

/* Three taps from `ms` on, half a second apart. */
static void three(struct staff *staff, uint64_t ms)
{
    for (int i = 0; i < 3; i++) {
        tap(staff, i, ms + (uint64_t)i * 500);
    }
}

static void last(struct staff *staff, enum event_kind kind, uint64_t ms)
{
    feel(staff, kind, 0, corners[3][0], corners[3][1], ms);
}

static void the_whole_chain_calls_once(void **state)
{
    (void)state;
    struct staff staff = a_staff();
    assert_int_equal(staff_timeout_ms(&staff, 0), -1);
    three(&staff, 1000);
    assert_int_equal(staff_timeout_ms(&staff, 2500 * MS), -1);
    last(&staff, EVENT_DOWN, 2500);
    assert_int_equal(staff_timeout_ms(&staff, 2500 * MS), 3000);
    assert_false(staff_called(&staff, 5499 * MS));
    assert_int_equal(staff_timeout_ms(&staff, 5499 * MS), 1);
    assert_true(staff_called(&staff, 5500 * MS));
    assert_false(staff_called(&staff, 5500 * MS));
    assert_false(staff_called(&staff, 60000 * MS)); /* still held */
    last(&staff, EVENT_UP, 60000);
    assert_false(staff_called(&staff, 60000 * MS));
    /* And again; nobody asked until the finger had left. */
    three(&staff, 61000);
    last(&staff, EVENT_DOWN, 62500);
    last(&staff, EVENT_UP, 65500);
    assert_int_equal(staff_timeout_ms(&staff, 65500 * MS), 0);
    assert_true(staff_called(&staff, 65501 * MS));
    assert_false(staff_called(&staff, 65501 * MS));
}

static void what_is_not_the_chain_does_not_call(void **state)
{
    (void)state;
    struct staff staff = a_staff();
    three(&staff, 1000);
    last(&staff, EVENT_DOWN, 2500);
    last(&staff, EVENT_UP, 5400); /* not held for long enough */
    assert_false(staff_called(&staff, 9000 * MS));
    static const int wrong[][4] = {{1, 0, 2, 3}, {0, 0, 1, 2}, {0, 2, 1, 3}, {3, 2, 1, 0}, {0, 1, 3, 3}};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        staff = a_staff();
        for (int j = 0; j < 3; j++) {
            tap(&staff, wrong[i][j], 1000 + (uint64_t)j * 500);
        }
        feel(&staff, EVENT_DOWN, 0, corners[wrong[i][3]][0], corners[wrong[i][3]][1], 2500);
        assert_false(staff_called(&staff, 20000 * MS));
    }
    staff = a_staff(); /* too slow from one tap to the next */
    tap(&staff, 0, 1000);
    tap(&staff, 1, 3200);
    tap(&staff, 2, 3700);
    last(&staff, EVENT_DOWN, 4200);
    assert_false(staff_called(&staff, 20000 * MS));
    staff = a_staff(); /* a tap that lasts too long is none */
    feel(&staff, EVENT_DOWN, 0, 0.02f, 0.02f, 1000);
    feel(&staff, EVENT_UP, 0, 0.02f, 0.02f, 3100);
    tap(&staff, 1, 3300);
    tap(&staff, 2, 3800);
    last(&staff, EVENT_DOWN, 4300);
    assert_false(staff_called(&staff, 20000 * MS));
    staff = a_staff(); /* a tap beside the corner */
    three(&staff, 1000);
    feel(&staff, EVENT_DOWN, 0, CORNER_X + 0.01f, 0.99f, 2500);
    assert_false(staff_called(&staff, 20000 * MS));
    staff = a_staff(); /* a wrong one that begins the chain begins it */
    tap(&staff, 0, 1000);
    tap(&staff, 1, 1500);
    three(&staff, 2000);
    last(&staff, EVENT_DOWN, 3500);
    assert_true(staff_called(&staff, 6500 * MS));
}

static void fingers_that_move_or_are_not_alone_do_not_call(void **state)
{
    (void)state;
    struct staff staff = a_staff();
    three(&staff, 1000);
    last(&staff, EVENT_DOWN, 2500);
    feel(&staff, EVENT_MOVE, 0, 0.06f, 0.93f, 3000); /* within the corner */
    assert_true(staff_called(&staff, 5500 * MS));
    staff = a_staff();
    three(&staff, 1000);
    last(&staff, EVENT_DOWN, 2500);
    feel(&staff, EVENT_MOVE, 0, 0.2f, 0.9f, 3000);
    feel(&staff, EVENT_MOVE, 0, corners[3][0], corners[3][1], 3100);
    assert_false(staff_called(&staff, 9000 * MS));
    staff = a_staff(); /* somebody paints meanwhile */
    feel(&staff, EVENT_DOWN, 5, 0.5f, 0.5f, 500);
    three(&staff, 1000);
    last(&staff, EVENT_DOWN, 2500);
    assert_false(staff_called(&staff, 9000 * MS));
    staff = a_staff();
    three(&staff, 1000);
    last(&staff, EVENT_DOWN, 2500);
    feel(&staff, EVENT_DOWN, 5, 0.5f, 0.5f, 3000);
    feel(&staff, EVENT_UP, 5, 0.5f, 0.5f, 3100);
    assert_false(staff_called(&staff, 9000 * MS));
    staff = a_staff(); /* four corners at once are no chain */
    for (int i = 0; i < 4; i++) {
        feel(&staff, EVENT_DOWN, i, corners[i][0], corners[i][1], 1000 + (uint64_t)i * 100);
    }
    assert_false(staff_called(&staff, 9000 * MS));
    staff = a_staff(); /* it was no finger after all */
    three(&staff, 1000);
    last(&staff, EVENT_DOWN, 2500);
    last(&staff, EVENT_CANCEL, 2600);
    assert_false(staff_called(&staff, 9000 * MS));
    three(&staff, 10000); /* and is not down any more */
    last(&staff, EVENT_DOWN, 11500);
    assert_true(staff_called(&staff, 14500 * MS));
    /* More fingers than are counted. */
    staff = a_staff();
    for (int i = 0; i < 40; i++) {
        feel(&staff, EVENT_DOWN, i, 0.5f, 0.5f, 1000);
    }
    for (int i = 0; i < 40; i++) {
        feel(&staff, EVENT_UP, i, 0.5f, 0.5f, 1000);
    }
    three(&staff, 2000);
    last(&staff, EVENT_DOWN, 3500);
    assert_true(staff_called(&staff, 6500 * MS));
}

static void without_taps_there_is_no_chain(void **state)
{
    (void)state;
    struct exhibit_staff def = {.within = 2, .hold = 0};
    struct staff staff;
    staff_init(&staff, &def, 0.1f, 0.1f);
    tap(&staff, 0, 1000);
    feel(&staff, EVENT_DOWN, 0, 0, 0, 2000);
    assert_false(staff_called(&staff, 9000 * MS));
    def = (struct exhibit_staff){.taps = {2}, .tap_count = 1, .hold = 5}; /* a curator may want it simple */
    staff_init(&staff, &def, 0.1f, 0.1f);
    feel(&staff, EVENT_DOWN, 0, 0.99f, 0.99f, 10000);
    assert_true(staff_called(&staff, 15000 * MS));
}

/* Ten hours of somebody who paints all the time, four fingers at most, in corners more often than elsewhere. Never is
 * too few to measure, so the odds are computed as well: of taps in the corners it wants, alone and in time, one after
 * another, the last held. */
static void ten_hours_of_painting_do_not_call(void **state)
{
    (void)state;
    enum { FINGERS = 4 };
    struct staff staff = a_staff();
    uint64_t now = 0, up[FINGERS] = {0};
    int down[FINGERS] = {0}, taps = 0, alone[4] = {0}, held = 0, called = 0, most = 0;
    for (int i = 0; now < 36000000; i++) {
        uint32_t dice = random_bits(i, 0, 7, RANDOM_XI);
        int slot = (int)(dice % FINGERS), others = 0;
        now += 40 + (dice >> 8 & 0xff);
        for (int j = 0; j < FINGERS; j++) {
            if (down[j] && now >= up[j]) {
                feel(&staff, EVENT_UP, j, 0.5f, 0.5f, up[j]);
                down[j] = 0;
                most = staff.done > most ? staff.done : most;
            }
            others += down[j];
        }
        if (!down[slot]) {
            float x = random_unit(i, 1, 7, RANDOM_XI), y = random_unit(i, 2, 7, RANDOM_XI);
            x = dice >> 28 ? x : x * x * x * 0.1f; /* along an edge now and then */
            float long_one = random_unit(i, 3, 7, RANDOM_XI);
            up[slot] = now + (long_one > 0.97f ? 3500 : 60 + (uint64_t)(long_one * 600));
            down[slot] = 1;
            taps++;
            bool left = x <= CORNER_X, right = x >= 1 - CORNER_X, top = y <= CORNER_Y, bottom = y >= 1 - CORNER_Y;
            int corner = top && left ? 0 : top && right ? 1 : bottom && right ? 2 : bottom && left ? 3 : -1;
            if (corner >= 0 && others == 0) {
                alone[corner]++;
                held += up[slot] - now >= 3000;
            }
            feel(&staff, EVENT_DOWN, slot, x, y, now);
        } else {
            feel(&staff, EVENT_MOVE, slot, random_unit(i, 4, 7, RANDOM_XI), random_unit(i, 5, 7, RANDOM_XI), now);
        }
        called += staff_called(&staff, now * MS);
    }
    assert_int_equal(called, 0);
    assert_true(taps > 100000 && alone[0] > 300 && held > 10 && most >= 1);
    double odds = taps, corner_taps = 0;
    for (int i = 0; i < 4; i++) {
        odds *= (double)alone[i] / taps;
        corner_taps += alone[i];
    }
    odds *= held / corner_taps; /* that the last is held; what moves meanwhile or comes down makes it fewer still */
    print_message("%d touches in ten hours; a call by chance: %.1g\n", taps, odds);
    assert_true(odds < 1e-3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_whole_chain_calls_once),
        cmocka_unit_test(what_is_not_the_chain_does_not_call),
        cmocka_unit_test(fingers_that_move_or_are_not_alone_do_not_call),
        cmocka_unit_test(without_taps_there_is_no_chain),
        cmocka_unit_test(ten_hours_of_painting_do_not_call),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
