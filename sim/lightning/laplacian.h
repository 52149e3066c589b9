/* Laplacian growth: lightning, coral, frost (Kim, Sewall, Sud and Lin, Fast Simulation of Laplacian Growth).
 *
 *     struct laplacian_def def = laplacian_default_def();
 *     enum laplacian_status status;
 *     struct laplacian *bolt = laplacian_create(&def, &status);
 *     while (laplacian_step(bolt, 1000) > 0) ...
 *
 * An aggregate of insulated point charges grows, a charge at a time, at one of its candidates, each as likely as its
 * normalised potential to the power of eta (eq. 10 to 13). Lengths are in cells, the diameter of a charge; x goes to
 * the right, y down, z away. The same definition gives the same aggregate on every machine. */
#ifndef FROND_LAPLACIAN_H
#define FROND_LAPLACIAN_H

#include <stddef.h>

#include "action.h"
#include "laplacian_cells.h"

enum laplacian_method {
    LAPLACIAN_AUTO,  /* exact while that is quicker */
    LAPLACIAN_EXACT, /* eq. 11 for every candidate at every step: O(n^2) */
    LAPLACIAN_FAST,  /* a tree of charges and lazy rejection: the same distribution within `error`, O(n log n); in 2D
                        and 3D, elsewhere exact */
    LAPLACIAN_METHODS
};

enum laplacian_status {
    LAPLACIAN_GROWING,
    LAPLACIAN_COMPLETE,      /* as many particles as wanted */
    LAPLACIAN_FAR,           /* it has come as far as `extent`, or as coordinates go */
    LAPLACIAN_HIT,           /* it has touched a charge that ends it */
    LAPLACIAN_NO_CANDIDATES, /* nowhere to grow */
    LAPLACIAN_NO_SEED,       /* no seed lies within the mask and the coordinates */
    LAPLACIAN_BAD_VALUE,     /* a value of the definition is out of its range, or no number */
    LAPLACIAN_NO_MEMORY,
    LAPLACIAN_STATUSES
};

extern const char *const laplacian_status_names[LAPLACIAN_STATUSES];
extern const char *const laplacian_method_names[LAPLACIAN_METHODS + 1]; /* ends with NULL */

enum laplacian_shape {
    LAPLACIAN_POINT,    /* at; within `radius` it is what it is there */
    LAPLACIAN_LINE,     /* without end, through `at` along `along` */
    LAPLACIAN_PLANE,    /* through `at`, upright on `along`; 1 / distance, as section IV.A has it */
    LAPLACIAN_CYLINDER, /* without end, about the line, of `radius` */
    LAPLACIAN_STROKE,   /* along a path: `charge` to each cell of its length; in 2D and 3D */
    LAPLACIAN_SHAPES
};
extern const char *const laplacian_shape_names[LAPLACIAN_SHAPES + 1]; /* "point", ...; ends with NULL */

/* An attractor or repulsor (section III.E). */
struct laplacian_charge {
    enum laplacian_shape shape;
    float charge; /* of a particle; above 0 attracts, below 0 repels */
    float at[LAPLACIAN_DIMENSIONS_MAX], along[LAPLACIAN_DIMENSIONS_MAX];
    float radius;      /* of a cylinder; of a point 0 or more */
    const float *path; /* path_count places of as many coordinates as there are dimensions; owned by the caller */
    int path_count;
    bool ends; /* growth that comes within 1.5 cells of it is complete */
};

/* Charges along a segment from the start; a point where both ends are the same. */
struct laplacian_seed {
    float from[LAPLACIAN_DIMENSIONS_MAX], to[LAPLACIAN_DIMENSIONS_MAX];
};

enum { LAPLACIAN_PARTICLES_MAX = 16000000, LAPLACIAN_DEGREE_MAX = 12 };

/* The table laplacian_keys says units and ranges. Rasters belong to the caller and stay till the end; each covers a
 * square or rectangle about the origin, `span` cells wide, in x and y. */
struct laplacian_def {
    int dimensions, method; /* enum laplacian_method */
    int particles, seed;
    float eta, eta_end;
    float jitter;
    bool off_grid;
    float error, extent, span;
    int harmonics;
    float environment_radius, environment_strength;
    struct action_raster mask, eta_map, outline, environment;
    struct action_raster background; /* of many charges that lie around: the sum of 1 / distance, those that attract
                                        less than 0; over the same rectangle as the mask. None: no values */
    const struct laplacian_charge *charges; /* copied, paths are not */
    int charge_count;
    const struct laplacian_seed *seeds; /* copied; none, and no outline: a charge at the origin */
    int seed_count;
};

extern const struct key laplacian_keys[]; /* of struct laplacian_def; ends with a key whose name is NULL */

struct laplacian_def laplacian_default_def(void);

struct laplacian_node {
    float at[LAPLACIAN_DIMENSIONS_MAX]; /* 0 beyond the dimensions */
    float potential;                    /* 0..1, eq. 13, when it was chosen; of seeds 1 */
    int32_t parent;                     /* an earlier node; of seeds -1 */
};

struct laplacian;

/* NULL with the reason in `status`. */
struct laplacian *laplacian_create(const struct laplacian_def *def, enum laplacian_status *status);
void laplacian_destroy(struct laplacian *laplacian); /* takes NULL */

/* Grows by `count` particles at the most; returns by how many it has. Fewer: laplacian_status says why. */
int32_t laplacian_step(struct laplacian *laplacian, int32_t count);
enum laplacian_status laplacian_status(const struct laplacian *laplacian);

int32_t laplacian_count(const struct laplacian *laplacian); /* nodes, in the order in which they came, seeds first */
struct laplacian_node laplacian_node(const struct laplacian *laplacian, int32_t index);
size_t laplacian_bytes(const struct laplacian *laplacian); /* of memory, now */

/* Eq. 10 at any place, attractors and harmonics included. */
float laplacian_potential(struct laplacian *laplacian, const float *at);

/* Other attractors and repulsors from now on. False when memory is short: nothing has changed then. */
bool laplacian_charge(struct laplacian *laplacian, const struct laplacian_charge *charges, int count);

/* Another background from now on, or none. */
void laplacian_background(struct laplacian *laplacian, const struct action_raster *background);
/* Another eta from now on, whatever is done; brought into the range of its key. */
void laplacian_eta(struct laplacian *laplacian, float eta);

/* For tests and benches: candidates, what is known of each, and a choice that is not grown. */
int32_t laplacian_candidates(const struct laplacian *laplacian);
struct laplacian_node laplacian_candidate(const struct laplacian *laplacian, int32_t index); /* potential: 0 */
int32_t laplacian_choose(struct laplacian *laplacian);                                       /* a candidate, or -1 */
double laplacian_trials(const struct laplacian *laplacian); /* of the fast method, for each choice so far */

#endif
