/* What a process gives up before it touches a stranger's bytes. Used by frond-image, and by the test that tries to get
 * out. */
#ifndef FROND_IMAGE_SANDBOX_H
#define FROND_IMAGE_SANDBOX_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct image_sandbox_def {
    int memory_megabytes; /* address space beyond what is mapped at the call: the libraries of OpenImageIO alone map 440
                           */
    int cpu_seconds;      /* beyond what is used at the call */
    uint64_t file_bytes;  /* how far a file may be written */
};

struct image_sandbox_def image_sandbox_default_def(void); /* 512 MB, 10 s, 512 MB */

/* For good, for every thread: no new privileges, no core dumps, not traceable, dies with its parent, no descriptor
 * above 2, no networks where the kernel permits, limits as above, and a seccomp filter that kills the process for any
 * call beyond reading, writing and seeking what is open, memory, locks, clocks and exit. Returns NULL, or a noun for
 * what could not be given up: do not go on then. Under a sanitizer memory is not limited: its shadow takes terabytes.
 */
const char *image_sandbox_enter(const struct image_sandbox_def *def);

#ifdef __cplusplus
}
#endif

#endif
