/* What a dish looks like. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "dish_state.h"
#include "ink.h"

/* Between these shares of the gradient v comes to hide the painting. */
#define HIDES_FROM 0.06f
#define HIDES_AT   0.3f

static void add_stop(struct dish *dish, const struct gradient *gradient, float at, float hides)
{
    if (dish->stop_count < DISH_STOPS) {
        struct gradient_stop *stop = &dish->stops[dish->stop_count++];
        stop->at = at;
        gradient_colour(gradient, at, stop->rgba);
        stop->rgba[3] *= hides;
    }
}

void dish_make_stops(struct dish *dish)
{
    const struct gradient *gradient = &gradients[dish->def.gradient].gradient;
    dish->stop_count = 0;
    add_stop(dish, gradient, 0, 0);
    add_stop(dish, gradient, HIDES_FROM, 0);
    for (int i = 0; i < gradient->count; i++) {
        float at = gradient->stops[i].at;
        if (at > HIDES_FROM && at < HIDES_AT) {
            add_stop(dish, gradient, at, (at - HIDES_FROM) / (HIDES_AT - HIDES_FROM));
        }
    }
    add_stop(dish, gradient, HIDES_AT, 1);
    for (int i = 0; i < gradient->count; i++) {
        if (gradient->stops[i].at > HIDES_AT) {
            add_stop(dish, gradient, gradient->stops[i].at, 1);
        }
    }
}

struct dish_view dish_view(const struct dish *dish, int64_t tick)
{
    const struct dish_def *def = &dish->def;
    struct dish_view view = {
        .pattern = {dish->seen, gray_scott_width(dish->chemistry), gray_scott_height(dish->chemistry)},
        .shade = gray_scott_shade_default_def(),
        .is_torus = def->torus,
        .clear = def->clear,
        .torus = torus_default_def()};
    view.shade.gradient = gradients[def->gradient].gradient;
    if (def->clear && !def->torus) { /* a body is not clear: the painting is behind it */
        view.shade.gradient = (struct gradient){dish->stops, dish->stop_count};
    }
    view.shade.low = def->low;
    view.shade.high = def->high;
    view.shade.relief = def->relief;
    double turns = (double)tick * (double)def->turn / 3600; /* ticks of a minute */
    view.torus.turn = (float)(turns - floor(turns));
    return view;
}

/* What lies there already, in linear light. */
static float *decode(int width, int height, const uint8_t *rgb)
{
    size_t count = 3 * (size_t)width * (size_t)height;
    float light[256], *texture = malloc(count * sizeof *texture);
    for (int i = 0; i < 256; i++) {
        light[i] = ink_decode((float)i / 255);
    }
    for (size_t i = 0; texture && i < count; i++) {
        texture[i] = light[rgb[i]];
    }
    return texture;
}

bool dish_view_lay(const struct dish_view *view, int width, int height, uint8_t *rgb)
{
    struct gray_scott_shade_def shade = view->shade;
    float *under = view->clear ? decode(width, height, rgb) : NULL;
    bool good = under || !view->clear;
    shade.texture = under;
    shade.texture_width = width;
    shade.texture_height = height;
    if (good && view->is_torus) {
        good = gray_scott_torus(&view->pattern, &shade, &view->torus, width, height, rgb);
    } else if (good) {
        gray_scott_shade(&view->pattern, &shade, width, height, rgb);
    }
    free(under);
    return good;
}

bool dish_lay(void *scene, int64_t tick, int width, int height, uint8_t *rgb)
{
    struct dish_view view = dish_view(scene, tick);
    return dish_view_lay(&view, width, height, rgb);
}
