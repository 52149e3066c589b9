/* How long a test waits for what must come: only a thing that hangs takes so long, however slow the machine is. Less
 * than any time limit of CTest (frond_unit, frond_sanitized), so that the test can say what it has waited for. SLOWER:
 * a sanitizer looks on; limits are longer by that factor, and less may be run. */
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
enum { PATIENCE_S = 60 * SLOWER, PATIENCE_MS = 1000 * PATIENCE_S };

/* All cases, not only those in which a sanitizer sees most for its time: tests/run --sanitized. */
static inline bool is_whole(void)
{
    return SLOWER == 1 || getenv("FROND_WHOLE");
}

#endif
