/* What lightning leaves: where bolts were that have faded and been forgotten, for those who grow from a storm. */
#include <stdlib.h>
#include <string.h>

#include "rinse.h"
#include "rounded.h"
#include "storm_state.h"

static size_t cells_of(const struct storm *storm)
{
    return (size_t)storm->mask_columns * (size_t)storm->mask_rows;
}

void storm_scar_keep(struct storm *storm, int slot)
{
    size_t count = cells_of(storm);
    float *dark = malloc(count * sizeof *dark);
    if (!dark) {
        storm->failed = true;
        return;
    }
    for (size_t i = 0; i < count; i++) {
        dark[i] = 1;
    }
    storm_field_draw(storm, slot, storm->mask_columns, storm->mask_rows, dark);
    for (size_t i = 0; i < count; i++) {
        uint8_t covered = (uint8_t)(255 * (1 - dark[i]) + 0.5f);
        storm->scar[i] = covered > storm->scar[i] ? covered : storm->scar[i];
    }
    free(dark);
}

void storm_scar_wash(struct storm *storm, const float *phases, float strength)
{
    for (size_t i = 0; i < cells_of(storm); i++) {
        if (phases[i] > 0 && storm->scar[i] > 0) {
            storm->scar[i] = (uint8_t)((float)storm->scar[i] * (1 - rinse_takes(phases[i], strength)));
        }
    }
}

void storm_scar_clear(struct storm *storm)
{
    memset(storm->scar, 0, cells_of(storm));
}

/* Cells of the raster from..to, without `to`, under cell `at` of `count`. */
static void span(int at, int count, int cells, int *from, int *to)
{
    *from = (int)((int64_t)at * cells / count);
    *to = (int)((int64_t)(at + 1) * cells / count);
    *to = *to > *from ? *to : *from + 1;
}

void storm_scar_lay(const struct storm *storm, int width, int height, float *values)
{
    for (int y = 0; y < height; y++) {
        int top, bottom;
        span(y, height, storm->mask_rows, &top, &bottom);
        for (int x = 0; x < width; x++) {
            int left, right, most = 0;
            span(x, width, storm->mask_columns, &left, &right);
            for (int row = top; row < bottom; row++) {
                for (int column = left; column < right; column++) {
                    int covered = storm->scar[row * storm->mask_columns + column];
                    most = covered > most ? covered : most;
                }
            }
            float dark = (float)(255 - most) / 255, *here = &values[(size_t)y * (size_t)width + (size_t)x];
            *here = dark < *here ? rounded(dark) : *here;
        }
    }
}
