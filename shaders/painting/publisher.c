#include "publisher.h"

#include <pthread.h>
#include <stdlib.h>

#include <GLES3/gl31.h>

#include "painting_gpu.h"

enum { NOBODY = -1 };

struct publisher {
    pthread_mutex_t lock; /* of what follows; never held over GL work */
    int shown;            /* the slot that the display reads, or NOBODY */
    bool pending;         /* the other one is filled */
    GLsync filled;        /* the GPU has filled it */
    GLsync released;      /* the GPU has read the slot that was shown before */

    struct fields slots[2];
    bool xray;
    float *texels[FIELDS_COUNT]; /* an engine of the CPU writes here first */
    int width, height;           /* cells of `texels` */
};

struct publisher *publisher_create(bool xray)
{
    struct publisher *publisher = calloc(1, sizeof *publisher);
    if (publisher && pthread_mutex_init(&publisher->lock, NULL) != 0) {
        free(publisher);
        return NULL;
    }
    if (publisher) {
        publisher->shown = NOBODY;
        publisher->xray = xray;
    }
    return publisher;
}

void publisher_destroy(struct publisher *publisher, bool lost)
{
    if (!publisher) {
        return;
    }
    for (int i = 0; i < 2 && !lost; i++) {
        fields_finish(&publisher->slots[i]);
    }
    if (!lost) {
        glDeleteSync(publisher->filled); /* none is a sync of 0: ignored */
        glDeleteSync(publisher->released);
    }
    for (int i = 0; i < FIELDS_COUNT; i++) {
        free(publisher->texels[i]);
    }
    pthread_mutex_destroy(&publisher->lock);
    free(publisher);
}

static bool fit_slot(struct fields *slot, int width, int height, bool xray)
{
    if (slot->width == width && slot->height == height) {
        return true;
    }
    fields_finish(slot);
    return fields_create(slot, width, height, xray);
}

static bool fit_texels(struct publisher *publisher, int width, int height)
{
    int wanted = publisher->xray ? FIELDS_COUNT : FIELDS_PICTURE_COUNT;
    if (publisher->width == width && publisher->height == height) {
        return true;
    }
    publisher->width = publisher->height = 0;
    for (int i = 0; i < wanted; i++) {
        free(publisher->texels[i]);
        publisher->texels[i] = malloc((size_t)width * (size_t)height * 4 * sizeof(float));
        if (!publisher->texels[i]) {
            return false;
        }
    }
    publisher->width = width;
    publisher->height = height;
    return true;
}

static bool fill(struct publisher *publisher, struct fields *slot, struct engine *engine)
{
    struct painting_def def = engine->ops->get_def(engine);
    struct painting *painting = engine_cpu_painting(engine);
    if (!fit_slot(slot, def.width, def.height, publisher->xray)) {
        return false;
    }
    if (!painting) {
        engine_gpu_publish(engine, slot);
        return true;
    }
    if (!fit_texels(publisher, def.width, def.height)) {
        return false;
    }
    painting_publish(painting, &(struct painting_texels){.ground = publisher->texels[FIELDS_GROUND],
                                                         .ink = publisher->texels[FIELDS_INK],
                                                         .pattern = publisher->texels[FIELDS_PATTERN],
                                                         .vectors = publisher->texels[FIELDS_VECTORS]});
    fields_upload(slot, (const float *const *)publisher->texels);
    return true;
}

bool publisher_publish(struct publisher *publisher, struct engine *engine, uint64_t number)
{
    pthread_mutex_lock(&publisher->lock);
    bool pending = publisher->pending;
    int slot = publisher->shown == 0 ? 1 : 0;
    GLsync released = publisher->released;
    if (!pending) {
        publisher->released = NULL;
    }
    pthread_mutex_unlock(&publisher->lock);
    if (pending) {
        return false;
    }
    if (released) { /* the GPU waits, not this thread */
        glWaitSync(released, 0, GL_TIMEOUT_IGNORED);
        glDeleteSync(released);
    }
    if (!fill(publisher, &publisher->slots[slot], engine)) {
        return false;
    }
    publisher->slots[slot].number = number;
    GLsync filled = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();
    pthread_mutex_lock(&publisher->lock);
    publisher->filled = filled;
    publisher->pending = true;
    pthread_mutex_unlock(&publisher->lock);
    return true;
}

const struct fields *publisher_newest(struct publisher *publisher, bool *fresh)
{
    *fresh = false;
    pthread_mutex_lock(&publisher->lock);
    if (publisher->pending && glClientWaitSync(publisher->filled, 0, 0) != GL_TIMEOUT_EXPIRED) {
        glDeleteSync(publisher->filled);
        publisher->filled = NULL;
        if (publisher->shown != NOBODY) {
            publisher->released = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
            glFlush();
        }
        publisher->shown = publisher->shown == 0 ? 1 : 0;
        publisher->pending = false;
        *fresh = true;
    }
    int shown = publisher->shown;
    pthread_mutex_unlock(&publisher->lock);
    return shown == NOBODY ? NULL : &publisher->slots[shown];
}
