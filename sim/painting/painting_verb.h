/* What a verb does to a painting, whichever engine paints it: its part on the ground (ground.h), and what it lays on
 * the cells by one of the laws of deposit.h. A law of its own is a function in painting_act.c and one in deposit.comp.
 */
#ifndef FROND_PAINTING_VERB_H
#define FROND_PAINTING_VERB_H

#include "deposit.h"
#include "territory.h"
#include "verb.h"

struct painting_verb {
    /* Does its part on the ground, and returns the cells that may now be different. NULL: nothing. */
    struct rectangle (*ground)(struct ground *ground, const struct action *action);
    enum deposit_law law;
    /* The cells that something may be laid on, not clipped; before any of `cover`. NULL: those of the region. */
    struct rectangle (*bounds)(struct deposit *deposit);
    /* How much is laid on a cell, 0..1; `seed` as the law has it. NULL: 1 where the region holds the cell. */
    float (*cover)(struct deposit *deposit, int x, int y, float *seed);
    bool crosses;        /* lays on cells under obstacles, too */
    bool common;         /* nobody's own: no visitor can take it back */
    enum mark_kind mark; /* what it leaves behind, for those who take back */
};

#endif
