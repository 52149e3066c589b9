/* What sources have in common: events and log lines that wait to be taken. No release is lost: when the queue is
 * full, motions and values that have newer ones go first (steps are added up), then the oldest press together with its
 * release. Private to the sources. */
#ifndef FROND_SOURCE_QUEUE_H
#define FROND_SOURCE_QUEUE_H

#include "source.h"

enum { SOURCE_LOG_LINES = 32, SOURCE_LOG_LENGTH = 200 };

struct source_queue {
    struct event events[SOURCE_EVENTS];
    unsigned first, count;
    uint64_t dropped; /* events that nobody took in time */
    char lines[SOURCE_LOG_LINES][SOURCE_LOG_LENGTH];
    unsigned line_first, line_count;
};

void source_post(struct source_queue *queue, const struct event *event);
bool source_take(struct source_queue *queue, struct event *event);
void source_note(struct source_queue *queue, const char *format, ...) __attribute__((format(printf, 2, 3)));
bool source_take_line(struct source_queue *queue, char *line, int size);
uint64_t source_now_us(void); /* CLOCK_MONOTONIC */

#endif
