#include <stdlib.h>
#include <string.h>

#include "hid_usage.h"
#include "inputs_read.h"

struct device_reading {
    struct inputs_device *devices;
    int *count;
    const struct key *keys;
    const struct yaml_node *map, *lights;
    struct inputs *inputs;
};

/* Digits of base 16, at most `most` of them, with or without 0x. */
static bool read_base16(const char *text, size_t most, uint32_t *number)
{
    if (text[0] == '0' && (text[1] == 'x' || text[1] == 'X')) {
        text += 2;
    }
    size_t digits = strspn(text, "0123456789abcdefABCDEF");
    if (digits == 0 || digits > most || text[digits]) {
        return false;
    }
    *number = (uint32_t)strtoul(text, NULL, 16);
    return true;
}

bool inputs_usage(struct reader *reader, const struct yaml_node *node, const char *name, uint32_t *usage)
{
    uint32_t number = 0;
    char found[128];
    if (strncmp(name, "0x", 2) == 0) {
        number = read_base16(name, 8, &number) ? number : 0;
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

static bool read_id(struct reader *reader, const struct yaml_node *node, uint16_t *id)
{
    uint32_t number = 0;
    char found[128];
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    if (node->kind != YAML_SCALAR || !read_base16(node->text, 4, &number)) {
        reader_problem(reader, node, "%s is no USB id; one to four digits of base 16, 077d",
                       yaml_found(node, found, sizeof found));
        return false;
    }
    *id = (uint16_t)number;
    return true;
}

static bool read_device_key(struct reader *reader, const struct key *key, const struct yaml_node *node, void *object,
                            void *context)
{
    struct inputs_device *device = object;
    struct device_reading *reading = context;
    if (inputs_is_section(key)) {
        *(strcmp(key->name, "map") == 0 ? &reading->map : &reading->lights) = node;
        return true;
    }
    if (strcmp(key->name, "vendor") == 0) {
        return read_id(reader, node, &device->vendor);
    }
    if (strcmp(key->name, "product") == 0) {
        return read_id(reader, node, &device->product);
    }
    return value_read(reader, key, node, object);
}

static void read_map_entry(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct inputs_device *device = context;
    struct inputs_map *entry = &device->map[device->map_count];
    (void)index;
    if (item->kind != YAML_MAPPING) {
        inputs_wrong_kind(reader, item, "{usage: NAME, bit: N, bits: N, ...}");
        return;
    }
    key_defaults(map_keys, entry);
    mapping_read(reader, map_keys, item, entry, NULL);
    const struct yaml_node *usage = yaml_get(item, "usage");
    if (entry->usage_name) {
        size_t length = reader_enter(reader, "usage");
        inputs_usage(reader, usage, entry->usage_name, &entry->usage);
        reader_leave(reader, length);
    }
    device->map_count++;
}

static void read_usage_of(struct reader *reader, const struct yaml_node *item, const char *key, const char *name,
                          uint32_t *usage)
{
    if (name) {
        size_t length = reader_enter(reader, key);
        inputs_usage(reader, yaml_get(item, key), name, usage);
        reader_leave(reader, length);
    }
}

static void read_light(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct device_reading *reading = context;
    struct inputs *inputs = reading->inputs;
    (void)index;
    if (item->kind != YAML_MAPPING) {
        inputs_wrong_kind(reader, item, "{id: WORD, usage: NAME, ...} or {id: WORD, bit: N, bits: N, ...}");
        return;
    }
    if (inputs->light_count == INPUTS_LINES) {
        reader_problem(reader, item, "lamps of all controllers: at most %d", INPUTS_LINES);
        return;
    }
    struct inputs_light *light = &inputs->lights[inputs->light_count];
    key_defaults(light_keys, light);
    mapping_read(reader, light_keys, item, light, NULL);
    light->controller = *reading->count;
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

static void check_device(struct reader *reader, const struct yaml_node *item, const struct device_reading *reading)
{
    const struct inputs_device *device = &reading->devices[*reading->count];
    if (!device->vendor && !device->product && !device->name) {
        reader_problem(reader, item, "any device would be it; vendor, product or a part of its name");
    }
    for (int i = 0; device->id && i < *reading->count; i++) {
        if (reading->devices[i].id && strcmp(reading->devices[i].id, device->id) == 0) {
            size_t length = reader_enter(reader, "id");
            reader_problem(reader, yaml_get(item, "id"), "'%s' is there already; another word", device->id);
            reader_leave(reader, length);
        }
    }
}

static void read_device(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct device_reading *reading = context;
    struct inputs_device *device = &reading->devices[*reading->count];
    (void)index;
    if (item->kind != YAML_MAPPING) {
        inputs_wrong_kind(reader, item, "{id: WORD, vendor: 077d, product: 0410, name: TEXT}");
        return;
    }
    key_defaults(reading->keys, device);
    reading->map = reading->lights = NULL;
    struct value_reading value = {read_device_key, reading};
    mapping_read(reader, reading->keys, item, device, &value);
    check_device(reader, item, reading);
    if (reading->map) {
        device->map = reader_take(reader, INPUTS_MAP * sizeof *device->map);
        if (device->map) {
            inputs_list(reader, item, "map", INPUTS_MAP, "a list of {usage: NAME, bit: N, bits: N, ...}",
                        read_map_entry, device);
        }
    }
    if (reading->lights) {
        inputs_list(reader, item, "lights", INPUTS_LINES, "a list of {id: WORD, usage: NAME, ...}", read_light,
                    reading);
    }
    (*reading->count)++;
}

void inputs_read_devices(struct reader *reader, const struct yaml_node *root, struct inputs *inputs)
{
    static const char ALLOWED[] = "a list of {id: WORD, vendor: 077d, product: 0410, name: TEXT}";
    struct device_reading keyboards = {inputs->keyboards, &inputs->keyboard_count, keyboard_keys, NULL, NULL, inputs};
    struct device_reading controllers = {
        inputs->controllers, &inputs->controller_count, controller_keys, NULL, NULL, inputs};
    inputs_list(reader, root, "keyboards", INPUTS_KEYBOARDS, ALLOWED, read_device, &keyboards);
    inputs_list(reader, root, "controllers", INPUTS_CONTROLLERS, ALLOWED, read_device, &controllers);
}
