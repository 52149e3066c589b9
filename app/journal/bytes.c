#include "bytes.h"

#include <stdlib.h>
#include <string.h>

enum { FIRST_ROOM = 4096, VARINT_MOST = 10 };

void bytes_finish(struct bytes *bytes)
{
    free(bytes->data);
    *bytes = (struct bytes){0};
}

uint8_t *bytes_room(struct bytes *bytes, size_t size)
{
    if (bytes->failed) {
        return NULL;
    }
    if (size > bytes->room - bytes->size) {
        size_t room = bytes->room ? bytes->room : FIRST_ROOM;
        while (room - bytes->size < size && room <= SIZE_MAX / 2) {
            room *= 2;
        }
        uint8_t *data = room - bytes->size < size ? NULL : realloc(bytes->data, room);
        if (!data) {
            bytes->failed = true;
            return NULL;
        }
        bytes->data = data;
        bytes->room = room;
    }
    return bytes->data + bytes->size;
}

void bytes_put(struct bytes *bytes, const void *data, size_t size)
{
    uint8_t *to = size > 0 ? bytes_room(bytes, size) : NULL;
    if (to) {
        memcpy(to, data, size);
        bytes->size += size;
    }
}

void bytes_put_u8(struct bytes *bytes, unsigned value)
{
    bytes_put(bytes, &(uint8_t){(uint8_t)value}, 1);
}

static void put_little(struct bytes *bytes, uint64_t value, int count)
{
    uint8_t little[8];
    for (int i = 0; i < count; i++) {
        little[i] = (uint8_t)(value >> 8 * i);
    }
    bytes_put(bytes, little, (size_t)count);
}

void bytes_put_u16(struct bytes *bytes, unsigned value)
{
    put_little(bytes, value, 2);
}

void bytes_put_u32(struct bytes *bytes, uint32_t value)
{
    put_little(bytes, value, 4);
}

void bytes_put_u64(struct bytes *bytes, uint64_t value)
{
    put_little(bytes, value, 8);
}

void bytes_put_float(struct bytes *bytes, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    bytes_put_u32(bytes, bits);
}

void bytes_put_double(struct bytes *bytes, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    bytes_put_u64(bytes, bits);
}

void bytes_put_varint(struct bytes *bytes, uint64_t value)
{
    while (value >= 0x80) {
        bytes_put_u8(bytes, (unsigned)(value & 0x7f) | 0x80);
        value >>= 7;
    }
    bytes_put_u8(bytes, (unsigned)value);
}

void bytes_put_text(struct bytes *bytes, const char *text)
{
    size_t length = text ? strnlen(text, BYTES_TEXT - 1) : 0;
    bytes_put_u8(bytes, (unsigned)length);
    bytes_put(bytes, text, length);
}

void bytes_set_u32(struct bytes *bytes, size_t at, uint32_t value)
{
    for (size_t i = 0; i < 4 && !bytes->failed; i++) {
        bytes->data[at + i] = (uint8_t)(value >> 8 * i);
    }
}

struct cursor cursor_over(const void *data, size_t size)
{
    const uint8_t *at = data;
    return (struct cursor){at, size > 0 ? at + size : at, false};
}

const uint8_t *cursor_take(struct cursor *cursor, size_t size)
{
    if (cursor->failed || size > (size_t)(cursor->end - cursor->at)) {
        cursor->failed = true;
        return NULL;
    }
    const uint8_t *at = cursor->at;
    cursor->at += size;
    return at;
}

static uint64_t take_little(struct cursor *cursor, int count)
{
    const uint8_t *little = cursor_take(cursor, (size_t)count);
    uint64_t value = 0;
    for (int i = 0; little && i < count; i++) {
        value |= (uint64_t)little[i] << 8 * i;
    }
    return value;
}

unsigned cursor_u8(struct cursor *cursor)
{
    return (unsigned)take_little(cursor, 1);
}

unsigned cursor_u16(struct cursor *cursor)
{
    return (unsigned)take_little(cursor, 2);
}

uint32_t cursor_u32(struct cursor *cursor)
{
    return (uint32_t)take_little(cursor, 4);
}

uint64_t cursor_u64(struct cursor *cursor)
{
    return take_little(cursor, 8);
}

float cursor_float(struct cursor *cursor)
{
    uint32_t bits = cursor_u32(cursor);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

double cursor_double(struct cursor *cursor)
{
    uint64_t bits = cursor_u64(cursor);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

uint64_t cursor_varint(struct cursor *cursor)
{
    uint64_t value = 0;
    for (int i = 0; i < VARINT_MOST; i++) {
        unsigned byte = cursor_u8(cursor);
        if (i == VARINT_MOST - 1 && byte > 1) { /* more than 64 bits */
            break;
        }
        value |= (uint64_t)(byte & 0x7f) << 7 * i;
        if (!(byte & 0x80)) {
            return cursor->failed ? 0 : value;
        }
    }
    cursor->failed = true;
    return 0;
}

int cursor_count(struct cursor *cursor, int most)
{
    uint64_t value = cursor_varint(cursor);
    if (value > (uint64_t)most) {
        cursor->failed = true;
    }
    return cursor->failed ? 0 : (int)value;
}

void cursor_text(struct cursor *cursor, char text[BYTES_TEXT])
{
    size_t length = cursor_u8(cursor);
    const uint8_t *from = cursor_take(cursor, length);
    if (from) {
        memcpy(text, from, length);
    }
    text[from ? length : 0] = '\0';
}

/* Half a byte at a time, from the remainders of half a byte each. */
static uint32_t crc_short(uint32_t crc, const uint8_t *at, size_t size)
{
    static const uint32_t halves[16] = {0x00000000, 0x1db71064, 0x3b6e20c8, 0x26d930ac, 0x76dc4190, 0x6b6b51f4,
                                        0x4db26158, 0x5005713c, 0xedb88320, 0xf00f9344, 0xd6d6a3e8, 0xcb61b38c,
                                        0x9b64c2b0, 0x86d3d2d4, 0xa00ae278, 0xbdbdf21c};
    for (size_t i = 0; i < size; i++) {
        crc ^= at[i];
        crc = crc >> 4 ^ halves[crc & 15];
        crc = crc >> 4 ^ halves[crc & 15];
    }
    return crc;
}

/* Four bytes at a time, with tables that are worth making for much. */
static uint32_t crc_long(uint32_t crc, const uint8_t *at, size_t words)
{
    uint32_t tables[4][256];
    for (unsigned i = 0; i < 256; i++) {
        tables[0][i] = crc_short(0, &(uint8_t){(uint8_t)i}, 1);
    }
    for (unsigned i = 0; i < 256; i++) {
        for (int k = 1; k < 4; k++) {
            tables[k][i] = tables[k - 1][i] >> 8 ^ tables[0][tables[k - 1][i] & 255];
        }
    }
    for (; words > 0; words--, at += 4) {
        crc ^= (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
        crc = tables[3][crc & 255] ^ tables[2][crc >> 8 & 255] ^ tables[1][crc >> 16 & 255] ^ tables[0][crc >> 24];
    }
    return crc;
}

uint32_t bytes_crc(uint32_t crc, const void *data, size_t size)
{
    enum { MUCH = 1 << 15 };
    const uint8_t *at = data;
    crc = ~crc;
    if (size >= MUCH) {
        crc = crc_long(crc, at, size / 4);
        at += size / 4 * 4;
        size %= 4;
    }
    return ~crc_short(crc, at, size);
}

uint64_t bytes_hash(uint64_t hash, const void *data, size_t size)
{
    const uint8_t *at = data;
    for (; size >= 4; at += 4, size -= 4) {
        uint32_t word;
        memcpy(&word, at, sizeof word);
        hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    for (; size > 0; at++, size--) {
        hash = (hash ^ *at) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return hash;
}
