/* Sweeps work in place, and runs in any order, so what a run reads beyond its own cells must be saved before anybody
 * writes. A halo: the rows above, then below, `levels` deep and as wide as the run's span; then the columns left and
 * right, `levels` wide. Columns further out are computed from whatever the ring holds: stale values spread by a cell a
 * level and never reach the run. */
#include <string.h>

#include "painting_state.h"

struct halo_shape {
    int top, bottom;  /* rows above and below */
    int left, right;  /* columns */
    size_t row, side; /* floats of one row; of one row of columns */
};

static struct halo_shape shape_of(const struct painting *painting, const struct halo_layout *layout,
                                  const struct run *run)
{
    struct span span = run_span(painting, run);
    int below = painting->height - run->y1;
    struct halo_shape shape = {
        .top = run->y0 < layout->levels ? run->y0 : layout->levels,
        .bottom = below < layout->levels ? below : layout->levels,
        .left = run->x0 == 0 ? 0 : layout->levels,
        .right = run->x1 >= painting->width ? 0 : layout->levels,
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

bool halo_place(struct painting *painting, const struct halo_layout *layout)
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

void halo_save(const struct painting *painting, const struct halo_layout *layout, const struct run *run)
{
    struct halo_shape shape = shape_of(painting, layout, run);
    struct span span = run_span(painting, run);
    float *to = painting->halo + run->halo;
    int width = span.to - span.from, stride = painting->stride;
    for (int y = run->y0 - shape.top; y < run->y1 + shape.bottom; y++) {
        const float *from = stored_row(painting, layout, y);
        if (y < run->y0 || y >= run->y1) {
            for (int field = 0; field < layout->fields; field++, to += width, from += stride) {
                copy(to, from + span.from, width);
            }
            continue;
        }
        if (shape.side == 0) {
            continue;
        }
        for (int field = 0; field < layout->fields; field++, from += stride) {
            copy(to, from + run->x0 - shape.left, shape.left);
            to += shape.left;
            copy(to, from + run->x1, shape.right);
            to += shape.right;
        }
    }
}

void halo_load(const struct painting *painting, const struct halo_layout *layout, const struct run *run, int y,
               float *ring)
{
    struct halo_shape shape = shape_of(painting, layout, run);
    struct span span = run_span(painting, run);
    int width = span.to - span.from, stride = painting->stride;
    const float *saved = painting->halo + run->halo;
    if (y < run->y0) {
        saved += shape.row * (size_t)(y - (run->y0 - shape.top));
    } else if (y >= run->y1) {
        saved += shape.row * (size_t)(shape.top + y - run->y1) + shape.side * (size_t)(run->y1 - run->y0);
    } else {
        int lead = run->x0 - span.from, inside = run->x1 >= painting->width ? width - lead : run->x1 - run->x0;
        const float *from = stored_row(painting, layout, y) + run->x0;
        saved += shape.row * (size_t)shape.top + shape.side * (size_t)(y - run->y0);
        for (int field = 0; field < layout->fields; field++, ring += RING, from += stride) {
            copy(ring + lead - shape.left, saved, shape.left);
            copy(ring + lead, from, inside);
            copy(ring + lead + inside, saved + shape.left, shape.right);
            saved += shape.left + shape.right;
        }
        return;
    }
    for (int field = 0; field < layout->fields; field++, ring += RING, saved += width) {
        copy(ring, saved, width);
    }
}
