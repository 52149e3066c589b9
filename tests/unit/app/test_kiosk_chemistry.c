/* A scene of chemistry, driven by devices on a fake clock: what visitors and attract do there, the map, and what the
 * stage is told. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <string.h>

#include "gray_scott_classes.h"
#include "hid_usage.h"
#include "hud_map.h"
#include "kiosk_case.h"
#include "kiosk_state.h"

#define HEAD                                                                                                           \
    "exhibit: 1\n"                                                                                                     \
    "display: {width: 530}\n"                                                                                          \
    "visit: {idle: 30, countdown: 10, thanks: 5, wash: 4, attract: 60}\n"                                              \
    "inputs:\n"                                                                                                        \
    "  gpio: {buttons: [{id: a, line: A}, {id: b, line: B}, {id: c, line: C}]}\n"                                      \
    "  bindings:\n"                                                                                                    \
    "    - {button: a, dose: {}}\n"                                                                                    \
    "    - {button: b, next_kind: {}}\n"                                                                               \
    "    - {button: c, switch: {}}\n"                                                                                  \
    "    - {usage: Rx, turn: {chemistry: feed, from: 0.01, to: 0.07, smooth: 0, dead_zone: 0}}\n"                      \
    "    - {usage: Ry, turn: {chemistry: kill, from: 0.045, to: 0.065, smooth: 0, dead_zone: 0}}\n"

static const char DISH[] = HEAD "scenes: [{id: dish, kind: chemistry, chemistry: {preset: maze}}]\n";

enum { DOSE, KIND, SWITCH };

static const uint32_t RX = HID_USAGE(HID_PAGE_DESKTOP, 0x33), RY = HID_USAGE(HID_PAGE_DESKTOP, 0x34);
static const struct point MIDDLE = {0.6f, 0.4f};

static int key_of(const char *name)
{
    return (int)(key_find(dish_keys, name) - dish_keys);
}

/* The value that was set last; -1: none was. */
static float reacted(const struct hall *hall, int from, const char *name)
{
    float value = -1;
    for (int i = from; i < hall->count; i++) {
        const struct hall_told *told = &hall->told[i];
        bool is = told->what == HALL_POST && told->verb == ACTION_REACT && told->option == key_of(name);
        value = is ? told->value : value;
    }
    return value;
}

static void a_finger_doses_erases_and_takes_back(void **state)
{
    (void)state;
    struct hall *hall = hall_open(DISH);
    struct point at;
    hall_wait(hall, 10);
    int before = hall->count;
    hall_touch(hall, EVENT_DOWN, 0, MIDDLE.x, MIDDLE.y);
    assert_int_equal(hall->told[before].what, HALL_FRESH);
    assert_int_equal(hall->told[before + 1].verb, ACTION_REACT); /* the preset first: it brings feed and kill */
    assert_int_equal(hall->told[before + 1].option, key_of("preset"));
    const struct hall_told *dose = &hall->told[hall->count - 1];
    assert_true(dose->verb == ACTION_DOSE && dose->visitor == 1 && dose->us == hall->now_us);
    hall_touch(hall, EVENT_UP, 0, MIDDLE.x, MIDDLE.y);
    assert_false(hall_find(hall, 0, HUD_INK, 0, &at));
    assert_false(hall_find(hall, 0, HUD_TOOL, TOOL_STRIKE, &at));
    before = hall->count;
    hall_drag(hall, 0.5f, 0.4f, 0.7f, 0.4f, 0.3);
    assert_true(hall_painted(hall, before, ACTION_DOSE) >= 5);
    assert_float_equal(hall->told[hall->count - 1].at.x, 0.7, 0.01);
    hall_press(hall, HUD_TOOL, TOOL_ERASE);
    before = hall->count;
    hall_drag(hall, 0.5f, 0.4f, 0.7f, 0.4f, 0.3);
    assert_true(hall_painted(hall, before, ACTION_DOSE) >= 5);
    hall->sheet.can_undo = 1 << 1;
    hall_press(hall, HUD_UNDO, 0);
    assert_int_equal(hall_painted(hall, before, ACTION_UNDO), 1);
    before = hall->count;
    hall_button(hall, DOSE, 0.1); /* it has no point: somewhere */
    assert_int_equal(hall_painted(hall, before, ACTION_DOSE), 1);
    assert_true(hall->told[hall->count - 1].has_at);
    hall_close(hall);
}

/* The middle of the open map, 0..1 of the sheet. */
static struct point map_of(const struct hall *hall, float across, float down)
{
    float place[4];
    assert_true(hud_map_place(&hall->kiosk->hud, 0, place));
    return (struct point){(place[0] + across * place[2]) / (float)hall->width,
                          (place[1] + down * place[3]) / (float)hall->height};
}

static void a_finger_on_the_map_picks(void **state)
{
    (void)state;
    struct hall *hall = hall_open(DISH);
    float place[4];
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    assert_false(hud_map_place(&hall->kiosk->hud, 0, place));
    hall_press(hall, HUD_TOOL, TOOL_MAP);
    hall_wait(hall, 1);
    const struct kiosk_pieces *pieces = kiosk_look(hall->kiosk, hall->now_us);
    assert_true(pieces->piece[LOOK_MAP].opacity > 0.5f);
    const struct hud *hud = &hall->kiosk->hud;
    assert_true(hud_map_place(hud, 0, place) && place[2] >= 60 * hud->mm);
    assert_float_equal(hud->map_feed, gray_scott_preset_find("maze")->feed, 1e-6);
    struct point low = map_of(hall, 0.3f, 0.8f), high = map_of(hall, 0.7f, 0.3f);
    int before = hall->count;
    hall_touch(hall, EVENT_DOWN, 0, low.x, low.y);
    hall_wait(hall, 0.05);
    float feed = reacted(hall, before, "feed"), kill = reacted(hall, before, "kill");
    assert_true(feed > 0 && kill > 0);
    assert_float_equal(hud->map_feed, feed, 1e-6);
    hall_touch(hall, EVENT_MOVE, 0, high.x, high.y);
    hall_wait(hall, 0.05);
    assert_true(reacted(hall, before, "feed") > feed + 0.01f); /* upwards is more */
    assert_true(reacted(hall, before, "kill") > kill + 0.005f);
    hall_touch(hall, EVENT_MOVE, 0, 0.99f, 0.01f); /* beyond its corner: the corner */
    hall_wait(hall, 0.05);
    hall_touch(hall, EVENT_UP, 0, 0.99f, 0.01f);
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_DOSE), 0);
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_REACT), 6); /* both rates, each frame at most */
    assert_int_equal(hud->told_count, 2);
    before = hall->count;
    hall_tap(hall, 0.9f, 0.5f, 0.1); /* beside the map it doses */
    assert_int_equal(hall_painted(hall, before, ACTION_DOSE), 1);
    hall_press(hall, HUD_TOOL, TOOL_DOSE);
    assert_false(hud_map_place(hud, 0, place));
    hall_close(hall);
}

static void axis(struct hall *hall, uint32_t usage, float value)
{
    struct event event = {.kind = EVENT_CONTROL, .source = SOURCE_HID, .device = 3, .control = usage, .value = value};
    hall_feel(hall, &event);
}

static void a_joystick_steers_feed_and_kill(void **state)
{
    (void)state;
    struct hall *hall = hall_open(DISH);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    int before = hall->count;
    axis(hall, RX, 0.5f);
    axis(hall, RY, 0.25f);
    hall_wait(hall, 0.1);
    assert_float_equal(reacted(hall, before, "feed"), 0.04, 1e-4);
    assert_float_equal(reacted(hall, before, "kill"), 0.05, 1e-4);
    const struct hud *hud = &hall->kiosk->hud;
    assert_int_equal(hud->told_count, 2); /* both are shown */
    before = hall->count;
    for (int i = 0; i <= 60; i++) { /* a second of one, the other rests: it follows as coefficients do */
        axis(hall, RX, 0.5f + 0.5f * (float)i / 60);
        hall_wait(hall, 0.016);
    }
    assert_float_equal(reacted(hall, before, "feed"), 0.07, 1e-4);
    assert_float_equal(reacted(hall, before, "kill"), -1, 0);
    assert_true(hall_count(hall, before, HALL_POST, ACTION_REACT) > 30);
    hall_close(hall);
}

static void another_pattern_brings_its_rates(void **state)
{
    (void)state;
    struct hall *hall = hall_open(DISH);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    int before = hall->count, maze = (int)(gray_scott_preset_find("maze") - gray_scott_presets);
    hall_button(hall, KIND, 0.1);
    assert_float_equal(reacted(hall, before, "preset"), maze + 1, 0);
    assert_float_equal(hall->kiosk->options.chemistry.reaction.feed, gray_scott_presets[maze + 1].feed, 1e-6);
    assert_float_equal(hall->kiosk->hud.map_kill, gray_scott_presets[maze + 1].kill, 1e-6);
    hall_press(hall, HUD_METAPHOR, 0);
    assert_float_equal(reacted(hall, before, "preset"), maze + 2, 0);
    for (int i = 0; i < 40; i++) { /* round and round, there is always a next */
        hall_button(hall, KIND, 0.02);
    }
    assert_true(gray_scott_presets[(int)reacted(hall, before, "preset")].name);
    before = hall->count;
    hall_wait(hall, 60);
    assert_string_equal(kiosk_state(hall->kiosk), "attract");
    assert_int_equal(hall_count(hall, before, HALL_KEEP, ACTION_VERBS), 1);
    assert_true(hall_count(hall, before, HALL_POST, ACTION_RINSE) > 20);
    assert_float_equal(reacted(hall, before, "preset"), maze, 0);
    hall_close(hall);
}

/* The way on which attract goes stays among patterns: near enough to one that lives. */
static void attract_doses_and_drifts_where_something_lives(void **state)
{
    (void)state;
    struct hall *hall = hall_open(DISH);
    hall_wait(hall, 58);
    int doses = hall_count(hall, 0, HALL_POST, ACTION_DOSE), drifts = 0;
    assert_true(doses >= 4 && doses <= 16);
    float feed = gray_scott_preset_find("maze")->feed, kill = gray_scott_preset_find("maze")->kill, way = 0;
    for (int i = 0; i < hall->count; i++) {
        const struct hall_told *told = &hall->told[i];
        if (told->what != HALL_POST || told->verb != ACTION_REACT || told->us < 2000000) {
            continue;
        }
        float *rate = told->option == key_of("feed") ? &feed : &kill;
        assert_true(told->option == key_of("feed") || told->option == key_of("kill"));
        assert_true(fabsf(told->value - *rate) < 0.004f); /* slowly */
        way += fabsf(told->value - *rate);
        *rate = told->value;
        drifts++;
        const struct gray_scott_preset *near = gray_scott_preset_near(feed, kill);
        assert_true(near->is != CLASS_UNIFORM);
        assert_true(hypotf((near->feed - feed) / 0.11f, (near->kill - kill) / 0.04f) < 0.16f);
    }
    assert_true(drifts >= 20 && way > 0.01f);
    assert_int_equal(hall_count(hall, 0, HALL_POST, ACTION_DROP), 0);
    hall_close(hall);
}

static void the_one_switch_doses_and_picks(void **state)
{
    (void)state;
    struct hall *hall = hall_open(HEAD "access: {scan: 8}\nscenes: [{id: dish, kind: chemistry}]\n");
    hall_button(hall, SWITCH, 0.1);
    hall_wait(hall, 4);
    hall_button(hall, SWITCH, 0.1);
    hall_wait(hall, 3);
    int before = hall->count;
    hall_button(hall, SWITCH, 0.1);
    hall_wait(hall, 0.5);
    assert_int_equal(hall_painted(hall, before, ACTION_DOSE), 1);
    hall_close(hall);
    hall = hall_open(HEAD "access: {dwell: 1}\nscenes: [{id: dish, kind: chemistry}]\n");
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    hall_press(hall, HUD_TOOL, TOOL_MAP);
    hall_wait(hall, 1);
    struct point at = map_of(hall, 0.5f, 0.5f);
    before = hall->count;
    assert_true(hud_map_tap(&hall->kiosk->hud, at.x, at.y, hall->now_us));
    hall_wait(hall, 0.1);
    assert_true(reacted(hall, before, "feed") > 0);
    assert_false(hud_map_tap(&hall->kiosk->hud, 0.95f, 0.5f, hall->now_us));
    hall_close(hall);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_finger_doses_erases_and_takes_back),
        cmocka_unit_test(a_finger_on_the_map_picks),
        cmocka_unit_test(a_joystick_steers_feed_and_kill),
        cmocka_unit_test(another_pattern_brings_its_rates),
        cmocka_unit_test(attract_doses_and_drifts_where_something_lives),
        cmocka_unit_test(the_one_switch_doses_and_picks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
