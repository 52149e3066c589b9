/* Every kind of Laplacian growth as it looks, and what tells them apart. */
#include <stdlib.h>

#include "bolt_shape.h"
#include "figure.h"
#include "laplacian_figures.h"
#include "sheet.h"

enum { SHOWN = 560 };

struct looked {
    double cover;  /* share of the pixels that differ from the ground */
    double middle; /* height of their middle, 0 above to 1 below */
};

static struct looked look_at(const uint8_t *rgb)
{
    double count = 0, sum = 0;
    for (int i = 0; i < SHOWN * SHOWN; i++) {
        int far = 0;
        for (int c = 0; c < 3; c++) {
            far += abs(rgb[3 * i + c] - rgb[3 * (SHOWN - 1) + c]); /* its upper right corner is ground in all */
        }
        count += far > 90;
        sum += far > 90 ? (double)(i / SHOWN) / SHOWN : 0;
    }
    return (struct looked){count / (SHOWN * SHOWN), count > 0 ? sum / count : 0};
}

static void show(struct figure *figure, struct sheet *sheet, enum bolt_kind kind, uint8_t *rgb)
{
    static struct bolt bolt;
    enum laplacian_status status;
    bolt_preset(&bolt, kind, SHOWN, SHOWN);
    struct laplacian *laplacian = laplacian_create(&bolt.growth, &status);
    struct bolt_sight sight = bolt_sight_of(&bolt, SHOWN, SHOWN);
    struct bolt_shape shape = {0};
    struct bolt_view view = {.width = SHOWN, .height = SHOWN, .look = bolt.look};
    struct laplacian_figures figures = {0};
    while (laplacian && laplacian_step(laplacian, 4096) > 0) {
    }
    if (!laplacian || !bolt_shape_make(&shape, laplacian, &bolt.look, &sight) ||
        !laplacian_measure(laplacian, &figures)) {
        figure_stop(bolt_kind_names[kind], "cannot grow");
    }
    view.look.life = 0;
    struct bolt_segment *segments = bolt_shape_segments(&shape, &bolt.look, 0, &view.count);
    view.segments = segments;
    if (!segments || !bolt_light_lay(&view, 1e6, SHOWN, SHOWN, rgb)) {
        figure_stop(bolt_kind_names[kind], "no memory");
    }
    struct looked looked = look_at(rgb);
    sheet_add(sheet, rgb, "%s: %d particles, %d branches, dimension %.2f", bolt_kind_names[kind],
              laplacian_count(laplacian), shape.branches, figures.box_dimension);
    figure_check(figure, looked.cover > 0.01 && looked.cover < 0.75, "%s covers %.3f of the picture",
                 bolt_kind_names[kind], looked.cover);
    if (kind == BOLT_LIGHTNING) {
        figure_check(figure, laplacian_status(laplacian) == LAPLACIAN_HIT, "%s arrives", bolt_kind_names[kind]);
    }
    if (kind == BOLT_CORAL || kind == BOLT_TREE) {
        figure_check(figure, bolt.growth.dimensions == 3, "%s has depth", bolt_kind_names[kind]);
    }
    if (kind == BOLT_LICHEN) {
        figure_check(figure, figures.box_dimension > 1.5, "lichen is dense: %.2f", figures.box_dimension);
    }
    free(segments);
    bolt_shape_finish(&shape);
    laplacian_destroy(laplacian);
}

void figure_bolts(struct figure *figure)
{
    uint8_t *rgb = malloc((size_t)3 * SHOWN * SHOWN);
    struct sheet *sheet = sheet_create(figure, "Kinds of Laplacian growth", 4, 3, SHOWN);
    if (!rgb) {
        figure_stop("bolts", "no memory");
    }
    for (int kind = 0; kind < BOLT_KINDS; kind++) {
        show(figure, sheet, (enum bolt_kind)kind, rgb);
    }
    sheet_finish(sheet);
    free(rgb);
}
