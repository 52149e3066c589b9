/* Plants that feel the potential: an environmentally sensitive L-system (Kim, Sewall, Sud and Lin, Fast Simulation of
 * Laplacian Growth, section IV.A; Mech and Prusinkiewicz 1996), whose environment is the potential of that paper.
 *
 *     struct lsystem_def def = lsystem_default_def();
 *     enum lsystem_status status;
 *     struct lsystem *plant = lsystem_create(&def, &status);
 *     while (lsystem_step(plant, 1) > 0) ...
 *
 * Bracketed parametric productions, all applied at once at each derivation step. A(o, k) is an apex on an axis of order
 * o that has made k internodes, B(o) a bud, F(l) an internode of l cells; Phi is eq. 13 among all apices, buds and
 * seeds:
 *
 *     axiom                                        A(0, 0) at every seed
 *     A(o, k)  k >= run decline^o               -> nothing: the axis is full-grown
 *     A(o, k)  where it would touch a branch    -> nothing
 *     A(o, k)                                   -> turn F(length ratio^o) [ /(divergence) +(angle) B(o+1) ]* A(o, k+1)
 *                                                  with a whorl of buds at every `spacing`-th internode; then A goes on
 *                                                  with the probability `dominance`
 *     B(o)     with the probability Phi^eta     -> A(o, 0)                                   (eq. 12)
 *     B(o)     after `patience` steps           -> nothing
 *
 * turn: at random, by wobble; about the upright, by twine; to the set-point, by upward; to where the potential rises
 * most steeply, by tropism |g| / (|g| + response) times the sine of the angle to it; then along a surface, where it
 * would come nearer to one than `keep`. Every cell of the plant's own length is a charge of `shyness` that repels. With
 * eta 0, tropism 0 and no surfaces and no clearance it is the plain L-system.
 *
 * Lengths are in cells; x goes to the right, y down, z away. The same definition gives the same plant on every machine.
 */
#ifndef FROND_LSYSTEM_H
#define FROND_LSYSTEM_H

#include "laplacian.h"

enum lsystem_status {
    LSYSTEM_GROWING,
    LSYSTEM_COMPLETE, /* as many derivation steps as wanted */
    LSYSTEM_STILL,    /* neither an apex nor a bud is left */
    LSYSTEM_FULL,     /* as many nodes as it may have */
    LSYSTEM_HIT,      /* it has come within 1.5 cells of a charge that ends it */
    LSYSTEM_FAR,      /* it has come as far as coordinates go */
    LSYSTEM_NO_SEED,  /* no seed lies within the coordinates */
    LSYSTEM_BAD_VALUE,
    LSYSTEM_NO_MEMORY,
    LSYSTEM_STATUSES
};
extern const char *const lsystem_status_names[LSYSTEM_STATUSES];

enum { LSYSTEM_NODES_MAX = 400000, LSYSTEM_ORDERS_MAX = 8, LSYSTEM_WHORL_MAX = 6 };

/* Where an axis begins, and where it points to: upwards where that is 0. */
struct lsystem_seed {
    float at[3], heading[3];
};

/* The table lsystem_keys says units and ranges. */
struct lsystem_def {
    int dimensions, steps, nodes, seed;
    float length, ratio;
    int run;
    float decline;
    int spacing, whorl;
    float angle, divergence;
    int orders;
    float dominance, wobble, upward, setpoint, twine;
    float tropism, response, eta;
    int patience;
    float shyness, clearance, keep;
    float tip, pipe;
    int harmonics;
    float environment_radius, environment_strength;
    struct action_raster environment; /* owned by the caller, needed by lsystem_create alone */
    /* Points, lines, planes, cylinders and strokes, as those of laplacian.h; all but points are solid. Copied, paths
     * are not. */
    const struct laplacian_charge *charges;
    int charge_count;
    const struct lsystem_seed *seeds; /* copied; none: one at the origin */
    int seed_count;
};

extern const struct key lsystem_keys[]; /* of struct lsystem_def; ends with a key whose name is NULL */

struct lsystem_def lsystem_default_def(void);

struct lsystem_node {
    float at[3];     /* cells; z is 0 in 2D */
    float radius;    /* cells, by the pipe model: radius^pipe adds up where branches meet */
    float potential; /* 0..1: Phi of the apex that made it; of seeds 1 */
    int32_t parent;  /* an earlier node; of seeds -1 */
    int order;       /* of the axis it is on, 0.. */
};

struct lsystem;

/* NULL with the reason in `status`. */
struct lsystem *lsystem_create(const struct lsystem_def *def, enum lsystem_status *status);
void lsystem_destroy(struct lsystem *lsystem); /* takes NULL */

/* Derives `count` times at the most; returns how often it has. Fewer: lsystem_status says why. */
int lsystem_step(struct lsystem *lsystem, int count);
enum lsystem_status lsystem_status(const struct lsystem *lsystem);

int32_t lsystem_count(const struct lsystem *lsystem); /* nodes, in the order in which they came, seeds first */
struct lsystem_node lsystem_node(const struct lsystem *lsystem, int32_t index);
/* The same as a node of Laplacian growth, for what draws and writes those. */
struct laplacian_node lsystem_laplacian_node(const struct lsystem *lsystem, int32_t index);

/* What an apex at a place is told: eq. 10 less its constant, and the way in which it rises, per cell. */
float lsystem_potential(struct lsystem *lsystem, const float at[3], float rise[3]);

#endif
