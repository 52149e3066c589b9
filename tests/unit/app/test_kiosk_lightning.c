/* A scene of lightning, driven by devices on a fake clock: what visitors, the curator and attract do there, and what
 * the stage is told. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <string.h>

#include "hud_told.h"
#include "kiosk_case.h"
#include "kiosk_state.h"

#define HEAD                                                                                                           \
    "exhibit: 1\n"                                                                                                     \
    "display: {width: 530}\n"                                                                                          \
    "visit: {idle: 30, countdown: 10, thanks: 5, wash: 4, attract: 60}\n"                                              \
    "inputs:\n"                                                                                                        \
    "  gpio: {buttons: [{id: a, line: A}, {id: b, line: B}, {id: c, line: C}], encoders: [{id: w, a: D, b: E}]}\n"     \
    "  bindings:\n"                                                                                                    \
    "    - {button: a, strike: {}}\n"                                                                                  \
    "    - {button: b, next_kind: {}}\n"                                                                               \
    "    - {button: c, switch: {}}\n"                                                                                  \
    "    - {encoder: w, turn: {lightning: eta, from: 0, to: 10, steps: 40, smooth: 0}}\n"

static const char STORM[] = HEAD "scenes: [{id: storm, kind: lightning, lightning: {eta: 2}, opening: "
                                 "[{attract: {path: [[0.1, 0.9], [0.9, 0.9]], amount: 3}}]}]\n";
static const char REEF[] = HEAD "scenes: [{id: reef, kind: lightning, lightning: {kind: coral}}, {id: paper}]\n";

enum { STRIKE, KIND, SWITCH, WHEEL };

static const struct point MIDDLE = {0.45f, 0.4f};

static int key_of(const char *name)
{
    return (int)(key_find(storm_keys, name) - storm_keys);
}

/* The last post of a verb since `from`; fails when there is none. */
static const struct hall_told *last(const struct hall *hall, int from, enum action_verb verb)
{
    const struct hall_told *found = NULL;
    for (int i = from; i < hall->count; i++) {
        found = hall->told[i].what == HALL_POST && hall->told[i].verb == verb ? &hall->told[i] : found;
    }
    assert_non_null(found);
    return found;
}

/* The value that was conducted last. */
static float conducted(const struct hall *hall, int from, const char *name)
{
    const struct hall_told *found = NULL;
    for (int i = from; i < hall->count; i++) {
        const struct hall_told *told = &hall->told[i];
        bool is = told->what == HALL_POST && told->verb == ACTION_CONDUCT && told->option == key_of(name);
        found = is ? told : found;
    }
    if (!found) {
        fail_msg("%s was not conducted", name);
        return 0;
    }
    return found->value;
}

static void a_first_touch_strikes_on_a_sheet_with_its_opening(void **state)
{
    (void)state;
    struct hall *hall = hall_open(STORM);
    hall_wait(hall, 20);
    assert_string_equal(kiosk_state(hall->kiosk), "attract");
    int before = hall->count;
    hall_touch(hall, EVENT_DOWN, 0, MIDDLE.x, MIDDLE.y);
    assert_string_equal(kiosk_state(hall->kiosk), "painting");
    assert_int_equal(hall->told[before].what, HALL_FRESH);
    assert_int_equal(hall->told[before + 1].verb, ACTION_CONDUCT); /* the kind first: it brings its own values */
    assert_int_equal(hall->told[before + 1].option, key_of("kind"));
    assert_float_equal(conducted(hall, before, "eta"), 2, 0);
    const struct hall_told *opening = last(hall, before, ACTION_ATTRACT);
    assert_true(opening->visitor == 0 && !opening->has_at && opening->value == 3);
    const struct hall_told *strike = &hall->told[hall->count - 1];
    assert_int_equal(strike->verb, ACTION_STRIKE);
    assert_int_equal(strike->visitor, 1);
    assert_float_equal(strike->at.x, MIDDLE.x, 1e-6);
    assert_int_equal(strike->us, hall->now_us); /* in the same turn */
    struct point at;
    assert_false(hall_find(hall, 0, HUD_INK, 0, &at));
    assert_false(hall_find(hall, 0, HUD_TOOL, TOOL_DROP, &at));
    hall_close(hall);
}

static void a_hand_that_stays_attracts_and_one_that_repels_repels(void **state)
{
    (void)state;
    struct hall *hall = hall_open(STORM);
    hall_touch(hall, EVENT_DOWN, 3, 0.5f, 0.5f);
    int before = hall->count;
    hall_wait(hall, 0.3);
    const struct hall_told *hand = last(hall, before, ACTION_ATTRACT);
    assert_true(hand->has_at && hand->value > 0 && hand->visitor >= CONTROLS_HANDS);
    int number = hand->visitor;
    for (int i = 1; i <= 30; i++) {
        hall_touch(hall, EVENT_MOVE, 3, 0.5f + 0.01f * (float)i, 0.5f);
        hall_wait(hall, 0.016);
    }
    hall_wait(hall, 0.2);
    assert_float_equal(last(hall, before, ACTION_ATTRACT)->at.x, 0.8, 0.009);
    hall_touch(hall, EVENT_UP, 3, 0.8f, 0.5f);
    assert_true(!last(hall, before, ACTION_ATTRACT)->has_at && last(hall, before, ACTION_ATTRACT)->visitor == number);
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_STRIKE), 0);
    hall_press(hall, HUD_TOOL, TOOL_REPEL);
    before = hall->count;
    hall_touch(hall, EVENT_DOWN, 0, 0.6f, 0.5f);
    assert_true(last(hall, before, ACTION_ATTRACT)->has_at && last(hall, before, ACTION_ATTRACT)->value < 0);
    hall_touch(hall, EVENT_UP, 0, 0.6f, 0.5f);
    assert_false(last(hall, before, ACTION_ATTRACT)->has_at);
    hall_press(hall, HUD_TOOL, TOOL_STROKE);
    before = hall->count;
    hall_drag(hall, 0.4f, 0.4f, 0.6f, 0.4f, 0.3);
    const struct hall_told *line = last(hall, before, ACTION_ATTRACT); /* a line that stays, the seat's own */
    assert_true(!line->has_at && line->visitor == 1 && line->value > 0);
    assert_float_equal(line->at.x, 0.6, 0.01);
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_STRIKE), 0);
    hall_close(hall);
}

static void a_button_strikes_anywhere_and_each_time_alike(void **state)
{
    (void)state;
    struct point places[2][3];
    for (int round = 0; round < 2; round++) {
        struct hall *hall = hall_open(STORM);
        hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.05);
        for (int i = 0; i < 3; i++) {
            int before = hall->count;
            hall_button(hall, STRIKE, 0.1);
            places[round][i] = last(hall, before, ACTION_STRIKE)->at;
            assert_true(places[round][i].x > 0.05f && places[round][i].x < 0.95f);
            assert_true(places[round][i].y > 0.05f && places[round][i].y < 0.95f);
        }
        hall_close(hall);
    }
    assert_memory_equal(places[0], places[1], sizeof places[0]);
    assert_true(hypotf(places[0][0].x - places[0][1].x, places[0][0].y - places[0][1].y) > 0.02f);
    assert_true(hypotf(places[0][1].x - places[0][2].x, places[0][1].y - places[0][2].y) > 0.02f);
}

static void turn_wheel(struct hall *hall, float steps)
{
    struct event event = {
        .kind = EVENT_CONTROL, .source = SOURCE_GPIO, .device = 1, .control = WHEEL, .relative = true, .value = steps};
    hall_feel(hall, &event);
}

/* So does one that sets what drops to come are like, in a painting. */
static void a_dial_of_drops_says_so(void **state)
{
    (void)state;
    struct hall *hall = hall_open(
        "exhibit: 1\n"
        "inputs:\n"
        "  gpio: {buttons: [{id: a, line: A}, {id: b, line: B}, {id: c, line: C}], encoders: [{id: w, a: D, b: E}]}\n"
        "  bindings:\n"
        "    - {touch: tap, drop: {}}\n"
        "    - {encoder: w, dial: {parameter: radius, from: 4, to: 24, steps: 20}}\n");
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.05);
    hall_wait(hall, 1);
    turn_wheel(hall, 3);
    hall_wait(hall, 0.4);
    const struct hud *hud = &hall->kiosk->hud;
    assert_true(hud->told_count == 1 && hud->told[0].key == key_find(action_keys(ACTION_DROP), "radius"));
    assert_true(hud->told[0].value > 4 && hud->told[0].value <= 24);
    assert_float_equal(kiosk_look(hall->kiosk, hall->now_us)->piece[LOOK_TOLD].opacity, 1, 0.01);
    hall_wait(hall, 5);
    assert_float_equal(hud_told_opacity(hud, hall->now_us), 0, 0); /* once */
    hall_close(hall);
}

static void a_dial_says_what_it_turns(void **state)
{
    (void)state;
    struct hall *hall = hall_open(STORM);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.05);
    hall_wait(hall, 1);
    const struct kiosk_pieces *pieces = kiosk_look(hall->kiosk, hall->now_us);
    assert_true(pieces->piece[LOOK_TOLD].opacity <= 0);
    int before = hall->count;
    turn_wheel(hall, 2);
    hall_wait(hall, 0.4);
    assert_float_equal(conducted(hall, before, "eta"), 2.5, 0.01); /* from where the file has it */
    const struct hud *hud = &hall->kiosk->hud;
    assert_true(hud->told_count == 1 && hud->told[0].key == &storm_keys[key_of("eta")]);
    assert_float_equal(hud->told[0].value, 2.5, 0.01);
    pieces = kiosk_look(hall->kiosk, hall->now_us);
    assert_float_equal(pieces->piece[LOOK_TOLD].opacity, 1, 0.01);
    const struct hud_panel *panel = &hud->panels[0];
    assert_true(pieces->piece[LOOK_TOLD].x >= panel->x + panel->width);
    hall_press(hall, HUD_METAPHOR, 0);
    float kind = conducted(hall, before, "kind");
    assert_float_equal(kind, BOLT_LIGHTNING + 1, 0);
    before = hall->count;
    float usual = hall->kiosk->options.lightning.eta; /* where the dial stands now */
    turn_wheel(hall, 1);
    hall_wait(hall, 0.1);
    assert_float_equal(conducted(hall, before, "eta"), usual < 9.75f ? usual + 0.25f : 10, 0.01);
    assert_int_equal(hud->told_count, 2); /* kind and eta */
    hall_button(hall, KIND, 0.1);
    assert_float_equal(conducted(hall, before, "kind"), BOLT_LIGHTNING + 2, 0);
    hall_wait(hall, 5);
    assert_float_equal(hud_told_opacity(hud, hall->now_us), 0, 0);
    hall_close(hall);
}

static void a_visit_ends_in_water_and_all_is_as_the_file_has_it(void **state)
{
    (void)state;
    struct hall *hall = hall_open(STORM);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.05);
    hall_button(hall, KIND, 0.1);
    int before = hall->count;
    hall_wait(hall, 60);
    assert_string_equal(kiosk_state(hall->kiosk), "attract");
    assert_int_equal(hall_count(hall, before, HALL_KEEP, ACTION_VERBS), 1);
    assert_true(hall_count(hall, before, HALL_POST, ACTION_RINSE) > 20);
    assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 1);
    assert_float_equal(hall->kiosk->options.lightning.eta, 2, 0);
    assert_int_equal(hall->kiosk->options.lightning.kind, BOLT_LIGHTNING);
    hall_close(hall);
}

static void attract_strikes_from_many_clouds_and_grows_a_coral(void **state)
{
    (void)state;
    struct hall *hall = hall_open(STORM);
    hall_wait(hall, 58);
    int strikes = hall_count(hall, 0, HALL_POST, ACTION_STRIKE);
    assert_true(strikes >= 6 && strikes <= 40);
    float least = 1, most = 0;
    for (int i = 0; i < hall->count; i++) {
        if (hall->told[i].what == HALL_POST && hall->told[i].verb == ACTION_STRIKE) {
            least = fminf(least, hall->told[i].at.x);
            most = fmaxf(most, hall->told[i].at.x);
        }
    }
    assert_true(most - least > 0.4f);
    assert_float_equal(conducted(hall, 0, "kind"), BOLT_CORAL, 0);
    assert_int_equal(hall_count(hall, 0, HALL_POST, ACTION_DROP), 0);
    int before = hall->count;
    hall_wait(hall, 10);
    assert_true(hall_count(hall, before, HALL_POST, ACTION_RINSE) > 0);
    assert_float_equal(conducted(hall, before, "kind"), BOLT_LIGHTNING, 0); /* the next begins as the file has it */
    hall_close(hall);
    hall = hall_open(REEF); /* corals alone, then ink */
    hall_wait(hall, 58);
    strikes = hall_count(hall, 0, HALL_POST, ACTION_STRIKE);
    assert_true(strikes >= 2 && strikes <= 6);
    before = hall->count;
    hall_wait(hall, 30);
    assert_ptr_equal(hall->script, kiosk_shows(hall->kiosk)->scenes[1].script);
    assert_true(hall_count(hall, before, HALL_POST, ACTION_DROP) > 0);
    hall_close(hall);
}

static void a_point_that_rests_and_the_one_switch_strike(void **state)
{
    (void)state;
    struct hall *hall = hall_open(HEAD "access: {dwell: 1}\nscenes: [{id: storm, kind: lightning}]\n");
    hall_touch(hall, EVENT_DOWN, 0, MIDDLE.x, MIDDLE.y);
    hall_wait(hall, 1.3);
    assert_int_equal(hall_painted(hall, 0, ACTION_STRIKE), 2); /* the finger, and its rest */
    hall_close(hall);
    hall = hall_open(HEAD "access: {scan: 8}\nscenes: [{id: storm, kind: lightning}]\n");
    hall_button(hall, SWITCH, 0.1);
    hall_wait(hall, 2);
    hall_button(hall, SWITCH, 0.1);
    hall_wait(hall, 2);
    int before = hall->count;
    hall_button(hall, SWITCH, 0.1);
    hall_wait(hall, 0.5);
    const struct hall_told *strike = last(hall, before, ACTION_STRIKE);
    assert_true(strike->has_at && strike->at.x > 0.1f && strike->at.x < 0.5f);
    hall_close(hall);
}

static void an_edit_conducts_and_what_has_grown_stays(void **state)
{
    (void)state;
    struct hall *hall = hall_open(STORM);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.05);
    int before = hall->count;
    struct exhibit *next = hall_exhibit(HEAD "scenes: [{id: storm, kind: lightning, lightning: {eta: 5}}]\n");
    struct exhibit *old = kiosk_exhibit(hall->kiosk, next, hall->now_us);
    struct inputs *inputs = next->inputs;
    next->inputs = old->inputs;
    old->inputs = inputs;
    kiosk_controls(hall->kiosk, hall->controls);
    exhibit_destroy(old);
    assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 0);
    assert_float_equal(conducted(hall, before, "eta"), 5, 0);
    hall_close(hall);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_first_touch_strikes_on_a_sheet_with_its_opening),
        cmocka_unit_test(a_hand_that_stays_attracts_and_one_that_repels_repels),
        cmocka_unit_test(a_button_strikes_anywhere_and_each_time_alike),
        cmocka_unit_test(a_dial_of_drops_says_so),
        cmocka_unit_test(a_dial_says_what_it_turns),
        cmocka_unit_test(a_visit_ends_in_water_and_all_is_as_the_file_has_it),
        cmocka_unit_test(attract_strikes_from_many_clouds_and_grows_a_coral),
        cmocka_unit_test(a_point_that_rests_and_the_one_switch_strike),
        cmocka_unit_test(an_edit_conducts_and_what_has_grown_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
