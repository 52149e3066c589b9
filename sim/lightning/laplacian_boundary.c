/* Attractors, repulsors, environment and rasters. */
#include "laplacian_boundary.h"

#include <math.h>

#include "exponential.h"
#include "laplacian_state.h"

static const float TOUCH = 1.5f, NEAREST = 0.5f, LN2 = 0.69314718f;

static float natural(float x)
{
    return LN2 * logarithm2(x);
}

static float squared_distance(const float *a, const float *b, int dimensions)
{
    float sum = 0;
    for (int d = 0; d < dimensions; d++) {
        sum += (a[d] - b[d]) * (a[d] - b[d]);
    }
    return sum;
}

/* Distance along a direction, and aside from it. */
static void split(const struct laplacian_charge *charge, const float *at, int dimensions, float *along, float *aside)
{
    float product = 0, length = 0, whole = squared_distance(at, charge->at, dimensions);
    for (int d = 0; d < dimensions; d++) {
        product += (at[d] - charge->at[d]) * charge->along[d];
        length += charge->along[d] * charge->along[d];
    }
    *along = product / sqrtf(length);
    float rest = whole - *along * *along;
    *aside = sqrtf(rest > 0 ? rest : 0);
}

/* 1 / r^(D-2), as of a particle. */
static float point_green(float distance, int dimensions)
{
    float inverse = 1 / (distance > NEAREST ? distance : NEAREST), green = inverse;
    for (int d = 3; d < dimensions; d++) {
        green *= inverse;
    }
    return green;
}

/* What a line or a cylinder does is a point's in one dimension less: minus the logarithm in 3D. */
static float line_green(float distance, int dimensions)
{
    return dimensions <= 3 ? -natural(distance) : point_green(distance, dimensions - 1);
}

static float stroke_distance(const struct laplacian_charge *charge, const float *at, int dimensions, float *green)
{
    float least = INFINITY;
    *green = 0;
    for (int i = 0; i < charge->path_count; i++) {
        const float *a = charge->path + (size_t)i * (size_t)dimensions, *b = i > 0 ? a - dimensions : a;
        float ra = sqrtf(squared_distance(at, a, dimensions)), rb = sqrtf(squared_distance(at, b, dimensions));
        float length = sqrtf(squared_distance(a, b, dimensions));
        least = ra < least ? ra : least;
        if (length > 0) {
            float past = ra + rb - length, smallest = NEAREST / (length + 1);
            *green += natural((ra + rb + length) / (past > smallest ? past : smallest));
            float along = 0;
            for (int d = 0; d < dimensions; d++) {
                along += (at[d] - a[d]) * (b[d] - a[d]) / length;
            }
            if (along > 0 && along < length) {
                float rest = ra * ra - along * along, aside = sqrtf(rest > 0 ? rest : 0);
                least = aside < least ? aside : least;
            }
        } else if (charge->path_count == 1) {
            *green += point_green(ra, dimensions);
        }
    }
    return least;
}

/* Distance from the surface of an attractor or repulsor, and its Green's function. */
static float distance_of(const struct laplacian_charge *charge, const float *at, int dimensions, float *green)
{
    float along, aside;
    switch (charge->shape) {
    case LAPLACIAN_POINT:
        aside = sqrtf(squared_distance(at, charge->at, dimensions));
        *green = point_green(aside > charge->radius ? aside : charge->radius, dimensions);
        return aside;
    case LAPLACIAN_PLANE:
        split(charge, at, dimensions, &along, &aside);
        along = fabsf(along);
        *green = 1 / (along > NEAREST ? along : NEAREST);
        return along;
    case LAPLACIAN_LINE:
        split(charge, at, dimensions, &along, &aside);
        *green = line_green(aside > NEAREST ? aside : NEAREST, dimensions);
        return aside;
    case LAPLACIAN_CYLINDER: {
        float radius = charge->radius > NEAREST ? charge->radius : NEAREST;
        split(charge, at, dimensions, &along, &aside);
        *green = line_green(aside > radius ? aside : radius, dimensions); /* within, it is what it is on the surface */
        return aside > radius ? aside - radius : 0;
    }
    default:
        return stroke_distance(charge, at, dimensions, green);
    }
}

static bool are_finite(const float *values, int count)
{
    for (int i = 0; i < count; i++) {
        if (!isfinite(values[i])) {
            return false;
        }
    }
    return true;
}

bool laplacian_charge_is_good(const struct laplacian_charge *charge, int dimensions)
{
    float length = 0;
    for (int d = 0; d < dimensions; d++) {
        length += charge->along[d] * charge->along[d];
    }
    if ((int)charge->shape < 0 || charge->shape >= LAPLACIAN_SHAPES || !isfinite(charge->charge) ||
        !isfinite(charge->radius)) {
        return false;
    }
    if (charge->shape == LAPLACIAN_STROKE) {
        return dimensions <= 3 && charge->path && charge->path_count > 0 &&
               are_finite(charge->path, charge->path_count * dimensions);
    }
    return are_finite(charge->at, dimensions) && (charge->shape == LAPLACIAN_POINT || (isfinite(length) && length > 0));
}

float laplacian_charges_load(const struct laplacian_charge *charges, int count, int dimensions, const float *at)
{
    float load = 0, green;
    for (int i = 0; i < count; i++) {
        (void)distance_of(&charges[i], at, dimensions, &green);
        load -= charges[i].charge * green;
    }
    return load;
}

float laplacian_charge_distance(const struct laplacian_charge *charge, int dimensions, const float *at)
{
    float green;
    return distance_of(charge, at, dimensions, &green);
}

float laplacian_static_load(const struct laplacian *laplacian, const float *at)
{
    const struct laplacian_def *def = &laplacian->def;
    float load = laplacian_charges_load(laplacian->charges, def->charge_count, def->dimensions, at);
    return def->background.values ? load + laplacian_raster(laplacian, &def->background, at) : load;
}

bool laplacian_touches(const struct laplacian *laplacian, const float *at)
{
    float green;
    for (int i = 0; i < laplacian->def.charge_count; i++) {
        const struct laplacian_charge *charge = &laplacian->charges[i];
        if (charge->ends && distance_of(charge, at, laplacian->def.dimensions, &green) <= TOUCH) {
            return true;
        }
    }
    return false;
}

/* Eq. 15 in the place of eq. 9: each charge brings the environment once. Given as what is missing to its greatest
 * value, it never falls, and only differences count. */
float laplacian_rate(const struct laplacian *laplacian, const float *at)
{
    double missing = laplacian->harmonics.most - laplacian_harmonics_value(&laplacian->harmonics, at);
    return missing > 0 ? 2 * laplacian->def.environment_strength * (float)missing : 0;
}

/* Bilinear, clamped at the border. */
float laplacian_raster(const struct laplacian *laplacian, const struct action_raster *raster, const float *at)
{
    float scale = (float)raster->width / laplacian->def.span;
    float x = at[0] * scale + 0.5f * (float)(raster->width - 1), y = at[1] * scale + 0.5f * (float)(raster->height - 1);
    float right = (float)(raster->width - 1), bottom = (float)(raster->height - 1);
    x = x < 0 ? 0 : x > right ? right : x;
    y = y < 0 ? 0 : y > bottom ? bottom : y;
    int column = (int)x, row = (int)y;
    int next_column = column + 1 < raster->width ? column + 1 : column;
    int next_row = row + 1 < raster->height ? row + 1 : row;
    float u = x - (float)column, v = y - (float)row;
    const float *top = raster->values + (size_t)row * (size_t)raster->width;
    const float *below = raster->values + (size_t)next_row * (size_t)raster->width;
    return (1 - v) * ((1 - u) * top[column] + u * top[next_column]) +
           v * ((1 - u) * below[column] + u * below[next_column]);
}

void laplacian_inside(const struct laplacian *laplacian, const struct action_raster *raster, int x, int y, float *at)
{
    float scale = laplacian->def.span / (float)raster->width;
    for (int d = 0; d < laplacian->def.dimensions; d++) {
        at[d] = 0;
    }
    at[0] = ((float)x - 0.5f * (float)(raster->width - 1)) * scale;
    at[1] = ((float)y - 0.5f * (float)(raster->height - 1)) * scale;
}
