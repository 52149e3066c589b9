/* The ground of a painting: what actions alone determine and no tick changes. Maps of the coefficients that vary over
 * the sheet, brushes stamped on them, guidance, obstacles. Every engine keeps one and does the same to it, so that all
 * of them grow on the same ground to the bit.
 * Rows are `stride` cells apart with GROUND_SIDE cells of room before and after; cells are counted with the margin. */
#ifndef FROND_GROUND_H
#define FROND_GROUND_H

#include "kernel.h"
#include "painting.h"
#include "rectangle.h"
#include "region.h"

enum { GROUND_SIDE = 16, GROUND_NEVER_STAMPED = 65535 };

enum obstacle { OBSTACLE_MASK = 1, OBSTACLE_LINE = 2 };

/* Coefficients that vary over the sheet, one map each in the units of kernel.h. */
enum map { MAP_ALPHA_A, MAP_XI, MAP_BETA_A, MAP_S_MAX, MAP_ALPHA_Y, MAPS };

struct ground {
    struct painting_def def; /* size and seed of the painting; the coefficients of now */
    int width, height;       /* cells, margin included */
    int stride;              /* cells from row to row */
    uint16_t *maps;          /* [height][MAPS][stride] */
    uint16_t *stamped;       /* [height][stride], distance to the drop whose brush a cell follows, 1/16 cell */
    uint8_t *weight;         /* [height][stride], diagonal weight of the stencil */
    int16_t *guide;          /* [height][2][stride], x right, y down */
    uint8_t *obstacle;       /* [height][stride], enum obstacle */
    size_t bytes;            /* taken */
};

/* Cells from row to row of a sheet `width` cells wide, margin included. */
int ground_stride(int width);

/* Fresh ground for a painting of this definition. NULL when memory is short. */
struct ground *ground_create(const struct painting_def *def);
void ground_destroy(struct ground *ground); /* takes NULL */
/* Everything but the memory. False when the sheets are not of one size. */
bool ground_copy(struct ground *to, const struct ground *from);
/* Rows [y0, y1) alone, between sheets of one size. */
void ground_copy_rows(struct ground *to, const struct ground *from, int y0, int y1);

/* Does an action's part on the ground; `action` is legal (action_legal). Returns the cells that may now be different,
 * an empty rectangle for none. Setting a coefficient that does not vary over the sheet concerns every cell. */
struct rectangle ground_act(struct ground *ground, const struct action *action);

/* Whether a coefficient (index into coefficient_keys[]) has a map; setting another one changes no cell of the ground.
 */
bool ground_varies(int coefficient);
/* A field that ground alone determines, PAINTING_GUIDE_U and later, of a cell. */
float ground_value(const struct ground *ground, enum painting_field field, int x, int y);

/* Maps from the coefficients of now, everywhere; forgets all stamps. */
void ground_fill(struct ground *ground);
/* The same for one cell, which loses its obstacles and guidance as well. Returns whether it was different. */
bool ground_fresh_cell(struct ground *ground, int x, int y);
/* The cell that a drop falls on: every drop covers the same cells around it. */
void ground_cell_of(const struct ground *ground, struct point at, int *x, int *y);
/* Whether any cell of a rectangle has an obstacle or guidance; a part of it beyond the sheet has none. */
bool ground_is_special(const struct ground *ground, struct rectangle cells);
/* Noise of a cell in units of its map, as ground_fill makes it from the coefficients of now. */
uint16_t ground_fresh_xi(const struct ground *ground, int x, int y);

/* For verbs (painting_verb.h). Does something to each cell within the bounds of the action's region; returns those. */
struct rectangle ground_each_cell(struct ground *ground, const struct action *action,
                                  void (*act)(struct ground *, const struct region *, int x, int y));
/* The same, ground_coefficients.c: a brush on the ground around a cell, `reach` cells far, and the `set` action.
 * Of a whole coefficient `set` keeps what is left of the point, where key_take would round: journals hold the values
 * that dials gave, and must come to the same painting. */
struct rectangle ground_stamp(struct ground *ground, int x, int y, int brush, float reach);
struct rectangle ground_set(struct ground *ground, const struct action *action);

/* First cell of a row. */
static inline uint16_t *ground_map(const struct ground *ground, enum map map, int y)
{
    return ground->maps + ((size_t)y * MAPS + (size_t)map) * (size_t)ground->stride + GROUND_SIDE;
}

static inline uint16_t *ground_stamped(const struct ground *ground, int y)
{
    return ground->stamped + (size_t)y * (size_t)ground->stride + GROUND_SIDE;
}

static inline uint8_t *ground_weight(const struct ground *ground, int y)
{
    return ground->weight + (size_t)y * (size_t)ground->stride + GROUND_SIDE;
}

static inline int16_t *ground_guide(const struct ground *ground, int axis, int y)
{
    return ground->guide + ((size_t)y * 2 + (size_t)axis) * (size_t)ground->stride + GROUND_SIDE;
}

static inline uint8_t *ground_obstacle(const struct ground *ground, int y)
{
    return ground->obstacle + (size_t)y * (size_t)ground->stride + GROUND_SIDE;
}

#endif
