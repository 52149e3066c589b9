#include "sitter.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ink.h"

enum { BLUR = 4, SHIFT = 45 };

struct sitter *sitter_draw(enum motif motif)
{
    struct sitter *sitter = calloc(1, sizeof *sitter);
    if (!sitter) {
        figure_stop("sitter", "no memory");
    }
    motif_draw(motif, SITTER_SIDE, SITTER_SIDE, sitter->linear);
    importance_grey(sitter->linear, SITTER_SIDE, SITTER_SIDE, 3, -1, sitter->grey);
    return sitter;
}

struct growth *sitter_grow(struct sitter *sitter, const struct growth_def *def)
{
    struct growth *growth = growth_create(sitter->grey, SITTER_SIDE, SITTER_SIDE, def);
    if (!growth) {
        figure_stop("sitter", "no memory");
    }
    return growth;
}

static void to_bytes(struct sitter *sitter)
{
    for (int i = 0; i < 3 * SITTER_SHOWN * SITTER_SHOWN; i++) {
        float value = 255 * sitter->rgb[i] + 0.5f;
        sitter->bytes[i] = (uint8_t)(value < 0 ? 0 : value > 255 ? 255 : value);
    }
}

void sitter_paint(struct sitter *sitter, const struct growth *growth, const struct growth_paint_def *def)
{
    struct strokes strokes = {0};
    if (!growth_strokes(growth, &strokes) || !growth_paint(growth, &strokes, def, sitter->rgb)) {
        figure_stop("sitter", "no memory");
    }
    strokes_finish(&strokes);
    to_bytes(sitter);
}

void sitter_paint_whole(struct sitter *sitter, const struct growth *growth)
{
    const struct growth_paint_def def = {
        .width = SITTER_SHOWN, .height = SITTER_SHOWN, .scale = (float)SITTER_SHOWN / SITTER_SIDE, .grown = FLT_MAX};
    sitter_paint(sitter, growth, &def);
}

/* A plane of the picture, as grey. */
void sitter_show_plane(struct sitter *sitter, const float *plane)
{
    for (int y = 0; y < SITTER_SHOWN; y++) {
        for (int x = 0; x < SITTER_SHOWN; x++) {
            for (int c = 0; c < 3; c++) {
                sitter->rgb[3 * (y * SITTER_SHOWN + x) + c] =
                    plane[y * SITTER_SIDE / SITTER_SHOWN * SITTER_SIDE + x * SITTER_SIDE / SITTER_SHOWN];
            }
        }
    }
    to_bytes(sitter);
}

static void blur(float *plane)
{
    static float other[SITTER_SIDE * SITTER_SIDE];
    for (int pass = 0; pass < 2; pass++) {
        for (int y = 0; y < SITTER_SIDE; y++) {
            for (int x = 0; x < SITTER_SIDE; x++) {
                float sum = 0;
                int count = 0;
                for (int k = -BLUR; k <= BLUR; k++) {
                    int u = pass ? x : x + k, v = pass ? y + k : y;
                    if (u >= 0 && v >= 0 && u < SITTER_SIDE && v < SITTER_SIDE) {
                        sum += plane[v * SITTER_SIDE + u];
                        count++;
                    }
                }
                other[y * SITTER_SIDE + x] = sum / (float)count;
            }
        }
        memcpy(plane, other, sizeof other);
    }
}

/* Correlation of two planes within a part, one of them moved sideways. */
static double correlate(const float *a, const float *b, int moved, struct rectangle part)
{
    double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0, n = 0;
    for (int y = part.y0; y < part.y1; y++) {
        for (int x = part.x0; x < part.x1; x++) {
            double p = (double)a[y * SITTER_SIDE + x], q = (double)b[y * SITTER_SIDE + (x + moved) % SITTER_SIDE];
            sa += p;
            sb += q;
            saa += p * p;
            sbb += q * q;
            sab += p * q;
            n++;
        }
    }
    return (sab - sa * sb / n) / sqrt((saa - sa * sa / n) * (sbb - sb * sb / n));
}

/* Blurred structure beside blurred importance, and beside importance that was moved. */
void sitter_check_seen(struct figure *figure, struct sitter *sitter, const struct growth *growth, const char *what,
                       double least, struct rectangle part)
{
    struct strokes strokes = {0};
    struct stroke_raster raster;
    if (!growth_strokes(growth, &strokes) || !stroke_raster_init(&raster, SITTER_SIDE, SITTER_SIDE, 1, 0, 0)) {
        figure_stop("sitter", "no memory");
    }
    for (int layer = 0; layer < growth->layer_count; layer++) {
        stroke_raster_draw(&raster, &strokes, layer, STROKE_BRANCH, FLT_MAX);
    }
    memcpy(sitter->ink, raster.cover, sizeof sitter->ink);
    memcpy(sitter->matter, growth->importance->values, sizeof sitter->matter);
    blur(sitter->ink);
    blur(sitter->matter);
    double seen = correlate(sitter->ink, sitter->matter, 0, part);
    double moved = correlate(sitter->ink, sitter->matter, SHIFT, part);
    figure_check(figure, seen > least && seen > moved + 0.15,
                 "%s: correlation with what matters %.2f, moved by %d pixels %.2f", what, seen, SHIFT, moved);
    stroke_raster_finish(&raster);
    strokes_finish(&strokes);
}

struct dendrite_figures sitter_check_sound(struct figure *figure, const struct growth *growth, const char *what)
{
    struct dendrite_figures first = {0};
    for (int layer = 0; layer < growth->layer_count; layer++) {
        struct dendrite_figures figures;
        if (!dendrite_measure(growth->layers[layer], growth->importance, &figures)) {
            figure_stop("sitter", "no memory");
        }
        figure_check(figure, figures.cycles == 0 && figures.components <= growth->seed_count && figures.endpoints > 200,
                     "%s: %d endpoints, %d pieces from %d seeds, %d cycles", what, figures.endpoints,
                     figures.components, growth->seed_count, figures.cycles);
        first = layer == 0 ? figures : first;
    }
    return first;
}

/* Figure 5: how early each place is reached, light first. */
void sitter_show_contours(struct sitter *sitter, const struct growth *growth)
{
    static float plane[SITTER_SIDE * SITTER_SIDE];
    static double values[SITTER_SIDE * SITTER_SIDE];
    double most = 0;
    for (int i = 0; i < SITTER_SIDE * SITTER_SIDE; i++) {
        int32_t node = lattice_node(growth->lattice, i % SITTER_SIDE, i / SITTER_SIDE);
        int maximum = routes_maximum(growth->routes, node);
        values[i] = growth->def.metric == METRIC_CUMULATIVE ? (double)routes_sum(growth->routes, node) : maximum;
        most = values[i] > most ? values[i] : most;
    }
    for (int i = 0; i < SITTER_SIDE * SITTER_SIDE; i++) {
        plane[i] = (float)(1 - values[i] / most);
    }
    sitter_show_plane(sitter, plane);
}
