/* One painting twice: as planes for the picture of the CPU, as textures for that of the GPU. */
#ifndef FROND_PICTURE_CASE_H
#define FROND_PICTURE_CASE_H

#include "display.h"
#include "painting.h"
#include "picture_gpu.h"

struct picture_case {
    int width, height;                       /* cells */
    float *ground, *ink, *pattern, *vectors; /* texels, as fields.h has them */
};

struct display *picture_case_display(int width, int height, int rotation);
void picture_case_init(struct picture_case *subject, int width, int height); /* nothing painted */
/* The session of busy.h up to this tick: every verb, four inks. */
void picture_case_busy(struct picture_case *subject, int ticks);
void picture_case_publish(struct picture_case *subject, struct painting *painting);
/* As textures of the current context. */
void picture_case_upload(const struct picture_case *subject, struct fields *fields);
void picture_case_finish(struct picture_case *subject);

/* How far two pictures are apart. */
struct picture_difference {
    int most;
    long count[256]; /* channels that differ by so much */
    int x, y;        /* where by the most */
};
struct picture_difference picture_case_compare(const uint8_t *a, const uint8_t *b, int width, int height);

/* Both pictures of a subject; owned by the caller. The display must show as many pixels as def has. */
uint8_t *picture_case_cpu(const struct picture_case *subject, const struct picture_def *def);
uint8_t *picture_case_gpu(const struct picture_case *subject, const struct picture_def *def, struct display *display);

#endif
