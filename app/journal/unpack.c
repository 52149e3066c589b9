#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <zstd.h>

#include "journal_read.h"
#include "pack.h"
#include "pack_planes.h"

/* What stands before the planes. */
struct head {
    int64_t tick, carved;
    double evaporated, ink_dried;
    int quiet_periods, planes;
    uint32_t crc;
};

static bool refuse(struct journal_error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));
static bool refuse(struct journal_error *error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(error->text, sizeof error->text, format, arguments);
    va_end(arguments);
    return false;
}

static void read_note(struct cursor *body, struct head *head, struct pack_note *note)
{
    head->tick = (int64_t)cursor_u64(body);
    head->evaporated = cursor_double(body);
    head->ink_dried = cursor_double(body);
    head->quiet_periods = (int)(int32_t)cursor_u32(body);
    head->carved = (int64_t)cursor_u64(body);
    note->generation = cursor_u64(body);
    note->number = cursor_u64(body);
    note->ticked = (int64_t)cursor_u64(body);
    note->records = cursor_u64(body);
    note->written = cursor_u64(body);
    note->crc = cursor_u32(body);
    note->exhibit_hash = cursor_u64(body);
    head->planes = (int)cursor_u8(body);
}

static bool read_head(struct cursor *file, struct head *head, struct pack_note *note, struct journal_error *error)
{
    const uint8_t *from = file->at, *magic = cursor_take(file, PACK_MAGIC);
    int skipped = 0;
    *note = (struct pack_note){.ticked = 0};
    if (!magic || memcmp(magic, pack_magic, PACK_MAGIC) != 0) {
        return refuse(error, "it is no painting of Frond");
    }
    int major = (int)cursor_u16(file), minor = (int)cursor_u16(file);
    if (!file->failed && major != PACK_MAJOR) {
        return refuse(error, "the painting is of version %d.%d; this Frond (%s) reads version %d", major, minor,
                      FROND_VERSION, PACK_MAJOR);
    }
    size_t size = cursor_u32(file);
    const uint8_t *data = cursor_take(file, size);
    size_t whole = (size_t)(file->at - from);
    uint32_t crc = cursor_u32(file);
    if (file->failed || bytes_crc(0, from, whole) != crc) {
        return refuse(error, "the head of the painting is broken");
    }
    struct cursor body = cursor_over(data, size);
    bool good = journal_read_sheet(&body, &note->sheet, &skipped);
    read_note(&body, head, note);
    head->crc = crc;
    if (!good || body.failed || skipped > 0 || head->planes != PACK_PLANES || head->tick < 0 || note->ticked < 0 ||
        !isfinite(head->evaporated) || !isfinite(head->ink_dried)) {
        return refuse(error, "the head of the painting makes no sense");
    }
    return true;
}

static bool read_plane(struct cursor *file, const struct checkpoint *checkpoint, int plane, uint8_t *parted,
                       uint32_t *crc)
{
    const uint8_t *from = file->at;
    size_t packed = cursor_u32(file), size = pack_size(checkpoint, plane);
    const uint8_t *frame = cursor_take(file, packed);
    uint32_t expected = cursor_u32(file);
    if (file->failed) {
        return false;
    }
    *crc = bytes_crc(*crc, from, 4 + packed);
    return *crc == expected && ZSTD_getFrameContentSize(frame, packed) == size &&
           ZSTD_decompress(parted, size, frame, packed) == size && pack_join(checkpoint, plane, parted);
}

bool checkpoint_peek(const void *data, size_t size, struct pack_note *note, struct journal_error *error)
{
    struct cursor file = cursor_over(data, size);
    struct head head = {.planes = 0};
    return read_head(&file, &head, note, error);
}

bool checkpoint_unpack(const void *data, size_t size, struct checkpoint *checkpoint, struct pack_note *note,
                       struct journal_error *error)
{
    struct cursor file = cursor_over(data, size);
    struct head head = {.planes = 0};
    *checkpoint = (struct checkpoint){.planes = NULL};
    if (!read_head(&file, &head, note, error)) {
        return false;
    }
    uint8_t *parted = NULL;
    if (checkpoint_init(checkpoint, &note->sheet.def)) {
        parted = malloc(pack_size(checkpoint, 0));
    }
    if (!parted) {
        checkpoint_finish(checkpoint);
        return refuse(error, "memory is short for the painting");
    }
    checkpoint->tick = head.tick;
    checkpoint->evaporated = head.evaporated;
    checkpoint->ink_dried = head.ink_dried;
    checkpoint->quiet_periods = head.quiet_periods;
    checkpoint->carved = head.carved;
    int plane = 0;
    while (plane < PACK_PLANES && read_plane(&file, checkpoint, plane, parted, &head.crc)) {
        plane++;
    }
    free(parted);
    if (plane < PACK_PLANES || file.at != file.end) {
        checkpoint_finish(checkpoint);
        return refuse(error, "the painting is broken after %d of %d parts", plane, PACK_PLANES);
    }
    return true;
}
