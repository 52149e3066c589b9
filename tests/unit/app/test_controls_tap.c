/* Drops of points that have rested, and of one switch (controls_tap of app/controls.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>

#include "controls_case.h"
#include "hid_usage.h"
#include "near.h"

#define BUTTON_1 HID_USAGE(HID_PAGE_BUTTON, 1)

enum { CONTROLLER = EXHIBIT_SEATS + 1, ANY = -1 };

static const struct exhibit_seat SEATS[] = {{{0, 0, 0.5f, 1}, -1, SIDE_OF_LEFT}, {{0.5f, 0, 1, 1}, 2, SIDE_OF_RIGHT}};

static void tap(struct place *place, int visitor, float x, float y)
{
    controls_tap(place->controls, visitor, (struct point){x, y}, place->now_us);
}

static void assert_taken(struct place *place, enum action_verb verb, int visitor, int ink)
{
    assert_true(take(place));
    assert_int_equal(place->action.verb, verb);
    assert_int_equal(place->action.visitor, visitor);
    if (ink != ANY) {
        assert_int_equal(place->action.ink, ink);
    }
    assert_int_equal(place->time_us, place->now_us);
}

static void a_tap_does_what_the_tool_of_its_seat_does(void **state)
{
    (void)state;
    static const enum action_verb FIRST[TOOLS] = {ACTION_DROP, ACTION_BRUSH_SOLVENT, ACTION_GUIDE,   ACTION_POUR,
                                                  ACTION_MASK, ACTION_REWIND,        ACTION_PLANT,   ACTION_TEND,
                                                  ACTION_TEND, ACTION_STRIKE,        ACTION_ATTRACT, ACTION_ATTRACT,
                                                  ACTION_DOSE, ACTION_DOSE,          ACTION_DOSE};
    struct place place = open_seats(strchr(inputs_default_text(), '\n') + 1, SEATS, 2);
    for (int tool = 0; tool < TOOLS; tool++) {
        struct scene_options options = scene_options_default(exhibit_tool_kinds[tool]);
        controls_options(place.controls, &options);
        controls_set_tool(place.controls, 0, (enum exhibit_tool)tool);
        tap(&place, 0, 0.25f, 0.75f);
        assert_taken(&place, FIRST[tool], 1, tool == TOOL_DROP ? 0 : ANY);
        struct point at = place.action.has_at ? place.action.at : place.action.path.points[0];
        assert_near(at.x, 0.25, 1e-6);
        assert_near(at.y, 0.75, 1e-6);
        bool path =
            tool == TOOL_REPEL || tool == TOOL_BRUSH || tool == TOOL_REWIND || tool == TOOL_TEND || tool == TOOL_THIN;
        assert_int_equal(place.action.path.count, tool == TOOL_GUIDE || tool == TOOL_STROKE ? 2 : path);
        if (tool == TOOL_REPEL) {
            assert_true(place.action.amount < 0); /* it repels, and stays, as nobody holds it there */
        }
        if (tool == TOOL_BRUSH) {
            assert_taken(&place, ACTION_BRUSH_INK, 1, 1); /* each tap takes the next ink, as fingers do */
        }
        assert_false(take(&place));
    }
    controls_options(place.controls, NULL);
    controls_set_tool(place.controls, 1, TOOL_GUIDE);
    tap(&place, 0, 1, 1);
    assert_taken(&place, ACTION_GUIDE, 2, ANY);
    assert_true(place.action.path.points[0].x < 1 && place.action.path.points[1].x == 1.0f); /* on the sheet */
    controls_set_tool(place.controls, 1, TOOL_DROP);
    tap(&place, 0, 0.75f, 0.5f);
    assert_taken(&place, ACTION_DROP, 2, 2);
    assert_false(take(&place));
    assert_false(controls_are_held(place.controls));
    close_place(&place);
}

static void a_tap_of_a_controller_is_its_own(void **state)
{
    (void)state;
    struct place place = open_seats("bindings: [{touch: press, drop: {}}, {usage: Button 1, drop: {}}]\n", SEATS, 2);
    tap(&place, CONTROLLER, 0.25f, 0.5f); /* nobody is that yet: the seat's */
    assert_taken(&place, ACTION_DROP, 1, 0);
    control(&place, SOURCE_HID, 1, BUTTON_1, 1);
    assert_taken(&place, ACTION_DROP, CONTROLLER, 1);
    tap(&place, CONTROLLER, 0.75f, 0.5f); /* over a seat with an ink of its own */
    assert_taken(&place, ACTION_DROP, CONTROLLER, 1);
    tap(&place, 0, 0.25f, 0.5f); /* it has taken nobody's */
    assert_taken(&place, ACTION_DROP, 1, 2);
    tap(&place, CONTROLLER + 1000, 0.25f, 0.5f);
    assert_taken(&place, ACTION_DROP, 1, 0);
    close_place(&place);
}

static void where_the_sheet_is_the_switch_a_tap_still_drops(void **state)
{
    (void)state;
    struct place place =
        open_place("gpio: {encoders: [{id: w, a: A, b: B}]}\n"
                   "bindings: [{touch: press, switch: {}}, {touch: tap, undo: {}},\n"
                   "           {touch: long press, clear: {}}, {touch: press, when: double, dry: {}},\n"
                   "           {encoder: w, dial: {parameter: radius, from: 4, to: 24, steps: 5}}]\n");
    struct event step = {.kind = EVENT_CONTROL, .source = SOURCE_GPIO, .device = 1, .relative = true, .value = 3};
    struct wish wish;
    controls_feel(place.controls, &step);
    wait_ms(&place, 10);
    tap(&place, 0, 0.25f, 0.5f);
    assert_taken(&place, ACTION_DROP, 1, 1); /* after whoever turns the knob */
    assert_true(place.action.has_at);
    assert_near(place.action.at.x, 0.25, 1e-6);
    assert_near(place.action.radius, 20, 1e-4);
    assert_false(take(&place));
    assert_false(controls_wish(place.controls, &wish));
    close_place(&place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tap_does_what_the_tool_of_its_seat_does),
        cmocka_unit_test(a_tap_of_a_controller_is_its_own),
        cmocka_unit_test(where_the_sheet_is_the_switch_a_tap_still_drops),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
