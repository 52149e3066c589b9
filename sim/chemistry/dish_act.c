/* What visitors do to a dish. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "dish_state.h"
#include "gray_scott_state.h"
#include "rinse.h"

int dish_nearest(int at, int cells, int wide)
{
    return (int)(((float)at + 0.5f) * (float)wide / (float)cells);
}

void dish_style(struct dish *dish, const struct action *action)
{
    const struct action_raster *raster = action->formula.values ? &action->formula : &action->picture;
    size_t count = (size_t)raster->width * (size_t)raster->height * (size_t)raster->channels;
    float *values = raster->values ? malloc(count * sizeof *values) : NULL;
    if (raster->values && !values) {
        dish->failed = true;
        return;
    }
    for (size_t i = 0; values && i < count; i++) {
        float value = raster->values[i];
        values[i] = value > 0 ? value < 1 ? value : 1 : 0; /* not a number: 0 */
    }
    free(dish->style);
    dish->style = values;
    dish->map = *raster;
    dish->map.values = values;
    dish->failed = !gray_scott_style(dish->chemistry, values ? &dish->map : NULL) || dish->failed;
    dish_set(dish);
}

struct washing {
    const struct dish *dish;
    struct canvas canvas;
    float strength;
    struct rinse rinse;
};

static float washed(void *context, int x, int y)
{
    struct washing *washing = context;
    int column = dish_nearest(x, gray_scott_width(washing->dish->chemistry), washing->canvas.width);
    int row = dish_nearest(y, gray_scott_height(washing->dish->chemistry), washing->canvas.height);
    const struct rectangle *cells = &washing->rinse.cells;
    if (column < cells->x0 || column >= cells->x1 || row < cells->y0 || row >= cells->y1) {
        return 0;
    }
    float turn, phase = rinse_phase(&washing->rinse, column, row, &turn);
    return rinse_takes(phase, washing->strength);
}

void dish_rinse(struct dish *dish, const struct action *action)
{
    struct washing *washing = NULL;
    if (!action->has_at && action->path.count == 0) {
        return;
    }
    dish->sows = 0;
    if (dish->fresh) {
        return;
    }
    dish->sown = false;
    washing = malloc(sizeof *washing);
    if (!washing) {
        dish->failed = true;
        return;
    }
    *washing = (struct washing){
        .dish = dish, .canvas = {.width = dish->width, .height = dish->height}, .strength = action->strength};
    rinse_begin(&washing->rinse, &washing->canvas, action);
    gray_scott_bring(dish->chemistry, dish_whole(dish), washed, washing, gray_scott_brush_state(CHEMISTRY_ERASE));
    free(washing);
}

void dish_clear(struct dish *dish)
{
    gray_scott_fill(dish->chemistry, 1, 0);
    memset(dish->seen, 0, dish_cells(dish) * sizeof *dish->seen);
    dish->combed = dish->combed || dish->along;
    free(dish->dry);
    free(dish->along);
    dish->dry = dish->along = NULL;
    dish->all_dry = dish->owed = 0;
    dish->fresh = true;
    dish->starts = dish->sown = false;
    dish->sowings = 0;
    dish->sows = 0;
}

/* A share more of what is not dry yet, or less of what is. */
static float dried(float was, float share, bool wet)
{
    return wet ? was - share * was : was + share * (1 - was);
}

/* How dry each cell is, the whole sheet counted in. */
static bool spread_dry(struct dish *dish)
{
    size_t count = dish_cells(dish);
    if (!dish->dry) {
        dish->dry = calloc(count, sizeof *dish->dry);
    }
    for (size_t i = 0; dish->dry && i < count && dish->all_dry > 0; i++) {
        dish->dry[i] = dried(dish->dry[i], dish->all_dry, false);
    }
    dish->all_dry = dish->dry ? 0 : dish->all_dry;
    return dish->dry;
}

void dish_dry(struct dish *dish, const struct action *action, bool wet)
{
    if (action->has_at && !spread_dry(dish)) {
        dish->failed = true;
        return;
    }
    if (!action->has_at) {
        dish->all_dry = dried(dish->all_dry, action->amount, wet);
    }
    if (!action->has_at && wet && action->amount >= 1) {
        free(dish->dry);
        dish->dry = NULL;
    }
    int width = gray_scott_width(dish->chemistry), height = gray_scott_height(dish->chemistry);
    for (int y = 0; dish->dry && (wet || action->has_at) && y < height; y++) {
        float down = (((float)y + 0.5f) / (float)height - action->at.y) * (float)dish->height;
        for (int x = 0; x < width; x++) {
            float right = (((float)x + 0.5f) / (float)width - action->at.x) * (float)dish->width;
            float inside =
                (action->radius - sqrtf(right * right + down * down)) / 4; /* cells that the edge fades over */
            float share = !action->has_at ? 1 : inside > 0 ? inside < 1 ? inside : 1 : 0;
            float *cell = &dish->dry[(size_t)y * (size_t)width + (size_t)x];
            *cell = dried(*cell, share * action->amount, wet);
        }
    }
}
