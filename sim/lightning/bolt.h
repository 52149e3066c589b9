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

/* The look of it; see bolt_light.h. Lengths are in cells of the room, in bolt_look_keys those of the table. */
enum bolt_style { BOLT_GLOW, BOLT_LINE, BOLT_BODY, BOLT_STYLES };
struct bolt_look {
    int style;                           /* light on the dark, lines on paper, lit bodies with depth */
    float trunk, tip;                    /* cells: radius at the root and at the tips */
    float pipe;                          /* radius^pipe adds up where branches meet (2: Leonardo's rule, 3: Murray's) */
    float colour[3], core[3], ground[3]; /* linear light 0..1: of the branches, of their hot middle, behind them */
    float leaves;                        /* a leaf at every so many particles near the tips; 0: none (the paper: 5) */
    float life;                          /* ticks that a strike glows; 0: it stays */
    int smooth;                          /* times that branches are evened out along themselves; 0: as they grew */
};
extern const char *const bolt_style_names[BOLT_STYLES + 1]; /* "glow", "line", "body"; ends with NULL */
extern const struct key bolt_look_keys[]; /* of struct bolt_look; ends with a key whose name is NULL */

/* How a kind grows and looks. The growth is `growth.span` of its own cells wide, which are drawn over the whole width
 * of the room (bolt_scale); its origin is the middle of the room, and charges and seeds lie about it. A scene that lets
 * it begin elsewhere moves both by where that is, less seeds[0].from. `charges` and `seeds` of the definition point
 * into `bolt` itself. */
enum { BOLT_CHARGES = 64, BOLT_SEEDS = 64 };
struct bolt {
    struct laplacian_def growth;
    struct laplacian_charge charges[BOLT_CHARGES];
    struct laplacian_seed seeds[BOLT_SEEDS];
    struct bolt_look look; /* lengths in cells of the room */
};
/* Fills `bolt`, which stays where it is. `width`, `height`: cells that it has room for, 1.. each. The same values on
 * every machine. */
void bolt_preset(struct bolt *bolt, enum bolt_kind kind, int width, int height);
/* Another span, in cells of the growth: seeds, charges, extent and environment move with it, particles stay as many. */
void bolt_respan(struct bolt *bolt, float span);
/* Cells of the room to a cell of the growth. */
float bolt_scale(const struct bolt *bolt, int width);

#endif
