#include "hid_definition.h"

#include <stdlib.h>
#include <string.h>

#include "source_device.h"

struct hid_definition {
    struct source_hid_def def;
    struct hid_device_def *devices;
    struct hid_lamp_def *lamps;
};

static bool copy_name(struct device_match *match)
{
    match->name = match->name ? strdup(match->name) : NULL;
    return match->name != NULL;
}

static bool copy_device(struct hid_device_def *to, const struct hid_device_def *from)
{
    *to = *from;
    to->map = NULL;
    bool good = copy_name(&to->match) || !from->match.name;
    if (from->map_count > 0) {
        struct hid_map_entry *map = calloc((size_t)from->map_count, sizeof *map);
        if (map) {
            memcpy(map, from->map, (size_t)from->map_count * sizeof *map);
        }
        to->map = map;
        good = good && map;
    }
    return good;
}

static bool check_device(const struct hid_device_def *device, int which, struct device_error *error)
{
    const struct device_match *match = &device->match;
    if (!match->vendor && !match->product && !match->name) {
        return device_fail(error, "hid: device %d of the definition matches everything", which);
    }
    for (int i = 0; i < device->map_count; i++) {
        const struct hid_map_entry *entry = &device->map[i];
        if (entry->bits < 1 || entry->bits > 32 || entry->bit > 8u * HID_REPORT_BYTES - (uint32_t)entry->bits) {
            return device_fail(error, "hid: entry %d of the map of device %d: %d bits from bit %u; 1 to 32 are allowed",
                               i, which, entry->bits, entry->bit);
        }
    }
    return true;
}

struct hid_definition *hid_definition_create(const struct source_hid_def *def, struct device_error *error)
{
    for (int i = 0; i < def->device_count; i++) {
        if (!check_device(&def->devices[i], i, error)) {
            return NULL;
        }
    }
    struct hid_definition *definition = calloc(1, sizeof *definition);
    bool good = definition != NULL;
    if (good) {
        definition->def = *def;
        definition->devices = calloc((size_t)def->device_count + 1, sizeof *definition->devices);
        definition->lamps = calloc((size_t)def->lamp_count + 1, sizeof *definition->lamps);
        good = definition->devices && definition->lamps;
        definition->def.devices = definition->devices;
        definition->def.lamps = definition->lamps;
    }
    for (int i = 0; good && i < def->device_count; i++) {
        good = copy_device(&definition->devices[i], &def->devices[i]);
    }
    for (int i = 0; good && i < def->lamp_count; i++) {
        definition->lamps[i] = def->lamps[i];
        good = copy_name(&definition->lamps[i].match) || !def->lamps[i].match.name;
    }
    if (!good) {
        hid_definition_destroy(definition);
        device_fail(error, "hid: memory is short");
        return NULL;
    }
    return definition;
}

void hid_definition_destroy(struct hid_definition *definition)
{
    if (!definition) {
        return;
    }
    for (int i = 0; definition->devices && i < definition->def.device_count; i++) {
        free((void *)definition->devices[i].match.name);
        free((void *)definition->devices[i].map);
    }
    for (int i = 0; definition->lamps && i < definition->def.lamp_count; i++) {
        free((void *)definition->lamps[i].match.name);
    }
    free(definition->devices);
    free(definition->lamps);
    free(definition);
}

const struct source_hid_def *hid_definition_get(const struct hid_definition *definition)
{
    return &definition->def;
}

bool hid_matches(const struct device_match *match, const struct hid_node *node)
{
    return device_matches(match, node->vendor, node->product, node->name);
}

const struct hid_device_def *hid_definition_find(const struct hid_definition *definition, const struct hid_node *node)
{
    for (int i = 0; i < definition->def.device_count; i++) {
        const struct hid_device_def *device = &definition->devices[i];
        bool fits = node->class != HID_CLASS_KEYBOARD || device->keyboard || device->refuse;
        if (fits && hid_matches(&device->match, node)) {
            return &definition->devices[i];
        }
    }
    return NULL;
}
