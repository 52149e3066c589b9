#include "picture.h"

#include <stdlib.h>

#include "picture_resample.h"

struct grey {
    struct resample across, down;
    float *rows; /* [cells_y][width] resampled across */
};

static void grey_draw(const struct grey *grey, const float *plane, int cells_x, int cells_y, float white, float black,
                      uint8_t *rgb)
{
    int width = grey->across.count;
    int taps = grey->down.taps;
    float range = black - white;
    float scale = range > 0 || range < 0 ? 255 / range : 0;
    for (int y = 0; y < cells_y; y++) {
        resample_row(&grey->across, plane + (size_t)y * (size_t)cells_x, grey->rows + (size_t)y * (size_t)width);
    }
    for (int y = 0; y < grey->down.count; y++) {
        const float *weights = grey->down.weights + (size_t)y * (size_t)taps;
        const float *first = grey->rows + (size_t)grey->down.start[y] * (size_t)width;
        for (int x = 0; x < width; x++) {
            float sum = 0;
            for (int j = 0; j < taps; j++) {
                sum += weights[j] * first[(size_t)j * (size_t)width + (size_t)x];
            }
            float dark = (sum - white) * scale;
            dark = dark > 0 ? dark : 0;
            dark = dark < 255 ? dark : 255;
            uint8_t byte = (uint8_t)(255.5f - dark);
            *rgb++ = byte;
            *rgb++ = byte;
            *rgb++ = byte;
        }
    }
}

bool picture_grey(const float *plane, int cells_x, int cells_y, float white, float black, int width, int height,
                  uint8_t *rgb)
{
    if (cells_x < 1 || cells_y < 1 || width < 1 || height < 1 || cells_x > PICTURE_CELLS_MAX ||
        cells_y > PICTURE_CELLS_MAX || width > PICTURE_SIZE_MAX || height > PICTURE_SIZE_MAX) {
        return false;
    }
    struct grey grey = {0};
    bool made = resample_init(&grey.across, cells_x, width, 0.65f, 0.175f) &&
                resample_init(&grey.down, cells_y, height, 0.65f, 0.175f);
    grey.rows = malloc((size_t)cells_y * (size_t)width * sizeof *grey.rows);
    made = made && grey.rows;
    if (made) {
        grey_draw(&grey, plane, cells_x, cells_y, white, black, rgb);
    }
    free(grey.rows);
    resample_finish(&grey.across);
    resample_finish(&grey.down);
    return made;
}
