#include "hand.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "along.h"
#include "blur.h"
#include "rounded.h"

enum { LEVELS = 256 };

static const float AROUND = 8.0f; /* cells: how far what is around reaches */
static const float MOST = 0.98f;  /* share of the cells that stand out less than what counts as dark */
static const float LEAST = 16.0f; /* of 255: what stands out less is grain */

/* Mean brightness (Rec. 709 luma of the encoded values, 0..255) of the pixels of each cell. */
static void fill_cells(float *cells, int cells_x, int cells_y, const uint8_t *rgb, int width, int height)
{
    for (int y = 0; y < cells_y; y++) {
        int top = (int)((int64_t)y * height / cells_y), bottom = (int)((int64_t)(y + 1) * height / cells_y);
        for (int x = 0; x < cells_x; x++) {
            int left = (int)((int64_t)x * width / cells_x), right = (int)((int64_t)(x + 1) * width / cells_x);
            int64_t sum = 0;
            for (int j = top; j < bottom; j++) {
                for (int i = left; i < right; i++) {
                    const uint8_t *pixel = rgb + 3 * ((size_t)j * (size_t)width + (size_t)i);
                    sum += 54 * pixel[0] + 183 * pixel[1] + 19 * pixel[2];
                }
            }
            cells[y * cells_x + x] = (float)sum / (256.0f * (float)((bottom - top) * (right - left)));
        }
    }
}

/* The value that a share of the cells does not reach. */
static float quantile(const float *values, int count, float share)
{
    int levels[LEVELS] = {0}, sum = 0, level = 0;
    for (int i = 0; i < count; i++) {
        levels[values[i] > 0 ? values[i] < LEVELS - 1 ? (int)values[i] : LEVELS - 1 : 0]++;
    }
    while (level < LEVELS - 1 && (float)(sum += levels[level]) < share * (float)count) {
        level++;
    }
    return (float)level;
}

/* Brightness becomes how little each cell stands out; false: nothing does. */
static bool make_dark(float *values, int count)
{
    float ground = quantile(values, count, 0.5f);
    for (int i = 0; i < count; i++) {
        values[i] = fabsf(values[i] - ground);
    }
    float most = quantile(values, count, MOST);
    for (int i = 0; i < count && most >= LEAST; i++) {
        float out = values[i] < most ? values[i] / most : 1;
        values[i] = rounded(1 - out);
    }
    return most >= LEAST;
}

bool hand_picture(struct outcome *outcome, const uint8_t *rgb, int width, int height)
{
    int longer = width > height ? width : height, side = longer < HAND_SIDE ? longer : HAND_SIDE;
    int cells_x = (int)((int64_t)width * side / longer), cells_y = (int)((int64_t)height * side / longer);
    *outcome = (struct outcome){.width = cells_x > 0 ? cells_x : 1, .height = cells_y > 0 ? cells_y : 1};
    int count = outcome->width * outcome->height;
    float *spare = malloc((size_t)count * sizeof *spare);
    bool good = spare;
    for (int i = 0; i < SCENE_FIELDS; i++) {
        outcome->fields[i] = calloc((size_t)count * (size_t)scene_field_channels((enum scene_field)i), sizeof(float));
        good = good && outcome->fields[i];
    }
    float *dark = outcome->fields[FIELD_DARK], *around = outcome->fields[FIELD_AROUND];
    if (good) {
        fill_cells(dark, outcome->width, outcome->height, rgb, width, height);
        good = make_dark(dark, count) &&
               along_of_pattern(dark, outcome->width, outcome->height, outcome->fields[FIELD_ALONG]);
    }
    if (good) {
        memcpy(around, dark, (size_t)count * sizeof *around);
        blur_boxes(around, spare, outcome->width, outcome->height, AROUND);
    } else {
        outcome_finish(outcome);
    }
    free(spare);
    return good;
}
