/* A scene that has no drawer of its own, on a display: as its `lay` has it. */
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
#include "dish.h"
#include "live_scene_draw.h"
#include "patience.h"

enum { WIDTH = 160, HEIGHT = 100, BYTES = WIDTH * HEIGHT * 3, TICKS = 60 };

static const uint8_t GROUND[3] = {204, 153, 102};

struct place {
    struct display *display;
    struct scene_type type;
    const struct scene_type *types[SCENE_KINDS];
    struct live_scene *scene;
    struct live_scene_draw draw;
    struct script script; /* only its size is read */
    int64_t ticked;
    uint8_t shown[BYTES], wanted[BYTES];
};

static void nap(void)
{
    nanosleep(&(struct timespec){0, 2000000}, NULL);
}

/* The left half is a dish through which half of what is below is seen, the right half is nothing. */
static bool lay_half(void *scene, int64_t now, int width, int height, uint8_t *rgb)
{
    uint8_t *dish = calloc((size_t)width * (size_t)height, 3);
    bool good = dish && dish_type.lay(scene, now, width, height, dish);
    for (int i = 0; i < 3 * width * height && good; i++) {
        if (i / 3 % width < width / 2) {
            rgb[i] = (uint8_t)((rgb[i] + dish[i]) / 2);
        }
    }
    free(dish);
    return good;
}

/* A dish that says nothing but what it looks like. */
static struct place *open_place(void)
{
    struct place *place = calloc(1, sizeof *place);
    struct display_def def = display_default_def();
    struct device_error error;
    assert_non_null(place);
    def.kind = DISPLAY_HEADLESS;
    def.width = WIDTH;
    def.height = HEIGHT;
    place->display = display_create(&def, &error);
    assert_non_null(place->display);
    place->type = dish_type;
    place->type.shows = SHOW_PICTURE;
    place->type.is_calm = NULL;
    place->type.lay = lay_half;
    place->types[SCENE_CHEMISTRY] = &place->type;
    place->script = (struct script){.width = WIDTH, .height = HEIGHT};
    place->scene = live_scene_create(place->types);
    assert_non_null(place->scene);
    live_scene_scene(place->scene, &place->script, SCENE_CHEMISTRY, "dish");
    live_scene_draw_init(&place->draw, place->scene, NULL);
    return place;
}

static void close_place(struct place *place)
{
    assert_true(display_enter(place->display));
    live_scene_draw_finish(&place->draw);
    live_scene_destroy(place->scene);
    display_destroy(place->display);
    free(place);
}

static void tell(struct place *place, enum studio_event_kind kind, const struct action *action)
{
    struct studio_event event = {.kind = kind,
                                 .ticked = place->ticked,
                                 .script = &place->script,
                                 .def = {.width = WIDTH, .height = HEIGHT},
                                 .action = action};
    live_scene_tell(place->scene, &event);
}

static void tick(struct place *place, int count)
{
    double end_s = bench_wall_s() + PATIENCE_S;
    for (int i = 0; i < count; i++) {
        place->ticked++;
        tell(place, STUDIO_TICKED, NULL);
    }
    while (!live_scene_is_calm(place->scene)) {
        assert_true(bench_wall_s() < end_s);
        nap();
    }
}

/* Another frame over the ground; what it shows is `shown`. */
static void draw(struct place *place)
{
    struct shader_error error;
    double end_s = bench_wall_s() + PATIENCE_S;
    while (!display_begin(place->display)) {
        assert_true(bench_wall_s() < end_s);
        display_wait(place->display, 20);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, display_framebuffer(place->display));
    glClearColor((float)GROUND[0] / 255, (float)GROUND[1] / 255, (float)GROUND[2] / 255, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    assert_true(live_scene_draw(&place->draw, place->display, &error));
    display_end(place->display);
    assert_true(display_capture(place->display, place->shown));
}

static void draw_until_it_stands(struct place *place)
{
    double end_s = bench_wall_s() + PATIENCE_S;
    do {
        assert_true(bench_wall_s() < end_s);
        draw(place);
    } while (live_scene_draw_moves(&place->draw));
}

static void fill(uint8_t *rgb)
{
    for (int i = 0; i < BYTES; i++) {
        rgb[i] = GROUND[i % 3];
    }
}

static int most_apart(const uint8_t *a, const uint8_t *b)
{
    int most = 0;
    for (int i = 0; i < BYTES; i++) {
        int apart = abs(a[i] - b[i]);
        most = apart > most ? apart : most;
    }
    return most;
}

/* What a scene with the same actions lays over the ground. */
static void lay_wanted(struct place *place, const struct action *dose)
{
    void *dish = dish_type.create(WIDTH, HEIGHT);
    assert_non_null(dish);
    dish_type.act(dish, 0, dose);
    for (int i = 0; i < TICKS; i++) {
        assert_true(dish_type.tick(dish, i));
    }
    fill(place->wanted);
    assert_true(lay_half(dish, TICKS - 1, WIDTH, HEIGHT, place->wanted));
    dish_type.destroy(dish);
}

static void it_is_what_it_lays(void **state)
{
    (void)state;
    struct place *place = open_place();
    struct action dose = action_default(ACTION_DOSE);
    dose.at = (struct point){0.3f, 0.4f};
    dose.has_at = true;
    dose.radius = 20;
    tell(place, STUDIO_SHEET, NULL);
    tell(place, STUDIO_ACTION, &dose);
    tick(place, TICKS);
    draw_until_it_stands(place);
    lay_wanted(place, &dose);
    assert_in_range(most_apart(place->shown, place->wanted), 0, 3);
    uint8_t *ground = malloc(BYTES);
    assert_non_null(ground);
    fill(ground);
    assert_true(most_apart(place->shown, ground) > 60);
    live_scene_draw_reveal(&place->draw, ground, WIDTH, HEIGHT); /* for the gallery */
    assert_in_range(most_apart(place->shown, ground), 0, 3);

    tell(place, STUDIO_SHEET, NULL); /* a fresh sheet: it fades */
    tick(place, 1);
    draw(place);
    assert_true(live_scene_draw_moves(&place->draw));
    assert_in_range(most_apart(place->shown, place->wanted), 0, 20);
    draw_until_it_stands(place);
    fill(ground);
    assert_in_range(most_apart(place->shown, ground), 0, 1);
    free(ground);
    close_place(place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(it_is_what_it_lays)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
