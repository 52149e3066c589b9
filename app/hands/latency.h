/* How long visitors wait: from the kernel's time of an event to the tick that consumed it, and to the flip that showed
 * it. A sliding window of the newest figures; pure. */
#ifndef FROND_LATENCY_H
#define FROND_LATENCY_H

#include <stdbool.h>
#include <stdint.h>

enum { LATENCY_WINDOW = 1024, LATENCY_WAITING = 512 };

struct latency_figures {
    int64_t count;        /* ever measured; 0: the rest means nothing */
    double p50, p95, max; /* ms, of the newest LATENCY_WINDOW; a percentile is the least value that so many reach */
};

struct latency_window {
    uint32_t us[LATENCY_WINDOW];
    int64_t count;
};

struct latency { /* all zero: nothing yet */
    struct latency_window tick, flip;
    struct latency_waiting { /* consumed, not shown yet; in the order of `published` */
        uint64_t event_us;
        uint64_t published;
    } waiting[LATENCY_WAITING];
    int waiting_count;
    uint64_t lost; /* that the table had no room for */
};

/* A tick consumed at `tick_us` what an event at `event_us` had caused, and the fields published as number `published`,
 * 1.., are the first to hold it. */
void latency_tick(struct latency *latency, uint64_t event_us, uint64_t tick_us, uint64_t published);
/* Fields number `published` reached the screen at `flip_us`; all that waited for them, or for older ones, was seen. */
void latency_flip(struct latency *latency, uint64_t published, uint64_t flip_us);
/* Nobody saw it: the screen is dark, or the picture was lost. */
void latency_forget(struct latency *latency);
struct latency_figures latency_figures(const struct latency_window *window);
/* "of 120 actions: to the tick p50 8.1 p95 17.0 max 20.3 ms, to the flip p50 ..."; "" when nothing was measured. */
const char *latency_text(const struct latency *latency, char *text, int size);

#endif
