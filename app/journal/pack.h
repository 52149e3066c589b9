/* A checkpoint as bytes, compressed, every part with its CRC: FORMAT.md. What is unpacked is what was packed, to the
 * bit, or it is refused; nothing in between. Pure: bytes in, bytes out.
 *
 * A fresh sheet costs nearly nothing: its ground is packed as what differs from one made of the same definition. */
#ifndef FROND_PACK_H
#define FROND_PACK_H

#include "checkpoint.h"
#include "journal.h"

enum { PACK_MAJOR = 1, PACK_MINOR = 0 };

/* What belongs to the painting and is not in it. */
struct pack_note {
    struct journal_sheet sheet; /* inks, mode, scene; its def becomes the checkpoint's */
    uint64_t generation;        /* of the sheet: which journal it is of */
    uint64_t number;            /* of the checkpoint */
    int64_t ticked;             /* of the journal, when it was taken */
    uint64_t records, written;  /* of the journal: how many records, and bytes, it holds already */
    uint32_t crc;               /* of those records (struct journal_reader) */
    uint64_t exhibit_hash;
};

/* What packing wants beside the checkpoint, kept from one to the next. */
struct packer {
    struct ground *fresh; /* as the definition of the last checkpoint makes it */
    uint8_t *parted;      /* a plane, its bytes apart */
    size_t parted_room;
};

void packer_finish(struct packer *packer);
/* Appends it to `out`. `hash`: of all of it but the note and the tick: equal hashes, equal paintings. False when memory
 * is short. About 2 ns a byte of the checkpoint. */
bool checkpoint_pack(struct packer *packer, const struct checkpoint *checkpoint, const struct pack_note *note,
                     struct bytes *out, uint64_t *hash);
/* Makes the checkpoint, for the caller to finish. False, with one line in `error` and nothing made, where anything is
 * not as it was packed. */
bool checkpoint_unpack(const void *data, size_t size, struct checkpoint *checkpoint, struct pack_note *note,
                       struct journal_error *error);
/* The note alone, without the planes: whether it is worth while. */
bool checkpoint_peek(const void *data, size_t size, struct pack_note *note, struct journal_error *error);

#endif
