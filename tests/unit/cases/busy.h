/* Everything that can be done to a sheet, in one session. */
#ifndef FROND_BUSY_H
#define FROND_BUSY_H

#include "painting.h"

enum { BUSY_TICKS = 420 };

struct busy { /* a formula's worth of values: a half sheet of obstacles, a wavy field */
    float wall[64 * 64], wave[2 * 64 * 64];
};

void busy_init(struct busy *busy);
/* 203x117 cells and a margin of 9, no multiple of a vector or a tile; one thread. */
struct painting_def busy_def(void);
/* What happens before this tick. */
void busy_act(const struct busy *busy, int tick, void (*apply)(void *context, const struct action *), void *context);

#endif
