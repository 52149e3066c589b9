/* Separable resampling with the cubic kernels of Mitchell and Netravali (1988), eq. 8: one axis of it. */
#ifndef FROND_PICTURE_RESAMPLE_H
#define FROND_PICTURE_RESAMPLE_H

#include <stdbool.h>

struct resample {
    int count;      /* samples out */
    int taps;       /* samples in that make one out */
    int *start;     /* [count] first of them; start + taps never passes the end of the input */
    float *weights; /* [count][taps], each row sums to 1; the border is repeated outwards */
};

/* From `from` samples to `to`, stretched; b and c are the kernel's (1, 0: B-spline; 1/3, 1/3: Mitchell). Widened when
 * it shrinks. False when memory is short. */
bool resample_init(struct resample *resample, int from, int to, float b, float c);
void resample_finish(struct resample *resample); /* takes a zeroed one */
void resample_row(const struct resample *resample, const float *in, float *out);

#endif
