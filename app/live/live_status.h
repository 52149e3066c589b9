/* What the staff is told of a running kiosk: lines of "name\tvalue\n". */
#ifndef FROND_LIVE_STATUS_H
#define FROND_LIVE_STATUS_H

#include <stddef.h>

#include "display.h"
#include "gallery.h"
#include "live_care.h"
#include "live_input.h"
#include "studio.h"

struct live_status_def {
    struct display *display;
    struct studio *studio;
    const struct live_input *input;
    struct live_care *care;
    struct gallery *gallery; /* NULL: nothing is kept */
    const char *engine;      /* as engine_choice says it */
    const char *kind;        /* "cpu", "gpu" */
};

/* Fills `lines`, cut at `size`. */
void live_status(const struct live_status_def *def, char *lines, size_t size);

#endif
