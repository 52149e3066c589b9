/* Pictograms of the palette: drawn as with a brush, so that nobody needs to read. */
#ifndef FROND_HUD_ICON_H
#define FROND_HUD_ICON_H

#include "pen.h"

enum hud_icon {
    ICON_DROP, /* in the order of enum exhibit_tool */
    ICON_BRUSH,
    ICON_GUIDE,
    ICON_POUR,
    ICON_MASK,
    ICON_REWIND,
    ICON_PLANT,
    ICON_TEND,
    ICON_THIN,
    ICON_STRIKE,
    ICON_REPEL,
    ICON_STROKE,
    ICON_DOSE,
    ICON_ERASE,
    ICON_MAP,
    ICON_UNDO,
    ICON_REDO,
    ICON_FINISH,
    ICON_PICTURE,  /* a framed one */
    ICON_METAPHOR, /* a leaf that becomes a star of frost */
    ICON_BOLTS,    /* a flash that becomes a coral */
    ICON_PATTERNS, /* spots that become a maze */
    ICON_HAND,     /* two ways */
    ICON_SEATED,   /* somebody in a wheelchair */
    ICON_LANGUAGE, /* an empty bubble of speech */
    ICON_MORE,
    ICON_BACK,
    ICON_EXIT,
    ICONS,
};

struct hud_icon_style {
    struct pen_colour line, wet, ground; /* strokes; ink that it drips; what is behind it */
    bool mirrored;
};

/* What ICON_PICTURE frames, in radii from its middle. */
#define HUD_FRAME_LEFT   (-0.78)
#define HUD_FRAME_TOP    (-0.76)
#define HUD_FRAME_WIDTH  1.44
#define HUD_FRAME_HEIGHT 1.14

/* A pictogram within `radius` pixels around x, y. */
void hud_icon_draw(const struct pen *pen, enum hud_icon icon, double x, double y, double radius,
                   const struct hud_icon_style *style);
/* An ink as a blot of itself, in its colours where it is thin, inked and thick. The mark on it, by its number of the
 * scene's inks, is for those who do not see its colour: a ring, a triangle, a square, a wave. Splashes go a tenth
 * beyond the radius. */
void hud_icon_ink(const struct pen *pen, const struct pen_colour colours[3], int number, double x, double y,
                  double radius, bool splashes);
/* The colour of a mark on an ink. */
struct pen_colour hud_icon_mark_colour(struct pen_colour ink);
/* The mark alone. */
void hud_icon_mark(const struct pen *pen, int number, double x, double y, double radius);
/* A hand that points, the tip of its finger at x, y; `size` from the tip to the wrist. */
void hud_icon_finger(const struct pen *pen, double x, double y, double size, const struct hud_icon_style *style,
                     double alpha);

#endif
