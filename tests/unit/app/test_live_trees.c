/* A kiosk with a scene of trees, from a finger on the glass to what is seen, through a kill and a lost GPU. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench.h"
#include "display_source.h"
#include "folder_case.h"
#include "live_loop.h"
#include "patience.h"
#include "pictures.h"
#include "source_fake.h"

enum { WIDTH = 320, HEIGHT = 200, SEEDS = 2, DARK = 90, SOME = 150 /* pixels */ };

static const char EXHIBIT[] = "exhibit: 1\n"
                              "display: {width: 530}\n"
                              "sheet: {cells: 16384}\n"
                              "engine: cpu\n"
                              "scenes:\n"
                              "  - {id: garden, kind: trees, trees: {over: leaf.png, endpoints: 300}}\n"
                              "visit: {idle: 600}\n";

struct place {
    char folder[FOLDER_CASE_PATH], file[100], state[100];
    struct display *display;
    struct live_def def;
    struct live live;
    struct source *fake;
};

static bool put(const char *path, const void *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    bool good = file && fwrite(bytes, 1, size, file) == size;
    return file && fclose(file) == 0 && good;
}

static void make_folder(struct place *place)
{
    char bytes[8192], path[200];
    assert_true(folder_case_make(place->folder));
    snprintf(place->file, sizeof place->file, "%s/trees.yaml", place->folder);
    snprintf(place->state, sizeof place->state, "%s/state", place->folder);
    snprintf(path, sizeof path, "%s/leaf.png", place->folder);
    FILE *file = fopen(IMAGE_SAMPLES "/rgb.png", "rb");
    assert_non_null(file);
    size_t size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    assert_true(put(path, bytes, size) && put(place->file, EXHIBIT, sizeof EXHIBIT - 1));
    assert_int_equal(mkdir(place->state, 0777), 0);
}

static bool open_place(struct place *place)
{
    struct display_def display_def = display_default_def();
    struct device_error error = {""};
    struct script_def def = script_default_def();
    struct device_error device_error;
    struct report report;
    def.load = pictures_load;
    display_def.kind = DISPLAY_HEADLESS;
    display_def.width = WIDTH;
    display_def.height = HEIGHT;
    display_def.refresh_mhz = 60000;
    place->display = display_create(&display_def, &error);
    report_init(&report, place->file);
    struct exhibit *exhibit = exhibit_read(place->file, &def, &report);
    report_print(&report, stdout);
    report_finish(&report);
    if (!place->display || !exhibit) {
        return false;
    }
    live_kiosk_fit(exhibit, WIDTH, HEIGHT);
    place->def = live_default_def();
    place->def.engine = ENGINE_CPU;
    place->def.exhibit = exhibit;
    place->def.state = place->state;
    bool good = live_open(&place->live, exhibit->scenes[0].script, place->display, &place->def);
    place->fake = source_fake_create(&(struct source_fake_def){.source = SOURCE_TOUCH}, &device_error);
    return good && place->fake && sources_add(place->live.input.sources, place->fake);
}

static void close_place(struct place *place)
{
    live_close(&place->live);
    display_destroy(place->display);
}

static struct live_scene_sheet sheet_of(const struct place *place)
{
    return live_scene_sheet(place->live.scene, bench_wall_s());
}

/* Turns of the loop for some seconds. */
static bool go_on(struct place *place, double seconds)
{
    double end_s = bench_wall_s() + seconds;
    bool good = true;
    do {
        good = live_turn(&place->live);
    } while (good && bench_wall_s() < end_s);
    return good;
}

/* Until all that was done is planned, and its plate is shown. */
static bool settle(struct place *place)
{
    double end_s = bench_wall_s() + PATIENCE_S;
    bool calm = false;
    while (!calm && bench_wall_s() < end_s && live_turn(&place->live)) {
        const struct live_plate *plate = &place->live.scene_draw.plate;
        calm = live_scene_is_calm(place->live.scene) && plate->shown && !live_scene_draw_moves(&place->live.scene_draw);
    }
    return calm;
}

/* Until what has been done is on the disk. */
static bool until_kept(struct place *place)
{
    int64_t ticked = (int64_t)sheet_of(place).tick;
    double end_s = bench_wall_s() + PATIENCE_S;
    bool good = true;
    while (good && keep_report(place->live.painting.keep).kept_ticked < ticked) {
        good = bench_wall_s() < end_s && live_turn(&place->live);
    }
    return good;
}

/* A tap, and until something has come of it. */
static bool touch(struct place *place, float x, float y)
{
    int plans = sheet_of(place).plans;
    double end_s = bench_wall_s() + PATIENCE_S;
    bool good = true;
    source_fake_post(place->fake, 0, &(struct event){.kind = EVENT_DOWN, .x = x, .y = y});
    source_fake_post(place->fake, 0, &(struct event){.kind = EVENT_UP, .x = x, .y = y});
    while (good && sheet_of(place).plans == plans) {
        good = bench_wall_s() < end_s && live_turn(&place->live);
    }
    return good;
}

static uint64_t mark_of(const struct place *place)
{
    const struct plate *plate = &place->live.scene_draw.plate.newest->plate;
    uint64_t mark = 14695981039346656037u; /* FNV-1a */
    for (size_t i = 0; i < (size_t)plate->width * (size_t)plate->height * 4; i++) {
        mark = (mark ^ plate->rgba[i]) * 1099511628211u;
    }
    return mark;
}

/* Paints until it is killed; says what is to be seen. */
static void paint(struct place *place, int to)
{
    bool good = open_place(place) && go_on(place, 0.5);
    for (int i = 0; good && i < SEEDS; i++) {
        good = touch(place, 0.35f + 0.3f * (float)i, 0.45f);
    }
    uint64_t mark = good && settle(place) && until_kept(place) ? mark_of(place) : 0;
    if (write(to, &mark, sizeof mark) == (ssize_t)sizeof mark) {
        go_on(place, PATIENCE_S);
    }
    _exit(1);
}

static uint64_t painted_and_killed(struct place *place)
{
    int ends[2], status;
    uint64_t mark = 0;
    assert_int_equal(pipe(ends), 0);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        paint(place, ends[1]);
    }
    close(ends[1]);
    ssize_t got = read(ends[0], &mark, sizeof mark);
    close(ends[0]);
    kill(child, SIGKILL);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(got, (ssize_t)sizeof mark);
    assert_true(WIFSIGNALED(status) && mark != 0);
    return mark;
}

static int dark_of(const uint8_t *rgb)
{
    int dark = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        dark += rgb[3 * i] < DARK && rgb[3 * i + 1] < DARK && rgb[3 * i + 2] < DARK;
    }
    return dark;
}

static int dark_on_the_display(const struct place *place)
{
    static uint8_t rgb[WIDTH * HEIGHT * 3];
    assert_true(display_capture(place->display, rgb));
    return dark_of(rgb);
}

/* What goes to the gallery. */
static void the_plate_is_in_the_picture(struct place *place)
{
    int width, height;
    uint8_t *rgb = live_picture_capture(&place->live.picture, &width, &height);
    assert_non_null(rgb);
    assert_true(width == WIDTH && height == HEIGHT);
    int before = dark_of(rgb);
    live_scene_draw_reveal(&place->live.scene_draw, rgb, width, height);
    assert_true(dark_of(rgb) > before + SOME);
    free(rgb);
}

static void the_gpu_is_lost(struct place *place)
{
    uint64_t mark = mark_of(place), resets = place->live.service.status.gpu_resets;
    int before = dark_on_the_display(place);
    place->display->lost = true;
    assert_true(go_on(place, 0.1) && settle(place) && go_on(place, 0.5));
    int after = dark_on_the_display(place);
    assert_int_equal(place->live.service.status.gpu_resets, resets + 1);
    assert_true(mark_of(place) == mark);
    assert_in_range(after, before - before / 5, before + before / 5);
}

static void a_visit_that_is_killed_goes_on(void **state)
{
    (void)state;
    struct place place = {.folder = ""};
    make_folder(&place);
    uint64_t mark = painted_and_killed(&place);
    assert_true(open_place(&place));
    assert_string_equal(kiosk_state(place.live.kiosk.kiosk), "painting");
    assert_true(settle(&place));
    struct live_scene_sheet sheet = sheet_of(&place);
    assert_true(sheet.kind == SCENE_TREES && sheet.can_undo != 0);
    assert_true(mark_of(&place) == mark);
    assert_true(dark_on_the_display(&place) > SOME);
    the_plate_is_in_the_picture(&place);
    the_gpu_is_lost(&place);
    close_place(&place);
    assert_true(folder_case_remove(place.folder));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_visit_that_is_killed_goes_on)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
