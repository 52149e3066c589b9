/* Whether anything that an exhibit is read from has changed: other files in its folder are none of its business. */
#ifndef FROND_EXHIBIT_MARK_H
#define FROND_EXHIBIT_MARK_H

#include <stdint.h>

#include "exhibit.h"

/* A number made of names, times and sizes of the exhibit's file at `path`, its pictures, sessions, guides and masks, as
 * they are on the disk now; the same, the same exhibit. */
uint64_t exhibit_mark(const char *path, const struct exhibit *exhibit);

#endif
