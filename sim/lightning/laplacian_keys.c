#include "laplacian.h"

#include "key_fields.h"

const char *const laplacian_method_names[LAPLACIAN_METHODS + 1] = {"auto", "exact", "fast", NULL};
const char *const laplacian_shape_names[LAPLACIAN_SHAPES + 1] = {"point", "line", "plane", "cylinder", "stroke", NULL};
const char *const laplacian_status_names[LAPLACIAN_STATUSES] = {
    "growing", "complete", "far enough", "hit", "no candidates", "no seed within the mask", "bad value", "no memory"};

#define KEY_AT(field) offsetof(struct laplacian_def, field)

const struct key laplacian_keys[] = {
    WHOLE(dimensions, "", 2, LAPLACIAN_DIMENSIONS_MAX, 2, "Of the space it grows in."),
    CHOICE(method, laplacian_method_names, LAPLACIAN_AUTO,
           "How the next particle is chosen; auto takes what is quicker."),
    WHOLE(particles, "", 1, LAPLACIAN_PARTICLES_MAX, 5000, "It is complete with so many."),
    WHOLE(seed, "", 0, 2147483647, 1, "Another number, another chance."),
    NUMBER(eta, "", 0, 20, 3, "How much growth prefers what stands out: 0 a round lump, 10 almost a line."),
    NUMBER(eta_end, "", -1, 20, -1, "Eta of the last particle, reached evenly; below 0: it stays the same."),
    NUMBER(jitter, "cells", 0, 0.98, 0.9, "How far particles lie off the middle of their cells, both ways together."),
    FLAG(off_grid, "Neighbours lie in any direction, a cell away, on no grid."),
    NUMBER(error, "", 1e-5, 0.01, 2.5e-3, "Bound of the relative error of the fast method's potential."),
    NUMBER(extent, "cells", 0, 131000, 0, "It is complete when it has come so far from the origin; 0: never."),
    NUMBER(span, "cells", 1, 262000, 512, "Width of mask, map of eta and outline, about the origin."),
    WHOLE(harmonics, "", 0, LAPLACIAN_DEGREE_MAX, 6, "Highest degree of the environment's harmonics."),
    NUMBER(environment_radius, "cells", 2, 131000, 400, "Where the environment lies: twice as far as it will grow."),
    NUMBER(environment_strength, "", 0, 10, 0.02, "Of the environment beside the particles; 1 is that of the paper."),
    RASTER(mask, "Grows where it is light."),
    RASTER(eta_map, "Eta is so many times what it is elsewhere."),
    RASTER(outline, "Grows from the outline of what is light."),
    RASTER(environment, "What lies around: light attracts. A panorama in 3D; in 2D its columns are directions."),
    END,
};

struct laplacian_def laplacian_default_def(void)
{
    struct laplacian_def def = {0};
    key_defaults(laplacian_keys, &def);
    return def;
}
