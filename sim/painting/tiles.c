#include "tiles.h"

#include <stdlib.h>
#include <string.h>

#include "kernel.h"

enum {
    FARTHEST_ENDS = 2, /* tiles by which a run may differ from the one above it and still be joined to it */
    LEAST_LINES = 4,   /* lines of tiles of a run that shares its work */
    MOST_LINES = 16,
};

bool tiles_init(struct tiles *tiles, int width, int height, int threads)
{
    *tiles = (struct tiles){.width = width,
                            .height = height,
                            .columns = (width + TILE - 1) / TILE,
                            .rows = (height + TILE - 1) / TILE,
                            .threads = threads};
    size_t count = (size_t)tiles->columns * (size_t)tiles->rows;
    bool whole = true;
    for (int flag = 0; flag < TILE_FLAGS; flag++) {
        tiles->flags[flag] = calloc(count, 1);
        whole = whole && tiles->flags[flag];
    }
    tiles->awake = calloc(count, 1);
    tiles->across = calloc(count, 1);
    tiles->owner = calloc(count, sizeof *tiles->owner);
    tiles->runs = calloc(count, sizeof *tiles->runs);
    return whole && tiles->awake && tiles->across && tiles->owner && tiles->runs;
}

void tiles_finish(struct tiles *tiles)
{
    for (int flag = 0; flag < TILE_FLAGS; flag++) {
        free(tiles->flags[flag]);
    }
    free(tiles->awake);
    free(tiles->across);
    free(tiles->owner);
    free(tiles->runs);
    *tiles = (struct tiles){0};
}

size_t tiles_bytes(const struct tiles *tiles)
{
    return (size_t)tiles->columns * (size_t)tiles->rows * (TILE_FLAGS + 2 + sizeof(int32_t) + sizeof(struct run));
}

void tiles_mark(struct tiles *tiles, enum tile_flag flag, int x0, int x1, int y0, int y1)
{
    x0 = x0 < 0 ? 0 : x0;
    y0 = y0 < 0 ? 0 : y0;
    x1 = x1 > tiles->width ? tiles->width : x1;
    y1 = y1 > tiles->height ? tiles->height : y1;
    if (x0 >= x1) {
        return;
    }
    size_t first = (size_t)x0 / TILE;
    size_t count = ((size_t)x1 - 1) / TILE - first + 1;
    for (int ty = y0 / TILE; ty * TILE < y1; ty++) {
        memset(tiles->flags[flag] + (size_t)ty * (size_t)tiles->columns + first, 1, count);
    }
}

/* Bits of a tile's three reasons, spread to its neighbours first along rows, then down columns. */
static void find_awake(struct tiles *tiles, const uint8_t *moves, const uint8_t *cause, const uint8_t *able)
{
    int columns = tiles->columns, rows = tiles->rows;
    for (int ty = 0; ty < rows; ty++) {
        uint8_t *across = tiles->across + (size_t)ty * (size_t)columns;
        size_t first = (size_t)ty * (size_t)columns;
        for (int tx = 0; tx < columns; tx++) {
            unsigned bits = 0;
            int last = tx < columns - 1 ? tx + 1 : tx;
            for (int near = tx > 0 ? tx - 1 : 0; near <= last; near++) {
                size_t at = first + (size_t)near;
                bits |= (moves[at] != 0) | (unsigned)(cause[at] != 0) << 1 | (unsigned)(able[at] != 0) << 2;
            }
            across[tx] = (uint8_t)bits;
        }
    }
    for (int ty = 0; ty < rows; ty++) {
        const uint8_t *own = tiles->across + (size_t)ty * (size_t)columns;
        const uint8_t *above = ty > 0 ? own - columns : own, *below = ty < rows - 1 ? own + columns : own;
        uint8_t *awake = tiles->awake + (size_t)ty * (size_t)columns;
        for (int tx = 0; tx < columns; tx++) {
            unsigned bits = own[tx] | above[tx] | below[tx];
            awake[tx] = (bits & 1u) || (bits & 6u) == 6u;
        }
    }
}

/* Whether tiles [from, to) of rows [top, bottom) belong to no run, or to `run`. */
static bool is_free(const struct tiles *tiles, int from, int to, int top, int bottom, int run)
{
    for (int ty = top; ty < bottom; ty++) {
        for (int tx = from; tx < to; tx++) {
            int owner = tiles->owner[ty * tiles->columns + tx];
            if (owner >= 0 && owner != run) {
                return false;
            }
        }
    }
    return true;
}

static void own(struct tiles *tiles, int from, int to, int top, int bottom, int run)
{
    for (int ty = top; ty < bottom; ty++) {
        for (int tx = from; tx < to; tx++) {
            tiles->owner[ty * tiles->columns + tx] = run;
        }
    }
}

/* Joins tiles [from, to) of row ty to the run above, if that ends here and begins and ends nearly as they do: long runs
 * compute fewer rows twice. */
static bool join(struct tiles *tiles, int from, int to, int ty)
{
    if (ty == 0) {
        return false;
    }
    for (int tx = from; tx < to; tx++) {
        int above = tiles->owner[(ty - 1) * tiles->columns + tx];
        if (above < 0) {
            continue;
        }
        struct run *run = &tiles->runs[above];
        int left = run->x0 / TILE, right = (run->x1 + TILE - 1) / TILE, top = run->y0 / TILE;
        int new_left = left < from ? left : from, new_right = right > to ? right : to;
        if (run->y1 != ty * TILE || (ty + 1) * TILE - run->y0 > tiles->tallest ||
            abs(left - from) + abs(right - to) > FARTHEST_ENDS || (new_right - new_left) * TILE > RUN_WIDEST ||
            !is_free(tiles, new_left, new_right, top, ty, above) ||
            !is_free(tiles, new_left, new_right, ty, ty + 1, above)) {
            continue;
        }
        /* Tiles awake to the right of `to` are not yet in a run; they must not be swallowed twice. */
        bool clear = true;
        for (int next = to; next < new_right; next++) {
            clear = clear && !tiles->awake[ty * tiles->columns + next];
        }
        if (!clear) {
            continue;
        }
        run->x0 = new_left * TILE;
        run->x1 = new_right * TILE < tiles->width ? new_right * TILE : tiles->width;
        run->y1 = (ty + 1) * TILE < tiles->height ? (ty + 1) * TILE : tiles->height;
        own(tiles, new_left, new_right, top, ty + 1, above);
        return true;
    }
    return false;
}

/* High runs compute fewer rows twice, low ones share the work better: some two for each thread. */
static void choose_tallest(struct tiles *tiles)
{
    int lines = 0;
    for (int ty = 0; ty < tiles->rows; ty++) {
        lines += memchr(tiles->awake + (size_t)ty * (size_t)tiles->columns, 1, (size_t)tiles->columns) != NULL;
    }
    int share = (lines + 2 * tiles->threads - 1) / (2 * tiles->threads);
    tiles->tallest = TILE * (share < LEAST_LINES ? LEAST_LINES : share > MOST_LINES ? MOST_LINES : share);
}

static void build_runs(struct tiles *tiles)
{
    int columns = tiles->columns;
    int bands = (columns * TILE + RUN_WIDEST - 1) / RUN_WIDEST, widest = (columns + bands - 1) / bands;
    tiles->run_count = 0;
    tiles->awake_count = 0;
    memset(tiles->owner, 0xff, (size_t)columns * (size_t)tiles->rows * sizeof *tiles->owner);
    for (int ty = 0; ty < tiles->rows; ty++) {
        const uint8_t *awake = tiles->awake + (size_t)ty * (size_t)columns;
        for (int tx = 0; tx < columns;) {
            if (!awake[tx]) {
                tx++;
                continue;
            }
            int to = tx; /* a gap of one tile is cheaper to compute than to leave out */
            while (to < columns && to - tx < widest && (awake[to] || (to + 1 < columns && awake[to + 1]))) {
                tiles->awake_count += awake[to];
                to++;
            }
            /* The run above may have been widened over the first tiles. */
            int from = tx;
            while (from < to && tiles->owner[ty * columns + from] >= 0) {
                from++;
            }
            if (from < to && !join(tiles, from, to, ty)) {
                int x1 = to * TILE, y1 = (ty + 1) * TILE;
                tiles->runs[tiles->run_count] = (struct run){.x0 = from * TILE,
                                                             .x1 = x1 < tiles->width ? x1 : tiles->width,
                                                             .y0 = ty * TILE,
                                                             .y1 = y1 < tiles->height ? y1 : tiles->height};
                own(tiles, from, to, ty, ty + 1, tiles->run_count);
                tiles->run_count++;
            }
            tx = to;
        }
    }
}

static bool foreign(const struct tiles *tiles, int tx, int ty, int index)
{
    int owner = tx >= 0 && tx < tiles->columns ? tiles->owner[ty * tiles->columns + tx] : -1;
    return owner >= 0 && owner != index;
}

/* What a run reads beyond its own cells: one tile around it; and, left and right, the first cell of the tile behind,
 * whose value comes to nothing, but which nobody may be writing. */
static void look_around(const struct tiles *tiles, struct run *run, int index)
{
    int left = run->x0 / TILE, right = (run->x1 - 1) / TILE, top = run->y0 / TILE, bottom = (run->y1 - 1) / TILE;
    for (int ty = top > 0 ? top - 1 : 0; ty <= bottom + 1 && ty < tiles->rows; ty++) {
        for (int tx = left > 0 ? left - 1 : 0; tx <= right + 1 && tx < tiles->columns; tx++) {
            bool others = foreign(tiles, tx, ty, index);
            run->guarded[SIDE_TOP] |= others && ty < top;
            run->guarded[SIDE_BOTTOM] |= others && ty > bottom;
            run->special |= tiles->flags[TILE_SPECIAL][ty * tiles->columns + tx] != 0;
        }
    }
    for (int ty = top; ty <= bottom; ty++) {
        run->guarded[SIDE_LEFT] |= foreign(tiles, left - 1, ty, index) || foreign(tiles, left - 2, ty, index);
        run->guarded[SIDE_RIGHT] |= foreign(tiles, right + 1, ty, index) || foreign(tiles, right + 2, ty, index);
    }
}

void tiles_wake(struct tiles *tiles, enum tile_flag moves, enum tile_flag cause, enum tile_flag able, bool dense)
{
    size_t count = (size_t)tiles->columns * (size_t)tiles->rows;
    if (dense) {
        memset(tiles->awake, 1, count);
    } else {
        find_awake(tiles, tiles->flags[moves], tiles->flags[cause], tiles->flags[able]);
    }
    choose_tallest(tiles);
    build_runs(tiles);
    for (int i = 0; i < tiles->run_count; i++) {
        look_around(tiles, &tiles->runs[i], i);
    }
    memset(tiles->flags[moves], 0, count);
    memset(tiles->flags[cause], 0, count);
}
