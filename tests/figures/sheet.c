#include "sheet.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <pango/pangocairo.h>

enum { GAP = 10, TITLE = 34, LABEL = 54 };

struct sheet {
    const struct figure *figure;
    cairo_surface_t *surface;
    cairo_t *cairo;
    PangoLayout *layout;
    int columns, rows, side, count;
};

static void write_text(struct sheet *sheet, const char *font, const char *text, int x, int y, int width)
{
    PangoFontDescription *description = pango_font_description_from_string(font);
    pango_layout_set_font_description(sheet->layout, description);
    pango_font_description_free(description);
    pango_layout_set_width(sheet->layout, width * PANGO_SCALE);
    pango_layout_set_height(sheet->layout, -3);
    pango_layout_set_text(sheet->layout, text, -1);
    cairo_move_to(sheet->cairo, x, y);
    pango_cairo_show_layout(sheet->cairo, sheet->layout);
}

struct sheet *sheet_create(const struct figure *figure, const char *title, int columns, int rows, int side)
{
    struct sheet *sheet = calloc(1, sizeof *sheet);
    if (!sheet) {
        figure_stop("sheet", "no memory");
    }
    sheet->figure = figure;
    sheet->columns = columns;
    sheet->rows = rows;
    sheet->side = side;
    int width = GAP + columns * (side + GAP), height = TITLE + rows * (side + LABEL);
    sheet->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    sheet->cairo = cairo_create(sheet->surface);
    if (cairo_status(sheet->cairo) != CAIRO_STATUS_SUCCESS) {
        figure_stop("sheet", cairo_status_to_string(cairo_status(sheet->cairo)));
    }
    sheet->layout = pango_cairo_create_layout(sheet->cairo);
    pango_layout_set_ellipsize(sheet->layout, PANGO_ELLIPSIZE_END);
    cairo_set_source_rgb(sheet->cairo, 1, 1, 1);
    cairo_paint(sheet->cairo);
    cairo_set_source_rgb(sheet->cairo, 0, 0, 0);
    write_text(sheet, "Sans Bold 12px", title, GAP, GAP, width - 2 * GAP);
    return sheet;
}

void sheet_destroy(struct sheet *sheet)
{
    if (!sheet) {
        return;
    }
    g_object_unref(sheet->layout);
    cairo_destroy(sheet->cairo);
    cairo_surface_destroy(sheet->surface);
    free(sheet);
}

int sheet_side(const struct sheet *sheet)
{
    return sheet->side;
}

/* Cairo's RGB24 is 32 bits a pixel in the order of the machine. */
static void copy_pixels(struct sheet *sheet, const uint8_t *rgb, int x0, int y0)
{
    cairo_surface_flush(sheet->surface);
    unsigned char *pixels = cairo_image_surface_get_data(sheet->surface);
    int stride = cairo_image_surface_get_stride(sheet->surface);
    for (int y = 0; y < sheet->side; y++) {
        for (int x = 0; x < sheet->side; x++, rgb += 3) {
            uint32_t pixel = (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
            memcpy(pixels + (ptrdiff_t)(y0 + y) * stride + (ptrdiff_t)(x0 + x) * 4, &pixel, sizeof pixel);
        }
    }
    cairo_surface_mark_dirty(sheet->surface);
}

void sheet_add(struct sheet *sheet, const uint8_t *rgb, const char *label, ...)
{
    if (sheet->count == sheet->columns * sheet->rows) {
        figure_stop("sheet", "more pictures than it has room for");
    }
    int x = GAP + sheet->count % sheet->columns * (sheet->side + GAP);
    int y = TITLE + sheet->count / sheet->columns * (sheet->side + LABEL);
    copy_pixels(sheet, rgb, x, y);
    cairo_set_source_rgb(sheet->cairo, 0.8, 0.8, 0.8);
    cairo_set_line_width(sheet->cairo, 1);
    cairo_rectangle(sheet->cairo, x - 0.5, y - 0.5, sheet->side + 1, sheet->side + 1);
    cairo_stroke(sheet->cairo);
    char text[256];
    va_list arguments;
    va_start(arguments, label);
    vsnprintf(text, sizeof text, label, arguments);
    va_end(arguments);
    cairo_set_source_rgb(sheet->cairo, 0, 0, 0);
    write_text(sheet, "Sans 11px", text, x, y + sheet->side + 3, sheet->side);
    for (char *line = text; (line = strchr(line, '\n'));) {
        *line = ';';
    }
    figure_note(sheet->figure, "%s", text);
    sheet->count++;
}

void sheet_finish(struct sheet *sheet)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.png", sheet->figure->out, sheet->figure->name);
    cairo_status_t status = cairo_surface_write_to_png(sheet->surface, path);
    if (status != CAIRO_STATUS_SUCCESS) {
        figure_stop(path, cairo_status_to_string(status));
    }
    sheet_destroy(sheet);
}
