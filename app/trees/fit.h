/* A picture in the size that is wanted. */
#ifndef FROND_FIT_H
#define FROND_FIT_H

#include <stdbool.h>

#include "image.h"

enum { FIT_SIDE = 4096 }; /* pixels; what is larger comes out of the helper smaller */

/* For photographs of up to IMAGE_SIZE_MAX pixels a side, 268 megapixels, at most FIT_SIDE as they come out. */
struct image_def fit_def(void);
/* Reads a picture with these limits. On failure the image is the placeholder; finish it in any case. */
bool fit_read(const char *path, struct image *image, struct file_error *error);
/* width * height pixels of red, green, blue, alpha, linear light; the mean over each pixel's area, or between pixels
 * where the picture is smaller. Owned by the caller; NULL when memory is short. */
float *fit_linear(const struct image *image, int width, int height);
/* Width and height of a picture whose longer side is `side`. */
void fit_size(const struct image *image, int side, int *width, int *height);

#endif
