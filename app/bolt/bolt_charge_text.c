#include "bolt_charge_text.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static const double FARTHEST = 131000, STRONGEST = 1e9, THICKEST = 131000;
static const float CHARGES[LAPLACIAN_SHAPES] = {1000, 100, 1000, 100, 10}; /* where none is given */

static const char FORM[] = "X,Y[,Z], line:X,Y/DX,DY, plane:X,Y/DX,DY, cylinder:X,Y/DX,DY/RADIUS or "
                           "stroke:X,Y;X,Y;..., then [:CHARGE][!]; places -131000 to 131000 cells, a number for each "
                           "dimension at the most";

static bool take_number(const char **text, double least, double most, float *value)
{
    char *end = NULL;
    errno = 0;
    double number = strtod(*text, &end);
    bool good = end != *text && !errno && number >= least && number <= most;
    *text = end;
    *value = good ? (float)number : 0;
    return good;
}

/* Two numbers or more, one for each dimension at the most. */
static bool take_place(const char **text, int dimensions, float *at)
{
    int count = 0;
    do {
        if (count == dimensions || !take_number(text, -FARTHEST, FARTHEST, &at[count++])) {
            return false;
        }
    } while (**text == ',' && (*text)++);
    return count >= 2;
}

static bool take_direction(const char **text, int dimensions, float *along)
{
    float length = 0;
    if (*(*text)++ != '/' || !take_place(text, dimensions, along)) {
        return false;
    }
    for (int d = 0; d < dimensions; d++) {
        length += along[d] * along[d];
    }
    return length > 0;
}

static bool take_path(struct bolt_order *order, const char **text, struct laplacian_charge *charge)
{
    int dimensions = order->bolt.growth.dimensions;
    float *path = calloc((size_t)BOLT_PATH_PLACES * LAPLACIAN_DIMENSIONS_MAX, sizeof *path);
    if (!path || order->path_count == BOLT_CHARGES) {
        free(path);
        return false;
    }
    order->paths[order->path_count++] = path;
    charge->path = path;
    do {
        if (charge->path_count == BOLT_PATH_PLACES ||
            !take_place(text, dimensions, path + (size_t)charge->path_count++ * (size_t)dimensions)) {
            return false;
        }
    } while (**text == ';' && (*text)++);
    return true;
}

static enum laplacian_shape take_shape(const char **text)
{
    for (int shape = 0; shape < LAPLACIAN_SHAPES; shape++) {
        size_t length = strlen(laplacian_shape_names[shape]);
        if (strncmp(*text, laplacian_shape_names[shape], length) == 0 && (*text)[length] == ':') {
            *text += length + 1;
            return (enum laplacian_shape)shape;
        }
    }
    return LAPLACIAN_POINT;
}

static bool take_body(struct bolt_order *order, const char **text, struct laplacian_charge *charge)
{
    int dimensions = order->bolt.growth.dimensions;
    if (charge->shape == LAPLACIAN_STROKE) {
        return take_path(order, text, charge);
    }
    if (!take_place(text, dimensions, charge->at)) {
        return false;
    }
    if (charge->shape != LAPLACIAN_POINT && !take_direction(text, dimensions, charge->along)) {
        return false;
    }
    return charge->shape != LAPLACIAN_CYLINDER ||
           (*(*text)++ == '/' && take_number(text, 0.5, THICKEST, &charge->radius));
}

const char *bolt_charge_take(struct bolt_order *order, const char *text, bool attracts)
{
    struct laplacian_def *growth = &order->bolt.growth;
    struct laplacian_charge charge = {.shape = take_shape(&text)};
    float strength = CHARGES[charge.shape];
    if (growth->charge_count == BOLT_CHARGES) {
        return "no more than 64 in all, those of the kind among them; --bare leaves those out";
    }
    if (charge.shape == LAPLACIAN_STROKE && growth->dimensions > 3) {
        return "strokes are for 2 and 3 dimensions";
    }
    if (!take_body(order, &text, &charge)) {
        return FORM;
    }
    if (*text == ':' && (text++, !take_number(&text, 0, STRONGEST, &strength))) {
        return "CHARGE is 0 to 1000000000, of a particle; of a stroke, to a cell of its length";
    }
    charge.ends = *text == '!' && text++;
    if (*text) {
        return FORM;
    }
    charge.charge = attracts ? strength : -strength;
    order->bolt.charges[growth->charge_count++] = charge;
    return NULL;
}

const char *bolt_seed_take(struct bolt_order *order, const char *text, bool first)
{
    struct laplacian_def *growth = &order->bolt.growth;
    struct laplacian_seed seed = {{0}, {0}};
    growth->seed_count = first ? 0 : growth->seed_count;
    if (growth->seed_count == BOLT_SEEDS) {
        return "no more than 64";
    }
    bool good = take_place(&text, growth->dimensions, seed.from);
    memcpy(seed.to, seed.from, sizeof seed.to);
    if (good && *text == '/') {
        text++;
        memset(seed.to, 0, sizeof seed.to);
        good = take_place(&text, growth->dimensions, seed.to);
    }
    if (!good || *text) {
        return "X,Y[,Z] or X,Y[,Z]/X,Y[,Z]; places -131000 to 131000 cells, a number for each dimension at the most";
    }
    order->bolt.seeds[growth->seed_count++] = seed;
    return NULL;
}
