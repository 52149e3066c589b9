/* A path for each branch: its outline, filled, and its widths beside it for those who draw with a pen. */
#include <stdlib.h>

#include "grow.h"
#include "growth_paint.h"
#include "svg.h"

/* `places`: room for all of its points. */
static void put_stroke(struct file_text *text, const struct stroke *stroke, const struct stroke_point *points,
                       struct svg_place *places, const float rgb[3])
{
    float least = points[0].radius, most = points[0].radius;
    for (int32_t i = 0; i < stroke->count; i++) {
        places[i] = (struct svg_place){points[i].x + 0.5f, points[i].y + 0.5f, points[i].radius};
        least = points[i].radius < least ? points[i].radius : least;
        most = points[i].radius > most ? points[i].radius : most;
    }
    file_text_put(text,
                  "<path class=\"%s\" fill=\"%s\" data-level=\"%d\" data-reach=\"%.1f\" data-width=\"%.2f %.2f\" d=\"",
                  stroke_names[stroke->kind], svg_fill(rgb).text, stroke->level, (double)stroke->reach,
                  (double)(2 * most), (double)(2 * least));
    svg_outline(text, places, stroke->count);
    file_text_put(text, "\"/>\n");
}

bool grow_write_svg(const struct grown *grown, const char *path, struct file_error *error)
{
    const struct growth *growth = grown->growth;
    const int width = growth->importance->width, height = growth->importance->height;
    struct growth_paint_def paint = {.width = width, .height = height, .scale = 1};
    struct growth_shade shade = {.growth = growth, .def = &paint};
    float ground[3];
    struct svg_place *places = malloc(((size_t)grown->strokes.point_count + 1) * sizeof *places);
    struct file_text text = {.failed = !places};
    growth_match(&shade);
    growth_ground(&shade, width / 2, height / 2, ground);
    file_text_put(&text,
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">\n",
                  grown->width, grown->height, width, height);
    if (!grown->background) {
        file_text_put(&text, "<rect width=\"100%%\" height=\"100%%\" fill=\"%s\"/>\n", svg_fill(ground).text);
    }
    for (int layer = growth->layer_count - 1; layer >= 0; layer--) {
        file_text_put(&text, "<g id=\"layer%d\" stroke-linejoin=\"round\">\n", layer);
        for (int32_t i = 0; i < grown->strokes.count; i++) {
            const struct stroke *stroke = &grown->strokes.strokes[i];
            if (stroke->layer != layer || stroke->count < 2 || text.failed) {
                continue;
            }
            float colour[3];
            for (int c = 0; c < 3; c++) {
                float leaf = shade.middle[c] + (shade.light[c] - shade.middle[c]) * stroke->tone;
                colour[c] = stroke->kind == STROKE_LEAF ? leaf : shade.middle[c];
                colour[c] += layer > 0 ? 0.42f * (shade.haze[c] - colour[c]) : 0;
            }
            put_stroke(&text, stroke, grown->strokes.points + stroke->first, places, colour);
        }
        file_text_put(&text, "</g>\n");
    }
    file_text_put(&text, "</svg>\n");
    free(places);
    return file_text_write(&text, path, error);
}
