/* What every engine of the painting can do, whatever it runs on: the CPU engine (engine_cpu_create, the reference,
 * deterministic to the bit) and the GPU engine (painting_gpu.h), which is held to it by tolerance.
 * An engine belongs to one thread at a time; the GPU engine, moreover, to its GL context. */
#ifndef FROND_ENGINE_H
#define FROND_ENGINE_H

#include "checkpoint.h"
#include "painting.h"
#include "patch.h"

struct engine;

struct engine_ops {
    const char *name; /* "cpu", "gpu" */
    void (*destroy)(struct engine *engine);
    void (*act)(struct engine *engine, const struct action *action); /* as painting_act */
    void (*tick)(struct engine *engine);   /* as painting_tick; the GPU's may still be under way */
    void (*finish)(struct engine *engine); /* waits for all ticks to be done */
    int64_t (*ticks)(const struct engine *engine);
    struct painting_def (*get_def)(const struct engine *engine); /* with the coefficients of now */
    /* These wait for the engine, and read back from a GPU: not for the way of a frame. */
    void (*read)(struct engine *engine, enum painting_field field, float *plane);
    struct painting_totals (*totals)(struct engine *engine);
    struct painting_effort (*effort)(struct engine *engine);
    size_t (*bytes)(const struct engine *engine); /* of its state */
    /* False when memory is short or the GPU is lost; a checkpoint of another size of sheet is refused. */
    bool (*save)(struct engine *engine, struct checkpoint *checkpoint);
    bool (*load)(struct engine *engine, const struct checkpoint *checkpoint);
    /* As painting_save_patch, painting_load_patch and painting_changed; they, too, wait for the engine and read back.
     * False moreover when the GPU is lost. `changed` may set more tiles than have changed, never fewer. */
    bool (*save_patch)(struct engine *engine, struct patch *patch);
    bool (*load_patch)(struct engine *engine, const struct patch *patch);
    bool (*changed)(struct engine *engine, uint8_t *changed);
};

struct engine { /* first member of every engine */
    const struct engine_ops *ops;
};

/* The CPU engine. NULL as painting_create. */
struct engine *engine_cpu_create(const struct painting_def *def);
/* Its painting; NULL for any other engine. */
struct painting *engine_cpu_painting(struct engine *engine);

static inline void engine_destroy(struct engine *engine) /* takes NULL */
{
    if (engine) {
        engine->ops->destroy(engine);
    }
}

#endif
