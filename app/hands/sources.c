#include "sources.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "source_gpio.h"
#include "source_hid.h"
#include "source_touch.h"

enum { LINE = 400 };

struct sources {
    struct source *sources[SOURCES_MAX];
    enum event_source said[SOURCES_MAX]; /* what its events say they come from, once there was one */
    int count, turn;
    char failures[SOURCES_MAX][LINE]; /* for the log */
    int failure_count;
};

bool sources_add(struct sources *sources, struct source *source)
{
    if (!source || sources->count == SOURCES_MAX) {
        source_destroy(source);
        return false;
    }
    sources->sources[sources->count++] = source;
    return true;
}

static void fail(struct sources *sources, const char *name, const struct source_error *error)
{
    if (sources->failure_count < SOURCES_MAX) {
        snprintf(sources->failures[sources->failure_count++], LINE, "%s: %s", name, error->text);
    }
}

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

static void make_hid(struct sources *sources, const struct sources_def *def)
{
    struct source_error error;
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
    if (!sources_add(sources, source_hid_create(&hid, &error))) {
        fail(sources, "controllers", &error);
    }
    free(maps);
}

static struct gpio_line_def line_of(const struct inputs_lines *lines, const struct inputs_line *line)
{
    static const enum gpio_bias BIASES[] = {[INPUTS_AS_IS] = GPIO_BIAS_AS_IS,
                                            [INPUTS_NO_BIAS] = GPIO_BIAS_NONE,
                                            [INPUTS_PULL_UP] = GPIO_BIAS_PULL_UP,
                                            [INPUTS_PULL_DOWN] = GPIO_BIAS_PULL_DOWN};
    return (struct gpio_line_def){.chip = lines->chip,
                                  .line = line->name,
                                  .offset = line->offset,
                                  .bias = BIASES[lines->bias],
                                  .active_low = lines->active_low};
}

static void make_gpio(struct sources *sources, const struct sources_def *def)
{
    struct source_error error;
    const struct inputs *inputs = def->inputs;
    struct gpio_button_def buttons[INPUTS_LINES];
    struct gpio_encoder_def encoders[INPUTS_LINES];
    struct gpio_lamp_def lamps[INPUTS_LINES];
    for (int i = 0; i < inputs->button_count; i++) {
        const struct inputs_lines *from = &inputs->buttons[i];
        buttons[i] = (struct gpio_button_def){from->id, line_of(from, &from->a), from->debounce};
    }
    for (int i = 0; i < inputs->encoder_count; i++) {
        const struct inputs_lines *from = &inputs->encoders[i];
        encoders[i] = (struct gpio_encoder_def){from->id, line_of(from, &from->a), line_of(from, &from->b), from->steps,
                                                from->reversed};
    }
    for (int i = 0; i < inputs->lamp_count; i++) {
        const struct inputs_lines *from = &inputs->lamps[i];
        lamps[i] = (struct gpio_lamp_def){from->id, line_of(from, &from->a)};
    }
    const struct source_gpio_def gpio = {buttons, inputs->button_count, encoders, inputs->encoder_count,
                                         lamps,   inputs->lamp_count};
    bool used = gpio.button_count + gpio.encoder_count + gpio.lamp_count > 0;
    if ((used || def->look) && !sources_add(sources, source_gpio_create(&gpio, &error))) {
        fail(sources, "gpio", &error);
    }
}

static void make_touch(struct sources *sources, const struct sources_def *def)
{
    struct source_error error;
    const struct inputs *inputs = def->inputs;
    struct source_touch_device_def devices[INPUTS_KEYBOARDS];
    uint32_t keys[SOURCE_TOUCH_KEYS];
    int key_count = 0;
    for (int i = 0; i < inputs->keyboard_count; i++) {
        const struct inputs_device *from = &inputs->keyboards[i];
        devices[i] = (struct source_touch_device_def){.match = {from->vendor, from->product, from->name}, .keys = true};
    }
    for (int i = 0; i < inputs->binding_count && key_count < SOURCE_TOUCH_KEYS; i++) {
        if (inputs->bindings[i].source == BINDING_KEY) {
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
    if (def->touch && !sources_add(sources, source_touch_create(&touch, &error))) {
        fail(sources, "touch", &error);
    }
}

struct sources *sources_create(const struct sources_def *def)
{
    struct sources *sources = calloc(1, sizeof *sources);
    if (sources) {
        make_touch(sources, def);
        make_hid(sources, def);
        make_gpio(sources, def);
    }
    return sources;
}

void sources_destroy(struct sources *sources)
{
    for (int i = 0; sources && i < sources->count; i++) {
        source_destroy(sources->sources[i]);
    }
    free(sources);
}

int sources_fds(const struct sources *sources, int fds[SOURCES_MAX])
{
    int count = 0;
    for (int i = 0; i < sources->count; i++) {
        int fd = sources->sources[i]->ops->fd(sources->sources[i]);
        if (fd >= 0) {
            fds[count++] = fd;
        }
    }
    return count;
}

int sources_timeout_ms(const struct sources *sources)
{
    int least = -1;
    for (int i = 0; i < sources->count; i++) {
        int ms = sources->sources[i]->ops->timeout_ms(sources->sources[i]);
        least = ms >= 0 && (least < 0 || ms < least) ? ms : least;
    }
    return least;
}

void sources_dispatch(struct sources *sources)
{
    for (int i = 0; i < sources->count; i++) {
        sources->sources[i]->ops->dispatch(sources->sources[i]);
    }
}

bool sources_event(struct sources *sources, struct event *event)
{
    for (int i = 0; i < sources->count; i++) { /* in turn, so that none keeps the others waiting */
        int index = (sources->turn + i) % sources->count;
        if (sources->sources[index]->ops->event(sources->sources[index], event)) {
            sources->said[index] = event->source;
            sources->turn = (index + 1) % sources->count;
            return true;
        }
    }
    return false;
}

bool sources_device(const struct sources *sources, const struct event *event, struct device *device)
{
    struct device devices[SOURCES_DEVICES];
    for (int i = 0; i < sources->count; i++) {
        const struct source *source = sources->sources[i];
        int count = sources->said[i] == event->source ? source->ops->devices(source, devices, SOURCES_DEVICES) : 0;
        for (int k = 0; k < count && k < SOURCES_DEVICES; k++) {
            if (devices[k].id == event->device) {
                *device = devices[k];
                return true;
            }
        }
    }
    return false;
}

int sources_devices(const struct sources *sources, struct device *devices, int most)
{
    int count = 0;
    for (int i = 0; i < sources->count; i++) {
        int room = most > count ? most - count : 0;
        count += sources->sources[i]->ops->devices(sources->sources[i], devices + (room ? count : 0), room);
    }
    return count;
}

bool sources_log(struct sources *sources, char *line, int size)
{
    if (sources->failure_count > 0) {
        snprintf(line, (size_t)size, "%s", sources->failures[--sources->failure_count]);
        return true;
    }
    for (int i = 0; i < sources->count; i++) {
        if (sources->sources[i]->ops->log(sources->sources[i], line, size)) {
            return true;
        }
    }
    return false;
}

void sources_light(struct sources *sources, int lamp, float level)
{
    bool set = false;
    for (int i = 0; i < sources->count && !set; i++) {
        struct source *source = sources->sources[i];
        set = source->ops->lamp && source->ops->lamp(source, lamp, level);
    }
}

struct source *sources_find(const struct sources *sources, const char *name)
{
    for (int i = 0; i < sources->count; i++) {
        if (strcmp(sources->sources[i]->ops->name, name) == 0) {
            return sources->sources[i];
        }
    }
    return NULL;
}
