/* Pictograms of scenes of lightning and of chemistry. */
#include <math.h>

#include "hud_icon_parts.h"

/* A flash from a point down, `size` high, filled and with an outline. */
static void flash(const struct pen *pen, const struct hud_icon_style *style, double x, double y, double size)
{
    static const double PLACES[][2] = {{0.16, 0},    {-0.34, 0.56}, {-0.04, 0.54}, {-0.22, 1},
                                       {0.36, 0.36}, {0.06, 0.38},  {0.4, 0}};
    cairo_new_path(pen->cairo);
    for (size_t i = 0; i < sizeof PLACES / sizeof PLACES[0]; i++) {
        cairo_line_to(pen->cairo, x + size * PLACES[i][0], y + size * PLACES[i][1]);
    }
    cairo_close_path(pen->cairo);
    cairo_set_line_join(pen->cairo, CAIRO_LINE_JOIN_ROUND);
    wet(pen, style);
    cairo_fill_preserve(pen->cairo);
    line(pen, style);
    cairo_set_line_width(pen->cairo, 0.75 * LINE);
    cairo_stroke(pen->cairo);
}

static void disc(const struct pen *pen, double x, double y, double radius)
{
    cairo_new_path(pen->cairo);
    cairo_arc(pen->cairo, x, y, radius, 0, 2 * G_PI);
    cairo_fill(pen->cairo);
}

/* A cloud, and what comes of it. */
void hud_icon_strike(const struct pen *pen, const struct hud_icon_style *style)
{
    static const double PUFFS[][3] = {{-0.48, -0.4, 0.34}, {-0.08, -0.58, 0.4}, {0.42, -0.42, 0.36}};
    for (int pass = 0; pass < 2; pass++) {
        pen_set(pen, pass == 0 ? style->line : style->ground, 1);
        double less = pass == 0 ? 0 : LINE;
        for (int i = 0; i < 3; i++) {
            disc(pen, PUFFS[i][0], PUFFS[i][1], PUFFS[i][2] - less);
        }
        cairo_rectangle(pen->cairo, -0.48, -0.46, 0.9, 0.4 - less);
        cairo_fill(pen->cairo);
    }
    flash(pen, style, -0.04, -0.26, 1.2);
}

/* A hand's place, and arrows that flee it. */
void hud_icon_repel(const struct pen *pen, const struct hud_icon_style *style)
{
    cairo_new_path(pen->cairo);
    cairo_arc(pen->cairo, 0, 0, 0.25, 0, 2 * G_PI);
    wet(pen, style);
    cairo_fill_preserve(pen->cairo);
    line(pen, style);
    cairo_set_line_width(pen->cairo, LINE);
    cairo_stroke(pen->cairo);
    for (int i = 0; i < 4; i++) {
        double angle = G_PI * (0.25 + 0.5 * i), x = cos(angle), y = sin(angle);
        line(pen, style);
        BRUSH(pen, 0.08, 1.2 * LINE, 1.1 * LINE, {0.44 * x, 0.44 * y}, {0.7 * x, 0.7 * y}, {1.02 * x, 1.02 * y});
        hud_icon_arrow_head(pen, 1.1 * x, 1.1 * y, angle, 0.4);
    }
}

/* A painted line with charges on it. */
void hud_icon_stroke(const struct pen *pen, const struct hud_icon_style *style)
{
    static const double CHARGES[][2] = {{-0.56, -0.3}, {-0.16, 0.84}, {0.62, 0.42}};
    wet(pen, style);
    BRUSH(pen, 0.1, 0.34, 0.14, {-0.92, 0.5}, {-0.5, 0.14}, {0, 0.4}, {0.46, 0.2}, {0.62, -0.34}, {0.92, -0.6});
    line(pen, style);
    for (int i = 0; i < 3; i++) {
        double x = CHARGES[i][0], y = CHARGES[i][1];
        BRUSH(pen, LINE, LINE, LINE, {x - 0.2, y}, {x, y}, {x + 0.2, y});
        BRUSH(pen, LINE, LINE, LINE, {x, y - 0.2}, {x, y}, {x, y + 0.2});
    }
    flash(pen, style, 0.12, -1, 0.72);
}

static void drop_of(const struct pen *pen, const struct hud_icon_style *style, double x, double y, double size)
{
    cairo_new_path(pen->cairo);
    cairo_move_to(pen->cairo, x, y - size);
    cairo_curve_to(pen->cairo, x + 0.3 * size, y - 0.3 * size, x + 0.7 * size, y, x + 0.7 * size, y + 0.4 * size);
    cairo_arc(pen->cairo, x, y + 0.4 * size, 0.7 * size, 0, G_PI);
    cairo_curve_to(pen->cairo, x - 0.7 * size, y, x - 0.3 * size, y - 0.3 * size, x, y - size);
    cairo_close_path(pen->cairo);
    wet(pen, style);
    cairo_fill_preserve(pen->cairo);
    line(pen, style);
    cairo_set_line_width(pen->cairo, 0.7 * LINE);
    cairo_stroke(pen->cairo);
}

/* A pipette that drips. */
void hud_icon_dose(const struct pen *pen, const struct hud_icon_style *style)
{
    cairo_save(pen->cairo);
    cairo_translate(pen->cairo, 0.2, -0.24);
    cairo_rotate(pen->cairo, 0.7);
    line(pen, style);
    BRUSH(pen, 0.3, 0.44, 0.36, {0, -0.94}, {0, -0.7}, {0, -0.5}); /* the bulb, its collar */
    BRUSH(pen, 0.14, 0.15, 0.14, {-0.28, -0.4}, {0, -0.4}, {0.28, -0.4});
    cairo_new_path(pen->cairo); /* the glass */
    cairo_move_to(pen->cairo, -0.18, -0.36);
    cairo_line_to(pen->cairo, -0.18, 0.38);
    cairo_line_to(pen->cairo, -0.06, 0.62);
    cairo_line_to(pen->cairo, -0.05, 0.86);
    cairo_line_to(pen->cairo, 0.05, 0.86);
    cairo_line_to(pen->cairo, 0.06, 0.62);
    cairo_line_to(pen->cairo, 0.18, 0.38);
    cairo_line_to(pen->cairo, 0.18, -0.36);
    cairo_close_path(pen->cairo);
    pen_set(pen, style->ground, 1);
    cairo_fill_preserve(pen->cairo);
    cairo_save(pen->cairo);
    cairo_clip_preserve(pen->cairo);
    wet(pen, style);
    cairo_new_path(pen->cairo);
    cairo_rectangle(pen->cairo, -0.3, 0, 0.6, 1);
    cairo_fill(pen->cairo);
    cairo_restore(pen->cairo);
    cairo_new_path(pen->cairo);
    cairo_move_to(pen->cairo, -0.18, -0.36);
    cairo_line_to(pen->cairo, -0.18, 0.38);
    cairo_line_to(pen->cairo, -0.05, 0.66);
    cairo_line_to(pen->cairo, -0.05, 0.88);
    cairo_move_to(pen->cairo, 0.18, -0.36);
    cairo_line_to(pen->cairo, 0.18, 0.38);
    cairo_line_to(pen->cairo, 0.05, 0.66);
    cairo_line_to(pen->cairo, 0.05, 0.88);
    line(pen, style);
    cairo_set_line_width(pen->cairo, 0.8 * LINE);
    cairo_stroke(pen->cairo);
    cairo_restore(pen->cairo);
    drop_of(pen, style, -0.62, 0.72, 0.27);
}

/* A rubber, and spots that it takes. */
void hud_icon_erase(const struct pen *pen, const struct hud_icon_style *style)
{
    static const double SPOTS[][3] = {
        {-0.78, 0.16, 0.13}, {-0.86, 0.56, 0.11}, {-0.5, 0.46, 0.12}, {-0.56, -0.12, 0.1}};
    wet(pen, style);
    for (size_t i = 0; i < sizeof SPOTS / sizeof SPOTS[0]; i++) {
        disc(pen, SPOTS[i][0], SPOTS[i][1], SPOTS[i][2]);
    }
    line(pen, style);
    BRUSH(pen, 0.05, 0.1, 0.05, {-0.86, 0.9}, {-0.1, 0.86}, {0.86, 0.9});
    cairo_save(pen->cairo);
    cairo_translate(pen->cairo, 0.22, 0.02);
    cairo_rotate(pen->cairo, -0.72);
    for (int half = 0; half < 2; half++) {
        cairo_new_path(pen->cairo);
        cairo_rectangle(pen->cairo, half == 0 ? -0.82 : -0.34, -0.34, half == 0 ? 0.5 : 1.16, 0.68);
        if (half == 0) {
            pen_set(pen, style->ground, 1);
        } else {
            wet(pen, style);
        }
        cairo_fill_preserve(pen->cairo);
        cairo_set_line_join(pen->cairo, CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_width(pen->cairo, LINE);
        line(pen, style);
        cairo_stroke(pen->cairo);
    }
    cairo_restore(pen->cairo);
}

/* A chart with a region on it, and the place that is chosen. */
void hud_icon_map(const struct pen *pen, const struct hud_icon_style *style)
{
    cairo_rectangle(pen->cairo, -0.84, -0.84, 1.68, 1.68);
    pen_set(pen, style->ground, 1);
    cairo_fill_preserve(pen->cairo);
    cairo_save(pen->cairo);
    cairo_clip(pen->cairo);
    wet(pen, style);
    cairo_move_to(pen->cairo, -0.9, 0.9); /* the crescent where there are patterns */
    cairo_curve_to(pen->cairo, -0.2, 0.5, 0.34, 0.1, 0.5, -0.7);
    cairo_curve_to(pen->cairo, 0.9, -0.2, 0.7, 0.7, -0.9, 0.9);
    cairo_fill(pen->cairo);
    cairo_restore(pen->cairo);
    cairo_new_path(pen->cairo);
    cairo_rectangle(pen->cairo, -0.84, -0.84, 1.68, 1.68);
    line(pen, style);
    cairo_set_line_join(pen->cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_width(pen->cairo, LINE);
    cairo_stroke(pen->cairo);
    cairo_new_path(pen->cairo);
    cairo_arc(pen->cairo, 0.3, 0.16, 0.24, 0, 2 * G_PI);
    pen_set(pen, style->ground, 1);
    cairo_fill_preserve(pen->cairo);
    line(pen, style);
    cairo_stroke(pen->cairo);
    disc(pen, 0.3, 0.16, 0.09);
    BRUSH(pen, 0.06, 0.08, 0.06, {-0.6, 0.16}, {-0.3, 0.16}, {0, 0.16}); /* both rates of it */
    BRUSH(pen, 0.06, 0.08, 0.06, {0.3, -0.6}, {0.3, -0.4}, {0.3, -0.14});
}

/* The way from one thing to another. */
static void arrow_over(const struct pen *pen, const struct hud_icon_style *style)
{
    line(pen, style);
    BRUSH(pen, 0.07, 1.1 * LINE, LINE, {-0.66, -0.5}, {-0.16, -0.9}, {0.34, -0.78}, {0.62, -0.44});
    hud_icon_arrow_head(pen, 0.7, -0.28, 1.15, 0.36);
}

/* A flash becomes a coral. */
void hud_icon_bolts(const struct pen *pen, const struct hud_icon_style *style)
{
    flash(pen, style, -0.62, -0.28, 1.16);
    line(pen, style);
    BRUSH(pen, 0.24, 0.2, 0.14, {0.42, 0.94}, {0.44, 0.6}, {0.4, 0.28});
    BRUSH(pen, 0.2, 0.17, 0.13, {0.43, 0.66}, {0.66, 0.5}, {0.8, 0.16});
    BRUSH(pen, 0.19, 0.16, 0.12, {0.43, 0.74}, {0.2, 0.56}, {0.12, 0.26});
    BRUSH(pen, 0.14, 0.12, 0.1, {0.41, 0.4}, {0.54, 0.22}, {0.56, 0.02});
    BRUSH(pen, 0.14, 0.12, 0.1, {0.41, 0.38}, {0.32, 0.2}, {0.32, 0.02});
    arrow_over(pen, style);
}

/* Spots become a maze. */
void hud_icon_patterns(const struct pen *pen, const struct hud_icon_style *style)
{
    static const double SPOTS[][3] = {
        {-0.72, 0.04, 0.17}, {-0.32, 0.24, 0.16}, {-0.78, 0.46, 0.15}, {-0.4, 0.68, 0.17}, {-0.8, 0.86, 0.13}};
    wet(pen, style);
    for (size_t i = 0; i < sizeof SPOTS / sizeof SPOTS[0]; i++) {
        disc(pen, SPOTS[i][0], SPOTS[i][1], SPOTS[i][2]);
    }
    line(pen, style);
    BRUSH(pen, 0.16, 0.16, 0.16, {0.12, 0.04}, {0.4, 0.2}, {0.74, 0.06}, {0.94, 0.22});
    BRUSH(pen, 0.16, 0.16, 0.16, {0.1, 0.36}, {0.3, 0.52}, {0.56, 0.42}, {0.66, 0.6}, {0.92, 0.54});
    BRUSH(pen, 0.16, 0.16, 0.16, {0.08, 0.7}, {0.3, 0.86}, {0.52, 0.78}, {0.7, 0.9}, {0.94, 0.84});
    arrow_over(pen, style);
}
