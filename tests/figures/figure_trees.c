/* Dendrites and trees from pictures: the figures of Long and Mould (2009), from pictures made by formula. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "figure.h"
#include "ink.h"
#include "sheet.h"
#include "sitter.h"

enum { SIDE = SITTER_SIDE, SHOWN = SITTER_SHOWN };

static const struct rectangle ALL = {0, SIDE, 0, SIDE}, FACE = {250, 390, 100, 330};

void figure_dendrites(struct figure *figure)
{
    struct sitter *sitter = sitter_draw(MOTIF_PORTRAIT);
    struct sheet *sheet = sheet_create(figure, "Dendrites from a picture: figures 2, 5, 6 and 7", 4, 3, SHOWN);
    struct growth_def def = growth_preset(METAPHOR_INK, false);
    sitter_show_plane(sitter, sitter->grey);
    sheet_add(sheet, sitter->bytes, "the picture");
    for (int m = 0; m < METRICS; m++) {
        def.metric = m;
        struct growth *growth = sitter_grow(sitter, &def);
        if (m == 0) {
            sitter_show_plane(sitter, growth->importance->values);
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
            sitter_show_plane(sitter, sitter->ink);
            sheet_add(sheet, sitter->bytes, "figure 6: %d endpoints", growth->endpoint_count);
        }
        if (m == METRIC_CUMULATIVE || m == METRIC_PARTIAL) {
            sitter_show_contours(sitter, growth);
            sheet_add(sheet, sitter->bytes, "figure 5: %s, light first", metric_names[m]);
        }
        struct dendrite_figures figures = sitter_check_sound(figure, growth, metric_names[m]);
        sitter_check_seen(figure, sitter, growth, metric_names[m], 0.5, ALL);
        sitter_paint_whole(sitter, growth);
        sheet_add(sheet, sitter->bytes, "%s: %.0f pixels long, covers %.0f %%", metric_names[m], figures.length,
                  100 * figures.coverage);
        growth_destroy(growth);
    }
    def = growth_preset(METAPHOR_INK, false);
    def.gain = 0;
    def.tip = 0.5f;
    struct growth *growth = sitter_grow(sitter, &def);
    sitter_paint_whole(sitter, growth);
    sheet_add(sheet, sitter->bytes, "figure 7: without emphasis");
    growth_destroy(growth);
    for (int motif = MOTIF_SPHERE; motif <= MOTIF_LEAF; motif += MOTIF_LEAF - MOTIF_SPHERE) {
        struct sitter *other = sitter_draw((enum motif)motif);
        def = growth_preset(METAPHOR_INK, false);
        growth = sitter_grow(other, &def);
        sitter_check_seen(figure, other, growth, motif_names[motif], 0.4, ALL);
        sitter_paint_whole(other, growth);
        sheet_add(sheet, other->bytes, "%s", motif_names[motif]);
        growth_destroy(growth);
        free(other);
    }
    sheet_finish(sheet);
    free(sitter);
}

void figure_metaphors(struct figure *figure)
{
    struct sitter *sitter = sitter_draw(MOTIF_PORTRAIT);
    struct sheet *sheet = sheet_create(figure, "Metaphors: figure 9 and more", 3, 2, SHOWN);
    for (int m = METAPHOR_INK; m <= METAPHOR_CRACKS; m++) {
        struct growth_def def = growth_preset((enum metaphor)m, false);
        struct growth *growth = sitter_grow(sitter, &def);
        sitter_check_sound(figure, growth, metaphor_names[m]);
        sitter_check_seen(figure, sitter, growth, metaphor_names[m], m == METAPHOR_LIGHTNING ? 0.3 : 0.4, ALL);
        sitter_paint_whole(sitter, growth);
        sheet_add(sheet, sitter->bytes, "%s", metaphor_names[m]);
        growth_destroy(growth);
    }
    sheet_finish(sheet);
    free(sitter);
}

static void add_tree(struct figure *figure, struct sheet *sheet, struct sitter *sitter, const struct growth_def *def,
                     const char *label, bool seen)
{
    struct growth *growth = sitter_grow(sitter, def);
    sitter_check_sound(figure, growth, label);
    if (seen) {
        sitter_check_seen(figure, sitter, growth, label, 0.25, FACE);
    }
    sitter_paint_whole(sitter, growth);
    sheet_add(sheet, sitter->bytes, "%s", label);
    growth_destroy(growth);
}

void figure_trees(struct figure *figure)
{
    struct sitter *sitter = sitter_draw(MOTIF_PORTRAIT);
    struct sheet *sheet = sheet_create(figure, "Trees: figures 12, 13, 15, 16 and 17", 4, 2, SHOWN);
    struct growth_def def = growth_preset(METAPHOR_INK, true);
    def.side = GROWTH_SIDE_ALL;
    def.layers = 1;
    def.iterations = 2;
    add_tree(figure, sheet, sitter, &def, "figure 12: two iterations", false);
    def.iterations = 3;
    add_tree(figure, sheet, sitter, &def, "figure 12: three", false);
    def.layers = 2;
    add_tree(figure, sheet, sitter, &def, "figure 13: two layers", false);
    def = growth_preset(METAPHOR_WINTER, true);
    def.side = GROWTH_SIDE_ALL;
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
    struct growth *growth = sitter_grow(sitter, &def);
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
    sitter_paint(sitter, growth, &paint_def);
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
    struct sitter *sitter = sitter_draw(MOTIF_PORTRAIT);
    struct sheet *sheet = sheet_create(figure, "Trees in landscapes: figures 18 and 19", 2, 1, SHOWN);
    compose(figure, sheet, sitter, MOTIF_WINTER, 0.46f, 0.72f);
    compose(figure, sheet, sitter, MOTIF_LANDSCAPE, 0.42f, 0.76f);
    sheet_finish(sheet);
    free(sitter);
}
