/* The planes of a packed checkpoint, each as bytes that compress well. */
#ifndef FROND_PACK_PLANES_H
#define FROND_PACK_PLANES_H

#include "checkpoint.h"

enum {
    PACK_MAGIC = 8,
    PACK_GROUND = CHECKPOINT_PLANES, /* the first plane of the ground: MAPS maps, then */
    PACK_STAMPED = PACK_GROUND + MAPS,
    PACK_WEIGHT,
    PACK_GUIDE,
    PACK_OBSTACLE = PACK_GUIDE + 2,
    PACK_PLANES,
};

extern const uint8_t pack_magic[PACK_MAGIC];

/* Bytes of a plane. */
size_t pack_size(const struct checkpoint *checkpoint, int plane);
/* A plane as bytes, `pack_size` of them, which it returns. Floats as the difference of their bits from what the
 * neighbours to the left and above let expect, folded so that small ones are small, then the lowest byte of all, the
 * next of all, ...; the ground as what differs from `fresh`, in the same order. */
size_t pack_part(const struct checkpoint *checkpoint, const struct ground *fresh, int plane, uint8_t *parted);
/* The way back, into a checkpoint whose ground is as fresh as `fresh` was. False: a value that no painting has. */
bool pack_join(const struct checkpoint *checkpoint, int plane, const uint8_t *parted);

#endif
