/* What every engine of the painting can do, whatever it runs on: the CPU engine (engine_cpu_create, the reference,
 * deterministic to the bit) and the GPU engine (painting_gpu.h), which is held to it by tolerance. Textures of what it
 * holds come from publisher.h, for either. An engine belongs to one thread at a time; the GPU engine, moreover, to its
 * GL context. */
#ifndef FROND_ENGINE_H
#define FROND_ENGINE_H

#include "checkpoint.h"
#include "painting.h"
#include "patch.h"

struct engine;

struct engine_ops {
    const char *name; /* "cpu", "gpu" */
    void (*destroy)(struct engine *engine);
    /* These are the way of a frame: they may return before the GPU is done, and none waits for it. */
    void (*act)(struct engine *engine, const struct action *action); /* as painting_act */
    void (*tick)(struct engine *engine);                             /* as painting_tick */
    int64_t (*ticks)(const struct engine *engine);                   /* as painting_ticks */
    struct painting_def (*get_def)(const struct engine *engine);     /* as painting_get_def */
    size_t (*bytes)(const struct engine *engine);                    /* of its state: memory, or the GPU's */
    /* These wait until all that was asked is done, and read back from a GPU: not for the way of a frame. What a lost
     * GPU held reads as 0. */
    void (*finish)(struct engine *engine);
    void (*read)(struct engine *engine, enum painting_field field, float *plane); /* as painting_read */
    struct painting_totals (*totals)(struct engine *engine);                      /* as painting_totals */
    struct painting_effort (*effort)(struct engine *engine); /* of the last tick, in tiles of the engine's own size */
    /* As painting_save and painting_load. False also when memory is short or the GPU is lost: what was to be filled in
     * is then neither old nor new. */
    bool (*save)(struct engine *engine, struct checkpoint *checkpoint);
    bool (*load)(struct engine *engine, const struct checkpoint *checkpoint);
    /* As painting_save_patch, painting_load_patch and painting_changed; false also when memory is short or the GPU is
     * lost. `changed` has a byte for each tile of tiles.h, whatever the engine's own are, and may set more of them than
     * have changed, never fewer. */
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
