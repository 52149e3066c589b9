#include "source_queue.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

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

/* Motion that a later event of the same finger makes superfluous, or nothing: then the oldest motion. */
static void make_room(struct source_queue *queue)
{
    for (unsigned i = 0; i < queue->count; i++) {
        const struct event *event = at(queue, i);
        for (unsigned j = i + 1; event->kind == EVENT_MOVE && j < queue->count; j++) {
            if (same_control(event, at(queue, j))) {
                take_out(queue, i);
                return;
            }
        }
    }
    /* A value between two others of its control: the last of a control is kept, and steps are added up. */
    for (unsigned i = 0; i < queue->count; i++) {
        const struct event *event = at(queue, i);
        for (unsigned j = i + 1; event->kind == EVENT_CONTROL && j < queue->count; j++) {
            if (same_control(event, at(queue, j))) {
                at(queue, j)->value += event->relative ? event->value : 0;
                take_out(queue, i);
                return;
            }
        }
    }
    take_out(queue, 0); /* a thousand different things at once: cannot happen with real hands */
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

bool source_fail(struct source_error *error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(error->text, sizeof error->text, format, arguments);
    va_end(arguments);
    return false;
}
