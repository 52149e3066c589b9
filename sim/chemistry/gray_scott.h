/* Gray-Scott: two chemicals that react and diffuse (Pearson, "Complex patterns in a simple system", Science 261, 1993;
 * "Reaction diffusion on shader", 2019, the article below).
 *     du/dt = r_u lap u - u v^2 + f (1 - u)
 *     dv/dt = r_v lap v + u v^2 - (f + k) v
 * by explicit Euler steps on square cells of side 1. Concentrations are in 0..1; rates are per unit of time. The same
 * input gives the same bits for every number of threads, every width of vectors, on every machine. */
#ifndef FROND_GRAY_SCOTT_H
#define FROND_GRAY_SCOTT_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"
#include "rectangle.h"
#include "vectors.h"

enum { GRAY_SCOTT_SIZE_MAX = 8192 }; /* cells a side */

enum gray_scott_stencil {
    LAPLACIAN_NINE,    /* the Laplacian of nine points: (4 axes + diagonals - 20) / 6 */
    LAPLACIAN_ARTICLE, /* 0.2 axes + 0.05 diagonals - 1: the same times 0.3 */
    LAPLACIAN_FIVE,    /* axes - 4, as Pearson had it */
    LAPLACIANS,
};
enum gray_scott_boundary {
    BOUNDARY_PERIODIC, /* what leaves on one side enters on the other */
    BOUNDARY_NO_FLUX,  /* nothing crosses the border */
    BOUNDARIES,
};
extern const char *const gray_scott_stencil_names[LAPLACIANS + 1];  /* ends with NULL */
extern const char *const gray_scott_boundary_names[BOUNDARIES + 1]; /* ends with NULL */

/* The table gray_scott_keys says units, ranges and defaults. */
struct gray_scott_def {
    float feed, kill, diffusion_u, diffusion_v;
    float time_step; /* at most: less where diffusion would not be stable (gray_scott_time_step) */
    float size;      /* diffusion is multiplied by its square */
    int stencil, boundary;
    float anisotropy_u, anisotropy_v; /* diffusion along the orientation is 1 + this, across 1 - this times the rate */
    float orientation;                /* degrees, from the x axis towards y (down) */
    float noise_feed, noise_kill;     /* of 3D simplex noise -1..1, added (article, figures 5 and 6) */
    float noise_size, noise_speed, noise_offset;
    float displacement;                       /* cells a step (article, figure 7) */
    float style_feed, style_kill, style_rate; /* what a light place of the style map adds */
    int seed;
};
extern const struct key gray_scott_keys[]; /* of struct gray_scott_def; ends with a key whose name is NULL */
struct gray_scott_def gray_scott_default_def(void);
/* Numbers brought into the range of their keys. */
struct gray_scott_def gray_scott_legal(const struct gray_scott_def *def);
/* The time of one step: time_step, or less where diffusion would not be stable. */
float gray_scott_time_step(const struct gray_scott_def *def);

struct gray_scott;

/* A sheet of u = 1, v = 0. `threads` 0: one for each processor. NULL when memory is short or a side is not within
 * 1..GRAY_SCOTT_SIZE_MAX. */
struct gray_scott *gray_scott_create(int width, int height, const struct gray_scott_def *def, int threads,
                                     enum vectors vectors);
void gray_scott_destroy(struct gray_scott *chemistry); /* takes NULL */

/* Other parameters from now on, made legal. False when memory for maps is short: the old ones stay. */
bool gray_scott_set(struct gray_scott *chemistry, const struct gray_scott_def *def);
const struct gray_scott_def *gray_scott_get(const struct gray_scott *chemistry);
/* The style map: brightness 0..1 over the sheet, copied; without values: none. With two channels the second is that of
 * the kill rate. False when memory is short. */
bool gray_scott_style(struct gray_scott *chemistry, const struct action_raster *brightness);
/* Orientation of anisotropy: a vector field over the sheet, copied (a vector and its opposite are the same; none: no
 * anisotropy there); without values: the angle of the parameters. False when memory is short. */
bool gray_scott_orient(struct gray_scott *chemistry, const struct action_raster *field);

void gray_scott_step(struct gray_scott *chemistry, int64_t steps);
/* One step of the plainest code that does the same to the bit, to compare with. False, and no step, with anisotropy,
 * a map of rates or displacement. */
bool gray_scott_step_reference(struct gray_scott *chemistry);
int64_t gray_scott_steps(const struct gray_scott *chemistry);

int gray_scott_width(const struct gray_scott *chemistry);
int gray_scott_height(const struct gray_scott *chemistry);
/* A row of concentrations, `width` of them, until the next call that changes anything. */
const float *gray_scott_u(const struct gray_scott *chemistry, int y);
const float *gray_scott_v(const struct gray_scott *chemistry, int y);
/* width * height concentrations each, row by row; kept within 0..1. */
void gray_scott_load(struct gray_scott *chemistry, const float *u, const float *v);
void gray_scott_save(const struct gray_scott *chemistry, float *u, float *v);

/* Another sheet of so many cells with the same parameters and threads, after as many steps, its state bilinear between
 * the cells of this one; without style map and orientation. NULL when memory is short or a side out of range. */
struct gray_scott *gray_scott_resampled(const struct gray_scott *chemistry, int width, int height);

/* The same everywhere. u = 1, v = 0 is a fresh sheet. */
void gray_scott_fill(struct gray_scott *chemistry, float u, float v);
/* The other uniform state that lasts: u v = f + k, f (1 - u) = u v^2. False where there is none
 * (f < 4 (f + k)^2). */
bool gray_scott_blue_state(const struct gray_scott_def *def, float *u, float *v);
enum gray_scott_brush { CHEMISTRY_PAINT, CHEMISTRY_ERASE };
/* Along a path in 0..1 of the sheet, `radius` in cells, its edge soft over two cells. Paint brings the cells to u =
 * 1/2, v = 1/4 (Pearson's seed), erase to u = 1, v = 0; `strength` 0..1 of the way. One point: a disc. */
void gray_scott_stroke(struct gray_scott *chemistry, const struct action_path *path, float radius,
                       enum gray_scott_brush brush, float strength);
struct gray_scott_state {
    float u, v;
};
/* Each cell of an area (within the sheet) is brought to a state by a share, 0..1 of the way, which is asked for row by
 * row. */
void gray_scott_bring(struct gray_scott *chemistry, struct rectangle area, float (*share)(void *context, int x, int y),
                      void *context, struct gray_scott_state to);
/* What a brush brings cells to, and the cells it may reach; none where x1 <= x0. */
struct gray_scott_state gray_scott_brush_state(enum gray_scott_brush brush);
struct rectangle gray_scott_stroke_area(const struct gray_scott *chemistry, const struct action_path *path,
                                        float radius);
/* Where the spot of that number falls, 0..1 of the sheet. */
struct point gray_scott_seed_place(int number, uint32_t seed);
/* First states, over what is there: `count` discs at those places, of a radius in cells; grains at random, a share of
 * the cells, each painted half and more; a mask, painted where it is light (or dark), as text and pictures give it. */
void gray_scott_seed_spots(struct gray_scott *chemistry, int count, float radius, uint32_t seed);
void gray_scott_seed_noise(struct gray_scott *chemistry, float share, uint32_t seed);
void gray_scott_seed_mask(struct gray_scott *chemistry, const struct action_raster *mask, bool dark);

#endif
