/* Widths of vectors that kernels are compiled for; every width gives the same bits. */
#ifndef FROND_VECTORS_H
#define FROND_VECTORS_H

enum vectors {
    VECTORS_BEST,   /* the widest that this machine has */
    VECTORS_NARROW, /* SSE2 or NEON */
    VECTORS_AVX2,
    VECTORS_AVX512,
};

/* The width to take: what is wanted, or the widest that this machine has where it has not that. Never VECTORS_BEST. */
enum vectors vectors_here(enum vectors wanted);

/* The copy of kernels to take: the address of name_narrow, name_avx2 or name_avx512. */
#if defined(__x86_64__)
#define VECTORS_COPY(name, wanted)                                                                                     \
    (vectors_here(wanted) == VECTORS_AVX512 ? &name##_avx512                                                           \
     : vectors_here(wanted) == VECTORS_AVX2 ? &name##_avx2                                                             \
                                            : &name##_narrow)
#else
#define VECTORS_COPY(name, wanted) ((void)(wanted), &name##_narrow)
#endif

#endif
