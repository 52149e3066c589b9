/* Touchscreens and mice, and keyboards of the staff: all that libinput hears. */
#include "device_class.h"
#include "inputs_devices.h"
#include "key_names.h"
#include "source_touch.h"

static const struct key sections[] = {
    SECTION("touch", "Touchscreens and mice."),
    SECTION("keyboards", "A list of the staff's keyboards; all others are ignored."),
    END,
};

static const struct key touch_keys[] = {
    FLAG("touchscreens", struct inputs, touchscreens, 1, "Whether fingers on touchscreens act."),
    FLAG("pointers", struct inputs, pointers, 0, "Whether mice act, as one finger while a button is down."),
    END,
};

static const struct key keyboard_keys[] = {INPUTS_DEVICE_ROWS, END};
static const struct inputs_table tables[] = {
    {"touch", "Touchscreens and mice.", touch_keys},
    {"keyboards", "A keyboard of the staff.", keyboard_keys},
    {.name = NULL},
};

static void read(struct reader *reader, const struct yaml_node *root, struct inputs *inputs)
{
    const struct inputs_devices keyboards = {
        "keyboards", keyboard_keys, inputs->keyboards, &inputs->keyboard_count, INPUTS_KEYBOARDS, NULL};
    inputs_defaults(touch_keys, inputs);
    inputs_mapping(reader, root, "touch", touch_keys, inputs, "{touchscreens: true, pointers: false}");
    inputs_read_devices(reader, root, &keyboards, inputs);
}

static void read_key(struct reader *reader, const struct yaml_node *node, const struct inputs *inputs,
                     struct binding *binding)
{
    static const char ALLOWED[] = "a to z, 0 to 9, F1 to F12, space, enter, escape, left, ...";
    char found[128];
    size_t length = reader_enter(reader, "key");
    const char *name = inputs_word(reader, node, ALLOWED);
    binding->control = name ? key_code_of(name) : 0;
    if (name && binding->control == 0) {
        reader_problem(reader, node, "unknown key %s; %s", yaml_found(node, found, sizeof found), ALLOWED);
    } else if (name && inputs->keyboard_count == 0) {
        reader_problem(reader, node, "no keyboard is admitted; keyboards: [{id: WORD, vendor: ID, product: ID}]");
    }
    reader_leave(reader, length);
}

static const struct inputs_device *keyboards_of(const struct inputs *inputs, int *count)
{
    *count = inputs->keyboard_count;
    return inputs->keyboards;
}

static bool name_key(const struct inputs *inputs, uint32_t control, char *text, size_t size)
{
    const char *name = key_name_of(control);
    (void)inputs;
    if (name) {
        snprintf(text, size, "%s", name);
    }
    return name;
}

static const char *begin_with(const struct event *event)
{
    (void)event;
    return "next_ink: {}";
}

static const struct binding_source sources[] = {
    {.key = SECTION("key", "Source: a key of a staff keyboard: a, 7, F1, space, enter."),
     .source = SOURCE_KEY,
     .read = read_key,
     .devices = keyboards_of,
     .list = "keyboards",
     .name = name_key,
     .action = begin_with},
    {.key = END},
};

static struct source *create(const struct sources_def *def, struct device_error *error)
{
    const struct inputs *inputs = def->inputs;
    struct source_touch_device_def devices[INPUTS_KEYBOARDS];
    uint32_t keys[SOURCE_TOUCH_KEYS];
    int key_count = 0;
    for (int i = 0; i < inputs->keyboard_count; i++) {
        const struct inputs_device *from = &inputs->keyboards[i];
        devices[i] = (struct source_touch_device_def){.match = {from->vendor, from->product, from->name}, .keys = true};
    }
    for (int i = 0; i < inputs->binding_count && key_count < SOURCE_TOUCH_KEYS; i++) {
        if (inputs->bindings[i].source == &sources[0]) {
            keys[key_count++] = inputs->bindings[i].control;
        }
    }
    const struct source_touch_def touch = {.rotation = def->rotation,
                                           .width = def->width,
                                           .height = def->height,
                                           .devices = devices,
                                           .device_count = inputs->keyboard_count,
                                           .touchscreens = inputs->touchscreens,
                                           .pointers = inputs->pointers,
                                           .keys = keys,
                                           .key_count = key_count,
                                           .hold = def->hold,
                                           .console = def->console};
    return def->touch ? source_touch_create(&touch, error) : NULL;
}

const struct device_class class_touch = {
    .source = "touch",
    .noun = "touch",
    .none = "no touchscreen, mouse or keyboard: none is plugged in, or libinput has no leave to look (group input)",
    .sections = sections,
    .tables = tables,
    .sources = sources,
    .read = read,
    .create = create,
};
