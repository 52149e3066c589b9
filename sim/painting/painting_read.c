/* Looking at a painting: fields, totals, hash. */
#include <string.h>

#include "d2q9.h"
#include "painting_state.h"

const char *painting_field_name(enum painting_field field)
{
    static const char *const NAMES[PAINTING_FIELDS] = {
        "pattern.catalyst", "pattern.active", "pattern.carved", "solvent.density", "solvent.u",
        "solvent.v",        "ink.density",    "ink.u",          "ink.v",           "ink.wet.0",
        "ink.wet.1",        "ink.wet.2",      "ink.wet.3",      "ink.dry.0",       "ink.dry.1",
        "ink.dry.2",        "ink.dry.3",      "guide.u",        "guide.v",         "mask",
        "map.alpha_a",      "map.alpha_y",    "map.beta_a",     "map.s_max",       "map.xi",
    };
    return NAMES[field];
}

/* Sum of weights[i] * population i of a cell. */
static float moment(const struct painting *painting, int first, const float weights[POPULATIONS], int x, int y)
{
    const float *population = fluid_row(painting, y) + (size_t)first * (size_t)painting->stride + x;
    float sum = 0.0f;
    for (int i = 0; i < 9; i++, population += painting->stride) {
        sum += weights[i] * *population;
    }
    return sum;
}

static float value_at(const struct painting *painting, enum painting_field field, int x, int y)
{
    static const float ONES[POPULATIONS] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
    size_t stride = (size_t)painting->stride;
    switch (field) {
    case PAINTING_ACTIVE:
        return pattern_row(painting, y)[x];
    case PAINTING_CATALYST:
        return pattern_row(painting, y)[PATTERN_CATALYST * stride + (size_t)x];
    case PAINTING_CARVED:
        return pattern_row(painting, y)[PATTERN_CARVED * stride + (size_t)x];
    case PAINTING_SOLVENT:
        return moment(painting, FLUID_SOLVENT, ONES, x, y);
    case PAINTING_SOLVENT_U:
        return moment(painting, FLUID_SOLVENT, d2q9_x, x, y);
    case PAINTING_SOLVENT_V:
        return moment(painting, FLUID_SOLVENT, d2q9_y, x, y);
    case PAINTING_INK:
        return moment(painting, FLUID_INK, ONES, x, y);
    case PAINTING_INK_U:
        return moment(painting, FLUID_INK, d2q9_x, x, y);
    case PAINTING_INK_V:
        return moment(painting, FLUID_INK, d2q9_y, x, y);
    default:
        if (field >= PAINTING_GUIDE_U) {
            return ground_value(painting->ground, field, x, y);
        }
        if (field >= PAINTING_WET && field < PAINTING_DRY) {
            return fluid_row(painting, y)[(size_t)(FLUID_WET + (field - PAINTING_WET)) * stride + (size_t)x];
        }
        return dry_row(painting, y)[(size_t)(field - PAINTING_DRY) * stride + (size_t)x];
    }
}

void painting_read(const struct painting *painting, enum painting_field field, float *plane)
{
    int margin = painting->def.margin;
    for (int y = 0; y < painting->def.height; y++) {
        for (int x = 0; x < painting->def.width; x++) {
            *plane++ = value_at(painting, field, x + margin, y + margin);
        }
    }
}

static double sum_of(const struct painting *painting, enum painting_field field)
{
    double sum = 0.0;
    for (int y = 0; y < painting->height; y++) {
        for (int x = 0; x < painting->width; x++) {
            sum += (double)value_at(painting, field, x, y);
        }
    }
    return sum;
}

struct painting_totals painting_totals(const struct painting *painting)
{
    struct painting_totals totals = {
        .solvent = sum_of(painting, PAINTING_SOLVENT),
        .ink = sum_of(painting, PAINTING_INK),
        .solvent_evaporated = painting->evaporated,
        .ink_dried = painting->ink_dried,
        .catalyst = sum_of(painting, PAINTING_CATALYST),
        .active = sum_of(painting, PAINTING_ACTIVE),
        .carved = sum_of(painting, PAINTING_CARVED),
    };
    for (int ink = 0; ink < PAINTING_INKS; ink++) {
        totals.wet[ink] = sum_of(painting, (enum painting_field)(PAINTING_WET + ink));
        totals.dry[ink] = sum_of(painting, (enum painting_field)(PAINTING_DRY + ink));
    }
    return totals;
}

static uint64_t mix_float(uint64_t hash, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    bits = bits == 0x80000000u ? 0 : bits;
    return (hash ^ bits) * 1099511628211u; /* FNV-1a, a word at a time */
}

uint64_t painting_hash(const struct painting *painting)
{
    uint64_t hash = 14695981039346656037u;
    size_t stride = (size_t)painting->stride;
    for (int y = 0; y < painting->height; y++) {
        for (int field = 0; field < FLUID_FIELDS + PATTERN_FIELDS + INKS; field++) {
            const float *row = field < FLUID_FIELDS ? fluid_row(painting, y) + (size_t)field * stride
                               : field < FLUID_FIELDS + PATTERN_FIELDS
                                   ? pattern_row(painting, y) + (size_t)(field - FLUID_FIELDS) * stride
                                   : dry_row(painting, y) + (size_t)(field - FLUID_FIELDS - PATTERN_FIELDS) * stride;
            for (int x = 0; x < painting->width; x++) {
                hash = mix_float(hash, row[x]);
            }
        }
        for (int x = 0; x < painting->width; x++) {
            uint64_t maps = ground_obstacle(painting->ground, y)[x] |
                            (uint64_t)ground_weight(painting->ground, y)[x] << 8 |
                            (uint64_t)(uint16_t)ground_guide(painting->ground, 0, y)[x] << 16 |
                            (uint64_t)(uint16_t)ground_guide(painting->ground, 1, y)[x] << 32;
            for (int map = 0; map < MAPS; map++) {
                maps = maps * 31 + ground_map(painting->ground, (enum map)map, y)[x];
            }
            hash = (hash ^ maps) * 1099511628211u;
        }
    }
    return hash;
}
