/* What frond-image answers to a read, and the parser that does not believe it. The helper has touched a stranger's
 * bytes: every number is checked against the limits and against the size of the reply before it is used. */
#ifndef FROND_IMAGE_REPLY_H
#define FROND_IMAGE_REPLY_H

#include <stdint.h>

#include "image.h"

enum {
    IMAGE_REPLY_MAGIC = 0x66726e64,
    IMAGE_REPLY_VALUES = 8192, /* offset of the values in the reply, bytes */
    IMAGE_REPLY_MESSAGE = 256,
    IMAGE_REPLY_WAIT = 2, /* seconds by the clock beyond the seconds of processor, before a helper is killed */
};

enum image_reply_status {
    IMAGE_REPLY_OK = 1,
    IMAGE_REPLY_DAMAGED,  /* message: what the decoder said */
    IMAGE_REPLY_SIZE,     /* width, height: what the file claims */
    IMAGE_REPLY_CHANNELS, /* channels: what the file claims */
    IMAGE_REPLY_MEMORY,
    IMAGE_REPLY_DEEP, /* an EXR of deep samples or a TIFF of volumes: not a flat picture */
};

/* The start of a reply, in the byte order of this machine. Floats follow at IMAGE_REPLY_VALUES: rows from the top left,
 * channels interleaved. Written last, so that a helper killed half-way leaves no magic. */
struct image_reply {
    uint32_t magic;
    uint32_t status; /* enum image_reply_status */
    uint32_t width, height, channels;
    int32_t alpha;
    uint32_t orientation; /* EXIF, 1..8 */
    char names[IMAGE_CHANNELS_MAX][IMAGE_NAME];
    char message[IMAGE_REPLY_MESSAGE];
};

/* Makes an image of a reply of `size` bytes, aligned to 4. False with `error` for a reply that reports a failure or
 * cannot be true; `image` is then zeroed. `path` is what the error names. */
bool image_reply_parse(const void *reply, size_t size, const struct image_def *def, const char *path,
                       struct image *image, struct file_error *error);

#endif
