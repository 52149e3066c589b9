/* A structure grown over a picture, from its importance to lines to draw: dendritic stylization and trees.
 *
 *     struct growth_def def = growth_preset(METAPHOR_INK, false);
 *     struct growth *growth = growth_create(grey, width, height, &def);
 *     struct strokes strokes = {0};
 *     growth_strokes(growth, &strokes);
 */
#ifndef FROND_GROWTH_H
#define FROND_GROWTH_H

#include "action.h"
#include "dendrite.h"
#include "key.h"
#include "stipple.h"
#include "strokes.h"

enum metaphor {
    METAPHOR_INK,
    METAPHOR_VINE,
    METAPHOR_LIGHTNING,
    METAPHOR_WINTER,
    METAPHOR_FROST,
    METAPHOR_CRACKS,
    METAPHOR_PAINTED,
    METAPHORS
};
enum growth_side { GROWTH_SIDE_NONE, GROWTH_SIDE_LEFT, GROWTH_SIDE_RIGHT, GROWTH_SIDE_ALL };

enum { GROWTH_PLANTS_MAX = 64, GROWTH_LAYERS_MAX = 4, GROWTH_SIZE_LEAST = 16 };

extern const char *const metaphor_names[METAPHORS + 1]; /* ends with NULL */

/* The table growth_keys says units and ranges. */
struct growth_def {
    int metaphor, metric; /* enum metaphor, enum metric */
    bool tree;
    int endpoints, emphasis, seed;
    struct point plant[GROWTH_PLANTS_MAX];
    struct action_path plants; /* points into plant, or NULL: the metaphor's own */
    float gradient, intensity, blur;
    bool light;
    float base, picture, random, upward, sideways;
    int smooth;
    float jitter, tip, gain, power;
    int window;
    float branch, step, trunk, mix;
    float leaves, tendrils, needles;
    int iterations, layers, side, primary;
    float radius, spacing, crown;
    struct point fork;
};

extern const struct key growth_keys[]; /* of struct growth_def; ends with a key whose name is NULL */

/* The values that suit a metaphor, as a dendrite or as a tree. */
struct growth_def growth_preset(enum metaphor metaphor, bool tree);

/* Sets the value of growth_keys[key], choices and flags by their number from 0, brought into its range and rounded
 * where it is whole. Another metaphor, or a tree instead of a dendrite, brings its own values of all others but the
 * seed. */
void growth_take(struct growth_def *def, int key, float value);

struct growth {
    struct growth_def def;
    struct importance *importance;
    struct lattice *lattice;
    struct routes *routes;
    struct stipple *stipple;                    /* NULL for trees */
    struct dendrite *layers[GROWTH_LAYERS_MAX]; /* the first in front; a dendrite has one */
    int layer_count;
    int32_t *seeds, seed_count;
    int32_t *endpoints, endpoint_count; /* of a dendrite */
};

/* From width * height values of grey, 0 black to 1 white, GROWTH_SIZE_LEAST..IMPORTANCE_SIZE_MAX a side. NULL when
 * memory is short. */
struct growth *growth_create(const float *grey, int width, int height, const struct growth_def *def);
void growth_destroy(struct growth *growth); /* takes NULL */

/* Makes a place more or less important (importance_brush) and grows it again: endpoints within the place are placed
 * anew, others stay, ways are as planned anew. Dendrites alone. False for trees and when memory is short; destroy it
 * then. */
bool growth_brush(struct growth *growth, float x, float y, float radius, float amount);

/* Adds the lines of all layers. False when memory is short. */
bool growth_strokes(const struct growth *growth, struct strokes *strokes);

/* For gardens: what the lattice is made of; how thick a dendrite is; endpoints within a rectangle, which is not empty,
 * placed anew, kept apart from those around it, false when memory is short. */
struct lattice_def growth_lattice_def(const struct growth_def *def);
struct thickness growth_thickness(const struct growth_def *def);
bool growth_place_again(struct growth *growth, struct rectangle touched);

/* For growth_tree.c: lays out branches, smooths, thickens. */
bool growth_finish_layer(const struct growth *growth, struct dendrite *dendrite);
bool growth_tree(struct growth *growth);

#endif
