/* The times of the upkeep (painting_upkeep.c, which says what it does): the same for every engine. */
#ifndef FROND_UPKEEP_H
#define FROND_UPKEEP_H

enum {
    UPKEEP_TICKS = 64,  /* a period */
    QUIET_PERIODS = 8,  /* one after the other, after which a painting has settled */
    QUIET_SHARE = 256,  /* quiet: the carved area grows by less than this part of it in a period */
    CALM_PERIODS = 24,  /* quiet periods after which liquid has to move more to move at all: see painting_fluid.c */
    STILL_PERIODS = 40, /* quiet periods after which more of them change nothing: the dead band is at its widest */
};

#endif
