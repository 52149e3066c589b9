/* What draws beside the painting: Cairo and Pango on a sheet of its own, a soft brush, words in every language. */
#ifndef FROND_PEN_H
#define FROND_PEN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <pango/pangocairo.h>

struct pen {
    cairo_surface_t *surface;
    cairo_t *cairo;
    PangoLayout *layout;
};

struct pen_colour {
    double red, green, blue; /* sRGB, 0..1 */
};

extern const struct pen_colour pen_paper, pen_dark; /* of a card; of lines and words on it */

/* A clear sheet of so many pixels. False when memory is short; nothing is to be closed then. */
bool pen_open(struct pen *pen, int width, int height);
/* Writes [height][width][4] bytes of sRGB red green blue alpha, multiplied by alpha, unless NULL, and ends it. */
void pen_close(struct pen *pen, uint8_t *rgba);

/* The same colour for what comes, alpha 0..1. */
void pen_set(const struct pen *pen, struct pen_colour colour, double alpha);
/* Halfway, 0..1, from one to the other. */
struct pen_colour pen_between(struct pen_colour from, struct pen_colour to, double share);
/* What inks[ink] looks like at a thickness (ink.h), mixed as enum ink_mixing says. */
struct pen_colour pen_ink(int ink, int mixing, double thickness);
/* Relative luminance, 0..1 (WCAG 2). */
double pen_luminance(struct pen_colour colour);
/* A number in 0..1 that looks like chance, always the same for the same two. */
double pen_chance(unsigned seed, unsigned index);

/* A stroke of a brush through points, smooth, of a width that goes from `first` by `middle` to `last`. */
void pen_brush(const struct pen *pen, const double (*points)[2], int count, double first, double middle, double last);
/* A path around a blot of a middle radius, its edge wavy by a share of it. */
void pen_blot(const struct pen *pen, double x, double y, double radius, double wave, unsigned seed);
/* A path of a rectangle with round corners; with an edge as of hand-made paper when `wave` > 0, pixels. */
void pen_card(const struct pen *pen, double x, double y, double width, double height, double radius, double wave,
              unsigned seed);
/* A card of paper with its shadow, which reaches `shadow` pixels beyond it. */
void pen_draw_card(const struct pen *pen, double x, double y, double width, double height, double radius, double shadow,
                   double alpha);

/* Words. */
struct pen_words {
    const char *text; /* UTF-8 */
    const char *tag;  /* BCP 47: what script and quotes are meant */
    double size;      /* pixels */
    double width;     /* pixels: broken into lines of about the same length within it; 0: one line */
    bool bold;
};
/* Pixels that they take. Returns how many lines. */
int pen_measure(const struct pen *pen, const struct pen_words *words, double *width, double *height);
/* Writes them, the middle of the block at x, y. */
void pen_write(const struct pen *pen, const struct pen_words *words, double x, double y);
/* The same with a soft border of paper around each letter, for words on a painting. */
void pen_write_haloed(const struct pen *pen, const struct pen_words *words, double x, double y);
/* One line from x on, its middle at y; where it is wider than that many pixels two small ones, and dots for the rest.
 */
void pen_write_cut(const struct pen *pen, const struct pen_words *words, double x, double y, double width);
/* How many of its characters no font has. */
int pen_unknown(const struct pen *pen, const struct pen_words *words);

/* A key over everything that is hashed into it (FNV-1a); begin with PEN_KEY. */
#define PEN_KEY UINT64_C(0xcbf29ce484222325)
uint64_t pen_hash(uint64_t key, const void *data, size_t size);
uint64_t pen_hash_text(uint64_t key, const char *text);
uint64_t pen_hash_int(uint64_t key, int64_t value);

/* Cairo's pixels, in the order of the machine, as bytes red green blue alpha. */
void pen_rgba(const uint8_t *from, int stride, int width, int height, uint8_t *rgba);

#endif
