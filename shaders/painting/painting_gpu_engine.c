/* The GPU engine as engine.h wants it: what painting_gpu_state.h lists, put together. */
#include <stdlib.h>

#include <GLES3/gl31.h>

#include "painting_gpu_state.h"

static struct painting_gpu *gpu_of(struct engine *engine)
{
    return (struct painting_gpu *)engine;
}

static void destroy(struct engine *engine)
{
    struct painting_gpu *gpu = gpu_of(engine);
    gpu_act_destroy(gpu);
    gpu_rolling_destroy(gpu);
    ground_destroy(gpu->ground);
    gpu_destroy(gpu);
}

static void act(struct engine *engine, const struct action *action)
{
    gpu_act(gpu_of(engine), action);
}

static void tick(struct engine *engine)
{
    struct painting_gpu *gpu = gpu_of(engine);
    gpu_steps_tick(gpu);
    if (gpu->tick % UPKEEP_TICKS == 0) {
        gpu_upkeep_run(gpu);
    }
}

static void finish(struct engine *engine)
{
    (void)engine;
    glFinish();
}

static int64_t ticks(const struct engine *engine)
{
    return ((const struct painting_gpu *)engine)->tick;
}

static struct painting_def get_def(const struct engine *engine)
{
    return ((const struct painting_gpu *)engine)->def;
}

static void read_field(struct engine *engine, enum painting_field field, float *plane)
{
    gpu_read_field(gpu_of(engine), field, plane);
}

static struct painting_totals totals(struct engine *engine)
{
    return gpu_read_totals(gpu_of(engine));
}

static struct painting_effort effort(struct engine *engine)
{
    return gpu_steps_effort(gpu_of(engine));
}

static size_t bytes(const struct engine *engine)
{
    return gpu_read_bytes_taken((const struct painting_gpu *)engine);
}

static bool save(struct engine *engine, struct checkpoint *checkpoint)
{
    return gpu_save(gpu_of(engine), checkpoint);
}

static bool load(struct engine *engine, const struct checkpoint *checkpoint)
{
    return gpu_load(gpu_of(engine), checkpoint);
}

static bool save_patch(struct engine *engine, struct patch *patch)
{
    return gpu_save_patch(gpu_of(engine), patch);
}

static bool load_patch(struct engine *engine, const struct patch *patch)
{
    return gpu_load_patch(gpu_of(engine), patch);
}

static bool find_changed(struct engine *engine, uint8_t *changed)
{
    return gpu_find_changed(gpu_of(engine), changed);
}

static const struct engine_ops OPS = {.name = "gpu",
                                      .destroy = destroy,
                                      .act = act,
                                      .tick = tick,
                                      .finish = finish,
                                      .ticks = ticks,
                                      .get_def = get_def,
                                      .read = read_field,
                                      .totals = totals,
                                      .effort = effort,
                                      .bytes = bytes,
                                      .save = save,
                                      .load = load,
                                      .save_patch = save_patch,
                                      .load_patch = load_patch,
                                      .changed = find_changed};

static bool add_parts(struct painting_gpu *gpu, struct shader_error *error)
{
    gpu->ground = ground_create(&gpu->def);
    if (!gpu->ground) {
        return shader_fail(error, "memory is short");
    }
    return gpu_rolling_create(gpu, error) && gpu_act_create(gpu, error);
}

struct engine *engine_gpu_create(const struct painting_def *def, const struct shader_folder *folder,
                                 struct shader_error *error)
{
    struct painting_gpu *gpu = gpu_create(def, folder, error);
    if (!gpu) {
        return NULL;
    }
    gpu->engine.ops = &OPS;
    if (!add_parts(gpu, error)) {
        destroy(&gpu->engine);
        return NULL;
    }
    gpu_act_upload_ground(gpu);
    gpu_steps_touch(gpu, (struct rectangle){0, gpu->width, 0, gpu->height});
    return &gpu->engine;
}

bool engine_gpu_reload(struct engine *engine, struct shader_error *error)
{
    return gpu_programs_make(gpu_of(engine), error);
}
