/* How much longer what a test waits for takes where a sanitizer looks on: a factor of its limits. */
#ifndef FROND_PATIENCE_H
#define FROND_PATIENCE_H

#ifdef SANITIZED_THREAD
enum { SLOWER = 12 };
#elif defined SANITIZED
enum { SLOWER = 4 };
#else
enum { SLOWER = 1 };
#endif

#endif
