/* Plays a journal: does again, tick by tick, what was done. With CPU engines, to the bit.
 *
 *     if (player_open(&player, data, size, &maker, &error)) {
 *         while (player_tick(&player, &error)) { ... player.engine has painted a tick more ... }
 *     }
 *     player_close(&player);
 */
#ifndef FROND_PLAYER_H
#define FROND_PLAYER_H

#include "checkpoint.h"
#include "engine.h"
#include "file.h"
#include "history.h"
#include "journal.h"
#include "plot.h"

/* Makes the engines. */
struct player_maker {
    /* An engine for this painting, the player's from then on; NULL with the reason in `error`. */
    struct engine *(*make)(void *data, const struct painting_def *def, struct file_error *error);
    void *data;
    bool grows; /* what grows over the painting is grown, too (plot.h); takes long */
};
/* CPU engines with this many threads, 0: one for each processor. */
struct player_maker player_cpu(const int *threads);

struct player {
    struct journal_reader reader; /* what it says of the journal, its ending above all */
    struct player_maker maker;
    struct engine *engine;      /* NULL: before the first sheet */
    struct journal_sheet sheet; /* now: inks, mode, scene; its def is that of the engine's sheet */
    int64_t ticked;             /* painted, over all sheets */
    int64_t last;               /* what `ticked` will be at the end; known from the beginning */
    int sheets, actions;        /* so far */
    struct journal_record next; /* what is done next, at next.ticked */
    bool has_next;
    struct journal_place done; /* behind what was done last: before `next` and what it declares */
    struct plot *plot;         /* what grows over the painting; NULL: nothing in the journal does */
    /* The inside. */
    struct history *history; /* NULL: nothing is taken back */
    bool goes_back, grows, resumed;
};

/* Reads the journal once, to see how long it is, and takes up its first sheet. False, with the reason in `error`, where
 * it is no journal or has no sheet. The bytes stay the caller's and must outlive the player. */
bool player_open(struct player *player, const void *data, size_t size, const struct player_maker *maker,
                 struct file_error *error);
/* Does what is due, then one tick. False when that was all: what is due last has been done, without a tick after it; or
 * when it failed, with the reason in `error` (else ""). */
bool player_tick(struct player *player, struct file_error *error);
/* Takes up a painting in the middle of its journal instead, to do what came after. What undo, redo and rewind would go
 * back to is not there: player_tick ends before the first of them, which is `next` then. Nothing grows over it. */
struct player_place {
    const struct checkpoint *checkpoint;
    int64_t ticked;   /* when it was taken */
    uint64_t records; /* that the journal held then */
};
bool player_resume(struct player *player, const void *data, size_t size, const struct player_place *place,
                   const struct player_maker *maker, struct file_error *error);
void player_close(struct player *player); /* a zeroed one may be closed */

#endif
