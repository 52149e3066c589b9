/* A visitor who paints without a display, for tests of what keeps the painting: actions and ticks as the studio tells
 * them, the same for the same number. */
#ifndef FROND_KEEP_CASE_H
#define FROND_KEEP_CASE_H

#include "keep.h"

struct keep_case {
    struct keep *keep; /* NULL: nobody is told */
    struct engine *engine;
    struct script *script;
    int64_t ticked; /* as it is told */
    bool acted;     /* what happens before the next tick has been done already */
};

/* A sheet of 160x100 cells. `found`: goes on with it; else a fresh sheet is told. */
bool keep_case_open(struct keep_case *one, struct keep *keep, const struct keep_found *found);
void keep_case_close(struct keep_case *one);
/* What happens before this tick, and the tick. */
void keep_case_tick(struct keep_case *one);
/* A fresh sheet. */
void keep_case_fresh(struct keep_case *one);
uint64_t keep_case_hash(const struct keep_case *one);
/* The hashes of the sheet at each tick, painted without any keeping: before what happens then, and after. */
enum { KEEP_CASE_TICKS = 720 };
struct keep_case_table {
    bool painted;
    uint64_t before[KEEP_CASE_TICKS], after[KEEP_CASE_TICKS];
};
bool keep_case_paint(struct keep_case_table *table); /* once; later it does nothing */
/* Whether it is the painting of its tick, before or after what happens then, which sets `acted`. */
bool keep_case_is_right(struct keep_case *one, const struct keep_case_table *table);

#endif
