#include "image_format.h"

#include <string.h>

static const struct {
    const char *name;
    size_t offset, size;
    const char *magic;
} formats[] = {
    {"png", 0, 8, "\x89PNG\r\n\x1a\n"},
    {"jpeg", 0, 3, "\xff\xd8\xff"},
    {"webp", 8, 4, "WEBP"},
    {"tiff", 0, 4, "II*\0"},
    {"tiff", 0, 4, "MM\0*"},
    {"tiff", 0, 4, "II+\0"},
    {"tiff", 0, 4, "MM\0+"},
    {"openexr", 0, 4, "\x76\x2f\x31\x01"},
};

const char *image_format(const void *bytes, size_t size)
{
    const char *start = bytes;
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        size_t offset = formats[i].offset;
        if (size >= offset + formats[i].size && memcmp(start + offset, formats[i].magic, formats[i].size) == 0) {
            return offset == 0 || memcmp(start, "RIFF", 4) == 0 ? formats[i].name : NULL;
        }
    }
    return NULL;
}
