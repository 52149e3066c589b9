/* How much longer what a test waits for takes where a sanitizer looks on: a factor of its limits; and how much of it is
 * run there. */
#ifndef FROND_PATIENCE_H
#define FROND_PATIENCE_H

#include <stdbool.h>
#include <stdlib.h>

#ifdef SANITIZED_THREAD
enum { SLOWER = 12 };
#elif defined SANITIZED
enum { SLOWER = 4 };
#else
enum { SLOWER = 1 };
#endif

/* All cases, not only those in which a sanitizer sees most for its time: tests/run --sanitized. */
static inline bool is_whole(void)
{
    return SLOWER == 1 || getenv("FROND_WHOLE");
}

#endif
