/* Seats, tools, inks and wishes: whose something is, and what is no action on the sheet (app/controls.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "controls_case.h"
#include "hid_usage.h"
#include "near.h"

#define BUTTON(n) HID_USAGE(HID_PAGE_BUTTON, n)
#define X         HID_USAGE(HID_PAGE_DESKTOP, 0x30)
#define DIAL      HID_USAGE(HID_PAGE_DESKTOP, 0x37)

enum { CONTROLLERS = EXHIBIT_SEATS + 1 }; /* the first of their visitors */

/* Two children at a table, one of them with an ink of her own; nobody sits in the middle. */
static const struct exhibit_seat TABLE[] = {{{0, 0, 0.4f, 1}, -1, SIDE_OF_LEFT}, {{0.6f, 0, 1, 1}, 2, SIDE_OF_RIGHT}};

static struct place open_table(const char *bindings)
{
    return open_seats(bindings, TABLE, 2);
}

static void device(struct place *place, enum event_kind kind, enum event_source source, uint32_t id)
{
    struct event event = {.kind = kind, .source = source, .device = id, .time_us = place->now_us};
    controls_feel(place->controls, &event);
}

static struct wish wanted(struct place *place)
{
    struct wish wish;
    assert_true(controls_wish(place->controls, &wish));
    return wish;
}

static void assert_wish(struct place *place, enum wish_kind kind, int visitor, bool down)
{
    struct wish wish = wanted(place);
    assert_int_equal(wish.kind, kind);
    assert_int_equal(wish.visitor, visitor);
    assert_int_equal(wish.down, down);
    assert_int_equal(wish.time_us, place->now_us);
}

static void assert_no_wish(struct place *place)
{
    struct wish wish;
    assert_false(controls_wish(place->controls, &wish));
}

static void assert_drop(struct place *place, int visitor, int ink)
{
    assert_true(take(place));
    assert_int_equal(place->action.verb, ACTION_DROP);
    assert_int_equal(place->action.visitor, visitor);
    assert_int_equal(place->action.ink, ink);
}

static void tap(struct place *place, float x, float y)
{
    finger(place, EVENT_DOWN, 0, x, y);
    finger(place, EVENT_UP, 0, x, y);
}

static void a_finger_belongs_to_the_seat_where_it_comes_down(void **state)
{
    (void)state;
    struct place place = open_table("bindings: [{touch: press, drop: {}}, {touch: drag, draw: {}}]\n");
    tap(&place, 0.1f, 0.5f);
    assert_drop(&place, 1, 0);
    tap(&place, 0.45f, 0.5f); /* nobody's: the nearest */
    assert_drop(&place, 1, 1);
    tap(&place, 0.55f, 0.5f);
    assert_drop(&place, 2, 2);
    finger(&place, EVENT_DOWN, 0, 0.9f, 0.5f);
    assert_drop(&place, 2, 2);
    for (int tenths = 8; tenths > 0; tenths -= 2) {
        finger(&place, EVENT_MOVE, 0, (float)tenths / 10, 0.5f);
        wait_ms(&place, 10);
        assert_true(take(&place) && place.action.verb == ACTION_DRAW);
        assert_true(place.action.visitor == 2 && place.action.ink == 2); /* wherever it goes */
    }
    finger(&place, EVENT_UP, 0, 0.1f, 0.5f);
    tap(&place, 0.1f, 0.5f); /* the other's inks have not been counted: the third comes after two */
    assert_drop(&place, 1, 2);
    close_place(&place);
}

static void a_seat_paints_in_the_ink_that_it_has_chosen(void **state)
{
    (void)state;
    struct place place = open_table("bindings: [{touch: press, drop: {}}, {touch: drag, draw: {ink: cyan}},\n"
                                    "           {touch: press, when: long, next_ink: {}}]\n");
    assert_int_equal(controls_ink(place.controls, 0), -1);
    assert_int_equal(controls_ink(place.controls, 1), 2);
    controls_set_ink(place.controls, 0, 1);
    controls_set_ink(place.controls, 1, 0); /* it has its own */
    controls_set_ink(place.controls, 0, INKS);
    controls_set_ink(place.controls, 7, 0);
    for (int i = 0; i < 3; i++) {
        tap(&place, 0.1f, 0.5f);
        assert_drop(&place, 1, 1);
        tap(&place, 0.9f, 0.5f);
        assert_drop(&place, 2, 2);
    }
    finger(&place, EVENT_DOWN, 0, 0.1f, 0.5f);
    assert_drop(&place, 1, 1);
    wait_ms(&place, 700);
    finger(&place, EVENT_UP, 0, 0.1f, 0.5f);
    assert_int_equal(controls_ink(place.controls, 0), 2); /* next_ink is the seat's */
    controls_set_ink(place.controls, 0, -1);
    tap(&place, 0.1f, 0.5f);
    assert_drop(&place, 1, 0);
    close_place(&place);
    place = open_table("bindings: [{touch: drag, draw: {ink: carbon black}}]\n");
    place.inputs->bindings[0].action.ink = INKS + 1; /* as read for a scene with more inks than this one */
    for (int seat = 0; seat < 2; seat++) {
        float x = seat == 0 ? 0.1f : 0.9f;
        finger(&place, EVENT_DOWN, 0, x, 0.4f);
        finger(&place, EVENT_MOVE, 0, x, 0.6f);
        finger(&place, EVENT_UP, 0, x, 0.6f);
        assert_true(take(&place) && place.action.ink == (seat == 0 ? 1 : 2)); /* her own, always */
    }
    close_place(&place);
    place = open_place("visitors: shared\nbindings: [{touch: press, drop: {}}, {usage: Button 1, drop: {}}]\n");
    controls_set_ink(place.controls, 0, 2);
    control(&place, SOURCE_HID, 1, BUTTON(1), 1);
    assert_drop(&place, CONTROLLERS, 2); /* all paint in one */
    controls_set_ink(place.controls, 0, -1);
    tap(&place, 0.5f, 0.5f);
    assert_drop(&place, 1, 2);
    close_place(&place);
    place = open_table("visitors: shared\nbindings: [{touch: press, next_ink: {}}]\n");
    controls_set_ink(place.controls, 0, 1);
    tap(&place, 0.9f, 0.5f); /* hers is not that of all */
    assert_int_equal(controls_ink(place.controls, 0), 1);
    tap(&place, 0.1f, 0.5f);
    assert_int_equal(controls_ink(place.controls, 0), 2);
    close_place(&place);
}

static void a_file_has_tools_of_its_own(void **state)
{
    (void)state;
    struct place place = open_place("bindings:\n"
                                    "  - {touch: tap, tool: mask, unmask: {}, where: there}\n"
                                    "  - {touch: two-finger drag, tool: guide, guide: {}}\n"
                                    "  - {touch: press, drop: {}}\n");
    controls_set_tool(place.controls, 0, TOOL_MASK);
    finger(&place, EVENT_DOWN, 0, 0.5f, 0.5f);
    assert_false(take(&place));
    finger(&place, EVENT_UP, 0, 0.5f, 0.5f);
    assert_true(take(&place) && place.action.verb == ACTION_UNMASK);
    controls_set_tool(place.controls, 0, TOOL_DROP); /* it has no use for two fingers: each drops */
    finger(&place, EVENT_DOWN, 0, 0.45f, 0.5f);
    finger(&place, EVENT_DOWN, 1, 0.55f, 0.5f);
    assert_drop(&place, 1, 1);
    assert_drop(&place, 1, 2);
    finger(&place, EVENT_MOVE, 1, 0.65f, 0.5f);
    wait_ms(&place, 10);
    assert_false(take(&place)); /* a tool that has bindings has no others */
    finger(&place, EVENT_UP, 0, 0.5f, 0.5f);
    finger(&place, EVENT_UP, 1, 0.5f, 0.5f);
    controls_set_tool(place.controls, 0, TOOL_GUIDE);
    finger(&place, EVENT_DOWN, 0, 0.45f, 0.5f);
    finger(&place, EVENT_DOWN, 1, 0.55f, 0.5f);
    finger(&place, EVENT_MOVE, 0, 0.45f, 0.6f);
    finger(&place, EVENT_MOVE, 1, 0.55f, 0.6f);
    wait_ms(&place, 10);
    assert_true(take(&place) && place.action.verb == ACTION_GUIDE);
    close_place(&place);
}

static void fingers_of_two_seats_are_never_of_one_hand(void **state)
{
    (void)state;
    static const struct exhibit_seat SEATS[] = {{{0, 0, 0.5f, 1}, -1, SIDE_OF_LEFT},
                                                {{0.5f, 0, 1, 1}, -1, SIDE_OF_RIGHT}};
    struct place place = open_seats("bindings: [{touch: press, drop: {}}, {touch: pinch, clear: {}}]\n", SEATS, 2);
    finger(&place, EVENT_DOWN, 0, 0.45f, 0.5f);
    finger(&place, EVENT_DOWN, 1, 0.55f, 0.5f);
    assert_drop(&place, 1, 0);
    assert_drop(&place, 2, 1);
    finger(&place, EVENT_MOVE, 1, 0.95f, 0.5f);
    assert_false(take(&place));
    finger(&place, EVENT_DOWN, 2, 0.9f, 0.5f); /* beside it, in its seat, in time */
    assert_false(take(&place));
    finger(&place, EVENT_MOVE, 2, 0.5f, 0.5f);
    assert_true(take(&place) && place.action.verb == ACTION_CLEAR && place.action.visitor == 2);
    while (take(&place)) {
        assert_int_equal(place.action.verb, ACTION_CLEAR);
    }
    finger(&place, EVENT_DOWN, 3, 0.5f, 0.1f);
    assert_drop(&place, 1, 2); /* on the edge between two: the first */
    close_place(&place);
}

static void controllers_keep_their_number(void **state)
{
    (void)state;
    struct place place = open_place("bindings: [{usage: Button 1, drop: {}}, {usage: X, cursor: {axis: x}}]\n");
    struct device pad = {.id = 4, .vendor = 1, .product = 2, .name = "Pad", .port = "usb-1"};
    struct device other = pad;
    other.id = 5;
    snprintf(other.port, sizeof other.port, "usb-2");
    controls_introduce(place.controls, SOURCE_HID, &pad);
    controls_introduce(place.controls, SOURCE_HID, &other);
    control(&place, SOURCE_HID, 4, BUTTON(1), 1);
    assert_drop(&place, CONTROLLERS, 0);
    control(&place, SOURCE_HID, 5, BUTTON(1), 1);
    assert_drop(&place, CONTROLLERS + 1, 1);
    device(&place, EVENT_LEFT, SOURCE_HID, 4);
    device(&place, EVENT_LEFT, SOURCE_HID, 5);
    control(&place, SOURCE_HID, 6, BUTTON(1), 1); /* another, meanwhile */
    assert_drop(&place, CONTROLLERS + 2, 2);
    other.id = 7; /* the second comes back first, and under another id */
    pad.id = 8;
    controls_introduce(place.controls, SOURCE_HID, &other);
    control(&place, SOURCE_HID, 7, BUTTON(1), 1);
    assert_drop(&place, CONTROLLERS + 1, 1); /* its ink as well */
    controls_introduce(place.controls, SOURCE_HID, &pad);
    control(&place, SOURCE_HID, 8, BUTTON(1), 1);
    assert_drop(&place, CONTROLLERS, 0);
    device(&place, EVENT_LEFT, SOURCE_HID, 6);
    control(&place, SOURCE_HID, 6, BUTTON(1), 1); /* nobody has said who it is: its id tells */
    assert_drop(&place, CONTROLLERS + 2, 2);
    for (uint32_t id = 100; id < 1000; id++) { /* more than there is room for: those that are there stay who they are */
        control(&place, SOURCE_HID, id, BUTTON(1), 1);
        device(&place, EVENT_LEFT, SOURCE_HID, id);
        assert_true(take(&place) && place.action.visitor > CONTROLLERS + 2);
        wait_ms(&place, 10);
    }
    close_place(&place);
}

static void cursors_tell_whose_they_are(void **state)
{
    (void)state;
    struct place place =
        open_place("bindings: [{usage: Button 1, drop: {}}, {usage: X, cursor: {axis: x, dead_zone: 0}}]\n");
    struct controls_cursor cursors[4];
    control(&place, SOURCE_HID, 1, BUTTON(1), 1); /* has not moved: no cursor */
    control(&place, SOURCE_HID, 2, X, 0.25f);
    control(&place, SOURCE_HID, 3, X, 0.75f);
    control(&place, SOURCE_HID, 3, BUTTON(1), 1);
    assert_int_equal(controls_cursors(place.controls, place.now_us, cursors, 4), 2);
    assert_int_equal(controls_cursors(place.controls, place.now_us, cursors, 1), 1);
    controls_cursors(place.controls, place.now_us + CONTROLS_CURSOR_US - 1, cursors, 4);
    assert_true(cursors[0].visitor == CONTROLLERS + 1 && cursors[0].ink == 1 && !cursors[0].held && cursors[0].used);
    assert_true(cursors[1].visitor == CONTROLLERS + 2 && cursors[1].ink == 2 && cursors[1].held);
    assert_near(cursors[1].at.x, 0.75, 1e-6);
    controls_cursors(place.controls, place.now_us + CONTROLS_CURSOR_US, cursors, 4);
    assert_false(cursors[0].used);
    struct event stick = {.kind = EVENT_CONTROL, .source = SOURCE_HID, .device = 2, .control = X, .centred = true};
    stick.time_us = place.now_us;
    stick.value = 0.01f;
    controls_feel(place.controls, &stick); /* held a little, and for long */
    stick.value = 0.3f;
    controls_feel(place.controls, &stick);
    for (int i = 0; i < 250; i++) {
        wait_ms(&place, 100);
    }
    controls_cursors(place.controls, place.now_us, cursors, 4);
    assert_true(cursors[0].used && !cursors[1].used);
    close_place(&place);
}

static void what_is_no_action_is_a_wish(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        enum wish_kind kind;
    } KINDS[] = {{"undo", WISH_UNDO},
                 {"redo", WISH_REDO},
                 {"finish", WISH_FINISH},
                 {"staff", WISH_STAFF},
                 {"next_tool", WISH_NEXT_TOOL},
                 {"next_scene", WISH_NEXT_SCENE},
                 {"next_language", WISH_NEXT_LANGUAGE},
                 {"next_picture", WISH_NEXT_PICTURE},
                 {"next_metaphor", WISH_NEXT_METAPHOR},
                 {"next_kind", WISH_NEXT_KIND}};
    assert_int_equal(sizeof KINDS / sizeof *KINDS + 1, WISHES);
    for (size_t i = 0; i < sizeof KINDS / sizeof *KINDS; i++) {
        char text[400];
        snprintf(text, sizeof text, "bindings: [{touch: press, %s: {}}, {usage: Button 1, when: release, %s: {}}]\n",
                 KINDS[i].name, KINDS[i].name);
        struct place place = open_table(text);
        tap(&place, 0.9f, 0.5f);
        assert_wish(&place, KINDS[i].kind, 2, true);
        control(&place, SOURCE_HID, 1, BUTTON(1), 1);
        assert_no_wish(&place);
        control(&place, SOURCE_HID, 1, BUTTON(1), 0);
        assert_int_equal(controls_timeout_ms(place.controls, place.now_us), 0);
        assert_wish(&place, KINDS[i].kind, CONTROLLERS, false);
        assert_no_wish(&place);
        assert_false(take(&place)); /* it lays nothing on the sheet */
        close_place(&place);
    }
}

static void a_switch_goes_down_and_comes_up(void **state)
{
    (void)state;
    struct place place = open_place("gpio: {buttons: [{id: a, line: A}]}\n"
                                    "bindings: [{button: a, switch: {}}, {touch: press, switch: {}},\n"
                                    "           {usage: Dial, switch: {}}]\n");
    control(&place, SOURCE_GPIO, 1, 0, 1);
    assert_wish(&place, WISH_SWITCH, CONTROLLERS, true);
    wait_ms(&place, 500);
    assert_no_wish(&place);
    control(&place, SOURCE_GPIO, 1, 0, 0);
    assert_wish(&place, WISH_SWITCH, CONTROLLERS, false);
    control(&place, SOURCE_GPIO, 1, 0, 1);
    assert_wish(&place, WISH_SWITCH, CONTROLLERS, true);
    device(&place, EVENT_LEFT, SOURCE_GPIO, 1);
    assert_wish(&place, WISH_SWITCH, CONTROLLERS, false);
    finger(&place, EVENT_DOWN, 0, 0.5f, 0.5f);
    finger(&place, EVENT_MOVE, 0, 0.8f, 0.5f); /* a hand that slips still presses */
    assert_wish(&place, WISH_SWITCH, 1, true);
    assert_no_wish(&place);
    finger(&place, EVENT_UP, 0, 0.5f, 0.5f);
    assert_wish(&place, WISH_SWITCH, 1, false);
    finger(&place, EVENT_DOWN, 0, 0.5f, 0.5f);
    assert_wish(&place, WISH_SWITCH, 1, true);
    finger(&place, EVENT_CANCEL, 0, 0.5f, 0.5f);
    assert_wish(&place, WISH_SWITCH, 1, false);
    struct event step = {.kind = EVENT_CONTROL, .source = SOURCE_HID, .device = 1, .control = DIAL, .relative = true};
    step.time_us = place.now_us;
    step.value = -1;
    controls_feel(place.controls, &step);
    assert_wish(&place, WISH_SWITCH, CONTROLLERS + 1, true);
    assert_wish(&place, WISH_SWITCH, CONTROLLERS + 1, false);
    assert_no_wish(&place);
    close_place(&place);
}

static void wishes_that_nobody_takes_are_bounded_and_switches_come_up(void **state)
{
    (void)state;
    struct place place = open_place("bindings: [{usage: Button 1, undo: {}}, {usage: Button 2, switch: {}}]\n");
    int wishes = 0, down = 0;
    for (uint32_t id = 1; id <= 10; id++) {
        control(&place, SOURCE_HID, id, BUTTON(2), 1);
    }
    for (int i = 0; i < 100; i++) {
        control(&place, SOURCE_HID, 1, BUTTON(1), 1);
        control(&place, SOURCE_HID, 1, BUTTON(1), 0);
    }
    for (uint32_t id = 11; id <= 20; id++) {
        control(&place, SOURCE_HID, id, BUTTON(2), 1); /* no room: neither down nor up */
    }
    for (uint32_t id = 1; id <= 20; id++) {
        control(&place, SOURCE_HID, id, BUTTON(2), 0);
    }
    struct wish wish;
    bool is_down[64] = {false};
    while (controls_wish(place.controls, &wish)) {
        wishes++;
        if (wish.kind == WISH_SWITCH) {
            assert_true(is_down[wish.visitor] != wish.down);
            is_down[wish.visitor] = wish.down;
            down += wish.down ? 1 : -1;
        }
    }
    assert_int_equal(wishes, CONTROLS_WISHES);
    assert_int_equal(down, 0);
    assert_int_equal(controls_counts(place.controls).dropped, 100 - (CONTROLS_WISHES - 20) + 10);
    assert_int_equal(controls_counts(place.controls).held, 0);
    control(&place, SOURCE_HID, 1, BUTTON(2), 1); /* and there is room again */
    assert_wish(&place, WISH_SWITCH, CONTROLLERS, true);
    close_place(&place);
}

static void a_key_switch_that_is_on_from_the_start_is_known(void **state)
{
    (void)state;
    struct place place = open_place("gpio: {buttons: [{id: key, line: A}, {id: held, line: B}]}\n"
                                    "bindings: [{button: key, staff: {}}, {button: key, when: release, staff: {}},\n"
                                    "           {button: key, drop: {}}, {button: held, when: hold, staff: {}},\n"
                                    "           {button: held, undo: {}}, {button: held, switch: {}}]\n");
    for (uint32_t i = 0; i < 2; i++) {
        struct event event = {.kind = EVENT_STANDING, .source = SOURCE_GPIO, .device = 1, .control = i, .value = 1};
        event.time_us = place.now_us;
        controls_feel(place.controls, &event);
    }
    assert_wish(&place, WISH_STAFF, CONTROLLERS, true);
    assert_no_wish(&place);
    assert_false(take(&place)); /* a button that is held at the start does not paint */
    wait_ms(&place, PRESS_HOLD_MS);
    assert_wish(&place, WISH_STAFF, CONTROLLERS, true);
    control(&place, SOURCE_GPIO, 1, 0, 0);
    assert_wish(&place, WISH_STAFF, CONTROLLERS, false);
    control(&place, SOURCE_GPIO, 1, 1, 0);
    assert_no_wish(&place);
    assert_false(take(&place));
    close_place(&place);
}

static void what_has_jammed_is_nobodys_hand(void **state)
{
    (void)state;
    struct place place = open_place("gpio: {buttons: [{id: key, line: A}]}\n"
                                    "bindings: [{button: key, staff: {}}, {touch: press, dry: {}},\n"
                                    "           {usage: Button 1, drop: {}}]\n");
    wait_ms(&place, 1);
    control(&place, SOURCE_GPIO, 1, 0, 1);
    assert_false(controls_are_held(place.controls)); /* a key that is turned */
    control(&place, SOURCE_HID, 1, BUTTON(1), 1);
    assert_true(controls_are_held(place.controls));
    wait_ms(&place, CONTROLS_STUCK_US / MS);
    assert_true(controls_are_held(place.controls));
    wait_ms(&place, 1);
    assert_false(controls_are_held(place.controls));
    finger(&place, EVENT_DOWN, 0, 0.5f, 0.5f);
    assert_true(controls_are_held(place.controls));
    wait_ms(&place, CONTROLS_STUCK_US / MS);
    finger(&place, EVENT_MOVE, 0, 0.501f, 0.5f); /* it lives */
    wait_ms(&place, CONTROLS_STUCK_US / MS);
    assert_true(controls_are_held(place.controls));
    wait_ms(&place, 1);
    assert_false(controls_are_held(place.controls));
    close_place(&place);
}

static void a_finger_that_is_taken_away_leaves_nothing(void **state)
{
    (void)state;
    struct place place = open_place("bindings: [{touch: tap, drop: {}}, {touch: drag, draw: {}},\n"
                                    "           {touch: press, when: long, clear: {}},\n"
                                    "           {touch: press, when: hold, dry: {}}]\n");
    finger(&place, EVENT_DOWN, 0, 0.5f, 0.5f);
    finger(&place, EVENT_CANCEL, 0, 0.5f, 0.5f);
    finger(&place, EVENT_DOWN, 0, 0.5f, 0.5f);
    finger(&place, EVENT_MOVE, 0, 0.6f, 0.5f);
    wait_ms(&place, 10);
    assert_true(take(&place) && place.action.verb == ACTION_DRAW); /* what is painted is painted */
    place.now_us += 3000 * MS;
    finger(&place, EVENT_MOVE, 0, 0.7f, 0.5f);
    finger(&place, EVENT_CANCEL, 0, 0.7f, 0.5f);
    finger(&place, EVENT_MOVE, 0, 0.8f, 0.5f); /* whoever has taken it may go on telling */
    finger(&place, EVENT_UP, 0, 0.8f, 0.5f);
    wait_ms(&place, 3000);
    assert_false(take(&place));
    assert_false(controls_are_held(place.controls));
    assert_int_equal(controls_counts(place.controls).held, 0);
    assert_int_equal(controls_counts(place.controls).fingers, 0);
    close_place(&place);
}

static void a_new_visit_begins_as_at_first(void **state)
{
    (void)state;
    struct place place =
        open_place("gpio: {encoders: [{id: w, a: A, b: B}]}\n"
                   "bindings: [{touch: press, drop: {}}, {touch: drag, draw: {}},\n"
                   "           {touch: press, when: release, clear: {}},\n"
                   "           {encoder: w, dial: {parameter: radius, from: 4, to: 24, steps: 5}},\n"
                   "           {usage: Slider, turn: {coefficient: s_max, from: 0, to: 0.6, smooth: 0}},\n"
                   "           {usage: Button 1, drop: {}}, {usage: Button 2, next_ink: {}},\n"
                   "           {usage: Button 3, switch: {}}, {usage: Button 4, when: hold, wet: {}},\n"
                   "           {usage: X, cursor: {axis: x}}]\n");
    struct controls_cursor cursor;
    struct event step = {.kind = EVENT_CONTROL, .source = SOURCE_GPIO, .device = 1, .relative = true, .value = 3};
    controls_feel(place.controls, &step);
    control(&place, SOURCE_HID, 1, BUTTON(2), 1);
    control(&place, SOURCE_HID, 1, X, 0.9f);
    control(&place, SOURCE_HID, 1, HID_USAGE(HID_PAGE_DESKTOP, 0x36), 1);
    wait_ms(&place, 10);
    assert_true(take(&place) && place.action.verb == ACTION_SET);
    controls_set_tool(place.controls, 0, TOOL_MASK);
    controls_set_ink(place.controls, 0, 2);
    controls_set_tool(place.controls, 0, TOOL_DROP);
    finger(&place, EVENT_DOWN, 0, 0.2f, 0.5f);
    assert_drop(&place, 1, 2);
    assert_near(place.action.radius, 20, 1e-4);
    finger(&place, EVENT_MOVE, 0, 0.3f, 0.5f);
    control(&place, SOURCE_HID, 1, BUTTON(3), 1);
    control(&place, SOURCE_HID, 1, BUTTON(4), 1);
    assert_wish(&place, WISH_SWITCH, CONTROLLERS + 1, true);
    controls_set_tool(place.controls, 0, TOOL_POUR);

    controls_reset(place.controls);
    assert_int_equal(controls_tool(place.controls, 0), TOOL_DROP);
    assert_int_equal(controls_ink(place.controls, 0), -1);
    assert_int_equal(controls_cursors(place.controls, place.now_us, &cursor, 1), 0);
    wait_ms(&place, 3000);
    assert_false(take(&place)); /* no stroke, no hold, no dial */
    finger(&place, EVENT_UP, 0, 0.3f, 0.5f);
    assert_false(take(&place)); /* and no release of the visit before */
    control(&place, SOURCE_HID, 1, BUTTON(3), 0);
    assert_wish(&place, WISH_SWITCH, CONTROLLERS + 1, false); /* but of a switch */
    control(&place, SOURCE_HID, 1, BUTTON(4), 0);
    assert_int_equal(controls_counts(place.controls).held, 1); /* next_ink's */
    finger(&place, EVENT_DOWN, 0, 0.2f, 0.5f);
    assert_drop(&place, 1, 2); /* after the finger that was down, and the controller */
    assert_near(place.action.radius, 8, 1e-4);
    control(&place, SOURCE_HID, 1, BUTTON(1), 1);
    assert_drop(&place, CONTROLLERS + 1, 1); /* who it was, with another ink */
    assert_near(place.action.at.x, 0.5, 1e-6);

    struct coefficients coefficients = coefficients_default();
    controls_scene(place.controls, 1, &coefficients); /* one ink */
    control(&place, SOURCE_HID, 1, BUTTON(1), 0);
    control(&place, SOURCE_HID, 1, BUTTON(1), 1);
    assert_drop(&place, CONTROLLERS + 1, 0);
    close_place(&place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_finger_belongs_to_the_seat_where_it_comes_down),
        cmocka_unit_test(a_seat_paints_in_the_ink_that_it_has_chosen),
        cmocka_unit_test(a_file_has_tools_of_its_own),
        cmocka_unit_test(fingers_of_two_seats_are_never_of_one_hand),
        cmocka_unit_test(controllers_keep_their_number),
        cmocka_unit_test(cursors_tell_whose_they_are),
        cmocka_unit_test(what_is_no_action_is_a_wish),
        cmocka_unit_test(a_switch_goes_down_and_comes_up),
        cmocka_unit_test(wishes_that_nobody_takes_are_bounded_and_switches_come_up),
        cmocka_unit_test(a_key_switch_that_is_on_from_the_start_is_known),
        cmocka_unit_test(what_has_jammed_is_nobodys_hand),
        cmocka_unit_test(a_finger_that_is_taken_away_leaves_nothing),
        cmocka_unit_test(a_new_visit_begins_as_at_first),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
