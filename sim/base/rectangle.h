/* Cells [x0, x1) x [y0, y1) of a sheet, margin included. */
#ifndef FROND_RECTANGLE_H
#define FROND_RECTANGLE_H

#include <stdbool.h>

struct rectangle {
    int x0, x1, y0, y1;
};

static inline bool rectangle_is_empty(struct rectangle rectangle)
{
    return rectangle.x0 >= rectangle.x1 || rectangle.y0 >= rectangle.y1;
}

/* The least that holds both, neither of which is empty. */
static inline struct rectangle rectangle_join(struct rectangle a, struct rectangle b)
{
    return (struct rectangle){a.x0 < b.x0 ? a.x0 : b.x0, a.x1 > b.x1 ? a.x1 : b.x1, a.y0 < b.y0 ? a.y0 : b.y0,
                              a.y1 > b.y1 ? a.y1 : b.y1};
}

/* What of it lies on a sheet of width x height cells. */
static inline struct rectangle rectangle_clip(struct rectangle rectangle, int width, int height)
{
    return (struct rectangle){rectangle.x0 < 0 ? 0 : rectangle.x0, rectangle.x1 > width ? width : rectangle.x1,
                              rectangle.y0 < 0 ? 0 : rectangle.y0, rectangle.y1 > height ? height : rectangle.y1};
}

#endif
