/* The legend of attract: how to begin, without a word. */
#include <math.h>
#include <stdlib.h>

#include "hud_draw.h"
#include "hud_icon.h"
#include "hud_image.h"

/* What happens at which phase of HUD_PHASES. */
static const double TOUCHES = 5, LIFTS = 9, GONE = 14, GROWS = 6, GROWN = 20, FADES = 21;
static const double SIZE = 38; /* units: radius of what grows */

/* How far along from..to a phase is, 0..1, gently at both ends. */
static double along(double phase, double from, double to)
{
    double share = fmin(fmax((phase - from) / (to - from), 0), 1);
    return share * share * (3 - 2 * share);
}

enum { SEGMENTS = 4096, AGES = 8 };

struct frost {
    struct segment {
        float x, y, to_x, to_y; /* pixels */
        float width;
        int age; /* of AGES */
    } segments[SEGMENTS];
    int count;
    double reach, size; /* how far it has grown, how far it will; pixels */
    unsigned seed;
};

/* A branch from x, y, which is `from` pixels from the first drop as it grew; smaller ones leave it on both sides. */
static void grow(struct frost *frost, double x, double y, double angle, double length, double from, int order)
{
    static const int STEPS[] = {14, 7, 3};
    static const double WIDTH[] = {0.062, 0.045, 0.034}, SHARE[] = {0.5, 0.42};
    double step = length / STEPS[order];
    for (int i = 0; i < STEPS[order] && from + i * step < frost->reach && frost->count < SEGMENTS; i++) {
        double part = fmin(1, (frost->reach - from - i * step) / step), share = (double)i / STEPS[order];
        angle += 0.24 * (pen_chance(frost->seed, 1) - 0.5);
        double next_x = x + part * step * cos(angle), next_y = y + part * step * sin(angle);
        frost->segments[frost->count++] = (struct segment){(float)x,
                                                           (float)y,
                                                           (float)next_x,
                                                           (float)next_y,
                                                           (float)(frost->size * WIDTH[order] * (1 - 0.5 * share)),
                                                           (int)fmin((from + i * step) / frost->size * AGES, AGES - 1)};
        frost->seed++;
        x = next_x;
        y = next_y;
        if (part == 1 && order < 2 && i > (order == 0 ? 2 : 0)) { /* by turns to the left and to the right */
            unsigned seed = frost->seed;
            int side = (int)(seed % 2) * 2 - 1;
            double left = length * SHARE[order] * (1 - share) * (0.75 + 0.5 * pen_chance(seed, 3));
            frost->seed = seed * 31;
            grow(frost, x, y, angle + side * (0.65 + 0.3 * pen_chance(seed, 2)), left, from + (i + 1) * step,
                 order + 1);
            frost->seed = seed;
        }
    }
}

/* A needle with pointed ends. */
static void add_needle(cairo_t *cairo, const struct segment *segment)
{
    double x = (double)segment->x, y = (double)segment->y, to_x = (double)segment->to_x, to_y = (double)segment->to_y;
    double length = fmax(hypot(to_x - x, to_y - y), 1e-6), half = 0.5 * (double)segment->width;
    double ux = half * (to_x - x) / length, uy = half * (to_y - y) / length;
    cairo_move_to(cairo, x - ux, y - uy);
    cairo_line_to(cairo, x + uy, y - ux);
    cairo_line_to(cairo, to_x + uy, to_y - ux);
    cairo_line_to(cairo, to_x + ux, to_y + uy);
    cairo_line_to(cairo, to_x - uy, to_y + ux);
    cairo_line_to(cairo, x - uy, y + ux);
    cairo_close_path(cairo);
}

/* All of one age at once: a stroke each would take several times as long. */
static void fill_all(const struct pen *pen, const struct frost *frost, struct pen_colour thick, struct pen_colour thin)
{
    for (int age = AGES - 1; age >= 0; age--) {
        for (int i = 0; i < frost->count; i++) {
            if (frost->segments[i].age == age) {
                add_needle(pen->cairo, &frost->segments[i]);
            }
        }
        pen_set(pen, pen_between(thick, thin, (age + 0.5) / AGES), 1);
        cairo_fill(pen->cairo);
    }
}

static void draw_frost(const struct hud *hud, const struct pen *pen, double x, double y, double size, double share)
{
    enum { ARMS = 8 };
    struct frost frost = {.size = size, .reach = 1.1 * size * share};
    for (int arm = 0; arm < ARMS && share > 0; arm++) {
        frost.seed = 902 + 17 * (unsigned)arm;
        double angle = 2 * G_PI * (arm + 0.5 * (pen_chance(frost.seed, 0) - 0.5)) / ARMS;
        grow(&frost, x, y, angle, size * (0.78 + 0.25 * pen_chance(frost.seed, 9)), 0, 0);
    }
    fill_all(pen, &frost, hud_ink_colour(hud, 0, 1.7), hud_ink_colour(hud, 0, 0.45));
}

static void draw_rings(const struct pen *pen, double phase, double x, double y, double unit)
{
    for (int i = 0; i < 3; i++) {
        double share = (phase - TOUCHES - 1.6 * i) / 6;
        if (share > 0 && share < 1) {
            cairo_new_path(pen->cairo);
            cairo_arc(pen->cairo, x, y, (4 + 30 * sqrt(share)) * unit, 0, 2 * G_PI);
            pen_set(pen, pen_dark, 0.5 * (1 - share));
            cairo_set_line_width(pen->cairo, (1.4 - share) * unit);
            cairo_stroke(pen->cairo);
        }
    }
}

/* Light behind it, so that it is seen on any painting, without an edge of its own. Drawn small and made large: it is
 * smooth, and a gradient costs ten times a copy. */
static void draw_glow(const struct pen *pen, double width, double height)
{
    enum { SMALL = 96 };
    static const double STOPS[][2] = {{0, 0.96}, {0.45, 0.92}, {0.62, 0.76}, {0.8, 0.34}, {0.92, 0.08}, {1, 0}};
    const struct pen_colour *paper = &pen_paper;
    cairo_pattern_t *glow =
        cairo_pattern_create_radial(0.5 * SMALL, 0.5 * SMALL, 0, 0.5 * SMALL, 0.5 * SMALL, 0.5 * SMALL - 1);
    for (size_t i = 0; i < sizeof STOPS / sizeof STOPS[0]; i++) {
        cairo_pattern_add_color_stop_rgba(glow, STOPS[i][0], paper->red, paper->green, paper->blue, STOPS[i][1]);
    }
    cairo_surface_t *small = cairo_surface_create_similar_image(pen->surface, CAIRO_FORMAT_ARGB32, SMALL, SMALL);
    cairo_t *inner = cairo_create(small);
    cairo_set_source(inner, glow);
    cairo_paint(inner);
    cairo_destroy(inner);
    cairo_save(pen->cairo);
    cairo_scale(pen->cairo, width / SMALL, height / SMALL);
    cairo_set_source_surface(pen->cairo, small, 0, 0);
    cairo_pattern_set_filter(cairo_get_source(pen->cairo), CAIRO_FILTER_BILINEAR);
    cairo_paint(pen->cairo);
    cairo_restore(pen->cairo);
    cairo_surface_destroy(small);
    cairo_pattern_destroy(glow);
}

/* One phase of the loop around x, y. */
static void draw_phase(const struct hud *hud, const struct pen *pen, double phase, double x, double y, double unit)
{
    double seen = 1 - along(phase, FADES, HUD_PHASES), down = along(phase, -1, TOUCHES);
    double up = along(phase, LIFTS, GONE), away = 22 * unit * (1 - down + 0.8 * up);
    struct hud_icon_style style = {.line = pen_dark, .ground = {1, 1, 1}};
    style.wet = hud_ink_colour(hud, 0, 1);
    cairo_save(pen->cairo);
    cairo_rectangle(pen->cairo, x - 1.2 * SIZE * unit, y - 1.2 * SIZE * unit, 2.4 * SIZE * unit, 2.4 * SIZE * unit);
    cairo_clip(pen->cairo);
    cairo_push_group(pen->cairo);
    draw_frost(hud, pen, x, y, SIZE * unit, along(phase, GROWS - 1, GROWN) * (phase >= GROWS));
    if (phase >= TOUCHES) {
        pen_blot(pen, x, y, (2.2 + 2 * along(phase, TOUCHES, TOUCHES + 3)) * unit, 0.1, 31);
        pen_set(pen, style.wet, 1);
        cairo_fill(pen->cairo);
    }
    cairo_pop_group_to_source(pen->cairo);
    cairo_paint_with_alpha(pen->cairo, seen);
    cairo_restore(pen->cairo);
    draw_rings(pen, phase, x, y, unit);
    if (up < 1) {
        hud_icon_finger(pen, x + 0.8 * away, y + away, 44 * unit, &style, fmin(along(phase, -2, 3), 1 - up));
    }
}

/* Light and words, which stay while the picture moves: kept in the image. False when memory is short. */
static bool lay_ground(struct hud_image *image, uint64_t key, const struct pen_words *words, int width, int height,
                       double middle)
{
    struct pen pen;
    if (image->ground && image->ground_key == key) {
        return true;
    }
    if (!pen_open(&pen, width, height)) {
        return false;
    }
    draw_glow(&pen, width, height);
    pen_write_haloed(&pen, words, 0.5 * width, middle);
    cairo_surface_destroy(image->ground);
    image->ground = cairo_surface_reference(pen.surface);
    image->ground_key = key;
    pen_close(&pen, NULL);
    return true;
}

bool hud_draw_invite(const struct hud *hud, int phase, struct hud_image *image)
{
    struct pen pen;
    double unit = hud_unit(hud), mm = (double)hud->mm, wide, high;
    struct pen_words words = {.text = hud_text(hud, TEXT_INVITE), .tag = hud_tag(hud->language), .bold = true};
    int width = (int)fmin(ceil(210 * unit), hud->def.width), height = (int)fmin(ceil(176 * unit), hud->def.height);
    words.size = fmax(6 * mm, 13 * unit);
    words.width = 0.8 * width;
    uint64_t ground = pen_hash_text(hud_key(hud, PIECE_INVITE), words.text), key = pen_hash_int(ground, phase);
    if (!hud_image_begin(image, key, width, height, &pen)) {
        return false;
    }
    /* Picture and words together are in the middle. */
    pen_measure(&pen, &words, &wide, &high);
    double gap = 3 * unit, top = 0.5 * (height - (2 * SIZE * unit + gap + high));
    if (!lay_ground(image, ground, &words, width, height, top + 2 * SIZE * unit + gap + 0.5 * high)) {
        pen_close(&pen, NULL);
        return false;
    }
    cairo_set_source_surface(pen.cairo, image->ground, 0, 0);
    cairo_paint(pen.cairo);
    draw_phase(hud, &pen, phase, 0.5 * width, top + SIZE * unit, unit);
    int x = (hud->def.width - width) / 2;
    int y = (int)fmin(0.58 * hud->def.height - 0.5 * height, hud->def.height - height);
    return hud_image_end(image, key, x, y > 0 ? y : 0, &pen);
}
