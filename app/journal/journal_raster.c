#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <zstd.h>

#include "journal.h"
#include "journal_read.h"
#include "journal_value.h"

enum { CHANNELS_MOST = 2, SIDE_MOST = 1 << 16 };

static bool join_bytes(const uint8_t *parted, size_t count, float *values)
{
    bool finite = true;
    for (size_t i = 0; i < count; i++) {
        uint32_t bits = 0;
        for (size_t byte = 0; byte < 4; byte++) {
            bits |= (uint32_t)parted[byte * count + i] << 8 * byte;
        }
        memcpy(values + i, &bits, sizeof bits);
        finite = finite && isfinite(values[i]);
    }
    return finite;
}

/* What is left of the body, as so many floats. */
static bool read_values(struct cursor *body, unsigned coding, float *values, size_t count)
{
    size_t size = (size_t)(body->end - body->at);
    if (coding == JOURNAL_CODING_PLAIN) {
        bool finite = size >= 4 * count;
        for (size_t i = 0; finite && i < count; i++) {
            values[i] = cursor_float(body);
            finite = isfinite(values[i]);
        }
        return finite;
    }
    if (coding != JOURNAL_CODING_ZSTD || ZSTD_getFrameContentSize(body->at, size) != 4 * count) {
        return false;
    }
    uint8_t *parted = malloc(4 * count);
    bool good =
        parted && ZSTD_decompress(parted, 4 * count, body->at, size) == 4 * count && join_bytes(parted, count, values);
    free(parted);
    return good;
}

static bool keep(struct journal_reader *reader, struct journal_raster raster)
{
    struct journal_raster *rasters =
        realloc(reader->rasters, (size_t)(reader->raster_count + 1) * sizeof *reader->rasters);
    if (!rasters) {
        return false;
    }
    reader->rasters = rasters;
    rasters[reader->raster_count++] = raster;
    return true;
}

void journal_read_raster(struct journal_reader *reader, struct cursor *body)
{
    int number = cursor_count(body, JOURNAL_RASTERS_MAX - 1);
    struct journal_raster raster = {.width = cursor_count(body, SIDE_MOST),
                                    .height = cursor_count(body, SIDE_MOST),
                                    .channels = cursor_count(body, CHANNELS_MOST)};
    unsigned coding = cursor_u8(body);
    size_t count = (size_t)raster.width * (size_t)raster.height * (size_t)raster.channels;
    if (body->failed || number != reader->raster_count || count == 0) {
        journal_torn(reader, "a raster makes no sense");
        return;
    }
    if (count > JOURNAL_RASTER_VALUES_MAX - reader->raster_values) {
        journal_torn(reader, "there are more values in rasters than %d", JOURNAL_RASTER_VALUES_MAX);
        return;
    }
    raster.values = malloc(count * sizeof *raster.values);
    if (!raster.values) {
        journal_torn(reader, "memory is short for a raster");
    } else if (!read_values(body, coding, raster.values, count) || !keep(reader, raster)) {
        free(raster.values);
        journal_torn(reader, "a raster cannot be read");
    } else {
        reader->raster_values += count;
    }
}
