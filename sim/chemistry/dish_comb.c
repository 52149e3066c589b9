/* Directions along which stripes run. */
#include <math.h>
#include <stdlib.h>

#include "dish_state.h"

/* Of each cell a vector; one and its opposite mean the same. */
static bool have(struct dish *dish)
{
    if (!dish->along) {
        dish->along = calloc(2 * dish_cells(dish), sizeof *dish->along);
    }
    dish->failed = dish->failed || !dish->along;
    return dish->along;
}

static void take_field(struct dish *dish, const struct action_raster *raster, float strength)
{
    int width = gray_scott_width(dish->chemistry), height = gray_scott_height(dish->chemistry);
    size_t count = (size_t)width * (size_t)height, from = (size_t)raster->width * (size_t)raster->height;
    if (raster->channels < 2 || !have(dish)) {
        return;
    }
    for (size_t channel = 0; channel < 2; channel++) {
        float *to = dish->along + channel * count;
        dish_sample(raster->values + channel * from, raster->width, raster->height, width, height, to);
        for (size_t i = 0; i < count; i++) {
            to[i] *= strength;
        }
    }
}

static void take_stroke(struct dish *dish, const struct action *action)
{
    int width = gray_scott_width(dish->chemistry), height = gray_scott_height(dish->chemistry);
    struct rectangle area =
        gray_scott_stroke_area(dish->chemistry, &action->path, action->radius * (float)width / (float)dish->width);
    if (action->path.count < 2 || !have(dish)) {
        return;
    }
    float *right = dish->along, *down = dish->along + dish_cells(dish);
    for (int y = area.y0; y < area.y1; y++) {
        for (int x = area.x0; x < area.x1; x++) {
            struct point at = {((float)x + 0.5f) * (float)dish->width / (float)width,
                               ((float)y + 0.5f) * (float)dish->height / (float)height},
                         to = {0, 0};
            float share = 1 - dish_apart(dish, &action->path, at, &to) / action->radius;
            size_t i = (size_t)y * (size_t)width + (size_t)x;
            if (share <= 0) {
                continue;
            }
            share = share < 0.5f ? 2 * share : 1;
            float length = right[i] * to.x + down[i] * to.y < 0 ? -fabsf(action->strength) : fabsf(action->strength);
            right[i] += share * (length * to.x - right[i]);
            down[i] += share * (length * to.y - down[i]);
        }
    }
}

void dish_comb(struct dish *dish, const struct action *action)
{
    const struct action_raster *raster = action->formula.values ? &action->formula : &action->picture;
    bool nothing = !(fabsf(action->strength) > 0);
    if (action->path.count > 0) {
        take_stroke(dish, action);
    } else if (nothing) {
        free(dish->along);
        dish->along = NULL;
    } else if (raster->values) {
        take_field(dish, raster, action->strength);
    } else {
        return;
    }
    dish->combed = true;
}
