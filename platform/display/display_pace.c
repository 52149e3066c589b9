#include "display_pace.h"

void display_pace_stop(struct display_pace *pace)
{
    pace->running = false;
}

uint64_t display_pace_missed(struct display_pace *pace, uint32_t sequence, uint64_t time_us, int refresh_mhz)
{
    struct display_pace last = *pace;
    *pace = (struct display_pace){.running = true, .sequence = sequence, .time_us = time_us};
    if (!last.running) {
        return 0;
    }
    uint32_t steps = sequence - last.sequence;
    if (steps > 0 && steps < UINT32_MAX / 2) {
        return steps - 1;
    }
    if (refresh_mhz <= 0 || time_us <= last.time_us) {
        return 0;
    }
    uint64_t period_us = UINT64_C(1000000000) / (uint64_t)refresh_mhz;
    uint64_t periods = (time_us - last.time_us + period_us / 2) / period_us;
    return periods > 1 ? periods - 1 : 0;
}
