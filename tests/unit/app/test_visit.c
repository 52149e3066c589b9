/* The visit: every state with every event, and what time brings. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "visit.h"

static const uint64_t S = 1000000, START = 1000000000;
enum { IDLE = 60, COUNTDOWN = 15, THANKS = 8, WASH = 6 };

static struct exhibit an_exhibit(int wake)
{
    struct exhibit exhibit = {.wake = wake};
    exhibit.visit = (struct exhibit_visit){.idle = IDLE, .countdown = COUNTDOWN, .thanks = THANKS, .wash = WASH};
    return exhibit;
}

static const char *const event_names[VISIT_EVENTS] = {
    [VISIT_INPUT] = "input",   [VISIT_PAINT] = "paint",   [VISIT_HOLD] = "hold",   [VISIT_TIME] = "time",
    [VISIT_FINISH] = "finish", [VISIT_WASHED] = "washed", [VISIT_STAFF] = "staff", [VISIT_OPEN] = "open",
    [VISIT_CLOSE] = "close",   [VISIT_RELOAD] = "reload", [VISIT_SCENE] = "scene",
};

static const char *const order_names[ORDER_KINDS] = {
    [ORDER_KEEP] = "keep",       [ORDER_SCENE] = "scene",     [ORDER_SHEET] = "sheet",
    [ORDER_WASH] = "wash",       [ORDER_WELCOME] = "welcome", [ORDER_PALETTE] = "palette",
    [ORDER_ATTRACT] = "attract", [ORDER_POWER] = "power",     [ORDER_STATUS] = "status",
};

/* All orders that wait, as "keep sheet palette+ attract-". */
static const char *orders(struct visit *visit, char text[200])
{
    struct visit_order order;
    text[0] = '\0';
    while (visit_order(visit, &order)) {
        size_t length = strlen(text);
        const char *sign = order.kind < ORDER_PALETTE ? "" : order.on ? "+" : "-";
        snprintf(text + length, 200 - length, "%s%s%s", length ? " " : "", order_names[order.kind], sign);
    }
    return text;
}

static void no_orders(struct visit *visit)
{
    char text[200];
    orders(visit, text);
}

/* A visit in a state, reached as visitors reach it, for five seconds now; its orders are taken. */
static struct visit in_state(enum visit_state state, bool painted, int wake, uint64_t *now)
{
    struct exhibit exhibit = an_exhibit(wake);
    struct visit visit;
    *now = START;
    visit_init(&visit, &exhibit, *now);
    if (state != VISIT_ATTRACT) {
        visit_feel(&visit, painted ? VISIT_PAINT : VISIT_INPUT, *now);
    }
    switch (state) {
    case VISIT_COUNTDOWN:
        *now += IDLE * S;
        visit_run(&visit, *now);
        break;
    case VISIT_THANKS:
        visit_feel(&visit, VISIT_FINISH, *now);
        break;
    case VISIT_WASHING:
        visit_feel(&visit, VISIT_FINISH, *now);
        *now += THANKS * S;
        visit_feel(&visit, VISIT_TIME, *now);
        break;
    case VISIT_CLOSED:
    case VISIT_CLOSING:
        visit_feel(&visit, VISIT_CLOSE, *now);
        *now += state == VISIT_CLOSED ? COUNTDOWN * S : 0;
        visit_run(&visit, *now);
        break;
    default:
        break;
    }
    *now += 5 * S;
    no_orders(&visit);
    assert_string_equal(visit_state_name(visit.state), visit_state_name(state));
    return visit;
}

struct pair {
    enum visit_event event;
    enum visit_state next;
    const char *orders;
};

static const struct pair pairs[VISIT_STATES][VISIT_EVENTS] =
    {
        [VISIT_ATTRACT] =
            {
                {VISIT_INPUT, VISIT_PAINTING, "sheet welcome palette+ attract-"},
                {VISIT_PAINT, VISIT_PAINTING, "sheet welcome palette+ attract-"},
                {VISIT_HOLD, VISIT_ATTRACT, ""},
                {VISIT_TIME, VISIT_ATTRACT, ""},
                {VISIT_FINISH, VISIT_ATTRACT, ""},
                {VISIT_WASHED, VISIT_ATTRACT, ""},
                {VISIT_STAFF, VISIT_ATTRACT, "status+"},
                {VISIT_OPEN, VISIT_ATTRACT, ""},
                {VISIT_CLOSE, VISIT_CLOSED, "attract- power-"},
                {VISIT_RELOAD, VISIT_ATTRACT, ""},
                {VISIT_SCENE, VISIT_ATTRACT, "scene sheet attract+"},
            },
        [VISIT_PAINTING] =
            {
                {VISIT_INPUT, VISIT_PAINTING, ""},
                {VISIT_PAINT, VISIT_PAINTING, ""},
                {VISIT_HOLD, VISIT_PAINTING, ""},
                {VISIT_TIME, VISIT_COUNTDOWN, ""},
                {VISIT_FINISH, VISIT_THANKS, "keep palette-"},
                {VISIT_WASHED, VISIT_PAINTING, ""},
                {VISIT_STAFF, VISIT_PAINTING, "status+"},
                {VISIT_OPEN, VISIT_PAINTING, ""},
                {VISIT_CLOSE, VISIT_CLOSING, ""},
                {VISIT_RELOAD, VISIT_PAINTING, ""},
                {VISIT_SCENE, VISIT_PAINTING, "keep scene sheet"},
            },
        [VISIT_COUNTDOWN] =
            {
                {VISIT_INPUT, VISIT_PAINTING, ""},
                {VISIT_PAINT, VISIT_PAINTING, ""},
                {VISIT_HOLD, VISIT_COUNTDOWN, ""},
                {VISIT_TIME, VISIT_WASHING, "keep wash palette-"},
                {VISIT_FINISH, VISIT_THANKS, "keep palette-"},
                {VISIT_WASHED, VISIT_COUNTDOWN, ""},
                {VISIT_STAFF, VISIT_COUNTDOWN, "status+"},
                {VISIT_OPEN, VISIT_COUNTDOWN, ""},
                {VISIT_CLOSE, VISIT_CLOSING, ""},
                {VISIT_RELOAD, VISIT_COUNTDOWN, ""},
                {VISIT_SCENE, VISIT_PAINTING, "keep scene sheet"},
            },
        [VISIT_THANKS] =
            {
                {VISIT_INPUT, VISIT_PAINTING, "sheet welcome palette+"},
                {VISIT_PAINT, VISIT_THANKS, ""},
                {VISIT_HOLD, VISIT_THANKS, ""},
                {VISIT_TIME, VISIT_WASHING, "wash"},
                {VISIT_FINISH, VISIT_THANKS, ""},
                {VISIT_WASHED, VISIT_THANKS, ""},
                {VISIT_STAFF, VISIT_THANKS, "status+"},
                {VISIT_OPEN, VISIT_THANKS, ""},
                {VISIT_CLOSE, VISIT_THANKS, ""},
                {VISIT_RELOAD, VISIT_THANKS, ""},
                {VISIT_SCENE, VISIT_ATTRACT, "scene sheet attract+"},
            },
        [VISIT_WASHING] =
            {
                {VISIT_INPUT, VISIT_PAINTING, "sheet welcome palette+"},
                {VISIT_PAINT, VISIT_WASHING, ""},
                {VISIT_HOLD, VISIT_WASHING, ""},
                {VISIT_TIME, VISIT_ATTRACT, "sheet attract+"},
                {VISIT_FINISH, VISIT_WASHING, ""},
                {VISIT_WASHED, VISIT_ATTRACT, "sheet attract+"},
                {VISIT_STAFF, VISIT_WASHING, "status+"},
                {VISIT_OPEN, VISIT_WASHING, ""},
                {VISIT_CLOSE, VISIT_WASHING, ""},
                {VISIT_RELOAD, VISIT_WASHING, ""},
                {VISIT_SCENE, VISIT_ATTRACT, "scene sheet attract+"},
            },
        [VISIT_CLOSING] =
            {
                {VISIT_INPUT, VISIT_CLOSING, ""},
                {VISIT_PAINT, VISIT_CLOSING, ""},
                {VISIT_HOLD, VISIT_CLOSING, ""},
                {VISIT_TIME, VISIT_CLOSED, "keep palette- power-"},
                {VISIT_FINISH, VISIT_CLOSING, ""},
                {VISIT_WASHED, VISIT_CLOSING, ""},
                {VISIT_STAFF, VISIT_CLOSING, "status+"},
                {VISIT_OPEN, VISIT_PAINTING, ""},
                {VISIT_CLOSE, VISIT_CLOSING, ""},
                {VISIT_RELOAD, VISIT_CLOSING, ""},
                {VISIT_SCENE, VISIT_CLOSING, ""},
            },
        [VISIT_CLOSED] =
            {
                {VISIT_INPUT, VISIT_CLOSED, ""},
                {VISIT_PAINT, VISIT_CLOSED, ""},
                {VISIT_HOLD, VISIT_CLOSED, ""},
                {VISIT_TIME, VISIT_CLOSED, ""},
                {VISIT_FINISH, VISIT_CLOSED, ""},
                {VISIT_WASHED, VISIT_CLOSED, ""},
                {VISIT_STAFF, VISIT_CLOSED, "power+ status+"},
                {VISIT_OPEN, VISIT_ATTRACT, "sheet attract+ power+"},
                {VISIT_CLOSE, VISIT_CLOSED, ""},
                {VISIT_RELOAD, VISIT_CLOSED, ""},
                {VISIT_SCENE, VISIT_CLOSED, "scene"},
            },
};

static void check_pair(struct visit *visit, enum visit_event event, uint64_t now, enum visit_state next,
                       const char *wanted)
{
    char text[200];
    enum visit_state before = visit->state;
    visit_feel(visit, event, now);
    orders(visit, text);
    if (visit->state != next || strcmp(text, wanted) != 0) {
        fail_msg("%s + %s: %s, \"%s\"; wanted: %s, \"%s\"", visit_state_name(before), event_names[event],
                 visit_state_name(visit->state), text, visit_state_name(next), wanted);
    }
}

static void every_state_with_every_event(void **state)
{
    (void)state;
    int checked = 0;
    for (int from = 0; from < VISIT_STATES; from++) {
        for (int event = 0; event < VISIT_EVENTS; event++) {
            const struct pair *pair = &pairs[from][event];
            assert_int_equal(pair->event, event); /* none is missing, none stands twice */
            uint64_t now;
            struct visit visit = in_state((enum visit_state)from, true, 0, &now);
            check_pair(&visit, pair->event, now, pair->next, pair->orders);
            checked++;
        }
    }
    assert_int_equal(checked, 77);
}

/* Under the staff's view only the view goes, and a sheet that is clean is clean. */
static void every_state_with_every_event_under_the_staffs_view(void **state)
{
    (void)state;
    for (int from = 0; from < VISIT_STATES; from++) {
        for (int event = 0; event < VISIT_EVENTS; event++) {
            uint64_t now;
            struct visit visit = in_state((enum visit_state)from, true, 10, &now);
            visit_feel(&visit, VISIT_STAFF, now);
            no_orders(&visit);
            assert_false(visit_paints(&visit));
            enum visit_state next = (enum visit_state)from;
            const char *wanted = "";
            if (event == VISIT_STAFF) {
                wanted = from == VISIT_CLOSED ? "status- power-" : "status-";
            } else if (from == VISIT_WASHING && event == VISIT_WASHED) {
                next = VISIT_ATTRACT;
                wanted = "sheet attract+";
            }
            check_pair(&visit, (enum visit_event)event, now + S, next, wanted);
        }
    }
}

static void a_sheet_with_nothing_on_it_is_not_kept(void **state)
{
    (void)state;
    uint64_t now;
    struct visit visit = in_state(VISIT_PAINTING, false, 0, &now);
    check_pair(&visit, VISIT_FINISH, now, VISIT_THANKS, "palette-");
    char text[200];
    visit_run(&visit, now);
    assert_string_equal(orders(&visit, text), "sheet attract+");
    assert_int_equal(visit.state, VISIT_ATTRACT);
    visit = in_state(VISIT_PAINTING, false, 0, &now);
    check_pair(&visit, VISIT_SCENE, now, VISIT_PAINTING, "scene sheet");
    visit = in_state(VISIT_COUNTDOWN, false, 0, &now);
    visit_run(&visit, now + COUNTDOWN * S);
    assert_string_equal(orders(&visit, text), "palette- sheet attract+");
    visit = in_state(VISIT_CLOSING, false, 0, &now);
    check_pair(&visit, VISIT_TIME, now, VISIT_CLOSED, "palette- power-");
    /* What is painted while it closes is kept. */
    visit = in_state(VISIT_CLOSING, false, 0, &now);
    check_pair(&visit, VISIT_PAINT, now, VISIT_CLOSING, "");
    check_pair(&visit, VISIT_TIME, now, VISIT_CLOSED, "keep palette- power-");
    /* A new scene is a new sheet: the old one is kept once. */
    visit = in_state(VISIT_PAINTING, true, 0, &now);
    check_pair(&visit, VISIT_SCENE, now, VISIT_PAINTING, "keep scene sheet");
    check_pair(&visit, VISIT_SCENE, now, VISIT_PAINTING, "scene sheet");
    check_pair(&visit, VISIT_FINISH, now, VISIT_THANKS, "palette-");
}

static void a_visit_from_beginning_to_end(void **state)
{
    (void)state;
    struct exhibit exhibit = an_exhibit(0);
    struct visit visit;
    char text[200];
    uint64_t now = START;
    visit_init(&visit, &exhibit, now);
    assert_string_equal(orders(&visit, text), "sheet attract+");
    assert_int_equal(visit_timeout_ms(&visit, now), -1);
    visit_run(&visit, now += 3600 * S);
    assert_int_equal(visit.state, VISIT_ATTRACT);
    visit_feel(&visit, VISIT_INPUT, now);
    assert_int_equal(visit.visits, 1);
    assert_true(visit_paints(&visit));
    visit_feel(&visit, VISIT_PAINT, now);
    assert_int_equal(visit_timeout_ms(&visit, now), IDLE * 1000);
    visit_run(&visit, now += IDLE * S - 1);
    assert_int_equal(visit.state, VISIT_PAINTING);
    assert_int_equal(visit_timeout_ms(&visit, now), 1);
    assert_int_equal(visit_countdown(&visit, now), 0);
    visit_run(&visit, now += 1);
    assert_int_equal(visit.state, VISIT_COUNTDOWN);
    assert_int_equal(visit_countdown(&visit, now), COUNTDOWN);
    assert_int_equal(visit_countdown(&visit, now + 1), COUNTDOWN);
    assert_int_equal(visit_countdown(&visit, now + S), COUNTDOWN - 1);
    assert_float_equal(visit_left(&visit, now + COUNTDOWN * S / 2), 0.5, 1e-4);
    visit_feel(&visit, VISIT_INPUT, now += COUNTDOWN * S - 1); /* at the last moment */
    assert_int_equal(visit.state, VISIT_PAINTING);
    visit_run(&visit, now += IDLE * S);
    no_orders(&visit);
    visit_run(&visit, now += COUNTDOWN * S);
    assert_string_equal(orders(&visit, text), "keep wash palette-");
    assert_false(visit_paints(&visit));
    visit_feel(&visit, VISIT_WASHED, now += WASH * S);
    assert_string_equal(orders(&visit, text), "sheet attract+");
    /* A wash that nobody says is over ends too. */
    visit = in_state(VISIT_WASHING, true, 0, &now);
    visit_run(&visit, now + (2 * WASH + VISIT_WASH_S - 5) * S - 1);
    assert_int_equal(visit.state, VISIT_WASHING);
    visit_run(&visit, now + (2 * WASH + VISIT_WASH_S - 5) * S);
    assert_int_equal(visit.state, VISIT_ATTRACT);
}

static void hands_that_still_paint_do_not_end_the_thanks(void **state)
{
    (void)state;
    uint64_t now;
    struct visit visit = in_state(VISIT_PAINTING, true, 0, &now);
    visit_feel(&visit, VISIT_FINISH, now);
    no_orders(&visit);
    check_pair(&visit, VISIT_INPUT, now + VISIT_GRACE_MS * 1000 - 1, VISIT_THANKS, "");
    check_pair(&visit, VISIT_INPUT, now + VISIT_GRACE_MS * 1000, VISIT_PAINTING, "sheet welcome palette+");
    assert_int_equal(visit.visits, 2);
}

static void a_hand_that_rests_does_not_keep_a_visit_for_ever(void **state)
{
    (void)state;
    uint64_t now;
    struct visit visit = in_state(VISIT_PAINTING, true, 0, &now);
    visit_feel(&visit, VISIT_INPUT, now);
    uint64_t down = now;
    while (visit.state == VISIT_PAINTING && now < down + 600 * S) {
        now += S / 10;
        visit_feel(&visit, VISIT_HOLD, now);
        visit_run(&visit, now);
    }
    assert_int_equal((now - down) / S, VISIT_HOLD_S + IDLE);
    while (visit.state != VISIT_ATTRACT && now < down + 600 * S) {
        now += S / 10;
        visit_feel(&visit, VISIT_HOLD, now);
        visit_run(&visit, now);
    }
    assert_int_equal(visit.state, VISIT_ATTRACT);
    /* Who paints on with it does. */
    visit = in_state(VISIT_PAINTING, true, 0, &now);
    for (int i = 0; i < 6000; i++) {
        now += S / 10;
        visit_feel(&visit, i % 100 ? VISIT_HOLD : VISIT_PAINT, now);
        visit_run(&visit, now);
        assert_int_equal(visit.state, VISIT_PAINTING);
    }
}

static void time_stands_still_in_the_staffs_view(void **state)
{
    (void)state;
    for (int from = 0; from < VISIT_STATES; from++) {
        uint64_t now;
        struct visit visit = in_state((enum visit_state)from, true, 0, &now);
        float left = visit_left(&visit, now);
        int seconds = visit_countdown(&visit, now);
        visit_feel(&visit, VISIT_STAFF, now);
        for (int i = 0; i < 100; i++) {
            now += 60 * S;
            visit_feel(&visit, VISIT_INPUT, now);
            visit_run(&visit, now);
            assert_int_equal(visit.state, from);
            assert_int_equal(visit_countdown(&visit, now), seconds);
            assert_int_equal(visit_timeout_ms(&visit, now), VISIT_STATUS_S * 1000);
        }
        visit_feel(&visit, VISIT_STAFF, now);
        visit_run(&visit, now);
        assert_int_equal(visit.state, from);
        assert_float_equal(visit_left(&visit, now), left, 1e-4);
    }
}

/* A hand that lay there before the staff looked is as good afterwards as it was. */
static void a_hand_that_rests_outlasts_the_staffs_view(void **state)
{
    (void)state;
    uint64_t now;
    struct visit visit = in_state(VISIT_PAINTING, true, 0, &now);
    visit_feel(&visit, VISIT_PAINT, now);
    visit_feel(&visit, VISIT_STAFF, now);
    now += 2 * VISIT_HOLD_S * S;
    visit_feel(&visit, VISIT_STAFF, now);
    for (float s = 0; s < visit.times.idle + 10; s++) {
        now += S;
        visit_feel(&visit, VISIT_HOLD, now);
        visit_run(&visit, now);
        assert_int_equal(visit.state, VISIT_PAINTING);
    }
}

static void the_staffs_view_goes_by_itself(void **state)
{
    (void)state;
    uint64_t now;
    char text[200];
    struct visit visit = in_state(VISIT_ATTRACT, true, 0, &now);
    visit_feel(&visit, VISIT_STAFF, now);
    visit_feel(&visit, VISIT_CLOSE, now); /* waits until the staff have seen enough */
    visit_feel(&visit, VISIT_HOLD, now + 100 * S);
    visit_run(&visit, now + VISIT_STATUS_S * S - 1);
    assert_string_equal(orders(&visit, text), "status+");
    visit_run(&visit, now + VISIT_STATUS_S * S);
    assert_string_equal(orders(&visit, text), "status- attract- power-");
    assert_int_equal(visit.state, VISIT_CLOSED);
    /* In the dark the screen comes for it, and stays when it opens meanwhile. */
    visit_feel(&visit, VISIT_STAFF, now += 1000 * S);
    assert_string_equal(orders(&visit, text), "power+ status+");
    visit_feel(&visit, VISIT_OPEN, now);
    visit_run(&visit, now);
    visit_feel(&visit, VISIT_STAFF, now);
    visit_run(&visit, now);
    assert_string_equal(orders(&visit, text), "status- sheet attract+ power+");
}

static void closing_time_waits_for_a_picture(void **state)
{
    (void)state;
    uint64_t now;
    char text[200];
    struct visit visit = in_state(VISIT_PAINTING, true, 0, &now);
    visit_feel(&visit, VISIT_CLOSE, now);
    assert_int_equal(visit_countdown(&visit, now), COUNTDOWN);
    for (int i = 0; i < COUNTDOWN; i++) { /* a touch does not put it off */
        visit_feel(&visit, VISIT_PAINT, now);
        visit_feel(&visit, VISIT_CLOSE, now);
        visit_run(&visit, now);
        assert_true(visit.state == VISIT_CLOSING && visit_paints(&visit));
        now += S;
    }
    visit_run(&visit, now);
    assert_string_equal(orders(&visit, text), "keep palette- power-");
    visit = in_state(VISIT_THANKS, true, 0, &now);
    visit_feel(&visit, VISIT_CLOSE, now);
    visit_run(&visit, now + THANKS * S);
    assert_string_equal(orders(&visit, text), "wash");
    visit_feel(&visit, VISIT_WASHED, now + (THANKS + WASH) * S);
    visit_run(&visit, now + (THANKS + WASH) * S);
    assert_int_equal(visit.state, VISIT_CLOSED);
    assert_string_equal(orders(&visit, text), "sheet attract- power-");
}

static void a_touch_wakes_what_is_closed_for_a_while(void **state)
{
    (void)state;
    uint64_t now;
    char text[200];
    struct visit visit = in_state(VISIT_CLOSED, true, 10, &now);
    visit_run(&visit, now += 700 * S);
    assert_int_equal(visit.state, VISIT_CLOSED);
    check_pair(&visit, VISIT_INPUT, now, VISIT_ATTRACT, "sheet attract+ power+");
    visit_feel(&visit, VISIT_CLOSE, now);
    visit_run(&visit, now += 599 * S);
    assert_int_equal(visit.state, VISIT_ATTRACT);
    assert_int_equal(visit_timeout_ms(&visit, now), 1000);
    visit_run(&visit, now += S);
    assert_string_equal(orders(&visit, text), "attract- power-");
    /* Each touch gives it that long again; who paints then gets a countdown. */
    visit_feel(&visit, VISIT_INPUT, now);
    visit_feel(&visit, VISIT_PAINT, now += 500 * S);
    for (int i = 0; i < 599; i++) {
        now += S;
        visit_feel(&visit, i < 60 ? VISIT_HOLD : VISIT_CLOSE, now);
        visit_run(&visit, now);
    }
    assert_int_equal(visit.state, VISIT_ATTRACT);
    visit_run(&visit, now += S);
    assert_int_equal(visit.state, VISIT_CLOSED);
}

static void another_exhibit_changes_the_times(void **state)
{
    (void)state;
    uint64_t now;
    struct visit visit = in_state(VISIT_PAINTING, true, 0, &now);
    struct exhibit exhibit = an_exhibit(0);
    exhibit.visit.idle = 4; /* five seconds have gone */
    visit_reload(&visit, &exhibit, now);
    assert_int_equal(visit.state, VISIT_PAINTING);
    visit_run(&visit, now);
    assert_int_equal(visit.state, VISIT_COUNTDOWN);
    exhibit.visit.idle = exhibit.visit.countdown = 0.0f / 1.0f;
    visit_reload(&visit, &exhibit, now);
    visit_run(&visit, now);
    assert_int_equal(visit.state, VISIT_WASHING);
}

static void a_clock_that_jumps(void **state)
{
    (void)state;
    uint64_t now;
    for (int from = 0; from < VISIT_STATES; from++) {
        struct visit visit = in_state((enum visit_state)from, true, 0, &now);
        float left = visit_left(&visit, now);
        visit_run(&visit, now); /* back, as far as it goes */
        uint64_t back = now - 7 * S;
        visit_run(&visit, back);
        assert_int_equal(visit.state, from);
        assert_float_equal(visit_left(&visit, back), left, 1e-4);
        no_orders(&visit);
        visit_run(&visit, back + 100000 * S);
        if (from == VISIT_PAINTING) { /* the countdown is shown all the same */
            assert_int_equal(visit_countdown(&visit, back + 100000 * S), COUNTDOWN);
        }
    }
}

/* A kiosk may sleep for as long as it is told. */
static void the_timeout_is_when_something_happens(void **state)
{
    (void)state;
    for (int from = 0; from < VISIT_STATES; from++) {
        uint64_t now;
        struct visit visit = in_state((enum visit_state)from, true, 0, &now);
        int ms = visit_timeout_ms(&visit, now);
        if (ms < 0) {
            continue;
        }
        visit_run(&visit, now + (uint64_t)(ms - 1) * 1000);
        assert_int_equal(visit.state, from);
        visit_run(&visit, now + (uint64_t)ms * 1000);
        assert_int_not_equal(visit.state, from);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_state_with_every_event),
        cmocka_unit_test(every_state_with_every_event_under_the_staffs_view),
        cmocka_unit_test(a_sheet_with_nothing_on_it_is_not_kept),
        cmocka_unit_test(a_visit_from_beginning_to_end),
        cmocka_unit_test(hands_that_still_paint_do_not_end_the_thanks),
        cmocka_unit_test(a_hand_that_rests_does_not_keep_a_visit_for_ever),
        cmocka_unit_test(time_stands_still_in_the_staffs_view),
        cmocka_unit_test(a_hand_that_rests_outlasts_the_staffs_view),
        cmocka_unit_test(the_staffs_view_goes_by_itself),
        cmocka_unit_test(closing_time_waits_for_a_picture),
        cmocka_unit_test(a_touch_wakes_what_is_closed_for_a_while),
        cmocka_unit_test(another_exhibit_changes_the_times),
        cmocka_unit_test(a_clock_that_jumps),
        cmocka_unit_test(the_timeout_is_when_something_happens),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
