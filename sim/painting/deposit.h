/* What an action lays on the cells of a painting, worked out once for every engine: from the action and the ground
 * alone, without knowing what grows or flows. An engine applies it cell by cell, each verb in its own way:
 *
 *     verb          cell by cell, where cover > 0 (but pour)
 *     drop          rho_a = max(rho_a, seed); solvent comes: cover * solvent; ink comes: cover * amount
 *     brush_solvent solvent comes: cover * amount
 *     brush_ink     ink comes: cover * amount, if the ground is carved there
 *     draw          dry pigment of the ink = max(dry, cover * amount)
 *     pour          cover > 0: fresh ground, everything on it gone; else rho_a = max(rho_a, seed) if rho_p alone is as
 * much dry           the share `cover` of solvent, ink and wet pigment dries or leaves wet           solvent comes, if
 * carved: cover * solvent; the share `amount` of dry pigment loosens rinse         as rinse.h says: cover is the phase
 * of the water, seed the turn of its flow
 *
 * Carved is rho_a + rho_p > CARVED_DEPTH (kernel.h). Ink comes with pigment, which blends by mass. Cells under an
 * obstacle are left out, but by draw, pour, dry and rinse. A deposit comes in parts of whole rows, so that the largest
 * takes no more room than the smallest:
 *
 *     deposit_begin(&deposit, ground, &action);
 *     while (deposit_next(&deposit)) {
 *         apply deposit.part, deposit.cover, deposit.seed
 *     } */
#ifndef FROND_DEPOSIT_H
#define FROND_DEPOSIT_H

#include "ground.h"
#include "region.h"
#include "rinse.h"

enum { DEPOSIT_CELLS = 1 << 15 }; /* of a part at most: seven rows of the widest sheet */

struct deposit {
    enum action_verb verb;
    int ink;
    float solvent, amount;  /* as the verb has them, in its units */
    struct rectangle cells; /* of all parts, on the sheet; empty when the verb lays nothing */
    struct rectangle part;  /* of this part */
    float *cover;           /* [part rows][part columns], 0..1; owned */
    float *seed;            /* as many; only drop, pour and rinse have any: else as it was */
    const struct ground *ground;
    struct action action; /* its rasters and path stay with the caller until the last part */
    struct region region;
    struct rinse water; /* of a rinse */
    int x, y;           /* cell that a drop falls on */
};

/* Room for one part; false when memory is short. deposit_finish takes a zeroed one. */
bool deposit_init(struct deposit *deposit, size_t *bytes);
void deposit_finish(struct deposit *deposit);

/* `action` is legal (action_legal). The ground may have had the action already or not, it makes no difference. */
void deposit_begin(struct deposit *deposit, const struct ground *ground, const struct action *action);
/* Whether it may bring liquid to its cells. */
bool deposit_is_wet(const struct deposit *deposit);
/* Fills in the next part; false when there is none. */
bool deposit_next(struct deposit *deposit);

#endif
