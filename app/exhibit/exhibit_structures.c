/* `structures` of a scene: what grows over a picture, done to every fresh sheet of a painting. */
#include <string.h>

#include "exhibit_read.h"
#include "file_rows.h"
#include "script_structure.h"

enum use { USE_GUIDE, USE_MASK, USE_INK, USE_RELIEF };

struct scene_structure {
    int as; /* enum use */
    float strength;
};

static const char *const USES[] = {"guide", "mask", "ink", "relief", NULL};

const struct key scene_structure_keys[] = {
    CHOICE(
        "as", struct scene_structure, as, USES, USE_GUIDE, false,
        "What it is to the painting: a field that growth follows, the only place where it grows, a dry drawing in the "
        "first ink, or the place where it is lush."),
    NUMBER("strength", struct scene_structure, strength, "share", 0, 1, 0.7, false,
           "Length of the field, darkness of the drawing, how much sparser growth is elsewhere; nothing of a mask."),
    END,
};

static enum action_verb verb_of(int as)
{
    static const enum action_verb VERBS[] = {ACTION_GUIDE, ACTION_MASK, ACTION_DRAW, ACTION_SET};
    return VERBS[as];
}

/* What a structure of a scene does, but for its raster. */
static struct action action_of(const struct scene_structure *structure, const struct script *script)
{
    struct action action = action_default(verb_of(structure->as));
    switch ((enum use)structure->as) {
    case USE_GUIDE:
        action.strength = structure->strength;
        break;
    case USE_MASK:
        action.invert = true;
        break;
    case USE_INK:
        action.amount = structure->strength;
        action.over = OVER_RUN;
        break;
    case USE_RELIEF:
        action.coefficient = (int)(key_find(coefficient_keys, "s_max") - coefficient_keys);
        action.value = script->coefficients.s_max; /* where the raster is dark: on the branches */
        action.to = script->coefficients.s_max * (1 - structure->strength);
        break;
    }
    return action;
}

static void read_structure(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct exhibit_scene *scene = context;
    struct scene_structure structure = {0};
    struct names names = names_of_choices(USES);
    const struct yaml_node *as = item->kind == YAML_MAPPING ? yaml_get(item, "as") : NULL;
    exhibit_defaults(scene_structure_keys, &structure);
    if (as && as->kind == YAML_SCALAR && names_find(&names, as->text) >= 0) {
        structure.as = names_find(&names, as->text); /* the raster depends on it; anything else is reported below */
    }
    struct action action = action_default(verb_of(structure.as));
    (void)index;
    if (script_structure_read(reader, item, &action, scene_structure_keys, &structure)) {
        struct action_raster raster = action.picture;
        action = action_of(&structure, scene->script);
        action.picture = raster;
        scene->ground[scene->ground_count++] = action;
    }
}

void exhibit_read_structures(struct reader *reader, const struct yaml_node *item, struct exhibit_scene *scene)
{
    const struct yaml_node *list = yaml_get(item, "structures");
    if (list && scene->kind != SCENE_PAINTING) {
        exhibit_problem(reader, "structures", list, "in a scene of %s; %s, or kind: painting",
                        exhibit_kind_of_scene(scene->kind), scene_kind_names[scene->kind]);
    } else {
        inputs_list(reader, item, "structures", EXHIBIT_STRUCTURES, "a list of {over: PICTURE, as: guide, ...}",
                    read_structure, scene);
    }
}
