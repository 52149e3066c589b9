#include "device_class.h"

#include <string.h>

/* One line a class: the order of their rows in an inputs file. */
#define CLASSES(EACH)                                                                                                  \
    EACH(class_touch)                                                                                                  \
    EACH(class_hid)                                                                                                    \
    EACH(class_gpio)

#define DECLARE(class) extern const struct device_class class;
#define LIST(class)    &(class),
CLASSES(DECLARE)

const struct device_class *const device_classes[] = {CLASSES(LIST) NULL};

const struct device_class *device_class_of(const struct source *source)
{
    int i = 0;
    while (device_classes[i] && strcmp(device_classes[i]->source, source->ops->name) != 0) {
        i++;
    }
    return device_classes[i];
}

const struct binding_source *binding_source_of(const struct event *event, const struct inputs *inputs, char *text,
                                               size_t size)
{
    for (int i = 0; device_classes[i]; i++) {
        for (const struct binding_source *from = device_classes[i]->sources; from->key.name; from++) {
            if (from->source == event->source && from->name(inputs, event->control, text, size)) {
                return from;
            }
        }
    }
    snprintf(text, size, "%u", event->control);
    return NULL;
}
