/* How long a test waits for what must come: only a thing that hangs takes so long, however slow the machine is. Less
 * than any time limit of CTest (frond_unit, frond_sanitized), so that the test can say what it has waited for. */
#ifndef FROND_PATIENCE_H
#define FROND_PATIENCE_H

#ifdef SANITIZED_THREAD
enum { SLOWER = 12 };
#elif defined SANITIZED
enum { SLOWER = 4 };
#else
enum { SLOWER = 1 };
#endif
enum { PATIENCE_S = 60 * SLOWER, PATIENCE_MS = 1000 * PATIENCE_S };

#endif
