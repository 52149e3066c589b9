/* The gallery: finished pictures as PNG files in one folder, each with its journal and the plan of its branches beside
 * it if given, capped by count and bytes, oldest out first. Writing and reading happen on a thread of its own and never
 * keep a frame waiting; a disk that is full, read-only or failing costs one line in the log, and one more when it works
 * again.
 *
 * Names are numbers and times, nothing personal: frond-000123-20260115-143005.png. The number is one more than the
 * highest there was, so that names sort by the order of keeping whatever a clock does; the local time follows where the
 * clock was set. Files of other names are never touched. Whatever stops in the middle leaves no half of a file. */
#ifndef FROND_GALLERY_H
#define FROND_GALLERY_H

#include <stdbool.h>
#include <stdint.h>

#include "gallery_folder.h"

enum {
    GALLERY_WAITING = 2, /* pictures that wait for the one being written */
    GALLERY_LINE = 320,  /* bytes of a line of the log, with the final NUL */
};

struct gallery_def {
    const char *folder; /* made, with those above it, if it is not there; copied */
    int pictures;       /* at most */
    int64_t bytes;      /* of all together, at most; one picture more while it is written */
    int64_t spare;      /* bytes of the disk that are left to others: with less than that free nothing is kept */
    const char *helper; /* of image_def; copied; NULL: as it says */
};

struct gallery;

/* NULL when memory is short or the thread cannot be started. A folder that cannot be used is told by gallery_log. */
struct gallery *gallery_create(const struct gallery_def *def);
/* Takes NULL. Waits until what was taken to be kept is written. */
void gallery_destroy(struct gallery *gallery);

struct gallery_picture {
    uint8_t *rgb; /* width * height * 3, sRGB from the top left; malloc */
    int width, height;
    int64_t unix_s; /* when it was finished, seconds since 1970 as the clock has it, right or wrong */
    /* The plan of its branches, as SVG: active plus carved pattern, cells_x * cells_y, malloc; NULL: none. */
    float *depth;
    int cells_x, cells_y;
    double paper_mm;     /* width of the plan's sheet; 0: PLAN_PAPER_MM */
    const char *journal; /* file whose bytes, as they are now, are kept beside it; NULL: none */
};

/* Takes rgb and depth over in any case. False, and they are freed, when too many wait: gallery_log tells. The journal
 * is opened before this returns: it may be renamed or removed afterwards, but not written. One that cannot be opened is
 * told by gallery_log; the picture is kept without it. */
bool gallery_keep(struct gallery *gallery, const struct gallery_picture *picture);
/* The next line for the log; false when there is none. */
bool gallery_log(struct gallery *gallery, char line[GALLERY_LINE]);
/* Pictures there, as of the last look, which follows each picture that was kept. */
int gallery_count(struct gallery *gallery);
/* Whether something is being written or read, or waits. */
bool gallery_busy(struct gallery *gallery);

/* Names of the pictures, newest first, at most `most`; the number of them. */
int gallery_list(struct gallery *gallery, char (*names)[GALLERY_NAME], int most);
/* Reads a picture of that list on the gallery's thread, for the slide show; one at a time: a second wish replaces the
 * first, and a name that is not the gallery's is no wish. */
void gallery_want(struct gallery *gallery, const char *name);
/* The picture that was wanted, once: *rgb as in gallery_picture, the caller's (free). NULL in *rgb when it could not be
 * read: it is gone, or broken. False: not yet, or none is wanted. */
bool gallery_got(struct gallery *gallery, uint8_t **rgb, int *width, int *height);

#endif
