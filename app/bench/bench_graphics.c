/* `frond bench gpu`: the GPU engine and its picture, on what GL there is, and what that foretells of boards. */
#include <stdio.h>
#include <stdlib.h>

#include "bench.h"
#include "bench_board.h"
#include "bench_gpu.h"
#include "bench_picture_gpu.h"
#include "display.h"
#include "random.h"

enum { BOARD_CELLS = 720 * 720, PICTURE_WIDTH = 1280, PICTURE_HEIGHT = 720, PANEL_PIXELS = 1920 * 1080 };

static void add_layers(struct bench *bench, const struct bench_gpu *gpu)
{
    static const char *const WALL[] = {"openness_ms", "fluid_ms", "pattern_ms"};
    static const char *const BYTES[] = {"openness_bytes", "fluid_bytes", "pattern_bytes"};
    static const char *const OPERATIONS[] = {"openness_operations", "fluid_operations", "pattern_operations"};
    for (int i = 0; i < BENCH_GPU_LAYERS; i++) {
        bench_add(bench, WALL[i], gpu->layers[i].wall_ms, "ms/tick", 0);
    }
    for (int i = 0; i < BENCH_GPU_LAYERS; i++) {
        bench_add(bench, BYTES[i], gpu->layers[i].bytes, "bytes/cell/tick", 0);
        bench_add(bench, OPERATIONS[i], gpu->layers[i].operations, "operations/cell/tick", 0);
    }
    const struct bench_gpu_layer *pattern = &gpu->layers[BENCH_GPU_PATTERN], *fluid = &gpu->layers[BENCH_GPU_FLUID];
    double cells = (double)gpu->width * gpu->height;
    bench_add(bench, "pattern_mcellsteps_per_cpu_s_256", cells * pattern->steps / (1e3 * pattern->cpu_ms),
              "million cell-steps/CPU-s", 0);
    bench_add(bench, "fluid_mcellsteps_per_cpu_s_256", cells * fluid->steps / (1e3 * fluid->cpu_ms),
              "million cell-steps/CPU-s", 0);
}

/* Ticks a second of a 720x720 sheet that is awake everywhere, and with a tenth of it awake; pictures a second. */
static void add_predictions(struct bench *bench, const struct bench_gpu *gpu, const struct picture_gpu_cost *picture)
{
    static const char *const DENSE[] = {"predicted_pi4_dense_720", "predicted_pi5_dense_720",
                                        "predicted_rk3588_dense_720"};
    static const char *const TENTH[] = {"predicted_pi4_tenth_720", "predicted_pi5_tenth_720",
                                        "predicted_rk3588_tenth_720"};
    static const char *const PICTURE[] = {"predicted_pi4_picture_1080", "predicted_pi5_picture_1080",
                                          "predicted_rk3588_picture_1080"};
    for (int i = 0; bench_boards[i].name; i++) {
        double tick_s = 0;
        for (int layer = 0; layer < BENCH_GPU_LAYERS; layer++) {
            tick_s += bench_board_s(&bench_boards[i], gpu->layers[layer].bytes * BOARD_CELLS,
                                    gpu->layers[layer].operations * BOARD_CELLS);
        }
        double picture_s =
            bench_board_s(&bench_boards[i], picture->bytes * PANEL_PIXELS, picture->operations * PANEL_PIXELS);
        bench_add(bench, DENSE[i], 1 / tick_s, "ticks/s, a prediction", 0);
        bench_add(bench, TENTH[i], 10 / tick_s, "ticks/s, a prediction", 0);
        bench_add(bench, PICTURE[i], 1 / picture_s, "pictures/s, a prediction", 0);
    }
}

/* The picture of a painting that fills its sheet. */
static bool add_picture(struct bench *bench, const struct bench_gpu *gpu, struct display *display,
                        struct shader_error *error)
{
    enum { CELLS_X = 480, CELLS_Y = 270, TIMES = 3 };
    struct picture_def def = picture_default_def();
    struct fields fields = {0};
    def.width = PICTURE_WIDTH;
    def.height = PICTURE_HEIGHT;
    def.cells_x = CELLS_X;
    def.cells_y = CELLS_Y;
    struct picture_gpu *picture = picture_gpu_create(&def, NULL, error);
    float *texels = calloc((size_t)CELLS_X * CELLS_Y * 4, sizeof *texels);
    bool good = picture && texels && fields_create(&fields, CELLS_X, CELLS_Y, false);
    if (good) {
        for (int i = 0; i < CELLS_X * CELLS_Y * 4; i++) {
            texels[i] = 0.3f + 0.2f * random_unit(i % 4, i / 4, 1, RANDOM_GRAIN); /* inked everywhere */
        }
        const float *all[FIELDS_COUNT] = {[FIELDS_GROUND] = texels, [FIELDS_INK] = texels};
        fields_upload(&fields, all);
        struct picture_gpu_time time =
            picture_gpu_time(picture, &fields, display_framebuffer(display), TIMES, bench_wall_s);
        struct picture_gpu_cost cost = picture_gpu_count(picture);
        bench_add(bench, "picture_ms_1280x720", time.shade_ms, "ms", 0);
        bench_add(bench, "picture_present_ms", time.present_ms, "ms", 0);
        bench_add(bench, "picture_fetches", cost.fetches, "fetches/pixel", 0);
        bench_add(bench, "picture_bytes", cost.bytes, "bytes/pixel", 0);
        bench_add(bench, "picture_operations", cost.operations, "operations/pixel", 0);
        add_predictions(bench, gpu, &cost);
    }
    free(texels);
    fields_finish(&fields);
    picture_gpu_destroy(picture);
    return good;
}

bool bench_graphics(struct bench *bench)
{
    struct display_def def = display_default_def();
    struct device_error reason;
    struct shader_error error;
    struct bench_gpu gpu;
    bench->name = "gpu";
    def.kind = DISPLAY_HEADLESS;
    def.width = PICTURE_WIDTH;
    def.height = PICTURE_HEIGHT;
    struct display *display = display_create(&def, &reason);
    if (!display) {
        snprintf(bench->meaning_text, sizeof bench->meaning_text, "%s", reason.text);
        return false;
    }
    bool good = bench_gpu_run(&gpu, 256, GPU_WAYS, &error);
    if (good) {
        snprintf(bench->meaning_text, sizeof bench->meaning_text,
                 "the GPU engine at 256x256 cells, all awake, on %.100s;\nits picture at 1280x720; predictions by the "
                 "roofline from the bytes and operations counted here and published figures of the boards",
                 gpu.renderer);
        add_layers(bench, &gpu);
        good = add_picture(bench, &gpu, display, &error);
    }
    if (!good) {
        snprintf(bench->meaning_text, sizeof bench->meaning_text, "%.300s", error.text);
    }
    bench->meaning = bench->meaning_text;
    display_destroy(display);
    return good;
}
