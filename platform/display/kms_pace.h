/* Counts the frames that reach the screen and the vertical blanks that went by without one. */
#ifndef FROND_KMS_PACE_H
#define FROND_KMS_PACE_H

#include <stdbool.h>
#include <stdint.h>

#include "kms_calls.h"

struct kms_pace {
    bool running; /* a flip has been counted since the last stop */
    uint32_t sequence;
    uint64_t time_us;
};

/* The screen went dark, away, or into another mode: the next flip has nothing to be compared with. */
void kms_pace_stop(struct kms_pace *pace);
/* Vertical blanks between the last flip and this one at which the last picture was shown again: by the kernel's
 * counter, which wraps at 2^32, or by the refresh (thousandths of a hertz) where the driver does not count. */
uint64_t kms_pace_missed(struct kms_pace *pace, const struct kms_flip *flip, int refresh_mhz);

#endif
