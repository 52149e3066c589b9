#include "devices_text.h"

#include <string.h>

#include "device_class.h"

enum { DEVICES_CONTROL = 160 }; /* what a control is called, at most */

static void print_device(const struct source *source, const struct device *device, FILE *out)
{
    const struct device_class *of = device_class_of(source);
    fprintf(out, "%s '%s'", device->class, device->name);
    if (device->vendor || device->product) {
        fprintf(out, " %04x:%04x", device->vendor, device->product);
    }
    fprintf(out, "%s%s%s%s, %s\n", *device->path ? " " : "", device->path, *device->port ? " at " : "", device->port,
            device->admitted ? "admitted" : "not admitted");
    if (of && of->print) {
        of->print(source, device, out);
    }
    if (*device->trouble) {
        fprintf(out, "    missing: %s\n", device->trouble);
    }
}

void devices_print(const struct sources *sources, FILE *out)
{
    struct device devices[SOURCES_DEVICES];
    const struct source *source;
    for (int i = 0; (source = sources_at(sources, i)); i++) {
        const struct device_class *of = device_class_of(source);
        int count = source->ops->devices(source, devices, SOURCES_DEVICES);
        if (count == 0 && of) {
            fprintf(out, "%s\n", of->none);
        }
        for (int k = 0; k < count && k < SOURCES_DEVICES; k++) {
            print_device(source, &devices[k], out);
        }
    }
}

bool devices_event(const struct event *event, const struct device *device, const struct inputs *inputs, char *text,
                   size_t size)
{
    static const char *const KINDS[] = {
        [EVENT_DOWN] = "finger down",       [EVENT_MOVE] = "finger moves", [EVENT_UP] = "finger up",
        [EVENT_CANCEL] = "finger was none", [EVENT_ARRIVED] = "has come",  [EVENT_LEFT] = "has left"};
    char name[DEVICES_CONTROL];
    switch (event->kind) {
    case EVENT_DOWN:
    case EVENT_MOVE:
    case EVENT_UP:
    case EVENT_CANCEL:
        snprintf(text, size, "'%s' %s %d at %.3f, %.3f", device->name, KINDS[event->kind], event->slot,
                 (double)event->x, (double)event->y);
        return true;
    case EVENT_ARRIVED:
    case EVENT_LEFT:
        snprintf(text, size, "'%s' %s", device->name, KINDS[event->kind]);
        return true;
    case EVENT_STANDING:
        binding_source_of(event, inputs, name, sizeof name);
        snprintf(text, size, "'%s' %s is on", device->name, name);
        return true;
    case EVENT_CONTROL: {
        binding_source_of(event, inputs, name, sizeof name);
        int length = snprintf(text, size, "'%s' %s", device->name, name);
        if (event->index > 0 && length > 0 && (size_t)length < size) {
            length += snprintf(text + length, size - (size_t)length, " (index %d)", event->index);
        }
        if (length > 0 && (size_t)length < size) {
            snprintf(text + length, size - (size_t)length,
                     event->null       ? " nowhere"
                     : event->relative ? " %+g"
                                       : " %.3f",
                     (double)event->value);
        }
        return true;
    }
    default:
        return false;
    }
}

static bool is_seen(struct devices_seen *seen, const struct event *event)
{
    for (int i = 0; i < seen->count; i++) {
        if (seen->controls[i].source == event->source && seen->controls[i].device == event->device &&
            seen->controls[i].control == event->control && seen->controls[i].index == event->index) {
            return true;
        }
    }
    if (seen->count < DEVICES_SEEN) {
        seen->controls[seen->count].source = event->source;
        seen->controls[seen->count].device = event->device;
        seen->controls[seen->count].control = event->control;
        seen->controls[seen->count++].index = event->index;
    }
    return false;
}

/* The controller of the file that this is, as "controller: knob, "; nothing where it is not listed. */
static void controller_part(const struct binding_source *from, const struct device *device, const struct inputs *inputs,
                            char *text, size_t size)
{
    int count = 0;
    const struct inputs_device *devices = from->devices ? from->devices(inputs, &count) : NULL;
    text[0] = '\0';
    for (int i = 0; i < count; i++) {
        if (inputs_match(&devices[i], device->vendor, device->product, device->name)) {
            snprintf(text, size, "controller: %s, ", devices[i].id);
            return;
        }
    }
}

static const char *usual_action(const struct binding_source *from, const struct event *event)
{
    const char *action = from->action ? from->action(event) : NULL;
    bool axis = event->relative || event->centred || (event->value > 0 && event->value < 1);
    return action ? action : axis ? BINDING_TURN : "drop: {}";
}

bool devices_binding(const struct event *event, const struct device *device, const struct inputs *inputs,
                     struct devices_seen *seen, char *text, size_t size)
{
    char name[DEVICES_CONTROL], controller[64], index[24] = "";
    bool finger = event->kind == EVENT_DOWN;
    struct event one = *event;
    if (finger) {
        one.control = 0;
        one.index = 0;
    }
    if ((!finger && event->kind != EVENT_CONTROL) || is_seen(seen, &one)) {
        return false;
    }
    if (finger) {
        snprintf(text, size, "- {touch: press, drop: {}}");
        return true;
    }
    const struct binding_source *from = binding_source_of(event, inputs, name, sizeof name);
    if (!from || (from->written && !from->written(inputs, event->control, name, sizeof name))) {
        return false;
    }
    if (event->index > 0) {
        snprintf(index, sizeof index, "index: %d, ", event->index);
    }
    controller_part(from, device, inputs, controller, sizeof controller);
    const char *quote = strchr(name, ':') ? "'" : "";
    snprintf(text, size, "- {%s: %s%s%s, %s%s%s}", from->key.name, quote, name, quote, controller, index,
             usual_action(from, event));
    return true;
}
