/* The studio's sheet: made fresh, brought to another grid, given another script. The thread's alone. */
#ifndef FROND_STUDIO_SHEET_H
#define FROND_STUDIO_SHEET_H

#include "studio_work.h"

/* The engine that the studio was told to have, or NULL; then `studio->error` says why. */
struct engine *studio_make_engine(struct studio *studio, const struct painting_def *def);
/* A fresh sheet with a seed of its own, at the script's first tick. False when none can be had: the old one stays. */
bool studio_begin_session(struct studio *studio);
/* Begins with the painting that the studio was given, `def.from`; false when it cannot be had. */
bool studio_take_up(struct studio *studio);
/* The painting on another grid. When that fails the old one stays. */
void studio_change_scale(struct studio *studio, float scale);
/* What the other script says, from now on: its inks, seed, coefficients that differ, actions that are still to come.
 * The painting stays, on the script's canvas. */
void studio_take_script(struct studio *studio, const struct script *script);
void studio_set_trouble(struct studio *studio, const char *text);

#endif
