/* Running water (not in the paper): the geometry of a `rinse`, and what it does to a cell.
 *
 * A front is a line across the flow; the water stands behind it, `reach` of the sheet deep. How far a cell is behind
 * the front, in shares of that depth, is its phase, 0..1: it grows as the front passes over the cell. Where the water
 * is early, and where it turns aside, is noise of the cell and the sheet's seed, so a front that goes on does not
 * flicker. In the first shares the water comes and things loosen: a thin film of ink's liquid runs along the flow, on
 * ground that is carved evenly, and takes the wet pigment along; in the last shares all of it goes. */
#ifndef FROND_RINSE_H
#define FROND_RINSE_H

#include "action.h"
#include "canvas.h"
#include "rectangle.h"

enum {
    RINSE_POINTS = 32, /* of a front; more are not heeded */
    RINSE_LATTICE = 4, /* cells between places where the water is worked out; between them it is bilinear */
    RINSE_LATTICE_MOST = (CANVAS_SIZE_MAX + 2 * CANVAS_MARGIN_MAX) / RINSE_LATTICE + 2,
};

#define RINSE_MOST  0.6f  /* of `vary`, that the water may be early or late by */
#define RINSE_OVER  0.97f /* phase from which a cell is fresh */
#define RINSE_FILM  0.4f  /* carved pattern under the water: ink's liquid is free to go there */
#define RINSE_WATER 0.5f  /* density of the film */
#define RINSE_SPEED 0.7f  /* cells that it goes in a step */

struct rinse {
    struct canvas canvas;
    struct point flow; /* of length 1 */
    bool disc;
    struct point at; /* middle of a disc, cells of the visible sheet */
    float radius, depth, vary;
    float size;                           /* of the features of the noise across the flow, cells */
    int count;                            /* points of the front, by `across` */
    struct point front[RINSE_POINTS];     /* x: across the flow, y: along it; cells of the visible sheet */
    struct rectangle cells, over;         /* bounds of the water, and of its last, clipped to the sheet */
    int line;                             /* of the lattice, whose rows, and those of the next, are at hand */
    float rows[2][2][RINSE_LATTICE_MOST]; /* [line & 1][behind the front, turn] */
};

/* `action` is a legal rinse. Without a path and a place it has no cells. */
void rinse_begin(struct rinse *rinse, const struct canvas *canvas, const struct action *action);
/* The phase of a cell (of the sheet with its margin), 0: no water; 0..1. `turn` (-1..1) is how far the flow there turns
 * aside. Rows are to be asked for one after another, else it is slow. */
float rinse_phase(struct rinse *rinse, int x, int y, float *turn);
/* Whether the phase is past RINSE_OVER. */
bool rinse_is_over(struct rinse *rinse, int x, int y);

struct rinse_shares {
    float wets;   /* of what lies there that gives way to water */
    float thins;  /* of the wet pigment that goes */
    float drains; /* of all the rest that goes */
};
/* In one tick; `strength` as the action has it. */
struct rinse_shares rinse_shares(float phase, float strength);
/* The share that goes in one tick of what does not flow, but fades under water: a branch, a bolt, chemicals. */
float rinse_takes(float phase, float strength);

#endif
