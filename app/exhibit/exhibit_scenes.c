/* Palettes of the exhibit's own, and its scenes. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "exhibit_read.h"
#include "ink.h"
#include "script_action.h"
#include "script_read.h"

enum { GROUND_ACTIONS = 2 + EXHIBIT_STRUCTURES + EXHIBIT_OPENING };

struct scenes_reading {
    struct exhibit *exhibit;
    struct exhibit_inks palettes[EXHIBIT_PALETTES];
    int palette_count;
};

static void read_palette(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct scenes_reading *scenes = context;
    struct exhibit_inks *palette = &scenes->palettes[scenes->palette_count];
    (void)index;
    if (!exhibit_item(reader, item, palettes_keys, palette, "{id: WORD, inks: [INK, INK, INK, INK]}")) {
        return;
    }
    const struct yaml_node *id = yaml_get(item, "id"), *list = yaml_get(item, "inks");
    bool again = false;
    for (int i = 0; i < scenes->palette_count && palette->id; i++) {
        again = again || (scenes->palettes[i].id && strcmp(scenes->palettes[i].id, palette->id) == 0);
    }
    if (again) {
        exhibit_problem(reader, "id", id, "'%s' is there already; another word", palette->id);
    } else if (palette->id && palette_find(palette->id) != PALETTE_NONE) {
        exhibit_problem(reader, "id", id, "'%s' is a palette that comes with Frond; another word", palette->id);
    }
    if (list) {
        size_t length = reader_enter(reader, "inks");
        palette->count = script_read_inks(reader, list, PAINTING_INKS, palette->inks);
        reader_leave(reader, length);
    } else {
        exhibit_problem(reader, "inks", item, "missing; a list of 4 inks, by name");
    }
    scenes->palette_count++;
}

/* One of the exhibit's own, or a shipped one. */
static void take_palette(struct reader *reader, const struct yaml_node *node, const struct scenes_reading *scenes)
{
    struct names names = {.count = 0}, shipped = names_of_palettes();
    struct script *script = reader->script;
    int index = 0;
    for (int i = 0; i < scenes->palette_count; i++) {
        names.names[names.count++] = scenes->palettes[i].id ? scenes->palettes[i].id : "";
    }
    for (int i = 0; i < shipped.count && names.count < NAMES_MAX; i++) {
        names.names[names.count++] = shipped.names[i];
    }
    if (!value_choice(reader, &names, "palette", node, &index)) {
        return;
    }
    if (index >= scenes->palette_count) {
        script_take_palette(script, index - scenes->palette_count);
    } else if (scenes->palettes[index].count == PAINTING_INKS) {
        memcpy(script->inks, scenes->palettes[index].inks, sizeof script->inks);
    }
}

static void read_inks(struct reader *reader, const struct yaml_node *item, const struct scenes_reading *scenes)
{
    const struct yaml_node *list = yaml_get(item, "inks"), *palette = yaml_get(item, "palette");
    struct script *script = reader->script;
    if (palette) {
        size_t length = reader_enter(reader, "palette");
        if (list) {
            reader_problem(reader, palette, "inks are given too; one of the two");
        }
        take_palette(reader, palette, scenes);
        reader_leave(reader, length);
    }
    if (list) {
        size_t length = reader_enter(reader, "inks");
        int count = script_read_inks(reader, list, 1, script->inks);
        script->ink_count = count ? count : script->ink_count;
        reader_leave(reader, length);
    }
}

/* A picture of the scene as what it does to a fresh sheet. */
static void read_picture(struct reader *reader, const struct yaml_node *item, const char *name, enum action_verb verb,
                         struct exhibit_scene *scene)
{
    const struct yaml_node *node = (verb == ACTION_MASK ? scene->mask : scene->guide) ? yaml_get(item, name) : NULL;
    struct action action = action_default(verb);
    action.reading = READ_ALONG_EDGES;
    size_t length = reader_enter(reader, name);
    if (node && script_action_picture(reader, node, &action)) {
        scene->ground[scene->ground_count++] = action;
    }
    reader_leave(reader, length);
}

/* A script of the sheet's size and with every default, for the scene and for its memory. */
static struct script *create_script(const struct exhibit_sheet *sheet)
{
    static const double SHAPE = 1.6; /* width over height, until the screen is known */
    struct script *script = calloc(1, sizeof *script);
    if (script) {
        script_defaults(script);
        script_take_palette(script, 0);
        script->width = (int)(sqrt(sheet->cells * SHAPE) + 0.5);
        script->height = (int)(sqrt(sheet->cells / SHAPE) + 0.5);
        script->margin = sheet->margin;
        script->seed = sheet->seed;
    }
    return script;
}

static bool open_scene(struct reader *reader, const struct exhibit *exhibit, struct exhibit_scene *scene)
{
    scene->script = create_script(&exhibit->sheet);
    if (!scene->script) {
        report_add(reader->report, 0, 0, "", "memory is short");
        return false;
    }
    reader->script = scene->script;
    scene->ground = reader_take(reader, GROUND_ACTIONS * sizeof *scene->ground);
    return scene->ground;
}

static bool read_scene_key(struct reader *reader, const struct key *key, const struct yaml_node *node, void *object,
                           void *context)
{
    return key_is_section(key) || value_read(reader, key, node, strcmp(key->name, "mode") == 0 ? context : object);
}

static void check_id(struct reader *reader, const struct yaml_node *item, const struct exhibit *exhibit)
{
    const struct exhibit_scene *scene = &exhibit->scenes[exhibit->scene_count];
    for (int i = 0; i < exhibit->scene_count; i++) {
        const char *id = exhibit->scenes[i].id;
        if (scene->id && id && strcmp(id, scene->id) == 0) {
            exhibit_problem(reader, "id", yaml_get(item, "id"), "'%s' is there already; another word", id);
            return;
        }
    }
}

static void read_scene(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct scenes_reading *scenes = context;
    struct exhibit *exhibit = scenes->exhibit;
    struct exhibit_scene *scene = &exhibit->scenes[exhibit->scene_count];
    struct script *outer = reader->script;
    (void)index;
    if (item->kind != YAML_MAPPING) {
        value_wrong_kind(reader, item, "{id: WORD, inks: [...], painting: {...}}; see frond explain scenes");
        return;
    }
    if (!scene->script && open_scene(reader, exhibit, scene)) {
        struct value_reading reading = {read_scene_key, scene->script};
        mapping_read(reader, scene_keys, item, scene, &reading);
        check_id(reader, item, exhibit);
        exhibit_read_words(reader, item, "title", exhibit, &scene->title);
        exhibit_read_options(reader, item, exhibit, scene);
        read_inks(reader, item, scenes);
        script_read_painting(reader, item);
        read_picture(reader, item, "mask", ACTION_MASK, scene);
        read_picture(reader, item, "guide", ACTION_GUIDE, scene);
        exhibit_read_structures(reader, item, scene);
        scene->opening = scene->ground_count;
        exhibit_read_feeds(reader, item, scene);
        exhibit_read_opening(reader, item, scene);
        exhibit->scene_count++;
    }
    reader->script = outer;
}

void exhibit_read_scenes(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit)
{
    static const char ALLOWED[] = "a list of {id: WORD, inks: [...], painting: {...}}";
    struct scenes_reading scenes = {.exhibit = exhibit};
    struct script *outer = reader->script;
    inputs_list(reader, root, "palettes", EXHIBIT_PALETTES, "a list of {id: WORD, inks: [INK, INK, INK, INK]}",
                read_palette, &scenes);
    inputs_list(reader, root, "scenes", EXHIBIT_SCENES, ALLOWED, read_scene, &scenes);
    if (exhibit->scene_count == 0 && open_scene(reader, exhibit, &exhibit->scenes[0])) {
        exhibit->scenes[0].id = "paper";
        exhibit->scene_count = 1;
    }
    reader->script = outer;
    exhibit_check_feeds(reader, root, exhibit);
}
