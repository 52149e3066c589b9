/* A panel in memory, hung one way or another, on which things are laid over a finished sheet. Every function fails the
 * test with a reason when something cannot be had, or GL reports an error. */
#ifndef FROND_PANEL_CASE_H
#define FROND_PANEL_CASE_H

#include "display.h"

struct panel_case {
    struct display *display; /* headless; its context is current */
    unsigned texture, framebuffer;
    int width, height;             /* of the sheet as it is looked at, pixels */
    int panel_width, panel_height; /* of the framebuffer */
    int rotation;                  /* degrees: 0, 90, 180, 270 */
    bool flipped;                  /* the first row of the framebuffer is the top of the panel */
    float turn[4];                 /* from the sheet's clip coordinates to the panel's */
    uint8_t *bytes;                /* of the framebuffer, RGBA */
};

struct panel_case panel_case_make(int width, int height, int rotation, bool flipped);
void panel_case_finish(struct panel_case *panel);
/* A sheet of width * height * 3 bytes onto the panel, opaque. */
void panel_case_lay(struct panel_case *panel, const uint8_t *rgb);
/* What is on it then, as a sheet; it is opaque still, and nothing blends any more. */
void panel_case_read(struct panel_case *panel, uint8_t *rgb);
/* ", at 90 degrees, flipped" */
const char *panel_case_way(const struct panel_case *panel);

#endif
