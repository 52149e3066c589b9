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
    bool reloaded;               /* its programs or inks are others: to be made or shaded again */
    bool other;
    bool hold;     /* what is shown is to be held before another is */
    double held_s; /* when a picture was held, to be faded out; 0: none is */
};

void live_picture_init(struct live_picture *picture, const struct script *script, bool xray,
                       const struct shader_folder *folder);
/* In the context in which it was drawn, lost or not. */
void live_picture_finish(struct live_picture *picture);
/* Draws the fields into the display's framebuffer. `fresh`: they are others than the last time. */
bool live_picture_draw(struct live_picture *picture, struct display *display, const struct fields *fields, bool fresh,
                       struct shader_error *error);
/* Another script's inks from the next picture on. */
void live_picture_change(struct live_picture *picture, const struct script *script);
/* The last picture, without what lies over it: width * height * 3 bytes of sRGB from the top left, the caller's to
 * free. NULL: there is none, or memory is short. Waits for the GPU. */
uint8_t *live_picture_capture(const struct live_picture *picture, int *width, int *height);
/* What is shown fades out over what comes: another sheet is no blow to the eye. */
void live_picture_hold(struct live_picture *picture);
/* Whether something fades: worth a frame. */
bool live_picture_fades(const struct live_picture *picture);
/* Makes the programs again when the sources in the folder have changed; says what is wrong with them. */
void live_picture_reload(struct live_picture *picture);

#endif
