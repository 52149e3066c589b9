/* Loops that gcc 12 and clang 14 both turn into vectors, in sources that are compiled once for each width of vectors
 * (CMakeLists.txt): conditions folded into floats, no branches, no calls. */
#ifndef FROND_LANES_H
#define FROND_LANES_H

/* LANES: floats in a vector. LANES_NAME(x): the name x has in this copy. */
#if defined(__AVX512F__)
#define LANES         16
#define LANES_NAME(x) x##_avx512
#elif defined(__AVX2__)
#define LANES         8
#define LANES_NAME(x) x##_avx2
#else
#define LANES         4
#define LANES_NAME(x) x##_narrow
#endif

/* Cells of the inner loop: gcc takes loops of four apart before it makes vectors of them. */
#ifndef LANES_BLOCK
#define LANES_BLOCK 16
#endif

/* x from begin to end, both multiples of 16; no iteration depends on another. gcc vectorises a loop of known length
 * inside another, clang a plain one. */
#if defined(__clang__)
#define FOR_CELLS(x, begin, end)                                                                                       \
    _Pragma("clang loop vectorize(assume_safety) interleave(disable)") for (int x = (begin); x < (end); x++)
#else
#define FOR_CELLS(x, begin, end)                                                                                       \
    for (int x##_block = (begin); x##_block < (end); x##_block += LANES_BLOCK)                                         \
    _Pragma("GCC ivdep") for (int x = x##_block; x < x##_block + LANES_BLOCK; x++)
#endif

#endif
