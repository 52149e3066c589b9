/* Row kernels of the painting: each computes one row of cells from the rows around it. kernel.c is compiled once for
 * each width of vectors; every copy gives the same bits. Rows lie in rings, RING floats apart from field to field, a
 * constant so that every address is a base and an offset. Cells are counted from the first of the run; `begin` and
 * `end` are multiples of 16; one cell beyond either is read. */
#ifndef FROND_KERNEL_H
#define FROND_KERNEL_H

#include <stddef.h>
#include <stdint.h>

#include "d2q9.h"

enum {
    RING = 800,       /* floats a row of a ring: 16 + 16 + 736 + 16 and room, and not a power of two */
    RING_LEAD = 16,   /* floats before the first cell */
    RUN_WIDEST = 736, /* cells of a run, without the 16 of halo on either side: a sheet of 720 needs no seam */
    HALO = 16,
    INKS = 4,
};

/* Fields of a row of the fluids, in the order of memory: populations of solvent and of ink, pigment. */
enum {
    FLUID_SOLVENT = 0,
    FLUID_INK = POPULATIONS,
    FLUID_WET = 2 * POPULATIONS,
    FLUID_FIELDS = FLUID_WET + INKS,
};

/* What the links of a row let through, made once a tick. Openness is 1 - kappa (section 4.2) clamped to 0..1; a gate is
 * the mean openness of the two ends of a link: from the left, from above, from above left, from above right. */
enum {
    GATE_SOLVENT = 0,
    GATE_INK = 4,
    OPEN_SOLVENT = 8,
    OPEN_INK = 9,
    GATE_FIELDS = 10,
};
enum { GATE_LEFT, GATE_UP, GATE_UP_LEFT, GATE_UP_RIGHT };
#define CLOSED (-4.0f) /* openness of an obstacle or the wall while gates are made: no mean with it is above 0 */

enum {
    PATTERN_ACTIVE,
    PATTERN_CATALYST,
    PATTERN_CARVED,
    PATTERN_FIELDS,
    PATTERN_POWER = PATTERN_FIELDS,
    PATTERN_RING_FIELDS
};

/* What the pattern layer needs of a cell and no step changes. */
enum { RATE_DIFFUSION, RATE_GROWTH, RATE_CATALYST, RATE_WEIGHT, RATE_OPEN, RATE_GUIDE_X, RATE_GUIDE_Y, RATE_FIELDS };

/* Bookkeeping of the fluids for the rest of the frame. */
enum { FLOW_DENSITY, FLOW_U, FLOW_V, FLOW_MOVED, FLOW_FIELDS };

struct fluid_row {
    int begin, end;
    const float *above, *here, *below;                   /* [FLUID_FIELDS][RING] */
    const float *gates_above, *gates_here, *gates_below; /* [GATE_FIELDS][RING]; below: the links to the row below */
    float *out;       /* [FLUID_FIELDS][RING]; of the last step, [FLUID_FIELDS][stride] of the painting itself */
    ptrdiff_t stride; /* of the painting: fluid_first reads, fluid_last writes rows that far apart */
    float *flow;      /* [FLOW_FIELDS][RING] */
    int32_t *changed; /* |= 1 where a population crossed a link */
    float omega, inverse_mu, gamma;
    float round; /* 1.5 * 2^23 * q: adding and taking it away rounds to multiples of q */
};

struct pattern_row {
    int begin, end;
    const float *above, *here, *below;              /* [PATTERN_RING_FIELDS][RING] */
    const float *rates_above, *rates, *rates_below; /* [RATE_FIELDS][RING] */
    float *out;                                     /* [PATTERN_RING_FIELDS][RING] */
    float *sums;                                    /* [RING] of scratch */
    float keep, carve, consume;                     /* 1 - dt beta_p; dt beta_p; dt beta_y */
    float seam, guide;                              /* catalyst; dt beta_v */
    float catalyst_weight; /* diagonal weight of the catalyst's Laplacian; only the full kernel heeds it */
};

struct rates_row { /* makes the rates of a row from its maps */
    int begin, end;
    const float *solvent;
    const uint16_t *alpha_a, *xi, *beta_a, *s_max, *alpha_y;
    const uint8_t *weight;
    float *rates;                           /* [RATE_FIELDS][RING] */
    float delta, scale_a, scale_b, scale_y; /* times dt and the units of the maps */
    float fixed_weight;                     /* >= 0: instead of the map */
};

struct pattern_end_row { /* compares old and new of a row, and stores the new */
    int begin, end, stride;
    const float *from; /* [PATTERN_RING_FIELDS][RING] */
    float *to;         /* [PATTERN_FIELDS][stride] */
    int32_t *changed;  /* |= PATTERN_CHANGED, PATTERN_ALIVE, PATTERN_OPENED */
};
enum { PATTERN_CHANGED = 1, PATTERN_ALIVE = 2, PATTERN_OPENED = 4 };

struct open_row { /* makes the openness of a row from its pattern */
    int begin, end;
    const float *active, *catalyst, *carved;
    float *open; /* [2][RING], solvent and ink */
};

struct gates_row { /* makes the gates between a row and the one above it */
    int begin, end;
    const float *above, *here; /* [2][RING], openness of solvent and ink or CLOSED */
    float *gates;              /* [GATE_FIELDS][RING] */
};

struct kernels {
    void (*open)(const struct open_row *);
    void (*gates)(const struct gates_row *);
    void (*fluid)(const struct fluid_row *);
    void (*pigment)(const struct fluid_row *);
    void (*fluid_first)(const struct fluid_row *);
    void (*pigment_first)(const struct fluid_row *);
    void (*fluid_last)(const struct fluid_row *);
    void (*pigment_last)(const struct fluid_row *);
    void (*rates)(const struct rates_row *);
    void (*pattern)(const struct pattern_row *); /* free ground: no obstacle, no guidance, catalyst by five points */
    void (*pattern_full)(const struct pattern_row *); /* everything; the same bits on free ground */
    void (*square)(const float *active, float *squares, int begin, int end);
    void (*raise)(const float *active, float *powers, int begin, int end, float k); /* active^k */
    void (*pattern_end)(const struct pattern_end_row *);
    /* |= 1 where growth will see other solvent than before; stores the new density. */
    void (*fluid_end)(const float *density, float *stored, const uint16_t *s_max, int32_t *changed, int begin, int end,
                      float delta);
};

/* Active + carved pattern above which ground counts as carved: a branch, not the trace of one. */
#define CARVED_DEPTH 0.1f

/* Units of the maps of coefficients: value = stored * unit. */
#define UNIT_ALPHA_A (1.0f / 32768)
#define UNIT_XI      (1.0f / 16384)
#define UNIT_BETA_A  (1.0f / 4096)
#define UNIT_S_MAX   (1.0f / 32768)
#define UNIT_ALPHA_Y (1.0f / 16384)
#define UNIT_WEIGHT  (1.0f / 1020)
#define UNIT_GUIDE   (1.0f / 8192)

extern const struct kernels kernels_narrow;
#if defined(__x86_64__)
extern const struct kernels kernels_avx2, kernels_avx512;
#endif

#endif
