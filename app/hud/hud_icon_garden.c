/* Pictograms of scenes of trees. */
#include <math.h>

#include "hud_icon_parts.h"

/* A leaf from its stalk at x, y to its tip, as wide as that share of its length. */
static void leaf_path(cairo_t *cairo, double x, double y, double to_x, double to_y, double wide)
{
    double along_x = to_x - x, along_y = to_y - y, across_x = -along_y * wide, across_y = along_x * wide;
    cairo_move_to(cairo, x, y);
    cairo_curve_to(cairo, x + 0.25 * along_x + across_x, y + 0.25 * along_y + across_y, x + 0.75 * along_x + across_x,
                   y + 0.75 * along_y + across_y, to_x, to_y);
    cairo_curve_to(cairo, x + 0.75 * along_x - across_x, y + 0.75 * along_y - across_y, x + 0.25 * along_x - across_x,
                   y + 0.25 * along_y - across_y, x, y);
    cairo_close_path(cairo);
}

static void leaf(const struct pen *pen, const struct hud_icon_style *style, double x, double y, double to_x,
                 double to_y, double wide)
{
    leaf_path(pen->cairo, x, y, to_x, to_y, wide);
    wet(pen, style);
    cairo_fill_preserve(pen->cairo);
    line(pen, style);
    cairo_set_line_width(pen->cairo, 0.75 * LINE);
    cairo_stroke(pen->cairo);
}

/* A seed in the ground, and what comes of it. */
void hud_icon_plant(const struct pen *pen, const struct hud_icon_style *style)
{
    line(pen, style);
    BRUSH(pen, 0.06, 1.1 * LINE, 0.06, {-0.94, 0.36}, {-0.4, 0.28}, {0.1, 0.36}, {0.5, 0.3}, {0.94, 0.38});
    BRUSH(pen, 0.16, 0.13, 0.1, {0, 0.62}, {-0.03, 0.2}, {0.02, -0.2}, {0.02, -0.4});
    leaf(pen, style, 0.02, -0.16, -0.78, -0.62, 0.36);
    leaf(pen, style, 0.02, -0.34, 0.72, -0.92, 0.36);
    cairo_save(pen->cairo); /* the seed */
    cairo_translate(pen->cairo, 0, 0.7);
    cairo_rotate(pen->cairo, 0.5);
    cairo_scale(pen->cairo, 1, 0.7);
    cairo_new_path(pen->cairo);
    cairo_arc(pen->cairo, 0, 0, 0.26, 0, 2 * G_PI);
    cairo_restore(pen->cairo);
    line(pen, style);
    cairo_fill(pen->cairo);
}

/* A watering can. */
void hud_icon_tend(const struct pen *pen, const struct hud_icon_style *style)
{
    static const double DROPS[][2] = {{-0.9, 0.24}, {-0.68, 0.5}, {-0.92, 0.72}, {-0.64, 0.9}};
    line(pen, style);
    cairo_set_line_width(pen->cairo, 1.1 * LINE);
    cairo_arc(pen->cairo, 0.42, -0.12, 0.5, -2.9, 0.9); /* the handle */
    cairo_stroke(pen->cairo);
    BRUSH(pen, 0.2, 0.15, 0.13, {-0.02, 0.42}, {-0.34, 0.06}, {-0.64, -0.34}); /* the spout, and its rose */
    BRUSH(pen, 0.12, 0.2, 0.12, {-0.9, -0.2}, {-0.7, -0.38}, {-0.48, -0.52});
    cairo_move_to(pen->cairo, -0.14, -0.06);
    cairo_line_to(pen->cairo, 0.7, -0.06);
    cairo_curve_to(pen->cairo, 0.78, 0.2, 0.82, 0.5, 0.84, 0.82);
    cairo_line_to(pen->cairo, -0.26, 0.82);
    cairo_curve_to(pen->cairo, -0.24, 0.5, -0.2, 0.2, -0.14, -0.06);
    cairo_close_path(pen->cairo);
    wet(pen, style);
    cairo_fill_preserve(pen->cairo);
    line(pen, style);
    cairo_set_line_width(pen->cairo, LINE);
    cairo_stroke(pen->cairo);
    wet(pen, style);
    for (size_t i = 0; i < sizeof DROPS / sizeof DROPS[0]; i++) {
        cairo_new_path(pen->cairo);
        cairo_arc(pen->cairo, DROPS[i][0], DROPS[i][1], 0.085, 0, 2 * G_PI);
        cairo_fill(pen->cairo);
    }
}

/* Shears, and the twig that they take. */
void hud_icon_thin(const struct pen *pen, const struct hud_icon_style *style)
{
    wet(pen, style);
    BRUSH(pen, 0.09, 0.11, 0.08, {-0.86, 0.92}, {-0.62, 0.3}, {-0.66, -0.16});
    leaf(pen, style, -0.66, -0.3, -0.9, -0.9, 0.34);
    leaf(pen, style, -0.62, -0.3, -0.22, -0.84, 0.34);
    line(pen, style);
    BRUSH(pen, 0.06, 0.2, 0.14, {-0.86, 0.02}, {-0.3, 0.1}, {0.1, 0.22}, {0.38, 0.42}); /* the blades */
    BRUSH(pen, 0.06, 0.2, 0.14, {-0.52, -0.62}, {-0.28, -0.2}, {0.04, 0.26}, {0.2, 0.6});
    cairo_set_line_width(pen->cairo, 1.1 * LINE);
    cairo_new_path(pen->cairo);
    cairo_arc(pen->cairo, 0.62, 0.44, 0.25, 0, 2 * G_PI); /* the handles */
    cairo_stroke(pen->cairo);
    cairo_new_path(pen->cairo);
    cairo_arc(pen->cairo, 0.26, 0.74, 0.22, 0, 2 * G_PI);
    cairo_stroke(pen->cairo);
    pen_set(pen, style->ground, 1);
    cairo_new_path(pen->cairo);
    cairo_arc(pen->cairo, 0.0, 0.2, 0.06, 0, 2 * G_PI);
    cairo_fill(pen->cairo);
}

/* A framed picture, and an arrow to the next. */
void hud_icon_picture(const struct pen *pen, const struct hud_icon_style *style)
{
    cairo_rectangle(pen->cairo, -0.86, -0.84, 1.6, 1.3);
    pen_set(pen, style->ground, 1);
    cairo_fill_preserve(pen->cairo);
    line(pen, style);
    cairo_set_line_width(pen->cairo, 1.2 * LINE);
    cairo_stroke(pen->cairo);
    wet(pen, style);
    cairo_move_to(pen->cairo, -0.72, 0.32); /* hills, the sun */
    cairo_curve_to(pen->cairo, -0.5, -0.1, -0.34, -0.36, -0.22, -0.36);
    cairo_curve_to(pen->cairo, -0.06, -0.36, 0.04, 0.02, 0.16, 0.02);
    cairo_curve_to(pen->cairo, 0.26, 0.02, 0.32, -0.14, 0.4, -0.14);
    cairo_curve_to(pen->cairo, 0.48, -0.14, 0.54, 0.1, 0.6, 0.32);
    cairo_close_path(pen->cairo);
    cairo_fill(pen->cairo);
    cairo_arc(pen->cairo, 0.32, -0.46, 0.14, 0, 2 * G_PI);
    cairo_fill(pen->cairo);
    line(pen, style);
    BRUSH(pen, 0.08, 1.2 * LINE, LINE, {-0.5, 0.8}, {0.1, 0.84}, {0.72, 0.8});
    hud_icon_arrow_head(pen, 0.86, 0.8, 0, 0.36);
}

/* A leaf becomes a star of frost. */
void hud_icon_metaphor(const struct pen *pen, const struct hud_icon_style *style)
{
    leaf(pen, style, -0.9, 0.86, -0.12, -0.1, 0.34);
    line(pen, style);
    BRUSH(pen, 0.06, 0.07, 0.05, {-0.9, 0.86}, {-0.56, 0.44}, {-0.3, 0.12});
    for (int i = 0; i < 3; i++) {
        double x = 0.46 * cos(i * G_PI / 3), y = 0.46 * sin(i * G_PI / 3);
        BRUSH(pen, 0.08, 0.12, 0.08, {0.5 - x, 0.46 - y}, {0.5, 0.46}, {0.5 + x, 0.46 + y});
    }
    for (int i = 0; i < 6; i++) { /* barbs */
        double angle = i * G_PI / 3, x = 0.5 + 0.28 * cos(angle), y = 0.46 + 0.28 * sin(angle);
        for (int k = -1; k <= 1; k += 2) {
            BRUSH(pen, 0.07, 0.06, 0.04, {x, y}, {x + 0.08 * cos(angle + 0.9 * k), y + 0.08 * sin(angle + 0.9 * k)},
                  {x + 0.17 * cos(angle + 0.9 * k), y + 0.17 * sin(angle + 0.9 * k)});
        }
    }
    BRUSH(pen, 0.07, 1.1 * LINE, LINE, {-0.62, -0.42}, {-0.16, -0.86}, {0.34, -0.72}, {0.6, -0.36});
    hud_icon_arrow_head(pen, 0.68, -0.2, 1.15, 0.36);
}
