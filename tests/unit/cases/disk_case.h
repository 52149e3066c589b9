/* A disk of its own for a test: small, and it can be filled and made read-only. */
#ifndef FROND_DISK_CASE_H
#define FROND_DISK_CASE_H

#include <stdbool.h>

/* A namespace of mounts for this process, which must have one thread only. False where that is not permitted. */
bool disk_case_isolate(void);
/* Mounts memory of `kilobytes` on an empty folder. */
bool disk_case_mount(const char *folder, int kilobytes);
bool disk_case_read_only(const char *folder, bool read_only);
void disk_case_unmount(const char *folder);

#endif
