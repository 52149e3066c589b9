#include "vectors.h"

#include <stdbool.h>

enum vectors vectors_here(enum vectors wanted)
{
#if defined(__x86_64__)
    bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq");
    if (wide && (wanted == VECTORS_BEST || wanted == VECTORS_AVX512)) {
        return VECTORS_AVX512;
    }
    if (__builtin_cpu_supports("avx2") && wanted != VECTORS_NARROW) {
        return VECTORS_AVX2;
    }
#endif
    (void)wanted;
    return VECTORS_NARROW;
}
