#include "script_structure.h"

#include <stdlib.h>
#include <string.h>

#include "pictures.h"
#include "script_action.h"

static int add_keys(struct key *keys, int count, const struct key *more, size_t offset)
{
    for (; more && more->name && count < SCRIPT_STRUCTURE_KEYS - 1; more++) {
        keys[count] = *more;
        keys[count++].offset += offset;
    }
    return count;
}

void script_structure_keys(struct key keys[SCRIPT_STRUCTURE_KEYS])
{
    int count = 0;
    keys[count++] = (struct key){.name = "over",
                                 .type = KEY_TEXT,
                                 .unit = "the path of a picture in this file's folder",
                                 .min = 1,
                                 .max = 1000,
                                 .offset = offsetof(struct script_structure, over),
                                 .required = true,
                                 .meaning = "The picture that it grows over."};
    count = add_keys(keys, count, structure_keys, offsetof(struct script_structure, structure));
    count = add_keys(keys, count, growth_keys, offsetof(struct script_structure, growth));
    keys[count] = (struct key){.name = NULL};
}

static size_t size_of(const struct key *key)
{
    switch (key->type) {
    case KEY_FLAG:
        return sizeof(bool);
    case KEY_POINT:
        return sizeof(struct point);
    case KEY_PATH:
        return sizeof(struct action_path);
    case KEY_TEXT:
        return sizeof(const char *);
    default:
        return key->type == KEY_NUMBER ? sizeof(float) : sizeof(int);
    }
}

struct reading {
    const struct key *more;
    void *object;
};

/* A key of the caller's goes to the caller's. */
static bool read_one(struct reader *reader, const struct key *key, const struct yaml_node *node, void *object,
                     void *context)
{
    struct reading *reading = context;
    const struct key *own = reading->more ? key_find(reading->more, key->name) : NULL;
    return own ? value_read(reader, own, node, reading->object) : value_read(reader, key, node, object);
}

/* What is given, over the values that suit the metaphor. */
static bool read_keys(struct reader *reader, const struct yaml_node *node, struct script_structure *structure,
                      struct reading *reading)
{
    struct key keys[SCRIPT_STRUCTURE_KEYS];
    struct script_structure given = {.over = NULL};
    int before = reader->report->count + reader->report->dropped, own = 0;
    script_structure_keys(keys);
    while (keys[own].name) {
        own++;
    }
    keys[add_keys(keys, own, reading->more, 0)] = (struct key){.name = NULL};
    uint64_t which = mapping_read(reader, keys, node, &given, &(struct value_reading){read_one, reading});
    key_defaults(structure_keys, &structure->structure);
    structure->growth = growth_preset((enum metaphor)given.growth.metaphor, given.growth.tree);
    for (int i = 0; i < own; i++) {
        if (which & (uint64_t)1 << i) {
            memcpy((char *)structure + keys[i].offset, (char *)&given + keys[i].offset, size_of(&keys[i]));
        }
    }
    int plants = structure->growth.plants.count;
    structure->growth.plants.count = plants < GROWTH_PLANTS_MAX ? plants : GROWTH_PLANTS_MAX;
    return reader->report->count + reader->report->dropped == before;
}

static bool grow(struct reader *reader, const struct yaml_node *node, const struct script_structure *structure,
                 struct action *action)
{
    struct file_error error;
    int width = reader->script->width, height = reader->script->height;
    enum structure_kind kind = action->verb == ACTION_GUIDE ? STRUCTURE_ALONG : STRUCTURE_DARK;
    int channels = kind == STRUCTURE_ALONG ? 2 : 1;
    size_t count = (size_t)width * (size_t)height * (size_t)channels;
    const struct yaml_node *over = yaml_get(node, "over");
    struct script_picture picture = {0};
    size_t length = reader_enter(reader, "over");
    bool good = reader->def->load || (reader_problem(reader, over, "pictures cannot be read here; a formula can"), 0);
    reader_names(reader, structure->over);
    if (good && !reader->def->load(reader->def->data, reader->folder, structure->over, &picture, &error)) {
        reader_problem(reader, over, "%s", error.text);
        good = false;
    }
    reader_leave(reader, length);
    float *values =
        good && script_take_values(reader, node, count) ? reader_take(reader, count * sizeof *values) : NULL;
    if (values) {
        const struct image image = pictures_image(&picture);
        action->picture = (struct action_raster){values, width, height, channels};
        good = structure_raster(&image, &structure->growth, &structure->structure, kind, width, height, values);
        if (!good) {
            reader_problem(reader, node, "memory is short");
        }
    }
    free(picture.values);
    return good && values;
}

bool script_structure_read(struct reader *reader, const struct yaml_node *node, struct action *action,
                           const struct key *more, void *object)
{
    struct script_structure structure = {.over = NULL};
    struct reading reading = {more, object};
    if (node->kind != YAML_MAPPING) {
        value_wrong_kind(reader, node, "{over: PICTURE, metaphor: ink, ...}; see frond explain structure");
        return false;
    }
    return read_keys(reader, node, &structure, &reading) && grow(reader, node, &structure, action);
}
