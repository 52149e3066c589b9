/* A dish as rasters for other scenes. */
#include <math.h>
#include <stdlib.h>

#include "blur.h"
#include "dish_state.h"
#include "gray_scott_state.h"
#include "rounded.h"

void dish_sample(const float *plane, int columns, int rows, int width, int height, float *values)
{
    const struct action_raster raster = {plane, columns, rows, 1};
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            values[(size_t)y * (size_t)width + (size_t)x] =
                chemistry_sample(&raster, 0, ((float)x + 0.5f) / (float)width, ((float)y + 0.5f) / (float)height);
        }
    }
}

/* A plane of the chemistry's cells. */
static void sample_own(const struct dish *dish, const float *plane, int width, int height, float *values)
{
    dish_sample(plane, gray_scott_width(dish->chemistry), gray_scott_height(dish->chemistry), width, height, values);
}

/* The gradient of v as a vector of twice its angle, whose length is its square: opposite slopes of a stripe agree. */
static void slopes(const struct dish *dish, float *cosine, float *sine, float *square)
{
    int width = gray_scott_width(dish->chemistry), height = gray_scott_height(dish->chemistry);
    int boundary = dish->def.reaction.boundary;
    for (int y = 0; y < height; y++) {
        const float *above = gray_scott_v(dish->chemistry, chemistry_wrap(boundary, y - 1, height));
        const float *below = gray_scott_v(dish->chemistry, chemistry_wrap(boundary, y + 1, height));
        const float *own = gray_scott_v(dish->chemistry, y);
        for (int x = 0; x < width; x++) {
            float right = own[chemistry_wrap(boundary, x + 1, width)] - own[chemistry_wrap(boundary, x - 1, width)];
            float down = below[x] - above[x];
            size_t i = (size_t)y * (size_t)width + (size_t)x;
            cosine[i] = right * right - down * down;
            sine[i] = 2 * (right * down);
            square[i] = right * right + down * down;
        }
    }
}

/* Half the angle and a quarter more: along the stripe, never to the left. Shorter where slopes disagree. */
static void turn(float cosine, float sine, float square, float *x, float *y)
{
    const float faint = 1e-6f; /* square of a slope that is none */
    float length = sqrtf(cosine * cosine + sine * sine);
    float share = square > 0 ? length / (square + faint) : 0, half = length > 0 ? cosine / length : 1;
    half = half > -1 ? half < 1 ? half : 1 : -1;
    share = share < 1 ? share : 1;
    float across = sqrtf(0.5f * (1 + half)), down = sqrtf(0.5f * (1 - half)); /* of the slope, to the right */
    *x = share * down;
    *y = sine > 0 ? -share * across : share * across;
}

static bool along(const struct dish *dish, int width, int height, float *values)
{
    const float sigma = 3; /* cells: some half a stripe */
    size_t cells = dish_cells(dish), count = (size_t)width * (size_t)height;
    int columns = gray_scott_width(dish->chemistry), rows = gray_scott_height(dish->chemistry);
    float *planes = malloc((4 * cells + count) * sizeof *planes);
    if (!planes) {
        return false;
    }
    float *cosine = planes, *sine = planes + cells, *square = sine + cells, *spare = square + cells;
    slopes(dish, cosine, sine, square);
    for (int i = 0; i < 3; i++) {
        blur_boxes(planes + (size_t)i * cells, spare, columns, rows, sigma);
    }
    float *squares = spare + cells;
    sample_own(dish, cosine, width, height, values);
    sample_own(dish, sine, width, height, values + count);
    sample_own(dish, square, width, height, squares);
    for (size_t i = 0; i < count; i++) {
        float x, y;
        turn(values[i], values[count + i], squares[i], &x, &y);
        values[i] = rounded(x);
        values[count + i] = rounded(y);
    }
    free(planes);
    return true;
}

bool dish_field(void *scene, enum scene_field field, int width, int height, float *values)
{
    const struct dish *dish = scene;
    size_t cells = dish_cells(dish), count = (size_t)width * (size_t)height;
    if (field == FIELD_ALONG) {
        return along(dish, width, height, values);
    }
    float *planes = malloc(2 * cells * sizeof *planes);
    if (!planes) {
        return false;
    }
    gray_scott_save(dish->chemistry, planes, planes + cells);
    sample_own(dish, field == FIELD_DARK ? planes + cells : planes, width, height, values);
    for (size_t i = 0; i < count; i++) {
        float grown = (values[i] - dish->def.low) / (dish->def.high - dish->def.low);
        float value = field == FIELD_DARK ? 1 - grown : values[i];
        values[i] = rounded(value > 0 ? value < 1 ? value : 1 : 0);
    }
    free(planes);
    return true;
}

bool dish_plane(void *scene, int plane, int width, int height, float *values)
{
    const struct dish *dish = scene;
    size_t cells = dish_cells(dish);
    float *planes = malloc(2 * cells * sizeof *planes);
    if (planes) {
        gray_scott_save(dish->chemistry, planes, planes + cells);
        sample_own(dish, planes + (size_t)plane * cells, width, height, values);
    }
    bool good = planes;
    free(planes);
    return good;
}
