/* One scene feeds the next in a whole kiosk: a finger strikes lightning on the glass, a button asks for the next scene,
 * and what was struck is drawn in ink on the painting that the display shows then. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "folder_case.h"
#include "kiosk_state.h"
#include "live_loop.h"
#include "patience.h"
#include "source_fake.h"

enum { WIDTH = 320, HEIGHT = 200, BYTES = WIDTH * HEIGHT * 3, DARK = 120, BRIGHT = 60, LEAST = 30 };

static const char EXHIBIT[] = "exhibit: 1\n"
                              "display: {width: 530}\n"
                              "sheet: {cells: 16384}\n"
                              "engine: cpu\n"
                              "scenes:\n"
                              "  - {id: cracks, kind: lightning, lightning: {life: 0, particles: 400}}\n"
                              "  - id: glaze\n"
                              "    inks: [carbon black]\n"
                              "    inputs: [{from: cracks, as: ink, tick: 20000}]\n"
                              "inputs:\n"
                              "  gpio: {buttons: [{id: next, line: NEXT}]}\n"
                              "  bindings: [{touch: press, tool: strike, strike: {}}, {button: next, next_scene: {}}]\n"
                              "visit: {idle: 600, wash: 1, attract: 1800}\n";

struct place {
    char folder[FOLDER_CASE_PATH], file[100];
    struct display *display;
    struct live_def def;
    struct live live;
    struct source *glass, *lines;
    uint8_t struck[BYTES], shown[BYTES];
};

static struct exhibit *read_exhibit(struct place *place)
{
    struct script_def def = script_default_def();
    struct report report;
    assert_true(folder_case_make(place->folder));
    snprintf(place->file, sizeof place->file, "%s/fed.yaml", place->folder);
    FILE *file = fopen(place->file, "w");
    assert_non_null(file);
    fputs(EXHIBIT, file);
    assert_int_equal(fclose(file), 0);
    report_init(&report, place->file);
    struct exhibit *exhibit = exhibit_read(place->file, &def, &report);
    report_print(&report, stdout);
    report_finish(&report);
    assert_non_null(exhibit);
    live_kiosk_fit(exhibit, WIDTH, HEIGHT);
    return exhibit;
}

static struct source *plug_in(struct place *place, enum event_source kind, const struct device *device)
{
    struct device_error error = {""};
    struct source *fake = source_fake_create(
        &(struct source_fake_def){.source = kind, .devices = device, .device_count = device ? 1 : 0}, &error);
    assert_non_null(fake);
    assert_true(sources_add(place->live.input.sources, fake));
    return fake;
}

static struct place *open_place(void)
{
    static const struct device LINES = {.class = DEVICE_LINES, .name = "lines", .admitted = true};
    struct place *place = calloc(1, sizeof *place);
    struct display_def display = display_default_def();
    struct device_error error = {""};
    assert_non_null(place);
    display.kind = DISPLAY_HEADLESS;
    display.width = WIDTH;
    display.height = HEIGHT;
    display.refresh_mhz = 60000;
    place->display = display_create(&display, &error);
    assert_non_null(place->display);
    place->def = live_default_def();
    place->def.engine = ENGINE_CPU;
    place->def.governed = false;
    place->def.exhibit = read_exhibit(place);
    assert_true(live_open(&place->live, place->def.exhibit->scenes[0].script, place->display, &place->def));
    place->glass = plug_in(place, SOURCE_TOUCH, NULL);
    place->lines = plug_in(place, SOURCE_GPIO, &LINES);
    return place;
}

static void close_place(struct place *place)
{
    live_close(&place->live);
    display_destroy(place->display);
    assert_true(folder_case_remove(place->folder));
    free(place);
}

static void go_on(struct place *place, double seconds)
{
    double end_s = bench_wall_s() + seconds;
    do {
        assert_true(live_turn(&place->live));
    } while (bench_wall_s() < end_s);
}

static void touch(struct place *place, float x, float y)
{
    source_fake_post(place->glass, 0, &(struct event){.kind = EVENT_DOWN, .x = x, .y = y});
    go_on(place, 0.1);
    source_fake_post(place->glass, 0, &(struct event){.kind = EVENT_UP, .x = x, .y = y});
    go_on(place, 0.1);
}

static void press(struct place *place)
{
    source_fake_post(place->lines, 0, &(struct event){.kind = EVENT_CONTROL, .value = 1});
    source_fake_post(place->lines, 0, &(struct event){.kind = EVENT_CONTROL, .value = 0});
}

/* Until that scene is on the display, with its ground. */
static void until_scene(struct place *place, const char *id)
{
    double end_s = bench_wall_s() + PATIENCE_S;
    const struct kiosk *kiosk = place->live.kiosk.kiosk;
    while (strcmp(kiosk_scene(kiosk)->id, id) != 0 || !kiosk->grounded || kiosk_is_covered(kiosk)) {
        assert_true(bench_wall_s() < end_s && live_turn(&place->live));
    }
}

/* Beside the palette, which is on the left. */
static int count(const uint8_t *rgb, bool (*is)(uint8_t green), const uint8_t *among, bool (*of)(uint8_t green))
{
    int count = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        bool aside = i % WIDTH < WIDTH / 4;
        count += !aside && is(rgb[3 * i + 1]) && (!among || of(among[3 * i + 1]));
    }
    return count;
}

static bool is_bright(uint8_t green)
{
    return green > BRIGHT;
}

static bool is_dark(uint8_t green)
{
    return green < DARK;
}

/* Until the bolts stand still, and can be seen: `struck` is that. */
static void until_it_has_struck(struct place *place)
{
    double end_s = bench_wall_s() + PATIENCE_S;
    const struct live_layer *bolts = &place->live.scene_draw.bolts.layer;
    int seen = 0;
    while (!bolts->shown || !bolts->newest->calm || !live_scene_is_calm(place->live.scene) ||
           live_scene_draw_moves(&place->live.scene_draw) || seen <= LEAST) {
        assert_true(bench_wall_s() < end_s && live_turn(&place->live));
        seen = display_capture(place->display, place->struck) ? count(place->struck, is_bright, NULL, NULL) : 0;
    }
}

/* Until what was struck is ink, but for the glow round it, and little else; `shown` is that. */
static void until_it_is_ink(struct place *place)
{
    double end_s = bench_wall_s() + PATIENCE_S;
    int struck = count(place->struck, is_bright, NULL, NULL), ink = 0, both = 0;
    while (both <= 0.6 * struck || both <= 0.8 * ink) {
        if (bench_wall_s() > end_s) {
            fail_msg("%d pixels of the bolt, %d of ink, %d of both", struck, ink, both);
        }
        assert_true(live_turn(&place->live) && display_capture(place->display, place->shown));
        ink = count(place->shown, is_dark, NULL, NULL);
        both = count(place->struck, is_bright, place->shown, is_dark);
    }
}

static void what_a_finger_has_struck_is_ink(void **state)
{
    (void)state;
    struct place *place = open_place();
    go_on(place, 0.5);
    touch(place, 0.6f, 0.7f);
    assert_string_equal(kiosk_state(place->live.kiosk.kiosk), "painting");
    until_it_has_struck(place);
    press(place);
    until_scene(place, "glaze");
    assert_string_equal(kiosk_state(place->live.kiosk.kiosk), "painting");
    until_it_is_ink(place);
    close_place(place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_a_finger_has_struck_is_ink)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
