/* The two clocks of a live session: the one that runs, and the one on the wall. A test makes days of them pass in
 * minutes, or lets the wall's jump. Devices, ticks and frames have the real ones always. */
#ifndef FROND_LIVE_CLOCK_H
#define FROND_LIVE_CLOCK_H

#include <stdint.h>
#include <time.h>

struct live_clock { /* each NULL: the real one */
    /* What the visit's times are counted by, at a time of CLOCK_MONOTONIC in microseconds; never goes back. */
    uint64_t (*kiosk_us)(void *context, uint64_t real_us);
    time_t (*wall)(void *context); /* as time() */
    void *context;
};

uint64_t live_clock_at(const struct live_clock *clock, uint64_t real_us);
uint64_t live_clock_us(const struct live_clock *clock); /* now */
time_t live_clock_wall(const struct live_clock *clock);

#endif
