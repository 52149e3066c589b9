/* Pictures in and out. Strangers' files are decoded in a short-lived, sandboxed process of its own, frond-image: no
 * decoder shares the caller's address space, and the worst that a hostile file can do is to be refused.
 *
 *     struct image image;
 *     struct file_error error;
 *     if (!image_read("petals.png", NULL, &image, &error)) {
 *         fprintf(stderr, "%s\n", error.text);    (image holds the placeholder: go on)
 *     }
 *     ...
 *     image_finish(&image);
 *
 * Read: PNG, JPEG, TIFF, EXR, WebP, told apart by their first bytes and never by name. Written: PNG and EXR. All
 * functions may be called from any thread of a process that does not ignore SIGCHLD, and block: a read takes about 0.2
 * s more than the decoding. */
#ifndef FROND_IMAGE_H
#define FROND_IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "file.h"

enum {
    IMAGE_CHANNELS_MAX = 64,
    IMAGE_NAME = 64,             /* bytes of a channel's name, with the final NUL */
    IMAGE_SIZE_MAX = 16384,      /* pixels a side, whatever the limits say */
    IMAGE_PLACEHOLDER_SIZE = 64, /* pixels a side */
};

/* What a picture may cost, and who decodes it. */
struct image_def {
    int width, height; /* pixels, at most; 1..IMAGE_SIZE_MAX */
    int shrink;    /* pixels that the longer side comes out with, at most: blocks of 2x2, 3x3, ... pixels are averaged
                      in the helper; 0: as it is */
    int channels;  /* at most; 1..IMAGE_CHANNELS_MAX */
    int megabytes; /* at most, of the values handed back, and again of the decoder's own memory; 1..4096. Below 128
                      decoders refuse even small pictures */
    int seconds;   /* of processor for a read; two more by the clock end it in any case; 1..600 */
    int write_seconds;  /* the same for a write */
    const char *helper; /* path of frond-image; NULL: beside this program, in ../libexec/frond, or where installed */
};

struct image_def image_default_def(void); /* 8192x8192, as it is, 4 channels, 512 MB, 10 s, 120 s to write, NULL */

/* Linear light, pixels row by row from the top left, channels interleaved. Integer files (8 and 16 bits) are taken as
 * sRGB and made linear, 0..1; float files (EXR, float TIFF) are taken as they are, to the bit, but for infinities and
 * not-a-numbers, which become 0. Colour is not multiplied by alpha. A photograph is turned as its EXIF orientation
 * says. */
struct image {
    int width, height; /* pixels */
    int channels;      /* 1..4 unless the limits allow more: Y, YA, RGB, RGBA, or as named */
    int alpha;         /* which channel is alpha (0..1, linear); -1: none */
    float *values;     /* width * height * channels; owned; NULL only when memory is short, width and height then 0 */
    char names[IMAGE_CHANNELS_MAX][IMAGE_NAME]; /* of the channels: "R", "Y", "pattern.carved", ... */
};

/* Reads a picture. `def` NULL: the defaults. On failure returns false, says why in `error` (may be NULL) and makes
 * `image` the placeholder. Finish it in any case. */
bool image_read(const char *path, const struct image_def *def, struct image *image, struct file_error *error);
/* The number of the channel of that name, or -1. EXR files keep channels in the order of the alphabet. */
int image_channel(const struct image *image, const char *name);
/* Frees what the picture owns. Takes NULL and zeroed. */
void image_finish(struct image *image);

/* Writes 8-bit sRGB pixels, row by row from the top left, three bytes each; width * height * 3 bytes, 1..IMAGE_SIZE_MAX
 * a side. Atomic as file_write_atomic; on failure nothing is left behind. */
bool image_write_png(const char *path, const uint8_t *rgb, int width, int height, const struct image_def *def,
                     struct file_error *error);
/* Writes planes of width * height floats each, to the bit, as the named channels of an EXR; 1..IMAGE_CHANNELS_MAX
 * channels, different names of 1 to IMAGE_NAME - 1 bytes. Atomic as file_write_atomic. Costs a second copy of the
 * planes in memory while it works. */
bool image_write_exr(const char *path, const char *const names[], const float *const planes[], int channels, int width,
                     int height, const struct image_def *def, struct file_error *error);

#endif
