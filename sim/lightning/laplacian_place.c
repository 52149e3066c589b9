/* Where charges and candidates are. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "laplacian_state.h"
#include "random.h"

static const float SPACING = 0.7f; /* of what lies off the grid: cells are smaller there, so that each holds one */
enum { TRIES_A_DIMENSION = 2 };

void laplacian_candidate_at(const struct laplacian *laplacian, int32_t candidate, float *at)
{
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        at[d] = laplacian->at[d][candidate];
    }
}

void laplacian_cell_of(const struct laplacian *laplacian, const float *at, int32_t *cell)
{
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        cell[d] = (int32_t)floorf(at[d] * laplacian->cells_a_unit + 0.5f);
    }
}

float laplacian_green(const struct laplacian *laplacian, const float *a, const float *b)
{
    float squared = 0;
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        squared += (a[d] - b[d]) * (a[d] - b[d]);
    }
    float inverse = 1 / sqrtf(squared > 0.25f ? squared : 0.25f), green = inverse;
    for (int d = 3; d < laplacian->def.dimensions; d++) {
        green *= inverse;
    }
    return green;
}

bool laplacian_allows(const struct laplacian *laplacian, const float *at)
{
    if (!laplacian->def.mask.values) {
        return true;
    }
    const struct action_raster *mask = &laplacian->def.mask;
    float half = 0.5f * laplacian->def.span, high = half * (float)mask->height / (float)mask->width;
    return fabsf(at[0]) <= half && fabsf(at[1]) <= high && laplacian_raster(laplacian, mask, at) >= 0.5f;
}

/* Room for one more in each of `count` arrays of floats or int32_t; `arrays` are the addresses of what points to them.
 */
static bool widen(void *arrays[], int count, int32_t have, int32_t *room, size_t *bytes)
{
    if (have < *room) {
        return true;
    }
    int32_t wide = (int32_t)(((int64_t)*room * 5 / 4 + 1024) / 16 * 16);
    for (int i = 0; i < count; i++) {
        void *memory;
        memcpy(&memory, arrays[i], sizeof memory);
        memory = realloc(memory, (size_t)wide * sizeof(float));
        if (!memory) {
            return false;
        }
        memset((float *)memory + *room, 0, (size_t)(wide - *room) * sizeof(float));
        memcpy(arrays[i], &memory, sizeof memory);
    }
    *bytes += (size_t)count * (size_t)(wide - *room) * sizeof(float);
    *room = wide;
    return true;
}

int32_t laplacian_put(struct laplacian *laplacian, const float *at, int32_t parent, float potential)
{
    void *arrays[LAPLACIAN_DIMENSIONS_MAX + 2] = {NULL};
    int count = 0;
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        arrays[count++] = &laplacian->places[d];
    }
    arrays[count++] = &laplacian->potential;
    arrays[count++] = &laplacian->parent;
    int32_t cell[LAPLACIAN_DIMENSIONS_MAX] = {0}, node = laplacian->count;
    laplacian_cell_of(laplacian, at, cell);
    int32_t *there = laplacian_cells_make(&laplacian->cells, cell);
    if (!there || !widen(arrays, count, node, &laplacian->room, &laplacian->bytes)) {
        return -1;
    }
    if (laplacian->fast && !laplacian_tree_insert(&laplacian->tree, at)) {
        return -1;
    }
    *there = -(node + 1);
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        laplacian->places[d][node] = at[d];
    }
    laplacian->potential[node] = potential;
    laplacian->parent[node] = parent;
    laplacian->count++;
    return node;
}

static bool add_candidate(struct laplacian *laplacian, const float *at, int32_t parent, int32_t *there)
{
    void *arrays[LAPLACIAN_DIMENSIONS_MAX + 3] = {NULL};
    int count = 0;
    int32_t index = laplacian->candidates;
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        arrays[count++] = &laplacian->at[d];
    }
    arrays[count++] = &laplacian->load;
    arrays[count++] = &laplacian->from;
    if (laplacian->environment) {
        arrays[count++] = &laplacian->rate;
    }
    if (!widen(arrays, count, index, &laplacian->candidate_room, &laplacian->bytes) ||
        !laplacian_weights_room(&laplacian->weights, laplacian->candidate_room)) {
        return false;
    }
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        laplacian->at[d][index] = at[d];
    }
    laplacian->from[index] = parent;
    if (laplacian->environment) {
        laplacian->rate[index] = laplacian_rate(laplacian, at);
    }
    laplacian->candidates++;
    *there = index + 1;
    laplacian->load[index] = 0;
    laplacian_note(laplacian, index);
    return true;
}

/* Uniform in 0..1 by what it is for. */
static float unit(const struct laplacian *laplacian, const int32_t *cell, int which)
{
    uint32_t bits = (uint32_t)laplacian->def.seed * 0x9e3779b9u + (uint32_t)which;
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        bits = random_mix(bits ^ ((uint32_t)cell[d] * 0x85ebca6bu + (uint32_t)d));
    }
    return (float)(bits >> 8) * (1.0f / 16777216.0f);
}

static bool is_within(const struct laplacian *laplacian, const int32_t *cell)
{
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        if (abs(cell[d]) >= laplacian->limit) {
            return false;
        }
    }
    return true;
}

/* The next cell of those within `reach` on all sides; false after the last. */
static bool next_cell(int32_t *step, int dimensions, int reach)
{
    for (int d = 0; d < dimensions; d++) {
        if (++step[d] <= reach) {
            return true;
        }
        step[d] = -reach;
    }
    return false;
}

static bool surround_on_grid(struct laplacian *laplacian, int32_t node)
{
    int32_t middle[LAPLACIAN_DIMENSIONS_MAX] = {0}, step[LAPLACIAN_DIMENSIONS_MAX] = {0},
            cell[LAPLACIAN_DIMENSIONS_MAX] = {0};
    int dimensions = laplacian->def.dimensions;
    float at[LAPLACIAN_DIMENSIONS_MAX] = {0};
    for (int d = 0; d < dimensions; d++) {
        at[d] = laplacian->places[d][node];
        step[d] = -1;
    }
    laplacian_cell_of(laplacian, at, middle);
    do {
        for (int d = 0; d < dimensions; d++) {
            cell[d] = middle[d] + step[d];
        }
        const int32_t *found = laplacian_cells_find(&laplacian->cells, cell);
        if ((found && *found != LAPLACIAN_CELL_FREE) || !is_within(laplacian, cell)) {
            continue;
        }
        for (int d = 0; d < dimensions; d++) {
            at[d] = (float)cell[d] + laplacian->def.jitter * (unit(laplacian, cell, d) - 0.5f);
        }
        if (laplacian_allows(laplacian, at)) {
            int32_t *there = laplacian_cells_make(&laplacian->cells, cell);
            if (!there || !add_candidate(laplacian, at, node, there)) {
                return false;
            }
        }
    } while (next_cell(step, dimensions, 1));
    return true;
}

/* Nothing lies nearer than SPACING. */
static bool is_free(struct laplacian *laplacian, const float *at, const int32_t *middle)
{
    int32_t step[LAPLACIAN_DIMENSIONS_MAX] = {0}, cell[LAPLACIAN_DIMENSIONS_MAX] = {0};
    int dimensions = laplacian->def.dimensions, reach = (int)(SPACING * laplacian->cells_a_unit) + 1;
    for (int d = 0; d < dimensions; d++) {
        step[d] = -reach;
    }
    do {
        for (int d = 0; d < dimensions; d++) {
            cell[d] = middle[d] + step[d];
        }
        const int32_t *there = laplacian_cells_find(&laplacian->cells, cell);
        if (there && *there != LAPLACIAN_CELL_FREE) {
            int32_t index = *there > 0 ? *there - 1 : -*there - 1;
            float squared = 0;
            for (int d = 0; d < dimensions; d++) {
                float by = (*there > 0 ? laplacian->at[d][index] : laplacian->places[d][index]) - at[d];
                squared += by * by;
            }
            if (squared < SPACING * SPACING) {
                return false;
            }
        }
    } while (next_cell(step, dimensions, reach));
    return true;
}

/* A direction, evenly distributed: a place in the ball that a cube holds, by rejection. */
static bool direction(const struct laplacian *laplacian, const int32_t *middle, int try, float *way)
{
    for (int again = 0; again < 256; again++) {
        float squared = 0;
        for (int d = 0; d < laplacian->def.dimensions; d++) {
            way[d] = 2 * unit(laplacian, middle, (try * 256 + again) * LAPLACIAN_DIMENSIONS_MAX + d) - 1;
            squared += way[d] * way[d];
        }
        if (squared > 0.01f && squared <= 1) {
            float scale = 1 / sqrtf(squared);
            for (int d = 0; d < laplacian->def.dimensions; d++) {
                way[d] *= scale;
            }
            return true;
        }
    }
    return false;
}

/* As the paper's conclusion suggests: neighbours in any direction. */
static bool surround_off_grid(struct laplacian *laplacian, int32_t node)
{
    int32_t middle[LAPLACIAN_DIMENSIONS_MAX] = {0}, cell[LAPLACIAN_DIMENSIONS_MAX] = {0};
    float centre[LAPLACIAN_DIMENSIONS_MAX] = {0}, at[LAPLACIAN_DIMENSIONS_MAX] = {0},
          way[LAPLACIAN_DIMENSIONS_MAX] = {0};
    int dimensions = laplacian->def.dimensions, tries = 3;
    for (int d = 0; d < dimensions; d++) {
        centre[d] = laplacian->places[d][node];
        tries *= TRIES_A_DIMENSION;
    }
    laplacian_cell_of(laplacian, centre, middle);
    for (int try = 0; try < tries; try++) {
        if (!direction(laplacian, middle, try, way)) {
            continue;
        }
        for (int d = 0; d < dimensions; d++) {
            at[d] = centre[d] + way[d];
        }
        laplacian_cell_of(laplacian, at, cell);
        if (is_within(laplacian, cell) && laplacian_allows(laplacian, at) && is_free(laplacian, at, cell)) {
            int32_t *there = laplacian_cells_make(&laplacian->cells, cell);
            if (!there || !add_candidate(laplacian, at, node, there)) {
                return false;
            }
        }
    }
    return true;
}

bool laplacian_surround(struct laplacian *laplacian, int32_t node)
{
    return laplacian->def.off_grid ? surround_off_grid(laplacian, node) : surround_on_grid(laplacian, node);
}

void laplacian_remove(struct laplacian *laplacian, int32_t candidate)
{
    int32_t last = laplacian->candidates - 1, cell[LAPLACIAN_DIMENSIONS_MAX];
    float at[LAPLACIAN_DIMENSIONS_MAX] = {0};
    laplacian_forget(laplacian, candidate, last);
    laplacian_candidate_at(laplacian, candidate, at);
    laplacian_cell_of(laplacian, at, cell);
    int32_t *there = laplacian_cells_find(&laplacian->cells, cell);
    *there = LAPLACIAN_CELL_FREE;
    if (candidate != last) {
        laplacian_candidate_at(laplacian, last, at);
        laplacian_cell_of(laplacian, at, cell);
        there = laplacian_cells_find(&laplacian->cells, cell);
        *there = candidate + 1;
        for (int d = 0; d < laplacian->def.dimensions; d++) {
            laplacian->at[d][candidate] = laplacian->at[d][last];
        }
        laplacian->load[candidate] = laplacian->load[last];
        laplacian->from[candidate] = laplacian->from[last];
        if (laplacian->environment) {
            laplacian->rate[candidate] = laplacian->rate[last];
        }
    }
    laplacian->candidates--;
}

int laplacian_neighbours(struct laplacian *laplacian, const float *at, int32_t *candidates)
{
    int32_t middle[LAPLACIAN_DIMENSIONS_MAX] = {0}, step[LAPLACIAN_DIMENSIONS_MAX] = {0},
            cell[LAPLACIAN_DIMENSIONS_MAX] = {0};
    int dimensions = laplacian->def.dimensions, count = 0;
    laplacian_cell_of(laplacian, at, middle);
    for (int d = 0; d < dimensions; d++) {
        step[d] = -1;
    }
    do {
        for (int d = 0; d < dimensions; d++) {
            cell[d] = middle[d] + step[d];
        }
        const int32_t *there = laplacian_cells_find(&laplacian->cells, cell);
        if (there && *there > 0) {
            candidates[count++] = *there - 1;
        }
    } while (next_cell(step, dimensions, 1));
    return count;
}
