/* An expression in x and y (0..1 of the sheet, x right, y down) and pi, evaluated by muParser.
 * Besides muParser's own operators and functions: atan2(y, x), hypot(x, y), floor(x), ceil(x), mod(x, y) with the sign
 * of y, clamp(x, low, high), smoothstep(low, high, x). Comparisons give 1 or 0. */
#ifndef FROND_FORMULA_H
#define FROND_FORMULA_H

#include <stdbool.h>

enum { FORMULA_LENGTH_MAX = 1000 }; /* bytes of an expression */

/* A value is rounded to 1/FORMULA_STEPS: what the last bit of a machine's libm says then decides nothing, but where a
 * rounding or a comparison falls exactly on its edge. */
#define FORMULA_STEPS     65536.0
#define FORMULA_VALUE_MAX 65536.0 /* values lie within plus and minus this */

struct formula_problem {
    int at;         /* the character inside the expression, from 1; 0: the expression as a whole */
    char text[256]; /* "what was found; what is allowed" */
};

struct formula;

/* NULL when the expression is wrong, with the reason in `problem`. */
struct formula *formula_create(const char *expression, struct formula_problem *problem);
void formula_destroy(struct formula *formula); /* takes NULL */

/* Samples the middle of each of width * height cells, row by row from the top left. False at the first value that is
 * not finite or too large, with the place in `problem`. */
bool formula_sample(struct formula *formula, int width, int height, float *values, struct formula_problem *problem);

#endif
