/* The text file for Prometheus: https://prometheus.io/docs/instrumenting/exposition_formats */
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "status.h"

struct page {
    char *text;
    size_t size, length; /* length >= size: it did not fit */
};

static void put(struct page *page, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void put(struct page *page, const char *format, ...)
{
    va_list arguments;
    if (page->length >= page->size) {
        return;
    }
    va_start(arguments, format);
    int length = vsnprintf(page->text + page->length, page->size - page->length, format, arguments);
    va_end(arguments);
    page->length += length > 0 ? (size_t)length : 0;
}

static void head(struct page *page, const char *name, const char *type, const char *help)
{
    put(page, "# HELP frond_%s %s\n# TYPE frond_%s %s\n", name, help, name, type);
}

static void gauge(struct page *page, const char *name, double value, const char *help)
{
    if (isfinite(value)) { /* what is not known has no sample */
        head(page, name, "gauge", help);
        put(page, "frond_%s %.10g\n", name, value);
    }
}

static void counter(struct page *page, const char *name, uint64_t value, const char *help)
{
    head(page, name, "counter", help);
    put(page, "frond_%s %" PRIu64 "\n", name, value);
}

/* `text` as a label's value: backslash, quote and line feed escaped. Names have no line feeds (status_word). */
static void label(struct page *page, const char *name, const char *text)
{
    put(page, "%s=\"", name);
    for (; *text; text++) {
        put(page, *text == '\\' || *text == '"' ? "\\%c" : "%c", *text);
    }
    put(page, "\"");
}

/* One sample for each state, 1 for the one that is: so that graphs can be drawn of it. */
static void put_display(struct page *page, const struct status *status)
{
    static const char *const STATES[] = {"shown", "dark", "absent", "lent"};
    head(page, "display", "gauge", "What has become of the screen, 1 for the state that it is in.");
    for (size_t i = 0; i < sizeof STATES / sizeof STATES[0]; i++) {
        put(page, "frond_display{state=\"%s\"} %d\n", STATES[i], strcmp(STATES[i], status->display) == 0);
    }
}

static void put_info(struct page *page, const struct status *status)
{
    head(page, "info", "gauge", "What runs, in its labels.");
    put(page, "frond_info{");
    label(page, "version", FROND_VERSION);
    put(page, ",");
    label(page, "engine", status->engine);
    put(page, ",");
    label(page, "state", status->state);
    put(page, ",");
    label(page, "scene", status->scene);
    put(page, "} 1\n");
}

static void put_frames(struct page *page, const struct status *status)
{
    const struct status_frames *frames = &status->frames;
    uint64_t below = 0;
    head(page, "frame_seconds", "histogram", "From one frame to the next, while the painting moves.");
    for (int i = 0; i < STATUS_BUCKETS; i++) {
        below += frames->buckets[i];
        put(page, "frond_frame_seconds_bucket{le=\"%g\"} %" PRIu64 "\n", status_bucket_s[i], below);
    }
    put(page, "frond_frame_seconds_bucket{le=\"+Inf\"} %" PRIu64 "\n", frames->count);
    put(page, "frond_frame_seconds_sum %.10g\n", frames->sum_s);
    put(page, "frond_frame_seconds_count %" PRIu64 "\n", frames->count);
}

static void put_devices(struct page *page, const struct status *status)
{
    if (status->device_count == 0) {
        return;
    }
    head(page, "device_works", "gauge", "Of each device that is plugged in, whether it acts.");
    for (int i = 0; i < status->device_count; i++) {
        const struct status_device *device = &status->devices[i];
        put(page, "frond_device_works{device=\"%d\",", i); /* two may have the same name */
        label(page, "class", device->class);
        put(page, ",");
        label(page, "name", device->name);
        put(page, "} %d\n", device->works);
    }
}

size_t status_metrics(const struct status *status, char *text, size_t size)
{
    struct page page = {text, size, 0};
    text[0] = '\0';
    put_info(&page, status);
    gauge(&page, "uptime_seconds", floor(status->uptime_s), "Since Frond was started.");
    counter(&page, "visits_total", status->visits, "Visits that have begun.");
    counter(&page, "drops_total", status->drops, "Drops that visitors let fall.");
    counter(&page, "actions_refused_total", status->actions_refused, "Actions that the painting had no room for.");
    put_display(&page, status);
    counter(&page, "frames_total", status->frames_presented, "Frames that have reached the screen.");
    counter(&page, "vertical_blanks_missed_total", status->blanks_missed,
            "Vertical blanks at which the last picture was shown again.");
    put_frames(&page, status);
    gauge(&page, "tick", (double)status->ticks, "Of the painting now.");
    gauge(&page, "ticks_per_second", status->ticks_per_second, "Reached in the last second.");
    gauge(&page, "tick_seconds", status->tick_s, "What a tick takes.");
    gauge(&page, "grid_ratio", status->grid, "Share of the cells a side that was wished for.");
    counter(&page, "gpu_resets_total", status->gpu_resets, "How often the GPU was lost.");
    gauge(&page, "temperature_celsius", status->celsius, "Of the hottest zone of the board.");
    gauge(&page, "throttled", status->throttled, "1: the board runs slower because of heat.");
    gauge(&page, "under_voltage", status->under_voltage, "1: the supply is too weak.");
    gauge(&page, "gallery_pictures", status->gallery >= 0 ? status->gallery : (double)NAN, "Pictures kept.");
    counter(&page, "exhibit_errors_total", status->exhibit_errors, "Changed exhibits that could not be taken up.");
    gauge(&page, "exhibit_wrong", status->exhibit_wrong, "1: the exhibit's file cannot be used as it is now.");
    put_devices(&page, status);
    return page.length < page.size ? page.length : 0;
}
