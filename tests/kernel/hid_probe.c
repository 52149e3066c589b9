/* hid_probe: controllers by source_hid; prints what comes. Lamp 0 is the indicator of a space mouse, lamp 1 the third
 * byte of a vendor-defined board, whose first bit is Button 1. Every turn of its loop takes a frame of 16 ms.
 *
 * Standard input: "lamp N LEVEL", "devices", "count" (presses and releases so far), "quit". */
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "hid_usage.h"
#include "source_hid.h"
#include "source_queue.h"

struct counts {
    int presses, releases;
    unsigned latest_us;
};

static struct source *create(void)
{
    static const struct hid_map_entry map[] = {{.bit = 0, .bits = 1, .usage = HID_USAGE(HID_PAGE_BUTTON, 1)},
                                               {.bit = 8, .bits = 8, .usage = HID_USAGE(HID_PAGE_DESKTOP, 0x36)}};
    static const struct hid_device_def board = {.match = {.name = "Board"}, .map = map, .map_count = 2};
    static const struct hid_lamp_def lamps[] = {
        {.lamp = 0, .match = {.name = "Space"}, .usage = HID_USAGE(HID_PAGE_LED, 0x4b)},
        {.lamp = 1, .match = {.name = "Board"}, .bit = 16, .bits = 8},
    };
    struct device_error error;
    struct source *source = source_hid_create(
        &(struct source_hid_def){
            .devices = &board, .device_count = 1, .lamps = lamps, .lamp_count = 2, .controllers = true},
        &error);
    if (!source) {
        fprintf(stderr, "%s\n", error.text);
        exit(1);
    }
    return source;
}

static void say_event(const struct event *event, struct counts *counts)
{
    char name[HID_USAGE_NAME];
    unsigned age = (unsigned)(source_now_us() - event->time_us);
    counts->latest_us = age > counts->latest_us ? age : counts->latest_us;
    if (event->kind == EVENT_CONTROL && event->control >> 16 == HID_PAGE_BUTTON) {
        counts->presses += event->value == 1;
        counts->releases += event->value == 0;
    }
    if (event->kind == EVENT_CONTROL) {
        printf("device %u %s %s %.3g\n", event->device, hid_usage_name(event->control, name, sizeof name),
               event->relative ? "turns"
               : event->null   ? "points nowhere"
                               : "is",
               (double)event->value);
    } else {
        printf("device %u %s\n", event->device, event->kind == EVENT_ARRIVED ? "arrived" : "left");
    }
}

static void say_devices(const struct source *source)
{
    struct device devices[16];
    int count = source->ops->devices(source, devices, 16);
    for (int i = 0; i < count && i < 16; i++) {
        printf("device %u '%s' %04x:%04x %s class %s %s %s\n", devices[i].id, devices[i].name, devices[i].vendor,
               devices[i].product, devices[i].path, devices[i].class, devices[i].admitted ? "admitted" : "ignored",
               devices[i].trouble);
    }
}

/* False: quit. */
static bool obey(struct source *source, const char *line, const struct counts *counts)
{
    if (strncmp(line, "lamp ", 5) == 0) {
        char *level;
        int lamp = (int)strtol(line + 5, &level, 10);
        puts(source->ops->lamp(source, lamp, strtof(level, NULL)) ? "lamp taken" : "no such lamp");
    } else if (strncmp(line, "devices", 7) == 0) {
        say_devices(source);
    } else if (strncmp(line, "count", 5) == 0) {
        printf("presses %d releases %d latest %u us\n", counts->presses, counts->releases, counts->latest_us);
    }
    return strncmp(line, "quit", 4) != 0;
}

int main(void)
{
    struct source *source = create();
    const struct source_ops *ops = source->ops;
    struct counts counts = {0};
    char line[SOURCE_LOG_LENGTH];
    bool going = true;
    setvbuf(stdin, NULL, _IONBF, 0);
    setvbuf(stdout, NULL, _IOLBF, 0);
    while (going) {
        struct pollfd pollers[] = {{.fd = ops->fd(source), .events = POLLIN}, {.fd = STDIN_FILENO, .events = POLLIN}};
        struct event event;
        poll(pollers, 2, ops->timeout_ms(source));
        usleep(16000);
        ops->dispatch(source);
        while (ops->event(source, &event)) {
            say_event(&event, &counts);
        }
        while (ops->log(source, line, sizeof line)) {
            printf("log: %s\n", line);
        }
        if (pollers[1].revents) {
            going = fgets(line, sizeof line, stdin) && obey(source, line, &counts);
        }
    }
    source_destroy(source);
    return 0;
}
