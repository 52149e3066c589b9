/* One switch, dwelling, a zone in reach (app/visit/access.h): whole plays on a clock of their own. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <string.h>

#include "access.h"
#include "display_rotation.h"
#include "near.h"

enum { MS = 1000, FRAME_US = 16667, PATIENCE_FRAMES = 2000, BUTTONS = 9, TAKEN = 64 };

static const struct exhibit_access DEF = {.scan = 4, .dwell = 1, .dwell_radius = 12, .zone = {0.25f, 0.5f, 0.75f, 1}};
static const float RADIUS_X = 0.02f, RADIUS_Y = 0.03f;

struct play {
    struct access access;
    uint64_t now_us;
    uint32_t seed;
    int presses;
    struct access_result taken[TAKEN];
    int count;
};

static struct play open_play(void)
{
    struct play play = {.now_us = 5000000, .seed = 7};
    access_init(&play.access, &DEF, RADIUS_X, RADIUS_Y);
    return play;
}

static uint32_t roll(struct play *play, uint32_t sides)
{
    play->seed = play->seed * 1664525u + 1013904223u;
    return (play->seed >> 8) % sides;
}

/* -1..1 */
static float tremble(struct play *play)
{
    return (float)roll(play, 2001) / 1000 - 1;
}

static void take_all(struct play *play)
{
    struct access_result result = access_run(&play->access, play->now_us);
    for (; result.what != ACCESS_NOTHING; result = access_run(&play->access, play->now_us)) {
        assert_true(play->count < TAKEN);
        play->taken[play->count++] = result;
    }
}

static void frame(struct play *play)
{
    play->now_us += FRAME_US;
    take_all(play);
}

static void pass_ms(struct play *play, int ms)
{
    uint64_t end = play->now_us + (uint64_t)ms * MS;
    while (play->now_us + FRAME_US < end) {
        frame(play);
    }
    play->now_us = end;
    take_all(play);
}

static void turn_switch(struct play *play, bool down)
{
    access_switch(&play->access, down, BUTTONS, play->now_us);
}

/* Held for so long by a hand that trembles: the contact opens and closes again at both ends. */
static void press_ms(struct play *play, int ms)
{
    play->presses++;
    turn_switch(play, true);
    for (int i = 0; i < 3; i++) {
        pass_ms(play, 15);
        turn_switch(play, false);
        pass_ms(play, 30);
        turn_switch(play, true);
    }
    pass_ms(play, ms > 180 ? ms - 180 : 0);
    turn_switch(play, false);
    pass_ms(play, 40);
    turn_switch(play, true);
    pass_ms(play, 5);
    turn_switch(play, false);
    pass_ms(play, 100);
}

/* Presses when it sees the line there, give or take 25 ms. */
static void stop_line(struct play *play, enum access_state state, const float *line, float at)
{
    for (int i = 0; play->access.state != state || *line < at; i++) {
        assert_true(i < PATIENCE_FRAMES);
        frame(play);
    }
    play->now_us += roll(play, 25 * MS);
    press_ms(play, 250);
}

static const float PLACES[][2] = {{0.5f, 0.5f}, {0.1f, 0.9f},   {0.95f, 0.05f}, {0.33f, 0.66f}, {0.02f, 0.02f},
                                  {0.7f, 0.3f}, {0.98f, 0.98f}, {0.2f, 0.4f},   {0.61f, 0.13f}, {0.45f, 0.85f}};
enum { PLACE_COUNT = sizeof PLACES / sizeof *PLACES };

static void ten_drops_fall_where_one_switch_wants_them(void **state)
{
    (void)state;
    struct play play = open_play();
    pass_ms(&play, 10000);
    assert_true(play.access.state == ACCESS_RESTS && !access_moves(&play.access));
    assert_int_equal(access_timeout_ms(&play.access, play.now_us), -1);
    press_ms(&play, 200);
    for (int i = 0; i < PLACE_COUNT; i++) {
        stop_line(&play, ACCESS_ACROSS, &play.access.x, PLACES[i][0]);
        assert_true(access_moves(&play.access));
        stop_line(&play, ACCESS_DOWN, &play.access.y, PLACES[i][1]);
        assert_int_equal(play.count, i + 1);
        assert_true(play.taken[i].what == ACCESS_DROP && play.taken[i].id == -1);
        assert_near(play.taken[i].x, PLACES[i][0], 0.015); /* 25 ms and a frame of 4 s */
        assert_near(play.taken[i].y, PLACES[i][1], 0.015);
    }
    assert_int_equal(play.presses, 1 + 2 * PLACE_COUNT);
    pass_ms(&play, 8000);
    assert_int_equal(play.access.state, ACCESS_RESTS);
    assert_int_equal(play.count, PLACE_COUNT);
}

static void stop_button(struct play *play, int button)
{
    for (int i = 0; play->access.state != ACCESS_BUTTONS || play->access.button != button; i++) {
        assert_true(i < PATIENCE_FRAMES);
        frame(play);
    }
    pass_ms(play, 400); /* half of its time: nobody is quicker */
    assert_int_equal(play->access.button, button);
    press_ms(play, 250);
}

static void an_ink_is_chosen_and_a_painting_finished_by_one_switch(void **state)
{
    (void)state;
    struct play play = open_play();
    press_ms(&play, 1500); /* from rest, a long one: the palette */
    assert_int_equal(play.access.state, ACCESS_BUTTONS);
    stop_button(&play, 2);
    assert_true(play.count == 1 && play.taken[0].what == ACCESS_PRESS && play.taken[0].button == 2);
    stop_line(&play, ACCESS_ACROSS, &play.access.x, 0.4f); /* the line goes already */
    stop_line(&play, ACCESS_DOWN, &play.access.y, 0.6f);
    assert_true(play.count == 2 && play.taken[1].what == ACCESS_DROP);
    press_ms(&play, 1500); /* in the middle of a line */
    stop_button(&play, BUTTONS - 1);
    assert_true(play.count == 3 && play.taken[2].what == ACCESS_PRESS && play.taken[2].button == BUTTONS - 1);
    access_rest(&play.access);
    assert_false(access_moves(&play.access));
    assert_int_equal(play.presses, 6);
}

static void a_line_that_nobody_stops_comes_back_and_rests(void **state)
{
    (void)state;
    struct play play = open_play();
    press_ms(&play, 100);
    uint64_t start = play.access.since_us;
    float furthest = 0;
    while (play.access.state == ACCESS_ACROSS) {
        frame(&play);
        furthest = fmaxf(furthest, play.access.x);
        double passes = (double)(play.now_us - start) / 4e6;
        if (play.access.state == ACCESS_ACROSS) {
            assert_near(play.access.x, passes <= 1 ? passes : 2 - passes, 1e-3);
        }
    }
    assert_true(furthest > 0.99f);
    assert_near((double)(play.now_us - start) / 1e6, 8, 0.02);
    press_ms(&play, 100);
    stop_line(&play, ACCESS_ACROSS, &play.access.x, 0.3f);
    int ms = access_timeout_ms(&play.access, play.now_us);
    pass_ms(&play, ms - 1);
    assert_int_equal(play.access.state, ACCESS_DOWN); /* which rests as well, and no drop has fallen */
    pass_ms(&play, 1);
    assert_int_equal(play.access.state, ACCESS_RESTS);
    assert_int_equal(play.count, 0);
}

static void the_walk_ends_after_two_rounds_or_a_long_press(void **state)
{
    (void)state;
    struct play play = open_play();
    int marked[BUTTONS] = {0}, last = -1;
    press_ms(&play, 1500);
    while (play.access.state == ACCESS_BUTTONS) {
        marked[play.access.button] += play.access.button != last;
        last = play.access.button;
        frame(&play);
    }
    for (int i = 0; i < BUTTONS; i++) {
        assert_int_equal(marked[i], 2);
    }
    assert_true(play.access.state == ACCESS_RESTS && play.count == 0);
    press_ms(&play, 1500);
    pass_ms(&play, 2000);
    press_ms(&play, 1500);
    assert_true(play.access.state == ACCESS_ACROSS && play.count == 0);
    access_switch(&play.access, true, 0, play.now_us); /* a palette without buttons: nowhere to walk */
    pass_ms(&play, 3000);
    access_switch(&play.access, false, 0, play.now_us);
    pass_ms(&play, 100);
    assert_true(play.access.state == ACCESS_ACROSS && play.count == 0);
    press_ms(&play, 1500);
    pass_ms(&play, 7000);
    assert_true(play.access.button > 2);
    access_switch(&play.access, true, 2, play.now_us); /* fewer than there were: the first */
    access_switch(&play.access, false, 2, play.now_us + 100 * MS);
    pass_ms(&play, 200);
    assert_true(play.count == 1 && play.taken[0].what == ACCESS_PRESS && play.taken[0].button == 0);
}

static void presses_of_a_trembling_hand_are_one(void **state)
{
    (void)state;
    struct play play = open_play();
    turn_switch(&play, true);
    pass_ms(&play, 20);
    turn_switch(&play, false);
    pass_ms(&play, 79);
    turn_switch(&play, true); /* the same */
    pass_ms(&play, 20);
    turn_switch(&play, false);
    pass_ms(&play, 79);
    assert_int_equal(play.access.state, ACCESS_RESTS); /* a press counts when it is over */
    pass_ms(&play, 1);
    assert_int_equal(play.access.state, ACCESS_ACROSS);
    pass_ms(&play, 2000);
    turn_switch(&play, true);
    float stopped = play.access.x;
    assert_near(stopped, 0.5, 1e-3);
    pass_ms(&play, 500);
    assert_near(play.access.x, stopped, 0); /* the line has stopped at the beginning of the press */
    turn_switch(&play, false);
    pass_ms(&play, 80);
    assert_int_equal(play.access.state, ACCESS_DOWN);
    turn_switch(&play, true); /* another, 80 ms later */
    pass_ms(&play, 10);
    turn_switch(&play, false);
    pass_ms(&play, 80);
    assert_true(play.count == 1 && play.taken[0].what == ACCESS_DROP);
    assert_near(play.taken[0].y, 0, 1e-3);
}

static void a_long_press_is_known_while_it_is_held(void **state)
{
    (void)state;
    struct play play = open_play();
    turn_switch(&play, true);
    assert_int_equal(access_timeout_ms(&play.access, play.now_us), 1200);
    pass_ms(&play, 600);
    pass_ms(&play, 599);
    assert_int_equal(play.access.state, ACCESS_RESTS);
    pass_ms(&play, 1);
    assert_int_equal(play.access.state, ACCESS_BUTTONS);
    pass_ms(&play, 10000);
    assert_int_equal(play.access.button, 0); /* it walks when the hand is off */
    turn_switch(&play, false);
    pass_ms(&play, 80 + 1500);
    assert_int_equal(play.access.button, 0);
    pass_ms(&play, 200);
    assert_int_equal(play.access.button, 1);
    assert_int_equal(play.count, 0);
    struct play late = open_play(); /* told by the times of the events, however late they come */
    access_switch(&late.access, true, BUTTONS, late.now_us);
    access_switch(&late.access, false, BUTTONS, late.now_us + ACCESS_LONG_US);
    assert_int_equal(late.access.state, ACCESS_BUTTONS);
    access_init(&late.access, &(struct exhibit_access){.scan = 0}, 0, 0);
    access_switch(&late.access, true, BUTTONS, late.now_us);
    pass_ms(&late, 5000);
    assert_true(late.access.state == ACCESS_RESTS && !access_moves(&late.access));
}

static void rest_at(struct play *play, int id, float x, float y, float share, int ms)
{
    for (int i = 0; i < ms / 10; i++) {
        pass_ms(play, 10);
        access_point(&play->access, id, x + share * RADIUS_X * tremble(play), y + share * RADIUS_Y * tremble(play),
                     play->now_us);
    }
}

static void a_point_that_rests_lets_a_drop_fall(void **state)
{
    (void)state;
    struct play play = open_play();
    for (int i = 0; i < PLACE_COUNT; i++) {
        float x = PLACES[i][0], y = PLACES[i][1];
        for (int k = 10; k > 0; k--) { /* it comes from above */
            access_point(&play.access, 3, x, y - 0.04f * (float)k, play.now_us);
            pass_ms(&play, 50);
        }
        assert_int_equal(play.count, i);
        rest_at(&play, 3, x, y, 0.95f, 900);
        assert_int_equal(play.count, i);
        assert_near(access_dwelt(&play.access, 3, play.now_us), 0.9, 0.06);
        rest_at(&play, 3, x, y, 0.95f, 3000);
        assert_int_equal(play.count, i + 1); /* once, however long it rests */
        assert_true(play.taken[i].what == ACCESS_DROP && play.taken[i].id == 3);
        assert_near(play.taken[i].x, x, 0.2 * RADIUS_X); /* the middle of its trembling */
        assert_near(play.taken[i].y, y, 0.2 * RADIUS_Y);
        assert_near(access_dwelt(&play.access, 3, play.now_us), 0, 0);
    }
    assert_false(access_moves(&play.access));
}

static void points_that_move_or_leave_do_not_dwell(void **state)
{
    (void)state;
    struct play play = open_play();
    for (int i = 0; i < 300; i++) { /* slowly: more than it may tremble in a second */
        access_point(&play.access, 1, 0.1f + 0.0005f * (float)i, 0.5f, play.now_us);
        pass_ms(&play, 10);
    }
    assert_int_equal(play.count, 0);
    access_leave(&play.access, 1);
    access_point(&play.access, 2, 0.5f, 0.5f, play.now_us);
    pass_ms(&play, 990);
    access_leave(&play.access, 2);
    access_leave(&play.access, 77);
    pass_ms(&play, 2000);
    assert_int_equal(play.count, 0);
    assert_false(access_moves(&play.access));
    rest_at(&play, 1, 0.5f, 0.5f, 2.5f, 5000); /* it trembles too much */
    assert_int_equal(play.count, 0);
    access_leave(&play.access, 1);
    for (int id = 0; id < 2 * ACCESS_POINTS; id++) { /* still ones, of which nothing more is heard: time is enough */
        access_point(&play.access, id, 0.25f, 0.75f, play.now_us);
    }
    assert_int_equal(access_timeout_ms(&play.access, play.now_us), 1000);
    pass_ms(&play, 1100);
    assert_int_equal(play.count, ACCESS_POINTS);
    assert_near(play.taken[0].x, 0.25, 1e-6);
    access_point(&play.access, 0, NAN, 0.5f, play.now_us);
    access_init(&play.access, &(struct exhibit_access){.dwell = 0}, RADIUS_X, RADIUS_Y);
    access_point(&play.access, 0, 0.25f, 0.75f, play.now_us);
    pass_ms(&play, 5000);
    assert_int_equal(play.count, ACCESS_POINTS);
}

static struct event reach(struct access *access, enum event_kind kind, int slot, float x, float y)
{
    struct event event = {.kind = kind, .source = SOURCE_TOUCH, .slot = slot, .x = x, .y = y};
    access_reach(access, &event);
    return event;
}

static void assert_at(struct event event, float x, float y)
{
    assert_near(event.x, x, 1e-5);
    assert_near(event.y, y, 1e-5);
}

static void a_zone_reaches_the_whole_sheet(void **state)
{
    (void)state;
    struct play play = open_play();
    struct access *access = &play.access;
    assert_at(reach(access, EVENT_DOWN, 0, 0.3f, 0.6f), 0.3f, 0.6f); /* nobody sits: as it is */
    access->seated = true;
    assert_at(reach(access, EVENT_MOVE, 0, 0.4f, 0.6f), 0.4f, 0.6f); /* and stays so until it leaves */
    assert_at(reach(access, EVENT_UP, 0, 0.4f, 0.6f), 0.4f, 0.6f);
    assert_at(reach(access, EVENT_DOWN, 0, 0.25f, 0.5f), 0, 0);
    assert_at(reach(access, EVENT_MOVE, 0, 0.5f, 0.75f), 0.5f, 0.5f);
    assert_at(reach(access, EVENT_MOVE, 0, 0.75f, 1), 1, 1);
    assert_at(reach(access, EVENT_MOVE, 0, 0.9f, 0.75f), 1, 0.5f);     /* over the edge: at the edge */
    assert_at(reach(access, EVENT_DOWN, 1, 0.9f, 0.75f), 0.9f, 0.75f); /* somebody who stands beside */
    assert_at(reach(access, EVENT_MOVE, 1, 0.5f, 0.75f), 0.5f, 0.75f); /* does not jump at the edge either */
    assert_at(reach(access, EVENT_MOVE, 0, 0.6f, 0.1f), 0.7f, 0);
    access->seated = false;
    assert_at(reach(access, EVENT_UP, 0, 0.6f, 0.75f), 0.7f, 0.5f); /* what began so ends so */
    assert_at(reach(access, EVENT_DOWN, 0, 0.6f, 0.75f), 0.6f, 0.75f);
    access->seated = true;
    reach(access, EVENT_DOWN, 2, 0.5f, 0.75f);
    assert_at(reach(access, EVENT_DOWN, 2, 0.1f, 0.1f), 0.1f, 0.1f); /* its release was lost */
    assert_at(reach(access, EVENT_MOVE, 2, 0.5f, 0.75f), 0.5f, 0.75f);
    reach(access, EVENT_DOWN, 3, 0.5f, 0.75f);
    assert_at(reach(access, EVENT_CANCEL, 3, 0.5f, 0.75f), 0.5f, 0.5f);
    assert_at(reach(access, EVENT_MOVE, 3, 0.5f, 0.75f), 0.5f, 0.75f);
    struct event dial = {.kind = EVENT_CONTROL, .source = SOURCE_HID, .x = 0.5f, .y = 0.75f};
    access_reach(access, &dial);
    assert_at(dial, 0.5f, 0.75f);
    for (int slot = 10; slot < 10 + 2 * ACCESS_FINGERS; slot++) {
        reach(access, EVENT_DOWN, slot, 0.5f, 0.75f);
    }
    for (int slot = 10; slot < 10 + 2 * ACCESS_FINGERS; slot++) {
        reach(access, EVENT_UP, slot, 0.5f, 0.75f);
    }
    assert_at(reach(access, EVENT_DOWN, 9, 0.75f, 1), 1, 1); /* there is room again */
    access->def.zone[2] = access->def.zone[0];
    assert_at(reach(access, EVENT_DOWN, 8, 0.25f, 0.75f), 0.25f, 0.75f); /* a zone of nothing */
}

/* The zone is of the sheet as it is looked at, however the panel hangs. */
static void the_zone_turns_with_the_display(void **state)
{
    (void)state;
    static const float CORNERS[4][2] = {{0.25f, 0.5f}, {0.75f, 0.5f}, {0.75f, 1}, {0.25f, 1}};
    static const float SHEET[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    /* The same corners on the panel, for 0, 90, 180, 270 degrees. */
    static const float PANEL[4][4][2] = {{{0.25f, 0.5f}, {0.75f, 0.5f}, {0.75f, 1}, {0.25f, 1}},
                                         {{0.5f, 0.25f}, {0.5f, 0.75f}, {0, 0.75f}, {0, 0.25f}},
                                         {{0.75f, 0.5f}, {0.25f, 0.5f}, {0.25f, 0}, {0.75f, 0}},
                                         {{0.5f, 0.75f}, {0.5f, 0.25f}, {1, 0.25f}, {1, 0.75f}}};
    for (int turn = 0; turn < 4; turn++) {
        struct play play = open_play();
        play.access.seated = true;
        for (int i = 0; i < 4; i++) {
            float x = PANEL[turn][i][0], y = PANEL[turn][i][1];
            rotation_untouch(90 * turn, &x, &y);
            assert_near(x, CORNERS[i][0], 1e-6);
            assert_near(y, CORNERS[i][1], 1e-6);
            assert_at(reach(&play.access, EVENT_DOWN, i, x, y), SHEET[i][0], SHEET[i][1]);
        }
    }
}

static void whatever_comes_nothing_is_out_of_range(void **state)
{
    (void)state;
    struct play play = open_play();
    int drops = 0, presses = 0;
    for (int i = 0; i < 200000; i++) {
        play.now_us += roll(&play, 30 * MS);
        uint64_t time_us = play.now_us - roll(&play, 50 * MS); /* late, and of two devices */
        int buttons = (int)roll(&play, 4) * 3;
        switch (roll(&play, 20)) {
        case 0:
            access_switch(&play.access, roll(&play, 2), buttons, time_us);
            break;
        case 1:
            access_point(&play.access, (int)roll(&play, 40), (float)roll(&play, 20) / 19, 0.5f, time_us);
            break;
        case 2:
            access_leave(&play.access, (int)roll(&play, 40));
            break;
        case 3:
            if (roll(&play, 100) == 0) {
                access_rest(&play.access);
            }
            break;
        default:
            break;
        }
        struct access_result result = access_run(&play.access, play.now_us);
        const struct access *access = &play.access;
        assert_true(access->x >= 0 && access->x <= 1 && access->y >= 0 && access->y <= 1);
        assert_true(access->state != ACCESS_BUTTONS || (access->button >= 0 && access->button < access->buttons));
        assert_true(access_timeout_ms(access, play.now_us) >= -1 && access_timeout_ms(access, play.now_us) <= 30000);
        drops += result.what == ACCESS_DROP;
        presses += result.what == ACCESS_PRESS;
        assert_true(result.what != ACCESS_DROP || (result.x >= 0 && result.x <= 1 && result.y >= 0 && result.y <= 1));
        assert_true(result.what != ACCESS_PRESS || (result.button >= 0 && result.button < 9));
    }
    assert_true(drops > 100 && presses > 10);
    access_switch(&play.access, false, 0, play.now_us);
    for (int id = 0; id < 40; id++) {
        access_leave(&play.access, id);
    }
    pass_ms(&play, 30000);
    assert_false(access_moves(&play.access));
    assert_int_equal(access_timeout_ms(&play.access, play.now_us), -1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ten_drops_fall_where_one_switch_wants_them),
        cmocka_unit_test(an_ink_is_chosen_and_a_painting_finished_by_one_switch),
        cmocka_unit_test(a_line_that_nobody_stops_comes_back_and_rests),
        cmocka_unit_test(the_walk_ends_after_two_rounds_or_a_long_press),
        cmocka_unit_test(presses_of_a_trembling_hand_are_one),
        cmocka_unit_test(a_long_press_is_known_while_it_is_held),
        cmocka_unit_test(a_point_that_rests_lets_a_drop_fall),
        cmocka_unit_test(points_that_move_or_leave_do_not_dwell),
        cmocka_unit_test(a_zone_reaches_the_whole_sheet),
        cmocka_unit_test(the_zone_turns_with_the_display),
        cmocka_unit_test(whatever_comes_nothing_is_out_of_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
