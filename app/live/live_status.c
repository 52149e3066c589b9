#include "live_status.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "bench.h"

enum { DEVICES = 12 };

struct page {
    char *lines;
    size_t size, length;
};

static void tell(struct page *page, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void tell(struct page *page, const char *format, ...)
{
    va_list arguments;
    if (page->length >= page->size) {
        return;
    }
    va_start(arguments, format);
    int length = vsnprintf(page->lines + page->length, page->size - page->length, format, arguments);
    va_end(arguments);
    page->length += length > 0 ? (size_t)length : 0;
}

static void tell_devices(struct page *page, const struct live_input *input)
{
    struct device devices[DEVICES];
    int count = sources_devices(input->sources, devices, DEVICES);
    for (int i = 0; i < count && i < DEVICES; i++) {
        const struct device *device = &devices[i];
        const char *how = device->trouble[0] ? device->trouble : device->admitted ? "works" : "is not admitted";
        tell(page, "%.40s\t%s\n", device->name, how);
    }
    if (count == 0) {
        tell(page, "devices\tnone\n");
    }
}

void live_status(const struct live_status_def *def, char *lines, size_t size)
{
    struct page page = {lines, size, 0};
    struct studio_report report = studio_report(def->studio);
    struct display_frames frames = display_frames(def->display);
    struct thermal_reading heat = thermal_read(def->care->thermal, (int64_t)(1e6 * bench_wall_s()));
    char delays[200];
    lines[0] = '\0';
    tell(&page, "screen\t%s\n", display_describe(def->display));
    tell(&page, "frames\t%llu, %llu vertical blanks missed\n", (unsigned long long)frames.presented,
         (unsigned long long)frames.missed);
    tell(&page, "ticks\t%.0f a second, %.1f ms each\n", report.ticks_per_second, report.tick_ms);
    tell(&page, "engine\t%s, grid %.0f %%\n", def->engine, 100 * (double)report.scale);
    if (*latency_text(&def->input->latency, delays, sizeof delays)) {
        tell(&page, "delays\t%s\n", delays);
    }
    if (!isnan(heat.celsius)) {
        tell(&page, "temperature\t%.0f °C%s%s\n", (double)heat.celsius, heat.throttled ? ", throttled" : "",
             heat.under_voltage ? ", supply too weak" : "");
    }
    if (def->gallery) {
        tell(&page, "gallery\t%d pictures\n", gallery_count(def->gallery));
    }
    if (report.trouble[0]) {
        tell(&page, "trouble\t%s\n", report.trouble);
    }
    tell_devices(&page, def->input);
}
