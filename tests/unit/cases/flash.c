#include "flash.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>

enum {
    BLOCKS = FLASH_BLOCKS * FLASH_BLOCKS,
    PLACES = FLASH_BLOCKS - FLASH_WINDOW + 1, /* of a window, across and down */
    QUARTER = FLASH_WINDOW * FLASH_WINDOW / 4,
    TIMES = 128,  /* transitions that are kept: more than frames in a second */
    FRAMES = 512, /* means that are kept */
    SECOND = 1000000,
    MOMENT = 50000, /* us: transitions this near to one another are one */
};
/* A fifth of the CIE 1976 chromaticity diagram, looked at along four axes: no distance is shorter than its longest
 * projection by more than this. */
#define RED_STEP  (0.2f * 0.9239f)
#define SATURATED 0.8f /* red of all light */

/* Transitions of one value: from its last extreme by a step or more. */
struct swing {
    float least, most;              /* since the last transition */
    bool least_marked, most_marked; /* what the mark of frames was there: saturated red */
    int direction;                  /* of the last; 0: none */
    uint64_t times[TIMES];
    int64_t count;
};

enum { GENERAL, RED, AXES = 4, KINDS = RED + AXES };

struct flash {
    int width, height;
    float linear[256];
    struct swing blocks[KINDS][BLOCKS];
    struct swing windows[KINDS][PLACES * PLACES]; /* `times` and `count` alone: concurrent transitions */
    double means[FRAMES];
    uint64_t times[FRAMES];
    struct flash_worst worst;
};

struct flash *flash_begin(int width, int height)
{
    struct flash *flash = calloc(1, sizeof *flash);
    assert_non_null(flash);
    assert_true(width >= FLASH_BLOCKS && height >= FLASH_BLOCKS);
    flash->width = width;
    flash->height = height;
    for (int i = 0; i < 256; i++) {
        float display = (float)i / 255;
        flash->linear[i] = display <= 0.04045f ? display / 12.92f : powf((display + 0.055f) / 1.055f, 2.4f);
    }
    return flash;
}

void flash_end(struct flash *flash)
{
    free(flash);
}

static void note(struct swing *swing, int direction, uint64_t time_us)
{
    swing->direction = direction;
    swing->times[swing->count++ % TIMES] = time_us;
}

static void restart(struct swing *swing, float value, bool marked)
{
    swing->least = swing->most = value;
    swing->least_marked = swing->most_marked = marked;
}

/* Luminance: the darker end must be dark enough. Red: either end must be marked. */
static bool counts(int kind, float darker, bool one_marked, bool other_marked)
{
    return kind == GENERAL ? darker < FLASH_DARKER : one_marked || other_marked;
}

static void follow(struct swing *swing, int kind, float value, bool marked, uint64_t time_us)
{
    const float step = (kind == GENERAL ? FLASH_STEP : RED_STEP) - 1e-5f;
    if (value <= swing->least) {
        swing->least = value;
        swing->least_marked = marked;
    }
    if (value >= swing->most) {
        swing->most = value;
        swing->most_marked = marked;
    }
    if (swing->direction <= 0 && value - swing->least >= step &&
        counts(kind, swing->least, marked, swing->least_marked)) {
        note(swing, 1, time_us);
        restart(swing, value, marked);
    } else if (swing->direction >= 0 && swing->most - value >= step &&
               counts(kind, value, marked, swing->most_marked)) {
        note(swing, -1, time_us);
        restart(swing, value, marked);
    }
}

static int within(const struct swing *swing, uint64_t time_us)
{
    int count = 0;
    for (int64_t i = swing->count - 1; i >= 0 && i >= swing->count - TIMES; i--) {
        if (time_us - swing->times[i % TIMES] >= SECOND) {
            break;
        }
        count++;
    }
    return count;
}

static void average(const struct flash *flash, const uint8_t *rgb, int block, float out[3])
{
    int across = block % FLASH_BLOCKS, down = block / FLASH_BLOCKS;
    int x0 = across * flash->width / FLASH_BLOCKS, x1 = (across + 1) * flash->width / FLASH_BLOCKS;
    int y0 = down * flash->height / FLASH_BLOCKS, y1 = (down + 1) * flash->height / FLASH_BLOCKS;
    double sums[3] = {0};
    for (int y = y0; y < y1; y++) {
        const uint8_t *pixel = rgb + ((size_t)y * (size_t)flash->width + (size_t)x0) * 3;
        for (int x = x0; x < x1; x++, pixel += 3) {
            for (int c = 0; c < 3; c++) {
                sums[c] += (double)flash->linear[pixel[c]];
            }
        }
    }
    for (int c = 0; c < 3; c++) {
        out[c] = (float)(sums[c] / (double)((x1 - x0) * (y1 - y0)));
    }
}

/* u', v' of linear sRGB along four axes 45 degrees apart; black is as white. */
static void chromaticity(const float rgb[3], float along[AXES])
{
    const float turn = 0.70710678f;
    float x = 0.4124f * rgb[0] + 0.3576f * rgb[1] + 0.1805f * rgb[2];
    float y = 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2];
    float z = 0.0193f * rgb[0] + 0.1192f * rgb[1] + 0.9505f * rgb[2];
    float u = y > 1e-3f ? 4 * x / (x + 15 * y + 3 * z) : 0.1978f,
          v = y > 1e-3f ? 9 * y / (x + 15 * y + 3 * z) : 0.4683f;
    along[0] = u;
    along[1] = v;
    along[2] = turn * (u + v);
    along[3] = turn * (u - v);
}

static double follow_blocks(struct flash *flash, const uint8_t *rgb, uint64_t time_us)
{
    double mean = 0;
    for (int block = 0; block < BLOCKS; block++) {
        float colour[3];
        average(flash, rgb, block, colour);
        float light = colour[0] + colour[1] + colour[2], values[KINDS];
        bool saturated = light > 1e-2f && colour[0] >= SATURATED * light;
        values[GENERAL] = 0.2126f * colour[0] + 0.7152f * colour[1] + 0.0722f * colour[2];
        chromaticity(colour, values + RED);
        mean += (double)values[GENERAL];
        for (int kind = 0; kind < KINDS; kind++) {
            if (flash->worst.frames == 0) {
                restart(&flash->blocks[kind][block], values[kind], saturated);
            }
            follow(&flash->blocks[kind][block], kind, values[kind], saturated, time_us);
        }
    }
    return mean / BLOCKS;
}

/* Transitions in the last second that a quarter of a window's blocks have made, each. */
static int by_itself(const uint8_t *counted, int x, int y)
{
    int having[TIMES + 1] = {0};
    for (int i = 0; i < FLASH_WINDOW * FLASH_WINDOW; i++) {
        having[counted[(y + i / FLASH_WINDOW) * FLASH_BLOCKS + x + i % FLASH_WINDOW]]++;
    }
    int count = TIMES, blocks = having[TIMES];
    while (count > 0 && blocks < QUARTER) {
        blocks += having[--count];
    }
    return count;
}

/* A window has a transition when a quarter of its blocks have one the same way at a moment, and its last was the other
 * way. */
static void follow_window(struct flash *flash, int kind, int x, int y, uint64_t time_us)
{
    struct swing *window = &flash->windows[kind][y * PLACES + x];
    int ways[2] = {0, 0};
    for (int i = 0; i < FLASH_WINDOW * FLASH_WINDOW; i++) {
        int block = (y + i / FLASH_WINDOW) * FLASH_BLOCKS + x + i % FLASH_WINDOW;
        const struct swing *swing = &flash->blocks[kind][block];
        if (swing->count > 0 && time_us - swing->times[(swing->count - 1) % TIMES] < MOMENT) {
            ways[swing->direction > 0]++;
        }
    }
    for (int way = 0; way < 2; way++) {
        int direction = way ? 1 : -1;
        if (ways[way] >= QUARTER && window->direction != direction) {
            note(window, direction, time_us);
        }
    }
}

static void look_at_windows(struct flash *flash, uint64_t time_us)
{
    uint8_t counted[KINDS][BLOCKS];
    for (int kind = 0; kind < KINDS; kind++) {
        for (int block = 0; block < BLOCKS; block++) {
            counted[kind][block] = (uint8_t)within(&flash->blocks[kind][block], time_us);
        }
    }
    for (int place = 0; place < PLACES * PLACES; place++) {
        int x = place % PLACES, y = place / PLACES, general = 0, red = 0;
        for (int kind = 0; kind < KINDS; kind++) {
            follow_window(flash, kind, x, y, time_us);
            int together = within(&flash->windows[kind][place], time_us), each = by_itself(counted[kind], x, y);
            int flashes = (together > each ? together : each) / 2;
            general = kind == GENERAL ? flashes : general;
            red = kind >= RED && flashes > red ? flashes : red;
        }
        struct flash_worst *worst = &flash->worst;
        if (general > worst->general || red > worst->red) {
            worst->x = x * flash->width / FLASH_BLOCKS;
            worst->y = y * flash->height / FLASH_BLOCKS;
            worst->time_us = time_us;
            worst->general = general > worst->general ? general : worst->general;
            worst->red = red > worst->red ? red : worst->red;
        }
    }
}

static void follow_mean(struct flash *flash, double mean, uint64_t time_us)
{
    struct flash_worst *worst = &flash->worst;
    double least = mean, most = mean;
    flash->means[worst->frames % FRAMES] = mean;
    flash->times[worst->frames % FRAMES] = time_us;
    for (int i = worst->frames; i >= 0 && i > worst->frames - FRAMES; i--) {
        if (time_us - flash->times[i % FRAMES] > SECOND) {
            break;
        }
        least = fmin(least, flash->means[i % FRAMES]);
        most = fmax(most, flash->means[i % FRAMES]);
    }
    if (most - least > worst->mean_change) {
        worst->mean_change = most - least;
        worst->mean_time_us = time_us;
    }
    worst->mean_first = worst->frames == 0 ? mean : worst->mean_first;
    worst->mean = mean;
}

void flash_frame(struct flash *flash, const uint8_t *rgb, uint64_t time_us)
{
    double mean = follow_blocks(flash, rgb, time_us);
    follow_mean(flash, mean, time_us);
    look_at_windows(flash, time_us);
    flash->worst.frames++;
}

struct flash_worst flash_worst(const struct flash *flash)
{
    return flash->worst;
}
