#include "scene.h"

#include "dish.h"
#include "scene_trees.h"
#include "storm.h"
#include "verb.h"

const char *const scene_kind_names[SCENE_KINDS + 1] = {"painting", "trees", "lightning", "chemistry", NULL};
const char *const scene_field_names[SCENE_FIELDS + 1] = {"dark", "along", "around", NULL};

const struct scene_type *const scene_types[SCENE_KINDS] = {
    [SCENE_TREES] = &trees_type,
    [SCENE_LIGHTNING] = &storm_type,
    [SCENE_CHEMISTRY] = &dish_type,
};

enum scene_kind scene_kind_of(enum action_verb verb)
{
    return verbs[verb]->scene;
}

bool scene_takes(enum scene_kind kind, enum action_verb verb)
{
    return verbs[verb]->shared || verbs[verb]->scene == kind;
}

int scene_field_channels(enum scene_field field)
{
    return field == FIELD_ALONG ? 2 : 1;
}
