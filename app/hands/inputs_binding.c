#include <string.h>

#include "device_class.h"
#include "exhibit.h"
#include "script_action.h"
#include "stroke.h"
#include "verb.h"

/* What a binding is made of, before it is put together. */
struct parts {
    struct key rows[INPUTS_ROWS]; /* its own keys, the verbs, the actions that are no verbs */
    const struct inputs *inputs;
    const struct binding_source *from;                           /* NULL: touch */
    const struct yaml_node *source, *controller, *length, *tool; /* NULL: not given */
    const struct yaml_node *what;                                /* the parameters of the action */
    const char *what_name, *source_name;
};

static void fill_rows(struct parts *parts)
{
    inputs_binding_rows(parts->rows);
    int count = key_count(parts->rows);
    for (int i = 0; i < ACTION_VERBS && count + 1 < INPUTS_ROWS; i++) {
        enum action_verb verb = (enum action_verb)i;
        if (key_find(binding_do_keys, action_name(verb))) {
            continue; /* the visitor's own, below */
        }
        parts->rows[count++] = (struct key){.name = action_name(verb), .type = KEY_CHOICE, .unit = "section"};
    }
    for (const struct key *key = binding_do_keys; key->name && count + 1 < INPUTS_ROWS; key++) {
        parts->rows[count++] = *key;
    }
    parts->rows[count] = (struct key){.name = NULL};
}

static void take_source(struct reader *reader, struct parts *parts, const char *name, const struct yaml_node *node)
{
    if (parts->source_name) {
        reader_problem(reader, node, "a second source, after %s; a binding has one", parts->source_name);
        return;
    }
    parts->source_name = name;
}

static const struct binding_source *find_source(const char *name)
{
    for (int i = 0; device_classes[i]; i++) {
        for (const struct binding_source *from = device_classes[i]->sources; from->key.name; from++) {
            if (strcmp(from->key.name, name) == 0) {
                return from;
            }
        }
    }
    return NULL;
}

/* What has a reader of its own is put aside; its text, where it is one, is looked at later. */
static bool read_part(struct reader *reader, const struct key *key, const struct yaml_node *node, void *object,
                      void *context)
{
    struct parts *parts = context;
    if (!key_is_section(key)) {
        if (strcmp(key->name, "touch") == 0) {
            take_source(reader, parts, key->name, node);
        }
        parts->tool = strcmp(key->name, "tool") == 0 ? node : parts->tool;
        return value_read(reader, key, node, object);
    }
    const struct binding_source *from = find_source(key->name);
    if (from) {
        parts->from = from;
        parts->source = node;
        take_source(reader, parts, key->name, node);
        return true;
    }
    if (strcmp(key->name, "controller") == 0 || strcmp(key->name, "length") == 0) {
        *(strcmp(key->name, "length") == 0 ? &parts->length : &parts->controller) = node;
        return true;
    }
    if (parts->what_name) {
        reader_problem(reader, node, "a second action, after %s; a binding has one", parts->what_name);
        return false;
    }
    parts->what = node;
    parts->what_name = key->name;
    return true;
}

const char *inputs_word(struct reader *reader, const struct yaml_node *node, const char *allowed)
{
    char found[128];
    if (node->kind == YAML_REFUSED) {
        return NULL;
    }
    if (node->kind != YAML_SCALAR || yaml_is_nothing(node)) {
        reader_problem(reader, node, "%s where a name should be; %s", yaml_found(node, found, sizeof found), allowed);
        return NULL;
    }
    return node->text;
}

int inputs_find(struct reader *reader, const char *what, const char *list, const struct yaml_node *node,
                const struct names *names)
{
    char allowed[1200], none[64];
    const char *text = NULL;
    int index = -1;
    size_t length = reader_enter(reader, what);
    snprintf(none, sizeof none, "there are none in %s", list);
    names_allowed(names, node->kind == YAML_SCALAR ? node->text : "", allowed, sizeof allowed);
    text = inputs_word(reader, node, names->count ? allowed : none);
    index = text ? names_find(names, text) : -1;
    if (text && index < 0) {
        char found[128];
        reader_problem(reader, node, "unknown %s %s; %s", what, yaml_found(node, found, sizeof found),
                       names->count ? allowed : none);
    }
    reader_leave(reader, length);
    return index;
}

static struct names names_of_devices(const struct inputs_device *devices, int count)
{
    struct names names = {.count = 0};
    for (int i = 0; i < count; i++) {
        names.names[names.count++] = devices[i].id ? devices[i].id : "";
    }
    return names;
}

/* "touch, key, usage, ...", or those that a device can be named with. */
static void list_sources(char *text, size_t size, bool devices)
{
    size_t length = (size_t)snprintf(text, size, "%s", devices ? "" : "touch");
    for (int i = 0; device_classes[i]; i++) {
        for (const struct binding_source *from = device_classes[i]->sources; from->key.name; from++) {
            if (length < size && (from->devices || !devices)) {
                length += (size_t)snprintf(text + length, size - length, "%s%s",
                                           length == 0 ? ""
                                           : devices   ? " or "
                                                       : ", ",
                                           from->key.name);
            }
        }
    }
}

static bool read_source(struct reader *reader, const struct yaml_node *item, const struct parts *parts,
                        struct binding *binding)
{
    const struct binding_source *from = parts->from;
    char all[256];
    binding->device = -1;
    binding->source = from;
    if (!parts->source_name) {
        list_sources(all, sizeof all, false);
        reader_problem(reader, item, "no source is given; one of %s", all);
        return false;
    }
    if (from) {
        from->read(reader, parts->source, parts->inputs, binding);
    }
    if (from && parts->tool) {
        size_t length = reader_enter(reader, "tool");
        reader_problem(reader, parts->tool, "goes with touch, not with %s; fingers have tools", parts->source_name);
        reader_leave(reader, length);
    }
    if (parts->controller && from && from->devices) {
        int count = 0;
        const struct inputs_device *devices = from->devices(parts->inputs, &count);
        struct names names = names_of_devices(devices, count);
        binding->device = inputs_find(reader, "controller", from->list, parts->controller, &names);
    } else if (parts->controller) {
        list_sources(all, sizeof all, true);
        size_t length = reader_enter(reader, "controller");
        reader_problem(reader, parts->controller, "goes with %s, not with %s", all, parts->source_name);
        reader_leave(reader, length);
    }
    return true;
}

/* A switch is told both when it goes down and when it comes up. */
static void check_switch(struct reader *reader, const struct yaml_node *item, const struct yaml_node *when,
                         const struct binding *binding)
{
    bool gesture = !binding->source && binding->touch != TOUCH_PRESS;
    if (binding->what != DO_SWITCH) {
        return;
    }
    size_t length = reader_enter(reader, "switch");
    if (gesture || (binding->source && binding->source->turned)) {
        reader_problem(reader, yaml_get(item, "switch"),
                       "goes down and comes up; touch: press, a usage, a button or a key");
    } else if (when && binding->when != PRESS_DOWN) {
        reader_problem(reader, yaml_get(item, "switch"), "is told of every press and its end; without when");
    }
    reader_leave(reader, length);
}

/* What `when` is where none is given, and whether the one that is fits the source. */
static void read_when(struct reader *reader, const struct yaml_node *item, struct binding *binding)
{
    static const int OF_TOUCH[] = {
        [TOUCH_PRESS] = PRESS_DOWN,  [TOUCH_TAP] = PRESS_SHORT,  [TOUCH_LONG] = PRESS_HOLD,
        [TOUCH_DRAG] = BINDING_MOVE, [TOUCH_TWO] = BINDING_MOVE, [TOUCH_PINCH] = BINDING_MOVE};
    const struct yaml_node *when = yaml_get(item, "when");
    bool touch = !binding->source, encoder = binding->source && binding->source->turned;
    bool value = binding_follows(binding);
    size_t length = reader_enter(reader, "when");
    if (when && touch && binding->touch != TOUCH_PRESS) {
        reader_problem(reader, when, "goes with touch: press alone; the others are conditions themselves");
    } else if (when && touch && binding->when == BINDING_MOVE) {
        reader_problem(reader, when, "a finger that is pressed does not move; touch: drag");
    } else if (when && encoder && binding->when != BINDING_MOVE) {
        reader_problem(reader, when, "an encoder is turned, not pressed; move, or a button for its push button");
    }
    reader_leave(reader, length);
    check_switch(reader, item, when, binding);
    if (!when) {
        binding->when = touch ? OF_TOUCH[binding->touch] : encoder || value ? BINDING_MOVE : PRESS_DOWN;
    }
    if (!yaml_get(item, "ms")) {
        binding->ms = binding->when == PRESS_DOUBLE           ? PRESS_DOUBLE_MS
                      : binding->when == PRESS_HOLD && !touch ? PRESS_HOLD_MS
                                                              : PRESS_LONG_MS;
    }
}

static int problems(const struct reader *reader)
{
    return reader->report->count + reader->report->dropped;
}

static void read_dial(struct reader *reader, const struct yaml_node *node, struct binding *binding)
{
    int before = problems(reader);
    binding->what = DO_DIAL;
    key_defaults(dial_keys, binding);
    mapping_read(reader, dial_keys, node, binding, NULL);
    if (problems(reader) == before) {
        inputs_check_ends(reader, node, inputs_drop_key(binding->parameter));
    }
}

static void read_cursor(struct reader *reader, const struct yaml_node *node, struct binding *binding)
{
    binding->what = DO_CURSOR;
    key_defaults(cursor_keys, binding);
    binding->axis.from = 0;
    binding->axis.to = 1;
    mapping_read(reader, cursor_keys, node, binding, NULL);
}

static void read_what(struct reader *reader, const struct parts *parts, struct binding *binding)
{
    bool own = key_find(binding_do_keys, parts->what_name);
    enum action_verb verb = own ? ACTION_VERBS : action_find(parts->what_name);
    const struct yaml_node *node = parts->what;
    struct yaml_node none = {.kind = YAML_MAPPING, .line = node->line, .column = node->column};
    size_t length = reader_enter(reader, parts->what_name);
    if (yaml_is_nothing(node)) {
        node = &none;
    }
    if (verb < ACTION_VERBS) {
        binding->what = DO_VERB;
        binding->action = action_default(verb);
        script_action_bound(reader, node, &binding->action);
        if (binding->action.path.count > STROKE_POINTS) {
            size_t inner = reader_enter(reader, "path");
            reader_problem(reader, yaml_get(node, "path"), "a path of %d points; at most %d in a binding",
                           binding->action.path.count, STROKE_POINTS);
            reader_leave(reader, inner);
        }
    } else if (node->kind != YAML_MAPPING) {
        value_wrong_kind(reader, node, "a mapping: {parameter: value, ...}, or {}");
    } else if (strcmp(parts->what_name, "turn") == 0) {
        inputs_read_turn(reader, node, binding);
    } else if (strcmp(parts->what_name, "dial") == 0) {
        read_dial(reader, node, binding);
    } else if (strcmp(parts->what_name, "cursor") == 0) {
        read_cursor(reader, node, binding);
    } else {
        static const struct key nothing[] = {{.name = NULL}};
        const struct key *key = key_find(binding_do_keys, parts->what_name);
        binding->what = (enum binding_do)(DO_NEXT_INK + (key - binding_do_keys));
        mapping_read(reader, nothing, node, binding, NULL);
    }
    reader_leave(reader, length);
}

static bool takes(enum action_verb verb, int parameter)
{
    return key_find(action_keys(verb), inputs_drop_key(parameter)->name) != NULL;
}

static void read_length(struct reader *reader, const struct yaml_node *node, struct binding *binding)
{
    int before = problems(reader);
    size_t length = reader_enter(reader, "length");
    binding->has_length = true;
    if (node->kind != YAML_MAPPING) {
        value_wrong_kind(reader, node, "{parameter: radius, from: 4, to: 24, ms: 1500}");
        reader_leave(reader, length);
        return;
    }
    key_defaults(length_keys, &binding->length);
    mapping_read(reader, length_keys, node, &binding->length, NULL);
    bool released = binding->when == PRESS_UP || binding->when == PRESS_SHORT || binding->when == PRESS_LONG;
    if (problems(reader) > before) {
        reader_leave(reader, length);
        return;
    }
    if (!released) {
        reader_problem(reader, node, "the length of a press is known when it is over; when: release, short or long");
    } else if (binding->what != DO_VERB || !takes(binding->action.verb, binding->length.parameter)) {
        reader_problem(reader, node, "the action has no %s; a verb that has one",
                       inputs_drop_key(binding->length.parameter)->name);
    } else {
        inputs_check_ends(
            reader, node,
            key_find(action_keys(binding->action.verb), inputs_drop_key(binding->length.parameter)->name));
    }
    reader_leave(reader, length);
}

static void report_no_action(struct reader *reader, const struct yaml_node *item)
{
    char allowed[1024];
    struct names names = names_of_verbs();
    for (const struct key *key = binding_do_keys; key->name; key++) {
        if (names_find(&names, key->name) < 0) {
            names.names[names.count++] = key->name;
        }
    }
    reader_problem(reader, item, "no action is given; %s", names_allowed(&names, "", allowed, sizeof allowed));
}

static void check_along(struct reader *reader, const struct yaml_node *item, const struct binding *binding)
{
    bool paints = binding->what == DO_VERB && key_find(action_keys(binding->action.verb), "path");
    if (binding->where == WHERE_ALONG && !paints) {
        size_t length = reader_enter(reader, "where");
        reader_problem(reader, yaml_get(item, "where"), "the action has no path; there or sheet");
        reader_leave(reader, length);
    }
}

static void read_binding(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct inputs *inputs = context;
    struct binding *binding = &inputs->bindings[inputs->binding_count];
    struct parts parts = {.inputs = inputs};
    (void)index;
    if (item->kind != YAML_MAPPING) {
        value_wrong_kind(reader, item, "{source: ..., when: ..., action: {...}}; see frond explain bindings");
        return;
    }
    fill_rows(&parts);
    inputs_defaults(parts.rows, binding);
    struct value_reading reading = {read_part, &parts};
    mapping_read(reader, parts.rows, item, binding, &reading);
    bool whole = read_source(reader, item, &parts, binding);
    if (parts.what_name) {
        read_what(reader, &parts, binding);
    } else {
        report_no_action(reader, item);
        whole = false;
    }
    if (whole) {
        read_when(reader, item, binding);
        int usual = verbs[binding->action.verb]->whole ? WHERE_SHEET : WHERE_THERE;
        binding->where = yaml_get(item, "where") ? binding->where : usual;
        check_along(reader, item, binding);
    }
    if (whole && parts.length) {
        read_length(reader, parts.length, binding);
    }
    inputs->binding_count++;
}

static bool same_source(const struct binding *a, const struct binding *b)
{
    bool touch = !a->source;
    bool device = a->device == b->device || a->device < 0 || b->device < 0;
    bool index = a->index == b->index || a->index < 0 || b->index < 0;
    return a->source == b->source && (touch || (a->control == b->control && device && index));
}

/* A short press of what is also pressed twice waits for the second. */
static void let_short_wait(struct inputs *inputs)
{
    for (int i = 0; i < inputs->binding_count; i++) {
        struct binding *binding = &inputs->bindings[i];
        for (int k = 0; k < inputs->binding_count && binding->when == PRESS_SHORT; k++) {
            const struct binding *other = &inputs->bindings[k];
            if (other->when == PRESS_DOUBLE && same_source(binding, other) && (uint32_t)other->ms > binding->wait_ms) {
                binding->wait_ms = (uint32_t)other->ms;
            }
        }
    }
}

/* The kind of scene that a binding turns something of; SCENE_PAINTING: none, or a coefficient. */
static int turned_scene(const struct binding *binding)
{
    return binding->what == DO_TURN && binding->option >= 0 ? binding->scene : SCENE_PAINTING;
}

/* Tools without a touch binding have the default ones, and scenes that are no paintings without a dial. */
static void read_default_tools(struct reader *reader, struct inputs *inputs)
{
    bool written[TOOLS] = {false}, dials[SCENE_KINDS] = {[SCENE_PAINTING] = true};
    inputs->written_count = inputs->binding_count;
    const char *text = inputs_default_text();
    for (int i = 0; i < inputs->binding_count; i++) {
        const struct binding *binding = &inputs->bindings[i];
        if (!binding->source && binding->tool >= 0 && binding->tool < TOOLS) {
            written[binding->tool] = true;
        }
        dials[turned_scene(binding)] = true;
    }
    struct yaml *yaml = yaml_parse(text, strlen(text), reader->report);
    const struct yaml_node *list = yaml ? yaml_get(yaml_root(yaml), "bindings") : NULL;
    for (const struct yaml_node *item = list ? list->first : NULL; item; item = item->next) {
        struct binding *binding = &inputs->bindings[inputs->binding_count];
        bool touch = yaml_get(item, "touch");
        if ((touch || yaml_get(item, "turn")) && inputs->binding_count < INPUTS_BINDINGS) {
            read_binding(reader, item, 0, inputs);
            if (touch ? written[binding->tool] : dials[turned_scene(binding)]) {
                *binding = (struct binding){.tool = 0};
                inputs->binding_count--;
            }
        }
    }
    yaml_destroy(yaml);
}

void inputs_read_bindings(struct reader *reader, const struct yaml_node *root, struct inputs *inputs)
{
    inputs_list(reader, root, "bindings", INPUTS_WRITTEN, "a list of {source: ..., action: {...}}", read_binding,
                inputs);
    read_default_tools(reader, inputs);
    let_short_wait(inputs);
}
