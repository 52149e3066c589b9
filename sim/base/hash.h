/* FNV-1a in 64 bits (Fowler, Noll and Vo): a mark by which states are told apart. */
#ifndef FROND_HASH_H
#define FROND_HASH_H

#include <stddef.h>
#include <stdint.h>

#define HASH_START UINT64_C(0xcbf29ce484222325)

/* The hash of what came before, and these bytes. */
static inline uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        hash = (hash ^ ((const uint8_t *)bytes)[i]) * UINT64_C(0x100000001b3);
    }
    return hash;
}

/* And the eight bytes of a number, the lowest first. */
static inline uint64_t hash_number(uint64_t hash, int64_t number)
{
    for (int i = 0; i < 8; i++) {
        hash = (hash ^ ((uint64_t)number >> 8 * i & 0xff)) * UINT64_C(0x100000001b3);
    }
    return hash;
}

#endif
