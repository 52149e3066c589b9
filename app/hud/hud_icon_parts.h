/* What pictograms are drawn with, in -1..1. Private to hud_icon*.c. */
#ifndef FROND_HUD_ICON_PARTS_H
#define FROND_HUD_ICON_PARTS_H

#include "hud_icon.h"

/* The width of a stroke. */
static const double LINE = 0.13;

#define BRUSH(pen, first, middle, last, ...)                                                                           \
    pen_brush(pen, (const double[][2]){__VA_ARGS__},                                                                   \
              (int)(sizeof((const double[][2]){__VA_ARGS__}) / sizeof(double[2])), first, middle, last)

static inline void line(const struct pen *pen, const struct hud_icon_style *style)
{
    pen_set(pen, style->line, 1);
}

static inline void wet(const struct pen *pen, const struct hud_icon_style *style)
{
    pen_set(pen, style->wet, 1);
}

/* The head of an arrow that flies in a direction (radians), its tip at x, y. */
void hud_icon_arrow_head(const struct pen *pen, double x, double y, double angle, double size);

/* Of scenes of trees. */
void hud_icon_plant(const struct pen *pen, const struct hud_icon_style *style);
void hud_icon_tend(const struct pen *pen, const struct hud_icon_style *style);
void hud_icon_thin(const struct pen *pen, const struct hud_icon_style *style);
void hud_icon_picture(const struct pen *pen, const struct hud_icon_style *style);
void hud_icon_metaphor(const struct pen *pen, const struct hud_icon_style *style);

/* Of scenes of lightning and chemistry. */
void hud_icon_strike(const struct pen *pen, const struct hud_icon_style *style);
void hud_icon_repel(const struct pen *pen, const struct hud_icon_style *style);
void hud_icon_stroke(const struct pen *pen, const struct hud_icon_style *style);
void hud_icon_dose(const struct pen *pen, const struct hud_icon_style *style);
void hud_icon_erase(const struct pen *pen, const struct hud_icon_style *style);
void hud_icon_map(const struct pen *pen, const struct hud_icon_style *style);
void hud_icon_bolts(const struct pen *pen, const struct hud_icon_style *style);
void hud_icon_patterns(const struct pen *pen, const struct hud_icon_style *style);

#endif
