#include "service.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <systemd/sd-daemon.h>

enum {
    PINGS = 4, /* in the time after which the manager gives up */
    STATUS_US = 1000000,
    STATUS_BYTES = 160,
};

struct service {
    uint64_t ping_us, pinged_us; /* ping_us 0: no watchdog waits */
    uint64_t pinged_frames;      /* as they were then */
    uint64_t pinged_turns;
    uint64_t said_us;
    char said[STATUS_BYTES];
    bool ready;
};

struct service *service_create(void)
{
    struct service *service = calloc(1, sizeof *service);
    uint64_t watchdog_us = 0;
    if (service && sd_watchdog_enabled(0, &watchdog_us) > 0) {
        service->ping_us = watchdog_us / PINGS;
    }
    return service;
}

void service_destroy(struct service *service)
{
    if (service) {
        sd_notify(0, "STOPPING=1");
    }
    free(service);
}

static void tell_status(struct service *service, const char *status, uint64_t now_us)
{
    char text[STATUS_BYTES + 16];
    if (!status || (service->said[0] && now_us - service->said_us < STATUS_US) ||
        strncmp(status, service->said, sizeof service->said - 1) == 0) {
        return;
    }
    snprintf(service->said, sizeof service->said, "%s", status);
    service->said_us = now_us;
    snprintf(text, sizeof text, "STATUS=%s", service->said);
    sd_notify(0, text);
}

void service_turn(struct service *service, const struct service_turn *turn, uint64_t now_us)
{
    bool works = turn->rests || turn->turns != service->pinged_turns;
    bool alive = works && (!turn->shown || turn->frames > service->pinged_frames);
    if (alive && !service->ready) {
        service->ready = true;
        service->pinged_us = now_us;
        service->pinged_frames = turn->frames;
        service->pinged_turns = turn->turns;
        sd_notify(0, "READY=1");
    } else if (alive && service->ping_us > 0 && now_us - service->pinged_us >= service->ping_us) {
        service->pinged_us = now_us;
        service->pinged_frames = turn->frames;
        service->pinged_turns = turn->turns;
        sd_notify(0, "WATCHDOG=1");
    }
    tell_status(service, turn->status, now_us);
}

void service_reloaded(struct service *service, uint64_t now_us)
{
    char text[64];
    if (!service->ready) {
        return;
    }
    snprintf(text, sizeof text, "RELOADING=1\nMONOTONIC_USEC=%" PRIu64, now_us);
    sd_notify(0, text);
    sd_notify(0, "READY=1");
}
