/* Journals in files. */
#ifndef FROND_JOURNAL_FILE_H
#define FROND_JOURNAL_FILE_H

#include "bytes.h"
#include "file.h"

enum { JOURNAL_FILE_MOST = 512 << 20 }; /* bytes of a file that is read */

/* All bytes of a file, at most `most`. False with the reason in `error`. */
bool journal_file_read(const char *path, size_t most, struct bytes *bytes, struct file_error *error);

#endif
