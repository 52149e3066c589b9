/* A whole visit as it is seen, painted by the engine of the CPU, with all that lies over the painting: nothing of it
 * flashes (WCAG 2.3.1), and it is never suddenly light or dark. The same visit through the fade of the live picture is
 * gentler still. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "easel.h"
#include "engine.h"
#include "flash.h"
#include "kiosk_case.h"
#include "kiosk_state.h"
#include "script_sheet.h"

enum { WIDTH = 480, HEIGHT = 300, CELLS = 2, EVERY = 2 /* ticks a frame: thirty a second */, SHOT_TICKS = 120 };

static const double MEAN_CHANGE =
    0.45; /* of relative luminance in a second: a full sheet that gives way to a bare one */

static const char EXHIBIT[] = "exhibit: 1\n"
                              "display: {width: 530}\n"
                              "languages: [en, ar]\n"
                              "inputs:\n"
                              "  visitors: each\n"
                              "  bindings: [{touch: press, drop: {}}, {touch: drag, brush_ink: {}}]\n"
                              "visit: {idle: 6, countdown: 5, thanks: 2, wash: 4, attract: 30}\n";

struct film {
    struct hall *hall;
    struct easel easel;
    struct engine *engine;
    struct easel_picture picture;
    struct painting_def painting;
    struct flash *flash;
    uint8_t rgb[WIDTH * HEIGHT * 3];
    int ticks;
    const char *shots; /* FROND_FILM: folder for some of its frames, as PPM; NULL: none */
    double darkest;    /* mean of a frame, 0..1 of 255 */
};

static bool act(void *context, const struct action *action)
{
    struct film *film = context;
    film->engine->ops->act(film->engine, action);
    return true;
}

/* One piece over the frame, as the overlay lays it (shaders/show/overlay.h); scaled ones by their nearest pixel. */
static void lay(struct film *film, const struct kiosk_piece *piece)
{
    const struct hud_image *image = piece->image;
    int width = piece->width > 0 ? (int)piece->width : image->width;
    int height = piece->height > 0 ? (int)piece->height : image->height;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            int to_x = (int)piece->x + x, to_y = (int)piece->y + y;
            if (to_x < 0 || to_x >= WIDTH || to_y < 0 || to_y >= HEIGHT) {
                continue;
            }
            size_t from =
                (size_t)(y * image->height / height) * (size_t)image->width + (size_t)(x * image->width / width);
            uint8_t *pixel = film->rgb + 3 * ((size_t)to_y * WIDTH + (size_t)to_x);
            float keep = 1 - piece->opacity * (float)image->rgba[4 * from + 3] / 255;
            for (size_t c = 0; c < 3; c++) {
                pixel[c] = (uint8_t)lroundf(keep * (float)pixel[c] + piece->opacity * (float)image->rgba[4 * from + c]);
            }
        }
    }
}

static void take_frame(struct film *film)
{
    double sum = 0;
    const struct easel_scene scene = {.engine = film->engine};
    struct file_error error;
    assert_true(easel_draw(&film->picture, &scene, &error));
    memcpy(film->rgb, film->picture.rgb, sizeof film->rgb);
    const struct kiosk_pieces *pieces = kiosk_look(film->hall->kiosk, film->hall->now_us);
    for (int i = 0; i < KIOSK_PIECES; i++) {
        if (pieces->piece[i].opacity > 0 && pieces->piece[i].image->rgba) {
            lay(film, &pieces->piece[i]);
        }
    }
    for (size_t i = 0; i < sizeof film->rgb; i++) {
        sum += film->rgb[i];
    }
    if (film->shots && film->ticks % SHOT_TICKS == 0) {
        char path[300];
        snprintf(path, sizeof path, "%s/visit-%05d.ppm", film->shots, film->ticks);
        FILE *file = fopen(path, "wb");
        assert_non_null(file);
        fprintf(file, "P6 %d %d 255\n", WIDTH, HEIGHT);
        assert_int_equal(fwrite(film->rgb, 1, sizeof film->rgb, file), sizeof film->rgb);
        assert_int_equal(fclose(file), 0);
    }
    film->darkest = fmin(film->darkest, sum / (255.0 * sizeof film->rgb));
    flash_frame(film->flash, film->rgb, film->hall->now_us);
}

static void tick(void *context, bool fresh)
{
    struct film *film = context;
    struct file_error error;
    if (fresh) {
        engine_destroy(film->engine);
        film->painting.seed++;
        film->engine = easel_engine(&film->easel, &film->painting, &error);
        assert_non_null(film->engine);
        return;
    }
    film->engine->ops->tick(film->engine);
    if (++film->ticks % EVERY == 0) {
        take_frame(film);
    }
}

static struct film *begin(void)
{
    struct film *film = calloc(1, sizeof *film);
    struct file_error error;
    assert_non_null(film);
    film->hall = hall_open_sized(EXHIBIT, WIDTH, HEIGHT);
    struct script *script = kiosk_scene(film->hall->kiosk)->script;
    script->width = WIDTH / CELLS;
    script->height = HEIGHT / CELLS;
    film->painting = script_painting(script);
    film->easel.def = (struct easel_def){.engine = ENGINE_CPU, .threads = 1};
    film->engine = easel_engine(&film->easel, &film->painting, &error);
    struct picture_def picture = script_picture(script, WIDTH, HEIGHT);
    assert_true(film->engine && easel_frame(&film->easel, &film->picture, &picture, script->ink_count));
    film->flash = flash_begin(WIDTH, HEIGHT);
    film->darkest = 1;
    film->shots = getenv("FROND_FILM");
    film->hall->act = act;
    film->hall->tick = tick;
    film->hall->context = film;
    return film;
}

static void end(struct film *film)
{
    flash_end(film->flash);
    easel_unframe(&film->picture);
    engine_destroy(film->engine);
    easel_close(&film->easel);
    hall_close(film->hall);
    free(film);
}

static void a_visit_never_flashes(void **state)
{
    (void)state;
    struct film *film = begin();
    struct hall *hall = film->hall;
    hall_wait(hall, 15);
    for (int i = 0; i < 8; i++) { /* quick and everywhere, as children do */
        hall_tap(hall, 0.25f + 0.08f * (float)i, 0.25f + 0.5f * (float)(i % 2), 0.1);
        hall_drag(hall, 0.3f, 0.8f - 0.08f * (float)i, 0.7f, 0.2f + 0.08f * (float)i, 0.5);
    }
    hall_wait(hall, 8);
    assert_string_equal(kiosk_state(hall->kiosk), "countdown");
    hall_wait(hall, 20);
    assert_string_equal(kiosk_state(hall->kiosk), "attract");
    struct flash_worst worst = flash_worst(film->flash);
    print_message("%d frames: flashes %d, red %d, mean luminance changes by at most %.2f a second, darkest %.2f\n",
                  worst.frames, worst.general, worst.red, worst.mean_change, film->darkest);
    assert_true(worst.frames > 1200);
    assert_true(worst.general <= FLASH_MOST);
    assert_true(worst.red <= FLASH_MOST);
    assert_true(worst.mean_change < MEAN_CHANGE);
    assert_true(film->darkest < 0.93); /* there was something to see */
    end(film);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_visit_never_flashes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
