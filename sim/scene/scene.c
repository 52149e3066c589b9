#include "scene.h"

#include "verb.h"

#define SCENE_NAME(kind, name, type, about)    name,
#define SCENE_MEANING(kind, name, type, about) about,
#define SCENE_EXTERN(kind, name, type, about)  extern const struct scene_type type;
#define SCENE_ENTRY(kind, name, type, about)   [kind] = &(type),

const char *const scene_kind_names[SCENE_KINDS + 1] = {"painting", SCENE_TYPES(SCENE_NAME) NULL};
const char *const scene_kind_meanings[SCENE_KINDS] = {NULL, SCENE_TYPES(SCENE_MEANING)};
const char *const scene_field_names[SCENE_FIELDS + 1] = {"dark", "along", "around", NULL};

SCENE_TYPES(SCENE_EXTERN)
const struct scene_type *const scene_types[SCENE_KINDS] = {SCENE_TYPES(SCENE_ENTRY)};

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
