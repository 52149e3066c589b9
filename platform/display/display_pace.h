/* Counts the frames that reach the screen and the vertical blanks that went by without one. */
#ifndef FROND_DISPLAY_PACE_H
#define FROND_DISPLAY_PACE_H

#include <stdbool.h>
#include <stdint.h>

struct display_pace {
    bool running; /* a flip has been counted since the last stop */
    uint32_t sequence;
    uint64_t time_us;
};

/* The screen went dark, away, or into another mode: the next flip has nothing to be compared with. */
void display_pace_stop(struct display_pace *pace);
/* Vertical blanks between the last flip and this one, at `time_us` of CLOCK_MONOTONIC, at which the last picture was
 * shown again: by the `sequence` of vertical blanks, which wraps at 2^32, or by the refresh (thousandths of a hertz)
 * where nobody counts them and it stays the same. */
uint64_t display_pace_missed(struct display_pace *pace, uint32_t sequence, uint64_t time_us, int refresh_mhz);

#endif
