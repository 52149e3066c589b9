/* `frond bench painting`: every ink is on the sheet, every layer works; what sleeps is said by the name of the figure.
 */
#include <stdio.h>

#include "bench.h"
#include "history.h"
#include "painting.h"
#include "random.h"

enum {
    STATE_BYTES = 4 * (9 + 9 + 4), /* of the fluids and the wet pigment, a cell */
    PATTERN_BYTES = 4 * 3,
    MEAN_TICKS = 800, /* the first so many ticks of a growing painting */
};

struct order {
    int size, drops, threads;
    bool dense;
};

static struct action drop_of(struct order order, int i)
{
    struct action drop = action_default(ACTION_DROP);
    drop.at.x = order.drops == 1 ? 0.5f : 0.1f + 0.8f * random_unit(i, 0, 1, RANDOM_GRAIN);
    drop.at.y = order.drops == 1 ? 0.5f : 0.1f + 0.8f * random_unit(i, 1, 1, RANDOM_GRAIN);
    drop.ink = i % PAINTING_INKS;
    drop.visitor = i + 1;
    return drop;
}

static struct painting_def def_of(struct order order)
{
    struct painting_def def = painting_default_def();
    def.width = def.height = order.size;
    def.threads = order.threads;
    def.dense = order.dense;
    return def;
}

static struct painting *sheet_with_drops(struct order order)
{
    struct painting_def def = def_of(order);
    struct painting *painting = painting_create(&def);
    for (int i = 0; painting && i < order.drops; i++) {
        struct action drop = drop_of(order, i);
        painting_act(painting, &drop);
    }
    return painting;
}

/* Mean seconds of a tick over the first `ticks`; 0 when memory is short. */
static double mean_tick_s(struct order order, int ticks, double *awake)
{
    struct painting *painting = sheet_with_drops(order);
    if (!painting) {
        return 0;
    }
    for (int tick = 0; order.dense && tick < 3; tick++) {
        painting_tick(painting); /* caches and page tables first */
    }
    double start = bench_wall_s(), tiles = 0;
    for (int tick = 0; tick < ticks; tick++) {
        painting_tick(painting);
        struct painting_effort effort = painting_effort(painting);
        tiles += (double)effort.fluid_awake / effort.tiles;
    }
    double mean = (bench_wall_s() - start) / ticks;
    painting_destroy(painting);
    if (awake) {
        *awake = tiles / ticks;
    }
    return mean;
}

/* CPU time of one thread, the best of several ticks: what the layers themselves cost. Twelve drops in four inks. */
static bool time_layers(struct bench *bench, double triad)
{
    enum { SIZE = 512, TICKS = 60 };
    struct painting *painting = sheet_with_drops((struct order){SIZE, 12, 1, true});
    if (!painting) {
        return false;
    }
    struct coefficients coefficients = painting_get_def(painting).coefficients;
    double flow = 1e9, grow = 1e9;
    for (int tick = 0; tick < TICKS; tick++) {
        double start = bench_thread_s();
        painting_flow(painting);
        double middle = bench_thread_s();
        painting_grow(painting);
        double end = bench_thread_s();
        flow = middle - start < flow ? middle - start : flow;
        grow = end - middle < grow ? end - middle : grow;
    }
    double cells = (double)SIZE * SIZE;
    double pattern_ns = 1e9 * grow / cells / coefficients.pattern_steps;
    double fluid_ns = 1e9 * flow / cells / (2 * coefficients.fluid_steps); /* two fluids */
    bench_add(bench, "pattern_step_1thread_512", pattern_ns, "ns/cell", grow / (2 * PATTERN_BYTES * cells / triad));
    bench_add(bench, "fluid_step_1thread_512", fluid_ns, "ns/cell", flow / (2 * STATE_BYTES * cells / triad));
    bench_add(bench, "bytes_per_cell", (double)painting_bytes(painting) / cells, "bytes", 0);
    painting_destroy(painting);
    return true;
}

/* What a history adds to a tick, and what the longest of its ticks, an action and an undo take: milliseconds of CPU
 * time of the thread. */
static bool time_history(struct bench *bench)
{
    enum { TICKS = 240 };
    const struct order order = {720, 10, 0, false};
    struct painting_def def = def_of(order);
    struct history_def history_def = history_default_def();
    struct engine *engine = engine_cpu_create(&def);
    struct history *history = history_create(&history_def, &def);
    double sum = 0, most = 0, act = 0;
    for (int tick = 0; engine && history && tick < TICKS; tick++) {
        double start = bench_thread_s();
        if (tick >= 60 && tick < 60 + order.drops) {
            struct action drop = drop_of(order, tick - 60);
            history_act(history, engine, &drop);
            double took = bench_thread_s() - start;
            act = took > act ? took : act;
            start = bench_thread_s();
        }
        history_tick(history, engine);
        double took = bench_thread_s() - start;
        sum += took;
        most = took > most ? took : most;
        engine->ops->tick(engine);
    }
    if (engine && history) {
        double start = bench_thread_s();
        struct action undo = action_default(ACTION_UNDO);
        history_act(history, engine, &undo);
        bench_add(bench, "history_undo_720", 1e3 * (bench_thread_s() - start), "ms", 0);
        bench_add(bench, "history_action_720", 1e3 * act, "ms", 0);
        bench_add(bench, "history_tick_most_720", 1e3 * most, "ms", 0);
        bench_add(bench, "history_tick_mean_720", 1e3 * sum / TICKS, "ms", 0);
    }
    bool whole = engine && history;
    history_destroy(history);
    engine_destroy(engine);
    return whole;
}

static void add_rate(struct bench *bench, const char *name, double tick_s, int size, double triad)
{
    double pass_s = 2.0 * (STATE_BYTES + PATTERN_BYTES) * size * size / triad;
    bench_add(bench, name, tick_s > 0 ? 1 / tick_s : 0, "frames/s", tick_s / pass_s);
}

bool bench_painting(struct bench *bench)
{
    static const struct {
        int size, ticks;
        const char *dense, *one_drop, *ten_drops;
    } SIZES[] = {
        {512, 60, "frame_fps_dense_512", "frame_fps_one_drop_512", "frame_fps_ten_drops_512"},
        {720, 40, "frame_fps_dense_720", "frame_fps_one_drop_720", "frame_fps_ten_drops_720"},
        {1500, 12, "frame_fps_dense_1500", "frame_fps_one_drop_1500", "frame_fps_ten_drops_1500"},
        {2000, 8, "frame_fps_dense_2000", "frame_fps_one_drop_2000", "frame_fps_ten_drops_2000"},
    };
    bench->name = "painting";
    bench->meaning = "the dendritic painting on the CPU engine; all processors unless the name says one thread;\n"
                     "one_drop and ten_drops: asleep where nothing happens, mean of the first 800 ticks;\n"
                     "history: CPU time of its thread, ten drops, 240 ticks";
    double triad = bench_triad();
    if (triad <= 0 || !time_layers(bench, triad) || !time_history(bench)) {
        return false;
    }
    for (size_t i = 0; i < sizeof SIZES / sizeof SIZES[0]; i++) {
        int size = SIZES[i].size;
        add_rate(bench, SIZES[i].dense, mean_tick_s((struct order){size, 10, 0, true}, SIZES[i].ticks, NULL), size,
                 triad);
        add_rate(bench, SIZES[i].one_drop, mean_tick_s((struct order){size, 1, 0, false}, MEAN_TICKS, NULL), size,
                 triad);
        add_rate(bench, SIZES[i].ten_drops, mean_tick_s((struct order){size, 10, 0, false}, MEAN_TICKS, NULL), size,
                 triad);
    }
    double awake = 0, dense = mean_tick_s((struct order){1024, 1, 0, true}, 24, NULL);
    double sleeping = mean_tick_s((struct order){1024, 1, 0, false}, MEAN_TICKS, &awake);
    bench_add(bench, "sleeping_speedup_1024", sleeping > 0 ? dense / sleeping : 0, "times dense", 0);
    bench_add(bench, "sleeping_awake_1024", 100 * awake, "% of tiles", 0);
    bench_add(bench, "triad", 1e-9 * triad, "GB/s", 0);
    return true;
}
