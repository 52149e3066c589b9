#include "latency.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void add(struct latency_window *window, uint64_t from_us, uint64_t to_us)
{
    uint64_t us = to_us > from_us ? to_us - from_us : 0;
    window->us[window->count++ % LATENCY_WINDOW] = us < UINT32_MAX ? (uint32_t)us : UINT32_MAX;
}

void latency_tick(struct latency *latency, uint64_t event_us, uint64_t tick_us, uint64_t published)
{
    add(&latency->tick, event_us, tick_us);
    if (latency->waiting_count < LATENCY_WAITING) {
        latency->waiting[latency->waiting_count++] = (struct latency_waiting){event_us, published};
    } else {
        latency->lost++;
    }
}

void latency_flip(struct latency *latency, uint64_t published, uint64_t flip_us)
{
    int left = 0;
    for (int i = 0; i < latency->waiting_count; i++) {
        struct latency_waiting waiting = latency->waiting[i];
        if (waiting.published <= published) {
            add(&latency->flip, waiting.event_us, flip_us);
        } else {
            latency->waiting[left++] = waiting;
        }
    }
    latency->waiting_count = left;
}

void latency_forget(struct latency *latency)
{
    latency->waiting_count = 0;
}

static int compare(const void *a, const void *b)
{
    uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

/* The least that `percent` of them do not exceed. */
static double percentile(const uint32_t *sorted, int count, int percent)
{
    int rank = (count * percent + 99) / 100;
    return sorted[rank > 0 ? rank - 1 : 0] / 1000.0;
}

struct latency_figures latency_figures(const struct latency_window *window)
{
    uint32_t sorted[LATENCY_WINDOW];
    int count = window->count < LATENCY_WINDOW ? (int)window->count : LATENCY_WINDOW;
    if (count == 0) {
        return (struct latency_figures){0};
    }
    memcpy(sorted, window->us, (size_t)count * sizeof *sorted);
    qsort(sorted, (size_t)count, sizeof *sorted, compare);
    return (struct latency_figures){window->count, percentile(sorted, count, 50), percentile(sorted, count, 95),
                                    sorted[count - 1] / 1000.0};
}

const char *latency_text(const struct latency *latency, char *text, int size)
{
    struct latency_figures tick = latency_figures(&latency->tick), flip = latency_figures(&latency->flip);
    text[0] = '\0';
    if (tick.count > 0) {
        int length = snprintf(text, (size_t)size, "of %lld actions: to the tick p50 %.1f p95 %.1f max %.1f ms",
                              (long long)tick.count, tick.p50, tick.p95, tick.max);
        if (flip.count > 0 && length < size) {
            snprintf(text + length, (size_t)(size - length), ", to the flip p50 %.1f p95 %.1f max %.1f ms", flip.p50,
                     flip.p95, flip.max);
        }
    }
    return text;
}
