/* Inside of Gray-Scott, for its own files and for the GPU, which takes the same maps. */
#ifndef FROND_GRAY_SCOTT_STATE_H
#define FROND_GRAY_SCOTT_STATE_H

#include "gray_scott.h"
#include "gray_scott_kernel.h"
#include "team.h"

enum {
    CHEMISTRY_LEAD = 32,  /* floats before the first cell of a row and after the last */
    CHEMISTRY_HALO = 16,  /* of them filled from across the border, so that so many steps can be made at once */
    CHEMISTRY_BLOCK = 8,  /* steps in one pass over memory */
    CHEMISTRY_RUN = 1024, /* cells of a run: the rows between steps stay in the cache */
    CHEMISTRY_RING = CHEMISTRY_RUN + 2 * CHEMISTRY_LEAD + 16, /* floats; not a power of two */
    CHEMISTRY_REFRESH = 32, /* steps for which noise that moves stays: a multiple of CHEMISTRY_BLOCK */
    CHEMISTRY_LATTICE = 8,  /* cells between the points at which noise is made; linear in between */
};

enum chemistry_map { MAP_FEED, MAP_LOSS, MAP_RATE, MAP_ALONG, MAP_ACROSS, MAP_MOVE_X, MAP_MOVE_Y, CHEMISTRY_MAPS };
enum chemistry_noise { NOISE_OF_FEED, NOISE_OF_KILL, NOISE_OF_X, NOISE_OF_Y, CHEMISTRY_NOISES };

struct gray_scott {
    struct gray_scott_def def;
    int width, height, stride; /* cells; floats from row to row */
    int current;               /* which of the two planes of each chemical is now */
    int64_t steps;
    int64_t maps_at;                  /* the step whose maps they are; -1: to be made */
    float *u[2], *v[2];               /* whole planes; a cell is at plane_at */
    float *maps[CHEMISTRY_MAPS];      /* laid out as planes; NULL until wanted */
    float *style, *field;             /* width * height brightness of feed (and rates), then of kill; twice that of
                                    vectors; NULL: none */
    float *lattice[CHEMISTRY_NOISES]; /* lattice_width * lattice_height; NULL until wanted */
    int lattice_width, lattice_height;
    float *rings; /* of each member of the team */
    const struct gray_scott_kernels *kernels;
    struct team *team;
    size_t bytes;
};

static inline float *plane_row(const struct gray_scott *chemistry, float *plane, int y)
{
    return plane + (size_t)y * (size_t)chemistry->stride + CHEMISTRY_LEAD;
}

/* What the parameters ask of a step. */
bool chemistry_whole(const struct gray_scott *chemistry);  /* rate, orientation */
bool chemistry_mapped(const struct gray_scott *chemistry); /* feed and kill by cell */
bool chemistry_displaced(const struct gray_scott *chemistry);
bool chemistry_moving(const struct gray_scott *chemistry); /* noise that changes with time */
struct gray_scott_rates chemistry_rates(const struct gray_scott_def *def);

/* Room for the maps that are wanted. False when memory is short. */
bool chemistry_take_maps(struct gray_scott *chemistry);
/* Makes the maps of the step that comes next, if they are not those that are there. True if they are new. */
bool chemistry_make_maps(struct gray_scott *chemistry);
/* The cell that counts where a row or column lies beyond the border. */
int chemistry_wrap(int boundary, int at, int size);
/* Bilinear, clamped at the border; x and y in 0..1 of the sheet. */
float chemistry_sample(const struct action_raster *raster, int channel, float x, float y);

#endif
