/* Which picture format a file is, by its first bytes alone. */
#ifndef FROND_IMAGE_FORMAT_H
#define FROND_IMAGE_FORMAT_H

#include <stddef.h>

enum {
    IMAGE_FORMAT_BYTES = 12, /* enough of the start of a file to tell */
};

/* The name of the decoder: "png", "jpeg", "webp", "tiff" or "openexr"; NULL for anything else, however alike. Sources:
 * PNG 5.2, JPEG (ITU T.81) B.1.1.3, RFC 9649 section 2.4, TIFF 6.0 section 2 and BigTIFF, OpenEXR file layout. */
const char *image_format(const void *bytes, size_t size);

#endif
