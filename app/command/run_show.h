/* What `frond run` does once its command line is read. */
#ifndef FROND_RUN_SHOW_H
#define FROND_RUN_SHOW_H

#include "display.h"
#include "live.h"

struct run_order {
    struct display_def display;
    struct live_def live;
    bool none;          /* no display at all: render */
    bool rotated;       /* display.rotation was asked for */
    int rate;           /* ticks a second that were asked for; 0: none were */
    int ticks;          /* -1: the script's */
    const char *inputs; /* path; NULL: the default ones */
    bool standby;       /* an exhibit that is wrong, or not there, is waited for */
};

/* Shows an exhibit or a session; NULL: the exhibit that comes with Frond, or where there is no display its
 * demonstration session. Returns the exit status. */
int run_show(const char *path, const struct run_order *order);

#endif
