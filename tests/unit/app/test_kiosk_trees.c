/* A scene of trees, driven by devices on a fake clock: what visitors, the curator and attract do there, and what the
 * stage is told. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "folder_case.h"
#include "kiosk_case.h"
#include "kiosk_state.h"

#define HEAD                                                                                                           \
    "exhibit: 1\n"                                                                                                     \
    "display: {width: 530}\n"                                                                                          \
    "visit: {idle: 30, countdown: 10, thanks: 5, wash: 4, attract: 60}\n"                                              \
    "pictures: stock\n"                                                                                                \
    "inputs:\n"                                                                                                        \
    "  gpio: {buttons: [{id: a, line: A}, {id: b, line: B}, {id: c, line: C}], encoders: [{id: w, a: D, b: E}]}\n"     \
    "  bindings:\n"                                                                                                    \
    "    - {button: a, next_picture: {}}\n"                                                                            \
    "    - {button: b, next_metaphor: {}}\n"                                                                           \
    "    - {button: c, drop: {}}\n"                                                                                    \
    "    - {encoder: w, turn: {growth: endpoints, from: 1000, to: 5000, steps: 40, smooth: 0}}\n"

static const char TREES[] = HEAD "scenes: [{id: wood, kind: trees, trees: {metaphor: vine, endpoints: 2000}}]\n";
static const char BOTH[] = HEAD "scenes: [{id: wood, kind: trees}, {id: paper}]\n";

enum { PICTURE, KIND, DROP, WHEEL };

static const struct point MIDDLE = {0.45f, 0.4f};

/* The index of the next one, from `from` on; fails when there is none. */
static int find(const struct hall *hall, int from, enum action_verb verb)
{
    for (int i = from; i < hall->count; i++) {
        if (hall->told[i].what == HALL_POST && hall->told[i].verb == verb) {
            return i;
        }
    }
    fail_msg("no %s", action_name(verb));
    return -1;
}

static int key_of(const char *name)
{
    return (int)(key_find(growth_keys, name) - growth_keys);
}

/* The value that a shape since `from` gave last; fails when none did. */
static float shaped(const struct hall *hall, int from, const char *name)
{
    int last = -1;
    for (int i = from; i < hall->count; i++) {
        const struct hall_told *told = &hall->told[i];
        last = told->what == HALL_POST && told->verb == ACTION_SHAPE && told->option == key_of(name) ? i : last;
    }
    assert_true(last >= 0);
    return hall->told[last].value;
}

static void a_first_touch_plants_on_the_picture_that_is_seen(void **state)
{
    (void)state;
    struct hall *hall = hall_open(TREES);
    hall_wait(hall, 130);
    assert_string_equal(kiosk_state(hall->kiosk), "attract");
    int seen = hall->picture, before = hall->count;
    assert_true(seen > 0); /* attract has gone on to another */
    hall_touch(hall, EVENT_DOWN, 0, MIDDLE.x, MIDDLE.y);
    assert_string_equal(kiosk_state(hall->kiosk), "painting");
    assert_int_equal(hall->told[before].what, HALL_FRESH);
    assert_int_equal(hall->told[before + 1].verb, ACTION_STOCK);
    assert_int_equal(hall->told[before + 1].picture, seen);
    assert_int_equal(hall->told[before + 2].verb, ACTION_SHAPE); /* the metaphor first: it brings its own values */
    assert_int_equal(hall->told[before + 2].option, key_of("metaphor"));
    assert_float_equal(hall->told[before + 2].value, METAPHOR_VINE, 0);
    assert_float_equal(shaped(hall, before, "endpoints"), 2000, 0);
    const struct hall_told *last = &hall->told[hall->count - 1];
    assert_int_equal(last->verb, ACTION_PLANT);
    assert_int_equal(last->visitor, 1);
    assert_float_equal(last->at.x, MIDDLE.x, 1e-6);
    assert_int_equal(last->us, hall->now_us); /* in the same turn */
    hall_close(hall);
}

static void a_hand_that_stays_is_held_follows_and_is_lifted(void **state)
{
    (void)state;
    struct hall *hall = hall_open(TREES);
    hall_touch(hall, EVENT_DOWN, 3, 0.5f, 0.5f);
    int before = hall->count;
    hall_wait(hall, 0.13);
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_HOLD), 0);
    hall_wait(hall, 0.05);
    int held = find(hall, before, ACTION_HOLD);
    assert_true(hall->told[held].has_at && hall->told[held].at.x == 0.5f);
    for (int i = 1; i <= 60; i++) { /* a second */
        hall_touch(hall, EVENT_MOVE, 3, 0.5f + 0.005f * (float)i, 0.5f);
        hall_wait(hall, 0.016);
    }
    hall_wait(hall, 0.2);
    int holds = hall_count(hall, before, HALL_POST, ACTION_HOLD);
    assert_true(holds >= 10 && holds <= 18); /* not with every move */
    const struct hall_told *last = &hall->told[hall->count - 1];
    assert_true(last->verb == ACTION_HOLD && last->has_at);
    assert_float_equal(last->at.x, 0.8, 0.009);
    int hand = last->visitor;
    hall_touch(hall, EVENT_DOWN, 5, 0.2f, 0.2f); /* another hand is another number */
    hall_wait(hall, 0.3);
    assert_true(hall->told[hall->count - 1].verb == ACTION_HOLD && hall->told[hall->count - 1].visitor != hand);
    hall_touch(hall, EVENT_UP, 3, 0.8f, 0.5f);
    last = &hall->told[hall->count - 1];
    assert_true(last->verb == ACTION_HOLD && last->visitor == hand && !last->has_at);
    hall_touch(hall, EVENT_CANCEL, 5, 0.2f, 0.2f); /* a palm */
    last = &hall->told[hall->count - 1];
    assert_true(last->verb == ACTION_HOLD && last->visitor != hand && !last->has_at);
    before = hall->count;
    hall_tap(hall, 0.3f, 0.3f, 0.05); /* a short one only plants */
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_PLANT), 1);
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_HOLD), 0);
    hall_close(hall);
}

static void tools_tend_and_thin_and_undo_is_its_seats(void **state)
{
    (void)state;
    struct hall *hall = hall_open(TREES);
    struct point at;
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.05);
    hall->sheet.can_undo = 1 << 1;
    assert_false(hall_find(hall, 0, HUD_INK, 0, &at));
    assert_false(hall_find(hall, 0, HUD_TOOL, TOOL_BRUSH, &at));
    hall_press(hall, HUD_TOOL, TOOL_TEND);
    int before = hall->count;
    hall_drag(hall, 0.4f, 0.4f, 0.6f, 0.4f, 0.3);
    assert_true(hall->told[find(hall, before, ACTION_TEND)].value > 0);
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_PLANT), 0);
    hall_press(hall, HUD_TOOL, TOOL_THIN);
    before = hall->count;
    hall_drag(hall, 0.4f, 0.4f, 0.6f, 0.4f, 0.3);
    assert_true(hall->told[find(hall, before, ACTION_TEND)].value < 0);
    before = hall->count;
    hall_press(hall, HUD_UNDO, 0);
    assert_int_equal(hall_painted(hall, before, ACTION_UNDO), 1);
    hall_button(hall, DROP, 0.1); /* no ink falls in a scene of trees */
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_DROP), 0);
    hall_close(hall);
}

static void the_next_picture_comes_when_it_is_read(void **state)
{
    (void)state;
    struct hall *hall = hall_open(TREES);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.05);
    int was = hall->picture, before = hall->count;
    hall_press(hall, HUD_PICTURE, 0);
    assert_int_equal(hall->told[find(hall, before, ACTION_STOCK)].picture, was + 1);
    assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 0); /* what was planted stays */
    hall->reading = true;
    before = hall->count;
    hall_button(hall, PICTURE, 0.1);
    hall_wait(hall, 1);
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_STOCK), 0);
    hall->reading = false;
    hall_wait(hall, 0.1);
    assert_int_equal(hall->told[find(hall, before, ACTION_STOCK)].picture, was + 2);
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_STOCK), 1); /* once */
    hall_close(hall);
}

static void a_sheet_whose_picture_is_not_read_yet_gets_it_later(void **state)
{
    (void)state;
    struct hall *hall = hall_open(TREES);
    hall->reading = true;
    hall_touch(hall, EVENT_DOWN, 0, MIDDLE.x, MIDDLE.y);
    hall_touch(hall, EVENT_UP, 0, MIDDLE.x, MIDDLE.y);
    assert_int_equal(hall_count(hall, 0, HALL_POST, ACTION_PLANT), 1);
    assert_int_equal(hall_count(hall, 0, HALL_POST, ACTION_STOCK), 0);
    hall->reading = false;
    hall_wait(hall, 0.1);
    assert_int_equal(hall_count(hall, 0, HALL_POST, ACTION_STOCK), 1);
    hall_close(hall);
}

static void turn_wheel(struct hall *hall, float steps)
{
    struct event event = {
        .kind = EVENT_CONTROL, .source = SOURCE_GPIO, .device = 1, .control = WHEEL, .relative = true, .value = steps};
    hall_feel(hall, &event);
}

static void a_dial_shapes_and_another_kind_brings_its_own_values(void **state)
{
    (void)state;
    struct hall *hall = hall_open(TREES);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.05);
    hall_wait(hall, 1);
    int before = hall->count;
    for (int i = 0; i < 60; i++) { /* a second of turning: 10 detents of 100, from 2000 on */
        turn_wheel(hall, 10.0f / 60);
        hall_wait(hall, 0.016);
    }
    hall_wait(hall, 0.3);
    int shapes = hall_count(hall, before, HALL_POST, ACTION_SHAPE);
    assert_true(shapes >= 4 && shapes <= 8); /* six a second */
    assert_float_equal(shaped(hall, before, "endpoints"), 3000, 1);
    before = hall->count;
    hall_wait(hall, 1);
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_SHAPE), 0);
    hall_press(hall, HUD_METAPHOR, 0);
    assert_float_equal(shaped(hall, before, "metaphor"), METAPHOR_VINE + 1, 0);
    before = hall->count;
    turn_wheel(hall, 1);
    hall_wait(hall, 0.3);
    float usual = (float)growth_preset(METAPHOR_VINE + 1, false).endpoints; /* where the dial stands now */
    assert_true(usual < 2000);
    assert_float_equal(shaped(hall, before, "endpoints"), usual + 100, 1);
    before = hall->count;
    hall_button(hall, KIND, 0.1);
    assert_float_equal(shaped(hall, before, "metaphor"), METAPHOR_VINE + 2, 0);
    hall_close(hall);
}

static void a_visit_ends_in_water_and_the_next_has_another_picture(void **state)
{
    (void)state;
    struct hall *hall = hall_open(TREES);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.05);
    hall_button(hall, KIND, 0.1);
    int was = hall->picture, before = hall->count;
    hall_wait(hall, 60);
    assert_string_equal(kiosk_state(hall->kiosk), "attract");
    assert_int_equal(hall_count(hall, before, HALL_KEEP, ACTION_VERBS), 1);
    assert_true(hall_count(hall, before, HALL_POST, ACTION_RINSE) > 20);
    assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 1);
    assert_int_equal(hall->told[find(hall, before, ACTION_STOCK)].picture, was + 1);
    assert_float_equal(shaped(hall, before, "metaphor"), METAPHOR_VINE, 0); /* it grows as the file has it */
    hall_close(hall);
}

static void attract_plants_tends_and_goes_through_both_kinds(void **state)
{
    (void)state;
    struct hall *hall = hall_open(BOTH);
    hall_wait(hall, 58);
    int seeds = hall_count(hall, 0, HALL_POST, ACTION_PLANT);
    assert_true(seeds >= 1 && seeds <= 3);
    assert_true(hall_count(hall, 0, HALL_POST, ACTION_TEND) >= 1);
    assert_int_equal(hall_count(hall, 0, HALL_POST, ACTION_DROP), 0);
    int before = hall->count;
    hall_wait(hall, 60);
    assert_true(hall_count(hall, before, HALL_POST, ACTION_RINSE) > 0);
    assert_ptr_equal(hall->script, kiosk_shows(hall->kiosk)->scenes[1].script);
    assert_true(hall_count(hall, before, HALL_POST, ACTION_DROP) > 0);
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_STOCK), 0);
    before = hall->count;
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.3);
    assert_int_equal(hall_painted(hall, before, ACTION_DROP), 1);
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_PLANT), 0);
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_HOLD), 0);
    hall_close(hall);
}

/* The file is another while somebody paints. */
static int reload(struct hall *hall, const char *yaml)
{
    int before = hall->count;
    struct exhibit *next = hall_exhibit(yaml), *old = kiosk_exhibit(hall->kiosk, next, hall->now_us);
    struct inputs *inputs = next->inputs;
    next->inputs = old->inputs;
    old->inputs = inputs;
    kiosk_controls(hall->kiosk, hall->controls);
    exhibit_destroy(old);
    return before;
}

static void an_edit_shapes_what_grows_and_another_kind_is_another_sheet(void **state)
{
    (void)state;
    struct hall *hall = hall_open(TREES);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.05);
    int before = reload(hall, TREES);
    assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 0);
    assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_SHAPE), 0);
    before = reload(hall, HEAD "scenes: [{id: wood, kind: trees, trees: {metaphor: frost}}]\n");
    assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 0); /* what was planted stays */
    assert_float_equal(shaped(hall, before, "metaphor"), METAPHOR_FROST, 0);
    before = reload(hall, HEAD "scenes: [{id: wood}]\n");
    assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 1);
    before = hall->count;
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.3);
    assert_int_equal(hall_painted(hall, before, ACTION_DROP), 1); /* with a tool of this kind */
    before = reload(hall, TREES);
    assert_int_equal(hall->told[find(hall, before, ACTION_STOCK)].picture, hall->picture);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.05);
    assert_int_equal(hall_painted(hall, before, ACTION_PLANT), 1);
    hall_close(hall);
}

static void a_point_that_rests_plants(void **state)
{
    (void)state;
    struct hall *hall = hall_open(HEAD "access: {dwell: 1}\nscenes: [{id: wood, kind: trees}]\n");
    hall_touch(hall, EVENT_DOWN, 0, MIDDLE.x, MIDDLE.y);
    hall_wait(hall, 1.3);
    assert_int_equal(hall_painted(hall, 0, ACTION_PLANT), 2); /* the finger, and its rest */
    hall_close(hall);
}

/* The exhibits lie in the current folder: a picture in `stock`, which nobody opens. */
static int make_folder(void **state)
{
    bool good = folder_case_enter(state) == 0 && mkdir("stock", 0755) == 0 && folder_case_put("stock/a.png", "");
    return good ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_first_touch_plants_on_the_picture_that_is_seen),
        cmocka_unit_test(a_hand_that_stays_is_held_follows_and_is_lifted),
        cmocka_unit_test(tools_tend_and_thin_and_undo_is_its_seats),
        cmocka_unit_test(the_next_picture_comes_when_it_is_read),
        cmocka_unit_test(a_sheet_whose_picture_is_not_read_yet_gets_it_later),
        cmocka_unit_test(a_dial_shapes_and_another_kind_brings_its_own_values),
        cmocka_unit_test(a_visit_ends_in_water_and_the_next_has_another_picture),
        cmocka_unit_test(attract_plants_tends_and_goes_through_both_kinds),
        cmocka_unit_test(an_edit_shapes_what_grows_and_another_kind_is_another_sheet),
        cmocka_unit_test(a_point_that_rests_plants),
    };
    return cmocka_run_group_tests(tests, make_folder, folder_case_leave);
}
