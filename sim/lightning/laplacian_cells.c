#include "laplacian_cells.h"

#include <stdlib.h>

#include "memory.h"

enum { CHUNK = 256, ROOM_FIRST = 256 };

/* Powers of two of cells along each side of a brick: 64 in all. */
static const uint8_t SIDES[LAPLACIAN_DIMENSIONS_MAX + 1][LAPLACIAN_DIMENSIONS_MAX] = {
    {0}, {6}, {3, 3}, {2, 2, 2}, {2, 2, 1, 1}, {2, 1, 1, 1, 1}, {1, 1, 1, 1, 1, 1}};
/* Powers of two of cells along a coordinate, all fitting in 63 bits of a key once the sides of bricks are taken off. */
static const uint8_t WIDTHS[LAPLACIAN_DIMENSIONS_MAX + 1] = {0, 20, 20, 20, 16, 13, 11};

int32_t laplacian_cells_limit(int dimensions)
{
    return (1 << (WIDTHS[dimensions] - 1)) - 2;
}

static uint64_t key_of(const struct laplacian_cells *cells, const int32_t *cell, uint32_t *within)
{
    uint64_t key = 1; /* a key is never 0 */
    uint32_t inside = 0;
    int width = WIDTHS[cells->dimensions];
    for (int d = 0; d < cells->dimensions; d++) {
        int side = SIDES[cells->dimensions][d];
        uint32_t at = (uint32_t)(cell[d] + (1 << (width - 1)));
        key = key << (width - side) | at >> side;
        inside = inside << side | (at & ((1u << side) - 1));
    }
    *within = inside;
    return key;
}

static uint32_t hash(uint64_t key)
{
    key ^= key >> 32;
    key *= UINT64_C(0x9e3779b97f4a7c15);
    return (uint32_t)(key >> 32) ^ (uint32_t)(key >> 50);
}

static int32_t *brick_at(const struct laplacian_cells *cells, int32_t brick)
{
    return cells->chunks[brick / CHUNK] + (size_t)(brick % CHUNK) * LAPLACIAN_BRICK_CELLS;
}

bool laplacian_cells_init(struct laplacian_cells *cells, int dimensions)
{
    *cells = (struct laplacian_cells){.dimensions = dimensions, .room = ROOM_FIRST};
    cells->keys = memory_take(ROOM_FIRST, sizeof *cells->keys, &cells->bytes);
    cells->bricks = memory_take(ROOM_FIRST, sizeof *cells->bricks, &cells->bytes);
    return cells->keys && cells->bricks;
}

void laplacian_cells_finish(struct laplacian_cells *cells)
{
    for (int32_t i = 0; i < cells->chunk_count; i++) {
        free(cells->chunks[i]);
    }
    free((void *)cells->chunks);
    free(cells->keys);
    free(cells->bricks);
    *cells = (struct laplacian_cells){0};
}

static uint32_t slot_of(const struct laplacian_cells *cells, uint64_t key)
{
    uint32_t mask = cells->room - 1, slot = hash(key) & mask;
    while (cells->keys[slot] && cells->keys[slot] != key) {
        slot = (slot + 1) & mask;
    }
    return slot;
}

static bool widen(struct laplacian_cells *cells)
{
    struct laplacian_cells wide = *cells;
    size_t bytes = 0;
    wide.room = 2 * cells->room;
    wide.keys = memory_take(wide.room, sizeof *wide.keys, &bytes);
    wide.bricks = memory_take(wide.room, sizeof *wide.bricks, &bytes);
    if (!wide.keys || !wide.bricks) {
        free(wide.keys);
        free(wide.bricks);
        return false;
    }
    for (uint32_t i = 0; i < cells->room; i++) {
        if (cells->keys[i]) {
            uint32_t slot = slot_of(&wide, cells->keys[i]);
            wide.keys[slot] = cells->keys[i];
            wide.bricks[slot] = cells->bricks[i];
        }
    }
    free(cells->keys);
    free(cells->bricks);
    cells->keys = wide.keys;
    cells->bricks = wide.bricks;
    cells->room = wide.room;
    cells->bytes += bytes / 2;
    return true;
}

static bool add_chunk(struct laplacian_cells *cells)
{
    int32_t **chunks = realloc((void *)cells->chunks, ((size_t)cells->chunk_count + 1) * sizeof *chunks);
    if (!chunks) {
        return false;
    }
    cells->chunks = chunks;
    chunks[cells->chunk_count] = memory_take(CHUNK, LAPLACIAN_BRICK_CELLS * sizeof **chunks, &cells->bytes);
    if (!chunks[cells->chunk_count]) {
        return false;
    }
    cells->chunk_count++;
    return true;
}

int32_t *laplacian_cells_find(struct laplacian_cells *cells, const int32_t *cell)
{
    uint32_t within;
    uint64_t key = key_of(cells, cell, &within);
    if (key != cells->last_key) {
        uint32_t slot = slot_of(cells, key);
        cells->last = cells->keys[slot] ? brick_at(cells, cells->bricks[slot]) : NULL;
        cells->last_key = key;
    }
    return cells->last ? cells->last + within : NULL;
}

int32_t *laplacian_cells_make(struct laplacian_cells *cells, const int32_t *cell)
{
    int32_t *there = laplacian_cells_find(cells, cell);
    if (there) {
        return there;
    }
    if ((uint32_t)cells->count > cells->room / 2 && !widen(cells)) {
        return NULL;
    }
    if (cells->count == cells->chunk_count * CHUNK && !add_chunk(cells)) {
        return NULL;
    }
    uint32_t within;
    uint64_t key = key_of(cells, cell, &within);
    uint32_t slot = slot_of(cells, key);
    cells->keys[slot] = key;
    cells->bricks[slot] = cells->count++;
    cells->last_key = key;
    cells->last = brick_at(cells, cells->bricks[slot]);
    return cells->last + within;
}
