#include <stdlib.h>

#include "engine.h"

struct engine_cpu {
    struct engine engine;
    struct painting *painting;
};

static struct painting *painting_of(const struct engine *engine)
{
    return ((const struct engine_cpu *)engine)->painting;
}

static void destroy(struct engine *engine)
{
    painting_destroy(painting_of(engine));
    free(engine);
}

static void act(struct engine *engine, const struct action *action)
{
    painting_act(painting_of(engine), action);
}

static void tick(struct engine *engine)
{
    painting_tick(painting_of(engine));
}

static void finish(struct engine *engine)
{
    (void)engine; /* a tick is done when it returns */
}

static int64_t ticks(const struct engine *engine)
{
    return painting_ticks(painting_of(engine));
}

static struct painting_def get_def(const struct engine *engine)
{
    return painting_get_def(painting_of(engine));
}

static void read_field(struct engine *engine, enum painting_field field, float *plane)
{
    painting_read(painting_of(engine), field, plane);
}

static struct painting_totals totals(struct engine *engine)
{
    return painting_totals(painting_of(engine));
}

static struct painting_effort effort(struct engine *engine)
{
    return painting_effort(painting_of(engine));
}

static size_t bytes(const struct engine *engine)
{
    return painting_bytes(painting_of(engine));
}

static bool save(struct engine *engine, struct checkpoint *checkpoint)
{
    return painting_save(painting_of(engine), checkpoint);
}

static bool load(struct engine *engine, const struct checkpoint *checkpoint)
{
    return painting_load(painting_of(engine), checkpoint);
}

static bool save_patch(struct engine *engine, struct patch *patch)
{
    return painting_save_patch(painting_of(engine), patch);
}

static bool load_patch(struct engine *engine, const struct patch *patch)
{
    return painting_load_patch(painting_of(engine), patch);
}

static bool find_changed(struct engine *engine, uint8_t *changed)
{
    painting_changed(painting_of(engine), changed);
    return true;
}

static const struct engine_ops OPS = {.name = "cpu",
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

struct engine *engine_cpu_create(const struct painting_def *def)
{
    struct engine_cpu *cpu = calloc(1, sizeof *cpu);
    if (!cpu) {
        return NULL;
    }
    cpu->engine.ops = &OPS;
    cpu->painting = painting_create(def);
    if (!cpu->painting) {
        free(cpu);
        return NULL;
    }
    return &cpu->engine;
}

struct painting *engine_cpu_painting(struct engine *engine)
{
    return engine->ops == &OPS ? painting_of(engine) : NULL;
}
