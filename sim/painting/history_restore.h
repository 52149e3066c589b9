/* Lines of tiles taken out of the engine, blended with what they were, and put back: what undo, redo and the time brush
 * share. Inside a history only. */
#ifndef FROND_HISTORY_RESTORE_H
#define FROND_HISTORY_RESTORE_H

#include "history_state.h"

/* What is done to each tile of a line; `plan` first says where. */
struct restoring {
    struct history *history;
    struct engine *engine;
    struct group *group;
    uint32_t now;
    const struct territory *territory; /* of undo */
    const struct mark *marks;          /* of rewind */
    int mark_count;
    float depth; /* moments that the middle of the time brush goes back */
    bool keeps;  /* what is there before */
    void (*plan)(struct restoring *restoring, int tile, struct plan *plan);
    void (*apply)(struct restoring *restoring, int tile, struct plan *plan);
};

/* Plans and applies in all tiles that these cells touch, line by line. */
void restoring_run(struct restoring *restoring, struct rectangle cells);
/* Brings a tile in the patch to what a code says, as far as the plan wants. */
void restoring_give(struct restoring *restoring, int tile, const struct plan *plan, const struct tile_code *code);
/* The cells that a plan takes more than half of have lost the time since. */
void restoring_lose(const struct restoring *restoring, int tile, const struct plan *plan, uint32_t from);

static inline int x_of(const struct history *history, int tile)
{
    return tile % history->columns * TILE;
}

static inline int y_of(const struct history *history, int tile)
{
    return tile / history->columns * TILE;
}

static inline struct lost *lost_of(const struct history *history, int tile, int cell)
{
    int x = x_of(history, tile) + cell % TILE, y = y_of(history, tile) + cell / TILE;
    bool outside = x >= history->width || y >= history->height;
    return outside ? NULL : &history->lost[(size_t)y * (size_t)history->width + (size_t)x];
}

#endif
