#include "script.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "ink.h"
#include "script_action.h"
#include "script_read.h"
#include "script_value.h"
#include "yaml.h"

const char *const script_modes[] = {"pigment", "cmy", NULL};

#define WHOLE(name, field, unit, min, max, def, need, text)                                                            \
    {                                                                                                                  \
        name, KEY_INTEGER, unit, min, max, def, NULL, offsetof(struct script, field), need, text                       \
    }
#define SECTION(name, text)                                                                                            \
    {                                                                                                                  \
        name, KEY_CHOICE, "section", 0, 0, 0, NULL, 0, false, text                                                     \
    }

const struct key script_keys[] = {
    WHOLE("frond", version, "", SCRIPT_VERSION, SCRIPT_VERSION, SCRIPT_VERSION, true, "The version of the script."),
    SECTION("canvas", "The sheet: width, height and margin."),
    WHOLE("seed", seed, "", 0, 2147483647, 1, false, "Of everything random: another seed is another painting."),
    WHOLE("ticks", ticks, "ticks", 0, SCRIPT_TICKS_MAX, 700, false, "How long the session takes."),
    SECTION("inks", "A list of one to four inks, by name."),
    SECTION("palette", "Four inks at once, by the palette's name, instead of inks; the first palette if left out."),
    {"mode", KEY_CHOICE, "", 0, 0, 0, script_modes, offsetof(struct script, mode), false,
     "How inks are shown: as pigment, in which blue and yellow make green, or subtracted as in the paper."},
    SECTION("painting", "Coefficients of the painting, by name."),
    SECTION("actions", "What is done, as a list of {tick: N, verb: {parameters}}."),
    {.name = NULL},
};

const struct key canvas_keys[] = {
    WHOLE("width", width, "cells", CANVAS_SIZE_MIN, CANVAS_SIZE_MAX, 720, false, "Width of the sheet."),
    WHOLE("height", height, "cells", CANVAS_SIZE_MIN, CANVAS_SIZE_MAX, 720, false, "Height of the sheet."),
    WHOLE("margin", margin, "cells", 0, CANVAS_MARGIN_MAX, 0, false,
          "Cells simulated beyond each side, so that growth does not turn square there."),
    {.name = NULL},
};

const struct key action_tick_keys[] = {
    {"tick", KEY_INTEGER, "ticks", 0, SCRIPT_TICKS_MAX, 0, NULL, 0, true,
     "When it is done; after the session's ticks, never."},
    {"visitor", KEY_INTEGER, "", 0, SCRIPT_VISITORS_MAX, 0, NULL, sizeof(int), false,
     "Who does it; undo and redo of 0 concern whoever acted last."},
    {.name = NULL},
};

struct script_def script_default_def(void)
{
    return (struct script_def){.raster_values_max = SCRIPT_RASTER_VALUES_MAX, .work_max = SCRIPT_WORK_MAX};
}

static bool read_scalar(struct reader *reader, const struct key *key, const struct yaml_node *node, void *object,
                        void *context)
{
    (void)context;
    return key_is_section(key) || value_read(reader, key, node, object); /* sections have readers of their own */
}

static void read_mapping(struct reader *reader, const struct yaml_node *root, const char *name, const struct key *keys,
                         void *object, const char *allowed)
{
    const struct yaml_node *node = yaml_get(root, name);
    if (!node || yaml_is_nothing(node)) {
        return;
    }
    size_t length = reader_enter(reader, name);
    if (node->kind == YAML_MAPPING) {
        mapping_read(reader, keys, node, object, NULL);
    } else {
        value_wrong_kind(reader, node, allowed);
    }
    reader_leave(reader, length);
}

void script_read_painting(struct reader *reader, const struct yaml_node *root)
{
    read_mapping(reader, root, "painting", coefficient_keys, &reader->script->coefficients,
                 "{coefficient: value, ...}");
}

int script_read_inks(struct reader *reader, const struct yaml_node *node, int least, int ink[PAINTING_INKS])
{
    char found[128], allowed[1024], list[64];
    struct names names = names_of_inks();
    snprintf(list, sizeof list, least < PAINTING_INKS ? "a list of 1 to 4 inks, by name" : "a list of 4 inks, by name");
    if (node->kind != YAML_LIST) {
        value_wrong_kind(reader, node, list);
        return 0;
    }
    if (node->count < least || node->count > PAINTING_INKS) {
        reader_problem(reader, node, "a list of %d; %s", node->count, list);
    }
    int count = 0, index = 0;
    for (const struct yaml_node *item = node->first; item && index < PAINTING_INKS; item = item->next, index++) {
        size_t length = reader_enter_index(reader, index);
        bool word = item->kind == YAML_SCALAR && !yaml_is_nothing(item);
        int one = word ? ink_find(item->text) : -1;
        bool again = false;
        for (int i = 0; i < count; i++) {
            again = again || ink[i] == one;
        }
        if (one >= 0 && !again) {
            ink[count++] = one;
        } else if (one >= 0) {
            reader_problem(reader, item, "%s is there already; different inks", yaml_found(item, found, sizeof found));
        } else if (item->kind != YAML_REFUSED) {
            reader_problem(reader, item, word ? "unknown ink %s; %s" : "%s where a name should be; %s",
                           yaml_found(item, found, sizeof found),
                           names_allowed(&names, word ? item->text : "", allowed, sizeof allowed));
        }
        reader_leave(reader, length);
    }
    return count;
}

void script_take_palette(struct script *script, int palette)
{
    for (int i = 0; i < PAINTING_INKS; i++) {
        script->inks[i] = ink_find(palettes[palette].inks[i]);
    }
    script->ink_count = PAINTING_INKS;
}

static void read_inks(struct reader *reader, const struct yaml_node *root)
{
    const struct yaml_node *list = yaml_get(root, "inks"), *palette = yaml_get(root, "palette");
    struct script *script = reader->script;
    script_take_palette(script, 0);
    if (palette) {
        struct names names = names_of_palettes();
        int index = 0;
        size_t length = reader_enter(reader, "palette");
        if (list) {
            reader_problem(reader, palette, "inks are given too; one of the two");
        }
        if (value_choice(reader, &names, "palette", palette, &index)) {
            script_take_palette(script, index);
        }
        reader_leave(reader, length);
    }
    if (list) {
        size_t length = reader_enter(reader, "inks");
        int count = script_read_inks(reader, list, 1, script->inks);
        script->ink_count = count ? count : script->ink_count;
        reader_leave(reader, length);
    }
}

static void sort_actions(struct action *actions, struct action *spare, int count)
{
    if (count < 2) {
        return;
    }
    int half = count / 2, i = 0, j = half;
    sort_actions(actions, spare, half);
    sort_actions(actions + half, spare, count - half);
    for (int k = 0; k < count; k++) { /* a merge: what stands first in the file stays first within its tick */
        bool left = i < half && (j >= count || actions[i].tick <= actions[j].tick);
        spare[k] = left ? actions[i++] : actions[j++];
    }
    memcpy(actions, spare, (size_t)count * sizeof *actions);
}

/* What a garden is asked for before there is anything to grow over. */
struct too_early {
    int64_t stocked; /* the first tick with a picture; INT64_MAX: none */
    int64_t planted; /* the first tick with a seed, */
    int index;       /* of the action that has it, */
    const struct yaml_node *at;
};

static void look_early(struct too_early *early, const struct action *action, const struct yaml_node *at, int index)
{
    if (action->verb == ACTION_STOCK && action->tick < early->stocked) {
        early->stocked = action->tick;
    }
    if (action->verb == ACTION_PLANT && action->tick < early->planted) {
        *early = (struct too_early){early->stocked, action->tick, index, at};
    }
}

static void tell_early(struct reader *reader, const struct too_early *early)
{
    if (early->planted < early->stocked) {
        size_t length = reader_enter_index(reader, early->index);
        reader_enter(reader, "plant");
        reader_problem(reader, early->at, "there is no picture yet; a stock before it, or at the same tick");
        reader_leave(reader, length);
    }
}

static void read_actions(struct reader *reader, const struct yaml_node *root)
{
    const struct yaml_node *node = yaml_get(root, "actions");
    if (!node || yaml_is_nothing(node)) {
        return;
    }
    size_t length = reader_enter(reader, "actions");
    if (node->kind != YAML_LIST) {
        value_wrong_kind(reader, node, "a list of {tick: N, verb: {...}}");
    } else if (node->count > SCRIPT_ACTIONS_MAX) {
        reader_problem(reader, node, "%d actions; at most %d", node->count, SCRIPT_ACTIONS_MAX);
    } else {
        struct action *actions = reader_take(reader, (size_t)node->count * sizeof *actions);
        struct action *spare = malloc((size_t)(node->count + 1) * sizeof *spare);
        struct too_early early = {.stocked = INT64_MAX, .planted = INT64_MAX};
        int index = 0, count = 0;
        for (const struct yaml_node *item = node->first; actions && item; item = item->next, index++) {
            size_t outer = reader_enter_index(reader, index);
            if (script_action_read(reader, item, &actions[count])) {
                look_early(&early, &actions[count++], item, index);
            }
            reader_leave(reader, outer);
        }
        if (count == index) { /* else it may be the picture that is wrong */
            tell_early(reader, &early);
        }
        if (actions && spare) {
            sort_actions(actions, spare, count);
        } else {
            report_add(reader->report, 0, 0, "", "memory is short");
        }
        free(spare);
        reader->script->actions = actions;
        reader->script->action_count = count;
    }
    reader_leave(reader, length);
}

static void read_root(struct reader *reader, const struct yaml_node *root)
{
    struct script *script = reader->script;
    struct value_reading reading = {.read = read_scalar};
    mapping_read(reader, script_keys, root, script, &reading);
    read_mapping(reader, root, "canvas", canvas_keys, script, "{width: cells, height: cells, margin: cells}");
    script_read_painting(reader, root);
    read_inks(reader, root); /* before the actions, which name them, wherever they stand in the file */
    read_actions(reader, root);
}

void script_defaults(struct script *script)
{
    key_defaults(canvas_keys, script);
    for (const struct key *key = script_keys; key->name; key++) {
        if (!key_is_section(key)) {
            struct key one[2] = {*key, {.name = NULL}};
            key_defaults(one, script);
        }
    }
    script->coefficients = coefficients_default();
}

struct script *script_parse(const char *text, size_t size, const char *folder, const struct script_def *def,
                            struct report *report)
{
    struct yaml *yaml = yaml_parse(text, size, report);
    if (!yaml) {
        return NULL;
    }
    struct script *script = calloc(1, sizeof *script);
    const struct yaml_node *root = yaml_root(yaml);
    if (!script) {
        report_add(report, 0, 0, "", "memory is short");
    } else if (!root) {
        report_add(report, 1, 1, "", "the file is empty; frond: 1, and a list of actions");
    } else if (root->kind != YAML_MAPPING) {
        char found[128];
        report_add(report, root->line, root->column, "",
                   "%s where a session should be; frond: 1, and a list of actions",
                   yaml_found(root, found, sizeof found));
    } else {
        script_defaults(script);
        struct reader reader = {.report = report, .script = script, .def = def, .folder = folder};
        read_root(&reader, root);
    }
    yaml_destroy(yaml);
    if (!report_empty(report)) {
        script_destroy(script);
        return NULL;
    }
    return script;
}

/* One byte more than is allowed, so that yaml_parse can tell. */
char *script_load(const char *path, size_t *size, struct report *report)
{
    FILE *file = fopen(path, "rb");
    char *text = file ? malloc(YAML_SIZE_MAX + 1) : NULL;
    *size = text ? fread(text, 1, YAML_SIZE_MAX + 1, file) : 0;
    if (!file || (text && ferror(file))) {
        report_add(report, 0, 0, "", "cannot be read: %s", strerror(errno));
        free(text);
        text = NULL;
    } else if (!text) {
        report_add(report, 0, 0, "", "memory is short");
    }
    if (file) {
        fclose(file);
    }
    return text;
}

char *script_folder(const char *path)
{
    const char *slash = strrchr(path, '/');
    if (!slash) {
        return strdup(".");
    }
    return slash == path ? strdup("/") : strndup(path, (size_t)(slash - path)); /* "/a.yaml" is in "/" */
}

struct script *script_read(const char *path, const struct script_def *def, struct report *report)
{
    size_t size = 0;
    char *text = script_load(path, &size, report);
    char *folder = script_folder(path);
    struct script *script = NULL;
    if (text && folder) {
        script = script_parse(text, size, folder, def, report);
    }
    free(folder);
    free(text);
    return script;
}

void script_destroy(struct script *script)
{
    if (!script) {
        return;
    }
    while (script->memory) {
        struct script_memory *next = script->memory->next;
        free(script->memory->block);
        free(script->memory);
        script->memory = next;
    }
    free(script);
}
