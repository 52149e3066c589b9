#include "light_case.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "laplacian.h"

const char *const light_case_names[LIGHT_CASES] = {"strike", "tesla",   "disc",  "river", "city",
                                                   "cracks", "vessels", "frost", "coral", "tree"};

/* How one is grown and seen. */
struct kind {
    int dimensions, particles;
    float eta;
    struct laplacian_charge charge; /* 0: none */
    struct laplacian_seed seed;
    float jitter;
    bool off_grid, strikes;
    int smooth; /* times that each place goes towards its neighbours */
    struct bolt_look look;
    float tilt;
};

static const struct kind KINDS[LIGHT_CASES] = {
    [LIGHT_STRIKE] = {.dimensions = 2,
                      .particles = 60000,
                      .eta = 4,
                      .charge = {LAPLACIAN_PLANE, 20000, {0, 420}, {0, 1}, 0, NULL, 0, true},
                      .jitter = 0.7f,
                      .strikes = true,
                      .smooth = 1,
                      .look = {.style = BOLT_GLOW,
                               .trunk = 1.1f,
                               .tip = 0.11f,
                               .pipe = 2.2f,
                               .colour = {0.36f, 0.38f, 1},
                               .core = {1, 0.97f, 1},
                               .ground = {0.004f, 0.003f, 0.012f}}},
    [LIGHT_TESLA] = {.dimensions = 2,
                     .particles = 4000,
                     .eta = 4.2f,
                     .jitter = 0.7f,
                     .strikes = true,
                     .look = {.style = BOLT_GLOW,
                              .trunk = 1.0f,
                              .tip = 0.25f,
                              .pipe = 2.5f,
                              .colour = {0.55f, 0.25f, 1},
                              .core = {1, 0.95f, 1},
                              .ground = {0.002f, 0.001f, 0.006f}}},
    [LIGHT_DISC] = {.dimensions = 2,
                    .particles = 40000,
                    .eta = 1.6f,
                    .jitter = 0.7f,
                    .strikes = true,
                    .look = {.style = BOLT_GLOW,
                             .trunk = 1.3f,
                             .tip = 0.2f,
                             .pipe = 3,
                             .colour = {0.25f, 0.5f, 1},
                             .core = {0.95f, 1, 1},
                             .ground = {0.001f, 0.003f, 0.008f}}},
    [LIGHT_RIVER] = {.dimensions = 2,
                     .particles = 9000,
                     .eta = 1.8f,
                     .charge = {LAPLACIAN_PLANE, 1500, {0, 260}, {0, 1}, 0, NULL, 0, true},
                     .jitter = 0.7f,
                     .smooth = 4,
                     .look = {.style = BOLT_LINE,
                              .trunk = 5,
                              .tip = 0.3f,
                              .pipe = 2.2f,
                              .colour = {0.05f, 0.14f, 0.24f},
                              .core = {0.2f, 0.42f, 0.55f},
                              .ground = {0.86f, 0.8f, 0.66f}}},
    [LIGHT_CITY] = {.dimensions = 2,
                    .particles = 7000,
                    .eta = 1.2f,
                    .look = {.style = BOLT_LINE,
                             .trunk = 1.5f,
                             .tip = 0.22f,
                             .pipe = 3,
                             .colour = {0.1f, 0.1f, 0.12f},
                             .core = {0.95f, 0.75f, 0.3f},
                             .ground = {0.9f, 0.89f, 0.86f}}},
    [LIGHT_CRACKS] = {.dimensions = 2,
                      .particles = 2500,
                      .eta = 3.5f,
                      .jitter = 0.7f,
                      .look = {.style = BOLT_LINE,
                               .trunk = 1.1f,
                               .tip = 0.12f,
                               .pipe = 2,
                               .colour = {0.02f, 0.025f, 0.03f},
                               .core = {0.02f, 0.02f, 0.03f},
                               .ground = {0.62f, 0.68f, 0.7f}}},
    [LIGHT_VESSELS] = {.dimensions = 2,
                       .particles = 9000,
                       .eta = 1.5f,
                       .jitter = 0.7f,
                       .smooth = 6,
                       .seed = {{0, 0}, {0, 0}},
                       .look = {.style = BOLT_LINE,
                                .trunk = 4,
                                .tip = 0.25f,
                                .pipe = 2.6f,
                                .colour = {0.25f, 0.01f, 0.02f},
                                .core = {0.6f, 0.07f, 0.06f},
                                .ground = {0.93f, 0.72f, 0.6f}}},
    [LIGHT_FROST] = {.dimensions = 2,
                     .particles = 16000,
                     .eta = 1.5f,
                     .charge = {LAPLACIAN_PLANE, 300, {0, -200}, {0, 1}, 0, NULL, 0, false},
                     .seed = {{-150, 120}, {150, 120}},
                     .look = {.style = BOLT_LINE,
                              .trunk = 1.2f,
                              .tip = 0.22f,
                              .pipe = 3,
                              .colour = {0.75f, 0.87f, 0.95f},
                              .core = {1, 1, 1},
                              .ground = {0.02f, 0.06f, 0.12f}}},
    [LIGHT_CORAL] = {.dimensions = 3,
                     .particles = 6000,
                     .eta = 6,
                     .charge = {LAPLACIAN_PLANE, -6000, {0, 6}, {0, 1}, 0, NULL, 0, false},
                     .jitter = 0.7f,
                     .smooth = 4,
                     .look = {.style = BOLT_BODY,
                              .trunk = 2.2f,
                              .tip = 0.5f,
                              .pipe = 3,
                              .colour = {0.62f, 0.09f, 0.06f},
                              .core = {0.98f, 0.62f, 0.42f},
                              .ground = {0.02f, 0.07f, 0.1f}},
                     .tilt = 0.04f},
    [LIGHT_TREE] = {.dimensions = 3,
                    .particles = 4500,
                    .eta = 5.5f,
                    .charge = {LAPLACIAN_PLANE, -3000, {0, 4}, {0, 1}, 0, NULL, 0, false},
                    .seed = {{0, 0, 0}, {0, -24, 0}},
                    .jitter = 0.7f,
                    .smooth = 3,
                    .look = {.style = BOLT_BODY,
                             .trunk = 2.4f,
                             .tip = 0.22f,
                             .pipe = 2.4f,
                             .colour = {0.16f, 0.085f, 0.045f},
                             .core = {0.16f, 0.36f, 0.05f},
                             .ground = {0.72f, 0.82f, 0.9f},
                             .leaves = 3},
                    .tilt = 0.02f},
};

struct grown {
    int count;
    struct laplacian_node *nodes;
    int *carried, *children; /* particles beyond each, and those that come right after it */
    float (*at)[3];
};

static void finish(struct grown *grown)
{
    free(grown->nodes);
    free(grown->carried);
    free(grown->children);
    free(grown->at);
}

static const char *grow(const struct kind *kind, struct grown *grown)
{
    enum laplacian_status status;
    struct laplacian_def def = laplacian_default_def();
    def.dimensions = kind->dimensions;
    def.particles = kind->particles;
    def.eta = kind->eta;
    def.seed = 7;
    def.jitter = kind->jitter;
    def.off_grid = kind->off_grid;
    def.charges = &kind->charge;
    def.charge_count = kind->charge.charge != 0;
    def.seeds = &kind->seed;
    def.seed_count = 1;
    *grown = (struct grown){0};
    struct laplacian *laplacian = laplacian_create(&def, &status);
    if (!laplacian) {
        return laplacian_status_names[status];
    }
    laplacian_step(laplacian, def.particles);
    size_t count = (size_t)laplacian_count(laplacian);
    grown->count = (int)count;
    grown->nodes = malloc(count * sizeof *grown->nodes);
    grown->carried = calloc(count, sizeof *grown->carried);
    grown->children = calloc(count, sizeof *grown->children);
    grown->at = calloc(2 * count, sizeof *grown->at);
    if (!grown->nodes || !grown->carried || !grown->children || !grown->at) {
        finish(grown);
        laplacian_destroy(laplacian);
        return "no memory";
    }
    for (int i = 0; i < grown->count; i++) {
        grown->nodes[i] = laplacian_node(laplacian, i);
        if (grown->nodes[i].parent < 0 && i > 0) { /* a trunk of seeds */
            grown->nodes[i].parent = kind->dimensions == 3 ? i - 1 : -1;
        }
        for (int d = 0; d < 3; d++) {
            grown->at[i][d] = grown->nodes[i].at[d];
        }
    }
    for (int i = grown->count - 1; i >= 0; i--) {
        int parent = grown->nodes[i].parent;
        grown->carried[i]++;
        if (parent >= 0) {
            grown->carried[parent] += grown->carried[i];
            grown->children[parent]++;
        }
    }
    laplacian_destroy(laplacian);
    return NULL;
}

static void smooth(struct grown *grown, int times)
{
    float(*sum)[3] = grown->at + grown->count;
    for (int time = 0; time < times; time++) {
        for (int i = 0; i < grown->count; i++) {
            for (int d = 0; d < 3; d++) {
                sum[i][d] = 0;
            }
        }
        for (int i = 0; i < grown->count; i++) {
            int parent = grown->nodes[i].parent;
            for (int d = 0; d < 3 && parent >= 0; d++) {
                sum[parent][d] += grown->at[i][d] * (float)grown->carried[i];
            }
        }
        for (int i = 0; i < grown->count; i++) {
            int parent = grown->nodes[i].parent;
            float beyond = (float)(grown->carried[i] - 1);
            for (int d = 0; d < 3 && parent >= 0 && beyond > 0; d++) {
                sum[i][d] = 0.5f * grown->at[i][d] + 0.25f * grown->at[parent][d] + 0.25f * sum[i][d] / beyond;
            }
        }
        for (int i = 0; i < grown->count; i++) {
            for (int d = 0; d < 3 && grown->nodes[i].parent >= 0 && grown->carried[i] > 1; d++) {
                grown->at[i][d] = sum[i][d];
            }
        }
    }
}

/* Moved and scaled into the sheet; returns the scale. */
static float fit(struct grown *grown, int width, int height)
{
    float low[3] = {FLT_MAX, FLT_MAX, FLT_MAX}, high[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX};
    for (int i = 0; i < grown->count; i++) {
        for (int d = 0; d < 3; d++) {
            low[d] = fminf(low[d], grown->at[i][d]);
            high[d] = fmaxf(high[d], grown->at[i][d]);
        }
    }
    float scale = 0.86f * fminf((float)width / (fmaxf(high[0] - low[0], high[2] - low[2]) + 1),
                                (float)height / (high[1] - low[1] + 1));
    for (int i = 0; i < grown->count; i++) {
        grown->at[i][0] = (grown->at[i][0] - (low[0] + high[0]) / 2) * scale + (float)width / 2;
        grown->at[i][1] = (grown->at[i][1] - (low[1] + high[1]) / 2) * scale + (float)height / 2;
        grown->at[i][2] = (grown->at[i][2] - (low[2] + high[2]) / 2) * scale;
    }
    return scale;
}

static float radius_of(const struct bolt_look *look, int carried)
{
    return fminf(look->tip * powf((float)carried, 1 / look->pipe), look->trunk);
}

static void fill(const struct kind *kind, const struct grown *grown, float scale, struct bolt_segment *segments)
{
    const struct bolt_look *look = &kind->look;
    bool *channel = calloc((size_t)grown->count, sizeof *channel);
    for (int i = grown->count - 1; i >= 0 && kind->charge.ends && kind->strikes && channel;
         i = grown->nodes[i].parent) {
        channel[i] = true;
    }
    for (int i = 0; i < grown->count; i++) {
        int parent = grown->nodes[i].parent < 0 ? i : grown->nodes[i].parent;
        struct bolt_segment *to = &segments[i];
        *to = (struct bolt_segment){.birth = 0.02f * (float)i, .death = FLT_MAX, .heat = 1};
        for (int d = 0; d < 3; d++) {
            to->from[d] = grown->at[parent][d];
            to->to[d] = grown->at[i][d];
        }
        to->radius = scale * radius_of(look, grown->carried[i]);
        to->radius_from =
            scale * fminf(radius_of(look, grown->carried[parent]), radius_of(look, grown->carried[i]) * 1.5f);
        if (kind->strikes) {
            to->heat = fminf(1, 0.05f + 0.75f * powf((float)grown->carried[i] / (float)grown->count, 0.45f));
        }
        if (channel && channel[i]) {
            to->heat = 1;
            to->radius = to->radius_from = scale * look->trunk;
        }
        bool leafy = look->leaves > 0 && grown->carried[i] < 12 && i % (int)look->leaves == 0;
        to->leaf = leafy ? 1.9f * scale : 0;
    }
    free(channel);
}

const char *light_case_grow(enum light_case which, int width, int height, struct bolt_view *view,
                            struct bolt_segment **own)
{
    const struct kind *kind = &KINDS[which];
    struct grown grown;
    const char *wrong = grow(kind, &grown);
    *view = (struct bolt_view){.width = width, .height = height, .tilt = kind->tilt, .look = kind->look};
    if (wrong) {
        return wrong;
    }
    *own = NULL;
    struct bolt_segment *segments = malloc((size_t)grown.count * sizeof *segments);
    if (segments) {
        smooth(&grown, kind->smooth);
        float scale = fit(&grown, width, height);
        view->look.trunk *= scale;
        view->look.tip *= scale;
        fill(kind, &grown, scale, segments);
    }
    view->segments = *own = segments;
    view->count = segments ? grown.count : 0;
    finish(&grown);
    return segments ? NULL : "no memory";
}
