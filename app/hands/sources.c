#include "sources.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "device_class.h"

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

static void fail(struct sources *sources, const char *name, const struct device_error *error)
{
    if (sources->failure_count < SOURCES_MAX) {
        snprintf(sources->failures[sources->failure_count++], LINE, "%s: %s", name, error->text);
    }
}

struct sources *sources_create(const struct sources_def *def)
{
    struct sources *sources = calloc(1, sizeof *sources);
    for (int i = 0; sources && device_classes[i]; i++) {
        struct device_error error = {""};
        if (!sources_add(sources, device_classes[i]->create(def, &error)) && error.text[0]) {
            fail(sources, device_classes[i]->noun, &error);
        }
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

struct source *sources_at(const struct sources *sources, int index)
{
    return index < sources->count ? sources->sources[index] : NULL;
}
