/* Why a source, a display or a broker cannot be had. */
#ifndef FROND_DEVICE_ERROR_H
#define FROND_DEVICE_ERROR_H

#include <stdbool.h>

enum { DEVICE_ERROR_TEXT = 300 }; /* bytes, with the final NUL */

struct device_error {
    char text[DEVICE_ERROR_TEXT]; /* one line, names the device, connector or file, and what to do about it */
};

/* Writes the line. Always returns false, so that a caller can `return device_fail(...)`. */
bool device_fail(struct device_error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Joins another line to what is there, if anything: "A; B", as far as it fits. */
void device_fail_too(struct device_error *error, const struct device_error *other);

#endif
