#include "inputs.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "device_class.h"

int inputs_list(struct reader *reader, const struct yaml_node *node, const char *name, int most, const char *allowed,
                void (*read)(struct reader *reader, const struct yaml_node *item, int index, void *context),
                void *context)
{
    const struct yaml_node *list = yaml_get(node, name);
    int index = 0;
    if (!list || yaml_is_nothing(list)) {
        return 0;
    }
    size_t length = reader_enter(reader, name);
    if (list->kind != YAML_LIST) {
        value_wrong_kind(reader, list, allowed);
    } else if (list->count > most) {
        reader_problem(reader, list, "a list of %d; at most %d", list->count, most);
    } else {
        for (const struct yaml_node *item = list->first; item; item = item->next, index++) {
            size_t outer = reader_enter_index(reader, index);
            read(reader, item, index, context);
            reader_leave(reader, outer);
        }
    }
    reader_leave(reader, length);
    return index;
}

static bool read_scalar(struct reader *reader, const struct key *key, const struct yaml_node *node, void *object,
                        void *context)
{
    (void)context;
    return key_is_section(key) || value_read(reader, key, node, object);
}

void inputs_mapping(struct reader *reader, const struct yaml_node *within, const char *name, const struct key *keys,
                    void *object, const char *allowed)
{
    const struct yaml_node *node = yaml_get(within, name);
    struct value_reading reading = {.read = read_scalar};
    if (!node || yaml_is_nothing(node)) {
        return;
    }
    size_t length = reader_enter(reader, name);
    if (node->kind == YAML_MAPPING) {
        mapping_read(reader, keys, node, object, &reading);
    } else {
        value_wrong_kind(reader, node, allowed);
    }
    reader_leave(reader, length);
}

void inputs_defaults(const struct key *keys, void *object)
{
    for (; keys->name; keys++) {
        if (!key_is_section(keys)) {
            struct key one[2] = {*keys, {.name = NULL}};
            key_defaults(one, object);
        }
    }
}

/* `version`: the first row, which a section of an exhibit has not. */
static void read_root(struct reader *reader, const struct yaml_node *root, bool version, struct inputs *inputs)
{
    struct value_reading reading = {.read = read_scalar};
    struct key rows[INPUTS_ROWS];
    inputs_rows(rows);
    inputs_defaults(rows, inputs);
    mapping_read(reader, version ? rows : rows + 1, root, inputs, &reading);
    for (int i = 0; device_classes[i]; i++) {
        device_classes[i]->read(reader, root, inputs);
    }
    inputs_read_bindings(reader, root, inputs);
}

/* What a reader keeps its memory in; its inks and its grid are the session's. */
static struct script *open_memory(const struct script *session)
{
    struct script *memory = calloc(1, sizeof *memory);
    if (memory && session) {
        *memory = *session;
        memory->actions = NULL;
        memory->action_count = 0;
        memory->memory = NULL;
    } else if (memory) {
        key_defaults(canvas_keys, memory);
    }
    return memory;
}

struct inputs *inputs_parse(const char *text, size_t size, const char *folder, const struct script *session,
                            const struct script_def *def, struct report *report)
{
    struct yaml *yaml = yaml_parse(text, size, report);
    if (!yaml) {
        return NULL;
    }
    struct inputs *inputs = calloc(1, sizeof *inputs);
    const struct yaml_node *root = yaml_root(yaml);
    if (inputs) {
        inputs->memory = open_memory(session);
    }
    if (!inputs || !inputs->memory) {
        report_add(report, 0, 0, "", "memory is short");
    } else if (!root) {
        report_add(report, 1, 1, "", "the file is empty; inputs: 1, and a list of bindings");
    } else if (root->kind != YAML_MAPPING) {
        char found[128];
        report_add(report, root->line, root->column, "", "%s where inputs should be; inputs: 1, and a list of bindings",
                   yaml_found(root, found, sizeof found));
    } else {
        struct reader reader = {.report = report, .script = inputs->memory, .def = def, .folder = folder};
        read_root(&reader, root, true, inputs);
    }
    yaml_destroy(yaml);
    if (!report_empty(report)) {
        inputs_destroy(inputs);
        return NULL;
    }
    return inputs;
}

struct inputs *inputs_section(struct reader *outer, const struct yaml_node *node, const struct script *session)
{
    struct inputs *inputs = calloc(1, sizeof *inputs);
    struct reader reader = *outer;
    if (inputs) {
        inputs->memory = open_memory(session);
    }
    if (!inputs || !inputs->memory) {
        report_add(outer->report, 0, 0, "", "memory is short");
        inputs_destroy(inputs);
        return NULL;
    }
    reader.script = inputs->memory;
    read_root(&reader, node, false, inputs);
    outer->raster_values = reader.raster_values;
    return inputs;
}

struct inputs *inputs_read(const char *path, const struct script *session, const struct script_def *def,
                           struct report *report)
{
    size_t size = 0;
    struct inputs *inputs = NULL;
    char *text = script_load(path, &size, report);
    char *folder = script_folder(path);
    if (text && folder) {
        inputs = inputs_parse(text, size, folder, session, def, report);
    }
    free(folder);
    free(text);
    return inputs;
}

void inputs_destroy(struct inputs *inputs)
{
    if (inputs) {
        script_destroy(inputs->memory);
        free(inputs);
    }
}

struct inputs *inputs_default(const struct script *session)
{
    struct script_def def = script_default_def();
    struct report report;
    const char *text = inputs_default_text();
    report_init(&report, "the default inputs");
    struct inputs *inputs = inputs_parse(text, strlen(text), ".", session, &def, &report);
    report_finish(&report);
    return inputs;
}

bool inputs_is(const char *text, size_t size)
{
    struct report report;
    report_init(&report, "");
    struct yaml *yaml = yaml_parse(text, size, &report);
    const struct yaml_node *root = yaml ? yaml_root(yaml) : NULL;
    bool is = root && root->kind == YAML_MAPPING && yaml_get(root, "inputs");
    yaml_destroy(yaml);
    report_finish(&report);
    return is;
}

static bool holds(const char *text, const char *part)
{
    size_t length = strlen(part);
    for (; *text; text++) {
        size_t i = 0;
        while (i < length && text[i] && tolower((unsigned char)text[i]) == tolower((unsigned char)part[i])) {
            i++;
        }
        if (i == length) {
            return true;
        }
    }
    return length == 0;
}

bool inputs_match(const struct inputs_device *wanted, uint16_t vendor, uint16_t product, const char *name)
{
    return (!wanted->vendor || wanted->vendor == vendor) && (!wanted->product || wanted->product == product) &&
           (!wanted->name || holds(name, wanted->name));
}
