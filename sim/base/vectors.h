/* The copies of a kernel (lanes.h), and the choice among them at run time. Whatever is chosen, the bits are the same.
 */
#ifndef FROND_VECTORS_H
#define FROND_VECTORS_H

#include <stdbool.h>

enum vectors {
    VECTORS_BEST,   /* the widest that this machine has */
    VECTORS_NARROW, /* SSE2 or NEON */
    VECTORS_AVX2,
    VECTORS_AVX512,
};

/* What is had of a wish: where the machine has not so wide ones, the widest it has; never VECTORS_BEST. */
static inline enum vectors vectors_had(enum vectors wish)
{
#if defined(__x86_64__)
    bool widest = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                  __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq");
    if (widest && (wish == VECTORS_BEST || wish == VECTORS_AVX512)) {
        return VECTORS_AVX512;
    }
    if (__builtin_cpu_supports("avx2") && wish != VECTORS_NARROW) {
        return VECTORS_AVX2;
    }
#endif
    (void)wish;
    return VECTORS_NARROW;
}

/* The copy of `name` that is had: the address of name_narrow, name_avx2 or name_avx512. */
#if defined(__x86_64__)
#define VECTORS_COPY(name, wish)                                                                                       \
    (vectors_had(wish) == VECTORS_AVX512 ? &name##_avx512                                                              \
     : vectors_had(wish) == VECTORS_AVX2 ? &name##_avx2                                                                \
                                         : &name##_narrow)
#else
#define VECTORS_COPY(name, wish) ((void)(wish), &name##_narrow)
#endif

#endif
