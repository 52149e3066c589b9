#include "past.h"

#include <stdlib.h>
#include <string.h>

enum {
    PLANE_BYTES = TILE_CELLS * (int)sizeof(uint16_t),
    EXTRA = CODE_PLANES, /* the plane more of past_copy */
    SLOTS = CODE_PLANES + 1,
    PLANES_A_VERSION = 6, /* at least, on an average: the others are shared or even */
};
#define IS_BLOCK 0x80000000u /* a slot: a block, or the one value of an even plane */

struct version {
    uint32_t moment, group;
    int32_t tile;            /* -1: of no tile */
    uint32_t older, newer;   /* of the same tile; free versions are a list by `older` */
    uint32_t earlier, later; /* in the line of those that have been succeeded */
    uint32_t slots[SLOTS];
};

struct line {
    uint32_t oldest, newest;
    bool cut; /* something older has been let go */
};

struct past {
    size_t bytes;
    uint32_t block_count, version_count;
    uint16_t (*blocks)[TILE_CELLS];
    uint32_t *holders; /* of each block; of a free one, the next free */
    struct version *versions;
    struct line *tiles;
    int tile_count;
    uint32_t free_block, free_version, free_blocks, free_versions;
    uint32_t first, last; /* of the line of succeeded versions, by when they were */
    uint32_t horizon;
};

struct past *past_create(size_t bytes, int tiles)
{
    struct past *past = calloc(1, sizeof *past);
    size_t fixed = (size_t)tiles * (sizeof(struct line) + sizeof(struct version));
    size_t each = PLANE_BYTES + sizeof(uint32_t) + sizeof(struct version) / PLANES_A_VERSION;
    if (!past || bytes < fixed + 64 * each) {
        free(past);
        return NULL;
    }
    past->bytes = bytes;
    past->tile_count = tiles;
    past->block_count = (uint32_t)((bytes - fixed) / each);
    past->version_count = past->block_count / PLANES_A_VERSION + (uint32_t)tiles;
    past->blocks = calloc(past->block_count, sizeof *past->blocks);
    past->holders = calloc(past->block_count, sizeof *past->holders);
    past->versions = calloc(past->version_count, sizeof *past->versions);
    past->tiles = calloc((size_t)tiles, sizeof *past->tiles);
    if (!past->blocks || !past->holders || !past->versions || !past->tiles) {
        past_destroy(past);
        return NULL;
    }
    past_clear(past);
    return past;
}

void past_destroy(struct past *past)
{
    if (past) {
        free(past->blocks);
        free(past->holders);
        free(past->versions);
        free(past->tiles);
        free(past);
    }
}

void past_clear(struct past *past)
{
    for (uint32_t i = 0; i < past->block_count; i++) {
        past->holders[i] = i + 1 < past->block_count ? i + 1 : PAST_NONE;
    }
    for (uint32_t i = 0; i < past->version_count; i++) {
        past->versions[i].older = i + 1 < past->version_count ? i + 1 : PAST_NONE;
    }
    for (int i = 0; i < past->tile_count; i++) {
        past->tiles[i] = (struct line){PAST_NONE, PAST_NONE, false};
    }
    past->free_block = past->free_version = 0;
    past->free_blocks = past->block_count;
    past->free_versions = past->version_count;
    past->first = past->last = PAST_NONE;
    past->horizon = 0;
}

static void let_go_block(struct past *past, uint32_t slot)
{
    uint32_t block = slot & ~IS_BLOCK;
    if ((slot & IS_BLOCK) && --past->holders[block] == 0) {
        past->holders[block] = past->free_block;
        past->free_block = block;
        past->free_blocks++;
    }
}

static void leave_line(struct past *past, uint32_t index)
{
    struct version *version = &past->versions[index];
    bool stands = version->earlier != PAST_NONE || version->later != PAST_NONE || past->first == index;
    if (!stands) {
        return;
    }
    *(version->earlier == PAST_NONE ? &past->first : &past->versions[version->earlier].later) = version->later;
    *(version->later == PAST_NONE ? &past->last : &past->versions[version->later].earlier) = version->earlier;
    version->earlier = version->later = PAST_NONE;
}

static void join_line(struct past *past, uint32_t index)
{
    struct version *version = &past->versions[index];
    version->earlier = past->last;
    version->later = PAST_NONE;
    *(past->last == PAST_NONE ? &past->first : &past->versions[past->last].later) = index;
    past->last = index;
}

void past_release(struct past *past, uint32_t version)
{
    struct version *gone = &past->versions[version];
    for (int slot = 0; slot < SLOTS; slot++) {
        let_go_block(past, gone->slots[slot]);
    }
    leave_line(past, version);
    if (gone->tile >= 0) {
        struct line *tile = &past->tiles[gone->tile];
        *(gone->older == PAST_NONE ? &tile->oldest : &past->versions[gone->older].newer) = gone->newer;
        *(gone->newer == PAST_NONE ? &tile->newest : &past->versions[gone->newer].older) = gone->older;
        tile->cut = true;
    }
    gone->older = past->free_version;
    past->free_version = version;
    past->free_versions++;
}

static void let_go_first(struct past *past)
{
    uint32_t index = past->first;
    past->horizon = past->versions[past->versions[index].newer].moment;
    past_release(past, index);
}

static bool make_room(struct past *past)
{
    while (past->first != PAST_NONE && (past->free_blocks < SLOTS || past->free_versions == 0)) {
        let_go_first(past);
    }
    return past->free_blocks >= SLOTS && past->free_versions > 0;
}

void past_age(struct past *past, uint32_t moment)
{
    while (past->first != PAST_NONE && past->versions[past->versions[past->first].newer].moment < moment) {
        let_go_first(past);
    }
}

static uint32_t take_version(struct past *past)
{
    uint32_t index = past->free_version;
    past->free_version = past->versions[index].older;
    past->free_versions--;
    past->versions[index] =
        (struct version){.tile = -1, .older = PAST_NONE, .newer = PAST_NONE, .earlier = PAST_NONE, .later = PAST_NONE};
    return index;
}

static bool is_even(const uint16_t plane[TILE_CELLS])
{
    return memcmp(plane, plane + 1, PLANE_BYTES - sizeof plane[0]) == 0;
}

static uint32_t take_slot(struct past *past, const uint16_t plane[TILE_CELLS])
{
    if (is_even(plane)) {
        return plane[0];
    }
    uint32_t block = past->free_block;
    past->free_block = past->holders[block];
    past->free_blocks--;
    past->holders[block] = 1;
    memcpy(past->blocks[block], plane, PLANE_BYTES);
    return block | IS_BLOCK;
}

static bool holds(const struct past *past, uint32_t slot, const uint16_t plane[TILE_CELLS])
{
    return slot & IS_BLOCK ? memcmp(past->blocks[slot & ~IS_BLOCK], plane, PLANE_BYTES) == 0
                           : slot == plane[0] && is_even(plane);
}

static uint32_t share_slot(struct past *past, uint32_t slot)
{
    if (slot & IS_BLOCK) {
        past->holders[slot & ~IS_BLOCK]++;
    }
    return slot;
}

/* Nothing is known of a tile any more. */
static void forget_tile(struct past *past, int tile)
{
    while (past->tiles[tile].newest != PAST_NONE) {
        past_release(past, past->tiles[tile].newest);
    }
    past->tiles[tile].cut = true;
}

/* Whether the newest version of a tile says all. */
static bool is_known(const struct past *past, uint32_t newest, const struct tile_code *code)
{
    bool same = newest != PAST_NONE;
    for (int plane = 0; same && plane < CODE_PLANES; plane++) {
        same = holds(past, past->versions[newest].slots[plane], code->planes[plane]);
    }
    return same;
}

bool past_keep(struct past *past, int tile, const struct tile_code *code, uint32_t moment, uint32_t group)
{
    struct line *line = &past->tiles[tile];
    if (is_known(past, line->newest, code)) {
        struct version *newest = &past->versions[line->newest];
        if (!group || !newest->group) {
            newest->group = group ? group : newest->group;
            return true;
        }
    }
    if (!make_room(past)) {
        forget_tile(past, tile);
        return false;
    }
    uint32_t index = take_version(past), before = line->newest;
    struct version *version = &past->versions[index];
    for (int plane = 0; plane < CODE_PLANES; plane++) {
        bool same = before != PAST_NONE && holds(past, past->versions[before].slots[plane], code->planes[plane]);
        version->slots[plane] =
            same ? share_slot(past, past->versions[before].slots[plane]) : take_slot(past, code->planes[plane]);
    }
    version->moment = moment;
    version->group = group;
    version->tile = tile;
    version->older = before;
    line->newest = index;
    if (before == PAST_NONE) {
        line->oldest = index;
    } else {
        past->versions[before].newer = index;
        join_line(past, before);
    }
    return true;
}

uint32_t past_find(const struct past *past, int tile, uint32_t moment)
{
    uint32_t index = past->tiles[tile].newest;
    while (index != PAST_NONE && past->versions[index].moment > moment) {
        index = past->versions[index].older;
    }
    return index == PAST_NONE && !past->tiles[tile].cut ? past->tiles[tile].oldest : index;
}

uint32_t past_find_of(const struct past *past, int tile, uint32_t group)
{
    uint32_t index = past->tiles[tile].newest;
    while (index != PAST_NONE && past->versions[index].group != group) {
        index = past->versions[index].older;
    }
    return index;
}

uint32_t past_next(const struct past *past, uint32_t version)
{
    return past->versions[version].newer;
}

uint32_t past_newest(const struct past *past, int tile)
{
    return past->tiles[tile].newest;
}

uint32_t past_before(const struct past *past, uint32_t version)
{
    return past->versions[version].older;
}

uint32_t past_group(const struct past *past, uint32_t version)
{
    return past->versions[version].group;
}

uint32_t past_moment(const struct past *past, uint32_t version)
{
    return past->versions[version].moment;
}

void past_read_plane(const struct past *past, uint32_t version, int plane, uint16_t to[TILE_CELLS])
{
    uint32_t slot = past->versions[version].slots[plane];
    if (slot & IS_BLOCK) {
        memcpy(to, past->blocks[slot & ~IS_BLOCK], PLANE_BYTES);
        return;
    }
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        to[cell] = (uint16_t)slot;
    }
}

void past_read(const struct past *past, uint32_t version, struct tile_code *code)
{
    for (int plane = 0; plane < CODE_PLANES; plane++) {
        past_read_plane(past, version, plane, code->planes[plane]);
    }
}

uint32_t past_copy(struct past *past, uint32_t from, const uint16_t extra[TILE_CELLS])
{
    uint32_t slots[SLOTS];
    for (int slot = 0; slot < CODE_PLANES; slot++) { /* held before room is made: `from` itself may go */
        slots[slot] = share_slot(past, past->versions[from].slots[slot]);
    }
    uint32_t moment = past->versions[from].moment;
    if (!make_room(past)) {
        for (int slot = 0; slot < CODE_PLANES; slot++) {
            let_go_block(past, slots[slot]);
        }
        return PAST_NONE;
    }
    uint32_t index = take_version(past);
    slots[EXTRA] = take_slot(past, extra);
    memcpy(past->versions[index].slots, slots, sizeof slots);
    past->versions[index].moment = moment;
    return index;
}

void past_read_extra(const struct past *past, uint32_t version, uint16_t to[TILE_CELLS])
{
    past_read_plane(past, version, EXTRA, to);
}

uint32_t past_horizon(const struct past *past)
{
    return past->horizon;
}

size_t past_used(const struct past *past)
{
    return (size_t)(past->block_count - past->free_blocks) * PLANE_BYTES +
           (size_t)(past->version_count - past->free_versions) * sizeof(struct version);
}
