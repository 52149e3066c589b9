/* A storm of events from all sources at once (app/controls.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "controls_case.h"
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
    struct source_error error;
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
    storm->finger[slot] = kind != EVENT_UP;
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

static void a_storm_loses_no_release_and_leaves_nothing_stuck(void **state)
{
    (void)state;
    struct place place = open_place("gpio: {buttons: [{id: a, line: A}, {id: b, line: B}]}\n"
                                    "bindings:\n"
                                    "  - {touch: press, drop: {}}\n"
                                    "  - {touch: drag, brush_solvent: {}}\n"
                                    "  - {touch: drag, brush_ink: {}}\n"
                                    "  - {touch: two-finger drag, guide: {}}\n"
                                    "  - {usage: Button 1, drop: {}}\n"
                                    "  - {usage: Button 2, when: hold, ms: 50, pour: {}}\n"
                                    "  - {usage: Dial, turn: {coefficient: s_max, from: 0, to: 1}}\n"
                                    "  - {usage: X, turn: {coefficient: beta_a, from: 0, to: 8}}\n"
                                    "  - {button: a, when: release, dry: {}}\n"
                                    "  - {button: b, when: double, clear: {}}\n");
    struct storm storm = {.touch = make_fake(&place, SOURCE_TOUCH),
                          .hid = make_fake(&place, SOURCE_HID),
                          .gpio = make_fake(&place, SOURCE_GPIO)};
    int events = 0, dried = 0;
    for (int ms = 0; ms <= STORM_MS; ms++) {
        if (ms == STORM_MS) {
            let_go(&storm);
        } else {
            blow(&storm);
        }
        if (ms % 16 == 0) { /* a tick */
            int actions = 0;
            drain(&place, storm.touch, &events);
            drain(&place, storm.hid, &events);
            drain(&place, storm.gpio, &events);
            controls_run(place.controls, place.now_us);
            struct action action;
            uint64_t time_us;
            while (controls_action(place.controls, &action, &time_us)) {
                actions++;
                dried += action.verb == ACTION_DRY;
                assert_true(action.path.count <= STROKE_POINTS);
            }
            assert_true(actions <= CONTROLS_ACTIONS);
        }
        place.now_us += MS;
    }
    struct controls_counts counts = controls_counts(place.controls);
    assert_true(events >= STORM_MS);
    assert_int_equal(storm.presses, storm.releases);
    assert_int_equal(dried, storm.releases); /* every release of that line was heard, and acted */
    assert_int_equal(counts.dropped, 0);
    assert_int_equal(counts.fingers, 0);
    controls_run(place.controls, place.now_us + 1000 * MS);
    assert_int_equal(controls_counts(place.controls).held, 0);
    assert_false(controls_are_held(place.controls));
    source_destroy(storm.touch);
    source_destroy(storm.hid);
    source_destroy(storm.gpio);
    close_place(&place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_storm_loses_no_release_and_leaves_nothing_stuck),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
