#include "hud_icon.h"

#include <math.h>

#include "hud_icon_parts.h"

void hud_icon_arrow_head(const struct pen *pen, double x, double y, double angle, double size)
{
    double ax = x - size * cos(angle - 0.6), ay = y - size * sin(angle - 0.6);
    double bx = x - size * cos(angle + 0.6), by = y - size * sin(angle + 0.6);
    BRUSH(pen, 0.75 * LINE, 1.1 * LINE, 1.15 * LINE, {ax, ay}, {0.5 * (ax + x), 0.5 * (ay + y)}, {x, y});
    BRUSH(pen, 1.15 * LINE, 1.1 * LINE, 0.75 * LINE, {x, y}, {0.5 * (bx + x), 0.5 * (by + y)}, {bx, by});
}

static void drop_path(cairo_t *cairo, double x, double y, double size)
{
    cairo_move_to(cairo, x, y - size);
    cairo_curve_to(cairo, x + 0.1 * size, y - 0.55 * size, x + 0.68 * size, y - 0.1 * size, x + 0.68 * size,
                   y + 0.32 * size);
    cairo_curve_to(cairo, x + 0.68 * size, y + 0.72 * size, x + 0.36 * size, y + size, x, y + size);
    cairo_curve_to(cairo, x - 0.36 * size, y + size, x - 0.68 * size, y + 0.72 * size, x - 0.68 * size,
                   y + 0.32 * size);
    cairo_curve_to(cairo, x - 0.68 * size, y - 0.1 * size, x - 0.1 * size, y - 0.55 * size, x, y - size);
    cairo_close_path(cairo);
}

static void draw_drop(const struct pen *pen, const struct hud_icon_style *style)
{
    drop_path(pen->cairo, 0, -0.02, 0.88);
    wet(pen, style);
    cairo_fill_preserve(pen->cairo);
    line(pen, style);
    cairo_set_line_width(pen->cairo, LINE);
    cairo_stroke(pen->cairo);
    pen_set(pen, pen_paper, 0.9);
    BRUSH(pen, 0.05, 0.12, 0.05, {-0.33, 0.2}, {-0.31, 0.42}, {-0.14, 0.6});
}

static void draw_brush(const struct pen *pen, const struct hud_icon_style *style)
{
    wet(pen, style);
    BRUSH(pen, 0.06, 0.3, 0.1, {-0.92, 0.62}, {-0.5, 0.86}, {0, 0.72}, {0.4, 0.82}, {0.85, 0.66});
    line(pen, style);
    BRUSH(pen, 0.1, 0.2, 0.28, {0.82, -0.9}, {0.5, -0.5}, {0.16, -0.08}); /* handle */
    cairo_move_to(pen->cairo, 0.3, -0.02);                                /* bristles, up to the point */
    cairo_curve_to(pen->cairo, 0.3, 0.34, -0.1, 0.5, -0.52, 0.58);
    cairo_curve_to(pen->cairo, -0.3, 0.3, -0.36, -0.1, 0.02, -0.24);
    cairo_close_path(pen->cairo);
    cairo_fill(pen->cairo);
    pen_set(pen, style->ground, 1);
    BRUSH(pen, 0.06, 0.07, 0.06, {0, -0.26}, {0.16, -0.13}, {0.3, 0}); /* the ferrule's edge */
}

/* A current that turns, and an arrow that goes with it. */
static void draw_guide(const struct pen *pen, const struct hud_icon_style *style)
{
    wet(pen, style);
    BRUSH(pen, 0.04, 0.11, 0.04, {-0.9, -0.12}, {-0.45, -0.5}, {0.02, -0.3}, {0.3, -0.38}, {0.5, -0.72});
    BRUSH(pen, 0.04, 0.11, 0.04, {-0.5, 0.86}, {-0.1, 0.5}, {0.35, 0.62}, {0.72, 0.3}, {0.9, -0.02});
    line(pen, style);
    BRUSH(pen, 0.06, 1.3 * LINE, 1.1 * LINE, {-0.92, 0.52}, {-0.5, 0.1}, {0, 0.2}, {0.42, 0.06}, {0.76, -0.5});
    hud_icon_arrow_head(pen, 0.8, -0.62, -1.06, 0.44);
}

/* A jug that pours. */
static void draw_pour(const struct pen *pen, const struct hud_icon_style *style)
{
    wet(pen, style);
    BRUSH(pen, 0.1, 0.16, 0.12, {-0.56, -0.4}, {-0.72, -0.02}, {-0.74, 0.5}); /* the stream, a pool */
    cairo_save(pen->cairo);
    cairo_translate(pen->cairo, -0.4, 0.76);
    cairo_scale(pen->cairo, 1, 0.32);
    pen_blot(pen, 0, 0, 0.54, 0.12, 3);
    cairo_restore(pen->cairo);
    cairo_fill(pen->cairo);
    cairo_save(pen->cairo);
    cairo_translate(pen->cairo, 0.22, -0.22);
    cairo_rotate(pen->cairo, -0.62);
    line(pen, style);
    cairo_set_line_width(pen->cairo, 1.05 * LINE);
    cairo_arc(pen->cairo, 0.46, 0.1, 0.3, -1.3, 1.5); /* the handle */
    cairo_stroke(pen->cairo);
    cairo_move_to(pen->cairo, -0.72, -0.58); /* the lip */
    cairo_curve_to(pen->cairo, -0.34, -0.36, -0.5, 0, -0.5, 0.3);
    cairo_curve_to(pen->cairo, -0.5, 0.56, -0.3, 0.6, 0, 0.6);
    cairo_curve_to(pen->cairo, 0.34, 0.6, 0.48, 0.52, 0.48, 0.26);
    cairo_curve_to(pen->cairo, 0.48, -0.06, 0.34, -0.3, 0.42, -0.58);
    cairo_close_path(pen->cairo);
    pen_set(pen, style->ground, 1);
    cairo_fill_preserve(pen->cairo);
    cairo_save(pen->cairo);
    cairo_clip_preserve(pen->cairo);
    cairo_rotate(pen->cairo, 0.62);
    wet(pen, style);
    cairo_new_path(pen->cairo);
    cairo_rectangle(pen->cairo, -1, -0.1, 2, 1.2);
    cairo_fill(pen->cairo);
    cairo_restore(pen->cairo);
    cairo_move_to(pen->cairo, -0.72, -0.58);
    cairo_curve_to(pen->cairo, -0.34, -0.36, -0.5, 0, -0.5, 0.3);
    cairo_curve_to(pen->cairo, -0.5, 0.56, -0.3, 0.6, 0, 0.6);
    cairo_curve_to(pen->cairo, 0.34, 0.6, 0.48, 0.52, 0.48, 0.26);
    cairo_curve_to(pen->cairo, 0.48, -0.06, 0.34, -0.3, 0.42, -0.58);
    cairo_close_path(pen->cairo);
    line(pen, style);
    cairo_stroke(pen->cairo);
    cairo_restore(pen->cairo);
}

/* A roll of tape, its torn end over a branch that stops there. */
static void draw_mask(const struct pen *pen, const struct hud_icon_style *style)
{
    cairo_move_to(pen->cairo, -0.2, 0.44); /* the end of the tape */
    cairo_line_to(pen->cairo, 0.72, 0.44);
    cairo_line_to(pen->cairo, 0.88, 0.52);
    cairo_line_to(pen->cairo, 0.74, 0.6);
    cairo_line_to(pen->cairo, 0.9, 0.68);
    cairo_line_to(pen->cairo, 0.76, 0.76);
    cairo_line_to(pen->cairo, 0.88, 0.84);
    cairo_line_to(pen->cairo, -0.2, 0.84);
    cairo_close_path(pen->cairo);
    wet(pen, style);
    cairo_fill_preserve(pen->cairo);
    line(pen, style);
    cairo_set_line_width(pen->cairo, 0.8 * LINE);
    cairo_stroke(pen->cairo);
    cairo_arc(pen->cairo, -0.18, 0, 0.84, 0, 2 * G_PI);
    pen_set(pen, style->ground, 1);
    cairo_fill_preserve(pen->cairo);
    wet(pen, style);
    cairo_fill(pen->cairo);
    cairo_arc(pen->cairo, -0.18, 0, 0.78, 0, 2 * G_PI);
    line(pen, style);
    cairo_set_line_width(pen->cairo, LINE);
    cairo_stroke(pen->cairo);
    cairo_arc(pen->cairo, -0.18, 0, 0.36, 0, 2 * G_PI);
    pen_set(pen, style->ground, 1);
    cairo_fill_preserve(pen->cairo);
    line(pen, style);
    cairo_stroke(pen->cairo);
}

/* A clock that goes backwards; its hand is a brush. */
static void draw_rewind(const struct pen *pen, const struct hud_icon_style *style)
{
    enum { POINTS = 12 };
    double points[POINTS][2];
    for (int i = 0; i < POINTS; i++) { /* from the right, over the bottom, to the upper left */
        double angle = -0.9 + (1.52 * G_PI) * i / (POINTS - 1);
        points[i][0] = 0.8 * cos(angle);
        points[i][1] = 0.04 + 0.8 * sin(angle);
    }
    line(pen, style);
    pen_brush(pen, (const double(*)[2])points, POINTS, 0.07, 1.1 * LINE, 1.2 * LINE);
    hud_icon_arrow_head(pen, points[POINTS - 1][0] + 0.03, points[POINTS - 1][1] - 0.06, -0.98, 0.42);
    BRUSH(pen, 0.1, 0.13, 0.15, {0, 0.06}, {0.15, 0.15}, {0.3, 0.26}); /* the short hand */
    BRUSH(pen, 0.1, 0.13, 0.14, {0, 0.06}, {0.06, -0.14}, {0.1, -0.26});
    wet(pen, style);
    cairo_move_to(pen->cairo, 0.02, -0.24); /* the brush's tip, drawn back */
    cairo_curve_to(pen->cairo, 0, -0.44, 0.06, -0.6, 0.22, -0.8);
    cairo_curve_to(pen->cairo, 0.34, -0.6, 0.32, -0.4, 0.22, -0.28);
    cairo_close_path(pen->cairo);
    cairo_fill_preserve(pen->cairo);
    line(pen, style);
    cairo_set_line_width(pen->cairo, 0.6 * LINE);
    cairo_stroke(pen->cairo);
}

static void draw_undo(const struct pen *pen, const struct hud_icon_style *style)
{
    line(pen, style);
    BRUSH(pen, 1.15 * LINE, 1.5 * LINE, 0.06, {-0.72, -0.24}, {-0.1, -0.42}, {0.52, -0.26}, {0.74, 0.18}, {0.5, 0.56},
          {0, 0.68});
    hud_icon_arrow_head(pen, -0.82, -0.2, G_PI - 0.27, 0.5);
}

static void draw_redo(const struct pen *pen, const struct hud_icon_style *style)
{
    cairo_scale(pen->cairo, -1, 1);
    draw_undo(pen, style);
}

static void draw_finish(const struct pen *pen, const struct hud_icon_style *style)
{
    wet(pen, style);
    pen_blot(pen, 0, 0.04, 0.82, 0.1, 11);
    cairo_fill(pen->cairo);
    line(pen, style);
    BRUSH(pen, 0.1, 0.24, 0.26, {-0.56, 0.1}, {-0.36, 0.3}, {-0.14, 0.54});
    BRUSH(pen, 0.26, 0.22, 0.06, {-0.14, 0.54}, {0.16, -0.08}, {0.72, -0.66});
}

/* Strokes as wide as fingers, and again narrower in the ground's colour: the outline of all of them together. */
static void outline(const struct pen *pen, const struct hud_icon_style *style, const double (*strokes)[5], int count,
                    double border)
{
    for (int pass = 0; pass < 2; pass++) {
        pen_set(pen, pass == 0 ? style->line : style->ground, 1);
        for (int i = 0; i < count; i++) {
            const double *s = strokes[i];
            cairo_new_path(pen->cairo);
            cairo_move_to(pen->cairo, s[0], s[1]);
            cairo_line_to(pen->cairo, s[2], s[3]);
            cairo_set_line_width(pen->cairo, s[4] + (pass == 0 ? border : -border));
            cairo_stroke(pen->cairo);
        }
    }
}

/* A hand, and both ways that it may go. */
static void draw_hand(const struct pen *pen, const struct hud_icon_style *style)
{
    static const double STROKES[][5] = {
        {0.02, 0.2, 0.02, 0.3, 0.62},   {-0.2, 0.06, -0.28, -0.42, 0.19}, {-0.02, 0, -0.04, -0.62, 0.19},
        {0.16, 0.02, 0.2, -0.54, 0.19}, {0.3, 0.14, 0.42, -0.28, 0.18},   {-0.16, 0.36, -0.52, 0.02, 0.2},
    };
    cairo_save(pen->cairo);
    cairo_translate(pen->cairo, 0, -0.18);
    outline(pen, style, STROKES, sizeof STROKES / sizeof STROKES[0], 0.1);
    cairo_restore(pen->cairo);
    line(pen, style);
    BRUSH(pen, 0.11, 0.13, 0.11, {-0.7, 0.78}, {0, 0.8}, {0.7, 0.78});
    cairo_save(pen->cairo);
    hud_icon_arrow_head(pen, 0.8, 0.78, 0, 0.34);
    hud_icon_arrow_head(pen, -0.8, 0.78, G_PI, 0.34);
    cairo_restore(pen->cairo);
}

/* After the symbol of ISO 7001, PI PF 006. */
static void draw_seated(const struct pen *pen, const struct hud_icon_style *style)
{
    wet(pen, style);
    cairo_arc(pen->cairo, -0.06, 0.34, 0.42, 0, 2 * G_PI);
    cairo_fill(pen->cairo);
    line(pen, style);
    cairo_arc(pen->cairo, -0.2, -0.76, 0.17, 0, 2 * G_PI);
    cairo_fill(pen->cairo);
    BRUSH(pen, 0.22, 0.2, 0.16, {-0.2, -0.46}, {-0.17, -0.16}, {-0.12, 0.16}, {0.2, 0.16}, {0.38, 0.18});
    BRUSH(pen, 0.16, 0.17, 0.12, {0.38, 0.18}, {0.5, 0.5}, {0.62, 0.78}, {0.86, 0.7});
    BRUSH(pen, 0.13, 0.12, 0.1, {-0.18, -0.22}, {0.1, -0.2}, {0.36, -0.18});
    cairo_set_line_width(pen->cairo, LINE);
    cairo_arc(pen->cairo, -0.06, 0.34, 0.56, 0.55, 1.28 * G_PI);
    cairo_stroke(pen->cairo);
}

static void draw_language(const struct pen *pen, const struct hud_icon_style *style)
{
    pen_card(pen, -0.92, -0.82, 1.84, 1.36, 0.44, 0, 0);
    cairo_move_to(pen->cairo, -0.5, 0.4); /* turns as the card does: their overlap is no hole */
    cairo_line_to(pen->cairo, 0.02, 0.48);
    cairo_curve_to(pen->cairo, -0.06, 0.74, -0.36, 0.9, -0.7, 0.94);
    cairo_curve_to(pen->cairo, -0.56, 0.82, -0.46, 0.7, -0.5, 0.4);
    cairo_close_path(pen->cairo);
    line(pen, style);
    cairo_set_line_width(pen->cairo, 2 * 0.8 * LINE); /* half of it is covered */
    cairo_stroke_preserve(pen->cairo);
    pen_set(pen, style->ground, 1);
    cairo_fill(pen->cairo);
}

static void draw_more(const struct pen *pen, const struct hud_icon_style *style)
{
    line(pen, style);
    for (int i = -1; i <= 1; i++) {
        pen_blot(pen, 0.58 * i, 0, 0.19, 0.12, (unsigned)(20 + i));
        cairo_fill(pen->cairo);
    }
}

static void draw_back(const struct pen *pen, const struct hud_icon_style *style)
{
    line(pen, style);
    BRUSH(pen, 1.2 * LINE, 1.4 * LINE, 0.08, {-0.7, 0}, {0, -0.04}, {0.82, 0.02});
    hud_icon_arrow_head(pen, -0.82, 0, G_PI, 0.56);
}

/* A door, and the way out of it. */
static void draw_exit(const struct pen *pen, const struct hud_icon_style *style)
{
    line(pen, style);
    cairo_set_line_width(pen->cairo, LINE);
    cairo_move_to(pen->cairo, 0.12, -0.5);
    cairo_line_to(pen->cairo, 0.12, -0.84);
    cairo_line_to(pen->cairo, -0.78, -0.84);
    cairo_line_to(pen->cairo, -0.78, 0.84);
    cairo_line_to(pen->cairo, 0.12, 0.84);
    cairo_line_to(pen->cairo, 0.12, 0.5);
    cairo_stroke(pen->cairo);
    BRUSH(pen, 0.08, 1.3 * LINE, 1.1 * LINE, {-0.4, 0}, {0.2, 0.02}, {0.8, 0});
    hud_icon_arrow_head(pen, 0.9, 0, 0, 0.44);
}

void hud_icon_draw(const struct pen *pen, enum hud_icon icon, double x, double y, double radius,
                   const struct hud_icon_style *style)
{
    static void (*const DRAW[ICONS])(const struct pen *, const struct hud_icon_style *) = {
        [ICON_DROP] = draw_drop,
        [ICON_BRUSH] = draw_brush,
        [ICON_GUIDE] = draw_guide,
        [ICON_POUR] = draw_pour,
        [ICON_MASK] = draw_mask,
        [ICON_REWIND] = draw_rewind,
        [ICON_UNDO] = draw_undo,
        [ICON_REDO] = draw_redo,
        [ICON_FINISH] = draw_finish,
        [ICON_HAND] = draw_hand,
        [ICON_SEATED] = draw_seated,
        [ICON_LANGUAGE] = draw_language,
        [ICON_PLANT] = hud_icon_plant,
        [ICON_TEND] = hud_icon_tend,
        [ICON_THIN] = hud_icon_thin,
        [ICON_STRIKE] = hud_icon_strike,
        [ICON_REPEL] = hud_icon_repel,
        [ICON_STROKE] = hud_icon_stroke,
        [ICON_DOSE] = hud_icon_dose,
        [ICON_ERASE] = hud_icon_erase,
        [ICON_MAP] = hud_icon_map,
        [ICON_BOLTS] = hud_icon_bolts,
        [ICON_PATTERNS] = hud_icon_patterns,
        [ICON_PICTURE] = hud_icon_picture,
        [ICON_METAPHOR] = hud_icon_metaphor,
        [ICON_MORE] = draw_more,
        [ICON_BACK] = draw_back,
        [ICON_EXIT] = draw_exit,
    };
    cairo_save(pen->cairo);
    cairo_translate(pen->cairo, x, y);
    cairo_scale(pen->cairo, style->mirrored ? -radius : radius, radius);
    cairo_new_path(pen->cairo);
    DRAW[icon](pen, style);
    cairo_restore(pen->cairo);
}

void hud_icon_mark(const struct pen *pen, int number, double x, double y, double radius)
{
    cairo_save(pen->cairo);
    cairo_translate(pen->cairo, x, y);
    cairo_scale(pen->cairo, radius, radius);
    cairo_new_path(pen->cairo);
    switch (number % 4) {
    case 0:
        cairo_arc(pen->cairo, 0, 0, 0.8, 0, 2 * G_PI);
        break;
    case 1:
        cairo_move_to(pen->cairo, 0, -0.9);
        cairo_line_to(pen->cairo, 0.88, 0.62);
        cairo_line_to(pen->cairo, -0.88, 0.62);
        cairo_close_path(pen->cairo);
        break;
    case 2:
        cairo_rectangle(pen->cairo, -0.72, -0.72, 1.44, 1.44);
        break;
    default:
        for (int i = -1; i <= 1; i += 2) {
            cairo_move_to(pen->cairo, -1, 0.36 * i);
            cairo_curve_to(pen->cairo, -0.4, 0.36 * i - 0.7, 0.4, 0.36 * i + 0.7, 1, 0.36 * i);
        }
        break;
    }
    cairo_set_line_width(pen->cairo, 0.36);
    cairo_stroke(pen->cairo);
    cairo_restore(pen->cairo);
}

struct pen_colour hud_icon_mark_colour(struct pen_colour ink)
{
    return pen_luminance(ink) > 0.19 ? pen_dark : pen_paper;
}

void hud_icon_ink(const struct pen *pen, const struct pen_colour colours[3], int number, double x, double y,
                  double radius, bool splashes)
{
    struct pen_colour thin = colours[0], middle = colours[1], thick = colours[2];
    unsigned seed = 31 + (unsigned)number;
    cairo_new_path(pen->cairo);
    for (unsigned i = 0; i < 5 && splashes; i++) {
        double angle = 2 * G_PI * (i + 0.7 * pen_chance(seed, 40 + i)) / 5;
        double away = radius * (0.97 + 0.1 * pen_chance(seed, 50 + i));
        cairo_new_sub_path(pen->cairo);
        cairo_arc(pen->cairo, x + away * cos(angle), y + away * sin(angle),
                  radius * (0.035 + 0.05 * pen_chance(seed, 60 + i)), 0, 2 * G_PI);
    }
    pen_set(pen, middle, 1);
    cairo_fill(pen->cairo);
    pen_blot(pen, x, y, 0.82 * radius, 0.13, seed);
    /* Ink dries with a darker rim. */
    cairo_pattern_t *fill = cairo_pattern_create_radial(x - 0.2 * radius, y - 0.25 * radius, 0, x, y, 0.95 * radius);
    cairo_pattern_add_color_stop_rgb(fill, 0, thin.red, thin.green, thin.blue);
    cairo_pattern_add_color_stop_rgb(fill, 0.7, middle.red, middle.green, middle.blue);
    cairo_pattern_add_color_stop_rgb(fill, 1, thick.red, thick.green, thick.blue);
    cairo_set_source(pen->cairo, fill);
    cairo_fill_preserve(pen->cairo);
    cairo_pattern_destroy(fill);
    pen_set(pen, thick, 0.7);
    cairo_set_line_width(pen->cairo, 0.05 * radius);
    cairo_stroke(pen->cairo);
    pen_set(pen, hud_icon_mark_colour(middle), 1);
    hud_icon_mark(pen, number, x, y, 0.3 * radius);
}

void hud_icon_finger(const struct pen *pen, double x, double y, double size, const struct hud_icon_style *style,
                     double alpha)
{
    static const double STROKES[][5] = {
        {0.3, 1.06, 0.34, 1.16, 0.66}, {0.06, 0.86, 0, 0.1, 0.25},    {0.24, 0.86, 0.2, 0.62, 0.24},
        {0.4, 0.86, 0.38, 0.68, 0.22}, {0.54, 0.92, 0.53, 0.76, 0.2}, {0.08, 1.12, -0.26, 0.8, 0.22},
        {0.34, 1.2, 0.4, 1.55, 0.5},
    };
    cairo_save(pen->cairo);
    cairo_rectangle(pen->cairo, x - size, y - size, 3 * size, 3 * size);
    cairo_clip(pen->cairo);
    cairo_push_group(pen->cairo);
    cairo_save(pen->cairo);
    cairo_translate(pen->cairo, x, y);
    cairo_rotate(pen->cairo, -0.5);
    cairo_scale(pen->cairo, size / 1.6, size / 1.6);
    outline(pen, style, STROKES, sizeof STROKES / sizeof STROKES[0], 0.075);
    line(pen, style);
    for (int i = 0; i < 3; i++) { /* between the knuckles */
        double at = 0.145 + 0.16 * i + 0.004 * i;
        BRUSH(pen, 0.03, 0.06, 0.02, {at, 0.74 + 0.03 * i}, {at + 0.01, 0.86 + 0.02 * i}, {at + 0.02, 0.98});
    }
    cairo_restore(pen->cairo);
    cairo_pop_group_to_source(pen->cairo);
    cairo_paint_with_alpha(pen->cairo, alpha);
    cairo_restore(pen->cairo);
}
