/* A painting under study: one that is grown, looked at and measured. Every function stops the program when memory is
 * short. */
#ifndef FROND_SUBJECT_H
#define FROND_SUBJECT_H

#include "ink.h"
#include "painting.h"
#include "shape.h"
#include "sheet.h"

struct subject {
    struct painting *painting;
    int width, height;
    size_t cells;
    float *depth;          /* active + carved, when last measured or read */
    float *planes;         /* PAINTING_INKS + 2 to spare */
    int inks[INK_PALETTE]; /* what the inks of the painting are: indices into inks[] (ink.h); the first palette */
    double x, y;           /* cells: where figures are measured from; the middle of the sheet */
};

/* A square sheet with default coefficients and one thread: CTest runs several figures at once. */
struct painting_def subject_def(int size);
struct subject subject_create(const struct painting_def *def);
void subject_finish(struct subject *subject); /* takes a zeroed one */

/* A default drop, at 0..1 of the sheet. */
struct action subject_drop(float x, float y);
void subject_run(struct subject *subject, int ticks);
const float *subject_depth(struct subject *subject);
/* A field, until the next call. */
const float *subject_read(struct subject *subject, enum painting_field field);
struct shape_figures subject_measure(struct subject *subject);
/* The same cells in another mask: those of active + carved above a tenth. */
int64_t subject_area(struct subject *subject);

/* Greys of depth, as the paper shows its patterns. */
void subject_show_depth(struct subject *subject, struct sheet *sheet, const char *label, ...)
    __attribute__((format(printf, 3, 4)));
enum subject_light { SUBJECT_PLAIN, SUBJECT_PLAIN_CMY, SUBJECT_LIT };
/* Its ink as a picture of side * side * 3 bytes; the caller's to free. */
uint8_t *subject_picture(struct subject *subject, int side, enum subject_light light);
void subject_show_ink(struct subject *subject, struct sheet *sheet, enum subject_light light, const char *label, ...)
    __attribute__((format(printf, 4, 5)));

/* One default drop in the middle, grown for `ticks`, measured, shown with its figures below `label`. */
struct shape_figures subject_grow(const struct painting_def *def, int ticks, struct sheet *sheet, const char *label,
                                  ...) __attribute__((format(printf, 4, 5)));
/* The same until its front is `radius` cells away, at most `most` ticks; `ticks`, unless NULL, is how many it took. */
struct shape_figures subject_grow_to(const struct painting_def *def, double radius, int most, struct sheet *sheet,
                                     const char *label, ...) __attribute__((format(printf, 5, 6)));

#endif
