#include "touch_admission.h"

#include <stdlib.h>
#include <string.h>

#include "source_device.h"

static char *copy_text(const char *text, bool *good)
{
    char *copy = text ? strdup(text) : NULL;
    *good = *good && (copy || !text);
    return copy;
}

static bool check(const struct source_touch_def *def, struct device_error *error)
{
    if (def->rotation != 0 && def->rotation != 90 && def->rotation != 180 && def->rotation != 270) {
        return device_fail(error, "touch: rotation %d; 0, 90, 180 and 270 are allowed", def->rotation);
    }
    if (def->width < 0 || def->height < 0) {
        return device_fail(error, "touch: a display of %dx%d", def->width, def->height);
    }
    if (def->key_count > SOURCE_TOUCH_KEYS) {
        return device_fail(error, "touch: %d keys; %d are allowed", def->key_count, SOURCE_TOUCH_KEYS);
    }
    for (int i = 0; i < def->device_count; i++) {
        const struct source_touch_device_def *device = &def->devices[i];
        if (device->keys && def->key_count == 0) {
            return device_fail(error, "touch: device %d of the definition is a keyboard to which no key is bound", i);
        }
    }
    return true;
}

static bool copy_lists(struct touch_definition *definition, const struct source_touch_def *def)
{
    bool good = true;
    definition->devices = calloc((size_t)def->device_count + 1, sizeof *definition->devices);
    definition->keys = calloc((size_t)def->key_count + 1, sizeof *definition->keys);
    if (!definition->devices || !definition->keys) {
        definition->def.device_count = 0;
        return false;
    }
    for (int i = 0; i < def->device_count; i++) {
        definition->devices[i] = def->devices[i];
        definition->devices[i].match.name = copy_text(def->devices[i].match.name, &good);
    }
    for (int i = 0; i < def->key_count; i++) {
        definition->keys[i] = def->keys[i];
    }
    return good;
}

struct touch_definition *touch_definition_create(const struct source_touch_def *def, struct device_error *error)
{
    bool good = true;
    if (!check(def, error)) {
        return NULL;
    }
    struct touch_definition *definition = calloc(1, sizeof *definition);
    if (!definition) {
        device_fail(error, "touch: memory is short");
        return NULL;
    }
    definition->def = *def;
    definition->def.seat = copy_text(def->seat ? def->seat : "seat0", &good);
    definition->def.console = copy_text(def->console, &good);
    good = copy_lists(definition, def) && good;
    definition->def.devices = definition->devices;
    definition->def.keys = definition->keys;
    if (!good) {
        device_fail(error, "touch: memory is short");
        touch_definition_destroy(definition);
        return NULL;
    }
    return definition;
}

void touch_definition_destroy(struct touch_definition *definition)
{
    if (definition) {
        for (int i = 0; i < definition->def.device_count; i++) {
            free((char *)definition->devices[i].match.name);
        }
        free((char *)definition->def.seat);
        free((char *)definition->def.console);
        free(definition->devices);
        free(definition->keys);
        free(definition);
    }
}

struct touch_admission touch_admit(const struct source_touch_def *def, const struct touch_traits *traits)
{
    bool screen = traits->touch && !traits->touchpad;
    for (int i = 0; i < def->device_count; i++) {
        const struct source_touch_device_def *device = &def->devices[i];
        if (device_matches(&device->match, traits->vendor, traits->product, traits->name)) {
            return (struct touch_admission){.touch = device->touch && screen,
                                            .pointer = device->pointer && traits->pointer,
                                            .keys = device->keys && traits->keys && def->key_count > 0};
        }
    }
    return (struct touch_admission){
        .touch = def->touchscreens && screen,
        .pointer = def->pointers && traits->pointer && !traits->keys && !traits->phantom,
    };
}

bool touch_key_is_bound(const struct source_touch_def *def, uint32_t code)
{
    for (int i = 0; i < def->key_count; i++) {
        if (def->keys[i] == code) {
            return true;
        }
    }
    return false;
}

const char *touch_class(const struct touch_traits *traits)
{
    if (traits->touch && !traits->touchpad) {
        return DEVICE_TOUCH;
    }
    return traits->keys ? DEVICE_KEYBOARD : DEVICE_POINTER;
}
