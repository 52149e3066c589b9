/* The inside of a history, shared by the files that make it up; nobody else includes this.
 *   history.c          life, keeping tiles, actions
 *   history_group.c    who did what where
 *   history_restore.c  tiles out of the engine and back
 *   history_undo.c     undo, redo
 *   history_rewind.c   the time brush */
#ifndef FROND_HISTORY_STATE_H
#define FROND_HISTORY_STATE_H

#include "history.h"
#include "past.h"
#include "territory.h"

enum {
    MOMENTS = 64, /* a tick: what happens in one tick is told apart by them */
    HISTORY_GROUPS = 128,
    HISTORY_MARKS = 2048,
};

enum group_state { GROUP_GONE, GROUP_DONE, GROUP_UNDONE };

struct taken { /* a tile that undo took something from */
    int tile;
    uint32_t version; /* of its own (past_copy): as it was, and the shares */
};

struct group {
    uint32_t id;
    int visitor;
    enum group_state state;
    bool rewinds;         /* it was made by the time brush */
    uint32_t begin, last; /* moments */
    uint32_t undone;      /* moment */
    struct taken *taken;  /* of an undone one; owned */
    int taken_count, taken_room;
};

/* A time that a cell has lost: from `from` to `until` something went on there that was taken back. Moments. */
struct lost {
    uint32_t from, until;
    uint16_t pass; /* tick, its low bits, at which the time brush came last */
    uint8_t cover; /* how much of it, 0..255 */
};

/* A tile in a line of tiles that is being worked on. */
struct plan {
    bool any;
    float share[TILE_CELLS];
    uint8_t ground[TILE_CELLS];
    uint32_t version;              /* of undo and redo */
    uint32_t versions[TILE_CELLS]; /* of the time brush */
};

struct history {
    struct history_def def;
    struct painting_def painting;
    int width, height; /* cells, margin included */
    int columns, rows; /* tiles */
    struct past *past;
    struct patch patch; /* a line of tiles */
    struct plan *plans; /* [columns] */
    struct lost *lost;  /* [height][width] */
    uint8_t *pending;   /* tiles still to be kept in this round */
    int cursor;         /* the tile from which on they are; columns * rows: none */
    bool begun;         /* since history_forget */
    int64_t start;      /* tick of moment 0 */
    int64_t tick, next_round;
    int64_t kept_tick; /* at which tiles were kept last: once a tick */
    uint32_t moment;   /* the last that was given away */
    uint32_t next_group;
    struct group groups[HISTORY_GROUPS]; /* a ring: number id % HISTORY_GROUPS */
    struct mark marks[HISTORY_MARKS];    /* by moment */
    int mark_count;
};

/* A moment of its own, later than all others. */
uint32_t history_moment(struct history *history);
/* Puts tiles [first, last] of a line into the patch; false when the engine does not answer. */
bool history_save_line(struct history *history, struct engine *engine, int line, int first, int last);

/* The marks of an action, not yet of any group; their number, 0 for what cannot be undone. `marks`: STROKE_MARKS. */
enum { STROKE_MARKS = 256 };
int history_marks_of(const struct history *history, const struct action *action, struct mark *marks);
/* The group that an action belongs to, made if need be; its marks are kept. What the visitor has undone is forgotten.
 */
struct group *history_group_for(struct history *history, const struct action *action, const struct mark *marks,
                                uint32_t moment);
void history_add_marks(struct history *history, const struct group *group, const struct mark *marks, int count);
/* The group that undo (DONE) or redo (UNDONE) of a visitor concerns, or NULL. */
struct group *history_find(struct history *history, int visitor, enum group_state state);
bool history_has(const struct history *history, const struct group *group, enum group_state state);
void history_drop_group(struct history *history, struct group *group);
/* Whether the marks of a group count for others. */
void history_count_marks(struct history *history, uint32_t group, bool counts);

/* The cells that marks may concern, grown by so many cells; on the sheet. */
struct rectangle history_around(const struct history *history, const struct mark *marks, int count, float reach);

void history_undo(struct history *history, struct engine *engine, struct group *group);
void history_redo(struct history *history, struct engine *engine, struct group *group);
void history_rewind(struct history *history, struct engine *engine, const struct mark *marks, int count, float ticks);

#endif
