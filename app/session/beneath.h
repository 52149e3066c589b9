/* Opening a file that a script or an exhibit names, and no other: it lies in that one's folder or below it. */
#ifndef FROND_BENEATH_H
#define FROND_BENEATH_H

#include "file.h"

/* Opens `path`, relative to `folder`, for reading. Absolute paths, `..` and symbolic links out of the folder are
 * refused (openat2; where the kernel lacks it, every symbolic link is). `what` it is meant to be:
 * "a picture". What is not there and lies in `stock/`, or is `stock` itself, is one of the pictures that come with
 * Frond (stock_find), or their folder. Returns a file descriptor, or -1 with "what was found; what is allowed" in
 * `error`. */
int beneath_open(const char *folder, const char *path, const char *what, struct file_error *error);

#endif
