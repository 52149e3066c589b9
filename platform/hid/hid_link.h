/* An open HID device: one thread reads its reports as they come, another, where there are lamps, writes them.
 *
 * Why threads: hidapi shows no descriptor that could be polled, Linux keeps no more than 64 reports for a reader (64 ms
 * of a controller that speaks at 1 kHz), and a write to a device that stalls takes five seconds. So each report is
 * taken and stamped within microseconds of the kernel's having it, however long a frame takes, and nothing that a
 * device does holds up the kiosk. The handles belong to one thread each: hidapi forbids two in one. Private to
 * source_hid.c. */
#ifndef FROND_HID_LINK_H
#define FROND_HID_LINK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    HID_LINK_REPORTS = 256, /* wait to be taken: a quarter of a second at 1 kHz */
    HID_LINK_WRITE = 1024,  /* bytes of the largest report that is written */
    HID_LINK_WRITES = 8,    /* different output reports that may wait */
};

struct hid_link;

struct hid_link_def {
    const char *path; /* "/dev/hidraw0" */
    size_t report;    /* bytes of the longest input report with its id */
    bool numbered;    /* reports begin with an id */
    bool lamps;       /* something will be written */
    int wake_fd;      /* an eventfd that is written to when there is something to take; outlives the link */
};

/* NULL: it could not be opened; errno says why. */
struct hid_link *hid_link_open(const struct hid_link_def *def);
/* The next report, and when it came (CLOCK_MONOTONIC). Returns its size, at most `most`; 0: none. */
size_t hid_link_take(struct hid_link *link, uint8_t *bytes, size_t most, uint64_t *time_us);
uint64_t hid_link_lost(const struct hid_link *link); /* reports that were overwritten by newer ones of their id */
bool hid_link_failed(const struct hid_link *link);   /* reading ended: the device is gone, or does not answer */
/* Hands over an output report, id first; one of the same id that still waits is replaced. Never blocks. */
void hid_link_write(struct hid_link *link, const uint8_t *bytes, size_t size);
bool hid_link_refuses(const struct hid_link *link); /* the last write failed, or has been going on for a second */

/* Asks the threads to end, and returns at once. */
void hid_link_stop(struct hid_link *link);
bool hid_link_ended(const struct hid_link *link); /* they have: destroying will not wait */
void hid_link_destroy(struct hid_link *link); /* takes NULL; waits for the threads: up to 5 s where a write stalls */

#endif
