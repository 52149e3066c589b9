/* The inside of the reader of journals: journal_read.c, journal_raster.c; and what others read in the same way. */
#ifndef FROND_JOURNAL_READ_H
#define FROND_JOURNAL_READ_H

#include "journal.h"
#include "journal_value.h"

/* A verb as the journal declares it. */
struct journal_verb {
    bool declared;
    enum action_verb verb; /* ACTION_VERBS: nobody knows it */
    int count;
    uint8_t types[JOURNAL_PARAMETERS];          /* enum journal_type */
    const struct key *keys[JOURNAL_PARAMETERS]; /* NULL: nobody knows it */
};

/* The reading ends here, for this reason; what was said first stays. Returns false. */
bool journal_torn(struct journal_reader *reader, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* The body of a raster. */
void journal_read_raster(struct journal_reader *reader, struct cursor *body);
/* The body of a sheet or a scene. */
bool journal_read_sheet(struct cursor *body, struct journal_sheet *sheet, int *skipped);

#endif
