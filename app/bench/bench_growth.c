/* `frond bench growth`: Laplacian growth, exact and fast, beside the models it replaces. Those are no part of Frond: a
 * program of the tests has them, which is started where it lies in a build, tests/bench/growth_baselines. */
#define _GNU_SOURCE /* pipe2 */
#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench.h"
#include "laplacian.h"
#include "storm.h"

enum { SMALL = 20000, LARGE = 1000000, FRAME = 1000, FRAMES = 100, BASELINES = 5 };

struct baselines {
    const char *name[BASELINES], *unit[BASELINES];
    double value[BASELINES];
};

static struct laplacian_def def_of(int dimensions, int particles, enum laplacian_method method)
{
    struct laplacian_def def = laplacian_default_def();
    def.dimensions = dimensions;
    def.particles = particles;
    def.method = (int)method;
    return def;
}

/* Seconds, the best of some; 0 when memory is short. */
static double grow_s(int dimensions, int particles, enum laplacian_method method, int repeats, double *bytes)
{
    const struct laplacian_def def = def_of(dimensions, particles, method);
    double least = 0;
    for (int i = 0; i < repeats; i++) {
        enum laplacian_status status;
        double start = bench_thread_s();
        struct laplacian *laplacian = laplacian_create(&def, &status);
        if (!laplacian) {
            return 0;
        }
        laplacian_step(laplacian, particles);
        double seconds = bench_thread_s() - start;
        bool good = laplacian_count(laplacian) == particles;
        *bytes = (double)laplacian_bytes(laplacian) / particles;
        laplacian_destroy(laplacian);
        if (!good) {
            return 0;
        }
        least = i == 0 || seconds < least ? seconds : least;
    }
    return least;
}

/* The worst of the frames in which it grows by FRAME particles each, up to 100,000 in 2D: of several growths the best,
 * frame by frame. ms; 0 when memory is short. */
static double worst_frame_ms(void)
{
    enum { REPEATS = 3 };
    double seconds[FRAMES], worst = 0;
    const struct laplacian_def def = def_of(2, FRAME * FRAMES, LAPLACIAN_AUTO);
    for (int i = 0; i < REPEATS; i++) {
        enum laplacian_status status;
        struct laplacian *laplacian = laplacian_create(&def, &status);
        if (!laplacian) {
            return 0;
        }
        for (int frame = 0; frame < FRAMES; frame++) {
            double start = bench_thread_s();
            laplacian_step(laplacian, FRAME);
            double taken = bench_thread_s() - start;
            seconds[frame] = i == 0 || taken < seconds[frame] ? taken : seconds[frame];
        }
        laplacian_destroy(laplacian);
    }
    for (int frame = 0; frame < FRAMES; frame++) {
        worst = seconds[frame] > worst ? seconds[frame] : worst;
    }
    return 1e3 * worst;
}

static void conduct(struct storm *storm, const char *key, float value)
{
    struct action action = action_default(ACTION_CONDUCT);
    while (strcmp(storm_keys[action.option].name, key) != 0) {
        action.option++;
    }
    action.value = value;
    storm_act(storm, 0, &action);
}

/* From the edges of a small square in the middle, in all directions. */
static struct storm *storm_begun(void)
{
    enum { SIDE = 32 };
    float square[SIDE * SIDE] = {0};
    struct action strike = action_default(ACTION_STRIKE);
    struct storm *storm = storm_create(740, 465);
    if (storm) {
        square[SIDE / 2 * SIDE + SIDE / 2] = 1;
        strike.formula = (struct action_raster){square, SIDE, SIDE, 1};
        conduct(storm, "eta", 3);
        conduct(storm, "pace", FRAME);
        conduct(storm, "particles", STORM_PARTICLES);
        storm_act(storm, 0, &strike);
    }
    return storm;
}

/* The same of a scene of lightning: ticks, with all that is to be seen after each. ms; 0 when memory is short. */
static double worst_tick_ms(void)
{
    enum { REPEATS = 3 };
    double seconds[FRAMES], worst = 0;
    for (int i = 0; i < REPEATS; i++) {
        struct storm *storm = storm_begun();
        bool good = storm;
        int since, count = 0;
        for (int frame = 0; frame < FRAMES && good; frame++) {
            double start = bench_thread_s();
            good = storm_tick(storm, frame);
            count = storm_view(storm, frame, &since).count;
            double taken = bench_thread_s() - start;
            seconds[frame] = i == 0 || taken < seconds[frame] ? taken : seconds[frame];
        }
        storm_destroy(storm);
        if (!good || count < (FRAMES - 2) * FRAME) {
            return 0;
        }
    }
    for (int frame = 0; frame < FRAMES; frame++) {
        worst = seconds[frame] > worst ? seconds[frame] : worst;
    }
    return 1e3 * worst;
}

static FILE *start_baselines(pid_t *pid)
{
    char program[1200];
    ssize_t length = readlink("/proc/self/exe", program, 1024);
    program[length > 0 ? length : 0] = '\0';
    char *slash = strrchr(program, '/');
    if (!slash) {
        return NULL;
    }
    snprintf(slash, sizeof program - (size_t)(slash - program), "/tests/bench/growth_baselines");
    char *arguments[] = {program, NULL};
    int ends[2];
    if (access(program, X_OK) != 0 || pipe2(ends, O_CLOEXEC) != 0) {
        return NULL;
    }
    posix_spawn_file_actions_t actions;
    int code = posix_spawn_file_actions_init(&actions);
    if (code == 0) {
        code = posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
        code = code ? code : posix_spawn(pid, program, &actions, NULL, arguments, environ);
        posix_spawn_file_actions_destroy(&actions);
    }
    close(ends[1]);
    FILE *out = code == 0 ? fdopen(ends[0], "r") : NULL;
    if (!out) {
        close(ends[0]);
    }
    return out;
}

/* False where the program is not there, or does not say all that is asked. */
static bool run_baselines(struct baselines *baselines)
{
    pid_t pid = 0;
    FILE *out = start_baselines(&pid);
    if (!out) {
        return false;
    }
    char line[128];
    int known = 0;
    while (fgets(line, sizeof line, out)) {
        char *space = strchr(line, ' ');
        double value = space ? strtod(space, NULL) : 0;
        for (int i = 0; i < BASELINES && space; i++) {
            size_t length = strlen(baselines->name[i]);
            if (line + length == space && memcmp(line, baselines->name[i], length) == 0 && value > 0) {
                baselines->value[i] = value;
                known++;
            }
        }
    }
    fclose(out);
    waitpid(pid, NULL, 0);
    return known == BASELINES;
}

static void add_ratios(struct bench *bench, double space, double plane)
{
    struct baselines baselines = {
        {"dbm_3d_64_step_ms", "dbm_2d_256_step_ms", "dbm_3d_64_bytes", "dla_3d_20k_s", "dla_2d_20k_s"},
        {"ms", "ms", "bytes", "s", "s"},
        {0}};
    if (!run_baselines(&baselines)) {
        snprintf(bench->meaning_text, sizeof bench->meaning_text,
                 "%s\nDBM and DLA are measured in a build with tests alone (FROND_TESTS=ON): they are not there",
                 bench->meaning);
        bench->meaning = bench->meaning_text;
        return;
    }
    for (int i = 0; i < BASELINES; i++) {
        bench_add(bench, baselines.name[i], baselines.value[i], baselines.unit[i], 0);
    }
    bench_add(bench, "dbm_ratio_3d", 1e-3 * baselines.value[0] * SMALL / space, "times", 0);
    bench_add(bench, "dbm_ratio_2d", 1e-3 * baselines.value[1] * SMALL / plane, "times", 0);
    bench_add(bench, "dla_ratio_3d", baselines.value[3] / space, "times", 0);
    bench_add(bench, "dla_ratio_2d", baselines.value[4] / plane, "times", 0);
}

bool bench_growth(struct bench *bench)
{
    const double paper_3d_20k_s = 410; /* figure 3 (a) */
    double ignored, bytes = 0;
    bench->name = "growth";
    bench->meaning =
        "Laplacian growth, eta 3, CPU time of one thread, particles 20k and 1m; frame: the worst of 100 frames with\n"
        "1000 new particles each, in 2D; storm_tick: the same of a scene of lightning; DBM (eta 1): the mean of its\n"
        "first 250 steps, 64^3, or 500, 256^2, for all 20,000; paper: its 410 s over ours";
    double space = grow_s(3, SMALL, LAPLACIAN_AUTO, 3, &ignored), plane = grow_s(2, SMALL, LAPLACIAN_AUTO, 3, &ignored);
    double exact_space = grow_s(3, SMALL, LAPLACIAN_EXACT, 1, &ignored);
    double exact_plane = grow_s(2, SMALL, LAPLACIAN_EXACT, 1, &ignored), frame = worst_frame_ms();
    double tick = worst_tick_ms();
    double large_plane = grow_s(2, LARGE, LAPLACIAN_AUTO, 1, &ignored);
    double large_space = grow_s(3, LARGE, LAPLACIAN_AUTO, 1, &bytes);
    if (space == 0 || plane == 0 || exact_space == 0 || exact_plane == 0 || frame == 0 || tick == 0 ||
        large_plane == 0 || large_space == 0) {
        return false;
    }
    bench_add(bench, "fast_3d_20k_s", space, "s", 0);
    bench_add(bench, "fast_2d_20k_s", plane, "s", 0);
    bench_add(bench, "exact_3d_20k_s", exact_space, "s", 0);
    bench_add(bench, "exact_2d_20k_s", exact_plane, "s", 0);
    bench_add(bench, "fast_3d_1m_s", large_space, "s", 0);
    bench_add(bench, "fast_2d_1m_s", large_plane, "s", 0);
    bench_add(bench, "bytes_per_particle", bytes, "bytes", 0);
    bench_add(bench, "frame_2d_100k_ms", frame, "ms", 0);
    bench_add(bench, "storm_tick_2d_100k_ms", tick, "ms", 0);
    bench_add(bench, "exact_ratio_3d", exact_space / space, "times", 0);
    bench_add(bench, "exact_ratio_2d", exact_plane / plane, "times", 0);
    bench_add(bench, "paper_ratio_3d", paper_3d_20k_s / space, "times", 0);
    add_ratios(bench, space, plane);
    return true;
}
