#include "tile_code.h"

#include <math.h>
#include <string.h>

#include "d2q9.h"

enum {
    MANTISSA_SHIFT = 13,
    EXPONENT_LEAST = (127 - 48) << 10, /* in units of the code: what is below is 0 */
    CODE_MOST = 65535,
    VELOCITY_ZERO = 32768,
};
#define VELOCITY_UNIT 16384.0f
/* Of each component: populations in equilibrium are then at least 0, as 1 / 2 - 3 / 2 u^2 is, and so is every density
 * that they flow into. */
#define VELOCITY_MOST 0.4f

static uint16_t number_code(float value)
{
    uint32_t bits;
    value = value > 0.0f ? value : 0.0f;
    memcpy(&bits, &value, sizeof bits);
    int32_t code = (int32_t)((bits + (1u << (MANTISSA_SHIFT - 1))) >> MANTISSA_SHIFT) - EXPONENT_LEAST;
    code = code > 0 ? code : 0;
    return (uint16_t)(code < CODE_MOST ? code : CODE_MOST);
}

float tile_code_number(uint16_t word)
{
    uint32_t bits = word ? ((uint32_t)word + EXPONENT_LEAST) << MANTISSA_SHIFT : 0;
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static uint16_t velocity_code(float momentum, float density)
{
    float u = density > 1e-9f ? momentum / density : 0.0f;
    u = fminf(fmaxf(u, -VELOCITY_MOST), VELOCITY_MOST);
    return (uint16_t)(int)(u * VELOCITY_UNIT + ((float)VELOCITY_ZERO + 0.5f));
}

/* The part of a tile that lies in a patch. */
struct part {
    int columns, rows;    /* cells */
    size_t first, stride; /* its first cell in the patch; cells from row to row */
};

static struct part part_of(const struct patch *patch, int x, int y)
{
    struct rectangle cells = patch->cells;
    return (struct part){.columns = cells.x1 - x < TILE ? cells.x1 - x : TILE,
                         .rows = cells.y1 - y < TILE ? cells.y1 - y : TILE,
                         .first = (size_t)(y - cells.y0) * (size_t)(cells.x1 - cells.x0) + (size_t)(x - cells.x0),
                         .stride = (size_t)(cells.x1 - cells.x0)};
}

static void take_liquid(const struct patch *patch, int first, const struct part *part, uint16_t (*to)[TILE_CELLS])
{
    const size_t plane = patch_cells(patch);
    for (int row = 0; row < part->rows; row++) {
        const float *f = patch_plane(patch, first) + part->first + (size_t)row * part->stride;
        for (int column = 0; column < part->columns; column++, f++) {
            float across = (f[plane] - f[3 * plane]), down = (f[2 * plane] - f[4 * plane]);
            float falling = f[5 * plane] - f[7 * plane], rising = f[6 * plane] - f[8 * plane];
            float density =
                (f[0] + (f[plane] + f[3 * plane])) +
                ((f[2 * plane] + f[4 * plane]) + ((f[5 * plane] + f[7 * plane]) + (f[6 * plane] + f[8 * plane])));
            int cell = row * TILE + column;
            to[0][cell] = number_code(density);
            to[1][cell] = velocity_code((across + falling) - rising, density);
            to[2][cell] = velocity_code((down + falling) + rising, density);
        }
    }
}

static void take_plane(const struct patch *patch, int plane, const struct part *part, uint16_t *to)
{
    for (int row = 0; row < part->rows; row++) {
        const float *from = patch_plane(patch, plane) + part->first + (size_t)row * part->stride;
        for (int column = 0; column < part->columns; column++) {
            to[row * TILE + column] = number_code(from[column]);
        }
    }
}

/* Planes that are kept as they are: where each stands in the code and in a checkpoint. */
static const struct {
    int code, plane, count;
} PLAIN[] = {{CODE_ACTIVE, CHECKPOINT_ACTIVE, 3},
             {CODE_WET, CHECKPOINT_WET, PAINTING_INKS},
             {CODE_DRY, CHECKPOINT_DRY, PAINTING_INKS}};
enum { PLAIN_COUNT = sizeof PLAIN / sizeof PLAIN[0] };

_Static_assert(CODE_CATALYST - CODE_ACTIVE == CHECKPOINT_CATALYST - CHECKPOINT_ACTIVE &&
                   CODE_CARVED - CODE_ACTIVE == CHECKPOINT_CARVED - CHECKPOINT_ACTIVE,
               "the pattern is in the order of a checkpoint");

void tile_code_take(struct tile_code *code, const struct patch *patch, int x, int y)
{
    struct part part = part_of(patch, x, y);
    if (part.columns < TILE || part.rows < TILE) {
        memset(code, 0, sizeof *code);
    }
    take_liquid(patch, CHECKPOINT_SOLVENT, &part, &code->planes[CODE_SOLVENT]);
    take_liquid(patch, CHECKPOINT_INK, &part, &code->planes[CODE_INK]);
    for (int i = 0; i < PLAIN_COUNT; i++) {
        for (int j = 0; j < PLAIN[i].count; j++) {
            take_plane(patch, PLAIN[i].plane + j, &part, code->planes[PLAIN[i].code + j]);
        }
    }
    for (int plane = 0; plane < PATCH_GROUND; plane++) {
        for (int row = 0; row < part.rows; row++) {
            memcpy(code->planes[CODE_GROUND + plane] + row * TILE,
                   patch_ground(patch, plane) + part.first + (size_t)row * part.stride,
                   (size_t)part.columns * sizeof code->planes[0][0]);
        }
    }
}

static void liquid_values(const uint16_t (*code)[TILE_CELLS], float (*values)[TILE_CELLS])
{
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        float density = tile_code_number(code[0][cell]);
        values[0][cell] = density;
        values[1][cell] = density * ((float)(code[1][cell] - VELOCITY_ZERO) * (1.0f / VELOCITY_UNIT));
        values[2][cell] = density * ((float)(code[2][cell] - VELOCITY_ZERO) * (1.0f / VELOCITY_UNIT));
    }
}

void tile_code_values(const struct tile_code *code, struct tile_values *values)
{
    liquid_values(&code->planes[CODE_SOLVENT], &values->planes[CODE_SOLVENT]);
    liquid_values(&code->planes[CODE_INK], &values->planes[CODE_INK]);
    for (int plane = CODE_ACTIVE; plane < CODE_STATE; plane++) {
        for (int cell = 0; cell < TILE_CELLS; cell++) {
            values->planes[plane][cell] = tile_code_number(code->planes[plane][cell]);
        }
    }
}

/* Populations of density `rho` that carry momentum x, y, none of them below 0. Returns the density of all. */
static float blend_liquid(float *population, size_t plane, float rho, float x, float y, float share)
{
    float size = fabsf(x) + fabsf(y), most = rho * (1.0f / 3);
    float scale = size > most ? most / size : 1.0f, density = 0.0f;
    for (int i = 0; i < 9; i++, population += plane) {
        float value = d2q9_weights[i] * (rho + (3.0f * scale) * (d2q9_x[i] * x + d2q9_y[i] * y));
        value = value > 0.0f ? value : 0.0f;
        *population = share >= 1.0f ? value : *population + share * (value - *population);
        density += *population;
    }
    return density;
}

static void blend_cell(const struct tile_values *values, int cell, float share, const struct patch *patch, size_t at)
{
    const size_t plane = patch_cells(patch);
    float density[2];
    for (int liquid = 0; liquid < 2; liquid++) {
        const float(*from)[TILE_CELLS] = &values->planes[liquid == 0 ? CODE_SOLVENT : CODE_INK];
        float *to = patch_plane(patch, liquid == 0 ? CHECKPOINT_SOLVENT : CHECKPOINT_INK) + at;
        density[liquid] = blend_liquid(to, plane, from[0][cell], from[1][cell], from[2][cell], share);
    }
    patch_plane(patch, CHECKPOINT_DENSITY)[at] = density[0];
    for (int i = 0; i < PLAIN_COUNT; i++) {
        for (int j = 0; j < PLAIN[i].count; j++) {
            float *to = patch_plane(patch, PLAIN[i].plane + j) + at, value = values->planes[PLAIN[i].code + j][cell];
            *to = share >= 1.0f ? value : *to + share * (value - *to);
        }
    }
}

void tile_values_blend(const struct tile_values *values, const float share[TILE_CELLS], struct patch *patch, int x,
                       int y)
{
    struct part part = part_of(patch, x, y);
    for (int row = 0; row < part.rows; row++) {
        for (int column = 0; column < part.columns; column++) {
            int cell = row * TILE + column;
            if (share[cell] > 0.0f) {
                blend_cell(values, cell, share[cell], patch, part.first + (size_t)row * part.stride + (size_t)column);
            }
        }
    }
}

void tile_code_give_ground(const struct tile_code *code, const uint8_t chosen[TILE_CELLS], struct patch *patch, int x,
                           int y)
{
    struct part part = part_of(patch, x, y);
    for (int row = 0; row < part.rows; row++) {
        for (int column = 0; column < part.columns; column++) {
            int cell = row * TILE + column;
            size_t at = part.first + (size_t)row * part.stride + (size_t)column;
            for (int plane = 0; chosen[cell] && plane < PATCH_GROUND; plane++) {
                patch_ground(patch, plane)[at] = code->planes[CODE_GROUND + plane][cell];
            }
        }
    }
}
