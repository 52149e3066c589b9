/* Kinds of what grows by Laplacian growth, as `frond bolt` and scenes of lightning know them: for each the values of
 * its growth, where it begins, what attracts it, and what it looks like (Kim et al., sections IV and V). */
#ifndef FROND_BOLT_H
#define FROND_BOLT_H

#include "laplacian.h"

enum bolt_kind {
    BOLT_LIGHTNING,   /* from above to a place below */
    BOLT_TESLA,       /* from a small electrode outwards, in all directions */
    BOLT_TREE,        /* upwards from the ground, with leaves */
    BOLT_LICHEN,      /* flat, dense, from a place */
    BOLT_CORAL,       /* thick, from the ground, in 3D */
    BOLT_RIVER,       /* a delta, towards the sea */
    BOLT_SNOW,        /* six arms */
    BOLT_FRACTURE,    /* cracks from an impact */
    BOLT_VESSELS,     /* towards many places that want to be reached */
    BOLT_CITY,        /* streets, on the grid */
    BOLT_LICHTENBERG, /* a discharge in a disc, from its edge or its middle */
    BOLT_FROST,       /* on a pane, from its edge */
    BOLT_KINDS,
};
extern const char *const bolt_kind_names[BOLT_KINDS + 1]; /* ends with NULL */
extern const char *const bolt_kind_meanings[BOLT_KINDS];  /* a sentence each, for a curator */

/* The look of it; see bolt_light.h. */
enum bolt_style { BOLT_GLOW, BOLT_LINE, BOLT_BODY, BOLT_STYLES };
struct bolt_look {
    int style;                           /* light on the dark, lines on paper, lit bodies with depth */
    float trunk, tip;                    /* cells: radius at the root and at the tips */
    float pipe;                          /* radius^pipe adds up where branches meet (2: Leonardo's rule, 3: Murray's) */
    float colour[3], core[3], ground[3]; /* linear light 0..1: of the branches, of their hot middle, behind them */
    float leaves;                        /* a leaf at every so many particles near the tips; 0: none (the paper: 5) */
    float life;                          /* ticks that a strike glows; 0: it stays */
};

/* How a kind grows and looks. Charges and seeds are those of a growth that is `span` cells wide, from the middle of it
 * or from where the kind begins; `charges` and `seeds` of the definition point into `bolt` itself. */
enum { BOLT_CHARGES = 64, BOLT_SEEDS = 16 };
struct bolt {
    struct laplacian_def growth;
    struct laplacian_charge charges[BOLT_CHARGES];
    struct laplacian_seed seeds[BOLT_SEEDS];
    struct bolt_look look;
};
/* Fills `bolt`, which stays where it is. `width`, `height`: cells that it has room for. */
void bolt_preset(struct bolt *bolt, enum bolt_kind kind, int width, int height);

#endif
