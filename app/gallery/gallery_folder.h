/* The gallery's folder: which files are the gallery's, how they are called, and which go first. A kept painting is up
 * to three files that differ in their ending only. */
#ifndef FROND_GALLERY_FOLDER_H
#define FROND_GALLERY_FOLDER_H

#include <stdbool.h>
#include <stdint.h>

#include "file.h"

enum gallery_part { GALLERY_PNG, GALLERY_SVG, GALLERY_JOURNAL, GALLERY_PARTS };

enum {
    GALLERY_NAME = 64,                /* bytes of a file's name, with the final NUL */
    GALLERY_NUMBER_MAX = 999999999,   /* nobody paints so many */
    GALLERY_CLOCK_LEAST = 1735689600, /* 2025-01-01: a clock that shows less was never set */
};

struct gallery_entry {
    int64_t number;
    char stem[GALLERY_NAME]; /* the name without its ending */
    unsigned parts;          /* 1 << enum gallery_part */
    int64_t bytes;           /* of all its parts */
};

/* What is in the folder, oldest first. Zeroed: nothing. */
struct gallery_shelf {
    struct gallery_entry *entries;
    int count, size;
    int64_t bytes; /* of all entries */
};

extern const char *const gallery_endings[GALLERY_PARTS]; /* ".png" */

/* Whether a file of this name is the gallery's: frond-NUMBER[-YYYYMMDD-HHMMSS].ENDING, six to nine digits. */
bool gallery_parse(const char *name, struct gallery_entry *entry);
/* The name of a new entry, without an ending; the local time of `unix_s` stands in it if the clock was set. */
void gallery_stem(int64_t number, int64_t unix_s, char stem[GALLERY_NAME]);

/* Looks at the folder anew. False with the error, and nothing on the shelf, when it cannot be read. */
bool gallery_scan(const char *folder, struct gallery_shelf *shelf, struct file_error *error);
void gallery_shelf_finish(struct gallery_shelf *shelf);
/* Pictures on the shelf: entries that have one. */
int gallery_shelf_pictures(const struct gallery_shelf *shelf);
/* Removes the files of an entry; none of them need be there. */
bool gallery_remove(const char *folder, const char *stem, struct file_error *error);
/* Removes the oldest entries until there are at most so many, of so many bytes; the shelf is as it is then. */
bool gallery_trim(const char *folder, struct gallery_shelf *shelf, int entries, int64_t bytes,
                  struct file_error *error);
/* Removes what a writer that was killed has left behind (file_write_atomic's temporaries). For the only writer. */
void gallery_sweep(const char *folder);

#endif
