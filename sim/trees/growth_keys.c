#include "growth.h"

#include <string.h>

#include "key_fields.h"

static const char *const SIDES[] = {"none", "left", "right", "all", NULL};
const char *const metaphor_names[METAPHORS + 1] = {"ink",   "vine",   "lightning", "winter",
                                                   "frost", "cracks", "painted",   NULL};

#define KEY_AT(field) offsetof(struct growth_def, field)

const struct key growth_keys[] = {
    CHOICE(metaphor, metaphor_names, METAPHOR_INK, "What it looks like; the defaults of the others follow."),
    FLAG(tree, "A tree that stands in the picture, not a dendrite over all of it."),
    CHOICE(metric, metric_names, METRIC_PARTIAL, "What makes one way shorter than another."),
    WHOLE(emphasis, "", 0, ROUTES_EMPHASIS_MAX, 1000, "Metric weighted: the maximum edge over the sum."),
    WHOLE(endpoints, "", 1, 200000, 3000, "Tips that are looked for, of a dendrite."),
    WHOLE(seed, "", 0, 2147483647, 1, "Another number, another chance."),
    {.name = "plant",
     .type = KEY_PATH,
     .unit = "",
     .min = 0,
     .max = 1,
     .offset = offsetof(struct growth_def, plants),
     .meaning = "Where it grows from, x,y in 0..1 of the picture; may be given again and again."},
    NUMBER(gradient, "", 0, 10, 3, "Importance of edges."),
    NUMBER(intensity, "", 0, 10, 1, "Importance of dark places."),
    NUMBER(blur, "pixels", 0, 16, 0.8, "Blur of the picture before anything else."),
    FLAG(light, "Light places are important, not dark ones."),
    NUMBER(base, "", 0, 1, 0.05, "Cost of a node that is wholly important."),
    NUMBER(picture, "", 0, 1, 1, "Cost of a node that is not important at all."),
    NUMBER(random, "", 0, 0.9, 0.04, "Random part of a node's cost."),
    NUMBER(upward, "", 0.25, 4, 1, "Growing upwards costs so many times more."),
    NUMBER(sideways, "", 0.25, 4, 1, "Growing sideways costs so many times more."),
    WHOLE(smooth, "passes", 0, 64, 2, "Smoothing of branches."),
    NUMBER(jitter, "pixels", 0, 4, 0.25, "Unrest of branches before smoothing."),
    NUMBER(tip, "pixels", 0.05, 8, 0.25, "Radius of tips."),
    NUMBER(gain, "pixels", 0, 16, 1.45, "Radius that importance adds."),
    NUMBER(power, "", 0.1, 8, 1.5, "How steeply importance adds it."),
    WHOLE(window, "nodes", 0, 64, 8, "Nodes on either side over which importance is averaged."),
    NUMBER(branch, "pixels", 0, 64, 3, "Radius at the foot of a branch that carries everything."),
    NUMBER(step, "pixels", 0, 16, 0.5, "Radius that each later iteration of a tree adds to what was there."),
    NUMBER(trunk, "pixels", 0, 64, 4, "More radius at the foot of a tree's trunk."),
    NUMBER(mix, "", 0, 1, 1, "Thickness by importance (1), as branches (0), or between."),
    NUMBER(leaves, "pixels", 0, 64, 0, "Length of leaves; 0: none."),
    NUMBER(tendrils, "pixels", 0, 64, 0, "Length of tendrils; 0: none."),
    NUMBER(needles, "pixels", 0, 64, 0, "Length of ice needles; 0: none."),
    WHOLE(iterations, "", 1, 5, 3, "Iterations of a tree after its primary branches."),
    WHOLE(primary, "", 0, 16, 6, "Primary branches of a tree."),
    WHOLE(layers, "", 1, GROWTH_LAYERS_MAX, 2, "Crowns of a tree behind one another."),
    CHOICE(side, SIDES, GROWTH_SIDE_LEFT, "The side of a tree's crown that grows free of the picture."),
    NUMBER(radius, "of the height", 0.02, 1, 0.26, "How far a tree's first iteration reaches; half each time."),
    NUMBER(spacing, "", 1, 200, 20, "Threshold of stippling in a tree's first iteration; half each time."),
    NUMBER(crown, "", 0.1, 2, 1, "Size of a tree's crown."),
    POINT(fork, "Where a tree's trunk ends, x,y in 0..1 of the picture."),
    END,
};

static void dress_tree(struct growth_def *def)
{
    def->tree = true;
    def->metric = METRIC_WEIGHTED;
    def->tip = 0.3f;
    def->mix = 0.45f;
    def->gain = 1.3f;
    def->branch = 4.5f;
    def->smooth = 3;
    def->jitter = 0.35f;
}

static void dress(struct growth_def *def)
{
    switch (def->metaphor) {
    case METAPHOR_VINE:
        def->metric = METRIC_FULL;
        def->endpoints = 1700;
        def->smooth = 12;
        def->mix = 0.75f;
        def->tip = 0.3f;
        def->gain = 2.3f;
        def->branch = 4;
        def->leaves = 11;
        def->tendrils = 17;
        break;
    case METAPHOR_LIGHTNING:
        def->light = true;
        def->upward = 4;
        def->sideways = 1.3f;
        def->endpoints = 1700;
        def->smooth = 1;
        def->jitter = 1.1f;
        def->tip = 0.2f;
        def->gain = 1.0f;
        def->random = 0.55f;
        def->mix = 0.7f;
        break;
    case METAPHOR_WINTER:
        def->mix = 0.75f;
        def->gain = 2.2f;
        def->branch = 6;
        def->tip = 0.28f;
        def->jitter = 0.4f;
        break;
    case METAPHOR_FROST:
        def->light = true;
        def->endpoints = 2600;
        def->smooth = 1;
        def->jitter = 0;
        def->tip = 0.22f;
        def->gain = 0.9f;
        def->needles = 7;
        break;
    case METAPHOR_CRACKS:
        def->metric = METRIC_FULL;
        def->endpoints = 2000;
        def->smooth = 1;
        def->jitter = 0.5f;
        def->random = 0.15f;
        def->tip = 0.18f;
        def->gain = 0.8f;
        def->branch = 2;
        def->mix = 0.7f;
        break;
    default:
        break;
    }
}

struct growth_def growth_preset(enum metaphor metaphor, bool tree)
{
    struct growth_def def = {0};
    key_defaults(growth_keys, &def);
    def.metaphor = (int)metaphor;
    def.fork = (struct point){0.42f, 0.52f};
    dress(&def);
    if (tree) {
        dress_tree(&def);
    }
    return def;
}

void growth_take(struct growth_def *def, int key, float value)
{
    const struct key *of = &growth_keys[key];
    int seed = def->seed;
    key_take(of, def, value);
    if (strcmp(of->name, "metaphor") == 0 || strcmp(of->name, "tree") == 0) {
        *def = growth_preset((enum metaphor)def->metaphor, def->tree);
        def->seed = seed;
    }
}
