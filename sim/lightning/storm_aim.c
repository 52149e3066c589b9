/* Where bolts begin, and what pulls them. */
#include <math.h>
#include <string.h>

#include "random.h"
#include "storm_state.h"

enum { CLOUDS = 11 };
static const float PULL = 0.06f;  /* of what lies beyond the hand, of 1000 particles, over the square of its distance */
static const float START = 0.05f; /* of that strength, before anything has grown */
static const float CROWDED = 0.08f; /* of the sheet's width, that a cloud is farther away for each unit of potential */
static const float HASTE = 1;       /* by how much eta rises with each 1000 particles of a strike: it comes to an end */
static const float HAND = 2;        /* cells of the growth: a hand's charge is not nearer */

struct aim {
    const struct storm *storm;
    float wide, high; /* cells of the growth, half of the sheet */
};

static void to_growth(const struct aim *aim, struct point at, float out[3])
{
    out[0] = (2 * at.x - 1) * aim->wide;
    out[1] = (2 * at.y - 1) * aim->high;
    out[2] = 0;
}

static bool allows(const struct storm *storm, struct point at)
{
    int x = (int)(at.x * (float)storm->mask_columns), y = (int)(at.y * (float)storm->mask_rows);
    x = x < storm->mask_columns ? x : storm->mask_columns - 1;
    y = y < storm->mask_rows ? y : storm->mask_rows - 1;
    return storm->mask[y * storm->mask_columns + x] >= 0.5f;
}

/* The place of the cloud from which it is nearest, and where no other bolt is. */
static bool choose_cloud(const struct storm *storm, struct point hand, struct point *cloud)
{
    float least = INFINITY;
    for (int i = 0; i < CLOUDS; i++) {
        float chance = random_unit(i, (int)storm->bolts_begun, (uint32_t)storm->def.seed, RANDOM_PLACE);
        struct point at = {((float)i + 0.15f + 0.7f * chance) / CLOUDS, 0.004f};
        float crowd = 0;
        for (int slot = 0; slot < STORM_SLOTS; slot++) {
            const struct storm_bolt *bolt = &storm->bolts[slot];
            crowd += bolt->lives && bolt->undone == 0 && bolt->potential
                         ? storm_sample(storm, bolt->potential, at.x, at.y) / (1 + (float)bolt->count)
                         : 0;
        }
        /* not straight above: a strike that leans is the more beautiful one */
        float away = fabsf(fabsf(at.x - hand.x) - 0.12f) + 0.1f * chance + CROWDED * 40 * crowd;
        if (allows(storm, at) && away < least) {
            least = away;
            *cloud = at;
        }
    }
    return least < INFINITY;
}

/* Places where the dark of a picture ends, on the mask's grid; every so many, so that there are `most` at the most. */
static int find_outline(const struct storm *storm, const struct action *action, const struct aim *aim,
                        struct laplacian_seed *seeds, int most)
{
    const struct canvas canvas = {.width = storm->mask_columns, .height = storm->mask_rows};
    struct region region = region_of(&canvas, action);
    int found = 0, count = 0, each = 1;
    for (int pass = 0; pass < 2; pass++) {
        found = 0;
        for (int y = 0; y < canvas.height; y++) {
            for (int x = 0; x < canvas.width; x++) {
                bool edge =
                    region_holds(&region, x, y) && ((x > 0 && !region_holds(&region, x - 1, y)) ||
                                                    (x + 1 < canvas.width && !region_holds(&region, x + 1, y)) ||
                                                    (y > 0 && !region_holds(&region, x, y - 1)) ||
                                                    (y + 1 < canvas.height && !region_holds(&region, x, y + 1)));
                if (edge && pass == 1 && found % each == 0 && count < most) {
                    struct point at = {((float)x + 0.5f) / (float)canvas.width,
                                       ((float)y + 0.5f) / (float)canvas.height};
                    to_growth(aim, at, seeds[count].from);
                    to_growth(aim, at, seeds[count].to);
                    count++;
                }
                found += edge;
            }
        }
        each = found / most + 1;
    }
    return count;
}

/* As of its kind, moved to the hand. Planes that end it stay where they are, and count only on this side. */
static void move_preset(struct bolt *preset, const float hand[3])
{
    float by[3];
    for (int d = 0; d < 3; d++) {
        by[d] = hand[d] - preset->seeds[0].from[d];
    }
    for (int i = 0; i < preset->growth.seed_count; i++) {
        for (int d = 0; d < 3; d++) {
            preset->seeds[i].from[d] += by[d];
            preset->seeds[i].to[d] += by[d];
        }
    }
    for (int i = 0; i < preset->growth.charge_count; i++) {
        struct laplacian_charge *charge = &preset->charges[i];
        if (charge->ends && charge->shape == LAPLACIAN_PLANE) {
            charge->ends = hand[1] < charge->at[1] - 4;
            continue;
        }
        for (int d = 0; d < 3; d++) {
            charge->at[d] += by[d];
        }
    }
}

bool storm_place(struct storm *storm, const struct action *action, struct storm_bolt *bolt, struct bolt *preset,
                 struct laplacian_seed *seeds, int most)
{
    struct aim aim = {storm, 0.5f * preset->growth.span, 0.5f * (float)storm->height / bolt->scale};
    bool drawn = action->formula.values || action->picture.values;
    float hand[3];
    if (!drawn && !action->has_at) {
        return false;
    }
    to_growth(&aim, action->at, hand);
    bolt->aims = bolt->kind == BOLT_LIGHTNING && action->has_at;
    bolt->target = action->at;
    int count = drawn ? find_outline(storm, action, &aim, seeds, most) : 0;
    if (drawn && count == 0) {
        return false;
    }
    if (!drawn && bolt->aims) {
        struct point cloud = {0.5f, 0};
        if (!choose_cloud(storm, action->at, &cloud)) {
            return false;
        }
        to_growth(&aim, cloud, seeds[0].from);
        to_growth(&aim, cloud, seeds[0].to);
        count = 1;
    } else if (!drawn) {
        move_preset(preset, hand);
        count = preset->growth.seed_count;
        memcpy(seeds, preset->seeds, (size_t)count * sizeof *seeds);
    }
    if (!bolt->aims && !drawn) {
        bolt->pull_count = preset->growth.charge_count;
        memcpy(bolt->pulls, preset->charges, (size_t)bolt->pull_count * sizeof *bolt->pulls);
    }
    memcpy(bolt->from, drawn ? hand : seeds[0].from, sizeof bolt->from);
    preset->growth.seeds = seeds;
    preset->growth.seed_count = count;
    return true;
}

/* A strike is drawn past its place, the more the longer it takes; and the nearer, the more by the place itself. */
static void aim_at(struct storm_bolt *bolt, const struct aim *aim)
{
    float at[3], grown = (float)bolt->count / 1000, strength = START + 0.5f * sqrtf(grown);
    to_growth(aim, bolt->target, at);
    float x = at[0] - bolt->from[0], y = at[1] - bolt->from[1], far = 4 * (x * x + y * y);
    bolt->pulls[0] = (struct laplacian_charge){
        .shape = LAPLACIAN_POINT, .charge = PULL * strength * far, .at = {at[0] + x, at[1] + y}};
    bolt->pulls[1] = (struct laplacian_charge){
        .shape = LAPLACIAN_POINT, .charge = 4000 * strength, .at = {at[0], at[1]}, .ends = true};
    bolt->pull_count = 2;
}

void storm_pull(struct storm *storm, struct storm_bolt *bolt)
{
    struct laplacian_charge charges[BOLT_CHARGES + STORM_HANDS];
    struct aim aim = {storm, 0.5f * bolt->width / bolt->scale, 0.5f * bolt->height / bolt->scale};
    if (bolt->aims) {
        aim_at(bolt, &aim);
        laplacian_eta(bolt->laplacian, storm->def.eta + HASTE * (float)bolt->count / 1000);
    }
    int count = bolt->pull_count;
    memcpy(charges, bolt->pulls, (size_t)count * sizeof *charges);
    for (int i = 0; i < STORM_HANDS; i++) {
        const struct storm_hand *hand = &storm->hands[i];
        if (hand->lies && hand->charge != 0) {
            charges[count] = (struct laplacian_charge){
                .shape = LAPLACIAN_POINT, .charge = storm_felt(bolt) * hand->charge, .radius = HAND};
            to_growth(&aim, hand->at, charges[count].at);
            count++;
        }
    }
    if (laplacian_charge(bolt->laplacian, charges, count)) {
        bolt->heard = storm->hands_changed;
        bolt->charged = storm->now;
        bolt->charged_count = bolt->count;
    } else {
        storm->failed = true;
    }
}
