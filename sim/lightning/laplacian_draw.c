/* Which candidate is next. */

#include "exponential.h"
#include "laplacian_state.h"
#include "memory.h"

enum { TRIALS_MAX = 256 };
static const float MARGIN = 0.03f;   /* of the spread, that the bound lies above the greatest load */
static const float ETA_STEP = 0.05f; /* eta may change by, before all are weighed again */

static double next_random(struct laplacian *laplacian)
{
    uint64_t x = ((uint64_t)(uint32_t)laplacian->def.seed << 32) + laplacian->draws++ * UINT64_C(0x9e3779b97f4a7c15);
    x = (x ^ x >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    x = (x ^ x >> 27) * UINT64_C(0x94d049bb133111eb);
    return (double)((x ^ x >> 31) >> 11) * 0x1p-53;
}

float laplacian_rate_of(const struct laplacian *laplacian, int32_t candidate)
{
    return laplacian->environment ? laplacian->rate[candidate] : 0;
}

float laplacian_load_now(struct laplacian *laplacian, const float *at, float rate)
{
    int dimensions = laplacian->def.dimensions;
    float load;
    if (laplacian->fast) {
        laplacian->kernels->walk(&laplacian->tree, at, laplacian->field);
        load = laplacian->kernels->value(laplacian->field, dimensions, at);
    } else {
        load = laplacian->kernels->sum((const float *const *)laplacian->places, laplacian->count, dimensions, at);
    }
    return load + laplacian_static_load(laplacian, at) + rate * (float)laplacian->count;
}

static float eta_now(const struct laplacian *laplacian)
{
    const struct laplacian_def *def = &laplacian->def;
    float done = (float)laplacian->count / (float)def->particles;
    return def->eta_end < 0 ? def->eta : def->eta + (def->eta_end - def->eta) * (done < 1 ? done : 1);
}

static float weight_of(const struct laplacian *laplacian, int32_t candidate, float load,
                       const struct laplacian_weighing *weighing)
{
    float eta = weighing->eta, base = (weighing->most - load) * weighing->scale;
    if (laplacian->def.eta_map.values) {
        float at[LAPLACIAN_DIMENSIONS_MAX];
        laplacian_candidate_at(laplacian, candidate, at);
        float here = laplacian_raster(laplacian, &laplacian->def.eta_map, at);
        eta *= here > 0 ? here : 0;
    }
    return eta == 0 ? 1 : power(base < 0 ? 0 : base, eta);
}

static void weigh_all(struct laplacian *laplacian, const struct laplacian_weighing *weighing)
{
    if (laplacian->def.eta_map.values) {
        for (int32_t i = 0; i < laplacian->candidates; i++) {
            laplacian->weights.sums[0][i] = weight_of(laplacian, i, laplacian->load[i], weighing);
        }
    } else {
        laplacian->kernels->weigh(laplacian->load, laplacian->candidates, weighing, laplacian->weights.sums[0]);
    }
    laplacian_weights_sum(&laplacian->weights, laplacian->candidates);
}

/* Eq. 12 and 13 as they stand, from loads that are all up to date. */
static int32_t choose_exactly(struct laplacian *laplacian)
{
    float least, most;
    laplacian->kernels->range(laplacian->load, laplacian->candidates, &least, &most);
    float size = most > -least ? most : -least;
    if (most - least <= 1e-6f * size) { /* all the same: each as likely */
        return (int32_t)(next_random(laplacian) * laplacian->candidates);
    }
    laplacian->bound = most;
    laplacian->spread = most - least;
    const struct laplacian_weighing weighing = {most, 1 / (most - least), eta_now(laplacian)};
    weigh_all(laplacian, &weighing);
    return laplacian_weights_draw(&laplacian->weights, next_random(laplacian));
}

/* Weights from above, by loads that may be old. */
static void weigh_bound(struct laplacian *laplacian)
{
    laplacian_extremes_find(laplacian, &laplacian->deep);
    laplacian_extremes_find(laplacian, &laplacian->bare);
    float eta = eta_now(laplacian), spread = laplacian->deep.most - laplacian->bare.least;
    float smallest = 1e-6f * (laplacian->deep.most > 1 ? laplacian->deep.most : 1);
    laplacian->spread = spread > smallest ? spread : smallest;
    laplacian->bound = laplacian->deep.most + MARGIN * laplacian->spread;
    laplacian->eta_was = eta;
    bool falls = laplacian->def.eta_end >= 0 && laplacian->def.eta_end < laplacian->def.eta;
    laplacian->eta_weighed = !falls ? eta : eta > ETA_STEP ? eta - ETA_STEP : 0;
    const struct laplacian_weighing weighing = {laplacian->bound, 1 / laplacian->spread, laplacian->eta_weighed};
    weigh_all(laplacian, &weighing);
    laplacian->weighed = true;
}

static bool is_outdated(const struct laplacian *laplacian)
{
    if (!laplacian->weighed || laplacian->deep.count == 0 || laplacian->deep.most > laplacian->bound) {
        return true;
    }
    if (!laplacian->eta_varies) {
        return false;
    }
    float by = eta_now(laplacian) - laplacian->eta_was, spread = laplacian->deep.most - laplacian->bare.least;
    return by > ETA_STEP || by < -ETA_STEP || laplacian->bare.count == 0 || spread < 0.98f * laplacian->spread;
}

static void set_load(struct laplacian *laplacian, int32_t candidate, float load)
{
    const struct laplacian_weighing weighing = {laplacian->bound, 1 / laplacian->spread, laplacian->eta_weighed};
    laplacian->load[candidate] = load;
    laplacian_weights_set(&laplacian->weights, candidate, weight_of(laplacian, candidate, load, &weighing));
}

/* The load of a place near that of the last walk, a little less than it may be. */
static float load_nearby(struct laplacian *laplacian, const float *at, float rate)
{
    float sum = laplacian->kernels->value(laplacian->field, laplacian->def.dimensions, at);
    return sum * (1 - laplacian->def.error) + laplacian_static_load(laplacian, at) + rate * (float)laplacian->count;
}

static void refresh_around(struct laplacian *laplacian, int32_t candidate, const float *at)
{
    int32_t near[NEIGHBOURS_MAX];
    int count = laplacian_neighbours(laplacian, at, near);
    for (int i = 0; i < count; i++) {
        float place[LAPLACIAN_DIMENSIONS_MAX];
        if (near[i] != candidate) {
            laplacian_candidate_at(laplacian, near[i], place);
            float load = load_nearby(laplacian, place, laplacian_rate_of(laplacian, near[i]));
            if (load > laplacian->load[near[i]]) {
                set_load(laplacian, near[i], load);
            }
        }
    }
}

/* When nearly all trials are rejected: once without them. */
static int32_t choose_after_all(struct laplacian *laplacian)
{
    float at[LAPLACIAN_DIMENSIONS_MAX];
    for (int32_t i = 0; i < laplacian->candidates; i++) {
        laplacian_candidate_at(laplacian, i, at);
        laplacian->load[i] = laplacian_load_now(laplacian, at, laplacian_rate_of(laplacian, i));
    }
    int32_t chosen = choose_exactly(laplacian);
    laplacian->weighed = false;
    if (chosen >= 0) {
        laplacian_candidate_at(laplacian, chosen, at);
        (void)laplacian_load_now(laplacian, at, 0);
    }
    return chosen;
}

static int32_t choose_fast(struct laplacian *laplacian)
{
    for (int trial = 0; trial < TRIALS_MAX; trial++) {
        if (is_outdated(laplacian)) {
            weigh_bound(laplacian);
        }
        float at[LAPLACIAN_DIMENSIONS_MAX];
        int32_t candidate = laplacian_weights_draw(&laplacian->weights, next_random(laplacian));
        if (candidate < 0) {
            break;
        }
        laplacian->trials++;
        laplacian_candidate_at(laplacian, candidate, at);
        float load = laplacian_load_now(laplacian, at, laplacian_rate_of(laplacian, candidate));
        laplacian_extremes_consider(laplacian, &laplacian->deep, candidate, load);
        laplacian_extremes_consider(laplacian, &laplacian->bare, candidate, load);
        float spread = laplacian->eta_varies ? laplacian->deep.most - laplacian->bare.least : laplacian->spread;
        const struct laplacian_weighing weighing = {laplacian->deep.most, 1 / spread, eta_now(laplacian)};
        float weight = weight_of(laplacian, candidate, load, &weighing);
        double bound = (double)laplacian->weights.sums[0][candidate];
        laplacian->load[candidate] = load;
        if (next_random(laplacian) * bound < (double)weight) {
            return candidate;
        }
        set_load(laplacian, candidate, load);
        refresh_around(laplacian, candidate, at);
    }
    return choose_after_all(laplacian);
}

int32_t laplacian_choose(struct laplacian *laplacian)
{
    if (laplacian->candidates == 0) {
        return -1;
    }
    laplacian->choices++;
    return laplacian->fast ? choose_fast(laplacian) : choose_exactly(laplacian);
}

void laplacian_note(struct laplacian *laplacian, int32_t candidate)
{
    float at[LAPLACIAN_DIMENSIONS_MAX];
    if (!laplacian->ready) {
        return;
    }
    laplacian_candidate_at(laplacian, candidate, at);
    float rate = laplacian_rate_of(laplacian, candidate);
    if (!laplacian->fast) {
        laplacian->load[candidate] = laplacian_load_now(laplacian, at, rate);
        return;
    }
    float newest[LAPLACIAN_DIMENSIONS_MAX];
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        newest[d] = laplacian->places[d][laplacian->count - 1];
    }
    float load = load_nearby(laplacian, at, rate) + laplacian_green(laplacian, at, newest);
    if (laplacian->weighed) {
        set_load(laplacian, candidate, load);
        laplacian_extremes_consider(laplacian, &laplacian->deep, candidate, load);
        laplacian_extremes_consider(laplacian, &laplacian->bare, candidate, load);
    } else {
        laplacian->load[candidate] = load;
    }
}

void laplacian_raise(struct laplacian *laplacian, const float *at)
{
    if (laplacian->fast) {
        laplacian_extremes_raise(laplacian, &laplacian->deep, at);
        laplacian_extremes_raise(laplacian, &laplacian->bare, at);
    } else {
        laplacian->kernels->add(laplacian->load, (const float *const *)laplacian->at, laplacian->candidates,
                                laplacian->def.dimensions, at);
        if (laplacian->environment) {
            laplacian->kernels->rise(laplacian->load, laplacian->rate, laplacian->candidates);
        }
    }
}

void laplacian_forget(struct laplacian *laplacian, int32_t candidate, int32_t moved)
{
    if (candidate != moved) {
        laplacian_weights_set(&laplacian->weights, candidate, laplacian->weights.sums[0][moved]);
    }
    laplacian_weights_set(&laplacian->weights, moved, 0);
    laplacian_extremes_forget(&laplacian->deep, candidate, moved);
    laplacian_extremes_forget(&laplacian->bare, candidate, moved);
}

float laplacian_normalised(const struct laplacian *laplacian, int32_t candidate)
{
    float most = laplacian->fast ? laplacian->deep.most : laplacian->bound;
    float potential = (most - laplacian->load[candidate]) / (laplacian->spread > 0 ? laplacian->spread : 1);
    return potential < 0 ? 0 : potential > 1 ? 1 : potential;
}

bool laplacian_quicken(struct laplacian *laplacian)
{
    laplacian->field = memory_take(1, sizeof *laplacian->field, &laplacian->bytes);
    if (!laplacian->field || !laplacian_tree_init(&laplacian->tree, laplacian->def.dimensions, laplacian->def.error)) {
        return false;
    }
    for (int32_t i = 0; i < laplacian->count; i++) {
        const float at[3] = {laplacian->places[0][i], laplacian->places[1][i],
                             laplacian->def.dimensions == 3 ? laplacian->places[2][i] : 0};
        if (!laplacian_tree_insert(&laplacian->tree, at)) {
            return false;
        }
    }
    laplacian->fast = true;
    laplacian->weighed = false;
    laplacian->deep.deep = true;
    return true;
}
