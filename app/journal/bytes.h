/* Bytes in a file's order: a buffer that grows, and a cursor that never reads beyond its end. Numbers are
 * little-endian, floats as their bits; a varint has seven bits a byte, the lowest first, the top bit set in all but the
 * last. */
#ifndef FROND_BYTES_H
#define FROND_BYTES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct bytes {
    uint8_t *data; /* from malloc; owned */
    size_t size, room;
    bool failed; /* memory was short: what was put since is lost */
};

void bytes_finish(struct bytes *bytes);
void bytes_put(struct bytes *bytes, const void *data, size_t size);
void bytes_put_u8(struct bytes *bytes, unsigned value);
void bytes_put_u16(struct bytes *bytes, unsigned value);
void bytes_put_u32(struct bytes *bytes, uint32_t value);
void bytes_put_u64(struct bytes *bytes, uint64_t value);
void bytes_put_float(struct bytes *bytes, float value);
void bytes_put_double(struct bytes *bytes, double value);
void bytes_put_varint(struct bytes *bytes, uint64_t value);
/* A byte of length and the text, cut after 255 bytes. NULL is "". */
void bytes_put_text(struct bytes *bytes, const char *text);
/* Room for this many more at the end, which the caller fills and adds to `size`; NULL: memory is short. */
uint8_t *bytes_room(struct bytes *bytes, size_t size);
/* Overwrites four bytes that are there already. */
void bytes_set_u32(struct bytes *bytes, size_t at, uint32_t value);

enum { BYTES_TEXT = 256 };

struct cursor {
    const uint8_t *at, *end;
    bool failed; /* something was asked for that is not there; everything since reads as 0 */
};

struct cursor cursor_over(const void *data, size_t size);
/* The next bytes, or NULL. */
const uint8_t *cursor_take(struct cursor *cursor, size_t size);
unsigned cursor_u8(struct cursor *cursor);
unsigned cursor_u16(struct cursor *cursor);
uint32_t cursor_u32(struct cursor *cursor);
uint64_t cursor_u64(struct cursor *cursor);
float cursor_float(struct cursor *cursor);
double cursor_double(struct cursor *cursor);
uint64_t cursor_varint(struct cursor *cursor);
/* A varint that must be within 0..most. */
int cursor_count(struct cursor *cursor, int most);
void cursor_text(struct cursor *cursor, char text[BYTES_TEXT]);

/* CRC-32 of IEEE 802.3 (polynomial 0xEDB88320 reflected, all ones before and after), continued from that of the bytes
 * before; 0 to begin. */
uint32_t bytes_crc(uint32_t crc, const void *data, size_t size);
/* A number that tells contents apart: 64 bits, by 32-bit words. Not for enemies. */
uint64_t bytes_hash(uint64_t hash, const void *data, size_t size);

#endif
