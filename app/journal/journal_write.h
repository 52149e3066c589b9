/* What others write as the journal does. */
#ifndef FROND_JOURNAL_WRITE_H
#define FROND_JOURNAL_WRITE_H

#include "journal.h"

/* The body of a sheet or a scene; journal_read_sheet reads it. */
void journal_put_sheet(struct bytes *out, const struct journal_sheet *sheet);

#endif
