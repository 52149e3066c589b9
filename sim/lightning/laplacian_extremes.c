/* The candidates with the greatest loads tell what the deepest is (eq. 13); those with the least, what stands out most.
 */
#include "laplacian_state.h"

static void measure(const struct laplacian *laplacian, struct extremes *extremes)
{
    if (extremes->count > 0) {
        laplacian->kernels->range(extremes->load, extremes->count, &extremes->least, &extremes->most);
    }
}

static void keep(const struct laplacian *laplacian, struct extremes *extremes, int32_t slot, int32_t candidate,
                 float load)
{
    extremes->index[slot] = candidate;
    extremes->load[slot] = load;
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        extremes->at[d][slot] = laplacian->at[d][candidate];
    }
    extremes->rate[slot] = laplacian_rate_of(laplacian, candidate);
    measure(laplacian, extremes);
}

static int32_t slot_of(const struct extremes *extremes, int32_t candidate)
{
    int32_t slot = -1;
    for (int32_t i = 0; i < extremes->count; i++) {
        slot = extremes->index[i] == candidate ? i : slot;
    }
    return slot;
}

void laplacian_extremes_consider(struct laplacian *laplacian, struct extremes *extremes, int32_t candidate, float load)
{
    bool full = extremes->count == EXTREMES;
    if (full && (extremes->deep ? load <= extremes->least : load >= extremes->most)) {
        return;
    }
    if (slot_of(extremes, candidate) >= 0) {
        return;
    }
    int32_t slot = extremes->count;
    for (int32_t i = 0; i < extremes->count && full; i++) {
        if (extremes->load[i] == (extremes->deep ? extremes->least : extremes->most)) {
            slot = i;
            break;
        }
    }
    extremes->count += !full;
    keep(laplacian, extremes, slot, candidate, load);
}

void laplacian_extremes_forget(struct extremes *extremes, int32_t candidate, int32_t moved)
{
    int32_t slot = slot_of(extremes, candidate);
    if (slot >= 0) {
        int32_t last = --extremes->count;
        extremes->index[slot] = extremes->index[last];
        extremes->load[slot] = extremes->load[last];
        extremes->rate[slot] = extremes->rate[last];
        for (int d = 0; d < LAPLACIAN_DIMENSIONS_MAX; d++) {
            extremes->at[d][slot] = extremes->at[d][last];
        }
    }
    slot = slot_of(extremes, moved);
    if (slot >= 0) {
        extremes->index[slot] = candidate;
    }
}

void laplacian_extremes_raise(struct laplacian *laplacian, struct extremes *extremes, const float *at)
{
    const float *places[LAPLACIAN_DIMENSIONS_MAX];
    for (int d = 0; d < LAPLACIAN_DIMENSIONS_MAX; d++) {
        places[d] = extremes->at[d];
    }
    laplacian->kernels->add(extremes->load, places, extremes->count, laplacian->def.dimensions, at);
    if (laplacian->environment) {
        laplacian->kernels->rise(extremes->load, extremes->rate, extremes->count);
    }
    measure(laplacian, extremes);
}

void laplacian_extremes_find(struct laplacian *laplacian, struct extremes *extremes)
{
    extremes->count = 0;
    /* The deepest are old, what stands out is new: so few have to be replaced. */
    for (int32_t i = 0; i < laplacian->candidates; i++) {
        int32_t candidate = extremes->deep ? i : laplacian->candidates - 1 - i;
        float load = laplacian->load[candidate];
        bool full = extremes->count == EXTREMES;
        if (!full || (extremes->deep ? load > extremes->least : load < extremes->most)) {
            laplacian_extremes_consider(laplacian, extremes, candidate, load);
        }
    }
    for (int32_t i = 0; i < extremes->count; i++) {
        float at[LAPLACIAN_DIMENSIONS_MAX];
        laplacian_candidate_at(laplacian, extremes->index[i], at);
        extremes->load[i] = laplacian_load_now(laplacian, at, extremes->rate[i]);
    }
    measure(laplacian, extremes);
}
