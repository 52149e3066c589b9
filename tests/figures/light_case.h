/* Aggregates that are grown for pictures of light, lines and bodies. */
#ifndef FROND_LIGHT_CASE_H
#define FROND_LIGHT_CASE_H

#include "bolt_light.h"

enum light_case {
    LIGHT_STRIKE,
    LIGHT_TESLA,
    LIGHT_DISC,
    LIGHT_RIVER,
    LIGHT_CITY,
    LIGHT_CRACKS,
    LIGHT_VESSELS,
    LIGHT_FROST,
    LIGHT_CORAL,
    LIGHT_TREE,
    LIGHT_CASES
};
extern const char *const light_case_names[LIGHT_CASES];

/* Grown, fitted into width x height cells; NULL and a reason when that fails. Segments, also in `own`, are
 * owned by the caller (free). */
const char *light_case_grow(enum light_case which, int width, int height, struct bolt_view *view,
                            struct bolt_segment **own);

#endif
