#include "device_error.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool device_fail(struct device_error *error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(error->text, sizeof error->text, format, arguments);
    va_end(arguments);
    return false;
}

void device_fail_too(struct device_error *error, const struct device_error *other)
{
    size_t used = strlen(error->text);
    snprintf(error->text + used, sizeof error->text - used, "%s%s", used > 0 ? "; " : "", other->text);
}
