/* What a running kiosk tells those who look after many of them: one JSON file for programs of their own, one text file
 * for Prometheus (exposition format 0.0.4, as node_exporter's textfile collector reads it). Nothing personal: no host
 * name, no path, no serial number, nothing of what was painted. */
#ifndef FROND_STATUS_H
#define FROND_STATUS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    STATUS_DEVICES = 32,
    STATUS_BUCKETS = 8,
    STATUS_WORD = 64,     /* bytes of a name, with the final NUL */
    STATUS_BYTES = 32768, /* of a file, at most */
};

/* How long frames took, from one to the next, while the painting moves. */
struct status_frames {
    uint64_t buckets[STATUS_BUCKETS]; /* that took at most status_bucket_s[i], and more than the one before */
    uint64_t count;
    double sum_s, longest_s;
};

extern const double status_bucket_s[STATUS_BUCKETS];
void status_frame(struct status_frames *frames, double seconds);

struct status_device {
    char name[STATUS_WORD]; /* as it calls itself */
    const char *class;      /* as of struct device; lives for ever */
    bool admitted, works;
};

struct status {
    double uptime_s;          /* since Frond was started */
    int64_t unix_s;           /* when this was, by the machine's clock, right or wrong */
    const char *display;      /* "shown", "dark", "absent", "lent"; lives for ever */
    char state[STATUS_WORD];  /* of the visit: "attract"; "" for a session */
    char scene[STATUS_WORD];  /* its id; "" */
    char engine[STATUS_WORD]; /* "cpu", "gpu" */
    uint64_t visits, drops;   /* begun; fallen from visitors' hands */
    uint64_t frames_presented, blanks_missed, actions_refused;
    struct status_frames frames;
    int64_t ticks;                         /* of the painting now */
    double ticks_per_second, tick_s, grid; /* grid: share of the cells a side that was wished for */
    double celsius;                        /* NAN: not known */
    bool throttled, under_voltage;
    int gallery; /* pictures; -1: none is kept */
    uint64_t exhibit_errors, gpu_resets;
    bool exhibit_wrong; /* its file cannot be used as it is now */
    struct status_device devices[STATUS_DEVICES];
    int device_count;
};

/* Copies a name for one of the fields: what is no UTF-8 becomes "?", controls become spaces; cut between characters. */
void status_word(char word[STATUS_WORD], const char *text);

/* Both fill `text` and return its length; 0 when it does not fit, or memory is short. */
size_t status_json(const struct status *status, char *text, size_t size);
size_t status_metrics(const struct status *status, char *text, size_t size);

#endif
