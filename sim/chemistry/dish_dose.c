/* Chemicals, as they are dosed. */
#include <math.h>

#include "dish_state.h"
#include "gray_scott_state.h"
#include "piece.h"
#include "random.h"

/* More v than Pearson's seed has, so that a line two cells wide and a disc of three take with every preset that does
 * not fade. Where a large place is filled, u runs out and all of it can die: within RIM cells of its edge it is filled,
 * farther in there are drops. */
static const struct gray_scott_state DOSED = {0.4f, 0.5f};
#define THICK  8.0f /* cells: RIM of what is no stroke, so that letters stay whole */
#define EDGE   2.0f /* cells over which it fades */
#define RIM    3.0f
#define APART  13.0f /* cells from drop to drop, about */
#define RADIUS 2.5f  /* of a drop */
#define GAPS   0.4f  /* of the edge */
#define BROAD  9.0f  /* cells: radius from which a stroke is a large place */

struct rectangle dish_whole(const struct dish *dish)
{
    return (struct rectangle){0, gray_scott_width(dish->chemistry), 0, gray_scott_height(dish->chemistry)};
}

float dish_apart(const struct dish *dish, const struct action_path *path, struct point at, struct point *along)
{
    float wide = (float)dish->width, high = (float)dish->height, least = 1e30f;
    for (int i = 0; i < path->count; i++) {
        struct point a = path->points[i > 0 ? i - 1 : 0], b = path->points[i];
        float dx = (b.x - a.x) * wide, dy = (b.y - a.y) * high, square = dx * dx + dy * dy;
        float distance = piece_square(at.x - a.x * wide, at.y - a.y * high, dx, dy);
        if (distance < least) {
            float length = sqrtf(square);
            least = distance;
            *along = square > 0 ? (struct point){dx / length, dy / length} : *along;
        }
    }
    return sqrtf(least);
}

struct laying {
    const struct dish *dish;
    const struct action_path *path; /* NULL: the raster */
    const struct action_raster *raster;
    bool formula;
    float radius, strength;
    bool broad;  /* it is a stroke wider than lines are */
    int rim;     /* cells */
    float apart; /* cells from drop to drop; 0: it is filled */
};

/* Of the full dose, what a stroke or disc has at a place of the sheet: 1 where it is RIM cells within. */
static float of_stroke(const struct laying *laying, int x, int y, bool *within)
{
    const struct dish *dish = laying->dish;
    float cell = (float)dish->width / (float)gray_scott_width(dish->chemistry); /* of the sheet */
    struct point along, at = {((float)x + 0.5f) * cell,
                              ((float)y + 0.5f) * (float)dish->height / (float)gray_scott_height(dish->chemistry)};
    float inside = (laying->radius - dish_apart(dish, laying->path, at, &along)) / cell;
    float share = (inside + 0.5f * EDGE) / EDGE;
    *within = laying->broad && inside > (float)laying->rim;
    return share > 0 ? share < 1 ? share : 1 : 0;
}

/* Where a formula is not zero; the darker a picture is. */
static float of_raster(const struct laying *laying, int x, int y)
{
    const struct action_raster *raster = laying->raster;
    int width = gray_scott_width(laying->dish->chemistry), height = gray_scott_height(laying->dish->chemistry);
    x = x < 0 ? 0 : x < width ? x : width - 1;
    y = y < 0 ? 0 : y < height ? y : height - 1;
    if (laying->formula) {
        size_t at = (size_t)dish_nearest(y, height, raster->height) * (size_t)raster->width;
        return fabsf(raster->values[at + (size_t)dish_nearest(x, width, raster->width)]) > 0 ? 1 : 0;
    }
    return 1 - chemistry_sample(raster, 0, ((float)x + 0.5f) / (float)width, ((float)y + 0.5f) / (float)height);
}

/* Of the full dose, what drops have there: one in each square, somewhere about its middle. */
static float of_drops(const struct laying *laying, int x, int y)
{
    uint32_t seed = (uint32_t)laying->dish->def.reaction.seed;
    float apart = laying->apart, u = ((float)x + 0.5f) / apart, v = ((float)y + 0.5f) / apart;
    int column = (int)u, row = (int)v;
    float dx = u - (float)column - 0.3f - 0.4f * random_unit(2 * column, row, seed, RANDOM_CHEMISTRY);
    float dy = v - (float)row - 0.3f - 0.4f * random_unit(2 * column + 1, row, seed, RANDOM_CHEMISTRY);
    float share = (RADIUS / APART - sqrtf(dx * dx + dy * dy)) * apart / EDGE + 0.5f;
    return share > 0 ? share < 1 ? share : 1 : 0;
}

static bool covers(const struct laying *laying, int x, int y)
{
    return of_raster(laying, x, y) > 0.5f;
}

/* Whether a place of a raster is in the midst of it; whether it is at the edge of what is broad both ways. */
static bool in_midst(const struct laying *laying, int x, int y)
{
    int far = laying->rim + 1;
    return covers(laying, x - far, y) && covers(laying, x + far, y) && covers(laying, x, y - far) &&
           covers(laying, x, y + far);
}

static bool is_broad(const struct laying *laying, int x, int y)
{
    int far = 2 * laying->rim;
    return (covers(laying, x - far, y) || covers(laying, x + far, y)) &&
           (covers(laying, x, y - far) || covers(laying, x, y + far));
}

static float laid(void *context, int x, int y)
{
    const struct laying *laying = context;
    bool within = false, broad = laying->broad;
    float share = laying->path ? of_stroke(laying, x, y, &within) : of_raster(laying, x, y);
    if (share <= 0) {
        return 0;
    }
    if (!laying->path && laying->apart > 0) {
        within = in_midst(laying, x, y);
        broad = within || is_broad(laying, x, y);
    }
    if (within && laying->apart > 0) {
        share *= of_drops(laying, x, y);
    } else if (broad && laying->apart > 0) {
        int column = (int)((float)x / laying->apart), row = (int)((float)y / laying->apart);
        share = random_unit(column, -1 - row, (uint32_t)laying->dish->def.reaction.seed, RANDOM_CHEMISTRY) < GAPS
                    ? 0
                    : share;
    }
    return laying->strength * share;
}

void dish_dose(struct dish *dish, const struct action *action)
{
    const struct action_path disc = {&action->at, 1}, *path = action->path.count > 0 ? &action->path : &disc;
    bool raster = action->path.count == 0 && (action->formula.values || action->picture.values);
    float size = dish->def.reaction.size, cell = (float)dish->width / (float)gray_scott_width(dish->chemistry);
    struct laying laying = {.dish = dish,
                            .path = path,
                            .raster = action->formula.values ? &action->formula : &action->picture,
                            .formula = action->formula.values,
                            .radius = action->radius,
                            .strength = action->strength,
                            .rim = (int)((raster ? THICK : RIM) * size + 0.5f),
                            .apart = action->invert ? 0 : APART * size};
    if ((action->invert && dish->fresh) || (!raster && action->path.count == 0 && !action->has_at)) {
        return;
    }
    if (!action->invert && !raster) {
        float least = 1.5f * size * cell; /* less would not take */
        laying.radius = laying.radius > least ? laying.radius : least;
    }
    laying.path = raster ? NULL : path;
    if (!action->invert && !raster) { /* thinner than it was meant, or as something broad */
        float line = (RIM + 1) * size * cell;
        laying.broad = laying.radius > BROAD * size * cell;
        laying.radius = laying.broad || laying.radius < line ? laying.radius : line;
    }
    struct rectangle area =
        raster ? dish_whole(dish) : gray_scott_stroke_area(dish->chemistry, path, laying.radius / cell);
    gray_scott_bring(dish->chemistry, area, laid, &laying,
                     action->invert ? gray_scott_brush_state(CHEMISTRY_ERASE) : DOSED);
    dish->fresh = dish->fresh && !(action->strength > 0);
    dish->sown = dish->sown && !action->invert;
    dish->sows = dish->fresh ? dish->sows : 0;
    dish->starts = dish->starts && dish->fresh;
}
