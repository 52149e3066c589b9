#include "dish.h"

#include <stdlib.h>

const struct key dish_keys[] = {
    {.name = "feed",
     .type = KEY_NUMBER,
     .unit = "per unit of time",
     .min = 0,
     .max = 0.15,
     .initial = 0.037,
     .offset = offsetof(struct dish_def, reaction.feed),
     .meaning = "How fast fresh u comes, and everything is thinned."},
    {.name = NULL},
};

struct dish {
    struct dish_def def;
};

struct dish_def dish_default_def(void)
{
    struct dish_def def = {0};
    key_defaults(dish_keys, &def);

    return def;
}

void dish_take(struct dish_def *def, int key, float value)
{
    key_take(&dish_keys[key], def, value);
}

struct dish *dish_create(int width, int height)
{
    (void)width, (void)height;
    return calloc(1, sizeof(struct dish));
}

void dish_destroy(struct dish *dish)
{
    free(dish);
}

static bool takes(enum action_verb verb)
{
    return verb == ACTION_DOSE || verb == ACTION_REACT || verb == ACTION_STYLE;
}

static void *create(int width, int height)
{
    return dish_create(width, height);
}

static void destroy(void *scene)
{
    dish_destroy(scene);
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

const struct scene_type dish_type = {
    .name = "chemistry",
    .options = dish_keys,
    .sets = ACTION_REACT,
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
