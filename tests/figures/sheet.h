/* A contact sheet: square pictures in rows, a label under each, a title above all. Drawn with Cairo and Pango. */
#ifndef FROND_SHEET_H
#define FROND_SHEET_H

#include <stdint.h>

#include "figure.h"

struct sheet;

/* Room for columns * rows pictures of `side` by `side` pixels. Stops the program when memory is short. */
struct sheet *sheet_create(const struct figure *figure, const char *title, int columns, int rows, int side);
void sheet_destroy(struct sheet *sheet); /* takes NULL */

int sheet_side(const struct sheet *sheet);
/* Pixels of one picture, side * side * 3 bytes red green blue, and what stands under it, about three lines; it is
 * printed too. */
void sheet_add(struct sheet *sheet, const uint8_t *rgb, const char *label, ...) __attribute__((format(printf, 3, 4)));
/* Writes the sheet into the folder of the figure, named after it, and destroys it. Stops the program when that cannot
 * be done. */
void sheet_finish(struct sheet *sheet);

#endif
