#include "outcome.h"

#include <stdlib.h>
#include <string.h>

#include "along.h"
#include "exponential.h"
#include "rounded.h"
#include "running.h"

static const float SOON = 2.0f; /* how soon ink is dark: a thickness of 1 covers 86 of 100 */

static float bounded(float value)
{
    float inside = value >= 0 ? value <= 1 ? value : 1 : 0;
    return rounded(inside);
}

static bool open_fields(struct outcome *outcome, int width, int height)
{
    size_t cells = (size_t)width * (size_t)height;
    bool good = true;
    *outcome = (struct outcome){.width = width, .height = height};
    for (int i = 0; i < SCENE_FIELDS; i++) {
        size_t count = cells * (size_t)scene_field_channels((enum scene_field)i);
        outcome->fields[i] = calloc(count, sizeof(float));
        good = good && outcome->fields[i];
    }
    if (!good) {
        outcome_finish(outcome);
    }
    return good;
}

void outcome_finish(struct outcome *outcome)
{
    for (int i = 0; i < SCENE_FIELDS; i++) {
        free(outcome->fields[i]);
    }
    *outcome = (struct outcome){.width = 0};
}

/* Of a painting: the sum of its inks (optical thickness) and its solvent, width * height values of each. */
static bool of_painting(struct outcome *outcome, const float *thickness, const float *solvent, int width, int height)
{
    size_t cells = (size_t)width * (size_t)height;
    if (!open_fields(outcome, width, height)) {
        return false;
    }
    for (size_t i = 0; i < cells; i++) {
        outcome->fields[FIELD_DARK][i] = bounded(exponential(-SOON * thickness[i]));
        outcome->fields[FIELD_AROUND][i] = bounded(1 - solvent[i]);
    }
    bool good = along_of_pattern(outcome->fields[FIELD_DARK], width, height, outcome->fields[FIELD_ALONG]);
    if (!good) {
        outcome_finish(outcome);
    }
    return good;
}

bool outcome_of_scene(struct outcome *outcome, const struct scene_type *type, void *scene, int width, int height)
{
    if (!open_fields(outcome, width, height)) {
        return false;
    }
    bool good = true;
    for (int i = 0; i < SCENE_FIELDS && good; i++) {
        good = type->field(scene, (enum scene_field)i, width, height, outcome->fields[i]);
    }
    if (!good) {
        outcome_finish(outcome);
    }
    return good;
}

static void merge_least(float *into, const float *other, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        into[i] = other[i] < into[i] ? other[i] : into[i];
    }
}

static void merge_longest(float *into, const float *other, size_t cells)
{
    for (size_t i = 0; i < cells; i++) {
        float square = into[i] * into[i] + into[cells + i] * into[cells + i];
        if (other[i] * other[i] + other[cells + i] * other[cells + i] > square) {
            into[i] = other[i];
            into[cells + i] = other[cells + i];
        }
    }
}

/* What one scene beside the painting adds; `spare` has room for two channels. */
static bool merge_scene(struct outcome *outcome, const struct scene_type *type, void *scene, float *spare)
{
    size_t cells = (size_t)outcome->width * (size_t)outcome->height;
    for (int i = 0; i < SCENE_FIELDS; i++) {
        if (!type->field(scene, (enum scene_field)i, outcome->width, outcome->height, spare)) {
            return false;
        }
        if (i == FIELD_ALONG) {
            merge_longest(outcome->fields[i], spare, cells);
        } else {
            merge_least(outcome->fields[i], spare, cells);
        }
    }
    return true;
}

bool outcome_take(struct outcome *outcome, struct engine *engine, struct plot *plot, int ink_count)
{
    struct painting_def def = engine->ops->get_def(engine);
    size_t cells = (size_t)def.width * (size_t)def.height;
    float *planes = calloc(3 * cells, sizeof *planes);
    float *thickness = planes, *spare = planes ? planes + cells : NULL;
    bool good = planes;
    *outcome = (struct outcome){.width = 0};
    for (int i = 0; i < 2 * ink_count && good; i++) {
        int first = i < ink_count ? PAINTING_WET : PAINTING_DRY;
        engine->ops->read(engine, (enum painting_field)(first + i % ink_count), spare);
        for (size_t k = 0; k < cells; k++) {
            thickness[k] += spare[k];
        }
    }
    if (good) {
        engine->ops->read(engine, PAINTING_SOLVENT, spare);
        good = of_painting(outcome, thickness, spare, def.width, def.height);
    }
    for (int kind = 0; kind < SCENE_KINDS && plot && good; kind++) {
        void *scene = plot_scene(plot, (enum scene_kind)kind);
        good = !scene || merge_scene(outcome, scene_types[kind], scene, spare);
    }
    if (!good) {
        outcome_finish(outcome);
    }
    free(planes);
    return good;
}

bool outcome_grow(struct outcome *outcome, const struct script *script, int64_t ticks, int threads,
                  const atomic_bool *stop, struct file_error *error)
{
    struct running running;
    struct easel_def def = {.engine = ENGINE_CPU, .threads = threads};
    bool good = running_open(&running, script, &def, error);
    *outcome = (struct outcome){.width = 0};
    for (int64_t tick = 0; tick <= ticks && good; tick++) {
        if (stop && atomic_load(stop)) {
            good = file_fail(error, "the session", "it was stopped");
            break;
        }
        running_act(&running, tick, NULL, NULL);
        good = running_plot(&running, tick, error);
        if (good && tick < ticks) {
            running_tick(&running);
        }
    }
    if (good) {
        running.engine->ops->finish(running.engine);
        good = outcome_take(outcome, running.engine, running.plot, script->ink_count) ||
               file_fail(error, "the session", "memory is short for what it comes to");
    }
    running_close(&running);
    return good;
}
