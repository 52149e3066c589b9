#include "kms_pace.h"

void kms_pace_stop(struct kms_pace *pace)
{
    pace->running = false;
}

uint64_t kms_pace_missed(struct kms_pace *pace, const struct kms_flip *flip, int refresh_mhz)
{
    struct kms_pace last = *pace;
    *pace = (struct kms_pace){.running = true, .sequence = flip->sequence, .time_us = flip->time_us};
    if (!last.running) {
        return 0;
    }
    uint32_t steps = flip->sequence - last.sequence;
    if (steps > 0 && steps < UINT32_MAX / 2) {
        return steps - 1;
    }
    if (refresh_mhz <= 0 || flip->time_us <= last.time_us) {
        return 0;
    }
    uint64_t period_us = UINT64_C(1000000000) / (uint64_t)refresh_mhz;
    uint64_t periods = (flip->time_us - last.time_us + period_us / 2) / period_us;
    return periods > 1 ? periods - 1 : 0;
}
