/* Journals for tests, and what their records are compared by. */
#ifndef FROND_JOURNAL_CASE_H
#define FROND_JOURNAL_CASE_H

#include "journal.h"

/* A head, and a sheet of 64x48 cells with three inks. */
struct journal_head journal_case_head(void);
struct journal_sheet journal_case_sheet(void);

/* An action with a value of its own in every parameter of its verb, all of them legal. Points and values of paths and
 * rasters are the case's. */
struct journal_case_values {
    struct point points[3];
    float values[2 * 4 * 3];
};
struct action journal_case_action(enum action_verb verb, int seed, struct journal_case_values *values);

/* Whether they are one sheet, as far as a journal knows it. */
bool journal_case_same_sheet(const struct journal_sheet *a, const struct journal_sheet *b);
/* Whether they are one action: every parameter, every point and every value of a raster, to the bit. */
bool journal_case_same(const struct action *a, const struct action *b);

#endif
