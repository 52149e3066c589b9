/* Dendrites and trees from pictures: the figures of Long and Mould (2009), from pictures made by formula. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "figure.h"
#include "growth.h"
#include "growth_paint.h"
#include "ink.h"
#include "motif.h"
#include "sheet.h"

enum { SIDE = 512, SHOWN = 640, BLUR = 4, SHIFT = 45 };

static const struct rectangle ALL = {0, SIDE, 0, SIDE}, FACE = {250, 390, 100, 330};

struct sitter {
    float linear[3 * SIDE * SIDE], grey[SIDE * SIDE];
    float rgb[3 * SHOWN * SHOWN], backdrop[3 * SHOWN * SHOWN], linear_backdrop[3 * SHOWN * SHOWN];
    float ink[SIDE * SIDE], matter[SIDE * SIDE];
    uint8_t bytes[3 * SHOWN * SHOWN];
};

static struct sitter *sit(enum motif motif)
{
    struct sitter *sitter = calloc(1, sizeof *sitter);
    if (!sitter) {
        figure_stop("trees", "no memory");
    }
    motif_draw(motif, SIDE, SIDE, sitter->linear);
    importance_grey(sitter->linear, SIDE, SIDE, 3, -1, sitter->grey);
    return sitter;
}

static struct growth *grow_it(struct sitter *sitter, const struct growth_def *def)
{
    struct growth *growth = growth_create(sitter->grey, SIDE, SIDE, def);
    if (!growth) {
        figure_stop("trees", "no memory");
    }
    return growth;
}

static void to_bytes(struct sitter *sitter)
{
    for (int i = 0; i < 3 * SHOWN * SHOWN; i++) {
        float value = 255 * sitter->rgb[i] + 0.5f;
        sitter->bytes[i] = (uint8_t)(value < 0 ? 0 : value > 255 ? 255 : value);
    }
}

static void paint(struct sitter *sitter, const struct growth *growth, const struct growth_paint_def *def)
{
    struct strokes strokes = {0};
    if (!growth_strokes(growth, &strokes) || !growth_paint(growth, &strokes, def, sitter->rgb)) {
        figure_stop("trees", "no memory");
    }
    strokes_finish(&strokes);
    to_bytes(sitter);
}

static void paint_whole(struct sitter *sitter, const struct growth *growth)
{
    const struct growth_paint_def def = {
        .width = SHOWN, .height = SHOWN, .scale = (float)SHOWN / SIDE, .grown = FLT_MAX};
    paint(sitter, growth, &def);
}

/* A plane of the picture, as grey. */
static void show_plane(struct sitter *sitter, const float *plane)
{
    for (int y = 0; y < SHOWN; y++) {
        for (int x = 0; x < SHOWN; x++) {
            for (int c = 0; c < 3; c++) {
                sitter->rgb[3 * (y * SHOWN + x) + c] = plane[y * SIDE / SHOWN * SIDE + x * SIDE / SHOWN];
            }
        }
    }
    to_bytes(sitter);
}

static void blur(float *plane)
{
    static float other[SIDE * SIDE];
    for (int pass = 0; pass < 2; pass++) {
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                float sum = 0;
                int count = 0;
                for (int k = -BLUR; k <= BLUR; k++) {
                    int u = pass ? x : x + k, v = pass ? y + k : y;
                    if (u >= 0 && v >= 0 && u < SIDE && v < SIDE) {
                        sum += plane[v * SIDE + u];
                        count++;
                    }
                }
                other[y * SIDE + x] = sum / (float)count;
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
            double p = (double)a[y * SIDE + x], q = (double)b[y * SIDE + (x + moved) % SIDE];
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
static void check_seen(struct figure *figure, struct sitter *sitter, const struct growth *growth, const char *what,
                       double least, struct rectangle part)
{
    struct strokes strokes = {0};
    struct stroke_raster raster;
    if (!growth_strokes(growth, &strokes) || !stroke_raster_init(&raster, SIDE, SIDE, 1, 0, 0)) {
        figure_stop("trees", "no memory");
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

static struct dendrite_figures check_sound(struct figure *figure, const struct growth *growth, const char *what)
{
    struct dendrite_figures first = {0};
    for (int layer = 0; layer < growth->layer_count; layer++) {
        struct dendrite_figures figures;
        if (!dendrite_measure(growth->layers[layer], growth->importance, &figures)) {
            figure_stop("trees", "no memory");
        }
        figure_check(figure, figures.cycles == 0 && figures.components <= growth->seed_count && figures.endpoints > 200,
                     "%s: %d endpoints, %d pieces from %d seeds, %d cycles", what, figures.endpoints,
                     figures.components, growth->seed_count, figures.cycles);
        first = layer == 0 ? figures : first;
    }
    return first;
}

/* Figure 5: how early each place is reached, light first. */
static void show_contours(struct sitter *sitter, const struct growth *growth)
{
    static float plane[SIDE * SIDE];
    static double values[SIDE * SIDE];
    double most = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        int32_t node = lattice_node(growth->lattice, i % SIDE, i / SIDE);
        int maximum = routes_maximum(growth->routes, node);
        values[i] = growth->def.metric == METRIC_CUMULATIVE ? (double)routes_sum(growth->routes, node) : maximum;
        most = values[i] > most ? values[i] : most;
    }
    for (int i = 0; i < SIDE * SIDE; i++) {
        plane[i] = (float)(1 - values[i] / most);
    }
    show_plane(sitter, plane);
}

void figure_dendrites(struct figure *figure)
{
    struct sitter *sitter = sit(MOTIF_PORTRAIT);
    struct sheet *sheet = sheet_create(figure, "Dendrites from a picture: figures 2, 5, 6 and 7", 4, 3, SHOWN);
    struct growth_def def = growth_preset(METAPHOR_INK, false);
    show_plane(sitter, sitter->grey);
    sheet_add(sheet, sitter->bytes, "the picture");
    for (int m = 0; m < METRICS; m++) {
        def.metric = m;
        struct growth *growth = grow_it(sitter, &def);
        if (m == 0) {
            show_plane(sitter, growth->importance->values);
            sheet_add(sheet, sitter->bytes, "what matters");
            for (int i = 0; i < SIDE * SIDE; i++) {
                sitter->ink[i] = 1;
            }
            for (int32_t i = 0; i < growth->endpoint_count; i++) {
                int x = lattice_x(growth->lattice, growth->endpoints[i]);
                int y = lattice_y(growth->lattice, growth->endpoints[i]);
                sitter->ink[y * SIDE + x] = sitter->ink[y * SIDE + (x ? x - 1 : 0)] = 0;
                sitter->ink[(y ? y - 1 : 0) * SIDE + x] = 0;
            }
            show_plane(sitter, sitter->ink);
            sheet_add(sheet, sitter->bytes, "figure 6: %d endpoints", growth->endpoint_count);
        }
        if (m == METRIC_CUMULATIVE || m == METRIC_PARTIAL) {
            show_contours(sitter, growth);
            sheet_add(sheet, sitter->bytes, "figure 5: %s, light first", metric_names[m]);
        }
        struct dendrite_figures figures = check_sound(figure, growth, metric_names[m]);
        check_seen(figure, sitter, growth, metric_names[m], 0.5, ALL);
        paint_whole(sitter, growth);
        sheet_add(sheet, sitter->bytes, "%s: %.0f pixels long, covers %.0f %%", metric_names[m], figures.length,
                  100 * figures.coverage);
        growth_destroy(growth);
    }
    def = growth_preset(METAPHOR_INK, false);
    def.gain = 0;
    def.tip = 0.5f;
    struct growth *growth = grow_it(sitter, &def);
    paint_whole(sitter, growth);
    sheet_add(sheet, sitter->bytes, "figure 7: without emphasis");
    growth_destroy(growth);
    for (int motif = MOTIF_SPHERE; motif <= MOTIF_LEAF; motif += MOTIF_LEAF - MOTIF_SPHERE) {
        struct sitter *other = sit((enum motif)motif);
        def = growth_preset(METAPHOR_INK, false);
        growth = grow_it(other, &def);
        check_seen(figure, other, growth, motif_names[motif], 0.4, ALL);
        paint_whole(other, growth);
        sheet_add(sheet, other->bytes, "%s", motif_names[motif]);
        growth_destroy(growth);
        free(other);
    }
    sheet_finish(sheet);
    free(sitter);
}

void figure_metaphors(struct figure *figure)
{
    struct sitter *sitter = sit(MOTIF_PORTRAIT);
    struct sheet *sheet = sheet_create(figure, "Metaphors: figure 9 and more", 3, 2, SHOWN);
    for (int m = METAPHOR_INK; m <= METAPHOR_CRACKS; m++) {
        struct growth_def def = growth_preset((enum metaphor)m, false);
        struct growth *growth = grow_it(sitter, &def);
        check_sound(figure, growth, metaphor_names[m]);
        check_seen(figure, sitter, growth, metaphor_names[m], m == METAPHOR_LIGHTNING ? 0.3 : 0.4, ALL);
        paint_whole(sitter, growth);
        sheet_add(sheet, sitter->bytes, "%s", metaphor_names[m]);
        growth_destroy(growth);
    }
    sheet_finish(sheet);
    free(sitter);
}

static void add_tree(struct figure *figure, struct sheet *sheet, struct sitter *sitter, const struct growth_def *def,
                     const char *label, bool seen)
{
    struct growth *growth = grow_it(sitter, def);
    check_sound(figure, growth, label);
    if (seen) {
        check_seen(figure, sitter, growth, label, 0.25, FACE);
    }
    paint_whole(sitter, growth);
    sheet_add(sheet, sitter->bytes, "%s", label);
    growth_destroy(growth);
}

void figure_trees(struct figure *figure)
{
    struct sitter *sitter = sit(MOTIF_PORTRAIT);
    struct sheet *sheet = sheet_create(figure, "Trees: figures 12, 13, 15, 16 and 17", 4, 2, SHOWN);
    struct growth_def def = growth_preset(METAPHOR_INK, true);
    def.side = SIDE_ALL;
    def.layers = 1;
    def.iterations = 2;
    add_tree(figure, sheet, sitter, &def, "figure 12: two iterations", false);
    def.iterations = 3;
    add_tree(figure, sheet, sitter, &def, "figure 12: three", false);
    def.layers = 2;
    add_tree(figure, sheet, sitter, &def, "figure 13: two layers", false);
    def = growth_preset(METAPHOR_WINTER, true);
    def.side = SIDE_ALL;
    add_tree(figure, sheet, sitter, &def, "winter", false);
    def = growth_preset(METAPHOR_INK, true);
    def.mix = 0.9f;
    add_tree(figure, sheet, sitter, &def, "figure 15: by importance", true);
    def.mix = 0;
    add_tree(figure, sheet, sitter, &def, "figure 16: by branch", true);
    def = growth_preset(METAPHOR_INK, true);
    add_tree(figure, sheet, sitter, &def, "mixed", true);
    def = growth_preset(METAPHOR_PAINTED, true);
    add_tree(figure, sheet, sitter, &def, "figure 17: painted", true);
    sheet_finish(sheet);
    free(sitter);
}

/* How much darker the crown is than the ground behind it, and how near its darks are to those of the ground. */
static void compose(struct figure *figure, struct sheet *sheet, struct sitter *sitter, enum motif ground, float at,
                    float high)
{
    struct growth_def def = growth_preset(METAPHOR_PAINTED, true);
    struct growth *growth = grow_it(sitter, &def);
    motif_draw(ground, SHOWN, SHOWN, sitter->linear_backdrop);
    double darkest = 1;
    for (int i = 0; i < 3 * SHOWN * SHOWN; i++) {
        float value = ink_encode(sitter->linear_backdrop[i]);
        sitter->backdrop[i] = value < 0 ? 0 : value > 1 ? 1 : value;
        darkest = (double)sitter->backdrop[i] < darkest ? (double)sitter->backdrop[i] : darkest;
    }
    float scale = high * SHOWN / SIDE;
    const struct growth_paint_def paint_def = {.width = SHOWN,
                                               .height = SHOWN,
                                               .scale = scale,
                                               .left = at * SHOWN - 0.5f * SIDE * scale,
                                               .top = 0.9f * SHOWN - 0.965f * SIDE * scale,
                                               .grown = FLT_MAX,
                                               .background = sitter->backdrop};
    paint(sitter, growth, &paint_def);
    int changed = 0;
    double dark = 1;
    for (int i = 0; i < 3 * SHOWN * SHOWN; i++) {
        changed += fabsf(sitter->rgb[i] - sitter->backdrop[i]) > 0.08f;
        dark = (double)sitter->rgb[i] < dark ? (double)sitter->rgb[i] : dark;
    }
    double share = changed / (3.0 * SHOWN * SHOWN);
    figure_check(figure, share > 0.02 && share < 0.3 && dark > 0.3 * darkest,
                 "%s: the tree takes %.1f %% of it, its darkest %.2f, that of the ground %.2f", motif_names[ground],
                 100 * share, dark, darkest);
    sheet_add(sheet, sitter->bytes, "a tree in %s", motif_names[ground]);
    growth_destroy(growth);
}

void figure_composites(struct figure *figure)
{
    struct sitter *sitter = sit(MOTIF_PORTRAIT);
    struct sheet *sheet = sheet_create(figure, "Trees in landscapes: figures 18 and 19", 2, 1, SHOWN);
    compose(figure, sheet, sitter, MOTIF_WINTER, 0.46f, 0.72f);
    compose(figure, sheet, sitter, MOTIF_LANDSCAPE, 0.42f, 0.76f);
    sheet_finish(sheet);
    free(sitter);
}
