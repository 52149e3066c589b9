/* A recorded session, varied: mirrored, its inks turned, shifted a little, slower or faster, so that it is another one
 * each time; as large as the sheet is; done by one hand. Pure. */
#ifndef FROND_VARY_H
#define FROND_VARY_H

#include "dice.h"
#include "performance.h"
#include "script.h"

struct vary_def {
    int inks;      /* of the scene that it is painted in */
    int cells;     /* of the sheet: lengths and amounts are brought to its size */
    int64_t ticks; /* that it may take at most; what comes later is left out */
    int rate;      /* ticks a second */
};

/* Room that a session needs: paths longer than STUDIO_PATH become several steps. */
int vary_steps(const struct script *session);
/* What was recorded with formulas or pictures stays where it is, and so do its places. */
void vary(struct performance *performance, const struct script *session, const struct vary_def *def, struct dice *dice);

#endif
