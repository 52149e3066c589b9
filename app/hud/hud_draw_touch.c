/* What stands for hands: the one that paints in attract, and the lines of one-switch play. */
#include <math.h>

#include "hud_draw.h"
#include "hud_image.h"

static const double TIP = 7; /* mm: radius of a fingertip */

bool hud_draw_hand(const struct hud *hud, float pressed, struct hud_image *image)
{
    enum { STEPS = 12 };
    struct pen pen;
    int step = (int)lroundf(fminf(fmaxf(pressed, 0), 1) * STEPS);
    double down = (double)step / STEPS, mm = (double)hud->mm, radius = TIP * mm;
    int side = 2 * (int)ceil(2.2 * radius);
    uint64_t key = pen_hash_int(hud_key(hud, PIECE_HAND), step);
    if (!hud_image_begin(image, key, side, side, &pen)) {
        return false;
    }
    double middle = 0.5 * side, high = 0.5 * (1 - down) * radius;
    cairo_pattern_t *shadow =
        cairo_pattern_create_radial(middle, middle, 0, middle, middle, radius * (1.6 - 0.3 * down));
    cairo_pattern_add_color_stop_rgba(shadow, 0, pen_dark.red, pen_dark.green, pen_dark.blue, 0.16 + 0.16 * down);
    cairo_pattern_add_color_stop_rgba(shadow, 1, pen_dark.red, pen_dark.green, pen_dark.blue, 0);
    cairo_set_source(pen.cairo, shadow);
    cairo_paint(pen.cairo);
    cairo_pattern_destroy(shadow);
    cairo_arc(pen.cairo, middle, middle - high, radius, 0, 2 * G_PI);
    pen_set(&pen, pen_paper, 0.62 + 0.2 * down);
    cairo_fill_preserve(pen.cairo);
    pen_set(&pen, pen_dark, 0.45);
    cairo_set_line_width(pen.cairo, 0.7 * mm);
    cairo_stroke(pen.cairo);
    return hud_image_end(image, key, 0, 0, &pen);
}

bool hud_draw_line(const struct hud *hud, struct hud_image *image)
{
    enum { SIDE = 4 };
    struct pen pen;
    uint64_t key = hud_key(hud, PIECE_LINE);
    if (!hud_image_begin(image, key, SIDE, SIDE, &pen)) {
        return false;
    }
    pen_set(&pen, pen_dark, 0.75);
    cairo_paint(pen.cairo);
    return hud_image_end(image, key, 0, 0, &pen);
}
