/* Sweeps work in place, and runs in any order, so what a run reads beyond its own cells must be saved before anybody
 * writes, where it belongs to another run. A halo: the rows above, then below, `levels` deep and as wide as the run's
 * span; then the columns left and right, `levels` wide. Columns further out are computed from whatever the ring holds:
 * stale values spread by a cell a level and never reach the run. */
#include <string.h>

#include "painting_state.h"

struct halo_shape {
    int top, bottom;  /* rows saved above and below */
    int left, right;  /* columns saved */
    size_t row, side; /* floats of one row; of one row of columns */
};

static struct halo_shape shape_of(const struct painting *painting, const struct halo_layout *layout,
                                  const struct run *run)
{
    struct span span = run_span(painting, run);
    int below = painting->height - run->y1;
    int top = run->y0 < layout->levels ? run->y0 : layout->levels;
    int bottom = below < layout->levels ? below : layout->levels;
    struct halo_shape shape = {
        .top = run->guarded[SIDE_TOP] ? top : 0,
        .bottom = run->guarded[SIDE_BOTTOM] ? bottom : 0,
        .left = run->guarded[SIDE_LEFT] ? layout->levels : 0,
        .right = run->guarded[SIDE_RIGHT] ? layout->levels : 0,
        .row = (size_t)layout->fields * (size_t)(span.to - span.from),
    };
    shape.side = (size_t)layout->fields * (size_t)(shape.left + shape.right);
    return shape;
}

static size_t need_of(const struct painting *painting, const struct halo_layout *layout, const struct run *run)
{
    struct halo_shape shape = shape_of(painting, layout, run);
    return shape.row * (size_t)(shape.top + shape.bottom) + shape.side * (size_t)(run->y1 - run->y0);
}

size_t halo_need(const struct painting *painting, const struct halo_layout *layout)
{
    size_t need = 0;
    for (int i = 0; i < painting->tiles.run_count; i++) {
        need += need_of(painting, layout, &painting->tiles.runs[i]);
    }
    return need;
}

/* Gives each run its place; false when there is not enough room. */
static bool place(struct painting *painting, const struct halo_layout *layout)
{
    size_t at = 0;
    for (int i = 0; i < painting->tiles.run_count; i++) {
        painting->tiles.runs[i].halo = at;
        at += need_of(painting, layout, &painting->tiles.runs[i]);
    }
    return at <= painting->halo_floats;
}

static const float *stored_row(const struct painting *painting, const struct halo_layout *layout, int y)
{
    return layout->base + (size_t)y * (size_t)layout->fields * (size_t)painting->stride + SIDE;
}

static void copy(float *to, const float *from, int count)
{
    memcpy(to, from, (size_t)count * sizeof *to);
}

static void save(const struct painting *painting, const struct halo_layout *layout, const struct run *run)
{
    struct halo_shape shape = shape_of(painting, layout, run);
    struct span span = run_span(painting, run);
    float *to = painting->halo + run->halo;
    int width = span.to - span.from, stride = painting->stride;
    for (int row = 0; row < shape.top + shape.bottom; row++) {
        int y = row < shape.top ? run->y0 - shape.top + row : run->y1 + row - shape.top;
        const float *from = stored_row(painting, layout, y) + span.from;
        for (int field = 0; field < layout->fields; field++, to += width, from += stride) {
            copy(to, from, width);
        }
    }
    for (int y = run->y0; y < run->y1 && shape.side > 0; y++) {
        const float *from = stored_row(painting, layout, y);
        for (int field = 0; field < layout->fields; field++, from += stride) {
            copy(to, from + run->x0 - shape.left, shape.left);
            to += shape.left;
            copy(to, from + run->x1, shape.right);
            to += shape.right;
        }
    }
}

/* A row of the run itself: its own cells, and what lies left and right of them. */
static void load_level(const struct painting *painting, const struct halo_layout *layout, const struct run *run, int y,
                       float *ring)
{
    struct halo_shape shape = shape_of(painting, layout, run);
    struct span span = run_span(painting, run);
    const float *from = stored_row(painting, layout, y) + run->x0;
    const float *saved = painting->halo + run->halo + shape.row * (size_t)(shape.top + shape.bottom) +
                         shape.side * (size_t)(y - run->y0);
    int levels = layout->levels, lead = run->x0 - span.from, inside = span.to - span.from - lead, trail = 0;
    if (run->x1 < painting->width) {
        inside = run->x1 - run->x0;
        trail = levels;
    }
    ring += lead;
    for (int field = 0; field < layout->fields; field++, ring += RING, from += painting->stride) {
        if (lead > 0) {
            copy(ring - levels, shape.left > 0 ? saved : from - levels, levels);
        }
        copy(ring, from, inside);
        copy(ring + inside, shape.right > 0 ? saved + shape.left : from + inside, trail);
        saved += shape.left + shape.right;
    }
}

void halo_load(const struct painting *painting, const struct halo_layout *layout, const struct run *run, int y,
               float *ring)
{
    if (y >= run->y0 && y < run->y1) {
        load_level(painting, layout, run, y, ring);
        return;
    }
    struct halo_shape shape = shape_of(painting, layout, run);
    struct span span = run_span(painting, run);
    int width = span.to - span.from, apart = painting->stride;
    const float *from = stored_row(painting, layout, y) + span.from;
    if (y < run->y0 ? shape.top > 0 : shape.bottom > 0) {
        int row = y < run->y0 ? y - (run->y0 - shape.top) : shape.top + y - run->y1;
        from = painting->halo + run->halo + shape.row * (size_t)row;
        apart = width;
    }
    for (int field = 0; field < layout->fields; field++, ring += RING, from += apart) {
        copy(ring, from, width);
    }
}

struct saving {
    const struct painting *painting;
    const struct halo_layout *layout;
};

static void save_run(void *context, int piece, int member)
{
    const struct saving *saving = context;
    (void)member;
    save(saving->painting, saving->layout, &saving->painting->tiles.runs[piece]);
}

int halo_sweep(struct painting *painting, const struct sweep *sweep)
{
    struct tiles *tiles = &painting->tiles;
    tiles_wake(tiles, sweep->moves, sweep->cause, sweep->able, painting->def.dense);
    int awake = tiles->awake_count;
    if (!place(painting, &sweep->layout)) { /* too many small runs: the few large ones of a dense sheet always fit */
        tiles_wake(tiles, sweep->moves, sweep->cause, sweep->able, true);
        place(painting, &sweep->layout);
    }
    struct saving saving = {painting, &sweep->layout};
    team_run(painting->team, save_run, &saving, tiles->run_count);
    team_run(painting->team, sweep->work, sweep->context, tiles->run_count);
    return awake;
}
