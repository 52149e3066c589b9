#include "territory.h"

#include <math.h>
#include <stdlib.h>

enum { NEAREST = 32 }; /* marks of a kind that are looked at for each cell of a tile */

#define FAR       1e9f
#define HALF_TILE 11.4f /* from the middle of a tile to its corners */
#define EDGE      1.5f  /* cells around a mark that are always its own */
#define CORE      4.0f  /* cells around what others did later that are always theirs */
#define SOFT      3.0f  /* cells over which what is put back fades into what stays */
#define CHAMFER   3     /* units of a cell: 3 along the axes, 4 along diagonals */

float mark_distance(const struct mark *mark, float x, float y)
{
    float dx = mark->x1 - mark->x0, dy = mark->y1 - mark->y0, px = x - mark->x0, py = y - mark->y0;
    float length = dx * dx + dy * dy, t = length > 0.0f ? (px * dx + py * dy) / length : 0.0f;
    t = t < 0.0f ? 0.0f : t > 1.0f ? 1.0f : t;
    px -= t * dx;
    py -= t * dy;
    return sqrtf(px * px + py * py) - mark->radius;
}

static int32_t least(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

bool territory_measure(struct territory *territory)
{
    int width = territory->box.x1 - territory->box.x0, height = territory->box.y1 - territory->box.y0;
    int across = width + 2;
    size_t cells = (size_t)across * (size_t)(height + 2);
    int32_t *units = malloc(cells * sizeof *units);
    territory->from_carved = malloc((size_t)width * (size_t)height * sizeof *territory->from_carved);
    if (!units || !territory->from_carved) {
        free(units);
        return false;
    }
    for (size_t i = 0; i < cells; i++) {
        units[i] = 1 << 20;
    }
    for (int y = 0; y < height; y++) {
        int32_t *row = units + (size_t)(y + 1) * (size_t)across + 1;
        const uint8_t *carved = territory->carved + (size_t)y * (size_t)width;
        for (int x = 0; x < width; x++) {
            int32_t near = least(row[x - 1], row[x - across]) + CHAMFER;
            near = least(near, least(row[x - across - 1], row[x - across + 1]) + CHAMFER + 1);
            row[x] = carved[x] ? 0 : near;
        }
    }
    for (int y = height - 1; y >= 0; y--) {
        int32_t *row = units + (size_t)(y + 1) * (size_t)across + 1;
        float *distance = territory->from_carved + (size_t)y * (size_t)width;
        for (int x = width - 1; x >= 0; x--) {
            int32_t near = least(row[x + 1], row[x + across]) + CHAMFER;
            near = least(near, least(row[x + across - 1], row[x + across + 1]) + CHAMFER + 1);
            row[x] = least(row[x], near);
            distance[x] = (float)row[x] * (1.0f / CHAMFER);
        }
    }
    free(units);
    return true;
}

/* The marks that can be the nearest of their kind to any cell of a tile; of very many, the first. */
struct nearest {
    const struct mark *marks[NEAREST];
    int count;
};

typedef bool mark_choice(const struct territory *territory, const struct mark *mark, uint32_t version);

static struct nearest find_nearest(const struct territory *territory, const struct mark *marks, int count,
                                   mark_choice *choose, uint32_t version, float x, float y)
{
    struct nearest nearest = {.count = 0};
    float best = FAR;
    for (int i = 0; i < count; i++) {
        if (choose(territory, &marks[i], version)) {
            float distance = mark_distance(&marks[i], x, y);
            best = distance < best ? distance : best;
        }
    }
    for (int i = 0; i < count && nearest.count < NEAREST; i++) {
        if (choose(territory, &marks[i], version) && mark_distance(&marks[i], x, y) <= best + 2.0f * HALF_TILE) {
            nearest.marks[nearest.count++] = &marks[i];
        }
    }
    return nearest;
}

static float distance_to(const struct nearest *nearest, float x, float y)
{
    float best = FAR;
    for (int i = 0; i < nearest->count; i++) {
        float distance = mark_distance(nearest->marks[i], x, y);
        best = distance < best ? distance : best;
    }
    return best;
}

static bool is_fresh(const struct territory *territory, const struct mark *mark, uint32_t version)
{
    (void)territory, (void)version;
    return mark->kind == MARK_GROWS && !mark->on_pattern;
}

static bool is_on_pattern(const struct territory *territory, const struct mark *mark, uint32_t version)
{
    (void)territory, (void)version;
    return mark->kind == MARK_GROWS && mark->on_pattern;
}

static bool is_still(const struct territory *territory, const struct mark *mark, uint32_t version)
{
    (void)territory, (void)version;
    return mark->kind == MARK_STILL;
}

static bool is_ground(const struct territory *territory, const struct mark *mark, uint32_t version)
{
    (void)territory, (void)version;
    return mark->kind == MARK_GROUND || mark->stamp > 0.0f;
}

static bool is_later(const struct territory *territory, const struct mark *mark, uint32_t version)
{
    return mark->counts && mark->group != territory->group && mark->moment >= version && mark->kind != MARK_GROUND;
}

/* By how many cells a cell is the group's rather than theirs who did something later: their growth began later, and its
 * own had come some way by then. `own`: distance to the group's nearest mark. */
static float before_others(const struct territory *territory, const struct nearest *others, float x, float y, float own)
{
    float margin = FAR;
    for (int i = 0; i < others->count; i++) {
        const struct mark *mark = others->marks[i];
        float distance = mark_distance(mark, x, y);
        float late = mark->moment > territory->begin ? (float)(mark->moment - territory->begin) : 0.0f;
        float lead = distance + late / territory->moments_a_cell - own, core = distance - CORE;
        margin = lead < margin ? lead : margin;
        margin = core < margin ? core : margin;
    }
    return margin;
}

struct near {
    struct nearest fresh, on_pattern, still, ground, others;
};

static float lesser(float a, float b)
{
    return a < b ? a : b;
}

static float greater(float a, float b)
{
    return a > b ? a : b;
}

/* By how many cells a cell lies inside the territory; `ground`: whether its ground does. */
static float depth_of(const struct territory *territory, const struct near *near, float x, float y, float from_carved,
                      uint8_t *ground)
{
    float fresh = distance_to(&near->fresh, x, y), flow = distance_to(&near->on_pattern, x, y);
    float still = distance_to(&near->still, x, y);
    float grown = lesser(territory->growth - fresh, greater(from_carved - fresh, EDGE - fresh));
    float depth = greater(grown, greater(territory->flow - flow, EDGE - still));
    float own = lesser(lesser(fresh, flow), lesser(still, distance_to(&near->ground, x, y)));
    float later = before_others(territory, &near->others, x, y, own);
    *ground = 0;
    for (int i = 0; i < near->ground.count; i++) {
        const struct mark *mark = near->ground.marks[i];
        float distance = mark_distance(mark, x, y) + (mark->stamp > 0.0f ? mark->radius - mark->stamp : 0.0f);
        *ground |= distance < 1.0f && later > 0.0f;
    }
    depth = lesser(depth, later);
    *ground |= depth > 0.0f;
    return depth;
}

bool territory_shares(const struct territory *territory, int x, int y, uint32_t version, float share[TILE_CELLS],
                      uint8_t ground[TILE_CELLS])
{
    const struct rectangle *box = &territory->box;
    float middle_x = (float)x + 0.5f * TILE, middle_y = (float)y + 0.5f * TILE;
    const struct mark *own = territory->own;
    int count = territory->own_count;
    struct near near = {
        .fresh = find_nearest(territory, own, count, is_fresh, version, middle_x, middle_y),
        .on_pattern = find_nearest(territory, own, count, is_on_pattern, version, middle_x, middle_y),
        .still = find_nearest(territory, own, count, is_still, version, middle_x, middle_y),
        .ground = find_nearest(territory, own, count, is_ground, version, middle_x, middle_y),
        .others =
            find_nearest(territory, territory->others, territory->other_count, is_later, version, middle_x, middle_y),
    };
    bool any = false;
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        int column = x + cell % TILE, row = y + cell / TILE;
        share[cell] = 0.0f;
        ground[cell] = 0;
        if (column >= box->x1 || row >= box->y1) {
            continue;
        }
        size_t at = (size_t)(row - box->y0) * (size_t)(box->x1 - box->x0) + (size_t)(column - box->x0);
        float depth = depth_of(territory, &near, (float)column + 0.5f, (float)row + 0.5f, territory->from_carved[at],
                               &ground[cell]);
        float part = 0.5f + depth / SOFT;
        share[cell] = part < 0.0f ? 0.0f : part > 1.0f ? 1.0f : part;
        any = any || share[cell] > 0.0f || ground[cell];
    }
    return any;
}
