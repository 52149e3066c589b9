/* The files of a kept painting: journal-0000000007.frond, sheet-0000000007-0000000042.frond. The first number is the
 * generation, which counts sheets, the second counts checkpoints. */
#ifndef FROND_KEEP_FILES_H
#define FROND_KEEP_FILES_H

#include <stdbool.h>
#include <stdint.h>

#include "file.h"

enum { KEEP_PATH = 4096, KEEP_FILES = 64 };

struct keep_file {
    bool journal;
    uint64_t generation, number; /* number 0: of a journal */
};

struct keep_files {
    struct keep_file files[KEEP_FILES]; /* newest first: by generation, then by number, the journal last */
    int count;
};

/* What lies in the folder; none where there is none. More than KEEP_FILES are not looked at. */
struct keep_files keep_files_list(const char *folder);
/* Its path. False where it is too long. */
bool keep_files_path(const char *folder, const struct keep_file *file, char path[KEEP_PATH]);
/* Removes those of the folder that are older than: another generation, or checkpoints with a number under `least`. Also
 * what a write that was cut short has left. `least` UINT64_MAX: all checkpoints; `generation` UINT64_MAX: everything.
 */
void keep_files_remove(const struct file_calls *calls, const char *folder, uint64_t generation, uint64_t least);

#endif
