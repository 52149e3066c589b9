/* Rectangles of a painting on the GPU, and which tiles may have changed: for a history. */
#include <stdlib.h>

#include <GLES3/gl31.h>

#include "painting_gpu_state.h"
#include "tiles.h"

enum { TILES_ACROSS = GPU_TILE / TILE }; /* tiles of a history in one of the GPU */

bool gpu_save_patch(struct painting_gpu *gpu, struct patch *patch)
{
    if (!patch_fits(patch, gpu->width, gpu->height)) {
        return false;
    }
    bool whole = true;
    for (int i = 0; i < GPU_STRETCHES; i++) {
        const struct gpu_stretch *stretch = &gpu_stretches[i];
        whole = whole && gpu_read_planes(gpu, stretch->kind, stretch->first, stretch->count, patch->cells,
                                         patch_plane(patch, stretch->plane));
    }
    patch_take_ground(patch, gpu->ground);
    return whole;
}

bool gpu_load_patch(struct painting_gpu *gpu, const struct patch *patch)
{
    if (!patch_fits(patch, gpu->width, gpu->height)) {
        return false;
    }
    bool whole = true;
    for (int i = 0; i < GPU_STRETCHES; i++) {
        const struct gpu_stretch *stretch = &gpu_stretches[i];
        whole = whole && gpu_write_planes(gpu, stretch->kind, stretch->first, stretch->count, patch->cells,
                                          patch_plane(patch, stretch->plane));
    }
    patch_give_ground(patch, gpu->ground);
    gpu_act_upload(gpu, patch->cells);
    gpu_steps_mark(gpu, patch->cells, BIT_WET | BIT_ALIVE);
    gpu_steps_touch(gpu, patch->cells);
    return whole;
}

/* A tile of the GPU stands for four. */
static void set_tiles(const struct painting_gpu *gpu, int tile, uint8_t *changed)
{
    int columns = (gpu->width + TILE - 1) / TILE, rows = (gpu->height + TILE - 1) / TILE;
    int left = tile % gpu->columns * TILES_ACROSS, top = tile / gpu->columns * TILES_ACROSS;
    for (int y = top; y < top + TILES_ACROSS && y < rows; y++) {
        for (int x = left; x < left + TILES_ACROSS && x < columns; x++) {
            changed[y * columns + x] = 1;
        }
    }
}

bool gpu_find_changed(struct painting_gpu *gpu, uint8_t *changed)
{
    size_t count = (size_t)gpu->columns * (size_t)gpu->lines, first = gpu_tiles_word(gpu, TILES_FLAGS);
    uint32_t *flags = calloc(count, sizeof *flags);
    if (!flags || !gpu_read_bytes(gpu->tiles, first * sizeof *flags, count * sizeof *flags, flags)) {
        free(flags);
        return false;
    }
    for (size_t tile = 0; tile < count; tile++) {
        if (flags[tile] & BIT_CHANGED) {
            set_tiles(gpu, (int)tile, changed);
            flags[tile] &= ~(uint32_t)BIT_CHANGED;
        }
    }
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, gpu->tiles);
    glBufferSubData(GL_SHADER_STORAGE_BUFFER, (GLintptr)(first * sizeof *flags), (GLsizeiptr)(count * sizeof *flags),
                    flags);
    free(flags);
    return true;
}
