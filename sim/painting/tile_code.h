/* A tile of a painting in 16 bits a value, as a history keeps it. Populations are kept as what flow means: density and
 * velocity; what comes back has the same density to a part in 2048 and the same velocity, and no memory of what is
 * between. Density, pattern and pigment are floats without sign: six bits of exponent, ten of mantissa, 2^-47 to 2^16.
 * The ground is kept to the bit. */
#ifndef FROND_TILE_CODE_H
#define FROND_TILE_CODE_H

#include "patch.h"
#include "tiles.h"

enum { TILE_CELLS = TILE * TILE };

enum tile_plane {
    CODE_SOLVENT, /* density; then u and v: momentum over density, -1..1 as 16384 + 32768 a unit */
    CODE_SOLVENT_U,
    CODE_SOLVENT_V,
    CODE_INK,
    CODE_INK_U,
    CODE_INK_V,
    CODE_ACTIVE,
    CODE_CATALYST,
    CODE_CARVED,
    CODE_WET,                              /* + ink */
    CODE_DRY = CODE_WET + PAINTING_INKS,   /* + ink */
    CODE_STATE = CODE_DRY + PAINTING_INKS, /* planes so far */
    CODE_GROUND = CODE_STATE,              /* + enum patch_ground */
    CODE_PLANES = CODE_GROUND + PATCH_GROUND,
};

struct tile_code {
    uint16_t planes[CODE_PLANES][TILE_CELLS]; /* row by row; cells beyond the sheet are 0 */
};

/* The state of a tile in numbers: density, momentum x and y for each liquid, then as enum tile_plane. */
struct tile_values {
    float planes[CODE_STATE][TILE_CELLS];
};

/* The tile whose first cell is x, y of the sheet, out of a patch that holds it. */
void tile_code_take(struct tile_code *code, const struct patch *patch, int x, int y);
void tile_code_values(const struct tile_code *code, struct tile_values *values);
/* One value of a plane that holds a density, pattern or pigment. */
float tile_code_number(uint16_t word);

/* Brings cells of the tile in the patch towards values: share 0 leaves a cell to the bit, 1 is all values. */
void tile_values_blend(const struct tile_values *values, const float share[TILE_CELLS], struct patch *patch, int x,
                       int y);
/* Puts back the ground of the cells that are chosen. */
void tile_code_give_ground(const struct tile_code *code, const uint8_t chosen[TILE_CELLS], struct patch *patch, int x,
                           int y);

#endif
