#include "lsystem.h"

#include "key_fields.h"

const char *const lsystem_status_names[LSYSTEM_STATUSES] = {
    "growing",   "complete", "nothing left to grow", "as many nodes as it may have", "hit", "far enough", "no seed",
    "bad value", "no memory"};

#define KEY_AT(field) offsetof(struct lsystem_def, field)

const struct key lsystem_keys[] = {
    WHOLE(dimensions, "", 2, 3, 2, "Of the space it grows in."),
    WHOLE(steps, "steps", 1, 1000, 40, "Derivation steps: an axis grows by one internode at each."),
    WHOLE(nodes, "", 1, LSYSTEM_NODES_MAX, 100000, "It ends with so many."),
    WHOLE(seed, "", 0, 2147483647, 1, "Another number, another chance."),
    NUMBER(length, "cells", 0.5, 64, 6, "Of an internode of the first order."),
    NUMBER(ratio, "", 0.1, 1, 0.8, "Internodes of a branch beside those of its parent."),
    WHOLE(run, "internodes", 1, 1000, 40, "Of an axis of the first order at the most."),
    NUMBER(decline, "", 0.05, 1, 0.6, "How many of them a branch has beside its parent."),
    WHOLE(spacing, "internodes", 1, 100, 2, "From buds to buds along an axis."),
    WHOLE(whorl, "", 0, LSYSTEM_WHORL_MAX, 1, "Buds in one place, evenly about the axis."),
    NUMBER(angle, "degrees", 0, 120, 45, "Between a branch and its parent, at first."),
    NUMBER(divergence, "degrees", 0, 360, 137.5, "About the axis, from buds to buds; in 2D sides alternate."),
    WHOLE(orders, "", 0, LSYSTEM_ORDERS_MAX, 3, "Of branches: 0 for an axis alone."),
    NUMBER(dominance, "", 0, 1, 1, "Chance that an axis goes on past its buds: 0 forks, 1 a stem with branches."),
    NUMBER(wobble, "degrees", 0, 45, 4, "By which an apex turns at random, an internode, at the most."),
    NUMBER(upward, "degrees", 0, 45, 1, "By which it turns towards its set-point, an internode, at the most."),
    NUMBER(setpoint, "degrees", 0, 180, 0, "From upright, to which axes turn by themselves."),
    NUMBER(twine, "degrees", -90, 90, 0, "About the upright, an internode; in 2D it curls."),
    NUMBER(tropism, "degrees", 0, 57, 20, "By which it bends to where the potential rises, an internode, at the most."),
    NUMBER(response, "per cell", 1e-4, 10, 0.05, "Slope of the potential at which it bends half as much."),
    NUMBER(eta, "", 0, 20, 1, "How much buds prefer a high potential: 0 all break, 10 the most exposed alone."),
    WHOLE(patience, "steps", 1, 1000, 3, "That a bud waits for a chance to break."),
    NUMBER(shyness, "", 0, 10, 0.1, "Charge of each cell of the plant's own length, which repels."),
    NUMBER(clearance, "cells", 0, 6, 1.5,
           "Nearest that a tip comes to other branches before it ends; 0: it goes through."),
    NUMBER(keep, "cells", 0, 64, 3,
           "Nearest that it comes to planes, lines, cylinders and strokes; 0: it goes through them."),
    NUMBER(tip, "cells", 0.05, 16, 0.6, "Radius of tips."),
    NUMBER(pipe, "", 1, 6, 2.3, "Radii to this power add up where branches meet: 2 Leonardo's rule, 3 Murray's."),
    WHOLE(harmonics, "", 0, LAPLACIAN_DEGREE_MAX, 6, "Highest degree of the environment's harmonics."),
    NUMBER(environment_radius, "cells", 2, 131000, 400, "Where the environment lies: twice as far as it will grow."),
    NUMBER(environment_strength, "", 0, 100000, 100, "Potential of what is white there, over what is black."),
    RASTER(environment, "What lies around: light attracts. A panorama in 3D; in 2D its columns are directions."),
    END,
};

struct lsystem_def lsystem_default_def(void)
{
    struct lsystem_def def = {0};
    key_defaults(lsystem_keys, &def);
    return def;
}
