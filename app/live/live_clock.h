/* The two clocks of a live session: the one that runs, and the one on the wall. A test makes days of them pass in
 * minutes, or lets the wall's jump. Devices, ticks and frames have the real ones always. */
#ifndef FROND_LIVE_CLOCK_H
#define FROND_LIVE_CLOCK_H

#include <stdint.h>
#include <time.h>

struct live_clock {                      /* each NULL: the real one */
    uint64_t (*kiosk_us)(void *context); /* microseconds that never go back: what the visit's times are counted by */
    time_t (*wall)(void *context);       /* as time() */
    void *context;
};

uint64_t live_clock_us(const struct live_clock *clock);
time_t live_clock_wall(const struct live_clock *clock);

#endif
