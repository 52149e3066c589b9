/* A garden as it grows: a portrait from two seeds, round a hand, after a stroke, under water, by other metaphors. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "figure.h"
#include "garden.h"
#include "motif.h"
#include "sheet.h"

enum { SIDE = 480, CELLS = 480, WIDTH = 448, HEIGHT = 512, PAPER = 245 };

struct scene {
    struct sheet *sheet;
    struct garden *garden;
    struct plate plate;
    uint8_t *rgb;
};

static void act(struct scene *scene, int64_t tick, const struct action *action)
{
    garden_act(scene->garden, tick, action);
    if (!garden_grow(scene->garden) || !garden_paint(scene->garden, &scene->plate)) {
        figure_stop("garden", "no memory");
    }
}

static void plant(struct scene *scene, int64_t tick, int visitor, float x, float y)
{
    struct action action = action_default(ACTION_PLANT);
    action.visitor = visitor;
    action.at = (struct point){x, y};
    act(scene, tick, &action);
}

static void shape(struct scene *scene, int64_t tick, const char *name, float value)
{
    struct action action = action_default(ACTION_SHAPE);
    action.option = (int)(key_find(growth_keys, name) - growth_keys);
    action.value = value;
    act(scene, tick, &action);
}

/* Shares of the sheet that are covered, within a disc. */
static double show(struct scene *scene, int64_t tick, const char *label, float x, float y, float radius)
{
    memset(scene->rgb, PAPER, 3 * SIDE * SIDE);
    plate_reveal(&scene->plate, tick, scene->rgb);
    double sum = 0, all = 0;
    for (int row = 0; row < SIDE; row++) {
        for (int column = 0; column < SIDE; column++) {
            float dx = (float)column / SIDE - x, dy = (float)row / SIDE - y;
            if (dx * dx + dy * dy < radius * radius) {
                sum += scene->rgb[3 * (row * SIDE + column) + 1] < PAPER - 60;
                all++;
            }
        }
    }
    sheet_add(scene->sheet, scene->rgb, "%s", label);
    return sum / all;
}

static void stock(struct scene *scene, enum motif motif)
{
    float *linear = malloc((size_t)3 * WIDTH * HEIGHT * sizeof *linear);
    if (!linear) {
        figure_stop("garden", "no memory");
    }
    motif_draw(motif, WIDTH, HEIGHT, linear);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        linear[i] = 0.2126f * linear[3 * i] + 0.7152f * linear[3 * i + 1] + 0.0722f * linear[3 * i + 2];
    }
    struct action action = action_default(ACTION_STOCK);
    action.picture = (struct action_raster){linear, WIDTH, HEIGHT, 1};
    act(scene, 0, &action);
    free(linear);
}

static void tend_and_rinse(struct figure *figure, struct scene *scene)
{
    static const struct point BROW[] = {{0.38f, 0.12f}, {0.62f, 0.12f}};
    struct action hold = action_default(ACTION_HOLD), tend = action_default(ACTION_TEND),
                  rinse = action_default(ACTION_RINSE);
    hold.has_at = true;
    hold.at = (struct point){0.66f, 0.62f};
    hold.radius = 50;
    double before = show(scene, 600, "600: grown from two seeds", 0.66f, 0.62f, 0.09f);
    act(scene, 600, &hold);
    double held = show(scene, 1100, "a hand lies there", 0.66f, 0.62f, 0.09f);
    figure_check(figure, before > 0.05 && held < 0.002, "under a hand %.3f of the sheet is covered, before %.3f", held,
                 before);
    hold.has_at = false;
    act(scene, 1200, &hold);
    tend.path = (struct action_path){BROW, 2};
    tend.radius = 45;
    tend.amount = 0.5f;
    before = show(scene, 1700, "the hand is lifted", 0.5f, 0.12f, 0.08f);
    act(scene, 1700, &tend);
    double after = show(scene, 2200, "the hair above is tended", 0.5f, 0.12f, 0.08f);
    figure_check(figure, after > 1.3 * before, "tended, %.3f of a place is covered, before %.3f", after, before);
    rinse.has_at = true;
    rinse.at = (struct point){0.35f, 0.75f};
    rinse.radius = 90;
    rinse.strength = 0.4f;
    for (int i = 0; i < 12; i++) {
        act(scene, 2300 + i, &rinse);
    }
    after = show(scene, 2400, "water on the left", 0.35f, 0.75f, 0.1f);
    figure_check(figure, after < 0.02, "after water %.3f of a place is covered", after);
}

void figure_garden(struct figure *figure)
{
    static const struct {
        int metaphor;
        bool tree;
        const char *label;
    } OTHERS[] = {{METAPHOR_VINE, false, "vine"},
                  {METAPHOR_LIGHTNING, false, "lightning"},
                  {METAPHOR_FROST, false, "frost"},
                  {METAPHOR_CRACKS, false, "cracks"},
                  {METAPHOR_WINTER, true, "winter, as a tree"},
                  {METAPHOR_PAINTED, true, "painted, as a tree"}};
    struct scene scene = {.sheet = sheet_create(figure, "A garden grows over a portrait", 4, 4, SIDE),
                          .rgb = malloc((size_t)3 * SIDE * SIDE)};
    struct garden_def def = garden_default_def();
    def.width = def.height = CELLS;
    scene.garden = garden_create(&def);
    if (!scene.garden || !scene.rgb || !plate_init(&scene.plate, SIDE, SIDE)) {
        figure_stop("garden", "no memory");
    }
    stock(&scene, MOTIF_PORTRAIT);
    plant(&scene, 0, 1, 0.5f, 0.97f);
    plant(&scene, 0, 2, 0.06f, 0.25f);
    double last = 0;
    static const int MOMENTS[] = {40, 90, 150, 220};
    for (int i = 0; i < 4; i++) {
        char label[40];
        snprintf(label, sizeof label, "tick %d", MOMENTS[i]);
        double covered = show(&scene, MOMENTS[i], label, 0.5f, 0.5f, 1);
        figure_check(figure, covered > last, "at tick %d it covers %.3f, before %.3f", MOMENTS[i], covered, last);
        last = covered;
    }
    tend_and_rinse(figure, &scene);
    for (size_t i = 0; i < sizeof OTHERS / sizeof *OTHERS; i++) {
        shape(&scene, 3000, "tree", OTHERS[i].tree);
        shape(&scene, 3000, "metaphor", (float)OTHERS[i].metaphor);
        show(&scene, 3600, OTHERS[i].label, 0.5f, 0.5f, 1);
    }
    sheet_finish(scene.sheet);
    garden_destroy(scene.garden);
    plate_finish(&scene.plate);
    free(scene.rgb);
}
