/* Pictures made by formula, for where no photograph is at hand: benches, tests, a kiosk with nothing else installed. */
#ifndef FROND_MOTIF_H
#define FROND_MOTIF_H

#include <stdbool.h>

enum motif { MOTIF_PORTRAIT, MOTIF_SPHERE, MOTIF_LANDSCAPE, MOTIF_WINTER, MOTIF_LEAF, MOTIFS };

extern const char *const motif_names[MOTIFS + 1]; /* ends with NULL */

/* width * height pixels of red, green, blue, linear light, row by row. */
void motif_draw(enum motif motif, int width, int height, float *rgb);

#endif
