/* `trees` of a scene: the options of frond grow, and the picture that comes first. */
#include <string.h>

#include "exhibit_read.h"

void exhibit_trees_keys(struct key keys[EXHIBIT_TREES_KEYS])
{
    int count = 0; /* growth_keys has a `picture` already: what one costs */
    keys[count++] = (struct key){.name = "over",
                                 .type = KEY_TEXT,
                                 .unit = "the path of a picture",
                                 .min = 1,
                                 .max = EXHIBIT_PATH_BYTES,
                                 .offset = offsetof(struct exhibit_scene, picture),
                                 .meaning = "The picture that comes first, beside this file, and the only one without "
                                            "a folder `pictures`."};
    for (const struct key *key = growth_keys; key->name && count < EXHIBIT_TREES_KEYS - 1; key++) {
        if (key->type != KEY_PATH && key->type != KEY_POINT) {
            keys[count] = *key;
            keys[count++].offset += offsetof(struct exhibit_scene, growth);
        }
    }
    keys[count] = (struct key){.name = NULL};
}

static size_t size_of(const struct key *key)
{
    return key->type == KEY_NUMBER ? sizeof(float) : key->type == KEY_FLAG ? sizeof(bool) : sizeof(int);
}

/* What is given, over the values that suit the metaphor. */
static void read_growth(struct reader *reader, const struct yaml_node *node, struct exhibit_scene *scene)
{
    struct key keys[EXHIBIT_TREES_KEYS];
    struct exhibit_scene given = *scene;
    exhibit_trees_keys(keys);
    uint64_t which = mapping_read(reader, keys, node, &given, NULL);
    scene->picture = given.picture;
    scene->growth = growth_preset((enum metaphor)given.growth.metaphor, given.growth.tree);
    for (int i = 1; keys[i].name; i++) {
        if (which & (uint64_t)1 << i) {
            memcpy((char *)scene + keys[i].offset, (char *)&given + keys[i].offset, size_of(&keys[i]));
        }
    }
}

static void check_picture(struct reader *reader, const struct yaml_node *node, const struct exhibit_scene *scene)
{
    size_t length = reader_enter(reader, "over");
    exhibit_check_picture(reader, yaml_get(node, "over"), scene->picture);
    reader_leave(reader, length);
}

void exhibit_read_trees(struct reader *reader, const struct yaml_node *item, const struct exhibit *exhibit,
                        struct exhibit_scene *scene)
{
    const struct yaml_node *node = yaml_get(item, "trees");
    size_t length = reader_enter(reader, "trees");
    scene->growth = growth_preset(METAPHOR_INK, false);
    node = node && !yaml_is_nothing(node) ? node : NULL;
    if (node && scene->kind != SCENE_TREES) {
        reader_problem(reader, node, "in a scene of paintings; kind: trees, or no trees");
    } else if (node && node->kind != YAML_MAPPING) {
        value_wrong_kind(reader, node, "{metaphor: ink, endpoints: 3000, ...}; see frond explain trees");
    } else if (node) {
        read_growth(reader, node, scene);
    }
    if (scene->picture) {
        check_picture(reader, node, scene);
    } else if (scene->kind == SCENE_TREES && exhibit_is_bare(exhibit)) {
        exhibit_problem(reader, "over", node ? node : item,
                        "no picture to grow over; a path, or pictures: FOLDER in this file's folder, with one in it");
    }
    reader_leave(reader, length);
}
