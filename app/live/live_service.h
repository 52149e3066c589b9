/* A live session as the service manager and those who look after many kiosks see it: alive (service.h), and its status
 * in $RUNTIME_DIRECTORY where there is one (status_writer.h). */
#ifndef FROND_LIVE_SERVICE_H
#define FROND_LIVE_SERVICE_H

#include "live_kiosk.h"
#include "service.h"
#include "status.h"
#include "status_writer.h"

struct live_service {
    struct service *service;
    struct status_writer *writer; /* NULL: there is no such folder */
    struct status status;         /* frames and resets are counted here, the rest is filled in when it is written */
    uint64_t start_us;
    uint32_t reloads; /* that the service manager knows of */
};

/* False when memory is short. `now_us` of CLOCK_MONOTONIC, here and below. */
bool live_service_open(struct live_service *service, uint64_t now_us);
void live_service_close(struct live_service *service); /* takes a zeroed one */
/* Once a turn of the loop, whether a frame is drawn or not. */
void live_service_turn(struct live_service *service, const struct live_kiosk *kiosk, uint64_t now_us);
/* The next line for the log. */
bool live_service_log(struct live_service *service, char *line, int size);

/* What there is to tell, but for what is counted in `status` already. */
void live_service_status(struct status *status, const struct live_kiosk *kiosk, uint64_t now_us);

#endif
