/* Soft light and stains. */
#ifndef FROND_BLUR_H
#define FROND_BLUR_H

/* Three boxes one after another over width * height values, in place: nearly a Gaussian of that sigma, 1 at least.
 * `other` is as large. The border repeats. */
void blur_boxes(float *plane, float *other, int width, int height, float sigma);

#endif
