/* A dish: what visitors do to the chemistry, as they see it; and the map of feed and kill. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "dish.h"
#include "dish_map.h"
#include "figure.h"
#include "importance.h"
#include "motif.h"
#include "script_text.h"
#include "sheet.h"

enum { SIDE = 640, CELLS = SIDE * SIDE, SHOWN = 480 };

struct show {
    struct figure *figure;
    struct sheet *sheet;
    struct dish *dish;
    int64_t tick;
    float raster[2 * CELLS], rgb_light[3 * CELLS];
    uint8_t rgb[3 * SHOWN * SHOWN], under[3 * SHOWN * SHOWN];
};

static void begin(struct show *show)
{
    dish_destroy(show->dish);
    show->dish = dish_create(SIDE, SIDE);
    show->tick = 0;
    if (!show->dish) {
        figure_stop("dish", "no memory");
    }
}

static void act(struct show *show, const struct action *action)
{
    dish_act(show->dish, show->tick, action);
}

static void react(struct show *show, const char *name, double value)
{
    struct action action = action_default(ACTION_REACT);
    action.option = (int)(key_find(dish_keys, name) - dish_keys);
    action.value = (float)value;
    act(show, &action);
}

static void preset(struct show *show, const char *name, const char *gradient)
{
    int colours = 0;
    while (strcmp(gradient_names[colours], gradient) != 0) {
        colours++;
    }
    react(show, "preset", (double)(gray_scott_preset_find(name) - gray_scott_presets));
    react(show, "gradient", colours);
}

static void go(struct show *show, int ticks)
{
    for (int i = 0; i < ticks; i++) {
        if (!dish_tick(show->dish, ++show->tick)) {
            figure_stop("dish", "no memory");
        }
    }
}

static void stroke(struct show *show, enum action_verb verb, const struct point *points, int count, float radius,
                   bool erase)
{
    struct action action = action_default(verb);
    action.path = (struct action_path){points, count};
    action.radius = radius;
    action.invert = erase;
    act(show, &action);
}

static void lay(struct show *show)
{
    memcpy(show->rgb, show->under, sizeof show->rgb);
    if (!dish_type.lay(show->dish, show->tick, SHOWN, SHOWN, show->rgb)) {
        figure_stop("dish", "no memory");
    }
}

/* Share of the picture that is not as it was before something lay on it. */
static double laid(const struct show *show)
{
    int apart = 0;
    for (int i = 0; i < SHOWN * SHOWN; i++) {
        apart += abs(show->rgb[3 * i] - show->under[3 * i]) > 12;
    }
    return (double)apart / (SHOWN * SHOWN);
}

/* A line that swings from left to right. */
static void wave(struct point *points, int count, float y, float high)
{
    for (int i = 0; i < count; i++) {
        float x = (float)i / (float)(count - 1);
        points[i] = (struct point){0.08f + 0.84f * x, y + high * sinf(12 * x)};
    }
}

static void show_strokes(struct show *show)
{
    enum { POINTS = 40 };
    struct point points[POINTS];
    begin(show);
    preset(show, "worms", "reef");
    react(show, "start", DISH_START_NOTHING);
    for (int i = 0; i < 3; i++) {
        wave(points, POINTS, 0.2f + 0.3f * (float)i, 0.06f * (float)(i + 1) / 2);
        stroke(show, ACTION_DOSE, points, POINTS, 5, false);
    }
    go(show, 60);
    lay(show);
    sheet_add(show->sheet, show->rgb, "dose: three strokes, a second later");
    go(show, 340);
    lay(show);
    sheet_add(show->sheet, show->rgb, "seven seconds later");
    static const struct point CROSS[] = {{0.2f, 0.2f}, {0.8f, 0.8f}};
    stroke(show, ACTION_DOSE, CROSS, 2, 40, true);
    go(show, 30);
    lay(show);
    sheet_add(show->sheet, show->rgb, "dose, erase: a stroke across it");
    struct action dry = action_default(ACTION_DRY);
    dry.has_at = true;
    dry.at = (struct point){0.3f, 0.7f};
    dry.radius = 130;
    act(show, &dry);
    preset(show, "honeycomb", "reef");
    go(show, 250);
    lay(show);
    sheet_add(show->sheet, show->rgb, "dry: a disc is frozen; preset honeycomb around it");
}

static void show_text(struct show *show)
{
    const struct script_text text = {.words = "FROND", .width = 0.92f, .height = 0.8f, .line = 8};
    struct action action = action_default(ACTION_DOSE);
    begin(show);
    preset(show, "worms", "ember");
    if (!script_text_draw(&text, SIDE, SIDE, show->raster)) {
        figure_stop("dish", "no memory");
    }
    action.picture = (struct action_raster){show->raster, SIDE, SIDE, 1};
    act(show, &action);
    go(show, 180);
    lay(show);
    double dark = 0;
    for (int i = 0; i < CELLS; i++) {
        dark += 1 - (double)show->raster[i];
    }
    figure_check(show->figure, dark / CELLS > 0.03 && dark / CELLS < 0.4, "words cover %.0f %%", 100 * dark / CELLS);
    sheet_add(show->sheet, show->rgb, "dose: {text: FROND}, preset worms");
}

static void show_style(struct show *show)
{
    struct action action = action_default(ACTION_STYLE);
    begin(show);
    motif_draw(MOTIF_PORTRAIT, SIDE, SIDE, show->rgb_light);
    importance_grey(show->rgb_light, SIDE, SIDE, 3, -1, show->raster);
    preset(show, "fingerprint", "indigo");
    react(show, "scale", 1);
    action.picture = (struct action_raster){show->raster, SIDE, SIDE, 1};
    act(show, &action);
    go(show, 700);
    lay(show);
    sheet_add(show->sheet, show->rgb, "style: a portrait, as it comes");
    double light = 0, lights = 0, dark = 0, darks = 0;
    for (int i = 0; i < CELLS; i++) {
        double v = (double)gray_scott_v(dish_chemistry(show->dish), i / SIDE)[i % SIDE];
        light += show->raster[i] > 0.6f ? v : 0;
        lights += show->raster[i] > 0.6f;
        dark += show->raster[i] < 0.2f ? v : 0;
        darks += show->raster[i] < 0.2f;
    }
    figure_check(show->figure, light / lights < 0.6 * (dark / darks), "style: %.2f times as much v where it is light",
                 light / lights / (dark / darks));
}

static void show_guides(struct show *show)
{
    static const struct point LINES[3][3] = {{{0, 0.15f}, {0.5f, 0.4f}, {1, 0.15f}},
                                             {{0.1f, 1}, {0.3f, 0.7f}, {0.1f, 0.4f}},
                                             {{0.9f, 1}, {0.7f, 0.7f}, {0.9f, 0.4f}}};
    struct action action = action_default(ACTION_GUIDE);
    for (int i = 0; i < CELLS; i++) {
        float x = (float)(i % SIDE) / SIDE - 0.5f, y = (float)(i / SIDE) / SIDE - 0.5f;
        show->raster[i] = x - 0.7f * y; /* a spiral */
        show->raster[CELLS + i] = y + 0.7f * x;
    }
    begin(show);
    preset(show, "fingerprint", "indigo");
    action.formula = (struct action_raster){show->raster, SIDE, SIDE, 2};
    act(show, &action);
    go(show, 500);
    lay(show);
    sheet_add(show->sheet, show->rgb, "guide: two formulas, a spiral");
    begin(show);
    preset(show, "maze", "bone");
    for (int i = 0; i < 3; i++) {
        stroke(show, ACTION_GUIDE, LINES[i], 3, 110, false);
    }
    go(show, 700);
    lay(show);
    sheet_add(show->sheet, show->rgb, "guide: combed along three strokes");
}

static void show_wash(struct show *show)
{
    struct action rinse = action_default(ACTION_RINSE);
    begin(show);
    preset(show, "negatons", "reef");
    go(show, 500);
    for (int i = 0; i <= 60; i++) {
        float y = -0.1f + 0.01f * (float)i;
        const struct point front[] = {{0, y + 0.05f}, {0.5f, y}, {1, y + 0.08f}};
        rinse.path = (struct action_path){front, 3};
        rinse.reach = 0.3f;
        act(show, &rinse);
        go(show, 1);
    }
    lay(show);
    sheet_add(show->sheet, show->rgb, "rinse: a front of water on its way down");
}

static void show_clear(struct show *show)
{
    motif_draw(MOTIF_PORTRAIT, SHOWN, SHOWN, show->rgb_light);
    for (int i = 0; i < 3 * SHOWN * SHOWN; i++) {
        show->under[i] = (uint8_t)(255 * sqrtf(show->rgb_light[i] < 1 ? show->rgb_light[i] : 1));
    }
    begin(show);
    preset(show, "mitosis", "glass");
    react(show, "clear", 1);
    go(show, 350);
    lay(show);
    double share = laid(show);
    figure_check(show->figure, share > 0.1 && share < 0.8, "clear: %.0f %% of a painting are covered", 100 * share);
    sheet_add(show->sheet, show->rgb, "clear: spots of glass over a painting");
    react(show, "torus", 1);
    preset(show, "fingerprint", "ember");
    go(show, 400);
    lay(show);
    sheet_add(show->sheet, show->rgb, "torus, clear: before a painting");
    memset(show->under, 0, sizeof show->under);
}

static void show_noise(struct show *show)
{
    begin(show);
    preset(show, "maze", "ember");
    react(show, "noise_kill", 0.005);
    react(show, "noise_feed", 0.012);
    react(show, "displacement", 0.3);
    react(show, "noise_speed", 0.5);
    go(show, 500);
    lay(show);
    sheet_add(show->sheet, show->rgb, "noise on feed, kill and displacement (the article, figure 7)");
}

/* Presets as dots: on the colour of what they are. */
static void show_map(struct show *show)
{
    dish_map_fill(SHOWN, SHOWN, show->rgb);
    int right = 0, count = 0;
    for (const struct gray_scott_preset *one = gray_scott_presets; one->name; one++, count++) {
        struct point at = dish_map_at(one->feed, one->kill);
        right += dish_map_class(one->feed, one->kill) == one->is;
        for (int i = 0; i < SHOWN * SHOWN; i++) {
            float dx = (float)(i % SHOWN) - at.x * SHOWN, dy = (float)(i / SHOWN) - at.y * SHOWN, r = dx * dx + dy * dy;
            if (r < 36) {
                const uint8_t *colour = dish_map_colours[one->is];
                memcpy(&show->rgb[3 * i], r < 16 ? colour : (const uint8_t[]){255, 255, 255}, 3);
            }
        }
    }
    figure_check(show->figure, right >= count - 4, "%d of %d presets lie in their class on the map", right, count);
    sheet_add(show->sheet, show->rgb,
              "the map: kill to the right, feed up; yellow spots, red worms, blue holes, green "
              "waves; both lines of the equations");
}

void figure_dish(struct figure *figure)
{
    struct show *show = calloc(1, sizeof *show);
    if (!show) {
        figure_stop("dish", "no memory");
    }
    show->figure = figure;
    show->sheet = sheet_create(figure, "A dish: what visitors do to it", 5, 3, SHOWN);
    show_strokes(show);
    show_text(show);
    show_style(show);
    show_guides(show);
    show_wash(show);
    show_noise(show);
    show_clear(show);
    show_map(show);
    sheet_finish(show->sheet);
    dish_destroy(show->dish);
    free(show);
}
