/* A recorded session, varied: mirrored, its inks turned, shifted a little, slower or faster, so that it is another one
 * each time. Pure. */
#ifndef FROND_VARY_H
#define FROND_VARY_H

#include "dice.h"
#include "performance.h"
#include "script.h"

/* `inks`: of the scene that it is painted in. `ticks`: that it may take at most; what comes later is left out. */
void vary(struct performance *performance, const struct script *session, int inks, int64_t ticks, struct dice *dice);

#endif
