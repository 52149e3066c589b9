/* From events to actions (app/controls.h), and the lamps that go with them (app/lamps.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "controls_case.h"
#include "hid_usage.h"
#include "lamps.h"
#include "near.h"

static void centred(struct place *place, uint32_t usage, float value)
{
    struct event event = {.kind = EVENT_CONTROL, .source = SOURCE_HID, .device = 1, .control = usage, .value = value};
    event.centred = true;
    event.time_us = place->now_us;
    controls_feel(place->controls, &event);
}

static void steps(struct place *place, enum event_source source, uint32_t usage, float value)
{
    struct event event = {.kind = EVENT_CONTROL, .source = source, .device = 1, .control = usage, .value = value};
    event.relative = true;
    event.time_us = place->now_us;
    controls_feel(place->controls, &event);
}

static int count_actions(struct place *place, enum action_verb verb)
{
    int count = 0;
    while (take(place)) {
        assert_int_equal(place->action.verb, verb);
        count++;
    }
    return count;
}

#define X        HID_USAGE(HID_PAGE_DESKTOP, 0x30)
#define DIAL     HID_USAGE(HID_PAGE_DESKTOP, 0x37)
#define HAT      HID_USAGE(HID_PAGE_DESKTOP, 0x39)
#define BUTTON_1 HID_USAGE(HID_PAGE_BUTTON, 1)
#define BUTTON_2 HID_USAGE(HID_PAGE_BUTTON, 2)

static void the_default_paints_with_fingers(void **state)
{
    (void)state;
    struct place place = open_place(strchr(inputs_default_text(), '\n') + 1);
    for (int i = 0; i < INKS + 1; i++) {
        finger(&place, EVENT_DOWN, i, 0.2f * (float)i, 0.5f);
        assert_true(take(&place));
        assert_true(place.action.verb == ACTION_DROP && place.action.has_at && place.action.ink == i % INKS);
        assert_near(place.action.at.x, 0.2 * i, 1e-6);
        assert_true(place.time_us == place.now_us);
    }
    finger(&place, EVENT_MOVE, 1, 0.3f, 0.5f);
    finger(&place, EVENT_MOVE, 1, 0.3f, 0.6f);
    wait_ms(&place, 10);
    assert_true(take(&place) && place.action.verb == ACTION_BRUSH_SOLVENT && place.action.path.count == 3);
    assert_true(take(&place) && place.action.verb == ACTION_BRUSH_INK && place.action.ink == 1);
    assert_near(place.action.path.points[0].x, 0.2, 1e-6);
    assert_near(place.action.path.points[2].y, 0.6, 1e-6);
    assert_false(take(&place));
    assert_true(controls_are_held(place.controls));
    for (int i = 0; i < INKS + 1; i++) {
        finger(&place, EVENT_UP, i, 0.5f, 0.5f);
    }
    assert_false(controls_are_held(place.controls));
    wait_ms(&place, 1000);
    assert_false(take(&place));
    assert_int_equal(controls_timeout_ms(place.controls, place.now_us), -1);
    close_place(&place);
}

static void a_gamepad_moves_a_point_and_drops_there(void **state)
{
    (void)state;
    struct place place = open_place("bindings:\n"
                                    "  - {usage: X, cursor: {axis: x, speed: 0.5, dead_zone: 0}}\n"
                                    "  - {usage: Hat switch, cursor: {axis: both, speed: 0.5}}\n"
                                    "  - {usage: Button 1, drop: {}}\n"
                                    "  - {usage: Button 2, brush_ink: {}}\n");
    struct controls_cursor cursor;
    assert_int_equal(controls_cursors(place.controls, place.now_us, &cursor, 1), 0);
    wait_ms(&place, 10);
    centred(&place, X, 0.5f);
    for (int i = 0; i < 10; i++) {
        wait_ms(&place, 50);
    }
    centred(&place, X, 0);
    wait_ms(&place, 50);
    assert_int_equal(controls_cursors(place.controls, place.now_us, &cursor, 1), 1);
    assert_near(cursor.at.x, 0.5 + 0.5 * 0.25, 1e-4);
    control(&place, SOURCE_HID, 1, BUTTON_1, 1);
    control(&place, SOURCE_HID, 1, BUTTON_1, 0);
    assert_true(take(&place) && place.action.verb == ACTION_DROP);
    assert_near(place.action.at.x, 0.625, 1e-4);
    control(&place, SOURCE_HID, 1, HAT, 0.5f); /* down, and a button that paints meanwhile */
    control(&place, SOURCE_HID, 1, BUTTON_2, 1);
    assert_true(take(&place) && place.action.path.count == 1);
    for (int i = 0; i < 5; i++) {
        wait_ms(&place, 20);
        assert_true(take(&place) && place.action.verb == ACTION_BRUSH_INK && place.action.path.count == 2);
    }
    assert_near(place.action.path.points[1].y, 0.55, 1e-3);
    struct event left = {.kind = EVENT_LEFT, .source = SOURCE_HID, .device = 1, .time_us = place.now_us};
    controls_feel(place.controls, &left); /* in the middle of it: nothing goes on */
    wait_ms(&place, 50);
    assert_false(take(&place));
    assert_int_equal(controls_cursors(place.controls, place.now_us, &cursor, 1), 0);
    assert_false(controls_are_held(place.controls));
    close_place(&place);
}

static void conditions_of_buttons(void **state)
{
    (void)state;
    struct place place = open_place("gpio: {buttons: [{id: red, line: A}, {id: blue, line: B}]}\n"
                                    "bindings:\n"
                                    "  - {button: red, when: hold, ms: 3000, clear: {}}\n"
                                    "  - {button: red, when: short, pour: {at: [0.25, 0.75]}}\n"
                                    "  - {button: blue, when: release, drop: {},\n"
                                    "     length: {parameter: radius, from: 4, to: 24, ms: 1000}}\n"
                                    "  - {button: blue, when: double, dry: {}}\n");
    control(&place, SOURCE_GPIO, 1, 0, 1);
    assert_int_equal(controls_timeout_ms(place.controls, place.now_us), 3000);
    wait_ms(&place, 2999);
    assert_false(take(&place));
    wait_ms(&place, 1);
    assert_true(take(&place) && place.action.verb == ACTION_CLEAR);
    control(&place, SOURCE_GPIO, 1, 0, 0);
    assert_false(take(&place));
    control(&place, SOURCE_GPIO, 1, 0, 1);
    wait_ms(&place, 100);
    control(&place, SOURCE_GPIO, 1, 0, 0);
    assert_true(take(&place) && place.action.verb == ACTION_POUR);
    assert_near(place.action.at.y, 0.75, 1e-6);
    control(&place, SOURCE_GPIO, 1, 1, 1);
    wait_ms(&place, 500);
    control(&place, SOURCE_GPIO, 1, 1, 0);
    assert_true(take(&place) && place.action.verb == ACTION_DROP);
    assert_near(place.action.radius, 14, 1e-4);
    for (int i = 0; i < 2; i++) {
        control(&place, SOURCE_GPIO, 1, 1, 1);
        wait_ms(&place, 50);
        control(&place, SOURCE_GPIO, 1, 1, 0);
    }
    assert_true(take(&place) && place.action.verb == ACTION_DROP);
    assert_true(take(&place) && place.action.verb == ACTION_DRY && !place.action.has_at);
    assert_true(take(&place) && place.action.verb == ACTION_DROP);
    control(&place, SOURCE_HID, 1, 0, 1); /* another source's number 0 */
    assert_false(take(&place));
    close_place(&place);
}

static void dials_turn_coefficients_and_drops(void **state)
{
    (void)state;
    struct place place =
        open_place("gpio: {encoders: [{id: w, a: A, b: B}]}\n"
                   "bindings:\n"
                   "  - {usage: Dial, turn: {coefficient: s_max, from: 0, to: 0.6, steps: 6, smooth: 0}}\n"
                   "  - {encoder: w, dial: {parameter: amount, from: 0, to: 100, steps: 10}}\n"
                   "  - {usage: Button 1, way: down, turn: {coefficient: pattern_steps, from: 1, to: 8, "
                   "steps: 7, smooth: 0}, when: press}\n"
                   "  - {touch: tap, drop: {}}\n");
    for (int i = 0; i < 100; i++) {
        steps(&place, SOURCE_HID, DIAL, i % 2 ? 0.5f : -0.5f);
    }
    steps(&place, SOURCE_HID, DIAL, 2);
    wait_ms(&place, 10);
    assert_true(take(&place) && place.action.verb == ACTION_SET && !place.action.has_at);
    assert_string_equal(coefficient_keys[place.action.coefficient].name, "s_max");
    assert_near(place.action.value, 0.5, 1e-5); /* from .3 on */
    assert_false(take(&place));                 /* one, of a hundred events */
    control(&place, SOURCE_HID, 1, BUTTON_1, 1);
    wait_ms(&place, 10);
    assert_true(take(&place));
    assert_near(place.action.value, 7, 1e-4);
    finger(&place, EVENT_DOWN, 0, 0.5f, 0.5f);
    finger(&place, EVENT_UP, 0, 0.5f, 0.5f);
    assert_true(take(&place));
    assert_near(place.action.amount, 30, 1e-5); /* nobody has turned it yet */
    steps(&place, SOURCE_GPIO, 0, 4);
    wait_ms(&place, 10);
    finger(&place, EVENT_DOWN, 0, 0.5f, 0.5f);
    finger(&place, EVENT_UP, 0, 0.5f, 0.5f);
    assert_true(take(&place));
    assert_near(place.action.amount, 70, 1e-4);
    close_place(&place);
}

static void a_button_is_a_hand_until_it_is_let_go(void **state)
{
    (void)state;
    const struct scene_options trees = scene_options_default(SCENE_TREES);
    struct place place = open_place("bindings: [{usage: Button 1, hold: {radius: 12}}, "
                                    "{usage: Dial, turn: {growth: metaphor}}]\n");
    control(&place, SOURCE_HID, 1, BUTTON_1, 1); /* in a painting there are no hands, and nothing is turned */
    control(&place, SOURCE_HID, 1, BUTTON_1, 0);
    steps(&place, SOURCE_HID, DIAL, 3);
    wait_ms(&place, 200);
    assert_false(take(&place));
    controls_options(place.controls, &trees);
    control(&place, SOURCE_HID, 1, BUTTON_1, 1);
    assert_true(take(&place) && place.action.verb == ACTION_HOLD && place.action.has_at);
    assert_near(place.action.radius, 12, 0);
    int hand = place.action.visitor;
    assert_true(hand > EXHIBIT_SEATS && hand < CONTROLS_HANDS);
    controls_reset(place.controls); /* another visit: it is lifted all the same */
    control(&place, SOURCE_HID, 1, BUTTON_1, 0);
    assert_true(take(&place) && place.action.verb == ACTION_HOLD && !place.action.has_at);
    assert_int_equal(place.action.visitor, hand);
    control(&place, SOURCE_HID, 1, BUTTON_1, 1);
    assert_true(take(&place) && place.action.has_at);
    controls_feel(place.controls, &(struct event){.kind = EVENT_LEFT, .source = SOURCE_HID, .device = 1});
    assert_true(take(&place) && place.action.verb == ACTION_HOLD && !place.action.has_at);
    steps(&place, SOURCE_HID, DIAL, 0.4f); /* a detent is a kind, and nothing is between two */
    wait_ms(&place, 20);
    assert_false(take(&place));
    steps(&place, SOURCE_HID, DIAL, 0.7f);
    wait_ms(&place, 20);
    assert_true(take(&place) && place.action.verb == ACTION_SHAPE);
    assert_string_equal(growth_keys[place.action.option].name, "metaphor");
    assert_near(place.action.value, METAPHOR_VINE, 0);
    assert_false(take(&place));
    close_place(&place);
}

static void gestures_reach_actions(void **state)
{
    (void)state;
    struct place place = open_place("bindings:\n"
                                    "  - {touch: tap, drop: {}}\n"
                                    "  - {touch: long press, wet: {}, where: there}\n"
                                    "  - {touch: two-finger drag, guide: {strength: 2}}\n"
                                    "  - {touch: pinch, turn: {coefficient: s_max, from: 0, to: 1, smooth: 0}}\n"
                                    "  - {touch: press, when: double, clear: {}}\n");
    finger(&place, EVENT_DOWN, 0, 0.5f, 0.5f);
    finger(&place, EVENT_MOVE, 0, 0.6f, 0.5f);
    finger(&place, EVENT_UP, 0, 0.6f, 0.5f);
    assert_false(take(&place)); /* a drag is no tap */
    wait_ms(&place, 1000);
    finger(&place, EVENT_DOWN, 0, 0.5f, 0.5f);
    wait_ms(&place, 600);
    assert_true(take(&place) && place.action.verb == ACTION_WET && place.action.has_at);
    finger(&place, EVENT_UP, 0, 0.5f, 0.5f);
    wait_ms(&place, 1000);
    finger(&place, EVENT_DOWN, 0, 0.45f, 0.5f);
    finger(&place, EVENT_DOWN, 1, 0.55f, 0.5f);
    for (int i = 1; i <= 5; i++) {
        finger(&place, EVENT_MOVE, 0, 0.45f, 0.5f - 0.02f * (float)i);
        finger(&place, EVENT_MOVE, 1, 0.55f, 0.5f - 0.02f * (float)i);
    }
    wait_ms(&place, 10);
    assert_true(take(&place) && place.action.verb == ACTION_GUIDE);
    assert_near(place.action.strength, 2, 1e-6);
    assert_near(place.action.path.points[place.action.path.count - 1].y, 0.4, 1e-5);
    assert_int_equal(count_actions(&place, ACTION_SET), 0); /* they went together: no pinch stays */
    finger(&place, EVENT_MOVE, 1, 0.65f, 0.4f);             /* .1 to .2: a quarter of the way */
    wait_ms(&place, 10);
    int guides = 0;
    while (take(&place)) {
        if (place.action.verb == ACTION_SET) {
            assert_near(place.action.value, 0.55, 1e-3);
        } else {
            guides++;
        }
    }
    assert_int_equal(guides, 1);
    finger(&place, EVENT_UP, 0, 0.5f, 0.5f);
    finger(&place, EVENT_UP, 1, 0.5f, 0.5f);
    wait_ms(&place, 1000);
    for (int i = 0; i < 2; i++) {
        finger(&place, EVENT_DOWN, 0, 0.5f, 0.5f);
        wait_ms(&place, 50);
        finger(&place, EVENT_UP, 0, 0.5f, 0.5f);
    }
    int clears = 0;
    while (take(&place)) {
        clears += place.action.verb == ACTION_CLEAR;
    }
    assert_int_equal(clears, 1);
    close_place(&place);
}

static void undo_is_asked_for_once(void **state)
{
    (void)state;
    struct place place = open_place("bindings: [{usage: Button 1, when: long, undo: {}}]\n");
    control(&place, SOURCE_HID, 1, BUTTON_1, 1);
    struct wish wish;
    assert_false(controls_wish(place.controls, &wish));
    place.now_us += 1000000;
    control(&place, SOURCE_HID, 1, BUTTON_1, 0);
    assert_true(controls_wish(place.controls, &wish) && wish.kind == WISH_UNDO);
    assert_true(wish.visitor == EXHIBIT_SEATS + 1 && !wish.down && wish.time_us == place.now_us);
    assert_false(controls_wish(place.controls, &wish));
    assert_false(take(&place)); /* it lays nothing on the sheet */
    close_place(&place);
}

static void two_visitors_own_an_ink_each(void **state)
{
    (void)state;
    static const char BINDINGS[] = "bindings: [{usage: Button 1, drop: {}}, {usage: Button 2, next_ink: {}}]\n";
    char shared[200];
    struct place place = open_place(BINDINGS);
    control(&place, SOURCE_HID, 1, BUTTON_1, 1);
    control(&place, SOURCE_HID, 2, BUTTON_1, 1);
    assert_true(take(&place) && place.action.ink == 0);
    assert_true(take(&place) && place.action.ink == 1);
    control(&place, SOURCE_HID, 2, BUTTON_2, 1);
    control(&place, SOURCE_HID, 1, BUTTON_1, 0);
    control(&place, SOURCE_HID, 1, BUTTON_1, 1);
    control(&place, SOURCE_HID, 2, BUTTON_1, 0);
    control(&place, SOURCE_HID, 2, BUTTON_1, 1);
    assert_true(take(&place) && place.action.ink == 0);
    assert_true(take(&place) && place.action.ink == 2);
    close_place(&place);
    snprintf(shared, sizeof shared, "visitors: shared\n%s", BINDINGS);
    place = open_place(shared);
    control(&place, SOURCE_HID, 1, BUTTON_2, 1);
    control(&place, SOURCE_HID, 2, BUTTON_1, 1);
    assert_true(take(&place) && place.action.ink == 1);
    close_place(&place);
}

static void axes_and_hats_can_be_buttons(void **state)
{
    (void)state;
    struct place place = open_place("bindings:\n"
                                    "  - {usage: X, way: right, drop: {}}\n"
                                    "  - {usage: Hat switch, way: left, clear: {}}\n"
                                    "  - {usage: Dial, way: down, dry: {}}\n");
    centred(&place, X, -1);
    centred(&place, X, 0.45f);
    assert_false(take(&place));
    centred(&place, X, 0.55f);
    centred(&place, X, 0.45f); /* no second one before it has come back */
    centred(&place, X, 0.55f);
    assert_int_equal(count_actions(&place, ACTION_DROP), 1);
    centred(&place, X, 0.3f);
    centred(&place, X, 0.9f);
    assert_int_equal(count_actions(&place, ACTION_DROP), 1);
    control(&place, SOURCE_HID, 1, HAT, 0.25f);
    assert_false(take(&place));
    control(&place, SOURCE_HID, 1, HAT, 0.875f); /* up and left */
    assert_int_equal(count_actions(&place, ACTION_CLEAR), 1);
    steps(&place, SOURCE_HID, DIAL, 3);
    steps(&place, SOURCE_HID, DIAL, -2);
    assert_int_equal(count_actions(&place, ACTION_DRY), 2);
    steps(&place, SOURCE_HID, DIAL, -5000);
    assert_int_equal(count_actions(&place, ACTION_DRY), 4);
    close_place(&place);
}

static void a_binding_hears_its_controller_alone(void **state)
{
    (void)state;
    struct place place = open_place("controllers: [{id: a, vendor: 1, name: pad}]\n"
                                    "bindings: [{usage: Button 1, controller: a, index: 1, drop: {}}]\n");
    struct device device = {.id = 1, .vendor = 1, .name = "Gamepad"};
    control(&place, SOURCE_HID, 1, BUTTON_1, 1);
    assert_false(take(&place)); /* nobody has said who that is */
    controls_introduce(place.controls, SOURCE_HID, &device);
    device = (struct device){.id = 2, .vendor = 2, .name = "Gamepad"};
    controls_introduce(place.controls, SOURCE_HID, &device);
    control(&place, SOURCE_HID, 1, BUTTON_1, 0);
    control(&place, SOURCE_HID, 1, BUTTON_1, 1);
    assert_false(take(&place)); /* the first of its buttons */
    for (uint32_t id = 1; id <= 2; id++) {
        struct event event = {.kind = EVENT_CONTROL, .source = SOURCE_HID, .device = id, .control = BUTTON_1};
        event.index = 1;
        event.value = 1;
        controls_feel(place.controls, &event);
    }
    assert_int_equal(count_actions(&place, ACTION_DROP), 1);
    close_place(&place);
}

static void lamps_light_and_breathe(void **state)
{
    (void)state;
    struct place place = open_place("gpio:\n"
                                    "  buttons: [{id: red, line: A}]\n"
                                    "  lamps: [{id: l, line: B, button: red}, {id: m, line: C}]\n");
    struct lamps lamps = {.inputs = place.inputs};
    struct event event = {.kind = EVENT_CONTROL, .source = SOURCE_GPIO, .device = 1, .value = 1, .time_us = 100000000};
    int lamp, changes = 0;
    float level;
    lamps_feel(&lamps, &event);
    assert_true(lamps_next(&lamps, event.time_us, &lamp, &level) && lamp == 0 && level == 1.0f);
    assert_false(lamps_next(&lamps, event.time_us, &lamp, &level));
    event.value = 0;
    lamps_feel(&lamps, &event);
    assert_true(lamps_next(&lamps, event.time_us, &lamp, &level) && lamp == 0 && level == 0.0f);
    assert_false(lamps_next(&lamps, event.time_us + 29000000, &lamp, &level));
    float most = 0;
    for (uint64_t ms = 0; ms < LAMPS_BREATH_MS; ms += 10) {
        while (lamps_next(&lamps, event.time_us + 31000000 + ms * MS, &lamp, &level)) {
            changes++;
            most = level > most ? level : most;
        }
    }
    assert_true(changes > 100 && changes < 400);
    assert_near(most, 1, 0.03);
    close_place(&place);
}

static void lamps_of_controllers_light_for_their_own(void **state)
{
    (void)state;
    struct place place = open_place("controllers:\n"
                                    "  - {id: board, vendor: 1, name: board, lights: [\n"
                                    "      {id: a, usage: 'LED: Power', button: Button 1},\n"
                                    "      {id: b, bit: 8, bits: 8, most: 100, button: Button 2}]}\n"
                                    "  - {id: pad, name: pad, lights: [{id: c, bit: 0, button: Button 1}]}\n"
                                    "gpio: {lamps: [{id: l, line: A}]}\n");
    const struct inputs_light *light = &place.inputs->lights[1];
    assert_true(place.inputs->light_count == 3 && light->controller == 0 && !light->usage && light->most == 100);
    struct lamps lamps = {.inputs = place.inputs};
    struct event event = {.kind = EVENT_CONTROL, .source = SOURCE_HID, .device = 5, .value = 1, .time_us = 100000000};
    int lamp;
    float level;
    event.control = BUTTON_1;
    lamps_feel(&lamps, &event);
    assert_false(lamps_next(&lamps, event.time_us, &lamp, &level)); /* nobody has said who that is */
    lamps_introduce(&lamps, SOURCE_HID, &(struct device){.id = 5, .vendor = 1, .name = "Board"});
    lamps_introduce(&lamps, SOURCE_HID, &(struct device){.id = 6, .vendor = 1, .name = "Pad"});
    lamps_feel(&lamps, &event);
    assert_true(lamps_next(&lamps, event.time_us, &lamp, &level) && lamp == 1 && level == 1.0f);
    assert_false(lamps_next(&lamps, event.time_us, &lamp, &level)); /* that of the pad has another Button 1 */
    event.device = 6;
    lamps_feel(&lamps, &event);
    assert_true(lamps_next(&lamps, event.time_us, &lamp, &level) && lamp == 3 && level == 1.0f);
    event = (struct event){.kind = EVENT_LEFT, .source = SOURCE_HID, .device = 5, .time_us = event.time_us};
    lamps_feel(&lamps, &event);
    assert_true(lamps_next(&lamps, event.time_us, &lamp, &level) && lamp == 1 && level == 0.0f);
    lamps_introduce(&lamps, SOURCE_HID, &(struct device){.id = 6, .vendor = 1, .name = "Pad"}); /* back, and dark */
    assert_true(lamps_next(&lamps, event.time_us, &lamp, &level) && lamp == 3 && level == 1.0f);
    assert_false(lamps_next(&lamps, event.time_us, &lamp, &level));
    int told[4] = {0};
    while (lamps_next(&lamps, event.time_us + 1000000 * LAMPS_IDLE_S + 4000 * MS, &lamp, &level)) {
        told[lamp]++;
    }
    assert_true(told[0] == 1 && told[1] == 1 && told[2] == 1 && told[3] == 0); /* all breathe but the pressed one */
    close_place(&place);
}

static void more_than_anybody_can_do_is_dropped_and_counted(void **state)
{
    (void)state;
    struct place place = open_place("bindings: [{usage: Button 1, drop: {}}]\n");
    int drops = 0;
    for (uint32_t i = 0; i < 1000; i++) {
        control(&place, SOURCE_HID, 1 + i % 20, BUTTON_1, 1);
        control(&place, SOURCE_HID, 1 + i % 20, BUTTON_1, 0);
        drops += i % 10 == 0 ? count_actions(&place, ACTION_DROP) : 0; /* however often they are taken */
    }
    drops += count_actions(&place, ACTION_DROP);
    assert_int_equal(drops, CONTROLS_ACTIONS);
    assert_int_equal(controls_counts(place.controls).dropped, 1000 - CONTROLS_ACTIONS);
    wait_ms(&place, 20);
    control(&place, SOURCE_HID, 1, BUTTON_1, 1);
    assert_int_equal(count_actions(&place, ACTION_DROP), 1);
    close_place(&place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_default_paints_with_fingers),
        cmocka_unit_test(a_gamepad_moves_a_point_and_drops_there),
        cmocka_unit_test(conditions_of_buttons),
        cmocka_unit_test(dials_turn_coefficients_and_drops),
        cmocka_unit_test(a_button_is_a_hand_until_it_is_let_go),
        cmocka_unit_test(gestures_reach_actions),
        cmocka_unit_test(undo_is_asked_for_once),
        cmocka_unit_test(two_visitors_own_an_ink_each),
        cmocka_unit_test(axes_and_hats_can_be_buttons),
        cmocka_unit_test(a_binding_hears_its_controller_alone),
        cmocka_unit_test(lamps_light_and_breathe),
        cmocka_unit_test(lamps_of_controllers_light_for_their_own),
        cmocka_unit_test(more_than_anybody_can_do_is_dropped_and_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
