/* The width of vectors that a test of threads asks for: a sanitizer sees the narrow kernels alone (sim/CMakeLists.txt).
 */
#ifndef FROND_VECTORS_SEEN_H
#define FROND_VECTORS_SEEN_H

#include "vectors.h"

#ifdef SANITIZED
static const enum vectors VECTORS_SEEN = VECTORS_NARROW;
#else
static const enum vectors VECTORS_SEEN = VECTORS_BEST;
#endif

#endif
