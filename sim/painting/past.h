/* What tiles of a painting were like, each at some moments: a store of a fixed size in which planes that have not
 * changed are shared. A version stands for the tile from its moment until something happens to it. When the store is
 * full the oldest versions that newer ones have succeeded go first. All memory is taken by past_create. */
#ifndef FROND_PAST_H
#define FROND_PAST_H

#include "tile_code.h"

#define PAST_NONE 0xffffffffu

struct past;

/* `bytes`: of all it will ever take; `tiles`: of the sheet. NULL when memory is short or the bytes are too few. */
struct past *past_create(size_t bytes, int tiles);
void past_destroy(struct past *past); /* takes NULL */
/* Everything goes. */
void past_clear(struct past *past);

/* The tile as it is now. `group`: whoever wants to find this version again (past_find_of), 0: nobody. Where nothing is
 * different from the newest version, that one stands. False when the store is full of what cannot go: then nothing is
 * known of the tile's past any more. Moments never go back. */
bool past_keep(struct past *past, int tile, const struct tile_code *code, uint32_t moment, uint32_t group);
/* The newest version that is no younger than `moment`, else the first of all; PAST_NONE: it is not known any more. */
uint32_t past_find(const struct past *past, int tile, uint32_t moment);
/* The version that a group has asked to keep, or PAST_NONE. */
uint32_t past_find_of(const struct past *past, int tile, uint32_t group);
/* The version after this one, or PAST_NONE; the newest of a tile, or PAST_NONE. */
uint32_t past_next(const struct past *past, uint32_t version);
uint32_t past_newest(const struct past *past, int tile);
/* The version before it, or PAST_NONE; the group that has asked for it, or 0. */
uint32_t past_before(const struct past *past, uint32_t version);
uint32_t past_group(const struct past *past, uint32_t version);
uint32_t past_moment(const struct past *past, uint32_t version);
/* One plane (enum tile_plane), or all. */
void past_read_plane(const struct past *past, uint32_t version, int plane, uint16_t to[TILE_CELLS]);
void past_read(const struct past *past, uint32_t version, struct tile_code *code);

/* A version of its own, of no tile, that stays until it is released: as `from` is, with a plane more. PAST_NONE when
 * the store is full of what cannot go. */
uint32_t past_copy(struct past *past, uint32_t from, const uint16_t extra[TILE_CELLS]);
void past_read_extra(const struct past *past, uint32_t version, uint16_t to[TILE_CELLS]);
void past_release(struct past *past, uint32_t version);

/* Lets go of succeeded versions whose successors are older than `moment`. */
void past_age(struct past *past, uint32_t moment);
/* Of what was let go: the moment before which tiles may not be known any more; 0: all is known. */
uint32_t past_horizon(const struct past *past);
size_t past_used(const struct past *past); /* by versions */

#endif
