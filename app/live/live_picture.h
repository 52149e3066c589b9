/* The picture of a session on its display: fits itself to the sheet and to the panel as they change. */
#ifndef FROND_LIVE_PICTURE_H
#define FROND_LIVE_PICTURE_H

#include "display.h"
#include "fields.h"
#include "picture.h"
#include "program.h"
#include "script.h"

struct live_picture {
    const struct script *script;
    const struct shader_folder *folder;
    bool xray;
    long long stamp;             /* of the folder when the programs were made */
    struct picture_def def;      /* of the picture as it is */
    struct picture_gpu *picture; /* NULL: not made yet, or the layers are shown */
    struct xray_gpu *layers;     /* NULL: not made yet, or the picture is shown */
    bool reloaded;               /* its programs are others: to be shaded again */
};

void live_picture_init(struct live_picture *picture, const struct script *script, bool xray,
                       const struct shader_folder *folder);
/* In the context in which it was drawn, lost or not. */
void live_picture_finish(struct live_picture *picture);
/* Draws the fields into the display's framebuffer. `fresh`: they are others than the last time. */
bool live_picture_draw(struct live_picture *picture, struct display *display, const struct fields *fields, bool fresh,
                       struct shader_error *error);
/* Makes the programs again when the sources in the folder have changed; says what is wrong with them. */
void live_picture_reload(struct live_picture *picture);

#endif
