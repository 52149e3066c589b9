#include "live_service.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const char *const DISPLAYS[] = {"shown", "dark", "absent", "lent"}; /* enum display_state */

bool live_service_open(struct live_service *service, uint64_t now_us)
{
    const char *folder = getenv("RUNTIME_DIRECTORY");
    char path[1200];
    *service = (struct live_service){.service = service_create(), .start_us = now_us};
    bool absolute = folder && folder[0] == '/';
    if (absolute) {
        snprintf(path, sizeof path, "%.*s", (int)strcspn(folder, ":"), folder);
        service->writer = status_writer_create(path);
    }
    return service->service && (service->writer || !absolute);
}

void live_service_close(struct live_service *service)
{
    status_writer_destroy(service->writer);
    service_destroy(service->service);
    *service = (struct live_service){.service = NULL};
}

static void fill_devices(struct status *status, const struct live_input *input)
{
    struct device devices[STATUS_DEVICES];
    int count = sources_devices(input->sources, devices, STATUS_DEVICES);
    status->device_count = count < STATUS_DEVICES ? count : STATUS_DEVICES;
    for (int i = 0; i < status->device_count; i++) {
        struct status_device *device = &status->devices[i];
        device->class = devices[i].class;
        device->admitted = devices[i].admitted;
        device->works = devices[i].admitted && !devices[i].trouble[0];
        status_word(device->name, devices[i].name);
    }
}

void live_service_status(struct status *status, const struct live_kiosk *kiosk, uint64_t now_us)
{
    const struct live_status_def *from = &kiosk->status;
    struct studio_report report = studio_report(from->studio);
    struct display_frames frames = display_frames(from->display);
    struct thermal_reading heat = thermal_read(from->care->thermal, (int64_t)now_us);
    status->display = DISPLAYS[display_state(from->display)];
    status_word(status->engine, from->kind);
    status->frames_presented = frames.presented;
    status->blanks_missed = frames.missed;
    status->actions_refused = from->input->refused;
    status->ticks = report.ticks;
    status->ticks_per_second = report.ticks_per_second;
    status->tick_s = report.tick_ms / 1000;
    status->grid = (double)report.scale;
    status->celsius = (double)heat.celsius;
    status->throttled = heat.throttled;
    status->under_voltage = heat.under_voltage;
    status->gallery = kiosk->gallery ? gallery_count(kiosk->gallery) : -1;
    status->drops = kiosk->drops;
    status->exhibit_errors = kiosk->errors;
    status->exhibit_wrong = kiosk->wrong;
    status->state[0] = status->scene[0] = '\0';
    if (kiosk->kiosk) {
        const char *scene = kiosk_scene(kiosk->kiosk)->id;
        status->visits = kiosk_visits(kiosk->kiosk);
        status_word(status->state, kiosk_state(kiosk->kiosk));
        status_word(status->scene, scene ? scene : "");
    }
    fill_devices(status, from->input);
}

static void feed(struct live_service *service, const struct live_kiosk *kiosk, uint64_t now_us)
{
    char text[120];
    struct display *display = kiosk->status.display;
    struct studio_report report = studio_report(kiosk->status.studio);
    struct service_turn turn = {.frames = display_frames(display).presented,
                                .turns = report.turns,
                                .rests = report.rests,
                                .shown = display_state(display) == DISPLAY_SHOWN};
    if (kiosk->kiosk) {
        snprintf(text, sizeof text, "%s; screen %s; visit %u%s", kiosk_state(kiosk->kiosk),
                 DISPLAYS[display_state(display)], kiosk_visits(kiosk->kiosk),
                 kiosk->wrong ? "; the exhibit's file is wrong" : "");
        turn.status = text;
    }
    service_turn(service->service, &turn, now_us);
}

void live_service_turn(struct live_service *service, const struct live_kiosk *kiosk, uint64_t now_us)
{
    feed(service, kiosk, now_us);
    if (service->reloads != kiosk->reloads) {
        service->reloads = kiosk->reloads;
        service_reloaded(service->service, now_us);
    }
    service->status.uptime_s = (double)(now_us - service->start_us) / 1e6;
    service->status.unix_s = (int64_t)time(NULL);
    if (service->writer && status_writer_due(service->writer, now_us)) {
        live_service_status(&service->status, kiosk, now_us);
        status_writer_post(service->writer, &service->status, now_us);
    }
}

bool live_service_log(struct live_service *service, char *line, int size)
{
    return service->writer && status_writer_log(service->writer, line, size);
}
