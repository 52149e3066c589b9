/* What sources have in common about devices: whom a definition means, what they call themselves, why they cannot be
 * opened. Private to the sources. */
#ifndef FROND_SOURCE_DEVICE_H
#define FROND_SOURCE_DEVICE_H

#include <stddef.h>

#include "source.h"

bool device_matches(const struct device_match *match, uint16_t vendor, uint16_t product, const char *name);

/* What a terminal might obey becomes '?', in UTF-8: whoever makes a device chooses its name. */
void device_clean_text(char *text);
/* As much as fits, clean; `from` NULL: nothing. */
void device_copy_text(char *to, size_t size, const char *from);

/* Why opening the node failed with `code`, and how to mend that: the group that may, or where there is none the udev
 * rule that would make one. */
void device_explain(char *text, size_t size, const char *path, int code, const char *rule);

#endif
