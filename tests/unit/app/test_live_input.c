/* From the events of a device to frames that hold what they caused, through a studio that really paints
 * (app/live_input.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <GLES3/gl31.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench.h"
#include "hud.h"
#include "kiosk_case.h"
#include "live_input.h"
#include "patience.h"
#include "source_fake.h"

enum { FRAMES = 90, PATIENCE_FRAMES = 2000 * SLOWER, REFRESH_MHZ = 60000 };

static const char SCRIPT[] = "frond: 1\n"
                             "canvas: {width: 96, height: 96}\n"
                             "ticks: 100000\n"
                             "inks: [cyan, magenta]\n";

struct place {
    struct display *display;
    struct script *script;
    struct studio *studio;
    struct source *fake; /* the input's */
    struct live_input input;
};

static struct place open_place(struct kiosk *kiosk, const struct live_clock *clock)
{
    struct place place = {.display = NULL};
    struct display_def display_def = display_default_def();
    struct script_def script_def = script_default_def();
    struct studio_def studio_def = studio_default_def();
    struct device_error device_error;
    struct studio_error studio_error;
    struct report report;
    display_def.kind = DISPLAY_HEADLESS;
    display_def.width = display_def.height = 64;
    display_def.refresh_mhz = REFRESH_MHZ;
    place.display = display_create(&display_def, &device_error);
    report_init(&report, "session");
    place.script = script_parse(SCRIPT, strlen(SCRIPT), ".", &script_def, &report);
    report_finish(&report);
    assert_true(place.display && place.script);
    studio_def.script = place.script;
    studio_def.threads = 1;
    place.studio = studio_create(&studio_def, place.display, &studio_error);
    assert_non_null(place.studio);
    assert_true(live_input_open(&place.input, place.script, place.display,
                                &(struct live_input_def){.kiosk = kiosk, .clock = *clock}));
    place.fake = source_fake_create(&(struct source_fake_def){.source = SOURCE_TOUCH}, &device_error);
    assert_true(place.fake && sources_add(place.input.sources, place.fake));
    return place;
}

static void close_place(struct place *place)
{
    studio_destroy(place->studio);
    live_input_close(&place->input);
    script_destroy(place->script);
    display_destroy(place->display);
}

/* One turn of the loop; true when a frame was presented. */
static bool turn(struct place *place)
{
    bool fresh;
    display_wait(place->display, live_input_wait_ms(&place->input, 5));
    live_input_feel(&place->input, place->display, place->studio);
    if (!display_begin(place->display)) {
        return false;
    }
    const struct fields *fields = studio_newest(place->studio, &fresh);
    if (!fields || !fresh) {
        nanosleep(&(struct timespec){0, 2000000}, NULL);
        return false;
    }
    glClear(GL_COLOR_BUFFER_BIT);
    live_input_draws(&place->input, place->display, fields->number);
    display_end(place->display);
    return true;
}

static void touch_at(struct place *place, enum event_kind kind, float x, float y)
{
    struct event event = {.kind = kind, .slot = 0, .x = x, .y = y};
    source_fake_post(place->fake, 0, &event);
}

static void touch(struct place *place, enum event_kind kind, float x)
{
    touch_at(place, kind, x, 0.5f);
}

static bool all_seen(const struct live_input *input)
{
    return input->latency.flip.count == (int64_t)controls_counts(input->controls).actions;
}

static void what_a_finger_does_is_followed_to_the_frame_that_shows_it(void **state)
{
    (void)state;
    struct place place = open_place(NULL, &(struct live_clock){.context = NULL});
    char text[200], line[200];
    int frames = 0;
    double began_s = bench_wall_s();
    for (int i = 0; frames < FRAMES && i < PATIENCE_FRAMES; i++) {
        if (turn(&place)) {
            frames++;
            touch(&place,
                  frames % 10 == 1   ? EVENT_DOWN
                  : frames % 10 == 0 ? EVENT_UP
                                     : EVENT_MOVE,
                  0.1f + 0.08f * (float)(frames % 10));
        }
    }
    for (int i = 0; !all_seen(&place.input) && i < PATIENCE_FRAMES; i++) {
        turn(&place);
    }
    struct latency_figures tick = latency_figures(&place.input.latency.tick);
    struct latency_figures flip = latency_figures(&place.input.latency.flip);
    struct controls_counts counts = controls_counts(place.input.controls);
    print_message("%s\n", latency_text(&place.input.latency, text, sizeof text));
    assert_int_equal(frames, FRAMES);
    assert_true(counts.actions >= 100); /* 9 drops; a stroke of solvent and one of ink a move */
    assert_int_equal(tick.count, counts.actions);
    assert_int_equal(flip.count, counts.actions); /* none is lost on the way */
    assert_true(tick.p50 > 0 && flip.p50 > tick.p50 && flip.max >= tick.max);
    assert_true(flip.max <= 1e3 * (bench_wall_s() - began_s)); /* the target is measured elsewhere */
    assert_true(counts.dropped == 0 && place.input.refused == 0);
    while (live_input_log(&place.input, line, sizeof line)) {
        print_message("%s\n", line);
    }
    live_input_unseen(&place.input);
    close_place(&place);
}

/* The hall's kiosk counts from a second on. */
static uint64_t hall_us(void *context, uint64_t real_us)
{
    return ((struct hall *)context)->now_us + real_us % 1000;
}

/* What a kiosk makes of events is tested elsewhere (test_kiosk.c): here, that it hears them, takes
 * what is its own, and posts the rest. */
static void a_kiosk_hears_events_and_gets_the_actions(void **state)
{
    (void)state;
    struct hall *hall = hall_open("exhibit: 1\n"
                                  "inputs: {bindings: [{touch: press, drop: {}}]}\n");
    struct place place = open_place(hall->kiosk, &(struct live_clock){.kiosk_us = hall_us, .context = hall});
    assert_string_equal(kiosk_state(hall->kiosk), "attract");
    kiosk_controls(hall->kiosk, place.input.controls);
    touch(&place, EVENT_DOWN, 0.5f);
    live_input_feel(&place.input, place.display, place.studio);
    assert_string_equal(kiosk_state(hall->kiosk), "painting");
    assert_int_equal(kiosk_visits(hall->kiosk), 1);
    assert_int_equal(hall_painted(hall, 0, ACTION_DROP), 1);
    touch(&place, EVENT_UP, 0.5f);
    live_input_feel(&place.input, place.display, place.studio);
    hall_wait(hall, 3); /* the palette is there again */
    kiosk_controls(hall->kiosk, place.input.controls);
    struct point button;
    assert_true(hall_find(hall, 0, HUD_TOOL, TOOL_BRUSH, &button));
    touch_at(&place, EVENT_DOWN, button.x, button.y);
    touch_at(&place, EVENT_UP, button.x, button.y);
    live_input_feel(&place.input, place.display, place.studio);
    assert_int_equal(controls_tool(place.input.controls, 0), TOOL_BRUSH);
    assert_int_equal(hall_painted(hall, 0, ACTION_DROP), 1); /* what is on the palette is for the kiosk alone */
    kiosk_controls(hall->kiosk, hall->controls);
    close_place(&place);
    hall_close(hall);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_a_finger_does_is_followed_to_the_frame_that_shows_it),
        cmocka_unit_test(a_kiosk_hears_events_and_gets_the_actions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
