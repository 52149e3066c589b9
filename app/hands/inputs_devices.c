#include "inputs_devices.h"

#include <stdlib.h>
#include <string.h>

struct device_reading {
    const struct inputs_devices *def;
    struct inputs *inputs;
};

bool inputs_base16(const char *text, size_t most, uint32_t *number)
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

static bool read_id(struct reader *reader, const struct yaml_node *node, uint16_t *id)
{
    uint32_t number = 0;
    char found[128];
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    if (node->kind != YAML_SCALAR || !inputs_base16(node->text, 4, &number)) {
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
    (void)context;
    if (strcmp(key->name, "vendor") == 0) {
        return read_id(reader, node, &device->vendor);
    }
    if (strcmp(key->name, "product") == 0) {
        return read_id(reader, node, &device->product);
    }
    return key_is_section(key) || value_read(reader, key, node, object);
}

static void check_device(struct reader *reader, const struct yaml_node *item, const struct inputs_devices *def)
{
    const struct inputs_device *device = &def->devices[*def->count];
    if (!device->vendor && !device->product && !device->name) {
        reader_problem(reader, item, "any device would be it; vendor, product or a part of its name");
    }
    for (int i = 0; device->id && i < *def->count; i++) {
        if (def->devices[i].id && strcmp(def->devices[i].id, device->id) == 0) {
            size_t length = reader_enter(reader, "id");
            reader_problem(reader, yaml_get(item, "id"), "'%s' is there already; another word", device->id);
            reader_leave(reader, length);
        }
    }
}

static void read_device(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    const struct device_reading *reading = context;
    const struct inputs_devices *def = reading->def;
    struct inputs_device *device = &def->devices[*def->count];
    struct value_reading value = {.read = read_device_key};
    (void)index;
    if (item->kind != YAML_MAPPING) {
        value_wrong_kind(reader, item, "{id: WORD, vendor: 077d, product: 0410, name: TEXT}");
        return;
    }
    inputs_defaults(def->keys, device);
    mapping_read(reader, def->keys, item, device, &value);
    check_device(reader, item, def);
    if (def->sections) {
        def->sections(reader, item, reading->inputs);
    }
    (*def->count)++;
}

void inputs_read_devices(struct reader *reader, const struct yaml_node *root, const struct inputs_devices *def,
                         struct inputs *inputs)
{
    struct device_reading reading = {def, inputs};
    inputs_list(reader, root, def->list, def->most, "a list of {id: WORD, vendor: 077d, product: 0410, name: TEXT}",
                read_device, &reading);
}
