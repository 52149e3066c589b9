#include "live_clock.h"

#include "bench.h"

uint64_t live_clock_us(const struct live_clock *clock)
{
    return clock->kiosk_us ? clock->kiosk_us(clock->context) : (uint64_t)(1e6 * bench_wall_s());
}

time_t live_clock_wall(const struct live_clock *clock)
{
    return clock->wall ? clock->wall(clock->context) : time(NULL);
}
