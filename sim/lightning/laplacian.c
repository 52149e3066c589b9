#include "laplacian.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "laplacian_boundary.h"
#include "laplacian_state.h"
#include "vectors.h"

static const float OFF_GRID_SPACING = 0.7f;
enum { QUICK_FROM = 3000 /* candidates from which the fast method is quicker */ };

const struct laplacian_kernels *laplacian_kernels_best(void)
{
    return VECTORS_COPY(laplacian_kernels, VECTORS_BEST);
}

static bool are_finite(const float *values, int count)
{
    for (int i = 0; i < count; i++) {
        if (!isfinite(values[i])) {
            return false;
        }
    }
    return true;
}

static bool is_good_raster(const struct action_raster *raster)
{
    return !raster->values || (raster->width > 0 && raster->height > 0);
}

static bool is_good(const struct laplacian_def *def)
{
    if (!keys_are_legal(laplacian_keys, def)) {
        return false;
    }
    if (!is_good_raster(&def->mask) || !is_good_raster(&def->eta_map) || !is_good_raster(&def->outline) ||
        !is_good_raster(&def->environment) || !is_good_raster(&def->background) ||
        (def->environment.values && def->dimensions > 3)) {
        return false;
    }
    for (int i = 0; i < def->charge_count; i++) {
        if (!laplacian_charge_is_good(&def->charges[i], def->dimensions)) {
            return false;
        }
    }
    for (int i = 0; i < def->seed_count; i++) {
        if (!are_finite(def->seeds[i].from, def->dimensions) || !are_finite(def->seeds[i].to, def->dimensions)) {
            return false;
        }
    }
    return true;
}

static bool put_seed(struct laplacian *laplacian, const float *at)
{
    int32_t cell[LAPLACIAN_DIMENSIONS_MAX];
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        if (fabsf(at[d]) * laplacian->cells_a_unit >= (float)laplacian->limit) {
            return true;
        }
    }
    laplacian_cell_of(laplacian, at, cell);
    const int32_t *there = laplacian_cells_find(&laplacian->cells, cell);
    if ((there && *there != LAPLACIAN_CELL_FREE) || !laplacian_allows(laplacian, at)) {
        return true;
    }
    return laplacian_put(laplacian, at, -1, 1) >= 0;
}

static bool put_segment(struct laplacian *laplacian, const struct laplacian_seed *seed)
{
    float length = 0, at[LAPLACIAN_DIMENSIONS_MAX];
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        length += (seed->to[d] - seed->from[d]) * (seed->to[d] - seed->from[d]);
    }
    float most = 4 * (float)laplacian->limit;
    length = sqrtf(length);
    int pieces = (int)ceilf(length < most ? length : most);
    for (int i = 0; i <= pieces; i++) {
        float part = pieces > 0 ? (float)i / (float)pieces : 0;
        for (int d = 0; d < laplacian->def.dimensions; d++) {
            at[d] = seed->from[d] + part * (seed->to[d] - seed->from[d]);
        }
        if (!put_seed(laplacian, at)) {
            return false;
        }
    }
    return true;
}

/* Where light meets dark. */
static bool put_outline(struct laplacian *laplacian)
{
    const struct action_raster *raster = &laplacian->def.outline;
    for (int y = 0; y < raster->height; y++) {
        for (int x = 0; x < raster->width; x++) {
            const float *here = raster->values + (size_t)y * (size_t)raster->width + x;
            bool edge = (x > 0 && here[-1] < 0.5f) || (x + 1 < raster->width && here[1] < 0.5f) ||
                        (y > 0 && here[-raster->width] < 0.5f) ||
                        (y + 1 < raster->height && here[raster->width] < 0.5f);
            float at[LAPLACIAN_DIMENSIONS_MAX];
            laplacian_inside(laplacian, raster, x, y, at);
            if (*here >= 0.5f && edge && !put_seed(laplacian, at)) {
                return false;
            }
        }
    }
    return true;
}

static bool put_seeds(struct laplacian *laplacian)
{
    const struct laplacian_def *def = &laplacian->def;
    if (def->outline.values && !put_outline(laplacian)) {
        return false;
    }
    for (int i = 0; i < def->seed_count; i++) {
        if (!put_segment(laplacian, &def->seeds[i])) {
            return false;
        }
    }
    const float origin[LAPLACIAN_DIMENSIONS_MAX] = {0};
    return def->seed_count > 0 || def->outline.values || put_seed(laplacian, origin);
}

/* Candidates around the seeds, and their loads. */
static bool begin(struct laplacian *laplacian)
{
    int32_t seeds = laplacian->count;
    bool could = laplacian->def.dimensions <= 3 && laplacian->def.method != LAPLACIAN_EXACT;
    for (int32_t i = 0; i < seeds; i++) {
        if (!laplacian_surround(laplacian, i)) {
            return false;
        }
    }
    if (could && (laplacian->def.method == LAPLACIAN_FAST || laplacian->candidates > QUICK_FROM) &&
        !laplacian_quicken(laplacian)) {
        return false;
    }
    for (int32_t i = 0; i < laplacian->candidates; i++) {
        float at[LAPLACIAN_DIMENSIONS_MAX];
        laplacian_candidate_at(laplacian, i, at);
        laplacian->load[i] = laplacian_load_now(laplacian, at, laplacian_rate_of(laplacian, i));
    }
    laplacian->ready = true;
    return true;
}

static bool copy_lists(struct laplacian *laplacian, const struct laplacian_def *def)
{
    laplacian->charges = malloc(((size_t)def->charge_count + 1) * sizeof *laplacian->charges);
    if (!laplacian->charges) {
        return false;
    }
    if (def->charge_count > 0) {
        memcpy(laplacian->charges, def->charges, (size_t)def->charge_count * sizeof *laplacian->charges);
    }
    laplacian->def.charges = laplacian->charges;
    return true;
}

static void project(struct laplacian *laplacian)
{
    const struct laplacian_def *def = &laplacian->def;
    laplacian->environment = def->environment.values && def->environment_strength > 0;
    if (laplacian->environment) {
        laplacian_harmonics_project(&laplacian->harmonics, def->dimensions, def->harmonics,
                                    (double)def->environment_radius, &def->environment);
    }
}

struct laplacian *laplacian_create(const struct laplacian_def *def, enum laplacian_status *status)
{
    *status = LAPLACIAN_BAD_VALUE;
    if (!is_good(def)) {
        return NULL;
    }
    *status = LAPLACIAN_NO_MEMORY;
    struct laplacian *laplacian = calloc(1, sizeof *laplacian);
    if (!laplacian) {
        return NULL;
    }
    laplacian->def = *def;
    laplacian->kernels = laplacian_kernels_best();
    laplacian->cells_a_unit = def->off_grid ? sqrtf((float)def->dimensions) / OFF_GRID_SPACING : 1;
    laplacian->limit = laplacian_cells_limit(def->dimensions);
    laplacian->limit = laplacian->limit < 131072 ? laplacian->limit : 131072; /* jitter is lost farther out */
    laplacian->eta_varies = def->eta_end >= 0 || def->eta_map.values;
    project(laplacian);
    bool good =
        copy_lists(laplacian, def) && laplacian_cells_init(&laplacian->cells, def->dimensions) && put_seeds(laplacian);
    laplacian->def.seeds = NULL;
    if (good && laplacian->count == 0) {
        *status = LAPLACIAN_NO_SEED;
        good = false;
    }
    if (!good || !begin(laplacian)) {
        laplacian_destroy(laplacian);
        return NULL;
    }
    laplacian->status = laplacian->candidates == 0           ? LAPLACIAN_NO_CANDIDATES
                        : laplacian->count >= def->particles ? LAPLACIAN_COMPLETE
                                                             : LAPLACIAN_GROWING;
    *status = laplacian->status;
    return laplacian;
}

void laplacian_destroy(struct laplacian *laplacian)
{
    if (laplacian) {
        for (int d = 0; d < LAPLACIAN_DIMENSIONS_MAX; d++) {
            free(laplacian->places[d]);
            free(laplacian->at[d]);
        }
        free(laplacian->potential);
        free(laplacian->parent);
        free(laplacian->load);
        free(laplacian->rate);
        free(laplacian->from);
        free(laplacian->charges);
        free(laplacian->field);
        laplacian_cells_finish(&laplacian->cells);
        laplacian_weights_finish(&laplacian->weights);
        laplacian_tree_finish(&laplacian->tree);
        free(laplacian);
    }
}

static enum laplacian_status status_after(const struct laplacian *laplacian, const float *at)
{
    float squared = 0;
    bool far = false;
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        squared += at[d] * at[d];
        far = far || fabsf(at[d]) * laplacian->cells_a_unit + 2 >= (float)laplacian->limit;
    }
    float extent = laplacian->def.extent;
    return laplacian_touches(laplacian, at)                    ? LAPLACIAN_HIT
           : far || (extent > 0 && squared >= extent * extent) ? LAPLACIAN_FAR
           : laplacian->count >= laplacian->def.particles      ? LAPLACIAN_COMPLETE
           : laplacian->candidates == 0                        ? LAPLACIAN_NO_CANDIDATES
                                                               : LAPLACIAN_GROWING;
}

static void grow(struct laplacian *laplacian)
{
    float at[LAPLACIAN_DIMENSIONS_MAX];
    int32_t candidate = laplacian_choose(laplacian);
    if (candidate < 0) {
        laplacian->status = LAPLACIAN_NO_CANDIDATES;
        return;
    }
    float potential = laplacian_normalised(laplacian, candidate);
    int32_t parent = laplacian->from[candidate];
    laplacian_candidate_at(laplacian, candidate, at);
    laplacian_remove(laplacian, candidate);
    int32_t node = laplacian_put(laplacian, at, parent, potential);
    if (node < 0) {
        laplacian->status = LAPLACIAN_NO_MEMORY;
        return;
    }
    laplacian_raise(laplacian, at);
    if (!laplacian_surround(laplacian, node)) {
        laplacian->status = LAPLACIAN_NO_MEMORY;
        return;
    }
    laplacian->status = status_after(laplacian, at);
    if (!laplacian->fast && laplacian->def.method == LAPLACIAN_AUTO && laplacian->def.dimensions <= 3 &&
        laplacian->candidates > QUICK_FROM && !laplacian_quicken(laplacian)) {
        laplacian->status = LAPLACIAN_NO_MEMORY;
    }
}

int32_t laplacian_step(struct laplacian *laplacian, int32_t count)
{
    int32_t before = laplacian->count;
    for (int32_t i = 0; i < count && laplacian->status == LAPLACIAN_GROWING; i++) {
        grow(laplacian);
    }
    return laplacian->count - before;
}

enum laplacian_status laplacian_status(const struct laplacian *laplacian)
{
    return laplacian->status;
}

int32_t laplacian_count(const struct laplacian *laplacian)
{
    return laplacian->count;
}

struct laplacian_node laplacian_node(const struct laplacian *laplacian, int32_t index)
{
    struct laplacian_node node = {.potential = laplacian->potential[index], .parent = laplacian->parent[index]};
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        node.at[d] = laplacian->places[d][index];
    }
    return node;
}

size_t laplacian_bytes(const struct laplacian *laplacian)
{
    return sizeof *laplacian + laplacian->bytes + laplacian->cells.bytes + laplacian->weights.bytes +
           laplacian->tree.bytes;
}

float laplacian_potential(struct laplacian *laplacian, const float *at)
{
    float rate = laplacian->environment ? laplacian_rate(laplacian, at) : 0;
    return (float)laplacian->count - 0.5f * laplacian_load_now(laplacian, at, rate);
}

/* What is around has another weight: all candidates are weighed anew. */
static void add_static_loads(struct laplacian *laplacian, float sign)
{
    for (int32_t i = 0; i < laplacian->candidates; i++) {
        float at[LAPLACIAN_DIMENSIONS_MAX];
        laplacian_candidate_at(laplacian, i, at);
        laplacian->load[i] += sign * laplacian_static_load(laplacian, at);
    }
    laplacian->weighed = false;
}

bool laplacian_charge(struct laplacian *laplacian, const struct laplacian_charge *charges, int count)
{
    struct laplacian_charge *copy = malloc(((size_t)count + 1) * sizeof *copy);
    for (int i = 0; i < count && copy; i++) {
        if (!laplacian_charge_is_good(&charges[i], laplacian->def.dimensions)) {
            free(copy);
            return false;
        }
        copy[i] = charges[i];
    }
    if (!copy) {
        return false;
    }
    add_static_loads(laplacian, -1);
    free(laplacian->charges);
    laplacian->charges = copy;
    laplacian->def.charges = copy;
    laplacian->def.charge_count = count;
    add_static_loads(laplacian, 1);
    return true;
}

void laplacian_background(struct laplacian *laplacian, const struct action_raster *background)
{
    add_static_loads(laplacian, -1);
    laplacian->def.background = background ? *background : (struct action_raster){0};
    add_static_loads(laplacian, 1);
}

void laplacian_eta(struct laplacian *laplacian, float eta)
{
    key_take(key_find(laplacian_keys, "eta"), &laplacian->def, eta);
    laplacian->def.eta_end = -1;
    laplacian->eta_varies = laplacian->def.eta_map.values;
    laplacian->weighed = false;
}

int32_t laplacian_candidates(const struct laplacian *laplacian)
{
    return laplacian->candidates;
}

struct laplacian_node laplacian_candidate(const struct laplacian *laplacian, int32_t index)
{
    struct laplacian_node node = {.parent = laplacian->from[index]};
    laplacian_candidate_at(laplacian, index, node.at);
    return node;
}

double laplacian_trials(const struct laplacian *laplacian)
{
    return laplacian->choices > 0 ? laplacian->trials / laplacian->choices : 0;
}
