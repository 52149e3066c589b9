#include "pen.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "ink.h"
#include "ink_table.h"

const struct pen_colour pen_paper = {0.988, 0.978, 0.957}, pen_dark = {0.17, 0.16, 0.2};

/* One of each script, so that no machine's settings choose; what else there is comes after. A weight that is a family
 * of its own comes first. */
#define FONTS "Quicksand,Noto Sans Arabic UI,MotoyaLMaru,DejaVu Sans,Sans"

bool pen_open(struct pen *pen, int width, int height)
{
    *pen = (struct pen){.surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height)};
    pen->cairo = cairo_create(pen->surface);
    if (cairo_status(pen->cairo) != CAIRO_STATUS_SUCCESS) {
        pen_close(pen, NULL);
        return false;
    }
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    pen->layout = pango_cairo_create_layout(pen->cairo);
    pango_cairo_context_set_font_options(pango_layout_get_context(pen->layout), options);
    pango_context_set_round_glyph_positions(pango_layout_get_context(pen->layout), FALSE);
    cairo_font_options_destroy(options);
    cairo_set_line_cap(pen->cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(pen->cairo, CAIRO_LINE_JOIN_ROUND);
    return true;
}

void pen_rgba(const uint8_t *from, int stride, int width, int height, uint8_t *rgba)
{
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++, rgba += 4) {
            uint32_t pixel;
            memcpy(&pixel, from + (size_t)y * (size_t)stride + 4 * (size_t)x, sizeof pixel);
            rgba[0] = (uint8_t)(pixel >> 16);
            rgba[1] = (uint8_t)(pixel >> 8);
            rgba[2] = (uint8_t)pixel;
            rgba[3] = (uint8_t)(pixel >> 24);
        }
    }
}

void pen_close(struct pen *pen, uint8_t *rgba)
{
    if (rgba) {
        cairo_surface_flush(pen->surface);
        pen_rgba(cairo_image_surface_get_data(pen->surface), cairo_image_surface_get_stride(pen->surface),
                 cairo_image_surface_get_width(pen->surface), cairo_image_surface_get_height(pen->surface), rgba);
    }
    if (pen->layout) {
        g_object_unref(pen->layout);
    }
    cairo_destroy(pen->cairo);
    cairo_surface_destroy(pen->surface);
    *pen = (struct pen){.surface = NULL};
}

void pen_set(const struct pen *pen, struct pen_colour colour, double alpha)
{
    cairo_set_source_rgba(pen->cairo, colour.red, colour.green, colour.blue, alpha);
}

struct pen_colour pen_between(struct pen_colour from, struct pen_colour to, double share)
{
    return (struct pen_colour){from.red + share * (to.red - from.red), from.green + share * (to.green - from.green),
                               from.blue + share * (to.blue - from.blue)};
}

struct pen_colour pen_ink(int ink, int mixing, double thickness)
{
    const int mixed[INK_PALETTE] = {ink, ink, ink, ink}; /* of the others there is nothing */
    const float thick[INK_PALETTE] = {(float)thickness};
    float rgb[3];
    if (mixing == INK_CMY) {
        ink_mix_cmy(mixed, thick, rgb);
        return (struct pen_colour){(double)rgb[0], (double)rgb[1], (double)rgb[2]};
    }
    ink_mix(mixed, thick, rgb);
    return (struct pen_colour){(double)ink_encode(fminf(rgb[0], 1)), (double)ink_encode(fminf(rgb[1], 1)),
                               (double)ink_encode(fminf(rgb[2], 1))};
}

double pen_luminance(struct pen_colour colour)
{
    return 0.2126 * (double)ink_decode((float)colour.red) + 0.7152 * (double)ink_decode((float)colour.green) +
           0.0722 * (double)ink_decode((float)colour.blue);
}

double pen_chance(unsigned seed, unsigned index)
{
    uint64_t key = pen_hash_int(pen_hash_int(PEN_KEY, seed), index);
    key ^= key >> 29;
    key *= UINT64_C(0xbf58476d1ce4e5b9);
    return (double)(key >> 11) / (double)(UINT64_C(1) << 53);
}

/* The place of a curve through points (Catmull and Rom 1974) at t points from the first. */
static void curve_at(const double (*points)[2], int count, double t, double *x, double *y)
{
    int i = (int)fmin(floor(t), count - 2);
    double u = t - i, place[2];
    const double *a = points[i > 0 ? i - 1 : 0], *b = points[i], *c = points[i + 1];
    const double *d = points[i + 2 < count ? i + 2 : count - 1];
    for (int k = 0; k < 2; k++) {
        place[k] =
            0.5 *
            (2 * b[k] +
             u * (c[k] - a[k] + u * (2 * a[k] - 5 * b[k] + 4 * c[k] - d[k] + u * (3 * b[k] - a[k] - 3 * c[k] + d[k]))));
    }
    *x = place[0];
    *y = place[1];
}

void pen_brush(const struct pen *pen, const double (*points)[2], int count, double first, double middle, double last)
{
    enum { STEPS = 12 };
    int steps = STEPS * (count - 1);
    double x, y, old_x = 0, old_y = 0, old = 0;
    cairo_new_path(pen->cairo);
    for (int i = 0; i <= steps; i++) {
        double share = (double)i / steps;
        double width = share < 0.5 ? first + 2 * share * (middle - first) : middle + (2 * share - 1) * (last - middle);
        double half = 0.5 * width;
        curve_at(points, count, (double)i / STEPS, &x, &y);
        double length = hypot(x - old_x, y - old_y);
        cairo_new_sub_path(pen->cairo);
        cairo_arc(pen->cairo, x, y, fmax(half, 1e-4), 0, 2 * G_PI);
        if (i > 0 && length > 1e-9) {
            double nx = -(y - old_y) / length, ny = (x - old_x) / length;
            cairo_move_to(pen->cairo, old_x - nx * old, old_y - ny * old); /* turns as the discs do */
            cairo_line_to(pen->cairo, x - nx * half, y - ny * half);
            cairo_line_to(pen->cairo, x + nx * half, y + ny * half);
            cairo_line_to(pen->cairo, old_x + nx * old, old_y + ny * old);
            cairo_close_path(pen->cairo);
        }
        old_x = x;
        old_y = y;
        old = half;
    }
    cairo_fill(pen->cairo);
}

void pen_blot(const struct pen *pen, double x, double y, double radius, double wave, unsigned seed)
{
    enum { STEPS = 96, WAVES = 5 };
    cairo_new_sub_path(pen->cairo);
    for (int i = 0; i < STEPS; i++) {
        double angle = 2 * G_PI * i / STEPS, r = 1;
        for (unsigned k = 0; k < WAVES; k++) {
            r += wave / (1 + 0.6 * k) * (pen_chance(seed, 2 * k) - 0.3) *
                 sin((k + 2) * angle + 2 * G_PI * pen_chance(seed, 2 * k + 1));
        }
        cairo_line_to(pen->cairo, x + r * radius * cos(angle), y + r * radius * sin(angle));
    }
    cairo_close_path(pen->cairo);
}

/* The edge of a card, a share of its whole length on: where it is, and which way is out. */
static void card_edge(double width, double height, double radius, double at, double place[4])
{
    double across = width - 2 * radius, down = height - 2 * radius, arc = 0.5 * G_PI * radius;
    const double lengths[4] = {across, down, across, down};
    int side = 0;
    while (side < 3 && at > lengths[side] + arc) {
        at -= lengths[side++] + arc;
    }
    /* As if this side were the upper one, then turned. */
    double w = side % 2 ? height : width, h = side % 2 ? width : height;
    double x = fmin(at, lengths[side]) - 0.5 * w + radius, y = -0.5 * h, nx = 0, ny = -1;
    if (at > lengths[side] && arc > 0) {
        double angle = fmin((at - lengths[side]) / arc, 1) * 0.5 * G_PI;
        nx = sin(angle);
        ny = -cos(angle);
        x = 0.5 * w - radius + radius * nx;
        y = -0.5 * h + radius + radius * ny;
    }
    const double turned[4][4] = {{x, y, nx, ny}, {-y, x, -ny, nx}, {-x, -y, -nx, -ny}, {y, -x, ny, -nx}};
    memcpy(place, turned[side], sizeof turned[side]);
}

void pen_card(const struct pen *pen, double x, double y, double width, double height, double radius, double wave,
              unsigned seed)
{
    radius = fmin(radius, 0.5 * fmin(width, height));
    double length = 2 * (width + height - 4 * radius) + 2 * G_PI * radius;
    int steps = (int)fmax(64, length / 3);
    cairo_new_sub_path(pen->cairo);
    for (int i = 0; i < steps; i++) {
        double place[4], at = length * i / steps, turn = 2 * G_PI * i / steps;
        card_edge(width, height, radius, at, place);
        double out = 0;
        for (unsigned k = 0; k < 4 && wave > 0; k++) {
            double frequency = 5 + 11 * k + floor(5 * pen_chance(seed, k));
            out += wave * (0.4 - 0.08 * k) * sin(frequency * turn + 2 * G_PI * pen_chance(seed, 8 + k));
        }
        cairo_line_to(pen->cairo, x + 0.5 * width + place[0] + out * place[2],
                      y + 0.5 * height + place[1] + out * place[3]);
    }
    cairo_close_path(pen->cairo);
}

void pen_draw_card(const struct pen *pen, double x, double y, double width, double height, double radius, double shadow,
                   double alpha)
{
    enum { LAYERS = 10 };
    unsigned seed = 7;
    double wave = 0.12 * shadow;
    /* A shadow as of many lamps, thin and wide; none of it under the card, which lets the painting through. */
    cairo_push_group(pen->cairo);
    for (int i = 0; i < LAYERS; i++) {
        double grow = shadow * (1 - (i + 1.0) / (LAYERS + 1)) - 0.15 * shadow;
        pen_card(pen, x - grow, y - grow + 0.15 * shadow, width + 2 * grow, height + 2 * grow, radius + grow, 0, 0);
        pen_set(pen, pen_dark, 0.028);
        cairo_fill(pen->cairo);
    }
    cairo_set_operator(pen->cairo, CAIRO_OPERATOR_DEST_OUT);
    pen_card(pen, x, y, width, height, radius, wave, seed);
    pen_set(pen, pen_dark, 1);
    cairo_fill(pen->cairo);
    cairo_pop_group_to_source(pen->cairo);
    cairo_paint(pen->cairo);
    pen_card(pen, x, y, width, height, radius, wave, seed);
    pen_set(pen, pen_paper, alpha);
    cairo_fill_preserve(pen->cairo);
    pen_set(pen, pen_dark, 0.14);
    cairo_set_line_width(pen->cairo, fmax(1, 0.06 * shadow));
    cairo_stroke(pen->cairo);
}

static int measure_width(const struct pen *pen)
{
    int width;
    pango_layout_get_size(pen->layout, &width, NULL);
    return width;
}

/* Where a text is best broken in two, after a mark that ends a part of it: bytes, 0 for nowhere. */
static size_t find_break(const char *text)
{
    static const char *const MARKS[] = {". ", "! ", "? ", ": ", ", ", "\xe3\x80\x81", "\xe3\x80\x82"};
    size_t length = strlen(text), best = 0;
    for (size_t i = 0; i < sizeof MARKS / sizeof MARKS[0]; i++) {
        for (const char *found = text; (found = strstr(found, MARKS[i]));) {
            found += strlen(MARKS[i]);
            size_t at = (size_t)(found - text), other = best > length - best ? best : length - best;
            if ((at > length - at ? at : length - at) < other && at < length) {
                best = at;
            }
        }
    }
    return best;
}

/* Breaks there, if both parts then fit. */
static bool break_at_mark(const struct pen *pen, const struct pen_words *words)
{
    char broken[400];
    size_t at = find_break(words->text), length = strlen(words->text);
    if (at == 0 || length + 2 > sizeof broken) {
        return false;
    }
    snprintf(broken, sizeof broken, "%.*s\n%s", (int)at, words->text, words->text + at);
    pango_layout_set_text(pen->layout, broken, -1);
    if (measure_width(pen) <= words->width * PANGO_SCALE) {
        return true;
    }
    pango_layout_set_text(pen->layout, words->text, -1);
    return false;
}

/* The narrowest that takes no more lines: they come out about the same length. */
static void balance(const struct pen *pen, int most)
{
    int least = 0;
    pango_layout_set_width(pen->layout, most);
    int lines = pango_layout_get_line_count(pen->layout);
    for (int i = 0; i < 8; i++) {
        int middle = least + (most - least) / 2;
        pango_layout_set_width(pen->layout, middle);
        bool fits = pango_layout_get_line_count(pen->layout) <= lines && measure_width(pen) <= middle;
        *(fits ? &most : &least) = middle;
    }
    pango_layout_set_width(pen->layout, most);
}

static void set_text(const struct pen *pen, const char *text)
{
    if (g_utf8_validate(text, -1, NULL)) {
        pango_layout_set_text(pen->layout, text, -1);
    } else { /* the name of a device, say */
        char *valid = g_utf8_make_valid(text, -1);
        pango_layout_set_text(pen->layout, valid, -1);
        g_free(valid);
    }
}

/* Fonts differ in the height of their lines: some leave a gap, some none. */
static void space_lines(const struct pen *pen, double size)
{
    PangoRectangle line;
    pango_layout_line_get_extents(pango_layout_get_line_readonly(pen->layout, 0), NULL, &line);
    double high = fmax((double)line.height / PANGO_SCALE, 1);
    pango_layout_set_line_spacing(pen->layout, (float)(fmax(0.95 * high, 1.2 * size) / high));
}

static void set_words(const struct pen *pen, const struct pen_words *words)
{
    PangoFontDescription *font = pango_font_description_from_string(words->bold ? FONTS : "Quicksand Medium," FONTS);
    PangoContext *context = pango_layout_get_context(pen->layout);
    pango_font_description_set_weight(font, words->bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    pango_font_description_set_absolute_size(font, words->size * PANGO_SCALE);
    pango_context_set_language(context, pango_language_from_string(words->tag));
    pango_layout_set_font_description(pen->layout, font);
    pango_font_description_free(font);
    pango_layout_set_alignment(pen->layout, PANGO_ALIGN_CENTER);
    pango_layout_set_wrap(pen->layout, PANGO_WRAP_WORD);
    pango_layout_set_width(pen->layout, -1);
    set_text(pen, words->text);
    space_lines(pen, words->size);
    if (words->width > 0 && measure_width(pen) > words->width * PANGO_SCALE && !break_at_mark(pen, words)) {
        balance(pen, (int)(words->width * PANGO_SCALE));
    }
}

int pen_measure(const struct pen *pen, const struct pen_words *words, double *width, double *height)
{
    int wide, high;
    set_words(pen, words);
    pango_layout_get_size(pen->layout, &wide, &high);
    *width = (double)wide / PANGO_SCALE;
    *height = (double)high / PANGO_SCALE;
    return pango_layout_get_line_count(pen->layout);
}

/* Sets the point where the layout begins so that its middle is at x, y. */
static void move_to_middle(const struct pen *pen, const struct pen_words *words, double x, double y)
{
    PangoRectangle logical;
    set_words(pen, words);
    pango_layout_get_extents(pen->layout, NULL, &logical);
    cairo_move_to(pen->cairo, x - (logical.x + 0.5 * logical.width) / PANGO_SCALE,
                  y - (logical.y + 0.5 * logical.height) / PANGO_SCALE);
}

void pen_write(const struct pen *pen, const struct pen_words *words, double x, double y)
{
    move_to_middle(pen, words, x, y);
    pango_cairo_show_layout(pen->cairo, pen->layout);
}

void pen_write_haloed(const struct pen *pen, const struct pen_words *words, double x, double y)
{
    cairo_save(pen->cairo);
    for (int i = 3; i >= 1; i--) {
        cairo_new_path(pen->cairo);
        move_to_middle(pen, words, x, y);
        pango_cairo_layout_path(pen->cairo, pen->layout);
        pen_set(pen, pen_paper, 0.4);
        cairo_set_line_width(pen->cairo, 0.13 * i * words->size);
        cairo_stroke(pen->cairo);
    }
    cairo_restore(pen->cairo);
    pen_set(pen, pen_dark, 1);
    pen_write(pen, words, x, y);
}

void pen_write_cut(const struct pen *pen, const struct pen_words *words, double x, double y, double width)
{
    struct pen_words small = *words;
    double wide, high;
    small.width = 0;
    pen_measure(pen, &small, &wide, &high);
    if (wide > width) {
        small.size *= 0.62;
    }
    set_words(pen, &small);
    pango_layout_set_alignment(pen->layout, PANGO_ALIGN_LEFT);
    pango_layout_set_wrap(pen->layout, PANGO_WRAP_WORD_CHAR);
    pango_layout_set_width(pen->layout, (int)(fmax(width, 1) * PANGO_SCALE));
    pango_layout_set_height(pen->layout, wide > width ? -2 : -1);
    pango_layout_set_ellipsize(pen->layout, PANGO_ELLIPSIZE_END);
    int rows;
    pango_layout_get_size(pen->layout, NULL, &rows);
    cairo_move_to(pen->cairo, x, y - 0.5 * rows / PANGO_SCALE);
    pango_cairo_show_layout(pen->cairo, pen->layout);
    pango_layout_set_ellipsize(pen->layout, PANGO_ELLIPSIZE_NONE);
    pango_layout_set_height(pen->layout, -1);
}

int pen_unknown(const struct pen *pen, const struct pen_words *words)
{
    set_words(pen, words);
    return pango_layout_get_unknown_glyphs_count(pen->layout);
}

uint64_t pen_hash(uint64_t key, const void *data, size_t size)
{
    for (const unsigned char *c = data; size > 0; size--, c++) {
        key = (key ^ *c) * UINT64_C(0x100000001b3);
    }
    return key;
}

uint64_t pen_hash_text(uint64_t key, const char *text)
{
    return pen_hash(key, text, strlen(text) + 1);
}

uint64_t pen_hash_int(uint64_t key, int64_t value)
{
    return pen_hash(key, &value, sizeof value);
}
