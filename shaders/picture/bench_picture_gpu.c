#include "bench_picture_gpu.h"

#include <GLES3/gl31.h>

#include "picture_gpu_state.h"

enum {
    WHOLE = 16, /* bytes of a texel of floats, of halves, of the picture */
    HALF = 8,
    SHOWN = 4,
    KERNEL = 4, /* taps that are not there for the slopes alone */
};

struct picture_gpu_cost picture_gpu_count(const struct picture_gpu *picture)
{
    const struct picture_def *def = &picture->def;
    double pixels = (double)def->width * def->height;
    double cells = (double)def->cells_x * def->cells_y / pixels; /* a pixel */
    double tall = (double)def->cells_x * def->height / pixels;
    double step_x = (double)def->cells_x / def->width, step_y = (double)def->cells_y / def->height;
    double kernel_x = KERNEL * (step_x > 1 ? step_x : 1), kernel_y = KERNEL * (step_y > 1 ? step_y : 1);
    double window = (BROAD_TAPS + 3) / 4.0; /* a cell, of four that share one */
    struct picture_gpu_cost cost = {0};

    /* Tone, across, down: the ground thrice, the ink, what is blurred and its relief. */
    cost.fetches += cells * (1 + 160.0 / 128 + window + 3);
    cost.bytes += cells * (3 * WHOLE + WHOLE + 2 * WHOLE + 2 * WHOLE + HALF);
    cost.operations += cells * (2 * 4 * (BROAD_TAPS + WIDE_TAPS + NARROW_TAPS) / 4.0 * 2 + 120);
    /* Tall: first row, weights and surface of every tap, matter and inks of the kernel's. */
    cost.fetches += tall * (1 + 2 * picture->taps_down + 2 * kernel_y);
    cost.bytes += (cells + tall) * (2 * WHOLE + HALF);
    cost.operations += tall * (8 * picture->taps_down + 18 * kernel_y);
    /* Shade: the same across; weights again for the inks, grain, streaks, lattice, tone. */
    cost.shade_fetches = 1 + 2 * picture->taps_across + kernel_x + picture->taps_across + kernel_x + 1 + 1 + 4 + 1;
    cost.fetches += cost.shade_fetches;
    cost.bytes += tall * (2 * WHOLE + HALF) + SHOWN;
    cost.operations += 8 * picture->taps_across + 20 * kernel_x + 200;
    /* Show. */
    cost.fetches += 1;
    cost.bytes += 2 * SHOWN;
    cost.operations += 20;
    return cost;
}

struct picture_gpu_time picture_gpu_time(struct picture_gpu *picture, const struct fields *fields, unsigned framebuffer,
                                         int times, double (*seconds)(void))
{
    static const float upright[4] = {1, 0, 0, 1};
    struct picture_gpu_time best = {0, 0};
    picture_gpu_shade(picture, fields); /* drivers finish compiling at the first use */
    glFinish();
    for (int i = 0; i < times; i++) {
        double start = seconds();
        picture_gpu_shade(picture, fields);
        glFinish();
        double shaded = seconds();
        picture_gpu_present(picture, framebuffer, picture->def.width, picture->def.height, upright);
        glFinish();
        double shade = 1000 * (shaded - start), present = 1000 * (seconds() - shaded);
        best.shade_ms = i == 0 || shade < best.shade_ms ? shade : best.shade_ms;
        best.present_ms = i == 0 || present < best.present_ms ? present : best.present_ms;
    }
    return best;
}
