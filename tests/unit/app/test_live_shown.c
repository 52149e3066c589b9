/* Lightning and chemistry on a display: shown, kept, through a lost GPU, and let go. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench.h"
#include "clock_case.h"
#include "display_source.h"
#include "live_loop.h"
#include "patience.h"

enum { WIDTH = 320, HEIGHT = 200, BYTES = WIDTH * HEIGHT * 3 };

static const char LIGHTNING[] = "  - {tick: 0, conduct: {lightning: kind, value: 0}}\n"
                                "  - {tick: 0, conduct: {lightning: life, value: 0}}\n";
static const char CHEMISTRY[] = "  - {tick: 0, react: {chemistry: start, value: 1}}\n"
                                "  - {tick: 0, react: {chemistry: gradient, value: 2}}\n";
static const char TORUS[] = "  - {tick: 0, react: {chemistry: torus, value: 1}}\n";
static const char CLEAR[] = "  - {tick: 0, react: {chemistry: clear, value: 1}}\n"
                            "  - {tick: 0, react: {chemistry: gradient, value: 2}}\n"
                            "  - {tick: 0, dose: {at: [0.5, 0.5]}}\n";
static const int LONG = 100000, CLEAR_TICKS = 120; /* each tick of what is clear leaves more that differs */

static const double LONGEST_TURN_S = 0.05;

struct place {
    struct script *script;
    struct display *display;
    struct live_def def;
    struct live live;
    uint8_t shown[BYTES], other[BYTES];
};

static struct script *read_script(const char *actions, int ticks)
{
    char path[] = "/tmp/frond-shown-XXXXXX";
    struct script_def def = script_default_def();
    struct report report;
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    dprintf(fd,
            "frond: 1\ncanvas: {width: %d, height: %d, margin: 0}\nticks: %d\n"
            "inks: [phthalo turquoise]\nactions:\n%s",
            WIDTH / 2, HEIGHT / 2, ticks, actions);
    close(fd);
    report_init(&report, path);
    struct script *script = script_read(path, &def, &report);
    report_print(&report, stdout);
    report_finish(&report);
    unlink(path);
    assert_non_null(script);
    return script;
}

static struct place *open_place(const char *actions, int ticks)
{
    struct place *place = calloc(1, sizeof *place);
    struct display_def def = display_default_def();
    struct device_error error;
    assert_non_null(place);
    def.kind = DISPLAY_HEADLESS;
    def.width = WIDTH;
    def.height = HEIGHT;
    def.refresh_mhz = 60000;
    place->display = display_create(&def, &error);
    assert_non_null(place->display);
    place->script = read_script(actions, ticks);
    place->def = live_default_def();
    place->def.engine = ENGINE_CPU;
    place->def.governed = false;
    place->def.once = true;
    assert_true(live_open(&place->live, place->script, place->display, &place->def));
    return place;
}

static void close_place(struct place *place)
{
    live_close(&place->live);
    display_destroy(place->display);
    script_destroy(place->script);
    free(place);
}

/* However long it really took, it was not long: what fades is seen in steps. */
static void turn(struct place *place)
{
    assert_true(live_turn(&place->live));
    clock_case_follow(LONGEST_TURN_S);
}

static void go_on(struct place *place, double seconds)
{
    double end_s = bench_wall_s() + seconds;
    while (bench_wall_s() < end_s) {
        turn(place);
    }
}

/* Until nothing fades, and what is there has been drawn. */
static void settle(struct place *place, bool growing)
{
    double end_s = bench_wall_s() + PATIENCE_S;
    bool calm = false;
    go_on(place, 0.6);
    while (!calm) {
        assert_true(bench_wall_s() < end_s);
        turn(place);
        const struct live_scene_draw *draw = &place->live.scene_draw;
        bool still = !draw->dish.layer.drawer.type->moves(&draw->dish.layer.drawer, NULL) &&
                     !draw->bolts.layer.drawer.type->moves(&draw->bolts.layer.drawer, NULL);
        calm = still && place->live.picture.picture &&
               (growing || !draw->bolts.layer.shown || draw->bolts.layer.newest->calm) &&
               (growing || (live_scene_is_calm(place->live.scene) && !live_scene_draw_moves(draw)));
    }
}

static void act(struct place *place, enum action_verb verb, float x, float y)
{
    struct action action = action_default(verb);
    action.at = (struct point){x, y};
    action.has_at = true;
    action.visitor = 1;
    assert_true(studio_post(place->live.studio, &action));
}

static void capture(struct place *place, uint8_t *rgb)
{
    assert_true(display_capture(place->display, rgb));
}

/* Mean over all bytes. */
static double apart(const uint8_t *a, const uint8_t *b)
{
    double sum = 0;
    for (int i = 0; i < BYTES; i++) {
        sum += abs(a[i] - b[i]);
    }
    return sum / BYTES;
}

/* What the gallery is given is what the display shows, within `most` of 255 on average; `place->shown` is that. */
static void the_gallery_has_it(struct place *place, double most)
{
    int width, height;
    uint8_t *rgb = live_picture_capture(&place->live.picture, &width, &height);
    assert_true(rgb && width == WIDTH && height == HEIGHT);
    capture(place, place->shown);
    double before = apart(rgb, place->shown);
    live_scene_draw_reveal(&place->live.scene_draw, rgb, width, height);
    double after = apart(rgb, place->shown);
    if (!(before > 4 * most && after <= most)) {
        print_error("the painting %.2f apart, the picture for the gallery %.2f\n", before, after);
    }
    assert_true(before > 4 * most && after <= most);
    free(rgb);
}

static void lose_the_gpu(struct place *place, bool growing)
{
    uint64_t resets = place->live.service.status.gpu_resets;
    place->display->lost = true;
    go_on(place, 0.1);
    settle(place, growing);
    assert_int_equal(place->live.service.status.gpu_resets, resets + 1);
}

/* Another sheet: what was shown fades, and no frame differs from the one before by most of it. */
static void it_fades(struct place *place)
{
    uint8_t *last = malloc(BYTES), *first = malloc(BYTES);
    double end_s, most = 0;
    assert_true(last && first);
    capture(place, first);
    capture(place, last);
    assert_true(studio_fresh(place->live.studio));
    for (end_s = bench_wall_s() + 1.6; bench_wall_s() < end_s;) {
        uint64_t frames = display_frames(place->display).presented;
        turn(place);
        if (display_frames(place->display).presented > frames) {
            capture(place, place->other);
            double step = apart(last, place->other);
            most = step > most ? step : most;
            memcpy(last, place->other, BYTES);
        }
    }
    settle(place, false);
    capture(place, place->other);
    double all = apart(first, place->other);
    if (!(all > 1 && most < 0.75 * all)) {
        print_error("%.2f apart, %.2f at once\n", all, most);
    }
    assert_true(all > 1 && most < 0.75 * all);
    free(first);
    free(last);
}

static void lightning(void **state)
{
    (void)state;
    struct place *place = open_place(LIGHTNING, LONG);
    settle(place, false);
    act(place, ACTION_STRIKE, 0.5f, 0.9f);
    settle(place, false);
    the_gallery_has_it(place, 4);
    lose_the_gpu(place, false);
    capture(place, place->other);
    assert_true(apart(place->shown, place->other) < 0.5);
    uint64_t frames = display_frames(place->display).presented;
    go_on(place, 1); /* what stands still costs no frames, but that of a window that may be uncovered */
    assert_in_range(display_frames(place->display).presented - frames, 0, 8);
    it_fades(place);
    close_place(place);
}

static void chemistry(void **state)
{
    (void)state;
    struct place *place = open_place(CHEMISTRY, LONG);
    act(place, ACTION_DOSE, 0.5f, 0.5f);
    act(place, ACTION_DOSE, 0.2f, 0.3f);
    settle(place, true);
    the_gallery_has_it(place, 4);
    lose_the_gpu(place, true);
    the_gallery_has_it(place, 4);
    it_fades(place);
    close_place(place);
}

static void a_body_and_what_is_clear(void **state)
{
    (void)state;
    struct place *place = open_place(TORUS, LONG);
    act(place, ACTION_DOSE, 0.5f, 0.5f);
    settle(place, true);
    the_gallery_has_it(place, 6);
    close_place(place);
    place = open_place(CLEAR, CLEAR_TICKS);
    while (!studio_report(place->live.studio).ended) {
        turn(place);
    }
    settle(place, false);
    the_gallery_has_it(place, 6);
    close_place(place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lightning),
        cmocka_unit_test(chemistry),
        cmocka_unit_test(a_body_and_what_is_clear),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
