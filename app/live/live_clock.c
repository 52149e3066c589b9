#include "live_clock.h"

#include "bench.h"

uint64_t live_clock_at(const struct live_clock *clock, uint64_t real_us)
{
    return clock->kiosk_us ? clock->kiosk_us(clock->context, real_us) : real_us;
}

uint64_t live_clock_us(const struct live_clock *clock)
{
    return live_clock_at(clock, (uint64_t)(1e6 * bench_wall_s()));
}

time_t live_clock_wall(const struct live_clock *clock)
{
    return clock->wall ? clock->wall(clock->context) : time(NULL);
}
