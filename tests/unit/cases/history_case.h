/* A sheet with a history, and what visitors do to it. */
#ifndef FROND_HISTORY_CASE_H
#define FROND_HISTORY_CASE_H

#include "history.h"

enum { WIDTH = 150, HEIGHT = 110, MARGIN = 5 }; /* cells; no multiple of a tile */

struct sheet {
    struct engine *engine;
    struct history *history;
    struct checkpoint before, after;
};

struct painting_def sheet_def(void); /* one thread */
struct sheet sheet_make_of(const struct painting_def *def, const struct history_def *history);
struct sheet sheet_make(void); /* 8 MiB */
void sheet_drop(struct sheet *sheet);
void run(struct sheet *sheet, int ticks);
void act(struct sheet *sheet, const struct action *action);
/* A drop of 113 cells with 60 of solvent each; the visitor's own ink. */
void drop(struct sheet *sheet, int visitor, float x, float y);
void stroke(struct sheet *sheet, enum action_verb verb, int visitor, struct point from, struct point to);
/* Undo, redo or clear. */
void order(struct sheet *sheet, enum action_verb verb, int visitor);
void look(struct sheet *sheet, struct checkpoint *checkpoint);
uint64_t hash_of(const struct sheet *sheet);

#endif
