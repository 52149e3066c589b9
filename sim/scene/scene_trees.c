#include "scene_trees.h"

#include <stdlib.h>

#include "along.h"
#include "garden.h"
#include "importance.h"
#include "lattice.h"
#include "rounded.h"

struct trees {
    struct garden *garden;
    struct plate plate; /* of the last picture's size */
    bool painted;       /* it is as the garden is now */
};

static void destroy(void *scene)
{
    struct trees *trees = scene;
    if (trees) {
        garden_destroy(trees->garden);
        plate_finish(&trees->plate);
        free(trees);
    }
}

static void *create(int width, int height)
{
    struct garden_def def = garden_default_def();
    struct trees *trees = calloc(1, sizeof *trees);
    def.width = width;
    def.height = height;
    if (trees) {
        trees->garden = garden_create(&def);
    }
    if (trees && !trees->garden) {
        destroy(trees);
        trees = NULL;
    }
    return trees;
}

struct garden *trees_garden(void *scene)
{
    struct trees *trees = scene;
    return trees->garden;
}

static void resize(void *scene, int width, int height)
{
    struct trees *trees = scene;
    garden_resize(trees->garden, width, height);
}

static void act(void *scene, int64_t tick, const struct action *action)
{
    struct trees *trees = scene;
    garden_act(trees->garden, tick, action);
}

static bool tick(void *scene, int64_t now)
{
    struct trees *trees = scene;
    (void)now;
    if (!garden_due(trees->garden)) {
        return true;
    }
    trees->painted = false;
    return garden_grow(trees->garden);
}

static uint64_t can_undo(const void *scene)
{
    const struct trees *trees = scene;
    return garden_can_undo(trees->garden);
}

static uint64_t can_redo(const void *scene)
{
    const struct trees *trees = scene;
    return garden_can_redo(trees->garden);
}

static bool paint(struct trees *trees, int width, int height)
{
    struct plate *plate = &trees->plate;
    if (plate->width != width || plate->height != height) {
        plate_finish(plate);
        trees->painted = false;
        if (!plate_init(plate, width, height)) {
            return false;
        }
    }
    trees->painted = trees->painted || garden_paint(trees->garden, plate);
    return trees->painted;
}

static bool lay(void *scene, int64_t now, int width, int height, uint8_t *rgb)
{
    struct trees *trees = scene;
    bool good = paint(trees, width, height);
    if (good) {
        plate_reveal(&trees->plate, now, rgb);
    }
    return good;
}

/* As the plate has it, whole, as if all had come. */
static bool field_dark(struct trees *trees, int width, int height, float *values)
{
    bool good = paint(trees, width, height);
    for (int i = 0; i < width * height && good; i++) {
        values[i] = 1 - rounded((float)trees->plate.rgba[4 * i + 3] / 255);
    }
    return good;
}

/* By births: a stroke comes from its root to its tip. */
static bool field_along(struct trees *trees, int width, int height, float *values)
{
    return paint(trees, width, height) && along_of_births(trees->plate.birth, width, height, values);
}

/* The importance of the picture, where there is one. */
static void field_around(const struct trees *trees, int width, int height, float *values)
{
    struct garden_plan plan;
    bool has = garden_get_plan(trees->garden, &plan);
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            int node_x = has ? (int)((int64_t)x * plan.lattice->width / width) : 0;
            int node_y = has ? (int)((int64_t)y * plan.lattice->height / height) : 0;
            float value = has ? importance_at(plan.importance, (float)node_x, (float)node_y) : 0;
            values[y * width + x] = rounded(value);
        }
    }
}

static bool field(void *scene, enum scene_field which, int width, int height, float *values)
{
    struct trees *trees = scene;
    switch (which) {
    case FIELD_DARK:
        return field_dark(trees, width, height, values);
    case FIELD_ALONG:
        return field_along(trees, width, height, values);
    default:
        field_around(trees, width, height, values);
        return true;
    }
}

static uint64_t hash(const void *scene)
{
    const struct trees *trees = scene;
    return garden_hash(trees->garden);
}

static void initial_options(void *options)
{
    *(struct growth_def *)options = growth_preset(METAPHOR_INK, false);
}

static void take_option(void *options, int key, float value)
{
    growth_take(options, key, value);
}

static const char *const BRINGS[] = {"metaphor", "tree", NULL};

const struct scene_type trees_type = {
    .shows = SHOW_PLATE,
    .options = growth_keys,
    .brings = BRINGS,
    .sets = ACTION_SHAPE,
    .begins = ACTION_PLANT,
    .initial = initial_options,
    .take = take_option,
    .create = create,
    .destroy = destroy,
    .resize = resize,
    .act = act,
    .tick = tick,
    .can_undo = can_undo,
    .can_redo = can_redo,
    .lay = lay,
    .field = field,
    .hash = hash,
};
