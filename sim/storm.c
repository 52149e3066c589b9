#include "storm.h"

#include <stdlib.h>

const struct key storm_keys[] = {
    {.name = "kind",
     .type = KEY_CHOICE,
     .unit = "",
     .choices = bolt_kind_names,
     .offset = offsetof(struct storm_def, kind),
     .meaning = "What grows; another brings its own values of all others."},
    {.name = "eta",
     .type = KEY_NUMBER,
     .unit = "",
     .min = 0,
     .max = 20,
     .initial = 3,
     .offset = offsetof(struct storm_def, eta),
     .meaning = "How much growth prefers what stands out: 0 a round lump, 10 almost a line."},
    {.name = NULL},
};

struct storm {
    struct storm_def def;
};

struct storm_def storm_preset(enum bolt_kind kind)
{
    struct storm_def def = {0};
    key_defaults(storm_keys, &def);
    def.kind = (int)kind;
    return def;
}

void storm_take(struct storm_def *def, int key, float value)
{
    key_take(&storm_keys[key], def, value);
}

struct storm *storm_create(int width, int height)
{
    (void)width, (void)height;
    return calloc(1, sizeof(struct storm));
}

void storm_destroy(struct storm *storm)
{
    free(storm);
}

static bool takes(enum action_verb verb)
{
    return verb == ACTION_STRIKE || verb == ACTION_ATTRACT || verb == ACTION_CONDUCT;
}

static void *create(int width, int height)
{
    return storm_create(width, height);
}

static void destroy(void *scene)
{
    storm_destroy(scene);
}

static void resize(void *scene, int width, int height)
{
    (void)scene, (void)width, (void)height;
}

static void act(void *scene, int64_t tick, const struct action *action)
{
    (void)scene, (void)tick, (void)action;
}

static bool tick(void *scene, int64_t now)
{
    (void)scene, (void)now;
    return true;
}

static uint64_t can(const void *scene)
{
    (void)scene;
    return 0;
}

static bool lay(void *scene, int64_t now, int width, int height, uint8_t *rgb)
{
    (void)scene, (void)now, (void)width, (void)height, (void)rgb;
    return true;
}

static bool field(void *scene, enum scene_field which, int width, int height, float *values)
{
    (void)scene;
    for (int i = 0; i < width * height * scene_field_channels(which); i++) {
        values[i] = 0;
    }
    return true;
}

const struct scene_type storm_type = {
    .name = "lightning",
    .options = storm_keys,
    .sets = ACTION_CONDUCT,
    .takes = takes,
    .create = create,
    .destroy = destroy,
    .resize = resize,
    .act = act,
    .tick = tick,
    .can_undo = can,
    .can_redo = can,
    .lay = lay,
    .field = field,
    .hash = can,
};
