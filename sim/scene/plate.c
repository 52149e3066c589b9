#include "plate.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

bool plate_init(struct plate *plate, int width, int height)
{
    size_t pixels = (size_t)width * (size_t)height;
    *plate = (struct plate){.width = width, .height = height};
    plate->rgba = calloc(pixels, 4);
    plate->birth = malloc(pixels * sizeof *plate->birth);
    if (!plate->rgba || !plate->birth) {
        plate_finish(plate);
        return false;
    }
    plate_clear(plate);
    return true;
}

void plate_finish(struct plate *plate)
{
    free(plate->rgba);
    free(plate->birth);
    *plate = (struct plate){0};
}

void plate_clear(struct plate *plate)
{
    size_t pixels = (size_t)plate->width * (size_t)plate->height;
    memset(plate->rgba, 0, pixels * 4);
    for (size_t i = 0; i < pixels; i++) {
        plate->birth[i] = FLT_MAX;
    }
}

/* One channel, multiplied by alpha, over another; shares are of 255 * 65536. */
static uint8_t over(uint8_t below, uint8_t above, unsigned alpha, unsigned shown)
{
    unsigned left = 255 * 65536 - alpha * shown;
    return (uint8_t)(((uint64_t)below * left + (uint64_t)above * shown * 255 + 255 * 32768) / (255 * 65536));
}

void plate_reveal(const struct plate *plate, int64_t tick, uint8_t *rgb)
{
    size_t pixels = (size_t)plate->width * (size_t)plate->height;
    float age = (float)(tick - plate->tick);
    bool grounded = plate->ground[3] > 0;
    for (size_t i = 0; i < pixels; i++) {
        const uint8_t *own = plate->rgba + 4 * i;
        uint8_t *out = rgb + 3 * i;
        for (int c = 0; c < 3 && grounded; c++) {
            out[c] = over(out[c], plate->ground[c], plate->ground[3], 65536);
        }
        float up = (age - plate->birth[i]) / PLATE_SOFT;
        if (own[3] == 0 || !(up > 0)) {
            continue;
        }
        up = up < 1 ? up : 1;
        unsigned shown = (unsigned)(up * up * (3 - 2 * up) * 65536);
        for (int c = 0; c < 3; c++) {
            out[c] = over(out[c], own[c], own[3], shown);
        }
    }
}
