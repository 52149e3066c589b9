#include "source_queue.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "source_device.h"

static struct event *at(struct source_queue *queue, unsigned place)
{
    return &queue->events[(queue->first + place) % SOURCE_EVENTS];
}

static void take_out(struct source_queue *queue, unsigned place)
{
    for (unsigned i = place; i + 1 < queue->count; i++) {
        *at(queue, i) = *at(queue, i + 1);
    }
    queue->count--;
    queue->dropped++;
}

static bool same_control(const struct event *a, const struct event *b)
{
    return a->kind == b->kind && a->device == b->device && a->control == b->control && a->index == b->index &&
           a->slot == b->slot;
}

/* Whether nobody misses an event of which the same finger or control has a later one. Ends of the range are kept: they
 * may be the press and the release of a button. */
static bool is_passing(const struct event *event)
{
    if (event->kind == EVENT_CONTROL) {
        return event->relative || event->centred || (event->value != 0 && event->value != 1);
    }
    return event->kind == EVENT_MOVE;
}

static bool take_passing(struct source_queue *queue)
{
    for (unsigned i = 0; i < queue->count; i++) {
        const struct event *event = at(queue, i);
        for (unsigned j = i + 1; is_passing(event) && j < queue->count; j++) {
            struct event *later = at(queue, j);
            if (same_control(event, later)) {
                later->value += event->relative ? event->value : 0;
                take_out(queue, i);
                return true;
            }
        }
    }
    return false;
}

static bool ends(const struct event *event, const struct event *later)
{
    if (event->kind == EVENT_DOWN) {
        return (later->kind == EVENT_UP || later->kind == EVENT_CANCEL) && later->device == event->device &&
               later->slot == event->slot;
    }
    return event->kind == EVENT_CONTROL && event->value == 1 && same_control(event, later) && later->value == 0;
}

/* A press and its release, both or neither: what is down for those who listen can always come up. */
static bool take_pair(struct source_queue *queue)
{
    for (unsigned i = 0; i < queue->count; i++) {
        for (unsigned j = i + 1; j < queue->count; j++) {
            if (ends(at(queue, i), at(queue, j))) {
                take_out(queue, j);
                take_out(queue, i);
                return true;
            }
        }
    }
    return false;
}

static void make_room(struct source_queue *queue)
{
    if (!take_passing(queue) && !take_pair(queue)) {
        take_out(queue, 0); /* a thousand different things at once: cannot happen with real hands */
    }
}

void source_post(struct source_queue *queue, const struct event *event)
{
    if (queue->count == SOURCE_EVENTS) {
        make_room(queue);
    }
    *at(queue, queue->count) = *event;
    queue->count++;
}

bool source_take(struct source_queue *queue, struct event *event)
{
    if (queue->count == 0) {
        return false;
    }
    *event = queue->events[queue->first];
    queue->first = (queue->first + 1) % SOURCE_EVENTS;
    queue->count--;
    return true;
}

void source_note(struct source_queue *queue, const char *format, ...)
{
    va_list arguments;
    if (queue->line_count == SOURCE_LOG_LINES) {
        queue->line_first = (queue->line_first + 1) % SOURCE_LOG_LINES;
        queue->line_count--;
    }
    char *line = queue->lines[(queue->line_first + queue->line_count) % SOURCE_LOG_LINES];
    va_start(arguments, format);
    vsnprintf(line, SOURCE_LOG_LENGTH, format, arguments);
    va_end(arguments);
    device_clean_text(line);
    queue->line_count++;
}

bool source_take_line(struct source_queue *queue, char *line, int size)
{
    if (queue->line_count == 0) {
        return false;
    }
    snprintf(line, (size_t)size, "%s", queue->lines[queue->line_first]);
    queue->line_first = (queue->line_first + 1) % SOURCE_LOG_LINES;
    queue->line_count--;
    return true;
}

uint64_t source_now_us(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000u + (uint64_t)now.tv_nsec / 1000u;
}
