#include "growth.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"

static const float TREE_TAPER = 0.14f; /* pixels for each pixel */

enum {
    BRUSH_MARGIN = 24, /* pixels around a change from which endpoints keep others apart */
    TRUNK_SMOOTH = 24, /* more passes over the trunk and primary branches of a tree */
};

struct lattice_def growth_lattice_def(const struct growth_def *def)
{
    struct lattice_def lattice = lattice_default_def();
    lattice.base = def->base;
    lattice.picture = def->picture;
    lattice.random = def->random;
    lattice.seed = (uint32_t)def->seed;
    for (int d = 0; d < LATTICE_NEIGHBOURS; d++) {
        float lean = lattice_steps[d][1] < 0 ? def->upward : lattice_steps[d][1] == 0 ? def->sideways : 1;
        lattice.lean[d] = (int)(lean * LATTICE_LEAN + 0.5f);
    }
    return lattice;
}

/* Where it grows from when nobody says: frost from the edges of the window, lightning from above, cracks from a blow.
 */
static int32_t own_plants(const struct growth_def *def, struct point plants[GROWTH_PLANTS_MAX])
{
    if (def->metaphor == METAPHOR_FROST) {
        enum { EACH = 6 };
        for (int i = 0; i < EACH; i++) {
            float at = ((float)i + 0.5f) / EACH;
            plants[4 * i] = (struct point){at, 0};
            plants[4 * i + 1] = (struct point){1 - at, 1};
            plants[4 * i + 2] = (struct point){0, 1 - at};
            plants[4 * i + 3] = (struct point){1, at};
        }
        return 4 * EACH;
    }
    plants[0] = def->metaphor == METAPHOR_LIGHTNING ? (struct point){0.5f, 0.02f}
                : def->metaphor == METAPHOR_CRACKS  ? (struct point){0.58f, 0.40f}
                                                    : (struct point){0.5f, 0.98f};
    return 1;
}

static bool plant(struct growth *growth)
{
    struct point own[GROWTH_PLANTS_MAX];
    const struct point *plants = growth->def.plants.points;
    int32_t count = growth->def.plants.count;
    if (count == 0 || !plants) {
        count = own_plants(&growth->def, own);
        plants = own;
    }
    growth->seeds = malloc((size_t)count * sizeof *growth->seeds);
    for (int32_t i = 0; i < count && growth->seeds; i++) {
        int x = (int)(plants[i].x * (float)growth->importance->width);
        int y = (int)(plants[i].y * (float)growth->importance->height);
        x = x < growth->importance->width ? x : growth->importance->width - 1;
        y = y < growth->importance->height ? y : growth->importance->height - 1;
        growth->seeds[i] = lattice_node(growth->lattice, x, y);
    }
    growth->seed_count = count;
    return growth->seeds;
}

struct thickness growth_thickness(const struct growth_def *def)
{
    return (struct thickness){.tip = def->tip,
                              .gain = def->gain,
                              .power = def->power,
                              .window = def->window,
                              .branch = def->branch,
                              .mix = def->mix};
}

bool growth_finish_layer(const struct growth *growth, struct dendrite *dendrite)
{
    const struct growth_def *def = &growth->def;
    if (!dendrite_arrange(dendrite)) {
        return false;
    }
    struct thickness thickness = growth_thickness(def);
    if (def->tree) {
        thickness.step = def->step;
        thickness.trunk = def->trunk;
        thickness.taper = TREE_TAPER;
    }
    dendrite_smooth(dendrite, def->smooth, def->jitter, (uint32_t)def->seed, def->tree ? TRUNK_SMOOTH : 0);
    dendrite_thicken(dendrite, growth->importance, &thickness);
    return true;
}

/* The structure from routes and endpoints. */
static bool build(struct growth *growth)
{
    dendrite_cut(growth->layers[0], 0);
    return dendrite_extend(growth->layers[0], growth->routes, growth->endpoints, growth->endpoint_count, 0, 0) &&
           growth_finish_layer(growth, growth->layers[0]);
}

static bool keep_endpoints(struct growth *growth, const int32_t *endpoints, int32_t count)
{
    int32_t *kept = realloc(growth->endpoints, ((size_t)count + 1) * sizeof *kept);
    if (!kept) {
        return false;
    }
    memcpy(kept, endpoints, (size_t)count * sizeof *kept);
    growth->endpoints = kept;
    growth->endpoint_count = count;
    return true;
}

static bool grow_dendrite(struct growth *growth)
{
    const struct growth_def *def = &growth->def;
    growth->stipple = stipple_create(growth->lattice);
    growth->layers[0] = dendrite_create(growth->lattice);
    growth->layer_count = 1;
    if (!growth->stipple || !growth->layers[0]) {
        return false;
    }
    stipple_weigh(growth->stipple, growth->importance, NULL);
    int32_t count = stipple_search(growth->stipple, growth->seeds, growth->seed_count, def->endpoints);
    return count >= 0 && keep_endpoints(growth, stipple_nodes(growth->stipple), count) &&
           routes_plan(growth->routes, (enum metric)def->metric, def->emphasis, growth->seeds, growth->seed_count) &&
           build(growth);
}

struct growth *growth_create(const float *grey, int width, int height, const struct growth_def *def)
{
    struct growth *growth = calloc(1, sizeof *growth);
    if (!growth) {
        return NULL;
    }
    growth->def = *def;
    memcpy(growth->def.plant, def->plants.points ? def->plants.points : def->plant,
           def->plants.points ? (size_t)def->plants.count * sizeof *def->plant : sizeof def->plant);
    growth->def.plants.points = def->plants.points ? growth->def.plant : NULL;
    struct importance_def weights = {def->gradient, def->intensity, def->blur, def->light};
    if (weights.gradient + weights.intensity <= 0) {
        weights.intensity = 1;
    }
    struct lattice_def lattice = growth_lattice_def(def);
    growth->importance = importance_create(grey, width, height, &weights);
    if (growth->importance) {
        growth->lattice = lattice_create(growth->importance, &lattice, NULL, NULL);
    }
    if (growth->lattice) {
        growth->routes = routes_create(growth->lattice);
    }
    if (!growth->importance || !growth->lattice || !growth->routes || !plant(growth) ||
        !(def->tree ? growth_tree(growth) : grow_dendrite(growth))) {
        growth_destroy(growth);
        return NULL;
    }
    return growth;
}

void growth_destroy(struct growth *growth)
{
    if (growth) {
        for (int i = 0; i < GROWTH_LAYERS_MAX; i++) {
            dendrite_destroy(growth->layers[i]);
        }
        stipple_destroy(growth->stipple);
        routes_destroy(growth->routes);
        lattice_destroy(growth->lattice);
        importance_destroy(growth->importance);
        free(growth->seeds);
        free(growth->endpoints);
        free(growth);
    }
}

static bool is_within(const struct lattice *lattice, struct rectangle rectangle, int32_t node)
{
    int x = lattice_x(lattice, node), y = lattice_y(lattice, node);
    return x >= rectangle.x0 && x < rectangle.x1 && y >= rectangle.y0 && y < rectangle.y1;
}

bool growth_place_again(struct growth *growth, struct rectangle touched)
{
    struct rectangle around = {touched.x0 - BRUSH_MARGIN, touched.x1 + BRUSH_MARGIN, touched.y0 - BRUSH_MARGIN,
                               touched.y1 + BRUSH_MARGIN};
    int32_t kept = 0, near = 0;
    size_t area = (size_t)(touched.x1 - touched.x0) * (size_t)(touched.y1 - touched.y0);
    size_t room = (size_t)growth->endpoint_count + (size_t)growth->seed_count + area + 1;
    int32_t *all = malloc(room * sizeof *all), *seeds = malloc(room * sizeof *seeds);
    bool good = all && seeds;
    for (int32_t i = 0; i < growth->endpoint_count && good; i++) {
        int32_t node = growth->endpoints[i];
        if (!is_within(growth->lattice, touched, node)) {
            all[kept++] = node;
            if (is_within(growth->lattice, around, node)) {
                seeds[near++] = node;
            }
        }
    }
    for (int32_t i = 0; i < growth->seed_count && good; i++) {
        if (is_within(growth->lattice, around, growth->seeds[i])) {
            seeds[near++] = growth->seeds[i];
        }
    }
    if (good && near == 0) {
        seeds[near++] = lattice_node(growth->lattice, (touched.x0 + touched.x1) / 2, (touched.y0 + touched.y1) / 2);
    }
    if (good) {
        int32_t found = stipple_run(growth->stipple, seeds, near, stipple_threshold(growth->stipple), &around);
        for (int32_t i = 0; i < found; i++) {
            if (is_within(growth->lattice, touched, stipple_nodes(growth->stipple)[i])) {
                all[kept++] = stipple_nodes(growth->stipple)[i];
            }
        }
        good = found >= 0 && keep_endpoints(growth, all, kept);
    }
    free(all);
    free(seeds);
    return good;
}

bool growth_brush(struct growth *growth, float x, float y, float radius, float amount)
{
    if (growth->def.tree) {
        return false;
    }
    struct lattice_def lattice = growth_lattice_def(&growth->def);
    struct rectangle touched = importance_brush(growth->importance, x, y, radius, amount);
    if (rectangle_is_empty(touched)) {
        return true;
    }
    lattice_weigh(growth->lattice, growth->importance, &lattice, touched);
    stipple_weigh(growth->stipple, growth->importance, &touched);
    return growth_place_again(growth, touched) && routes_replan(growth->routes, touched) && build(growth);
}

bool growth_strokes(const struct growth *growth, struct strokes *strokes)
{
    const struct growth_def *def = &growth->def;
    uint32_t seed = (uint32_t)def->seed;
    bool good = true;
    for (int i = 0; i < growth->layer_count && good; i++) {
        const struct dendrite *layer = growth->layers[i];
        good = strokes_branches(strokes, layer, i) &&
               (def->needles <= 0 || strokes_needles(strokes, layer, i, def->needles, seed)) &&
               (def->tendrils <= 0 || strokes_tendrils(strokes, layer, i, def->tendrils, seed)) &&
               (def->leaves <= 0 || strokes_leaves(strokes, layer, i, def->leaves, 2.1f * def->leaves, seed));
    }
    return good;
}
