/* A picture that dendrites and trees grow over, for the figures. Every function stops the program when memory is short.
 */
#ifndef FROND_SITTER_H
#define FROND_SITTER_H

#include "figure.h"
#include "growth.h"
#include "growth_paint.h"
#include "motif.h"

enum { SITTER_SIDE = 512, SITTER_SHOWN = 640 };

struct sitter {
    float linear[3 * SITTER_SIDE * SITTER_SIDE], grey[SITTER_SIDE * SITTER_SIDE];
    float rgb[3 * SITTER_SHOWN * SITTER_SHOWN], backdrop[3 * SITTER_SHOWN * SITTER_SHOWN],
        linear_backdrop[3 * SITTER_SHOWN * SITTER_SHOWN];
    float ink[SITTER_SIDE * SITTER_SIDE], matter[SITTER_SIDE * SITTER_SIDE];
    uint8_t bytes[3 * SITTER_SHOWN * SITTER_SHOWN]; /* what is shown */
};

/* By formula; free() it. */
struct sitter *sitter_draw(enum motif motif);
struct growth *sitter_grow(struct sitter *sitter, const struct growth_def *def);

/* These fill `bytes`. */
void sitter_paint(struct sitter *sitter, const struct growth *growth, const struct growth_paint_def *def);
void sitter_paint_whole(struct sitter *sitter, const struct growth *growth);
/* A plane of the picture, as grey. */
void sitter_show_plane(struct sitter *sitter, const float *plane);
/* Figure 5: how early each place is reached, light first. */
void sitter_show_contours(struct sitter *sitter, const struct growth *growth);

/* Blurred structure beside blurred importance within a part: more than `least`, and more than beside importance that
 * was moved. */
void sitter_check_seen(struct figure *figure, struct sitter *sitter, const struct growth *growth, const char *what,
                       double least, struct rectangle part);
/* One piece a seed, no cycles, endpoints reached. Returns the figures of the layer in front. */
struct dendrite_figures sitter_check_sound(struct figure *figure, const struct growth *growth, const char *what);

#endif
