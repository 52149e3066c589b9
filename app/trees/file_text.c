#include "file_text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool has_room(struct file_text *text, size_t more)
{
    if (text->size + more > text->room) {
        size_t room = 2 * text->room + more + 65536;
        char *bytes = text->failed ? NULL : realloc(text->bytes, room);
        if (!bytes) {
            text->failed = true;
            return false;
        }
        text->bytes = bytes;
        text->room = room;
    }
    return true;
}

void file_text_put(struct file_text *text, const char *format, ...)
{
    enum { LONGEST = 512 };
    if (has_room(text, LONGEST)) {
        va_list arguments;
        va_start(arguments, format);
        int length = vsnprintf(text->bytes + text->size, LONGEST, format, arguments);
        va_end(arguments);
        text->size += length > 0 ? (size_t)length : 0;
    }
}

void file_text_bytes(struct file_text *text, const void *bytes, size_t size)
{
    if (has_room(text, size)) {
        memcpy(text->bytes + text->size, bytes, size);
        text->size += size;
    }
}

bool file_text_write(struct file_text *text, const char *path, struct file_error *error)
{
    bool good = text->failed ? file_fail(error, path, "memory is short")
                             : file_write_atomic(path, text->bytes, text->size, error);
    free(text->bytes);
    *text = (struct file_text){0};
    return good;
}
