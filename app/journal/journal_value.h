/* How values are written in a journal (FORMAT.md): what its writer and its reader share. */
#ifndef FROND_JOURNAL_VALUE_H
#define FROND_JOURNAL_VALUE_H

#include "bytes.h"
#include "key.h"

enum journal_type {
    JOURNAL_NONE, /* never written: a key whose value means nothing to a journal */
    JOURNAL_FLOAT,
    JOURNAL_WHOLE,
    JOURNAL_FLAG,
    JOURNAL_POINT,
    JOURNAL_NAME,
    JOURNAL_INK,
    JOURNAL_PATH,
    JOURNAL_RASTER_NUMBER,
    JOURNAL_TYPES,
};

enum {
    JOURNAL_MAGIC = 8,
    JOURNAL_START = 12, /* bytes before the first record */
    JOURNAL_PARAMETERS = 32,
    JOURNAL_CODING_PLAIN = 0,
    JOURNAL_CODING_ZSTD = 1,
};

extern const uint8_t journal_magic[JOURNAL_MAGIC];

enum journal_type journal_type_of(enum key_type type);
/* The name that stands for a choice, a brush or a coefficient; "" for none. */
const char *journal_name_of(const struct key *key, int value);
/* The value that a name stands for; false: nobody knows it. */
bool journal_value_of(const struct key *key, const char *name, int *value);

#endif
