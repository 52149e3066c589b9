#include "thinning.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "components.h"

enum { FIRST_PASS = 1, SECOND_PASS = 2, CORNER = 4, SIMPLE = 8 }; /* when a cell with such neighbours may go */

struct thin {
    int width, height; /* of the padded sheet: one cell of ground all around */
    ptrdiff_t offsets[8];
    uint8_t *shape;  /* 1: shape */
    uint8_t *listed; /* 1: stands in `border` */
    size_t *border;  /* shape cells beside ground, the only ones that may go */
    size_t *going;
    size_t borders;
    uint8_t rules[256];
};

/* One of the eight neighbours of a cell: 0 east, then clockwise (y down) SE, S, SW, W, NW, N, NE, and east again. */
static int bit(unsigned neighbours, int i)
{
    return (int)(neighbours >> (i & 7)) & 1;
}

/* Simple: one 8-connected object passes through the neighbourhood, and ground touches a side (Yokoi's number is 1). */
static bool simple(unsigned neighbours)
{
    int number = 0;
    for (int i = 0; i < 8; i += 2) {
        int a = !bit(neighbours, i), b = !bit(neighbours, i + 1), c = !bit(neighbours, i + 2);
        number += a - a * b * c;
    }
    return number == 1;
}

/* A1 of Guo and Hall: C(p) = 1, 2 <= N(p) <= 3, and a side that depends on the pass; the second is the first turned
 * half around. */
static uint8_t rule(unsigned neighbours)
{
    int count = 0, even = 0, odd = 0;
    for (int i = 0; i < 8; i++) {
        count += bit(neighbours, i);
    }
    for (int i = 0; i < 8; i += 2) {
        even += bit(neighbours, i) | bit(neighbours, i + 1);
        odd += bit(neighbours, i + 1) | bit(neighbours, i + 2);
    }
    int pairs = even < odd ? even : odd;
    uint8_t rules = 0;
    if (simple(neighbours)) {
        rules |= SIMPLE;
        rules |= count >= 2 ? CORNER : 0;
    }
    if (simple(neighbours) && pairs >= 2 && pairs <= 3) {
        bool first = bit(neighbours, 0) && (bit(neighbours, 6) || bit(neighbours, 7) || !bit(neighbours, 1));
        bool second = bit(neighbours, 4) && (bit(neighbours, 2) || bit(neighbours, 3) || !bit(neighbours, 5));
        rules |= first ? 0 : FIRST_PASS;
        rules |= second ? 0 : SECOND_PASS;
    }
    return rules;
}

static unsigned neighbourhood(const struct thin *thin, size_t cell)
{
    unsigned neighbours = 0;
    for (int i = 0; i < 8; i++) {
        neighbours |= (unsigned)thin->shape[(ptrdiff_t)cell + thin->offsets[i]] << i;
    }
    return neighbours;
}

static void list(struct thin *thin, size_t cell)
{
    if (thin->shape[cell] && !thin->listed[cell]) {
        thin->listed[cell] = 1;
        thin->border[thin->borders++] = cell;
    }
}

static bool thin_create(struct thin *thin, const uint8_t *mask, int width, int height)
{
    *thin = (struct thin){.width = width + 2, .height = height + 2};
    ptrdiff_t w = thin->width;
    const ptrdiff_t offsets[8] = {1, w + 1, w, w - 1, -1, -w - 1, -w, -w + 1};
    memcpy(thin->offsets, offsets, sizeof offsets);
    size_t cells = (size_t)thin->width * (size_t)thin->height;
    thin->shape = calloc(cells, 1);
    thin->listed = calloc(cells, 1);
    thin->border = malloc(cells * sizeof *thin->border);
    thin->going = malloc(cells * sizeof *thin->going);
    if (!thin->shape || !thin->listed || !thin->border || !thin->going) {
        return false;
    }
    for (unsigned i = 0; i < 256; i++) {
        thin->rules[i] = rule(i);
    }
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            thin->shape[(size_t)(y + 1) * (size_t)w + (size_t)x + 1] = mask[(size_t)y * (size_t)width + (size_t)x] != 0;
        }
    }
    for (size_t cell = (size_t)w; cell < cells - (size_t)w; cell++) {
        if (thin->shape[cell] && neighbourhood(thin, cell) != 255) {
            list(thin, cell);
        }
    }
    return true;
}

static void thin_destroy(struct thin *thin)
{
    free(thin->shape);
    free(thin->listed);
    free(thin->border);
    free(thin->going);
    *thin = (struct thin){0};
}

/* One pass: all cells that the rule lets go are found first, then go one by one while they are still simple. Returns
 * how many went. */
static size_t thin_pass(struct thin *thin, uint8_t pass)
{
    size_t going = 0, gone = 0, kept = 0;
    for (size_t i = 0; i < thin->borders; i++) {
        if (thin->rules[neighbourhood(thin, thin->border[i])] & pass) {
            thin->going[going++] = thin->border[i];
        }
    }
    uint8_t still = pass == CORNER ? CORNER : SIMPLE;
    for (size_t i = 0; i < going; i++) {
        if (thin->rules[neighbourhood(thin, thin->going[i])] & still) {
            thin->shape[thin->going[i]] = 0;
            thin->going[gone++] = thin->going[i];
        }
    }
    for (size_t i = 0; i < thin->borders; i++) {
        if (thin->shape[thin->border[i]]) {
            thin->border[kept++] = thin->border[i];
        }
    }
    thin->borders = kept;
    for (size_t i = 0; i < gone; i++) {
        for (int j = 0; j < 8; j++) {
            list(thin, (size_t)((ptrdiff_t)thin->going[i] + thin->offsets[j]));
        }
    }
    return gone;
}

bool thinning(uint8_t *mask, int width, int height)
{
    struct thin thin;
    bool done = thin_create(&thin, mask, width, height);
    if (done) {
        size_t gone = 1;
        while (gone > 0) {
            gone = thin_pass(&thin, FIRST_PASS);
            gone += thin_pass(&thin, SECOND_PASS);
        }
        while (thin_pass(&thin, CORNER) > 0) {
        }
        for (int y = 0; y < height; y++) {
            memcpy(mask + (size_t)y * (size_t)width, thin.shape + (size_t)(y + 1) * (size_t)thin.width + 1,
                   (size_t)width);
        }
    }
    thin_destroy(&thin);
    return done;
}

static int neighbours_of(const uint8_t *mask, int width, int height, int x, int y)
{
    int count = -1; /* itself */
    for (int v = y > 0 ? y - 1 : 0; v <= y + 1 && v < height; v++) {
        for (int u = x > 0 ? x - 1 : 0; u <= x + 1 && u < width; u++) {
            count += mask[(size_t)v * (size_t)width + (size_t)u] != 0;
        }
    }
    return count;
}

bool skeleton_count(const uint8_t *mask, int width, int height, struct skeleton *skeleton)
{
    size_t cells = (size_t)width * (size_t)height;
    uint8_t *crossings = calloc(cells, 1);
    int32_t *labels = malloc(cells * sizeof *labels);
    bool done = crossings && labels;
    *skeleton = (struct skeleton){0};
    for (int y = 0; done && y < height; y++) {
        for (int x = 0; x < width; x++) {
            size_t i = (size_t)y * (size_t)width + (size_t)x;
            if (!mask[i]) {
                continue;
            }
            int neighbours = neighbours_of(mask, width, height, x, y);
            skeleton->cells++;
            skeleton->tips += neighbours == 1;
            crossings[i] = neighbours >= 3;
        }
    }
    if (done) {
        skeleton->junctions = components_label(crossings, width, height, labels);
        done = skeleton->junctions >= 0;
    }
    free(labels);
    free(crossings);
    return done;
}
