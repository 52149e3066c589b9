/* `frond bench trees`: from a decoded picture to a structure, stage by stage, on one thread. The portrait of motif.h.
 */
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "growth.h"
#include "motif.h"
#include "stroke_raster.h"

enum { REPEATS = 5, EDITS = 24, EDIT_RADIUS = 20 };

struct stages {
    double importance, lattice, stipple, plan[METRICS], whole; /* s */
};

static void keep_least(double *least, double value)
{
    *least = *least == 0 || value < *least ? value : *least;
}

/* The stages one by one, as growth_create has them. */
static bool time_stages(const float *grey, int side, const struct growth_def *def, struct stages *stages)
{
    struct importance_def weights = importance_default_def();
    struct lattice_def lattice_weights = lattice_default_def();
    double start = bench_thread_s();
    struct importance *importance = importance_create(grey, side, side, &weights);
    keep_least(&stages->importance, bench_thread_s() - start);
    start = bench_thread_s();
    struct lattice *lattice = importance ? lattice_create(importance, &lattice_weights, NULL, NULL) : NULL;
    keep_least(&stages->lattice, bench_thread_s() - start);
    struct stipple *stipple = lattice ? stipple_create(lattice) : NULL;
    struct routes *routes = lattice ? routes_create(lattice) : NULL;
    bool good = stipple && routes;
    if (good) {
        int32_t seed = lattice_node(lattice, side / 2, side * 98 / 100);
        start = bench_thread_s();
        stipple_weigh(stipple, importance, NULL);
        good = stipple_search(stipple, &seed, 1, def->endpoints) > 0;
        keep_least(&stages->stipple, bench_thread_s() - start);
        for (int m = 0; m < METRICS && good; m++) {
            start = bench_thread_s();
            good = routes_plan(routes, (enum metric)m, 1000, &seed, 1);
            keep_least(&stages->plan[m], bench_thread_s() - start);
        }
    }
    routes_destroy(routes);
    stipple_destroy(stipple);
    lattice_destroy(lattice);
    importance_destroy(importance);
    return good;
}

/* From linear light to the structure with its thickness; the growth is the last one's. */
static struct growth *time_whole(const float *linear, float *grey, int side, const struct growth_def *def, int repeats,
                                 double *least)
{
    struct growth *growth = NULL;
    for (int i = 0; i < repeats; i++) {
        growth_destroy(growth);
        double start = bench_thread_s();
        importance_grey(linear, side, side, 3, -1, grey);
        growth = growth_create(grey, side, side, def);
        keep_least(least, bench_thread_s() - start);
        if (!growth) {
            return NULL;
        }
    }
    return growth;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static bool time_edits(struct growth *growth, double *median, double *worst)
{
    double seconds[EDITS];
    for (int i = 0; i < EDITS; i++) {
        int row = i / 6;
        float x = (float)growth->importance->width * (0.1f + 0.16f * (float)(i % 6));
        float y = (float)growth->importance->height * (0.1f + 0.26f * (float)row);
        double start = bench_thread_s();
        if (!growth_brush(growth, x, y, EDIT_RADIUS, i % 2 ? 0.5f : -0.5f)) {
            return false;
        }
        seconds[i] = bench_thread_s() - start;
    }
    qsort(seconds, EDITS, sizeof *seconds, compare);
    *median = seconds[EDITS / 2];
    *worst = seconds[EDITS - 1];
    return true;
}

static double draw_s(const struct growth *growth, int scale)
{
    struct strokes strokes = {0};
    struct stroke_raster raster = {0};
    int side = growth->importance->width * scale;
    double seconds = 0;
    if (growth_strokes(growth, &strokes) && stroke_raster_init(&raster, side, side, (float)scale, 0, 0)) {
        double start = bench_thread_s();
        stroke_raster_draw(&raster, &strokes, 0, STROKE_BRANCH, 1e9f);
        seconds = bench_thread_s() - start;
    }
    stroke_raster_finish(&raster);
    strokes_finish(&strokes);
    return seconds;
}

static bool bench_size(struct bench *bench, int side, const struct growth_def *def, const char *whole_name,
                       struct growth **grown)
{
    size_t pixels = (size_t)side * (size_t)side;
    float *linear = malloc(3 * pixels * sizeof *linear), *grey = malloc(pixels * sizeof *grey);
    double least = 0;
    *grown = NULL;
    if (linear && grey) {
        motif_draw(MOTIF_PORTRAIT, side, side, linear);
        *grown = time_whole(linear, grey, side, def, side > 1000 ? 2 : REPEATS, &least);
    }
    bench_add(bench, whole_name, 1e3 * least, "ms", 0);
    free(linear);
    free(grey);
    return *grown;
}

static bool bench_stages(struct bench *bench, const struct growth_def *def)
{
    static const char *const NAMES[METRICS] = {"plan_cumulative_ms_512", "plan_partial_ms_512", "plan_weighted_ms_512",
                                               "plan_full_ms_512"};
    enum { SIDE = 512 };
    struct stages stages = {0};
    float *linear = malloc(3 * SIDE * SIDE * sizeof *linear), *grey = malloc(SIDE * SIDE * sizeof *grey);
    bool good = linear && grey;
    if (good) {
        motif_draw(MOTIF_PORTRAIT, SIDE, SIDE, linear);
        importance_grey(linear, SIDE, SIDE, 3, -1, grey);
    }
    for (int i = 0; i < REPEATS && good; i++) {
        good = time_stages(grey, SIDE, def, &stages);
    }
    bench_add(bench, "importance_ms_512", 1e3 * stages.importance, "ms", 0);
    bench_add(bench, "lattice_ms_512", 1e3 * stages.lattice, "ms", 0);
    bench_add(bench, "stipple_ms_512", 1e3 * stages.stipple, "ms", 0);
    for (int m = 0; m < METRICS; m++) {
        bench_add(bench, NAMES[m], 1e3 * stages.plan[m], "ms", 0);
    }
    free(linear);
    free(grey);
    return good;
}

bool bench_trees(struct bench *bench)
{
    /* Long and Mould (2009), table 1: endpoints and seconds. */
    static const struct {
        const char *name;
        double seconds;
        int endpoints;
    } PAPER[] = {{"paper_2019_endpoints_over_here", 237, 2019},
                 {"paper_2992_endpoints_over_here", 368, 2992},
                 {"paper_3838_endpoints_over_here", 530, 3838}};
    struct growth_def def = growth_preset(METAPHOR_INK, false);
    struct growth *growth;
    double median = 0, worst = 0;
    bench->name = "trees";
    bench->meaning =
        "dendrites from a picture: decoded picture to structure, the best of several, CPU time of one thread;\n"
        "replan: a brush of 20 pixels at 24 places, median and worst; paper: its seconds over ours";
    bool good = bench_size(bench, 512, &def, "structure_ms_512", &growth) && bench_stages(bench, &def) &&
                time_edits(growth, &median, &worst);
    if (good) {
        bench_add(bench, "replan_ms_512", 1e3 * median, "ms", 0);
        bench_add(bench, "replan_worst_ms_512", 1e3 * worst, "ms", 0);
        bench_add(bench, "draw_ms_1536", 1e3 * draw_s(growth, 3), "ms", 0);
    }
    growth_destroy(growth);
    for (size_t i = 0; i < sizeof PAPER / sizeof *PAPER && good; i++) {
        struct bench other = {.count = 0};
        struct growth_def like = def;
        like.endpoints = PAPER[i].endpoints;
        good = bench_size(&other, 512, &like, "", &growth);
        growth_destroy(growth);
        bench_add(bench, PAPER[i].name, PAPER[i].seconds / (1e-3 * other.figures[0].value), "times", 0);
    }
    def.endpoints = 12000;
    good = good && bench_size(bench, 2048, &def, "structure_ms_2048", &growth);
    if (good) {
        growth_destroy(growth);
        struct growth_def tree = growth_preset(METAPHOR_PAINTED, true);
        good = bench_size(bench, 640, &tree, "tree_ms_640", &growth);
        growth_destroy(growth);
    }
    return good;
}
