/* Coefficients that vary over the sheet: maps, brushes that stamp them, the `set` action. */
#include <math.h>
#include <string.h>

#include "brush.h"
#include "ground.h"
#include "noise.h"
#include "region.h"
#include "smooth.h"
#include "xi.h"

#define STAMP_UNIT (1.0f / 16)

/* The coefficients of one cell. */
struct local {
    float alpha_a, alpha_y, beta_a, s_max, xi, weight;
};

/* Diagonal weight at which the pinning of the front by the lattice cancels; fitted over eight seeds a point (four-fold
 * amplitude of the front under 1.5 %). D2Q9 has 1/6 and pins the axes, five points have 0 and pin the diagonals. */
static float isotropic_weight(const struct coefficients *c, float alpha_a)
{
    if (c->weight > 0.0f) {
        return c->weight;
    }
    float weight = 1.0f / 6 - 0.0163f * sqrtf(c->beta_y / (2.0f * alpha_a)) + 0.035f * (2.0f - c->k);
    return weight < 0.05f ? 0.05f : weight > 0.2f ? 0.2f : weight;
}

static uint16_t stored(float value, float unit)
{
    float units = value / unit + 0.5f;
    return (uint16_t)(units < 0.0f ? 0.0f : units > 65535.0f ? 65535.0f : units);
}

static struct local read_local(const struct ground *ground, int x, int y)
{
    return (struct local){(float)ground_map(ground, MAP_ALPHA_A, y)[x] * UNIT_ALPHA_A,
                          (float)ground_map(ground, MAP_ALPHA_Y, y)[x] * UNIT_ALPHA_Y,
                          (float)ground_map(ground, MAP_BETA_A, y)[x] * UNIT_BETA_A,
                          (float)ground_map(ground, MAP_S_MAX, y)[x] * UNIT_S_MAX,
                          (float)ground_map(ground, MAP_XI, y)[x] * UNIT_XI,
                          (float)ground_weight(ground, y)[x] * UNIT_WEIGHT};
}

static void write_local(const struct ground *ground, int x, int y, const struct local *local)
{
    ground_map(ground, MAP_ALPHA_A, y)[x] = stored(local->alpha_a, UNIT_ALPHA_A);
    ground_map(ground, MAP_ALPHA_Y, y)[x] = stored(local->alpha_y, UNIT_ALPHA_Y);
    ground_map(ground, MAP_BETA_A, y)[x] = stored(local->beta_a, UNIT_BETA_A);
    ground_map(ground, MAP_S_MAX, y)[x] = stored(local->s_max, UNIT_S_MAX);
    ground_map(ground, MAP_XI, y)[x] = stored(local->xi, UNIT_XI);
    ground_weight(ground, y)[x] = (uint8_t)(local->weight / UNIT_WEIGHT + 0.5f);
}

/* Cells are counted from the corner of the visible sheet, so that a margin does not change what grows in it. */
static float xi_at(const struct ground *ground, int x, int y, float xi0, int noise)
{
    int margin = ground->def.margin;
    return xi_of(x - margin, y - margin, xi0, (enum noise_kind)noise, ground->def.seed);
}

static float vary_at(const struct ground *ground, int x, int y, float size, enum random_stream stream)
{
    int margin = ground->def.margin;
    return noise_smooth((float)(x - margin), (float)(y - margin), size, ground->def.seed, stream);
}

void ground_fill(struct ground *ground)
{
    const struct coefficients *c = &ground->def.coefficients;
    struct local local = {c->alpha_a, c->alpha_y, c->beta_a, c->s_max, 1.0f, isotropic_weight(c, c->alpha_a)};
    for (int y = 0; y < ground->height; y++) {
        for (int x = 0; x < ground->width; x++) {
            local.xi = xi_at(ground, x, y, c->xi0, c->noise);
            write_local(ground, x, y, &local);
            ground_stamped(ground, y)[x] = GROUND_NEVER_STAMPED;
        }
    }
}

bool ground_fresh_cell(struct ground *ground, int x, int y)
{
    const struct coefficients *c = &ground->def.coefficients;
    struct local local = {c->alpha_a, c->alpha_y, c->beta_a, c->s_max, 1.0f, isotropic_weight(c, c->alpha_a)};
    uint16_t before[MAPS], *stamped = ground_stamped(ground, y) + x;
    uint8_t *obstacle = ground_obstacle(ground, y) + x, weight = ground_weight(ground, y)[x];
    int16_t *guide_x = ground_guide(ground, 0, y) + x, *guide_y = ground_guide(ground, 1, y) + x;
    bool changed = *stamped != GROUND_NEVER_STAMPED || *obstacle || *guide_x || *guide_y;
    for (int map = 0; map < MAPS; map++) {
        before[map] = ground_map(ground, (enum map)map, y)[x];
    }
    local.xi = xi_at(ground, x, y, c->xi0, c->noise);
    write_local(ground, x, y, &local);
    *stamped = GROUND_NEVER_STAMPED;
    *obstacle = 0;
    *guide_x = *guide_y = 0;
    for (int map = 0; map < MAPS; map++) {
        changed |= before[map] != ground_map(ground, (enum map)map, y)[x];
    }
    return changed || weight != ground_weight(ground, y)[x];
}

uint16_t ground_fresh_xi(const struct ground *ground, int x, int y)
{
    const struct coefficients *c = &ground->def.coefficients;
    return stored(xi_at(ground, x, y, c->xi0, c->noise), UNIT_XI);
}

/* What a brush wants at a cell `distance` from its drop (in shares of its reach). */
static struct local brush_at(const struct ground *ground, const struct brush *brush, int x, int y, float distance)
{
    int margin = ground->def.margin;
    struct local local = {.alpha_a = brush->alpha_a, .alpha_y = brush->alpha_y, .beta_a = brush->beta_a};
    local.s_max = brush->s_max * (1.0f + (brush->s_max_rim - 1.0f) * distance);
    if (brush->vary_s_max > 0.0f) {
        local.s_max *= 1.0f + brush->vary_s_max * vary_at(ground, x, y, brush->vary_size, RANDOM_VARY_S_MAX);
    }
    if (brush->vary_alpha_a > 0.0f) {
        local.alpha_a *= 1.0f + brush->vary_alpha_a * vary_at(ground, x, y, brush->vary_size, RANDOM_VARY_ALPHA_A);
    }
    if (brush->reaction_noise > 0.0f) {
        local.beta_a *=
            1.0f + brush->reaction_noise * random_signed(x - margin, y - margin, ground->def.seed, RANDOM_REACTION);
    }
    local.alpha_a = local.alpha_a > 0.02f ? local.alpha_a : 0.02f;
    local.xi = xi_at(ground, x, y, brush->xi0, brush->noise);
    local.weight = brush->weight > 0.0f ? brush->weight : isotropic_weight(&ground->def.coefficients, local.alpha_a);
    return local;
}

static void blend(struct local *to, const struct local *with, float share)
{
    to->alpha_a += share * (with->alpha_a - to->alpha_a);
    to->alpha_y += share * (with->alpha_y - to->alpha_y);
    to->beta_a += share * (with->beta_a - to->beta_a);
    to->s_max += share * (with->s_max - to->s_max);
    to->xi += share * (with->xi - to->xi);
    to->weight += share * (with->weight - to->weight);
}

/* Each cell follows the nearest drop, with a soft border half way between two. */
static void stamp_cell(struct ground *ground, int x, int y, const struct brush *brush, float distance, float reach)
{
    uint16_t *nearest = ground_stamped(ground, y) + x;
    float share = 1.0f - smooth_between(0.8f, 1.0f, distance / reach);
    if (*nearest != GROUND_NEVER_STAMPED) {
        float old = (float)*nearest * STAMP_UNIT;
        share *= smooth_between(0.42f, 0.58f, old / (old + distance + 1e-3f));
    }
    if (share <= 0.0f) {
        return;
    }
    struct local local = read_local(ground, x, y), wanted = brush_at(ground, brush, x, y, distance / reach);
    blend(&local, &wanted, share);
    write_local(ground, x, y, &local);
    uint16_t mine = stored(distance, STAMP_UNIT);
    *nearest = mine < *nearest ? mine : *nearest;
}

struct rectangle ground_stamp(struct ground *ground, int x, int y, int brush, float reach)
{
    int around = (int)reach + 1;
    struct rectangle cells = rectangle_clip((struct rectangle){x - around, x + around + 1, y - around, y + around + 1},
                                            ground->width, ground->height);
    for (int row = cells.y0; row < cells.y1; row++) {
        for (int column = cells.x0; column < cells.x1; column++) {
            float dx = (float)(column - x), dy = (float)(row - y), distance = sqrtf(dx * dx + dy * dy);
            if (distance < reach) {
                stamp_cell(ground, column, row, &brushes[brush], distance, reach);
            }
        }
    }
    return cells;
}

bool ground_varies(int coefficient)
{
    static const size_t VARYING[] = {offsetof(struct coefficients, alpha_a), offsetof(struct coefficients, alpha_y),
                                     offsetof(struct coefficients, beta_a),  offsetof(struct coefficients, s_max),
                                     offsetof(struct coefficients, xi0),     offsetof(struct coefficients, noise),
                                     offsetof(struct coefficients, weight)};
    bool varies = false;
    for (size_t i = 0; i < sizeof VARYING / sizeof VARYING[0]; i++) {
        varies = varies || coefficient_keys[coefficient].offset == VARYING[i];
    }
    return varies;
}

/* Writes one coefficient of a cell; false for one that does not vary over the sheet. */
static bool set_local(const struct ground *ground, struct local *local, size_t coefficient, float value, int x, int y)
{
    const struct coefficients *c = &ground->def.coefficients;
    if (coefficient == offsetof(struct coefficients, alpha_a)) {
        local->alpha_a = value;
        local->weight = isotropic_weight(c, value);
    } else if (coefficient == offsetof(struct coefficients, alpha_y)) {
        local->alpha_y = value;
    } else if (coefficient == offsetof(struct coefficients, beta_a)) {
        local->beta_a = value;
    } else if (coefficient == offsetof(struct coefficients, s_max)) {
        local->s_max = value;
    } else if (coefficient == offsetof(struct coefficients, xi0)) {
        local->xi = xi_at(ground, x, y, value, c->noise);
    } else if (coefficient == offsetof(struct coefficients, noise)) {
        local->xi = xi_at(ground, x, y, c->xi0, (int)value);
    } else if (coefficient == offsetof(struct coefficients, weight)) {
        local->weight = value > 0.0f ? value : isotropic_weight(c, local->alpha_a);
    } else {
        return false;
    }
    return true;
}

/* The value for the whole sheet, kept for what does not vary and for a sheet made fresh. */
static void set_everywhere(struct ground *ground, const struct key *key, float value)
{
    char *at = (char *)&ground->def.coefficients + key->offset;
    if (key->type == KEY_NUMBER) {
        memcpy(at, &value, sizeof value);
    } else {
        int whole = (int)value;
        memcpy(at, &whole, sizeof whole);
    }
}

static float value_for(const struct ground *ground, const struct action *action, const struct region *disc, int x,
                       int y, float *share)
{
    const struct action_raster *raster = action->formula.values ? &action->formula : &action->picture;
    float value = action->value;
    *share = 1.0f;
    if (raster->values) {
        float t = region_sample(&disc->canvas, raster, 0, x, y);
        value += (t < 0.0f ? 0.0f : t > 1.0f ? 1.0f : t) * (action->to - action->value);
    }
    if (action->vary > 0.0f) {
        value *= 1.0f + action->vary * vary_at(ground, x, y, action->size, RANDOM_VARY_SET);
    }
    if (disc->kind == REGION_DISC) {
        *share = 1.0f - smooth_between(0.5f, 1.0f, region_distance(disc, x, y, NULL) / disc->radius);
    }
    return value;
}

struct rectangle ground_set(struct ground *ground, const struct action *action)
{
    if (action->coefficient < 0 || action->coefficient >= key_count(coefficient_keys)) {
        return (struct rectangle){0, 0, 0, 0};
    }
    const struct key *key = &coefficient_keys[action->coefficient];
    struct action place = *action; /* only a disc bounds it: a raster gives values, not a region */
    place.formula = place.picture = (struct action_raster){0};
    struct canvas canvas = painting_canvas(&ground->def);
    struct region disc = region_of(&canvas, &place);
    if (disc.kind == REGION_ALL) {
        set_everywhere(ground, key, key_bound(key, action->value));
    }
    for (int y = disc.cells.y0; y < disc.cells.y1; y++) {
        for (int x = disc.cells.x0; x < disc.cells.x1; x++) {
            float share, value = key_bound(key, value_for(ground, action, &disc, x, y, &share));
            struct local local = read_local(ground, x, y), wanted = local;
            if (!set_local(ground, &wanted, key->offset, value, x, y)) {
                return (struct rectangle){0, ground->width, 0, ground->height};
            }
            blend(&local, &wanted, share);
            write_local(ground, x, y, &local);
        }
    }
    return disc.cells;
}
