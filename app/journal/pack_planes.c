#include "pack_planes.h"

#include <math.h>
#include <string.h>

const uint8_t pack_magic[PACK_MAGIC] = {0x89, 'S', 'H', 'E', 'E', 'T', '\r', '\n'};

static const float VALUE_MOST = 1e9f; /* of any field; a drop is a thousand */

static size_t bytes_of(int plane)
{
    if (plane < PACK_GROUND) {
        return sizeof(float);
    }
    return plane == PACK_WEIGHT || plane == PACK_OBSTACLE ? 1 : 2;
}

size_t pack_size(const struct checkpoint *checkpoint, int plane)
{
    return bytes_of(plane) * (size_t)checkpoint->width * (size_t)checkpoint->height;
}

static uint32_t bits_of(const float *row, int x)
{
    uint32_t bits;
    memcpy(&bits, row + x, sizeof bits);
    return bits;
}

/* Left, above, and the corner between them; 0 beyond the sheet. The same before and after packing. */
static uint32_t expected(const float *row, const float *above, int x)
{
    uint32_t left = x > 0 ? bits_of(row, x - 1) : 0;
    return above ? left + bits_of(above, x) - (x > 0 ? bits_of(above, x - 1) : 0) : left;
}

static uint32_t fold(uint32_t difference)
{
    return difference << 1 ^ (difference >> 31 ? UINT32_MAX : 0);
}

static uint32_t unfold(uint32_t folded)
{
    return folded >> 1 ^ (folded & 1 ? UINT32_MAX : 0);
}

static void part_floats(const struct checkpoint *checkpoint, int plane, uint8_t *parted)
{
    size_t count = (size_t)checkpoint->width * (size_t)checkpoint->height, i = 0;
    const float *row = checkpoint_plane(checkpoint, plane), *above = NULL;
    for (int y = 0; y < checkpoint->height; y++, above = row, row += checkpoint->width) {
        for (int x = 0; x < checkpoint->width; x++, i++) {
            uint32_t folded = fold(bits_of(row, x) - expected(row, above, x));
            parted[i] = (uint8_t)folded;
            parted[count + i] = (uint8_t)(folded >> 8);
            parted[2 * count + i] = (uint8_t)(folded >> 16);
            parted[3 * count + i] = (uint8_t)(folded >> 24);
        }
    }
}

static bool join_floats(const struct checkpoint *checkpoint, int plane, const uint8_t *parted)
{
    size_t count = (size_t)checkpoint->width * (size_t)checkpoint->height, i = 0;
    float *row = checkpoint_plane(checkpoint, plane), *above = NULL;
    bool good = true;
    for (int y = 0; y < checkpoint->height; y++, above = row, row += checkpoint->width) {
        for (int x = 0; x < checkpoint->width; x++, i++) {
            uint32_t folded = (uint32_t)parted[i] | (uint32_t)parted[count + i] << 8 |
                              (uint32_t)parted[2 * count + i] << 16 | (uint32_t)parted[3 * count + i] << 24;
            uint32_t bits = unfold(folded) + expected(row, above, x);
            memcpy(row + x, &bits, sizeof bits);
            good &= fabsf(row[x]) <= VALUE_MOST; /* NaN is not */
        }
    }
    return good;
}

/* A row of the ground, and the bytes of its values. */
static uint8_t *ground_row(const struct ground *ground, int plane, int y)
{
    switch (plane) {
    case PACK_STAMPED:
        return (uint8_t *)ground_stamped(ground, y);
    case PACK_WEIGHT:
        return ground_weight(ground, y);
    case PACK_GUIDE:
    case PACK_GUIDE + 1:
        return (uint8_t *)ground_guide(ground, plane - PACK_GUIDE, y);
    case PACK_OBSTACLE:
        return ground_obstacle(ground, y);
    default:
        return (uint8_t *)ground_map(ground, (enum map)(plane - PACK_GROUND), y);
    }
}

/* A value of one or two bytes of a row. */
static unsigned value_of(const uint8_t *row, size_t size, int x)
{
    uint16_t wide;
    if (size == 1) {
        return row[x];
    }
    memcpy(&wide, row + 2 * (size_t)x, sizeof wide);
    return wide;
}

static void part_ground(const struct checkpoint *checkpoint, const struct ground *fresh, int plane, uint8_t *parted)
{
    size_t count = (size_t)checkpoint->width * (size_t)checkpoint->height, size = bytes_of(plane), i = 0;
    for (int y = 0; y < checkpoint->height; y++) {
        const uint8_t *row = ground_row(checkpoint->ground, plane, y), *base = ground_row(fresh, plane, y);
        for (int x = 0; x < checkpoint->width; x++, i++) {
            unsigned value = value_of(row, size, x) ^ value_of(base, size, x);
            for (size_t byte = 0; byte < size; byte++) {
                parted[byte * count + i] = (uint8_t)(value >> 8 * byte);
            }
        }
    }
}

static void join_ground(const struct checkpoint *checkpoint, int plane, const uint8_t *parted)
{
    size_t count = (size_t)checkpoint->width * (size_t)checkpoint->height, size = bytes_of(plane), i = 0;
    for (int y = 0; y < checkpoint->height; y++) {
        uint8_t *row = ground_row(checkpoint->ground, plane, y);
        for (int x = 0; x < checkpoint->width; x++, i++) {
            unsigned value = value_of(row, size, x);
            for (size_t byte = 0; byte < size; byte++) {
                value ^= (unsigned)parted[byte * count + i] << 8 * byte;
            }
            if (size == 1) {
                row[x] = (uint8_t)value;
            } else {
                memcpy(row + 2 * (size_t)x, &(uint16_t){(uint16_t)value}, 2);
            }
        }
    }
}

size_t pack_part(const struct checkpoint *checkpoint, const struct ground *fresh, int plane, uint8_t *parted)
{
    if (plane < PACK_GROUND) {
        part_floats(checkpoint, plane, parted);
    } else {
        part_ground(checkpoint, fresh, plane, parted);
    }
    return pack_size(checkpoint, plane);
}

bool pack_join(const struct checkpoint *checkpoint, int plane, const uint8_t *parted)
{
    if (plane < PACK_GROUND) {
        return join_floats(checkpoint, plane, parted);
    }
    join_ground(checkpoint, plane, parted);
    return true;
}
