/* HID controllers: knobs, gamepads, arcade boards, space mice, and their lamps. */
#include <stdlib.h>
#include <string.h>

#include "device_class.h"
#include "hid_report.h"
#include "hid_usage.h"
#include "inputs_devices.h"
#include "source_hid.h"
#include "word_lines.h"

static const struct key sections[] = {
    SECTION("controllers", "A list of HID controllers that bindings name, or whose reports want a map."),
    FLAG("other_controllers", struct inputs, others, 1, "Whether controllers that are not in the list may act."),
    END,
};

static const struct key controller_keys[] = {
    INPUTS_DEVICE_ROWS,
    FLAG("refuse", struct inputs_device, refuse, 0, "Whether it is never to act, whatever it is."),
    SECTION("map", "A list of what bits of its reports mean, where it does not say so itself."),
    SECTION("lights", "A list of its lamps."),
    END,
};

static const char *const MODES[] = {"absolute", "relative", "counter", NULL};
#define MAP struct inputs_map
static const struct key map_keys[] = {
    TEXT("usage", MAP, usage_name, "a HID usage", INPUTS_NAME_BYTES, true, "What the bits become: Button 1, Dial, X."),
    WHOLE("report", MAP, report, "", 0, 255, 0, false, "Id of the report; 0 where reports have none."),
    WHOLE("bit", MAP, bit, "bits", 0, 65535, 0, true, "First bit, from the lowest of the first byte after the id."),
    WHOLE("bits", MAP, bits, "bits", 1, 32, 1, false, "How many."),
    FLAG("signed", MAP, is_signed, 0, "Whether the highest bit is a sign."),
    FLAG("centred", MAP, centred, 0, "Whether it rests in the middle of its range."),
    CHOICE("mode", MAP, mode, MODES, HID_MAP_ABSOLUTE, false,
           "A value, steps since the report before, or a counter that runs on."),
    WHOLE("min", MAP, min, "", -2147483647, 2147483647, 0, false,
          "Value at one end; with max 0 as well: all that the bits hold."),
    WHOLE("max", MAP, max, "", -2147483647, 2147483647, 0, false, "Value at the other end; below min it is turned."),
    END,
};

#define LIGHT struct inputs_light
static const struct key light_keys[] = {
    TEXT("id", LIGHT, id, "a word", INPUTS_ID_BYTES, true, "What the log calls it."),
    TEXT("usage", LIGHT, usage_name, "a HID usage", INPUTS_NAME_BYTES, false,
         "The output that lights it, where the controller names one: `LED: Power`."),
    WHOLE("index", LIGHT, index, "", 0, 1023, 0, false, "Which of several outputs of that usage."),
    WHOLE("report", LIGHT, report, "", 0, 255, 0, false,
          "Without usage: id of the output report; 0 where they have none."),
    WHOLE("bit", LIGHT, bit, "bits", 0, 65535, 0, false, "Without usage: first bit, after the id."),
    WHOLE("bits", LIGHT, bits, "bits", 1, 32, 1, false, "Without usage: how many."),
    WHOLE("most", LIGHT, most, "", 0, 2147483647, 0, false, "Without usage: full brightness; 0: all bits."),
    TEXT("button", LIGHT, button_name, "a HID usage", INPUTS_NAME_BYTES, false,
         "The control of this controller whose presses light it: Button 1."),
    END,
};

static const struct inputs_table tables[] = {
    {"controllers", "A HID controller.", controller_keys},
    {"map", "What some bits of a controller's reports mean.", map_keys},
    {"lights", "A lamp of a controller.", light_keys},
    {.name = NULL},
};

static bool find_usage(struct reader *reader, const struct yaml_node *node, const char *name, uint32_t *usage)
{
    uint32_t number = 0;
    char found[128];
    if (strncmp(name, "0x", 2) == 0) {
        number = inputs_base16(name, 8, &number) ? number : 0;
    } else {
        number = hid_usage_of(name);
    }
    if (number == 0) {
        reader_problem(reader, node, "unknown usage %s; a HID usage by name (X, Dial, Button 3) or number (0x00090003)",
                       yaml_found(node, found, sizeof found));
        return false;
    }
    *usage = number;
    return true;
}

static void read_map_entry(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct inputs_device *device = context;
    struct inputs_map *entry = &device->map[device->map_count];
    (void)index;
    if (item->kind != YAML_MAPPING) {
        value_wrong_kind(reader, item, "{usage: NAME, bit: N, bits: N, ...}");
        return;
    }
    key_defaults(map_keys, entry);
    mapping_read(reader, map_keys, item, entry, NULL);
    const struct yaml_node *usage = yaml_get(item, "usage");
    if (entry->usage_name) {
        size_t length = reader_enter(reader, "usage");
        find_usage(reader, usage, entry->usage_name, &entry->usage);
        reader_leave(reader, length);
    }
    device->map_count++;
}

static void read_usage_of(struct reader *reader, const struct yaml_node *item, const char *key, const char *name,
                          uint32_t *usage)
{
    if (name) {
        size_t length = reader_enter(reader, key);
        find_usage(reader, yaml_get(item, key), name, usage);
        reader_leave(reader, length);
    }
}

static void read_light(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct inputs *inputs = context;
    (void)index;
    if (item->kind != YAML_MAPPING) {
        value_wrong_kind(reader, item, "{id: WORD, usage: NAME, ...} or {id: WORD, bit: N, bits: N, ...}");
        return;
    }
    if (inputs->light_count == INPUTS_LINES) {
        reader_problem(reader, item, "lamps of all controllers: at most %d", INPUTS_LINES);
        return;
    }
    struct inputs_light *light = &inputs->lights[inputs->light_count];
    key_defaults(light_keys, light);
    mapping_read(reader, light_keys, item, light, NULL);
    light->controller = inputs->controller_count;
    read_usage_of(reader, item, "usage", light->usage_name, &light->usage);
    read_usage_of(reader, item, "button", light->button_name, &light->button);
    bool bits = yaml_get(item, "bit");
    if (!yaml_get(item, "usage") && !bits) {
        reader_problem(reader, item, "nothing says where it is; usage, or bit: its first bit in the output report");
    } else if (yaml_get(item, "usage") && bits) {
        reader_problem(reader, yaml_get(item, "bit"), "usage says where it is already; one of both");
    }
    inputs->light_count++;
}

static void read_sections(struct reader *reader, const struct yaml_node *item, struct inputs *inputs)
{
    struct inputs_device *device = &inputs->controllers[inputs->controller_count];
    device->map = yaml_get(item, "map") ? reader_take(reader, INPUTS_MAP * sizeof *device->map) : NULL;
    if (device->map) {
        inputs_list(reader, item, "map", INPUTS_MAP, "a list of {usage: NAME, bit: N, bits: N, ...}", read_map_entry,
                    device);
    }
    inputs_list(reader, item, "lights", INPUTS_LINES, "a list of {id: WORD, usage: NAME, ...}", read_light, inputs);
}

static void read(struct reader *reader, const struct yaml_node *root, struct inputs *inputs)
{
    const struct inputs_devices controllers = {"controllers",       controller_keys,
                                               inputs->controllers, &inputs->controller_count,
                                               INPUTS_CONTROLLERS,  read_sections};
    inputs_read_devices(reader, root, &controllers, inputs);
}

static void read_usage(struct reader *reader, const struct yaml_node *node, const struct inputs *inputs,
                       struct binding *binding)
{
    (void)inputs;
    size_t length = reader_enter(reader, "usage");
    const char *name = inputs_word(reader, node, "a HID usage by name (X, Dial, Button 3) or number (0x00090003)");
    if (name) {
        find_usage(reader, node, name, &binding->control);
    }
    reader_leave(reader, length);
}

static const struct inputs_device *controllers_of(const struct inputs *inputs, int *count)
{
    *count = inputs->controller_count;
    return inputs->controllers;
}

static bool name_usage(const struct inputs *inputs, uint32_t control, char *text, size_t size)
{
    (void)inputs;
    hid_usage_name(control, text, (int)size);
    return true;
}

static bool write_usage(const struct inputs *inputs, uint32_t control, char *text, size_t size)
{
    name_usage(inputs, control, text, size);
    if (hid_usage_of(text) != control) {
        snprintf(text, size, "0x%08x", control);
    }
    return true;
}

static const char *begin_with(const struct event *event)
{
    switch (event->control) {
    case HID_USAGE(HID_PAGE_DESKTOP, 0x39):
        return "cursor: {axis: both}"; /* a hat */
    case HID_USAGE(HID_PAGE_DESKTOP, 0x30):
        return "cursor: {axis: x}";
    case HID_USAGE(HID_PAGE_DESKTOP, 0x31):
        return "cursor: {axis: y}";
    default:
        return event->control >> 16 == HID_PAGE_DESKTOP ? BINDING_TURN : NULL;
    }
}

static const struct binding_source sources[] = {
    {.key = SECTION("usage", "Source: a control of a HID controller, by name (X, Dial, Button 3) or number "
                             "(0x00090003)."),
     .source = SOURCE_HID,
     .read = read_usage,
     .devices = controllers_of,
     .list = "controllers",
     .name = name_usage,
     .written = write_usage,
     .action = begin_with},
    {.key = END},
};

static void fill_lights(const struct inputs *inputs, struct hid_lamp_def *lamps)
{
    for (int i = 0; i < inputs->light_count; i++) {
        const struct inputs_light *light = &inputs->lights[i];
        const struct inputs_device *of = &inputs->controllers[light->controller];
        lamps[i] = (struct hid_lamp_def){.lamp = inputs->lamp_count + i,
                                         .match = {of->vendor, of->product, of->name},
                                         .usage = light->usage,
                                         .index = light->index,
                                         .report = (uint8_t)light->report,
                                         .bit = (uint32_t)light->bit,
                                         .bits = light->bits,
                                         .most = (uint32_t)light->most};
    }
}

static struct source *create(const struct sources_def *def, struct device_error *error)
{
    struct hid_device_def devices[INPUTS_CONTROLLERS];
    struct hid_map_entry *maps = calloc((size_t)INPUTS_CONTROLLERS * INPUTS_MAP, sizeof *maps);
    const struct inputs *inputs = def->inputs;
    for (int i = 0; i < inputs->controller_count && maps; i++) {
        const struct inputs_device *from = &inputs->controllers[i];
        struct hid_map_entry *map = maps + (size_t)i * INPUTS_MAP;
        for (int k = 0; k < from->map_count; k++) {
            const struct inputs_map *entry = &from->map[k];
            map[k] = (struct hid_map_entry){.report = (uint8_t)entry->report,
                                            .bit = (uint32_t)entry->bit,
                                            .bits = entry->bits,
                                            .is_signed = entry->is_signed,
                                            .centred = entry->centred,
                                            .mode = (enum hid_map_mode)entry->mode,
                                            .min = entry->min,
                                            .max = entry->max,
                                            .usage = entry->usage};
        }
        devices[i] = (struct hid_device_def){.match = {from->vendor, from->product, from->name},
                                             .refuse = from->refuse,
                                             .map = map,
                                             .map_count = from->map_count};
    }
    struct hid_lamp_def lamps[INPUTS_LINES];
    fill_lights(inputs, lamps);
    const struct source_hid_def hid = {.devices = devices,
                                       .device_count = maps ? inputs->controller_count : 0,
                                       .lamps = lamps,
                                       .lamp_count = inputs->light_count,
                                       .controllers = inputs->others,
                                       .vendor = def->look};
    struct source *source = source_hid_create(&hid, error);
    free(maps);
    return source;
}

/* Consecutive buttons as one: "Button 1 to Button 12". */
static int run_of(const struct hid_control *controls, int count)
{
    int length = 1;
    while (length < count && controls[0].kind == HID_BUTTON &&
           controls[length].usage == controls[0].usage + (uint32_t)length &&
           controls[length].kind == controls[0].kind) {
        length++;
    }
    return length;
}

static void print_usages(const struct hid_descriptor *descriptor, FILE *out)
{
    const struct hid_control *controls;
    struct hid_decoder_def def = {.descriptor = descriptor, .everything = true, .vendor = true};
    struct hid_decoder *decoder = hid_decoder_create(&def);
    struct word_lines words = {out, 0};
    int count = decoder ? hid_decoder_controls(decoder, &controls) : 0;
    for (int i = 0; i < count;) {
        char first[HID_USAGE_NAME], last[HID_USAGE_NAME], text[2 * HID_USAGE_NAME + 8];
        int length = run_of(&controls[i], count - i);
        const struct hid_control *end = &controls[i + length - 1];
        hid_usage_name(controls[i].usage, first, sizeof first);
        hid_usage_name(end->usage_last, last, sizeof last);
        bool one = controls[i].usage == end->usage_last;
        snprintf(text, sizeof text, "%s%s%s", first, one ? "" : " to ", one ? "" : last);
        word_lines_add(&words, text);
        i += length;
    }
    word_lines_end(&words);
    hid_decoder_destroy(decoder);
}

static void print(const struct source *source, const struct device *device, FILE *out)
{
    const struct hid_descriptor *descriptor = source_hid_descriptor(source, device->id);
    if (descriptor) {
        print_usages(descriptor, out);
    }
}

const struct device_class class_hid = {
    .source = "hid",
    .noun = "controllers",
    .none = "no controller: none is plugged in, or the kernel has no hidraw (CONFIG_HIDRAW)",
    .sections = sections,
    .tables = tables,
    .sources = sources,
    .read = read,
    .create = create,
    .print = print,
};
