/* What an action lays on the cells of a painting, worked out once for every engine: from the action and the ground
 * alone, without knowing what grows or flows. An engine applies it cell by cell, by the law that the verb names.
 * Cells under an obstacle are left out, unless the verb crosses them. A deposit comes in parts of whole rows, so that
 * the largest takes no more room than the smallest:
 *
 *     deposit_begin(&deposit, ground, &action);
 *     while (deposit_next(&deposit)) {
 *         apply deposit.part, deposit.cover, deposit.seed by deposit.law
 *     } */
#ifndef FROND_DEPOSIT_H
#define FROND_DEPOSIT_H

#include "ground.h"
#include "region.h"
#include "rinse.h"

enum { DEPOSIT_CELLS = 1 << 15 }; /* of a part at most: seven rows of the widest sheet */

/* What is done to a cell, where cover > 0 (but FRESH). Carved is rho_a + rho_p > CARVED_DEPTH (kernel.h). Ink comes
 * with pigment, which blends by mass. In this order in deposit.comp, too. */
enum deposit_law {
    DEPOSIT_NOTHING,
    DEPOSIT_DROP,    /* rho_a = max(rho_a, seed); solvent comes: cover * solvent; ink comes: cover * amount */
    DEPOSIT_SOLVENT, /* solvent comes: cover * amount */
    DEPOSIT_INK,     /* ink comes: cover * amount, if the ground is carved there */
    DEPOSIT_LINE,    /* dry pigment of the ink = max(dry, cover * amount) */
    DEPOSIT_FRESH,   /* cover > 0: fresh ground, everything on it gone; else rho_a = max(rho_a, seed) if rho_p >
                        CARVED_DEPTH */
    DEPOSIT_DRIES,   /* the share `cover` of solvent, ink and wet pigment dries or leaves */
    DEPOSIT_WETS,    /* solvent comes, if carved: cover * solvent; the share `amount` of dry pigment loosens */
    DEPOSIT_RINSE,   /* as rinse.h says: cover is the phase of the water, seed the turn of its flow */
    DEPOSIT_LAWS,
};

struct painting_verb;

struct deposit {
    const struct painting_verb *verb; /* NULL: it does nothing to a painting */
    enum deposit_law law;
    int ink;
    float solvent, amount;  /* as the verb has them, in its units */
    struct rectangle cells; /* of all parts, on the sheet; empty when the verb lays nothing */
    struct rectangle part;  /* of this part */
    float *cover;           /* [part rows][part columns], 0..1; owned */
    float *seed;            /* as many; only DROP, FRESH and RINSE have any: else as it was */
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
/* Fills in the next part; false when there is none. */
bool deposit_next(struct deposit *deposit);
/* Whether liquid may come to its cells. */
bool deposit_brings_liquid(const struct deposit *deposit);

#endif
