/* What fingers on the palette mean, and when it is out of the way (app/hud/hud.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>

#include "hud_case.h"
#include "near.h"

enum { S = 1000000 };

struct place {
    struct hud_case place;
    struct hud hud;
    struct hud_press press;
    bool pressed;
    uint64_t now_us;
};

static void open_place(struct place *place, int screen, int seats)
{
    hud_case_init(&place->place, &hud_screens[screen], SIDE_OF_LEFT);
    hud_case_seats(&place->place, seats, false, SIDE_OF_LEFT);
    struct hud_def def = hud_case_def(&place->place, &hud_screens[screen]);
    hud_init(&place->hud, &def);
    hud_show(&place->hud, true, 0);
    place->now_us = 10 * S;
}

static bool feel(struct place *place, enum event_kind kind, int slot, float x, float y)
{
    struct event event = {.kind = kind, .source = SOURCE_TOUCH, .slot = slot, .time_us = place->now_us};
    event.x = x / (float)place->hud.def.width;
    event.y = y / (float)place->hud.def.height;
    return hud_feel(&place->hud, &event, &place->press, &place->pressed);
}

static int find(const struct place *place, int panel, enum hud_kind kind, int value)
{
    const struct hud_panel *of = &place->hud.panels[panel];
    for (int i = 0; i < of->count; i++) {
        if (of->buttons[i].kind == kind && (value < 0 || of->buttons[i].value == value)) {
            return i;
        }
    }
    fail_msg("there is no button of kind %d and value %d", kind, value);
    return -1;
}

/* On a button, `across` times its width from its middle. */
static bool feel_button(struct place *place, enum event_kind kind, int slot, int panel, int button, float across)
{
    const struct hud_button *of = &place->hud.panels[panel].buttons[button];
    return feel(place, kind, slot, of->x + (0.5f + across) * of->width, of->y + 0.5f * of->height);
}

static bool press(struct place *place, int panel, enum hud_kind kind, int value)
{
    int button = find(place, panel, kind, value);
    struct hud_button of = place->hud.panels[panel].buttons[button];
    assert_true(feel_button(place, EVENT_DOWN, 0, panel, button, 0));
    assert_true(feel(place, EVENT_UP, 0, of.x + 0.5f * of.width, of.y + 0.5f * of.height));
    return place->pressed;
}

static void a_press_is_down_and_up_on_one_button(void **state)
{
    (void)state;
    struct place place;
    open_place(&place, 3, 1);
    int brush = find(&place, 0, HUD_TOOL, TOOL_BRUSH);
    assert_true(feel_button(&place, EVENT_DOWN, 4, 0, brush, 0));
    assert_true(!place.pressed && hud_pressed(&place.hud, 0, brush));
    assert_true(feel_button(&place, EVENT_MOVE, 4, 0, brush, 0.3f));
    place.now_us += 5;
    assert_true(feel_button(&place, EVENT_UP, 4, 0, brush, 0.3f));
    assert_true(place.pressed && place.press.kind == HUD_TOOL && place.press.value == TOOL_BRUSH);
    assert_true(place.press.seat == 0 && place.press.time_us == place.now_us);
    assert_int_equal(place.hud.panels[0].tool, TOOL_BRUSH);
    assert_false(hud_pressed(&place.hud, 0, brush));
    assert_false(feel_button(&place, EVENT_UP, 4, 0, brush, 0)); /* it is gone */
    assert_true(press(&place, 0, HUD_INK, 2));
    assert_true(place.press.kind == HUD_INK && place.press.value == 2 && place.hud.panels[0].ink == 2);
    assert_true(press(&place, 0, HUD_FINISH, 0) && place.press.kind == HUD_FINISH);
}

static void a_finger_that_slides_off_presses_nothing(void **state)
{
    (void)state;
    struct place place;
    open_place(&place, 3, 1);
    int brush = find(&place, 0, HUD_TOOL, TOOL_BRUSH);
    assert_true(feel_button(&place, EVENT_DOWN, 0, 0, brush, 0));
    assert_true(feel(&place, EVENT_MOVE, 0, 1500, 500)); /* far out on the sheet, and still the palette's */
    assert_false(hud_pressed(&place.hud, 0, brush));
    assert_true(feel(&place, EVENT_UP, 0, 1500, 500));
    assert_false(place.pressed);
    assert_true(feel_button(&place, EVENT_DOWN, 0, 0, brush, 0)); /* onto the next button: neither of them */
    assert_true(feel_button(&place, EVENT_UP, 0, 0, brush + 1, 0) && !place.pressed);
    assert_true(feel_button(&place, EVENT_DOWN, 0, 0, brush, 0)); /* away and back */
    assert_true(feel(&place, EVENT_MOVE, 0, 1500, 500));
    assert_true(feel_button(&place, EVENT_MOVE, 0, 0, brush, 0));
    assert_true(feel_button(&place, EVENT_UP, 0, 0, brush, 0) && place.pressed);
    assert_false(feel(&place, EVENT_DOWN, 0, 1500, 500)); /* from the sheet onto a button: a stroke */
    assert_false(feel_button(&place, EVENT_MOVE, 0, 0, brush, 0));
    assert_false(feel_button(&place, EVENT_UP, 0, 0, brush, 0) || place.pressed);
    const struct hud_panel *panel = &place.hud.panels[0]; /* between the buttons: swallowed, and nothing */
    assert_true(feel(&place, EVENT_DOWN, 0, panel->x + 2, panel->y + 2));
    assert_true(feel_button(&place, EVENT_UP, 0, 0, 0, 0) && !place.pressed);
}

static void a_finger_that_was_none_presses_nothing(void **state)
{
    (void)state;
    struct place place;
    open_place(&place, 3, 1);
    assert_true(feel_button(&place, EVENT_DOWN, 0, 0, 1, 0));
    assert_true(feel_button(&place, EVENT_CANCEL, 0, 0, 1, 0) && !place.pressed);
    assert_false(feel_button(&place, EVENT_UP, 0, 0, 1, 0) || place.pressed);
    struct event control = {.kind = EVENT_CONTROL, .source = SOURCE_TOUCH};
    assert_false(hud_feel(&place.hud, &control, &place.press, &place.pressed) || place.pressed);
}

static void many_fingers_press_each_their_own(void **state)
{
    (void)state;
    struct place place;
    open_place(&place, 3, 1);
    int count = place.hud.panels[0].count;
    place.hud.panels[0].can_undo = true;
    for (int i = 0; i < 6; i++) {
        assert_true(feel_button(&place, EVENT_DOWN, i, 0, i, 0));
    }
    assert_true(
        feel_button(&place, EVENT_DOWN, 6, 0, 3, 0.2f)); /* a second one on the same button counts for nothing */
    assert_true(feel_button(&place, EVENT_UP, 6, 0, 3, 0.2f) && !place.pressed);
    for (int i = 5; i >= 0; i--) {
        struct hud_button button = place.hud.panels[0].buttons[i];
        assert_true(feel_button(&place, EVENT_UP, i, 0, i, 0) && place.pressed);
        assert_true(place.press.kind == button.kind && place.press.value == button.value);
    }
    /* More of them than are told apart: none is taken by halves. */
    for (int i = 0; i < HUD_FINGERS + 10; i++) {
        assert_true(feel_button(&place, EVENT_DOWN, i, 0, i % count, 0) == (i < HUD_FINGERS));
    }
    for (int i = 0; i < HUD_FINGERS + 10; i++) {
        assert_true(feel_button(&place, EVENT_CANCEL, i, 0, i % count, 0) == (i < HUD_FINGERS));
    }
    /* The same slot of another source is another finger. */
    assert_true(feel_button(&place, EVENT_DOWN, 0, 0, 0, 0));
    struct event mouse = {.kind = EVENT_UP, .source = SOURCE_WINDOW, .time_us = place.now_us};
    assert_false(hud_feel(&place.hud, &mouse, &place.press, &place.pressed));
    assert_true(feel_button(&place, EVENT_UP, 0, 0, 0, 0) && place.pressed);
}

static void seats_choose_for_themselves(void **state)
{
    (void)state;
    struct place place;
    open_place(&place, 4, 2);
    assert_true(feel_button(&place, EVENT_DOWN, 0, 0, find(&place, 0, HUD_INK, 1), 0));
    assert_true(feel_button(&place, EVENT_DOWN, 1, 1, find(&place, 1, HUD_INK, 3), 0));
    assert_true(feel_button(&place, EVENT_UP, 1, 1, find(&place, 1, HUD_INK, 3), 0));
    assert_true(place.pressed && place.press.seat == 1 && place.press.value == 3);
    assert_true(feel_button(&place, EVENT_UP, 0, 0, find(&place, 0, HUD_INK, 1), 0));
    assert_true(place.pressed && place.press.seat == 0 && place.press.value == 1);
    assert_true(place.hud.panels[0].ink == 1 && place.hud.panels[1].ink == 3);
    assert_true(press(&place, 1, HUD_HAND, 0) && place.press.value == 1);
    assert_true(place.hud.panels[1].side == SIDE_OF_RIGHT && place.hud.panels[0].side == SIDE_OF_LEFT);
    assert_true(press(&place, 1, HUD_HAND, 0) && place.press.value == 0);
    assert_true(place.hud.panels[1].side == SIDE_OF_LEFT);
    assert_int_equal(hud_seat(&place.hud, 0.2f, 0.5f), 0);
    assert_int_equal(hud_seat(&place.hud, 0.7f, 0.5f), 1);
    place.place.exhibit.seats[1].zone[0] = 0.8f; /* between the zones: the nearest */
    assert_int_equal(hud_seat(&place.hud, 0.6f, 0.5f), 0);
    assert_int_equal(hud_seat(&place.hud, 0.7f, 0.5f), 1);
}

static void what_cannot_be_undone_is_not_told(void **state)
{
    (void)state;
    struct place place;
    open_place(&place, 3, 1);
    assert_false(hud_enabled(&place.hud, 0, find(&place, 0, HUD_UNDO, 0)));
    assert_false(press(&place, 0, HUD_UNDO, 0) || press(&place, 0, HUD_REDO, 0));
    place.hud.panels[0].can_undo = place.hud.panels[0].can_redo = true;
    assert_true(press(&place, 0, HUD_UNDO, 0) && place.press.kind == HUD_UNDO);
    assert_true(press(&place, 0, HUD_REDO, 0) && place.press.kind == HUD_REDO);
}

static void groups_open_and_close(void **state)
{
    (void)state;
    struct place place;
    open_place(&place, 0, 1); /* 7 inches: everything is folded */
    const struct hud_panel *panel = &place.hud.panels[0];
    int whole = panel->count;
    assert_false(press(&place, 0, HUD_TOOL, TOOL_DROP));
    assert_true(panel->open == HUD_TOOL && panel->count == TOOL_PLANT);
    assert_true(press(&place, 0, HUD_TOOL, TOOL_POUR) && place.press.value == TOOL_POUR);
    assert_true(panel->open == -1 && panel->count == whole && panel->tool == TOOL_POUR);
    assert_false(press(&place, 0, HUD_TOOL, TOOL_POUR)); /* it is the one in view now; the sheet closes it */
    assert_int_equal(panel->open, HUD_TOOL);
    assert_false(feel(&place, EVENT_DOWN, 0, 600, 240));
    assert_int_equal(panel->open, -1);
    assert_false(press(&place, 0, HUD_MORE, 0));
    assert_int_equal(panel->open, HUD_MORE);
    assert_false(press(&place, 0, HUD_MORE, 0));
    assert_int_equal(panel->open, -1);
    assert_false(press(&place, 0, HUD_MORE, 0));
    assert_true(press(&place, 0, HUD_LANGUAGE, 1) && place.press.value == 1 && place.hud.language == 1);
    assert_true(panel->open == -1 && hud_next_language(&place.hud) == 2);
    assert_false(press(&place, 0, HUD_MORE, 0));
    assert_true(press(&place, 0, HUD_SEATED, 0) && place.press.value == 1 && place.hud.seated);
    hud_choose(&place.hud, 0, TOOL_MASK, 3); /* by other means: what is folded shows it */
    assert_true(panel->ink == 3 && panel->tool == TOOL_MASK);
    assert_int_equal(panel->buttons[find(&place, 0, HUD_TOOL, -1)].value, TOOL_MASK);
    assert_int_equal(panel->buttons[find(&place, 0, HUD_INK, -1)].value, 3);
    hud_choose(&place.hud, 0, -1, 99);
    assert_true(panel->ink == 0 && panel->tool == TOOL_MASK);
    /* A finger that rests on a button while another opens a group presses nothing of that group. */
    open_place(&place, 0, 1);
    assert_true(feel_button(&place, EVENT_DOWN, 5, 0, find(&place, 0, HUD_FINISH, 0), 0));
    assert_false(press(&place, 0, HUD_TOOL, TOOL_DROP));
    assert_true(feel_button(&place, EVENT_UP, 5, 0, 4, 0) && !place.pressed);
    assert_int_equal(panel->open, HUD_TOOL);
    hud_reset(&place.hud);
    assert_int_equal(panel->open, -1);
}

static void a_new_visit_finds_it_as_at_first(void **state)
{
    (void)state;
    struct place place;
    open_place(&place, 3, 1);
    press(&place, 0, HUD_INK, 2);
    press(&place, 0, HUD_TOOL, TOOL_MASK);
    press(&place, 0, HUD_LANGUAGE, 1);
    press(&place, 0, HUD_HAND, 0);
    press(&place, 0, HUD_SEATED, 0);
    place.hud.panels[0].can_undo = true;
    assert_true(feel_button(&place, EVENT_DOWN, 7, 0, 0, 0));
    hud_reset(&place.hud);
    const struct hud_panel *panel = &place.hud.panels[0];
    assert_true(panel->ink == 0 && panel->tool == TOOL_DROP && panel->side == SIDE_OF_LEFT && !panel->can_undo);
    assert_true(place.hud.language == 0 && !place.hud.seated && panel->scanned == -1);
    assert_true(feel_button(&place, EVENT_UP, 7, 0, 0, 0) && !place.pressed);
}

static void it_is_out_of_the_way_while_hands_are_busy(void **state)
{
    (void)state;
    struct place place;
    open_place(&place, 4, 2);
    struct hud *hud = &place.hud;
    uint64_t t = place.now_us;
    assert_near(hud_opacity(hud, 0, t), 1, 1e-6);
    assert_int_equal(hud_timeout_ms(hud, t), -1);
    assert_true(hud_busy(hud, 0, true, t));
    assert_near(hud_opacity(hud, 0, t + 3 * S / 2), 1, 1e-6);
    assert_int_equal(hud_timeout_ms(hud, t), 1500);
    assert_near(hud_opacity(hud, 0, t + 7 * S / 4), 0.5, 1e-3);
    assert_int_equal(hud_timeout_ms(hud, t + 7 * S / 4), 0);
    assert_near(hud_opacity(hud, 0, t + 2 * S), 0, 1e-6);
    assert_int_equal(hud_timeout_ms(hud, t + 2 * S), -1);
    assert_near(hud_opacity(hud, 1, t + 2 * S), 1, 1e-6); /* the neighbour's stays */
    assert_false(hud_busy(hud, 0, true, t + 3 * S));
    place.now_us = t + 3 * S; /* what is not to be seen takes no finger */
    assert_false(feel_button(&place, EVENT_DOWN, 0, 0, 0, 0));
    hud_busy(hud, 0, false, t + 3 * S);
    assert_near(hud_opacity(hud, 0, t + 3 * S + S / 2), 0, 1e-6);
    assert_near(hud_opacity(hud, 0, t + 5 * S), 1, 1e-6);
    place.now_us = t + 5 * S;
    assert_true(feel_button(&place, EVENT_DOWN, 0, 0, 0, 0));
    hud_show(hud, false, t + 6 * S);
    assert_near(hud_opacity(hud, 0, t + 6 * S + S / 4), 0.5, 1e-3);
    assert_near(hud_opacity(hud, 1, t + 7 * S), 0, 1e-6);
}

static void it_is_solid_while_it_is_used(void **state)
{
    (void)state;
    struct place place;
    open_place(&place, 4, 2);
    struct hud *hud = &place.hud;
    uint64_t t = place.now_us;
    place.place.exhibit.palette.opacity = 0.4f;
    assert_near(hud_opacity(hud, 0, t), 0.4, 1e-6);
    assert_int_equal(hud_timeout_ms(hud, t), -1);
    assert_true(feel_button(&place, EVENT_DOWN, 0, 0, 0, 0));
    assert_true(feel_button(&place, EVENT_DOWN, 1, 0, 1, 0));
    assert_int_equal(hud_timeout_ms(hud, t), 0);
    assert_near(hud_opacity(hud, 0, t + S / 4), 0.7, 1e-3);
    place.now_us = t + S / 4;
    assert_true(feel_button(&place, EVENT_UP, 0, 0, 0, 0)); /* one of two: it is still held */
    assert_near(hud_opacity(hud, 0, t + 9 * S), 1, 1e-6);
    assert_near(hud_opacity(hud, 1, t + S), 0.4, 1e-6);
    place.now_us = t + 9 * S;
    assert_true(feel_button(&place, EVENT_CANCEL, 1, 0, 1, 0));
    assert_int_equal(hud_timeout_ms(hud, t + 9 * S), 4000);
    assert_near(hud_opacity(hud, 0, t + 13 * S), 1, 1e-6);
    assert_int_equal(hud_timeout_ms(hud, t + 13 * S), 0);
    assert_near(hud_opacity(hud, 0, t + 13 * S + S / 4), 0.7, 1e-3);
    assert_near(hud_opacity(hud, 0, t + 14 * S), 0.4, 1e-6);
    assert_int_equal(hud_timeout_ms(hud, t + 14 * S), -1);
    hud_show(hud, false, t + 20 * S); /* when it appears it is solid, too */
    hud_show(hud, true, t + 22 * S);
    assert_near(hud_opacity(hud, 1, t + 23 * S), 1, 1e-6);
    assert_near(hud_opacity(hud, 1, t + 27 * S), 0.4, 1e-6);
}

/* WCAG 2.3.1: a flash is a pair of opposing changes of a tenth or more; three a second at most. Hands that come and go
 * at any rate, on the sheet and on the palette, and an exhibit that says hide at once. */
static void it_never_flashes(void **state)
{
    (void)state;
    for (int period = 20; period < 4000; period += 20 + period / 10) { /* ms */
        struct place place;
        open_place(&place, 3, 1);
        uint64_t begin = place.now_us;
        place.place.exhibit.visit.hide = 0;
        place.place.exhibit.palette.opacity = 0.3f;
        float extreme = 1, last = 1;
        int turns[40] = {0}, sign = -1;
        for (int ms = 0; ms < 40000; ms += 10) {
            uint64_t now = begin + (uint64_t)ms * 1000;
            place.now_us = now;
            hud_busy(&place.hud, 0, ms / period % 2 == 0, now);
            feel_button(&place, ms / period % 3 == 0 ? EVENT_DOWN : EVENT_UP, 0, 0, 0, 0);
            last = hud_opacity(&place.hud, 0, now);
            if ((float)sign * (last - extreme) > 0) {
                extreme = last;
            } else if (fabsf(last - extreme) >= 0.1f) {
                turns[ms / 1000]++;
                sign = -sign;
                extreme = last;
            }
        }
        for (int i = 0; i < 40; i++) {
            assert_in_range(turns[i], 0, 2); /* one flash a second at most */
        }
    }
}

static void the_staffs_view_takes_every_finger(void **state)
{
    (void)state;
    struct place place;
    open_place(&place, 3, 1);
    place.hud.status = true;
    const struct hud_button exit = place.hud.staff[1];
    assert_true(feel(&place, EVENT_DOWN, 0, exit.x + 5, exit.y + 5));
    assert_true(hud_pressed(&place.hud, -1, 1));
    assert_true(feel(&place, EVENT_UP, 0, exit.x + 5, exit.y + 5) && place.pressed && place.press.kind == HUD_EXIT);
    assert_true(feel_button(&place, EVENT_DOWN, 0, 0, 0, 0)); /* the palette is not there */
    assert_true(feel_button(&place, EVENT_UP, 0, 0, 0, 0) && !place.pressed);
    assert_true(feel(&place, EVENT_DOWN, 0, 900, 300));
    assert_true(feel(&place, EVENT_UP, 0, 900, 300) && !place.pressed);
    assert_true(hud_press(&place.hud, -1, 0, 7, &place.press) && place.press.kind == HUD_BACK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_press_is_down_and_up_on_one_button),
        cmocka_unit_test(a_finger_that_slides_off_presses_nothing),
        cmocka_unit_test(a_finger_that_was_none_presses_nothing),
        cmocka_unit_test(many_fingers_press_each_their_own),
        cmocka_unit_test(seats_choose_for_themselves),
        cmocka_unit_test(what_cannot_be_undone_is_not_told),
        cmocka_unit_test(groups_open_and_close),
        cmocka_unit_test(a_new_visit_finds_it_as_at_first),
        cmocka_unit_test(it_is_out_of_the_way_while_hands_are_busy),
        cmocka_unit_test(it_is_solid_while_it_is_used),
        cmocka_unit_test(it_never_flashes),
        cmocka_unit_test(the_staffs_view_takes_every_finger),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
