/* Ways of a garden: round hands, to seeds beyond the picture, and apart where the structures of two seeds meet. */
#include <stdlib.h>
#include <string.h>

#include "garden_state.h"
#include "piece.h"

enum {
    UNKNOWN = 254, /* owners */
    NOBODY = 255,
    EVEN_WEIGHT = 800, /* half of what counts for who is nearest, so that every seed has its share */
    WAY_CHEAPER = 8,   /* outside the picture, where nothing else would take a seed there */
};

static const float STEM = 0.6f; /* of the lattice's detail: how far a stem goes at most through what does not matter */
static const float WAY_WIDE = 0.03f; /* of the lattice's detail: half the width of a way to a seed */

/* Fills bed->seeds; how many more they are than before, where those of before are the first of them, else -1. */
static int32_t place_seeds(struct garden *garden)
{
    struct bed *bed = garden->bed;
    int32_t count = 0;
    bool same = true;
    for (int i = 0; i < garden->seed_count; i++) {
        int x = (int)(garden->seeds[i].at.x * (float)bed->width);
        int y = (int)(garden->seeds[i].at.y * (float)bed->height);
        int32_t node =
            lattice_node(bed->base, x < bed->width ? x : bed->width - 1, y < bed->height ? y : bed->height - 1);
        bool fresh = garden->seeds[i].undone == 0;
        for (int32_t k = 0; k < count; k++) {
            fresh = fresh && bed->seeds[k] != node; /* two in one place are one */
        }
        if (fresh) {
            same = same && (count >= bed->seed_count || bed->seeds[count] == node);
            bed->seeds[count] = node;
            bed->owners[count++] = i;
        }
    }
    int32_t more = same && bed->seed_count > 0 ? count - bed->seed_count : -1;
    bed->seed_count = count;
    return more;
}

/* The square of the distance of a node to the line from a seed to the middle of the picture. */
static float off_way(const struct bed *bed, int32_t seed, int x, int y)
{
    float x0 = (float)lattice_x(bed->base, seed), y0 = (float)lattice_y(bed->base, seed);
    float dx = 0.5f * (float)(bed->picture.x0 + bed->picture.x1) - x0;
    float dy = 0.5f * (float)(bed->picture.y0 + bed->picture.y1) - y0;
    return piece_square((float)x - x0, (float)y - y0, dx, dy);
}

static uint16_t legal(unsigned weight)
{
    return (uint16_t)(weight < 1 ? 1 : weight > LATTICE_WEIGHT_MAX ? LATTICE_WEIGHT_MAX : weight);
}

/* A way to a seed that lies beyond the picture. */
static void open_way(struct bed *bed, int32_t seed)
{
    int longer = bed->width > bed->height ? bed->width : bed->height;
    float wide = WAY_WIDE * (float)longer;
    wide = wide > 3 ? wide : 3;
    for (int y = 0; y < bed->height; y++) {
        for (int x = 0; x < bed->width; x++) {
            int32_t node = lattice_node(bed->base, x, y);
            if (bed->spare[node] == 0 && off_way(bed, seed, x, y) < wide * wide) {
                bed->spare[node] = legal((unsigned)bed->full[node] * bed->uneven[node] / GARDEN_EVEN / WAY_CHEAPER);
            }
        }
    }
}

struct hand {
    float x, y, radius; /* nodes */
};

/* Seeds under the hand; of them growth comes out on their side of it. */
static int32_t seeds_under(const struct bed *bed, const struct hand *hand, int32_t under[GARDEN_SEEDS])
{
    int32_t count = 0;
    for (int32_t i = 0; i < bed->seed_count; i++) {
        float dx = (float)lattice_x(bed->base, bed->seeds[i]) - hand->x;
        float dy = (float)lattice_y(bed->base, bed->seeds[i]) - hand->y;
        if (dx * dx + dy * dy < hand->radius * hand->radius) {
            under[count++] = bed->seeds[i];
        }
    }
    return count;
}

static void lay_hand(struct bed *bed, const struct hand *hand)
{
    int32_t under[GARDEN_SEEDS], count = seeds_under(bed, hand, under);
    struct rectangle place = {(int)(hand->x - hand->radius) - 1, (int)(hand->x + hand->radius) + 2,
                              (int)(hand->y - hand->radius) - 1, (int)(hand->y + hand->radius) + 2};
    place = rectangle_clip(place, bed->width, bed->height);
    for (int y = place.y0; y < place.y1; y++) {
        for (int x = place.x0; x < place.x1; x++) {
            float dx = (float)x - hand->x, dy = (float)y - hand->y, far = dx * dx + dy * dy;
            bool free = far >= hand->radius * hand->radius;
            for (int32_t i = 0; i < count; i++) {
                float ex = (float)(x - lattice_x(bed->base, under[i]));
                float ey = (float)(y - lattice_y(bed->base, under[i]));
                free = free || ex * ex + ey * ey <= far;
            }
            if (!free) {
                bed->spare[lattice_node(bed->base, x, y)] = 0;
            }
        }
    }
}

/* The weights of `spare` into a lattice; the rectangle in which they differ from those before. */
static struct rectangle change(const struct bed *bed, struct lattice *lattice)
{
    struct rectangle all = {0, 0, 0, 0};
    for (int y = 0; y < bed->height; y++) {
        int32_t from = lattice_node(lattice, 0, y);
        const uint16_t *now = bed->spare + from, *before = lattice->weight + from;
        if (memcmp(now, before, (size_t)bed->width * sizeof *now) == 0) {
            continue;
        }
        int x0 = 0, x1 = bed->width;
        while (now[x0] == before[x0]) {
            x0++;
        }
        while (now[x1 - 1] == before[x1 - 1]) {
            x1--;
        }
        struct rectangle row = {x0, x1, y, y + 1};
        all = rectangle_is_empty(all) ? row : rectangle_join(all, row);
    }
    memcpy(lattice->weight, bed->spare, (size_t)lattice->nodes * sizeof *lattice->weight);
    return all;
}

/* By the maximum, a seed where nothing matters would have all ways alike, which are straight then. So each has a stem
 * first, the cheapest way to a better place near by, and the rest grows from that. Whether the stems are as before. */
static bool lead_stems(struct bed *bed)
{
    const int32_t *toward = routes_toward(bed->near);
    uint64_t best[GARDEN_SEEDS];
    uint64_t worth = (uint64_t)(STEM * GARDEN_DETAIL * bed->unit * 2 * ROUTES_AXIS);
    for (int32_t i = 0; i < bed->seed_count; i++) {
        bed->stems[i] = bed->seeds[i];
        best[i] = worth * bed->full[bed->seeds[i]];
    }
    for (int32_t node = 0; node < bed->base->nodes; node++) {
        int owner = bed->owner[node];
        if (owner < bed->seed_count && toward[node] >= 0) {
            uint64_t cost = routes_sum(bed->near, node) + worth * bed->full[node];
            bed->stems[owner] = cost < best[owner] ? node : bed->stems[owner];
            best[owner] = cost < best[owner] ? cost : best[owner];
        }
    }
    int32_t count = 0;
    bool same = true;
    for (int32_t i = 0; i < bed->seed_count; i++) {
        for (int32_t node = bed->stems[i]; node >= 0; node = toward[node]) {
            same = same && count < bed->root_count && bed->roots[count] == node;
            bed->roots[count++] = node;
        }
    }
    same = same && count == bed->root_count;
    bed->root_count = count;
    return same;
}

/* Whose each node is, from the ways to the nearest seed. */
static void share_out(struct bed *bed)
{
    const int32_t *toward = routes_toward(bed->near);
    memset(bed->owner, UNKNOWN, (size_t)bed->base->nodes);
    for (int32_t i = 0; i < bed->seed_count; i++) {
        bed->owner[bed->seeds[i]] = (uint8_t)i;
    }
    for (int32_t i = 0; i < bed->base->nodes; i++) {
        int32_t node = i;
        while (bed->owner[node] == UNKNOWN && toward[node] >= 0) {
            node = toward[node];
        }
        uint8_t owner = bed->owner[node] == UNKNOWN ? NOBODY : bed->owner[node];
        for (node = i; bed->owner[node] == UNKNOWN; node = toward[node] >= 0 ? toward[node] : node) {
            bed->owner[node] = owner;
        }
    }
}

static uint16_t real_weight(const struct bed *bed, int32_t node)
{
    uint16_t open = bed->open->weight[node], base = bed->base->weight[node];
    return open > 0 && base > 0 ? base : open;
}

/* Walls along the borders: on the side of the later seed. */
static void part(struct bed *bed)
{
    const struct lattice *open = bed->open;
    for (int32_t i = 0; i < open->nodes; i++) {
        bed->spare[i] = real_weight(bed, i);
    }
    for (int y = 0; y < bed->height; y++) {
        for (int x = 0; x < bed->width; x++) {
            int32_t node = lattice_node(open, x, y);
            for (int d = 0; d < LATTICE_NEIGHBOURS && bed->owner[node] < bed->seed_count; d++) {
                int32_t next = node + open->step[d];
                if (open->weight[next] > 0 && bed->owner[next] < bed->owner[node]) {
                    bed->spare[node] = 0;
                }
            }
        }
    }
    for (int32_t i = 0; i < bed->root_count; i++) {
        bed->spare[bed->roots[i]] = real_weight(bed, bed->roots[i]);
    }
}

/* Ways to the nearest seed, where so many seeds more are there (-1: others), and weights have changed. */
static bool find_nearest(struct bed *bed, struct rectangle changed, int32_t more)
{
    if (more < 0 || (more > 0 && !rectangle_is_empty(changed))) { /* a way from beyond the picture changes much */
        return routes_plan(bed->near, METRIC_CUMULATIVE, 0, bed->seeds, bed->seed_count);
    }
    bool good = true;
    for (int32_t i = bed->seed_count - more; i < bed->seed_count && good; i++) {
        good = routes_add(bed->near, bed->seeds[i]);
    }
    return good && (rectangle_is_empty(changed) || routes_replan(bed->near, changed));
}

bool garden_route(struct garden *garden, bool anew)
{
    struct bed *bed = garden->bed;
    int32_t more = place_seeds(garden);
    enum metric metric = (enum metric)garden->def.growth.metric;
    int emphasis = garden->def.growth.emphasis;
    for (int32_t i = 0; i < bed->base->nodes; i++) {
        unsigned weight = (EVEN_WEIGHT + (unsigned)bed->base->weight[i]) / 2 * bed->uneven[i] / GARDEN_EVEN;
        bed->spare[i] = bed->base->weight[i] > 0 ? legal(weight) : 0;
    }
    for (int32_t i = 0; i < bed->seed_count; i++) {
        if (bed->base->weight[bed->seeds[i]] == 0) {
            open_way(bed, bed->seeds[i]);
        }
    }
    for (int i = 0; i < GARDEN_HOLDS; i++) {
        const struct hold *hold = &garden->holds[i];
        struct point at = garden_node_place(garden, hold->at);
        struct hand hand = {at.x, at.y, hold->radius * garden_node_scale(garden)};
        if (hold->lies) {
            lay_hand(bed, &hand);
        }
    }
    struct rectangle changed = change(bed, bed->open);
    if (bed->seed_count == 0) {
        return true;
    }
    if (!find_nearest(bed, changed, anew ? -1 : more)) {
        return false;
    }
    share_out(bed);
    bool same = lead_stems(bed);
    part(bed);
    changed = change(bed, bed->walled);
    return anew || !same ? routes_plan(bed->routes, metric, emphasis, bed->roots, bed->root_count)
                         : rectangle_is_empty(changed) || routes_replan(bed->routes, changed);
}

int garden_owner(const struct bed *bed, int32_t node)
{
    int owner = bed->owner[node];
    return bed->owners[owner < bed->seed_count ? owner : 0];
}
