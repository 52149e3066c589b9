/* `trees`, `lightning`, `chemistry` of a scene: what can be set of its kind; and `opening`, what is done on every fresh
 * sheet of it. */
#include <string.h>

#include "exhibit_read.h"
#include "script_action.h"

static const struct key OVER = {.name = "over",
                                .type = KEY_TEXT,
                                .unit = "the path of a picture",
                                .min = 1,
                                .max = EXHIBIT_PATH_BYTES,
                                .offset = offsetof(struct exhibit_scene, picture),
                                .meaning = "The picture that comes first, beside this file, and the only one without a "
                                           "folder `pictures`."};

const char *exhibit_kind_of_scene(int kind)
{
    return kind == SCENE_PAINTING ? "paintings" : scene_kind_names[kind];
}

void exhibit_options_keys(enum scene_kind kind, struct key keys[EXHIBIT_OPTIONS_KEYS])
{
    int count = 0; /* growth_keys has a `picture` already: what one costs */
    if (kind == SCENE_TREES) {
        keys[count++] = OVER;
    }
    for (const struct key *key = scene_options_keys(kind); key->name && count < EXHIBIT_OPTIONS_KEYS - 1; key++) {
        if (scene_option_is_value(key)) {
            keys[count] = *key;
            keys[count++].offset += offsetof(struct exhibit_scene, options.any);
        }
    }
    keys[count] = (struct key){.name = NULL};
}

static size_t size_of(const struct key *key)
{
    return key->type == KEY_NUMBER ? sizeof(float) : key->type == KEY_FLAG ? sizeof(bool) : sizeof(int);
}

/* What is given, over the values that it brings: those that bring others first. */
static void read_values(struct reader *reader, const struct yaml_node *node, struct exhibit_scene *scene)
{
    struct key keys[EXHIBIT_OPTIONS_KEYS];
    struct exhibit_scene given = *scene;
    const struct key *table = scene_options_keys((enum scene_kind)scene->kind);
    exhibit_options_keys((enum scene_kind)scene->kind, keys);
    uint64_t which = mapping_read(reader, keys, node, &given, NULL);
    scene->picture = given.picture;
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; keys[i].name; i++) {
            const struct key *key = key_find(table, keys[i].name);
            if (!(which & (uint64_t)1 << i) || !key) {
                continue;
            }
            bool brings = scene_option_brings((enum scene_kind)scene->kind, key);
            if (pass == 0 && brings) {
                scene_option_take(&scene->options, (int)(key - table),
                                  scene_option_value(&given.options, (int)(key - table)));
            } else if (pass == 1 && !brings) { /* whole numbers are more exact than a value of the table */
                memcpy((char *)scene + keys[i].offset, (char *)&given + keys[i].offset, size_of(&keys[i]));
            }
        }
    }
}

static void check_picture(struct reader *reader, const struct yaml_node *node, const struct exhibit_scene *scene)
{
    size_t length = reader_enter(reader, "over");
    exhibit_check_picture(reader, yaml_get(node, "over"), scene->picture);
    reader_leave(reader, length);
}

/* The section of one kind; NULL where there is none that can be read. */
static const struct yaml_node *read_section(struct reader *reader, const struct yaml_node *item, enum scene_kind kind,
                                            struct exhibit_scene *scene)
{
    const char *name = scene_kind_names[kind];
    const struct yaml_node *node = yaml_get(item, name);
    char allowed[160];
    if (!node || yaml_is_nothing(node)) {
        return NULL;
    }
    size_t length = reader_enter(reader, name);
    if (scene->kind != (int)kind) {
        reader_problem(reader, node, "in a scene of %s; kind: %s, or no %s", exhibit_kind_of_scene(scene->kind), name,
                       name);
    } else if (node->kind != YAML_MAPPING) {
        const struct key *first = scene_options_keys(kind);
        snprintf(allowed, sizeof allowed, "{%s: %s, ...}; see frond explain %s", first->name,
                 first->type == KEY_CHOICE ? first->choices[0] : "VALUE", name);
        value_wrong_kind(reader, node, allowed);
    } else {
        read_values(reader, node, scene);
    }
    reader_leave(reader, length);
    return node;
}

void exhibit_read_options(struct reader *reader, const struct yaml_node *item, const struct exhibit *exhibit,
                          struct exhibit_scene *scene)
{
    const struct yaml_node *trees = NULL;
    scene->options = scene_options_default((enum scene_kind)scene->kind);
    for (int kind = SCENE_PAINTING + 1; kind < SCENE_KINDS; kind++) {
        const struct yaml_node *node = read_section(reader, item, (enum scene_kind)kind, scene);
        trees = kind == SCENE_TREES ? node : trees;
    }
    size_t length = reader_enter(reader, scene_kind_names[SCENE_TREES]);
    if (scene->picture) {
        check_picture(reader, trees, scene);
    } else if (scene->kind == SCENE_TREES && !exhibit_is_fed(item, PORT_PICTURE) && exhibit_is_bare(exhibit)) {
        exhibit_problem(reader, "over", trees ? trees : item,
                        "no picture to grow over; a path, or pictures: FOLDER in this file's folder, with one in it");
    }
    reader_leave(reader, length);
}

static void read_opening(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct exhibit_scene *scene = context;
    struct action action;
    (void)index;
    if (!script_action_at_once(reader, item, &action)) {
        return;
    }
    if (scene_takes((enum scene_kind)scene->kind, action.verb) && action.verb != ACTION_UNDO &&
        action.verb != ACTION_REDO) {
        scene->ground[scene->ground_count++] = action;
    } else {
        exhibit_problem(reader, action_name(action.verb), item,
                        "does nothing to a fresh sheet of a scene of %s; another verb",
                        exhibit_kind_of_scene(scene->kind));
    }
}

void exhibit_read_opening(struct reader *reader, const struct yaml_node *item, struct exhibit_scene *scene)
{
    inputs_list(reader, item, "opening", EXHIBIT_OPENING, "a list of {verb: {...}}", read_opening, scene);
}
