#include "legend.h"

#include <math.h>
#include <stdio.h>

#include <pango/pangocairo.h>

#include "pen.h"

const struct legend_text legend_texts[XRAY_LAYERS] = {
    [XRAY_CATALYST] = {"Catalyst", "food of growth"},
    [XRAY_ACTIVE] = {"Active", "where it grows now"},
    [XRAY_CARVED] = {"Carved", "depth"},
    [XRAY_SOLVENT] = {"Solvent", "density"},
    [XRAY_VELOCITY] = {"Solvent flow", "momentum"},
    [XRAY_GUIDANCE] = {"Guidance", "direction of growth"},
};

static const double LIGHT[3] = {0.93, 0.94, 0.95};
static const double DIM[3] = {0.62, 0.65, 0.7};

struct legend_pen {
    cairo_t *cairo;
    PangoLayout *layout;
    int text; /* height, pixels */
};

enum side { SIDE_LEFT, SIDE_MIDDLE, SIDE_RIGHT };

/* Makes a line ready. Returns its width, pixels. */
static int set_line(const struct legend_pen *pen, const char *text, double size, bool bold)
{
    PangoFontDescription *font = pango_font_description_from_string(bold ? "Sans Bold" : "Sans");
    int width = 0;
    pango_font_description_set_absolute_size(font, size * PANGO_SCALE);
    pango_layout_set_font_description(pen->layout, font);
    pango_font_description_free(font);
    pango_layout_set_text(pen->layout, text, -1);
    pango_layout_get_pixel_size(pen->layout, &width, NULL);
    return width;
}

/* One line whose left end, middle or right end is at x; its vertical middle at y. */
static void write_line(const struct legend_pen *pen, const char *text, double size, bool bold, const double colour[3],
                       double x, double y, enum side side)
{
    int width = set_line(pen, text, size, bold), height = 0;
    pango_layout_get_pixel_size(pen->layout, NULL, &height);
    double shift = side == SIDE_LEFT ? 0 : side == SIDE_MIDDLE ? 0.5 : 1;
    cairo_set_source_rgb(pen->cairo, colour[0], colour[1], colour[2]);
    cairo_move_to(pen->cairo, round(x - shift * width), round(y - 0.5 * height));
    pango_cairo_show_layout(pen->cairo, pen->layout);
}

static void paint(const struct legend_pen *pen, const uint8_t rgb[3], double x, double y, double width, double height)
{
    cairo_set_source_rgb(pen->cairo, rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0);
    cairo_rectangle(pen->cairo, x, y, width, height);
    cairo_fill(pen->cairo);
}

static void draw_title(const struct legend_pen *pen, const struct xray_box *box, const struct legend_text *text)
{
    double y = box->y + 0.5 * box->height;
    double unit = 0.75 * pen->text;
    int title = set_line(pen, text->title, pen->text, true);
    int taken = title + set_line(pen, text->unit, unit, false);
    write_line(pen, text->title, pen->text, true, LIGHT, box->x, y, SIDE_LEFT);
    /* Where the two do not fit, the title is worth more. */
    if (taken + pen->text / 2 <= box->width) {
        write_line(pen, text->unit, unit, false, DIM, box->x + title + 0.6 * pen->text, y + 0.1 * pen->text, SIDE_LEFT);
    }
}

static void draw_bar(const struct legend_pen *pen, const struct xray_box *box, enum xray_layer layer)
{
    const struct xray_scale *scale = &xray_scales[layer];
    double top = box->y + 0.35 * pen->text, high = 0.6 * pen->text;
    for (int x = 0; x < box->width; x++) {
        uint8_t rgb[3];
        xray_colour(layer, ((float)x + 0.5f) / (float)box->width, rgb);
        paint(pen, rgb, box->x + x, top, 1, high);
    }
    for (int i = 0; i <= 2; i++) {
        char number[32];
        snprintf(number, sizeof number, "%g", (double)scale->low + 0.5 * i * (double)(scale->high - scale->low));
        write_line(pen, number, 0.75 * pen->text, false, LIGHT, box->x + 0.5 * i * box->width,
                   top + high + 0.55 * pen->text, (enum side)i);
    }
}

/* Hue is direction: a wheel, dark in the middle; beside it what its rim stands for. */
static void draw_wheel(const struct legend_pen *pen, const struct xray_box *box, enum xray_layer layer)
{
    const struct xray_scale *scale = &xray_scales[layer];
    int radius = (box->height - pen->text / 3) / 2;
    int x = box->x + radius, y = box->y + pen->text / 3 + radius;
    char number[64];
    for (int j = -radius; j < radius; j++) {
        for (int i = -radius; i < radius; i++) {
            uint8_t rgb[3];
            float across = ((float)i + 0.5f) / (float)radius, down = ((float)j + 0.5f) / (float)radius;
            xray_vector_colour(across, down, rgb);
            if (across * across + down * down < 1) {
                paint(pen, rgb, x + i, y + j, 1, 1);
            }
        }
    }
    snprintf(number, sizeof number, "up to %g at the rim", (double)scale->high);
    write_line(pen, number, 0.75 * pen->text, false, LIGHT, x + radius + 0.6 * pen->text, y, SIDE_LEFT);
}

bool legend_draw(const struct xray_panel panels[XRAY_LAYERS], int width, int height, uint8_t *rgba)
{
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    struct legend_pen pen = {.cairo = cairo_create(surface), .text = xray_text(width, height)};
    bool good = cairo_status(pen.cairo) == CAIRO_STATUS_SUCCESS;
    if (good) {
        cairo_font_options_t *options = cairo_font_options_create();
        pen.layout = pango_cairo_create_layout(pen.cairo);
        cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
        pango_cairo_context_set_font_options(pango_layout_get_context(pen.layout), options);
        cairo_font_options_destroy(options);
        for (int i = 0; i < XRAY_LAYERS; i++) {
            draw_title(&pen, &panels[i].title, &legend_texts[i]);
            if (xray_scales[i].vector) {
                draw_wheel(&pen, &panels[i].scale, (enum xray_layer)i);
            } else {
                draw_bar(&pen, &panels[i].scale, (enum xray_layer)i);
            }
        }
        g_object_unref(pen.layout);
        cairo_surface_flush(surface);
        pen_rgba(cairo_image_surface_get_data(surface), cairo_image_surface_get_stride(surface), width, height, rgba);
    }
    cairo_destroy(pen.cairo);
    cairo_surface_destroy(surface);
    return good;
}
