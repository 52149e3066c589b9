#include "gray_scott.h"

#include <stdlib.h>
#include <string.h>

#include "gray_scott_state.h"
#include "memory.h"

enum { RING_ROWS = 4, CHEMICALS = 2 };
/* Floats of one member: rows between steps, and the sums of a row. */
#define MEMBER_FLOATS ((size_t)((CHEMISTRY_BLOCK - 1) * RING_ROWS * CHEMICALS + CHEMICALS) * CHEMISTRY_RING)

struct gray_scott *gray_scott_create(int width, int height, const struct gray_scott_def *def, int threads,
                                     enum vectors vectors)
{
    if (width < 1 || height < 1 || width > GRAY_SCOTT_SIZE_MAX || height > GRAY_SCOTT_SIZE_MAX) {
        return NULL;
    }
    struct gray_scott *chemistry = calloc(1, sizeof *chemistry);
    if (!chemistry) {
        return NULL;
    }
    chemistry->width = width;
    chemistry->height = height;
    chemistry->stride = (width + 15) / 16 * 16 + 2 * CHEMISTRY_LEAD;
    chemistry->maps_at = -1;
    chemistry->kernels = VECTORS_COPY(gray_scott_kernels, vectors);
    chemistry->team = team_create(threads);
    bool good = chemistry->team != NULL;
    size_t cells = (size_t)chemistry->stride * (size_t)height;
    for (int i = 0; i < 2 && good; i++) {
        chemistry->u[i] = memory_take(cells, sizeof(float), &chemistry->bytes);
        chemistry->v[i] = memory_take(cells, sizeof(float), &chemistry->bytes);
        good = chemistry->u[i] && chemistry->v[i];
    }
    if (good) {
        chemistry->rings =
            memory_take((size_t)team_size(chemistry->team) * MEMBER_FLOATS, sizeof(float), &chemistry->bytes);
        good = chemistry->rings && gray_scott_set(chemistry, def);
    }
    if (!good) {
        gray_scott_destroy(chemistry);
        return NULL;
    }
    gray_scott_fill(chemistry, 1, 0);
    return chemistry;
}

void gray_scott_destroy(struct gray_scott *chemistry)
{
    if (!chemistry) {
        return;
    }
    team_destroy(chemistry->team);
    for (int i = 0; i < 2; i++) {
        free(chemistry->u[i]);
        free(chemistry->v[i]);
    }
    for (int i = 0; i < CHEMISTRY_MAPS; i++) {
        free(chemistry->maps[i]);
    }
    for (int i = 0; i < CHEMISTRY_NOISES; i++) {
        free(chemistry->lattice[i]);
    }
    free(chemistry->style);
    free(chemistry->field);
    free(chemistry->rings);
    free(chemistry);
}

bool gray_scott_set(struct gray_scott *chemistry, const struct gray_scott_def *def)
{
    struct gray_scott_def old = chemistry->def;
    chemistry->def = gray_scott_legal(def);
    if (!chemistry_take_maps(chemistry)) {
        chemistry->def = old;
        return false;
    }
    chemistry->maps_at = -1;
    return true;
}

const struct gray_scott_def *gray_scott_get(const struct gray_scott *chemistry)
{
    return &chemistry->def;
}

int64_t gray_scott_steps(const struct gray_scott *chemistry)
{
    return chemistry->steps;
}

int gray_scott_width(const struct gray_scott *chemistry)
{
    return chemistry->width;
}

int gray_scott_height(const struct gray_scott *chemistry)
{
    return chemistry->height;
}

const float *gray_scott_u(const struct gray_scott *chemistry, int y)
{
    return plane_row(chemistry, chemistry->u[chemistry->current], y);
}

const float *gray_scott_v(const struct gray_scott *chemistry, int y)
{
    return plane_row(chemistry, chemistry->v[chemistry->current], y);
}

int chemistry_wrap(int boundary, int at, int size)
{
    if (at >= 0 && at < size) {
        return at;
    }
    int period = boundary == BOUNDARY_PERIODIC ? size : 2 * size;
    int place = at % period;
    place = place < 0 ? place + period : place;
    return place < size ? place : period - 1 - place;
}

/* Cells beyond the left and right border, from across it or mirrored: as both stencils are symmetric, mirrored cells
 * stay the mirror of those within, step by step, and nothing crosses. */
static void fill_halo(const struct gray_scott *chemistry, float *plane)
{
    int width = chemistry->width, boundary = chemistry->def.boundary;
    int from[2 * CHEMISTRY_HALO];
    for (int i = 0; i < CHEMISTRY_HALO; i++) {
        from[i] = chemistry_wrap(boundary, i - CHEMISTRY_HALO, width);
        from[CHEMISTRY_HALO + i] = chemistry_wrap(boundary, width + i, width);
    }
    for (int y = 0; y < chemistry->height; y++) {
        float *row = plane_row(chemistry, plane, y);
        for (int i = 0; i < CHEMISTRY_HALO; i++) {
            row[i - CHEMISTRY_HALO] = row[from[i]];
            row[width + i] = row[from[CHEMISTRY_HALO + i]];
        }
    }
}

struct pass {
    struct gray_scott *chemistry;
    struct gray_scott_rates rates;
    int steps, runs, bands;
    bool displace, mapped;
    void (*kernel)(const struct gray_scott_rates *, const struct gray_scott_row *);
};

struct run {
    const struct pass *pass;
    float *rings;
    int x, cells;
};

static float *ring_row(const struct run *run, int step, int chemical, int y)
{
    int row = ((step - 1) * RING_ROWS + (y & (RING_ROWS - 1))) * CHEMICALS + chemical;
    return run->rings + (size_t)row * CHEMISTRY_RING + CHEMISTRY_LEAD;
}

/* The maps of row y from column x on. */
static void set_maps(const struct gray_scott *chemistry, int y, int x, struct gray_scott_row *row)
{
    const float *maps[CHEMISTRY_MAPS];
    for (int i = 0; i < CHEMISTRY_MAPS; i++) {
        maps[i] = chemistry->maps[i] ? plane_row(chemistry, chemistry->maps[i], y) + x : NULL;
    }
    row->feed = maps[MAP_FEED];
    row->loss = maps[MAP_LOSS];
    row->rate = maps[MAP_RATE];
    row->along = maps[MAP_ALONG];
    row->across = maps[MAP_ACROSS];
    row->move_x = maps[MAP_MOVE_X];
    row->move_y = maps[MAP_MOVE_Y];
}

/* Row y of step `step` of the pass, from three rows of the step before. */
static void step_row(const struct run *run, int step, int y)
{
    const struct pass *pass = run->pass;
    const struct gray_scott *chemistry = pass->chemistry;
    bool last = step == pass->steps;
    int boundary = chemistry->def.boundary, own = chemistry_wrap(boundary, y, chemistry->height);
    int here = chemistry->current;
    struct gray_scott_row row = {.begin = last ? 0 : -CHEMISTRY_HALO,
                                 .end = last ? run->cells : run->cells + CHEMISTRY_HALO};
    for (int i = 0; i < 3; i++) {
        if (step == 1) {
            int from = chemistry_wrap(boundary, y + i - 1, chemistry->height);
            row.u[i] = plane_row(chemistry, chemistry->u[here], from) + run->x;
            row.v[i] = plane_row(chemistry, chemistry->v[here], from) + run->x;
        } else {
            row.u[i] = ring_row(run, step - 1, 0, y + i - 1);
            row.v[i] = ring_row(run, step - 1, 1, y + i - 1);
        }
    }
    row.u_out = last ? plane_row(chemistry, chemistry->u[!here], y) + run->x : ring_row(run, step, 0, y);
    row.v_out = last ? plane_row(chemistry, chemistry->v[!here], y) + run->x : ring_row(run, step, 1, y);
    row.u_sums = ring_row(run, CHEMISTRY_BLOCK, 0, 0);
    row.v_sums = ring_row(run, CHEMISTRY_BLOCK, 1, 0);
    if (pass->mapped) {
        set_maps(chemistry, own, run->x, &row);
    }
    if (pass->displace) {
        chemistry->kernels->displace(&row);
    } else {
        pass->kernel(&pass->rates, &row);
    }
}

/* All steps of the pass over a run of columns and a band of rows: each row of a step as soon as the three of the step
 * before are there, so that all rows between stay in the cache. Rows and columns at the rim are made by both
 * neighbours. */
static void step_piece(void *context, int piece, int member)
{
    const struct pass *pass = context;
    const struct gray_scott *chemistry = pass->chemistry;
    int band = piece / pass->runs, steps = pass->steps;
    struct run run = {.pass = pass, .rings = chemistry->rings + (size_t)member * MEMBER_FLOATS};
    int wide = (chemistry->width + 15) / 16 * 16;
    run.x = piece % pass->runs * CHEMISTRY_RUN;
    run.cells = wide - run.x < CHEMISTRY_RUN ? wide - run.x : CHEMISTRY_RUN;
    int top = (int)((int64_t)chemistry->height * band / pass->bands);
    int bottom = (int)((int64_t)chemistry->height * (band + 1) / pass->bands);
    for (int lead = top - (steps - 1); lead < bottom + steps - 1; lead++) {
        for (int step = 1; step <= steps; step++) {
            int y = lead - (step - 1), beyond = steps - step;
            if (y >= top - beyond && y < bottom + beyond) {
                step_row(&run, step, y);
            }
        }
    }
}

static void make_pass(struct gray_scott *chemistry, int steps, bool displace)
{
    const struct gray_scott_kernels *kernels = chemistry->kernels;
    struct pass pass = {
        .chemistry = chemistry, .rates = chemistry_rates(&chemistry->def), .steps = steps, .displace = displace};
    pass.kernel = chemistry_whole(chemistry)    ? kernels->whole
                  : chemistry_mapped(chemistry) ? kernels->plain
                                                : kernels->uniform;
    pass.mapped = displace || pass.kernel != kernels->uniform;
    pass.runs = (chemistry->width + CHEMISTRY_RUN - 1) / CHEMISTRY_RUN;
    int members = team_size(chemistry->team), most = (chemistry->height + 63) / 64;
    pass.bands = members == 1 ? 1 : (2 * members + pass.runs - 1) / pass.runs;
    pass.bands = pass.bands < most ? pass.bands : most;
    fill_halo(chemistry, chemistry->u[chemistry->current]);
    fill_halo(chemistry, chemistry->v[chemistry->current]);
    team_run(chemistry->team, step_piece, &pass, pass.runs * pass.bands);
    chemistry->current = !chemistry->current;
}

/* Steps that can be made in one pass: maps may change, turned and displaced cells are no mirror of one another. */
static int steps_at_once(const struct gray_scott *chemistry, int64_t left)
{
    int64_t most = chemistry_whole(chemistry) || chemistry_displaced(chemistry) ? 1 : CHEMISTRY_BLOCK;
    if (chemistry_moving(chemistry)) {
        int64_t until = CHEMISTRY_REFRESH - chemistry->steps % CHEMISTRY_REFRESH;
        most = most < until ? most : until;
    }
    return (int)(left < most ? left : most);
}

void gray_scott_step(struct gray_scott *chemistry, int64_t steps)
{
    while (steps > 0) {
        if (chemistry_make_maps(chemistry) && chemistry->maps[MAP_FEED]) {
            fill_halo(chemistry, chemistry->maps[MAP_FEED]);
            fill_halo(chemistry, chemistry->maps[MAP_LOSS]);
        }
        int count = steps_at_once(chemistry, steps);
        if (chemistry_displaced(chemistry)) {
            make_pass(chemistry, 1, true);
        }
        make_pass(chemistry, count, false);
        chemistry->steps += count;
        steps -= count;
    }
}
