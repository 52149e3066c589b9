/* A path for each branch: its outline, filled, and its widths beside it for those who draw with a pen. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "grow.h"
#include "growth_paint.h"

struct text {
    char *bytes;
    size_t size, room;
    bool failed;
};

static void put(struct text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void put(struct text *text, const char *format, ...)
{
    enum { LONGEST = 512 };
    if (text->size + LONGEST > text->room) {
        size_t room = 2 * text->room + 65536;
        char *more = realloc(text->bytes, room);
        if (!more) {
            text->failed = true;
            return;
        }
        text->bytes = more;
        text->room = room;
    }
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(text->bytes + text->size, LONGEST, format, arguments);
    va_end(arguments);
    text->size += length > 0 ? (size_t)length : 0;
}

/* One side of a stroke: its points moved across by the radius. */
static void put_side(struct text *text, const struct stroke_point *points, int32_t count, bool back)
{
    for (int32_t k = 0; k < count; k++) {
        int32_t i = back ? count - 1 - k : k;
        const struct stroke_point *a = &points[i > 0 ? i - 1 : 0], *b = &points[i + 1 < count ? i + 1 : i];
        float dx = b->x - a->x, dy = b->y - a->y, length = sqrtf(dx * dx + dy * dy);
        float side = (back ? -1.0f : 1.0f) * points[i].radius / (length > 1e-6f ? length : 1);
        put(text, "%c%.2f %.2f", k == 0 && !back ? 'M' : 'L', (double)(points[i].x + 0.5f - dy * side),
            (double)(points[i].y + 0.5f + dx * side));
    }
}

static void put_stroke(struct text *text, const struct stroke *stroke, const struct stroke_point *points,
                       const char *fill)
{
    float least = points[0].radius, most = points[0].radius;
    for (int32_t i = 1; i < stroke->count; i++) {
        least = points[i].radius < least ? points[i].radius : least;
        most = points[i].radius > most ? points[i].radius : most;
    }
    put(text, "<path class=\"%s\" fill=\"%s\" data-level=\"%d\" data-reach=\"%.1f\" data-width=\"%.2f %.2f\" d=\"",
        stroke_names[stroke->kind], fill, stroke->level, (double)stroke->reach, (double)(2 * most),
        (double)(2 * least));
    put_side(text, points, stroke->count, false);
    put_side(text, points, stroke->count, true);
    put(text, "Z\"/>\n");
}

static void fill_of(const float rgb[3], char fill[8])
{
    int part[3];
    for (int c = 0; c < 3; c++) {
        float value = rgb[c] < 0 ? 0 : rgb[c] > 1 ? 1 : rgb[c];
        part[c] = (int)(255 * value + 0.5f);
    }
    snprintf(fill, 8, "#%02x%02x%02x", (unsigned)part[0] & 255u, (unsigned)part[1] & 255u, (unsigned)part[2] & 255u);
}

bool grow_write_svg(const struct grown *grown, const char *path, struct file_error *error)
{
    const struct growth *growth = grown->growth;
    const int width = growth->importance->width, height = growth->importance->height;
    struct growth_paint_def paint = {.width = width, .height = height, .scale = 1};
    struct growth_shade shade = {.growth = growth, .def = &paint};
    float ground[3];
    char fill[8];
    struct text text = {0};
    growth_match(&shade);
    growth_ground(&shade, width / 2, height / 2, ground);
    fill_of(ground, fill);
    put(&text, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">\n",
        grown->width, grown->height, width, height);
    if (!grown->background) {
        put(&text, "<rect width=\"100%%\" height=\"100%%\" fill=\"%s\"/>\n", fill);
    }
    for (int layer = growth->layer_count - 1; layer >= 0; layer--) {
        put(&text, "<g id=\"layer%d\" stroke-linejoin=\"round\">\n", layer);
        for (int32_t i = 0; i < grown->strokes.count; i++) {
            const struct stroke *stroke = &grown->strokes.strokes[i];
            if (stroke->layer != layer || stroke->count < 2) {
                continue;
            }
            float colour[3];
            for (int c = 0; c < 3; c++) {
                float leaf = shade.middle[c] + (shade.light[c] - shade.middle[c]) * stroke->tone;
                colour[c] = stroke->kind == STROKE_LEAF ? leaf : shade.middle[c];
                colour[c] += layer > 0 ? 0.42f * (shade.haze[c] - colour[c]) : 0;
            }
            fill_of(colour, fill);
            put_stroke(&text, stroke, grown->strokes.points + stroke->first, fill);
        }
        put(&text, "</g>\n");
    }
    put(&text, "</svg>\n");
    bool good =
        text.failed ? file_fail(error, path, "memory is short") : file_write_atomic(path, text.bytes, text.size, error);
    free(text.bytes);
    return good;
}
