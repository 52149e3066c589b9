/* What a soak costs and how it fares: memory, descriptors, threads, delays, frames, and what is written where. */
#ifndef FROND_SOAK_GAUGE_H
#define FROND_SOAK_GAUGE_H

#include "soak.h"

enum { GAUGE_WINDOWS = 4096, GAUGE_MS = 2000, GAUGE_FOLDERS = 2 };

struct gauge_window { /* the least of each second's samples, which is what there is while nothing is under way */
    double s;
    double resident_kb, used_kb; /* RSS; what malloc has handed out */
    int descriptors, threads;
    int descriptors_most, threads_most;
    uint32_t visits;
};

struct delays {
    uint32_t ms[GAUGE_MS]; /* how many took so long; the last one: or longer */
    int64_t total, read;   /* of the window that is read */
};

struct gauge {
    double window_s, sample_s, told_s;
    struct gauge_window windows[GAUGE_WINDOWS];
    int count; /* windows; the last one is being filled */
    struct delays tick, flip;
    struct display_frames frames_told;
    uint32_t visits_told;
    int writes; /* inotify */
    bool watched[GAUGE_FOLDERS];
    double calm_s; /* since when it is in attract; 0: it is not */
    bool quiet;    /* it is for long enough, since the last turn at least */
    int kept_most, sheets;
    long long bytes_most;
    bool resting; /* no visitor comes any more: memory is not looked at */
    int quiet_turns, kept_seen;
};

bool gauge_open(struct gauge *gauge, struct soak *soak, double window_s);
/* After each turn. */
void gauge_turn(struct gauge *gauge, struct soak *soak);
/* The figures since the last time. */
void gauge_tell(struct gauge *gauge, struct soak *soak);
/* All of it at the end, and whether it may be so. `slopes`: it was long enough for them to mean something. */
void gauge_judge(struct gauge *gauge, struct soak *soak, bool slopes);
void gauge_close(struct gauge *gauge);

#endif
