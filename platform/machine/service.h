/* What the service manager hears of a running kiosk, by sd_notify(3): that it is ready, alive, what it does, and that
 * it ends. Without a service manager (no NOTIFY_SOCKET) nothing is said and everything works.
 *
 * - READY=1: after the first completed frame, or the first turn while none can complete
 * - WATCHDOG=1: four times in WatchdogSec, and only if a frame has been completed since the last one, and the thread
 *   that paints has turned or has been told to rest: what hangs in the loop, in a tick, in GL or in the kernel's page
 *   flip starves it, and the manager starts Frond again. While no frame can complete, the screen being absent, dark or
 *   lent, frames do not count: that is a state of days, and no fault
 * - STATUS=: what the visit is in, at most once a second, when it is another than before
 * - RELOADING=1: around another exhibit, with READY=1 after it
 * - STOPPING=1: at the end */
#ifndef FROND_SERVICE_H
#define FROND_SERVICE_H

#include <stdbool.h>
#include <stdint.h>

struct service;

/* NULL when memory is short. WATCHDOG_USEC counts where WATCHDOG_PID is this process. NOTIFY_SOCKET stays in the
 * environment, which no thread may change while others run; the unit listens to its main process only (NotifyAccess).
 */
struct service *service_create(void);
void service_destroy(struct service *service); /* takes NULL */

struct service_turn {
    uint64_t frames;    /* completed page flips since the start (display_frames) */
    uint64_t turns;     /* of the thread that paints (struct studio_report) */
    bool rests;         /* that thread waits until it is told to go on */
    bool shown;         /* a frame can complete: the screen is there, switched on and ours (DISPLAY_SHOWN) */
    const char *status; /* one line; NULL: nothing to say */
};

/* Once a turn of the loop, never before it. `now_us` of CLOCK_MONOTONIC. Never waits. */
void service_turn(struct service *service, const struct service_turn *turn, uint64_t now_us);
/* The exhibit is another one, as of now. */
void service_reloaded(struct service *service, uint64_t now_us);

#endif
