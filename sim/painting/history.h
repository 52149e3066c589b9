/* Undo and redo for each visitor, and a brush that takes a place back in time, on any engine; all else goes on.
 *
 *     before each tick, for each action:  history_act(history, engine, &action);
 *     then                                history_tick(history, engine);
 *                                         engine->ops->tick(engine);
 *
 * Tiles that have changed are kept every `interval` ticks, some at a time; those around an action that begins something
 * new, at once. So all depends on actions and ticks alone: on the CPU engine the same actions at the same ticks give
 * the same painting to the bit, undone or not.
 *
 * What is undone together, a group, is what a visitor did in one go: a drop begins a group, and so does a stroke that
 * does not go on from where the visitor has been, or comes after a pause. Its territory (territory.h) goes back to what
 * it was before; where it ends, old and new blend over some cells. A dropped group, one too old for the store, stays
 * painted. What concerns the whole sheet (`set`, `dry`, a mask from a picture, a wash) is no group; `clear` forgets
 * all. */
#ifndef FROND_HISTORY_H
#define FROND_HISTORY_H

#include "engine.h"

enum { HISTORY_SCRIPT = -1 }; /* a visitor of its own, whom undo and redo of 0 leave alone */

struct history_def {
    size_t bytes;     /* of all that is kept; the oldest goes first */
    int interval;     /* ticks from one round of keeping to the next, 1.. */
    int tiles_a_tick; /* kept in a tick at most, 1..; a round takes as many ticks as it needs */
    int age;          /* ticks after which the past is let go */
    int levels;       /* groups of a visitor that can be undone */
    int pause;        /* ticks after which a visitor's next action is a new group */
};

struct history_def history_default_def(void);

struct history;

/* For sheets of this size. NULL when memory is short or `bytes` are too few for it. */
struct history *history_create(const struct history_def *def, const struct painting_def *painting);
void history_destroy(struct history *history); /* takes NULL */
/* Whether it is for sheets of this size. */
bool history_fits(const struct history *history, const struct painting_def *painting);

/* Does an action now: undo, redo and rewind itself, all else by the engine. What undo and redo have no group for, and
 * what a lost GPU does not answer, does nothing. */
void history_act(struct history *history, struct engine *engine, const struct action *action);
/* Before a tick of the engine; a second time before the same tick it does nothing. */
void history_tick(struct history *history, struct engine *engine);
/* Nothing can be undone any more: after the engine has loaded a checkpoint, or is another. */
void history_forget(struct history *history);

/* Bit v: visitor v, 0..63, has something to undo, to redo; bit 0: anybody but the script has. */
uint64_t history_can_undo(const struct history *history);
uint64_t history_can_redo(const struct history *history);

size_t history_used(const struct history *history); /* by what is kept now */

#endif
