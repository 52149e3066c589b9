/* A kiosk in a group of kiosks (group.h), where its exhibit names a broker. */
#ifndef FROND_LIVE_GROUP_H
#define FROND_LIVE_GROUP_H

#include "broker.h"
#include "live_kiosk.h"
#include "status.h"

struct live_group {
    struct broker *broker;       /* NULL: none is named, or none can be had */
    const struct exhibit *since; /* whose broker it is; only compared */
    uint64_t said_us;            /* when the status was said last; 0: not yet */
    uint64_t mark;               /* hash of what the exhibit says of it */
    char line[400];
    bool has_line;
};

/* Once a turn of the loop. `status` has what is counted already. `now_us` of CLOCK_MONOTONIC. */
void live_group_turn(struct live_group *group, struct live_kiosk *kiosk, struct status *status, uint64_t now_us);
void live_group_close(struct live_group *group); /* takes a zeroed one */
/* The next line for the log. */
bool live_group_log(struct live_group *group, char *line, int size);

#endif
