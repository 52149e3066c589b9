/* A few texts in one file, .tar.gz (POSIX ustar in gzip), with neither owners nor times. */
#ifndef FROND_BUNDLE_H
#define FROND_BUNDLE_H

#include <stdbool.h>
#include <stddef.h>

#include "file.h"

struct bundle;

struct bundle *bundle_create(void);         /* NULL when memory is short */
void bundle_destroy(struct bundle *bundle); /* takes NULL */
/* `name`: 1 to 99 bytes, no folder above it ("frond-report/status.json"). False when memory is short, or the name is
 * none. */
bool bundle_add(struct bundle *bundle, const char *name, const char *data, size_t size);
/* As file_write_atomic. */
bool bundle_write(struct bundle *bundle, const char *path, struct file_error *error);

#endif
