/* The gallery: finished pictures as PNG files in one folder, capped by count and bytes, oldest out first. Writing
 * happens on a thread of its own and never keeps a frame waiting; a disk that is full or read-only costs one line in
 * the log. Names are times and numbers: nothing personal. */
#ifndef FROND_GALLERY_H
#define FROND_GALLERY_H

#include <stdbool.h>
#include <stdint.h>

struct gallery_def {
    const char *folder; /* made if it is not there */
    int pictures;       /* at most */
    int64_t bytes;      /* of all together, at most */
};

struct gallery;

/* NULL when memory is short or the thread cannot be started. A folder that cannot be used is told by gallery_log. */
struct gallery *gallery_create(const struct gallery_def *def);
void gallery_destroy(struct gallery *gallery); /* takes NULL; what is being written is written */
/* Takes the bytes over (malloc; width * height * 3, sRGB from the top left). False, and they are freed, when it is
 * still busy with others. */
bool gallery_keep(struct gallery *gallery, uint8_t *rgb, int width, int height);
bool gallery_log(struct gallery *gallery, char *line, int size);
/* Pictures there now. */
int gallery_count(struct gallery *gallery);

#endif
