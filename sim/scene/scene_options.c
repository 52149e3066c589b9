#include "scene_options.h"

#include <math.h>
#include <string.h>

_Static_assert(sizeof(struct growth_def) <= SCENE_OPTIONS_BYTES && sizeof(struct storm_def) <= SCENE_OPTIONS_BYTES &&
                   sizeof(struct dish_def) <= SCENE_OPTIONS_BYTES,
               "there is room for the options of each kind");

struct scene_options scene_options_default(enum scene_kind kind)
{
    struct scene_options options = {.kind = kind};
    if (scene_types[kind]) {
        scene_types[kind]->initial(scene_options_object(&options));
    }
    return options;
}

const struct key *scene_options_keys(enum scene_kind kind)
{
    static const struct key NONE[] = {{.name = NULL}};
    return scene_types[kind] ? scene_types[kind]->options : NONE;
}

void *scene_options_object(struct scene_options *options)
{
    return options->any;
}

bool scene_option_is_value(const struct key *key)
{
    return key->type == KEY_NUMBER || key->type == KEY_INTEGER || key->type == KEY_FLAG || key->type == KEY_CHOICE;
}

bool scene_option_brings(enum scene_kind kind, const struct key *key)
{
    const char *const *name = scene_types[kind] ? scene_types[kind]->brings : NULL;
    while (name && *name && strcmp(*name, key->name) != 0) {
        name++;
    }
    return name && *name;
}

float scene_option_value(const struct scene_options *options, int key)
{
    struct scene_options copy = *options;
    return key_value(&scene_options_keys(options->kind)[key], scene_options_object(&copy));
}

void scene_option_take(struct scene_options *options, int key, float value)
{
    if (scene_types[options->kind]) {
        scene_types[options->kind]->take(scene_options_object(options), key, value);
    }
}

/* Brings `now` to what is wanted, and says by which action; none where they are the same already. */
static int settle(struct scene_options *now, const struct scene_options *wanted, int key, bool always,
                  struct action *action)
{
    float value = scene_option_value(wanted, key);
    if (!always && !(fabsf(scene_option_value(now, key) - value) > 0)) {
        return 0;
    }
    scene_option_take(now, key, value);
    *action = action_default(scene_types[wanted->kind]->sets);
    action->option = key;
    action->value = value;
    return 1;
}

int scene_options_actions(const struct scene_options *options, struct action actions[SCENE_OPTIONS_ACTIONS])
{
    const struct key *keys = scene_options_keys(options->kind);
    struct scene_options now = scene_options_default(options->kind);
    int count = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; keys[i].name && count < SCENE_OPTIONS_ACTIONS; i++) {
            bool brings = scene_option_brings(options->kind, &keys[i]);
            if (brings == (pass == 0) && scene_option_is_value(&keys[i])) {
                count += settle(&now, options, i, brings, &actions[count]);
            }
        }
    }
    return count;
}
