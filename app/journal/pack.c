#include "pack.h"

#include <stdlib.h>
#include <string.h>

#include <zstd.h>

#include "journal_write.h"
#include "pack_planes.h"
#include "upkeep.h"

enum { ZSTD_LEVEL = 1 };

void packer_finish(struct packer *packer)
{
    ground_destroy(packer->fresh);
    free(packer->parted);
    *packer = (struct packer){.fresh = NULL};
}

static bool same_coefficients(const struct coefficients *a, const struct coefficients *b)
{
    bool same = true;
    for (const struct key *key = coefficient_keys; key->name && same; key++) { /* each is a float or an int */
        same = memcmp((const char *)a + key->offset, (const char *)b + key->offset, sizeof(uint32_t)) == 0;
    }
    return same;
}

/* The ground as the definition makes it; its noise takes time, so it is kept. */
static bool fit(struct packer *packer, const struct checkpoint *checkpoint)
{
    const struct painting_def *def = &checkpoint->def;
    size_t room = (size_t)checkpoint->width * (size_t)checkpoint->height * sizeof(float);
    const struct painting_def *old = packer->fresh ? &packer->fresh->def : NULL;
    if (!old || old->width != def->width || old->height != def->height || old->margin != def->margin ||
        old->seed != def->seed || !same_coefficients(&old->coefficients, &def->coefficients)) {
        ground_destroy(packer->fresh);
        packer->fresh = ground_create(def);
    }
    if (packer->parted_room < room) {
        free(packer->parted);
        packer->parted = malloc(room);
        packer->parted_room = packer->parted ? room : 0;
    }
    return packer->fresh && packer->parted;
}

static void put_head(struct bytes *out, const struct checkpoint *checkpoint, const struct pack_note *note)
{
    struct journal_sheet sheet = note->sheet;
    sheet.def = checkpoint->def;
    bytes_put(out, pack_magic, PACK_MAGIC);
    bytes_put_u16(out, PACK_MAJOR);
    bytes_put_u16(out, PACK_MINOR);
    bytes_put_u32(out, 0);
    size_t from = out->size;
    journal_put_sheet(out, &sheet);
    bytes_put_u64(out, (uint64_t)checkpoint->tick);
    bytes_put_double(out, checkpoint->evaporated);
    bytes_put_double(out, checkpoint->ink_dried);
    bytes_put_u32(out, (uint32_t)checkpoint->quiet_periods);
    bytes_put_u64(out, (uint64_t)checkpoint->carved);
    bytes_put_u64(out, note->generation);
    bytes_put_u64(out, note->number);
    bytes_put_u64(out, (uint64_t)note->ticked);
    bytes_put_u64(out, note->records);
    bytes_put_u64(out, note->written);
    bytes_put_u32(out, note->crc);
    bytes_put_u64(out, note->exhibit_hash);
    bytes_put_u8(out, PACK_PLANES);
    bytes_set_u32(out, from - 4, (uint32_t)(out->size - from));
}

/* A plane: its length, the frame, the CRC over all before it. */
static void put_plane(struct packer *packer, struct bytes *out, size_t size, uint32_t *crc)
{
    size_t from = out->size, most = ZSTD_compressBound(size);
    bytes_put_u32(out, 0);
    uint8_t *to = bytes_room(out, most);
    size_t packed = to ? ZSTD_compress(to, most, packer->parted, size, ZSTD_LEVEL) : 0;
    if (!to || ZSTD_isError(packed)) {
        out->failed = true;
        return;
    }
    out->size += packed;
    bytes_set_u32(out, from, (uint32_t)packed);
    *crc = bytes_crc(*crc, out->data + from, out->size - from);
    bytes_put_u32(out, *crc);
}

bool checkpoint_pack(struct packer *packer, const struct checkpoint *checkpoint, const struct pack_note *note,
                     struct bytes *out, uint64_t *hash)
{
    size_t from = out->size;
    int quiet = checkpoint->quiet_periods < STILL_PERIODS ? checkpoint->quiet_periods : STILL_PERIODS;
    const uint64_t counters[] = {(uint64_t)quiet, (uint64_t)checkpoint->carved};
    if (!fit(packer, checkpoint)) {
        return false;
    }
    put_head(out, checkpoint, note);
    if (out->failed) {
        return false;
    }
    uint32_t crc = bytes_crc(0, out->data + from, out->size - from);
    bytes_put_u32(out, crc);
    *hash = bytes_hash(note->generation, counters, sizeof counters);
    for (int plane = 0; plane < PACK_PLANES && !out->failed; plane++) {
        size_t size = pack_part(checkpoint, packer->fresh, plane, packer->parted);
        *hash = bytes_hash(*hash, packer->parted, size);
        put_plane(packer, out, size, &crc);
    }
    return !out->failed;
}
