#include "exhibit.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "exhibit_read.h"
#include "yaml.h"

void exhibit_defaults(const struct key *keys, void *object)
{
    for (; keys->name; keys++) {
        if (!key_is_section(keys)) {
            struct key one[2] = {*keys, {.name = NULL}};
            key_defaults(one, object);
        }
    }
}

static bool read_scalar(struct reader *reader, const struct key *key, const struct yaml_node *node, void *object,
                        void *context)
{
    (void)context;
    return key_is_section(key) || value_read(reader, key, node, object);
}

static const struct value_reading SCALARS = {.read = read_scalar};

const struct yaml_node *exhibit_mapping(struct reader *reader, const struct yaml_node *root, const char *name,
                                        const struct key *keys, void *object)
{
    const struct yaml_node *node = yaml_get(root, name);
    exhibit_defaults(keys, object);
    if (!node || yaml_is_nothing(node)) {
        return NULL;
    }
    size_t length = reader_enter(reader, name);
    if (node->kind == YAML_MAPPING) {
        mapping_read(reader, keys, node, object, &SCALARS);
    } else {
        char allowed[512];
        struct names names = names_of_keys(keys);
        size_t used = (size_t)snprintf(allowed, sizeof allowed, "{key: value, ...}, of keys that are ");
        names_allowed(&names, "", allowed + used, sizeof allowed - used);
        value_wrong_kind(reader, node, allowed);
        node = NULL;
    }
    reader_leave(reader, length);
    return node;
}

bool exhibit_item(struct reader *reader, const struct yaml_node *item, const struct key *keys, void *object,
                  const char *allowed)
{
    exhibit_defaults(keys, object);
    if (item->kind != YAML_MAPPING) {
        value_wrong_kind(reader, item, allowed);
        return false;
    }
    mapping_read(reader, keys, item, object, &SCALARS);
    return true;
}

void exhibit_problem(struct reader *reader, const char *name, const struct yaml_node *at, const char *format, ...)
{
    char message[1400];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    size_t length = reader_enter(reader, name);
    reader_problem(reader, at, "%s", message);
    reader_leave(reader, length);
}

/* In the state folder, and nowhere else. */
static void read_gallery(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit)
{
    const struct yaml_node *node = exhibit_mapping(reader, root, "gallery", gallery_keys, &exhibit->gallery);
    const char *folder = exhibit->gallery.folder;
    if (node && folder && (strchr(folder, '/') || folder[0] == '.')) {
        char found[128];
        const struct yaml_node *at = yaml_get(node, "folder");
        size_t length = reader_enter(reader, "gallery");
        exhibit_problem(reader, "folder", at,
                        "%s is no name of a folder in the state folder; a word without / and "
                        "without a dot before it",
                        yaml_found(at, found, sizeof found));
        reader_leave(reader, length);
    }
}

static void check_mqtt_path(struct reader *reader, const struct yaml_node *node, const char *name, const char *path)
{
    char found[128];
    if (path && (path[0] == '/' || strstr(path, ".."))) {
        const struct yaml_node *at = yaml_get(node, name);
        exhibit_problem(reader, name, at, "%s is not beside this file; a path without .. and without / before it",
                        yaml_found(at, found, sizeof found));
    }
}

/* Names become parts of topics, in which / + and # mean something. */
static void check_mqtt_word(struct reader *reader, const struct yaml_node *node, const char *name, const char *word,
                            const char *forbidden)
{
    char found[128];
    if (word && strpbrk(word, forbidden)) {
        const struct yaml_node *at = yaml_get(node, name);
        exhibit_problem(reader, name, at, "%s is no part of a topic; a text without %s",
                        yaml_found(at, found, sizeof found), forbidden[0] == '/' ? "/, + and #" : "+ and #");
    }
}

static void read_mqtt(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit)
{
    struct exhibit_mqtt *mqtt = &exhibit->mqtt;
    const struct yaml_node *node = exhibit_mapping(reader, root, "mqtt", mqtt_keys, mqtt);
    size_t length = reader_enter(reader, "mqtt");
    if (node) {
        check_mqtt_word(reader, node, "topic", mqtt->topic, "+#");
        check_mqtt_word(reader, node, "name", mqtt->name, "/+#");
        check_mqtt_word(reader, node, "group", mqtt->group, "/+#");
        check_mqtt_path(reader, node, "ca", mqtt->ca);
        check_mqtt_path(reader, node, "certificate", mqtt->certificate);
        check_mqtt_path(reader, node, "key", mqtt->key);
        check_mqtt_path(reader, node, "credentials", mqtt->credentials);
    }
    reader_leave(reader, length);
}

static bool has_switch(const struct inputs *inputs)
{
    for (int i = 0; inputs && i < inputs->binding_count; i++) {
        if (inputs->bindings[i].what == DO_SWITCH) {
            return true;
        }
    }
    return false;
}

/* After the inputs. */
static void read_access(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit)
{
    const struct yaml_node *node = exhibit_mapping(reader, root, "access", access_keys, &exhibit->access);
    if (node && exhibit->access.scan > 0 && !has_switch(exhibit->inputs)) {
        size_t length = reader_enter(reader, "access");
        exhibit_problem(reader, "scan", yaml_get(node, "scan"),
                        "a line that nothing stops; 0, or a binding of the switch: {button: ID, switch: {}}");
        reader_leave(reader, length);
    }
}

static void read_root(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit)
{
    enum { DEGREES = 90 };
    exhibit_defaults(exhibit_keys, exhibit);
    mapping_read(reader, exhibit_keys, root, exhibit, &SCALARS);
    exhibit_mapping(reader, root, "display", display_keys, &exhibit->display);
    exhibit->display.rotation *= DEGREES;
    exhibit_mapping(reader, root, "sheet", sheet_keys, &exhibit->sheet);
    exhibit_read_languages(reader, root, exhibit);
    exhibit_read_words(reader, root, "title", exhibit, &exhibit->title);
    exhibit_read_texts(reader, root, exhibit);
    exhibit_read_scenes(reader, root, exhibit);
    exhibit_read_files(reader, root, exhibit);
    exhibit_read_palette(reader, root, exhibit);
    exhibit_read_seats(reader, root, exhibit);
    exhibit_read_inputs(reader, root, exhibit);
    exhibit_mapping(reader, root, "visit", visit_keys, &exhibit->visit);
    read_access(reader, root, exhibit);
    exhibit_read_hours(reader, root, exhibit);
    read_gallery(reader, root, exhibit);
    exhibit_read_staff(reader, root, exhibit);
    read_mqtt(reader, root, exhibit);
}

static const char *keep(struct reader *reader, const char *text)
{
    size_t size = strlen(text) + 1;
    char *copy = reader_take(reader, size);
    return copy ? memcpy(copy, text, size) : NULL;
}

/* Whose files are named, and where their names are kept. */
struct naming {
    struct reader *reader;
    struct exhibit *exhibit;
};

static void name_file(void *data, const char *folder, const char *path)
{
    struct naming *naming = data;
    struct exhibit *exhibit = naming->exhibit;
    for (int i = 0; i < exhibit->file_count; i++) {
        if (strcmp(exhibit->files[i].path, path) == 0 && strcmp(exhibit->files[i].folder, folder) == 0) {
            return;
        }
    }
    if (exhibit->file_count < EXHIBIT_FILES) {
        struct exhibit_file file = {keep(naming->reader, folder), keep(naming->reader, path)};
        exhibit->files[exhibit->file_count] = file;
        exhibit->file_count += file.folder && file.path;
    }
}

static struct exhibit *parse(const char *text, size_t size, const char *path, const char *folder,
                             const struct script_def *def, struct report *report)
{
    struct yaml *yaml = yaml_parse(text, size, report);
    if (!yaml) {
        return NULL;
    }
    struct exhibit *exhibit = calloc(1, sizeof *exhibit);
    const struct yaml_node *root = yaml_root(yaml);
    if (exhibit) {
        exhibit->memory = calloc(1, sizeof *exhibit->memory);
    }
    if (!exhibit || !exhibit->memory) {
        report_add(report, 0, 0, "", "memory is short");
    } else if (!root) {
        report_add(report, 1, 1, "", "the file is empty; exhibit: 1");
    } else if (root->kind != YAML_MAPPING) {
        char found[128];
        report_add(report, root->line, root->column, "", "%s where an exhibit should be; exhibit: 1, and its keys",
                   yaml_found(root, found, sizeof found));
    } else {
        struct script_def watched = *def;
        struct reader reader = {.report = report, .script = exhibit->memory, .def = &watched, .folder = folder};
        struct naming naming = {&reader, exhibit};
        watched.names = name_file;
        watched.names_data = &naming;
        exhibit->path = keep(&reader, path);
        exhibit->folder = keep(&reader, folder);
        read_root(&reader, root, exhibit);
    }
    yaml_destroy(yaml);
    if (!report_empty(report)) {
        exhibit_destroy(exhibit);
        return NULL;
    }
    return exhibit;
}

struct exhibit *exhibit_parse(const char *text, size_t size, const char *folder, const struct script_def *def,
                              struct report *report)
{
    return parse(text, size, report->file ? report->file : "", folder, def, report);
}

struct exhibit *exhibit_read(const char *path, const struct script_def *def, struct report *report)
{
    size_t size = 0;
    struct exhibit *exhibit = NULL;
    char *text = script_load(path, &size, report);
    char *folder = script_folder(path);
    if (text && folder) {
        exhibit = parse(text, size, path, folder, def, report);
    } else if (text) {
        report_add(report, 0, 0, "", "memory is short");
    }
    free(folder);
    free(text);
    return exhibit;
}

void exhibit_destroy(struct exhibit *exhibit)
{
    if (!exhibit) {
        return;
    }
    for (int i = 0; i < EXHIBIT_SCENES; i++) {
        script_destroy(exhibit->scenes[i].script);
    }
    for (int i = 0; i < EXHIBIT_SESSIONS; i++) {
        script_destroy(exhibit->recorded[i]);
    }
    inputs_destroy(exhibit->inputs);
    script_destroy(exhibit->memory);
    free(exhibit);
}

bool exhibit_is(const char *text, size_t size)
{
    struct report report;
    report_init(&report, "");
    struct yaml *yaml = yaml_parse(text, size, &report);
    const struct yaml_node *root = yaml ? yaml_root(yaml) : NULL;
    bool is = root && root->kind == YAML_MAPPING && yaml_get(root, "exhibit");
    yaml_destroy(yaml);
    report_finish(&report);
    return is;
}
