/* One painting into the gallery's folder, or not at all. Private to the gallery. */
#ifndef FROND_GALLERY_WRITE_H
#define FROND_GALLERY_WRITE_H

#include "gallery.h"

/* A painting on its way. */
struct gallery_work {
    struct gallery_picture picture; /* journal: not used */
    int journal;                    /* open file, or -1 */
};

void gallery_work_finish(struct gallery_work *work); /* takes zeroed with journal -1 */
/* Writes the journal, the plan and last the picture under this stem. On failure nothing of them is left. */
bool gallery_write(const struct gallery_def *def, const struct gallery_work *work, const char *stem,
                   struct file_error *error);

#endif
