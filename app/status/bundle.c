#include "bundle.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <zlib.h>

enum { BLOCK = 512, NAME = 100, END_BLOCKS = 2, GZIP = 16 + MAX_WBITS, MEMORY = 8 };

struct bundle {
    unsigned char *bytes;
    size_t size, capacity;
};

struct bundle *bundle_create(void)
{
    return calloc(1, sizeof(struct bundle));
}

void bundle_destroy(struct bundle *bundle)
{
    if (bundle) {
        free(bundle->bytes);
    }
    free(bundle);
}

/* Room for whole blocks, all zero; NULL when memory is short. */
static unsigned char *grow(struct bundle *bundle, size_t size)
{
    size_t blocks = (size + BLOCK - 1) / BLOCK * BLOCK;
    if (bundle->size + blocks > bundle->capacity) {
        size_t capacity = 2 * (bundle->size + blocks);
        unsigned char *bytes = realloc(bundle->bytes, capacity);
        if (!bytes) {
            return NULL;
        }
        bundle->bytes = bytes;
        bundle->capacity = capacity;
    }
    unsigned char *at = bundle->bytes + bundle->size;
    memset(at, 0, blocks);
    bundle->size += blocks;
    return at;
}

/* pax(1), "ustar Interchange Format"; what is left at zero is not known. */
struct header {
    char name[NAME], mode[8], uid[8], gid[8], size[12], mtime[12], checksum[8], type, link[NAME], magic[6], version[2];
    char rest[BLOCK - 265];
};

_Static_assert(sizeof(struct header) == BLOCK, "a header is a block");

static void fill_header(unsigned char *block, const char *name, size_t size)
{
    struct header header = {.mode = "0000644", .uid = "0000000", .gid = "0000000", .mtime = "00000000000", .type = '0'};
    unsigned sum = 0;
    snprintf(header.name, sizeof header.name, "%s", name);
    snprintf(header.size, sizeof header.size, "%011zo", size);
    memcpy(header.magic, "ustar", sizeof header.magic);
    memcpy(header.version, "00", sizeof header.version);
    memset(header.checksum, ' ', sizeof header.checksum);
    memcpy(block, &header, BLOCK);
    for (int i = 0; i < BLOCK; i++) {
        sum += block[i];
    }
    snprintf(header.checksum, sizeof header.checksum, "%06o", sum & 0777777u);
    memcpy(block, &header, BLOCK);
    block[offsetof(struct header, checksum) + sizeof header.checksum - 1] = ' ';
}

bool bundle_add(struct bundle *bundle, const char *name, const char *data, size_t size)
{
    size_t length = strlen(name);
    unsigned char *block = length > 0 && length < NAME && name[0] != '/' ? grow(bundle, BLOCK) : NULL;
    if (!block) {
        return false;
    }
    fill_header(block, name, size);
    unsigned char *at = grow(bundle, size);
    if (at && size > 0) {
        memcpy(at, data, size);
    }
    return at;
}

bool bundle_write(struct bundle *bundle, const char *path, struct file_error *error)
{
    z_stream stream = {.zalloc = NULL};
    bool good = grow(bundle, (size_t)END_BLOCKS * BLOCK) &&
                deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, GZIP, MEMORY, Z_DEFAULT_STRATEGY) == Z_OK;
    if (!good) {
        return file_fail(error, path, "memory is short");
    }
    size_t room = deflateBound(&stream, bundle->size);
    unsigned char *packed = malloc(room);
    stream.next_in = bundle->bytes;
    stream.avail_in = (uInt)bundle->size;
    stream.next_out = packed;
    stream.avail_out = (uInt)room;
    good = packed && deflate(&stream, Z_FINISH) == Z_STREAM_END;
    good = good ? file_write_atomic(path, packed, stream.total_out, error) : file_fail(error, path, "memory is short");
    deflateEnd(&stream);
    free(packed);
    return good;
}
