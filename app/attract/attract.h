/* Attract: the sheet paints itself. Sessions are recorded ones of the exhibit, varied, and generated ones, in turn;
 * scenes of trees are planted and tended,
 * those of lightning struck, those of chemistry dosed. No two of a day are the same, and something always moves. Pure
 * but for its seed: ticks come in, actions come out; nothing is written anywhere.
 *
 *     attract_begin(attract, scene, aspect);                               on a fresh sheet (studio_fresh)
 *     while (attract_action(attract, tick, &action)) { studio_post... }    tick: since the sheet was fresh
 *     if (attract_over(attract, tick)) { wash, begin again }
 *
 * A wash alone does not make a fresh sheet: a recorded session may have set coefficients for all of it. */
#ifndef FROND_ATTRACT_H
#define FROND_ATTRACT_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"
#include "exhibit.h"

struct attract;

/* `seed`: of the day and the start (a kiosk takes the clock). NULL: memory is short. The exhibit outlives it. */
struct attract *attract_create(const struct exhibit *exhibit, uint64_t seed);
void attract_destroy(struct attract *attract); /* takes NULL */
/* Another session for a fresh sheet. `aspect`: its width over its height. It takes visit.attract seconds at most, less
 * where the sheet has no room for so much. */
void attract_begin(struct attract *attract, int scene, float aspect);
/* The next action that is due at this tick; its path, of at most STUDIO_PATH points, is good until the next call. */
bool attract_action(struct attract *attract, int64_t tick, struct action *action);
/* It has been looked at for long enough. */
bool attract_over(const struct attract *attract, int64_t tick);
/* Where a hand would be that paints this, for the legend (a ghost finger), 0..1 of the sheet and somewhat beyond, and
 * how hard it presses, 0..1; false: none is shown now. */
bool attract_hand(const struct attract *attract, int64_t tick, struct point *at, float *pressed);
/* A number that tells sessions apart. */
uint64_t attract_fingerprint(const struct attract *attract);

#endif
