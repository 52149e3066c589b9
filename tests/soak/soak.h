/* A kiosk that is left alone with its visitors: the real loop (live_loop.h) on a display in memory, with devices that
 * are not there, a clock for the visit that runs SOAK_SPEED times as fast, and everything going wrong that can. */
#ifndef FROND_SOAK_H
#define FROND_SOAK_H

#include <stdbool.h>
#include <stdint.h>

#include "folder_case.h"
#include "live_loop.h"
#include "source_fake.h"

enum {
    SOAK_SPEED = 15,
    SOAK_WIDTH = 320,
    SOAK_HEIGHT = 200,
    SOAK_FINGERS = 4,
    SOAK_PICTURES = 12, /* that the gallery may keep */
    SOAK_MEGABYTES = 1,
};

enum soak_source { SOAK_TOUCH, SOAK_PAD, SOAK_LINES, SOAK_SOURCES };
enum soak_line { LINE_FINISH, LINE_STAFF, LINE_SWITCH }; /* numbers of the exhibit's buttons */

struct soak {
    char root[FOLDER_CASE_PATH]; /* a folder of its own */
    char pictures[80];           /* in it */
    char file[80];               /* the exhibit */
    char disk[80];               /* mounted, where `disks`; the state is in it */
    char state[96];
    bool disks; /* can be mounted, filled and made read-only */
    uint32_t random;

    struct live live;
    struct live_def def;
    struct display *display;
    struct source *fakes[SOAK_SOURCES]; /* the input's */
    uint64_t began_us;                  /* CLOCK_MONOTONIC */
    uint64_t event_us;                  /* of what is posted; 0: now */
    uint64_t ahead_us;                  /* that the visit's clock has jumped */
    int64_t wall_ahead_s;
    int variant; /* of the exhibit, as it was written last */
    int inputs;  /* of its inputs */

    uint64_t refused, refused_before; /* actions */
    int exits;                        /* that somebody has found */
    double turn_s, turn_most_s;       /* what a turn of the loop took: the last, the longest */
    int turns, slow_turns;            /* slow: longer than SLOW_S */
    bool failed;
};

double soak_s(const struct soak *soak); /* since it began */
uint32_t soak_random(struct soak *soak, uint32_t below);
/* Tells what is wrong; the soak goes on, and has failed. */
void soak_fail(struct soak *soak, const char *format, ...) __attribute__((format(printf, 2, 3)));
void soak_say(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* False with the reason said. The process must have one thread. */
bool soak_open(struct soak *soak, uint32_t seed);
/* One turn of the loop, and what the soak has to do for it. False: it has ended. */
bool soak_turn(struct soak *soak);
void soak_close(struct soak *soak);
/* The exhibit as it should be, written as an editor does (`in_place`) or by rename. */
void soak_write_exhibit(struct soak *soak, bool in_place);
bool soak_put(const char *path, const void *bytes, size_t size);
void soak_post(struct soak *soak, enum soak_source source, int device, const struct event *event);

#endif
