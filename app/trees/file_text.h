/* Bytes of a file that is being made up. */
#ifndef FROND_FILE_TEXT_H
#define FROND_FILE_TEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "file.h"

struct file_text {
    char *bytes;
    size_t size, room;
    bool failed; /* memory was short; what is put then is lost */
};

/* Up to 511 bytes. */
void file_text_put(struct file_text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
void file_text_bytes(struct file_text *text, const void *bytes, size_t size);
/* Writes the file and frees the bytes. */
bool file_text_write(struct file_text *text, const char *path, struct file_error *error);

#endif
