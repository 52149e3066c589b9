/* The figures of Long and Mould (2009) from real photographs, as theirs are. */
#include <math.h>
#include <stdlib.h>

#include "figure.h"
#include "lattice.h"
#include "photograph.h"
#include "random.h"
#include "routes.h"
#include "sheet.h"

enum { SIDE = SITTER_SIDE, SHOWN = SITTER_SHOWN, ENDS = 260 };

static const struct rectangle ALL = {0, SIDE, 0, SIDE};

static void show(struct sheet *sheet, struct sitter *sitter, const struct growth *growth, const char *label)
{
    sitter_paint_whole(sitter, growth);
    sheet_add(sheet, sitter->bytes, "%s", label);
}

/* How long the ways from the seed to the tips are, beside straight lines. */
static double winding(const struct growth *growth)
{
    const struct dendrite *dendrite = growth->layers[0];
    float sx, sy;
    double way = 0, straight = 0;
    lattice_place(growth->lattice, growth->seeds[0], &sx, &sy);
    for (int32_t i = 0; i < dendrite->endpoint_count; i++) {
        float x, y;
        lattice_place(growth->lattice, dendrite->endpoints[i], &x, &y);
        way += (double)dendrite->nodes[dendrite->at[dendrite->endpoints[i]]].reach;
        straight += hypot((double)(x - sx), (double)(y - sy));
    }
    return way / straight;
}

/* Figure 1: a graph of chance, the same endpoints, two metrics. The ways of the second wind. */
static void show_metrics(struct figure *figure, struct sheet *sheet)
{
    double winds[METRICS] = {0};
    struct growth_def def = growth_preset(METAPHOR_INK, false);
    struct sitter *plain = calloc(1, sizeof *plain);
    def.picture = 0;
    def.random = 0.9f;
    def.gradient = 0;
    def.endpoints = ENDS;
    def.gain = 0;
    def.tip = 0.9f;
    for (int i = 0; plain && i < SIDE * SIDE; i++) {
        plain->grey[i] = 0.5f;
    }
    if (!plain) {
        figure_stop("photographs", "no memory");
    }
    for (int metric = METRIC_CUMULATIVE; metric <= METRIC_PARTIAL; metric++) {
        def.metric = metric;
        struct growth *growth = sitter_grow(plain, &def);
        sitter_check_sound(figure, growth, metric_names[metric]);
        winds[metric] = winding(growth);
        sitter_paint_whole(plain, growth);
        sheet_add(sheet, plain->bytes, "figure 1: a graph of chance, %s", metric_names[metric]);
        growth_destroy(growth);
    }
    figure_check(figure, winds[METRIC_PARTIAL] > 1.15 * winds[METRIC_CUMULATIVE],
                 "figure 1: ways are %.2f times a straight line by the partial metric, %.2f by the cumulative one",
                 winds[METRIC_PARTIAL], winds[METRIC_CUMULATIVE]);
    free(plain);
}

struct edge {
    int32_t a, b, cost;
};

static int by_cost(const void *a, const void *b)
{
    const struct edge *one = a, *other = b;
    return one->cost - other->cost;
}

static int32_t root_of(int32_t *parent, int32_t node)
{
    while (parent[node] != node) {
        node = parent[node] = parent[parent[node]];
    }
    return node;
}

/* Kruskal: what joins a node's tree to that of the seed is the most expensive edge of its way in the minimum spanning
 * tree. `next` are rings of the nodes of a tree. */
static void span(const struct lattice *lattice, int32_t seed, int32_t *most)
{
    size_t nodes = (size_t)lattice->nodes;
    struct edge *edges = malloc(4 * nodes * sizeof *edges);
    int32_t *parent = malloc(nodes * sizeof *parent), *next = malloc(nodes * sizeof *next), count = 0;
    if (!edges || !parent || !next) {
        figure_stop("photographs", "no memory");
    }
    for (int32_t node = 0; node < lattice->nodes; node++) {
        parent[node] = next[node] = node;
        most[node] = 0;
        for (int k = 0; k < LATTICE_NEIGHBOURS && lattice->weight[node] > 0; k++) {
            int32_t other = node + lattice->step[k];
            if (other > node && lattice->weight[other] > 0) {
                edges[count++] = (struct edge){node, other, lattice->weight[node] + lattice->weight[other]};
            }
        }
    }
    qsort(edges, (size_t)count, sizeof *edges, by_cost);
    for (int32_t i = 0; i < count; i++) {
        int32_t a = root_of(parent, edges[i].a), b = root_of(parent, edges[i].b), home = root_of(parent, seed);
        if (a == b) {
            continue;
        }
        int32_t joined = a == home ? b : b == home ? a : -1, node = joined;
        while (joined >= 0 && (most[node] = edges[i].cost, node = next[node]) != joined) {
        }
        int32_t swap = next[a];
        next[a] = next[b];
        next[b] = swap;
        parent[a] = b;
    }
    free(edges);
    free(parent);
    free(next);
}

/* The partial metric's maxima are those of the spanning tree, at every pixel. */
static void check_minimax(struct figure *figure, const struct growth *growth, const char *what)
{
    const struct lattice *lattice = growth->lattice;
    int32_t *most = malloc((size_t)lattice->nodes * sizeof *most), same = 0, open = 0, sums = 0;
    if (!most) {
        figure_stop("photographs", "no memory");
    }
    span(lattice, growth->seeds[0], most);
    for (int32_t node = 0; node < lattice->nodes; node++) {
        if (lattice->weight[node] > 0) {
            open++;
            same += routes_maximum(growth->routes, node) == most[node];
            sums += most[node] > 0;
        }
    }
    figure_check(figure, same == open && open == SIDE * SIDE && sums == open - 1,
                 "%s: the maximum is that of the minimum spanning tree at %d of %d pixels", what, same, open);
    free(most);
}

/* Distances from stipple to stipple: even, and closer where it matters. */
static void check_spacing(struct figure *figure, const struct growth *growth, const char *what)
{
    double sum[2] = {0}, square[2] = {0}, far[2] = {0}, count[2] = {0}, matter = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        matter += (double)growth->importance->values[i] / (SIDE * SIDE);
    }
    for (int32_t i = 0; i < growth->endpoint_count; i++) {
        int ix = lattice_x(growth->lattice, growth->endpoints[i]),
            iy = lattice_y(growth->lattice, growth->endpoints[i]);
        int cx = (int)(random_unit(i, 0, 7, RANDOM_PLACE) * SIDE),
            cy = (int)(random_unit(i, 1, 7, RANDOM_PLACE) * SIDE);
        double nearest = 1e9, chance = 1e9;
        for (int32_t k = 0; k < growth->endpoint_count; k++) {
            int x = lattice_x(growth->lattice, growth->endpoints[k]),
                y = lattice_y(growth->lattice, growth->endpoints[k]);
            double apart = (double)((x - ix) * (x - ix) + (y - iy) * (y - iy));
            double other = (double)((x - cx) * (x - cx) + (y - cy) * (y - cy));
            nearest = k != i && apart < nearest ? apart : nearest;
            chance = other < chance ? other : chance;
        }
        int high = (double)growth->importance->values[iy * SIDE + ix] > matter;
        sum[high] += sqrt(nearest);
        square[high] += nearest;
        count[high]++;
        far[0] += sqrt(chance);
        far[1] = sqrt(chance) > far[1] ? sqrt(chance) : far[1];
    }
    double mean[2], spread[2];
    for (int h = 0; h < 2; h++) {
        mean[h] = sum[h] / count[h];
        spread[h] = sqrt(square[h] / count[h] - mean[h] * mean[h]) / mean[h];
    }
    /* Of points of chance on an even ground the spread is .52; elsewhere is both skin and wall. */
    figure_check(
        figure, mean[1] < 0.8 * mean[0] && spread[1] < 0.4 && spread[0] < 0.65 && far[1] < 60,
        "%s: %d stipples, %.1f pixels apart where it matters and %.1f elsewhere, spread %.2f and %.2f, no place "
        "farther than %.0f",
        what, growth->endpoint_count, mean[1], mean[0], spread[1], spread[0], far[1]);
}

static void show_endpoints(struct sheet *sheet, struct sitter *sitter, const struct growth *growth)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        sitter->ink[i] = 1;
    }
    for (int32_t i = 0; i < growth->endpoint_count; i++) {
        int x = lattice_x(growth->lattice, growth->endpoints[i]), y = lattice_y(growth->lattice, growth->endpoints[i]);
        sitter->ink[y * SIDE + x] = sitter->ink[y * SIDE + (x ? x - 1 : 0)] = sitter->ink[(y ? y - 1 : 0) * SIDE + x] =
            0;
    }
    sitter_show_plane(sitter, sitter->ink);
    sheet_add(sheet, sitter->bytes, "figure 6: %d endpoints", growth->endpoint_count);
}

/* Figures 2, 5, 6 and 7, of one face. */
static void show_face(struct figure *figure, struct sheet *sheet)
{
    struct sitter *sitter = photograph_sit(PHOTOGRAPH_FACE);
    struct growth_def def = growth_preset(METAPHOR_INK, false);
    sitter_show_plane(sitter, sitter->grey);
    sheet_add(sheet, sitter->bytes, "the photograph");
    def.metric = METRIC_CUMULATIVE;
    struct growth *growth = sitter_grow(sitter, &def);
    sitter_check_sound(figure, growth, "face, cumulative");
    show(sheet, sitter, growth, "figure 2: cumulative");
    sitter_show_contours(sitter, growth);
    sheet_add(sheet, sitter->bytes, "figure 5: cumulative, light first");
    growth_destroy(growth);
    def.metric = METRIC_PARTIAL;
    growth = sitter_grow(sitter, &def);
    sitter_check_sound(figure, growth, "face, partial");
    sitter_check_seen(figure, sitter, growth, "face, partial", 0.6, ALL);
    check_minimax(figure, growth, "face");
    check_spacing(figure, growth, "face");
    show(sheet, sitter, growth, "figures 2 and 7: partial, with emphasis");
    sitter_show_contours(sitter, growth);
    sheet_add(sheet, sitter->bytes, "figure 5: partial, light first");
    show_endpoints(sheet, sitter, growth);
    growth_destroy(growth);
    def.gain = 0;
    def.tip = 0.5f;
    growth = sitter_grow(sitter, &def);
    show(sheet, sitter, growth, "figure 7: without emphasis");
    growth_destroy(growth);
    free(sitter);
}

/* Figures 3 and 8: more photographs; and 9. */
static void show_others(struct figure *figure, struct sheet *sheet)
{
    static const struct {
        enum photograph photograph;
        enum metaphor metaphor;
        const char *label;
        double least;
    } OTHERS[] = {
        {PHOTOGRAPH_ASTRONAUT, METAPHOR_INK, "figure 8: an astronaut", 0.5},
        {PHOTOGRAPH_ADMIRAL, METAPHOR_INK, "figure 8: an admiral", 0.5},
        {PHOTOGRAPH_CAT, METAPHOR_INK, "figure 8: a cat", 0.5},
        {PHOTOGRAPH_FACE, METAPHOR_VINE, "figure 9: vine", 0.4},
        {PHOTOGRAPH_ADMIRAL, METAPHOR_LIGHTNING, "figure 9: lightning", 0.3},
    };
    for (size_t i = 0; i < sizeof OTHERS / sizeof OTHERS[0]; i++) {
        struct sitter *sitter = photograph_sit(OTHERS[i].photograph);
        struct growth_def def = growth_preset(OTHERS[i].metaphor, false);
        struct growth *growth = sitter_grow(sitter, &def);
        sitter_check_sound(figure, growth, OTHERS[i].label);
        sitter_check_seen(figure, sitter, growth, OTHERS[i].label, OTHERS[i].least, ALL);
        if (OTHERS[i].photograph != PHOTOGRAPH_FACE && OTHERS[i].metaphor == METAPHOR_INK) {
            check_minimax(figure, growth, OTHERS[i].label);
        }
        if (OTHERS[i].photograph == PHOTOGRAPH_CAT) {
            check_spacing(figure, growth, OTHERS[i].label);
        }
        show(sheet, sitter, growth, OTHERS[i].label);
        growth_destroy(growth);
        free(sitter);
    }
}

void figure_photographs(struct figure *figure)
{
    if (!photographs_are_there()) {
        figure->skipped = true;
        return;
    }
    struct sheet *sheet = sheet_create(figure, "From photographs: figures 1, 2, 5, 6, 7, 8 and 9", 5, 3, SHOWN);
    show_metrics(figure, sheet);
    show_face(figure, sheet);
    show_others(figure, sheet);
    sheet_finish(sheet);
}

static void show_tree(struct figure *figure, struct sheet *sheet, struct sitter *sitter, const struct growth_def *def,
                      const char *label, const struct rectangle *face)
{
    struct growth *growth = sitter_grow(sitter, def);
    sitter_check_sound(figure, growth, label);
    if (face) {
        sitter_check_seen(figure, sitter, growth, label, 0.25, *face);
    }
    show(sheet, sitter, growth, label);
    growth_destroy(growth);
}

void figure_hidden(struct figure *figure)
{
    static const struct rectangle HERS = {140, 400, 90, 400}, FROWN = {110, 350, 185, 375}; /* the faces alone */
    if (!photographs_are_there()) {
        figure->skipped = true;
        return;
    }
    struct sitter *face = photograph_sit(PHOTOGRAPH_CLOSE), *admiral = photograph_sit(PHOTOGRAPH_FROWN);
    struct sheet *sheet = sheet_create(figure, "Photographs in trees: figures 12, 13, 15 and 16", 4, 2, SHOWN);
    struct growth_def def = growth_preset(METAPHOR_INK, true);
    sitter_show_plane(face, face->grey);
    sheet_add(sheet, face->bytes, "the photograph");
    def.side = GROWTH_SIDE_ALL;
    def.layers = 1;
    def.iterations = 2;
    show_tree(figure, sheet, face, &def, "figure 12: two iterations", NULL);
    def.iterations = 3;
    show_tree(figure, sheet, face, &def, "figure 12: three", NULL);
    def.layers = 2;
    show_tree(figure, sheet, face, &def, "figure 13: two layers", NULL);
    def = growth_preset(METAPHOR_INK, true);
    def.side = GROWTH_SIDE_NONE; /* all of the crown is her face; the paper leaves the left half free */
    def.radius = 0.4f;
    def.spacing = 10;
    def.primary = 3;
    def.branch = 3;
    def.mix = 0.7f;
    def.fork = (struct point){0.49f, 0.62f};
    show_tree(figure, sheet, face, &def, "figure 15: mixed", &HERS);
    def.mix = 0.9f;
    show_tree(figure, sheet, face, &def, "figure 15: by importance", &HERS);
    show_tree(figure, sheet, admiral, &def, "figure 16: by importance", &FROWN);
    def.mix = 0;
    show_tree(figure, sheet, admiral, &def, "figure 16: by branch", &FROWN);
    sheet_finish(sheet);
    free(face);
    free(admiral);
}
