#include "svg.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>

struct svg_fill svg_fill(const float rgb[3])
{
    struct svg_fill fill;
    unsigned part[3];
    for (int c = 0; c < 3; c++) {
        part[c] = rgb[c] > 0 ? rgb[c] < 1 ? (unsigned)(255 * rgb[c] + 0.5f) : 255 : 0;
    }
    snprintf(fill.text, sizeof fill.text, "#%02x%02x%02x", part[0] & 255u, part[1] & 255u, part[2] & 255u);
    return fill;
}

static void put_side(struct file_text *text, const struct svg_place *places, int32_t count, bool back)
{
    for (int32_t k = 0; k < count; k++) {
        int32_t i = back ? count - 1 - k : k;
        const struct svg_place *a = &places[i > 0 ? i - 1 : 0], *b = &places[i + 1 < count ? i + 1 : i];
        float dx = b->x - a->x, dy = b->y - a->y, length = sqrtf(dx * dx + dy * dy);
        float side = (back ? -1.0f : 1.0f) * places[i].radius / (length > 1e-6f ? length : 1);
        file_text_put(text, "%c%.2f %.2f", k == 0 && !back ? 'M' : 'L', (double)(places[i].x - dy * side),
                      (double)(places[i].y + dx * side));
    }
}

void svg_outline(struct file_text *text, const struct svg_place *places, int32_t count)
{
    put_side(text, places, count, false);
    put_side(text, places, count, true);
    file_text_put(text, "Z");
}
