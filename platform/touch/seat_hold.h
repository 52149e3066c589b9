/* Keeps the keys of the seat from everyone else: what the source for touch does while it holds the seat
 * (source_touch.h). Private to it. */
#ifndef FROND_SEAT_HOLD_H
#define FROND_SEAT_HOLD_H

#include "source_queue.h"

struct seat_hold;

/* `console`: the VT that takes no keys from now on; NULL: none. What cannot be done becomes a line of the log. NULL:
 * memory is short. */
struct seat_hold *seat_hold_create(const char *console, struct source_queue *queue);
void seat_hold_destroy(struct seat_hold *hold); /* takes NULL; gives everything back */

/* Grabs an open device (evdev) if it has keys; while somebody else has grabbed it, tries again at each sweep. The grab
 * lasts until the device leaves, also when `fd` is closed: libinput closes what it has no use for, and a joystick may
 * have a power key too. `path` is its node. */
void seat_hold_take(struct seat_hold *hold, int fd, const char *path);
/* Whether its keys reach others: somebody else has grabbed it. */
bool seat_hold_missed(const struct seat_hold *hold, const char *path);
/* Lets go of devices that have left. Returns how many are held, or shall be. */
int seat_hold_sweep(struct seat_hold *hold);

#endif
