#include "gpu_case.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

struct display *gpu_display(void)
{
    struct display_def def = display_default_def();
    struct device_error error = {""};
    def.kind = DISPLAY_HEADLESS;
    def.width = def.height = 16;
    struct display *display = display_create(&def, &error);
    if (!display) {
        fail_msg("no display: %s", error.text);
    }
    assert_true(display_begin(display));
    return display;
}

struct engine *gpu_engine(const struct painting_def *def)
{
    struct shader_error error = {""};
    struct engine *engine = engine_gpu_create(def, NULL, &error);
    if (!engine) {
        fail_msg("no GPU engine: %s", error.text);
    }
    return engine;
}

void gpu_case_init(struct gpu_case *both, const struct painting_def *def)
{
    both->display = gpu_display();
    both->gpu = gpu_engine(def);
    both->cpu = engine_cpu_create(def);
    assert_non_null(both->cpu);
    assert_true(checkpoint_init(&both->gpu_state, def));
    assert_true(checkpoint_init(&both->cpu_state, def));
}

void gpu_case_finish(struct gpu_case *both)
{
    engine_destroy(both->gpu);
    engine_destroy(both->cpu);
    checkpoint_finish(&both->gpu_state);
    checkpoint_finish(&both->cpu_state);
    display_destroy(both->display);
}

void gpu_case_act(struct gpu_case *both, const struct action *action)
{
    both->gpu->ops->act(both->gpu, action);
    both->cpu->ops->act(both->cpu, action);
}

void gpu_case_tick(struct gpu_case *both, int ticks)
{
    for (int tick = 0; tick < ticks; tick++) {
        both->gpu->ops->tick(both->gpu);
        both->cpu->ops->tick(both->cpu);
    }
}

void gpu_case_load(struct gpu_case *both, const struct checkpoint *checkpoint)
{
    assert_true(both->gpu->ops->load(both->gpu, checkpoint));
    assert_true(both->cpu->ops->load(both->cpu, checkpoint));
}

static bool is_apart(float one, float other, double within)
{
    return !(fabs((double)one - (double)other) <= within * (1.0 + fabs((double)one)));
}

int64_t gpu_differences(const struct checkpoint *one, const struct checkpoint *other, double within)
{
    size_t values = CHECKPOINT_PLANES * (size_t)one->width * (size_t)one->height;
    int64_t apart = 0;
    for (size_t i = 0; i < values; i++) {
        apart += is_apart(one->planes[i], other->planes[i], within);
    }
    return apart;
}

static void report(const struct checkpoint *cpu, const struct checkpoint *gpu, double within, int64_t apart)
{
    size_t plane = (size_t)cpu->width * (size_t)cpu->height, worst = 0;
    for (size_t i = 0; i < CHECKPOINT_PLANES * plane; i++) {
        if (is_apart(cpu->planes[i], gpu->planes[i], within) &&
            !(fabsf(cpu->planes[i] - gpu->planes[i]) <= fabsf(cpu->planes[worst] - gpu->planes[worst]))) {
            worst = i;
        }
    }
    fail_msg("%lld values apart, the worst in plane %zu at (%zu, %zu): %.9g on the CPU, %.9g on the GPU",
             (long long)apart, worst / plane, worst % plane % (size_t)cpu->width, worst % plane / (size_t)cpu->width,
             (double)cpu->planes[worst], (double)gpu->planes[worst]);
}

static void compare_ground(const struct checkpoint *cpu, const struct checkpoint *gpu)
{
    for (int y = 0; y < cpu->height; y++) {
        for (int x = 0; x < cpu->width; x++) {
            bool same = ground_obstacle(cpu->ground, y)[x] == ground_obstacle(gpu->ground, y)[x] &&
                        ground_weight(cpu->ground, y)[x] == ground_weight(gpu->ground, y)[x] &&
                        ground_guide(cpu->ground, 0, y)[x] == ground_guide(gpu->ground, 0, y)[x] &&
                        ground_guide(cpu->ground, 1, y)[x] == ground_guide(gpu->ground, 1, y)[x];
            for (int map = 0; map < MAPS; map++) {
                same = same &&
                       ground_map(cpu->ground, (enum map)map, y)[x] == ground_map(gpu->ground, (enum map)map, y)[x];
            }
            assert_true(same);
        }
    }
}

void gpu_case_compare(struct gpu_case *both, double within, int outliers)
{
    struct checkpoint *cpu = &both->cpu_state, *gpu = &both->gpu_state;
    assert_true(both->cpu->ops->save(both->cpu, cpu));
    assert_true(both->gpu->ops->save(both->gpu, gpu));
    int64_t apart = gpu_differences(cpu, gpu, within);
    if (apart > outliers) {
        report(cpu, gpu, within, apart);
    }
    compare_ground(cpu, gpu);
    assert_int_equal(gpu->tick, cpu->tick);
    assert_int_equal(gpu->quiet_periods, cpu->quiet_periods);
    double liquid = fabs(cpu->evaporated) + 1, ink = fabs(cpu->ink_dried) + 1;
    assert_true(fabs(gpu->evaporated - cpu->evaporated) <= 1e-3 * liquid);
    assert_true(fabs(gpu->ink_dried - cpu->ink_dried) <= 1e-3 * ink);
}
