/* A storm of events from all sources at once (app/controls.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "controls_case.h"
#include "gesture.h"
#include "hid_usage.h"
#include "source_fake.h"
#include "stroke.h"

#define X    HID_USAGE(HID_PAGE_DESKTOP, 0x30)
#define DIAL HID_USAGE(HID_PAGE_DESKTOP, 0x37)

/* A storm: three sources, a thousand events a second between them, for a minute. */

enum { STORM_MS = 60000, FINGERS = 10, BUTTONS = 8 };

static uint64_t storm_clock(void *user)
{
    return ((const struct place *)user)->now_us;
}

static struct source *make_fake(struct place *place, enum event_source kind)
{
    struct device_error error;
    struct source *source =
        source_fake_create(&(struct source_fake_def){.source = kind, .clock = storm_clock, .user = place}, &error);
    assert_non_null(source);
    return source;
}

struct storm {
    struct source *touch, *hid, *gpio;
    bool finger[FINGERS], button[BUTTONS], line[2];
    int presses, releases; /* of line 0 */
    uint32_t seed;
};

static uint32_t roll(struct storm *storm, uint32_t sides)
{
    storm->seed = storm->seed * 1664525u + 1013904223u;
    return (storm->seed >> 8) % sides;
}

static void post_finger(struct storm *storm, int slot, enum event_kind kind)
{
    struct event event = {.kind = kind, .slot = slot};
    event.x = (float)roll(storm, 1000) / 1000;
    event.y = (float)roll(storm, 1000) / 1000;
    storm->finger[slot] = kind == EVENT_DOWN || kind == EVENT_MOVE;
    source_fake_post(storm->touch, 0, &event);
}

static void post_control(struct source *source, uint32_t number, float value, bool relative)
{
    struct event event = {.kind = EVENT_CONTROL, .control = number, .value = value, .relative = relative};
    source_fake_post(source, 0, &event);
}

static void post_line(struct storm *storm, uint32_t line, bool down)
{
    storm->presses += line == 0 && down;
    storm->releases += line == 0 && !down;
    storm->line[line] = down;
    post_control(storm->gpio, line, down ? 1 : 0, false);
}

static void blow(struct storm *storm)
{
    int slot = (int)roll(storm, FINGERS), button = (int)roll(storm, BUTTONS);
    uint32_t line = roll(storm, 2);
    switch (roll(storm, 10)) {
    case 0:
        post_line(storm, line, !storm->line[line]);
        return;
    case 1:
    case 2:
        storm->button[button] = !storm->button[button];
        post_control(storm->hid, HID_USAGE(HID_PAGE_BUTTON, button + 1), storm->button[button] ? 1 : 0, false);
        return;
    case 3:
        post_control(storm->hid, DIAL, roll(storm, 2) ? 1 : -1, true);
        return;
    case 4:
        post_finger(storm, slot, storm->finger[slot] ? EVENT_UP : EVENT_DOWN);
        return;
    default:
        if (storm->finger[slot]) {
            post_finger(storm, slot, EVENT_MOVE);
        } else {
            post_control(storm->hid, X, (float)roll(storm, 100) / 100, false);
        }
        return;
    }
}

static void drain(struct place *place, struct source *source, int *events)
{
    struct event event;
    source->ops->dispatch(source);
    while (source->ops->event(source, &event)) {
        controls_feel(place->controls, &event);
        *events += 1;
    }
}

static void let_go(struct storm *storm)
{
    for (int i = 0; i < FINGERS; i++) {
        if (storm->finger[i]) {
            post_finger(storm, i, EVENT_UP);
        }
    }
    for (int i = 0; i < BUTTONS; i++) {
        post_control(storm->hid, HID_USAGE(HID_PAGE_BUTTON, i + 1), 0, false);
    }
    for (uint32_t i = 0; i < 2; i++) {
        if (storm->line[i]) {
            post_line(storm, i, false);
        }
    }
}

static const char BINDINGS[] = "gpio: {buttons: [{id: a, line: A}, {id: b, line: B}]}\n"
                               "bindings:\n"
                               "  - {touch: press, drop: {}}\n"
                               "  - {touch: drag, brush_solvent: {}}\n"
                               "  - {touch: drag, brush_ink: {}}\n"
                               "  - {touch: two-finger drag, tool: guide, guide: {}}\n"
                               "  - {touch: press, tool: pour, switch: {}}\n"
                               "  - {touch: pinch, tool: pour, undo: {}}\n"
                               "  - {usage: Button 1, drop: {}}\n"
                               "  - {usage: Button 2, when: hold, ms: 50, pour: {}}\n"
                               "  - {usage: Button 3, undo: {}}\n"
                               "  - {usage: Button 4, switch: {}}\n"
                               "  - {usage: Button 5, when: release, staff: {}}\n"
                               "  - {usage: Button 6, next_ink: {}}\n"
                               "  - {usage: Dial, turn: {coefficient: s_max, from: 0, to: 1}}\n"
                               "  - {usage: X, turn: {coefficient: beta_a, from: 0, to: 8}}\n"
                               "  - {button: a, when: release, dry: {}}\n"
                               "  - {button: a, switch: {}}\n"
                               "  - {button: b, when: double, clear: {}}\n";

static const struct exhibit_seat SEATS[] = {{{0, 0, 0.5f, 0.5f}, -1, SIDE_OF_LEFT},
                                            {{0.5f, 0, 1, 0.5f}, 1, SIDE_OF_RIGHT},
                                            {{0.2f, 0.6f, 0.9f, 1}, -1, SIDE_OF_BOTTOM}};

enum { SEAT_COUNT = 3, VISITORS = EXHIBIT_SEATS + 8 };

struct heard {
    int events, dried;
    bool hands[CONTROLS_HANDS + GESTURE_FINGERS]; /* that lie there */
    int holds;
    int switches[VISITORS], down[VISITORS]; /* told down; down now */
};

static void open_storm(struct place *place, struct storm *storm)
{
    *place = open_seats(BINDINGS, SEATS, SEAT_COUNT);
    *storm = (struct storm){.touch = make_fake(place, SOURCE_TOUCH),
                            .hid = make_fake(place, SOURCE_HID),
                            .gpio = make_fake(place, SOURCE_GPIO)};
}

static void close_storm(struct place *place, struct storm *storm)
{
    source_destroy(storm->touch);
    source_destroy(storm->hid);
    source_destroy(storm->gpio);
    close_place(place);
}

static void hear_actions(struct place *place, struct heard *heard)
{
    int actions = 0;
    while (take(place)) {
        const struct action *action = &place->action;
        int visitor = action->visitor;
        actions++;
        heard->dried += action->verb == ACTION_DRY;
        assert_true(action->path.count <= STROKE_POINTS);
        if (action->verb == ACTION_HOLD || (action->verb == ACTION_ATTRACT && action->path.count == 0)) {
            assert_in_range(visitor, 1, CONTROLS_HANDS + GESTURE_FINGERS - 1);
            heard->hands[visitor] = action->has_at;
            heard->holds++;
            continue;
        }
        if (action->verb == ACTION_SHAPE || action->verb == ACTION_CONDUCT || action->verb == ACTION_REACT) {
            continue; /* nobody's, as ACTION_SET */
        }
        assert_true(visitor >= 0 && visitor < VISITORS && action->ink >= 0 && action->ink < INKS);
        assert_true(action->verb == ACTION_SET || (visitor != 0 && (visitor <= SEAT_COUNT || visitor > EXHIBIT_SEATS)));
        bool inked = action->verb == ACTION_DROP || action->verb == ACTION_BRUSH_INK;
        assert_true(visitor != 2 || !inked || action->ink == SEATS[1].ink);
    }
    assert_true(actions <= CONTROLS_ACTIONS);
}

static void hear_wishes(struct place *place, struct heard *heard)
{
    struct wish wish;
    int wishes = 0;
    while (controls_wish(place->controls, &wish)) {
        wishes++;
        assert_true(wish.visitor > 0 && wish.visitor < VISITORS);
        if (wish.kind == WISH_SWITCH) {
            heard->switches[wish.visitor] += wish.down;
            heard->down[wish.visitor] += wish.down ? 1 : -1;
            assert_true(heard->down[wish.visitor] >= 0);
        }
    }
    assert_true(wishes <= CONTROLS_WISHES);
}

static void hear(struct place *place, const struct storm *storm, struct heard *heard)
{
    drain(place, storm->touch, &heard->events);
    drain(place, storm->hid, &heard->events);
    drain(place, storm->gpio, &heard->events);
    controls_run(place->controls, place->now_us);
    hear_actions(place, heard);
    hear_wishes(place, heard);
}

static void assert_calm(struct place *place, const struct heard *heard)
{
    struct controls_counts counts = controls_counts(place->controls);
    assert_int_equal(counts.fingers, 0);
    controls_run(place->controls, place->now_us + 1000 * MS);
    assert_int_equal(controls_counts(place->controls).held, 0);
    assert_false(controls_are_held(place->controls));
    for (int i = 0; i < VISITORS; i++) {
        assert_int_equal(heard->down[i], 0);
    }
    for (int i = 0; i < CONTROLS_HANDS + GESTURE_FINGERS; i++) {
        assert_false(heard->hands[i]); /* every hand was lifted */
    }
}

static void a_storm_loses_no_release_and_leaves_nothing_stuck(void **state)
{
    (void)state;
    struct place place;
    struct storm storm;
    struct heard heard = {.events = 0};
    open_storm(&place, &storm);
    for (int ms = 0; ms <= STORM_MS; ms++) {
        if (ms == STORM_MS) {
            let_go(&storm);
        } else {
            blow(&storm);
        }
        if (ms % 100 == 0) { /* somebody chooses */
            controls_set_tool(place.controls, (int)roll(&storm, SEAT_COUNT), (enum exhibit_tool)roll(&storm, TOOLS));
            controls_set_ink(place.controls, (int)roll(&storm, SEAT_COUNT), (int)roll(&storm, INKS + 1) - 1);
        }
        if (ms % 16 == 0) { /* a tick */
            hear(&place, &storm, &heard);
        }
        place.now_us += MS;
    }
    assert_true(heard.events >= STORM_MS);
    assert_int_equal(storm.presses, storm.releases);
    assert_int_equal(heard.dried, storm.releases); /* every release of that line was heard, and acted */
    int lines = 0;
    for (int i = EXHIBIT_SEATS + 1; i < VISITORS; i++) {
        lines += heard.switches[i] == storm.presses;
    }
    assert_int_equal(lines, 1); /* and every press and release of it as a switch */
    assert_int_equal(controls_counts(place.controls).dropped, 0);
    assert_calm(&place, &heard);
    close_storm(&place, &storm);
}

/* Devices that are pulled out in use, fingers that are taken away, visits that begin in the middle of it. */
static void in_a_storm_devices_leave_and_visits_begin(void **state)
{
    (void)state;
    struct place place;
    struct storm storm;
    struct heard heard = {.events = 0};
    open_storm(&place, &storm);
    for (int ms = 0; ms < STORM_MS; ms++) {
        blow(&storm);
        if (ms % 37 == 0) {
            post_finger(&storm, (int)roll(&storm, FINGERS), EVENT_CANCEL);
        }
        if (ms % 100 == 0) {
            controls_set_tool(place.controls, (int)roll(&storm, SEAT_COUNT), (enum exhibit_tool)roll(&storm, TOOLS));
        }
        if (ms % 700 == 0) {
            struct source *const sources[] = {storm.touch, storm.hid, storm.gpio};
            struct source *source = sources[roll(&storm, 3)];
            source_fake_post(source, 0, &(struct event){.kind = EVENT_LEFT}); /* without a release before it */
        }
        if (ms % 900 == 0) {
            controls_reset(place.controls);
        }
        if (ms % 1300 == 0) { /* from one kind of scene to another */
            struct scene_options options = scene_options_default((enum scene_kind)(ms / 1300 % SCENE_KINDS));
            controls_options(place.controls, options.kind ? &options : NULL);
        }
        if (ms % 16 == 0 || ms == STORM_MS - 1) {
            hear(&place, &storm, &heard);
        }
        place.now_us += MS;
    }
    for (int slot = 0; slot < FINGERS; slot++) {
        post_finger(&storm, slot, EVENT_UP);
    }
    let_go(&storm);
    post_line(&storm, 0, false);
    post_line(&storm, 1, false);
    hear(&place, &storm, &heard);
    assert_true(heard.holds > 50);
    assert_calm(&place, &heard);
    int switches = 0;
    for (int i = 0; i < VISITORS; i++) {
        switches += heard.switches[i];
    }
    assert_true(switches > 1000);
    close_storm(&place, &storm);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_storm_loses_no_release_and_leaves_nothing_stuck),
        cmocka_unit_test(in_a_storm_devices_leave_and_visits_begin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
