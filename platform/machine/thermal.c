#include "thermal.h"

#include <dirent.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SOURCES_MOST = 32, PATH_MOST = 512 };

/* Bits of get_throttled that speak of now: github.com/raspberrypi/documentation, "get_throttled". The cap of the
 * frequency (bit 1) also comes of under-voltage, and is told as such. */
enum { FIRMWARE_UNDER_VOLTAGE = 1 << 0, FIRMWARE_THROTTLED = 1 << 2, FIRMWARE_SOFT_LIMIT = 1 << 3 };

enum kind { ZONE, COOLING, SUPPLY, FIRMWARE, KINDS };

struct source {
    enum kind kind;
    char path[PATH_MOST]; /* of the file that is read */
    char name[32];        /* what it calls itself */
};

struct thermal {
    struct source sources[SOURCES_MOST];
    int count;
    int64_t read_us; /* -1: not yet */
    struct thermal_reading reading;
    char description[300];
};

/* The file without the space at its end; false when it cannot be read: a sensor that sleeps says EAGAIN, one that was
 * unplugged is gone. */
static bool read_text(const char *path, char *text, size_t size)
{
    int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    ssize_t count = file < 0 ? -1 : read(file, text, size - 1);
    if (file >= 0) {
        close(file);
    }
    if (count <= 0) {
        return false;
    }
    text[count] = '\0';
    text[strcspn(text, "\r\n")] = '\0';
    return true;
}

static bool read_number(const char *path, int base, long *value)
{
    char text[32], *end = text;
    if (!read_text(path, text, sizeof text)) {
        return false;
    }
    *value = strtol(text, &end, base);
    return end != text && *end == '\0';
}

static bool contains_any(const char *name, const char *const *parts)
{
    for (; *parts; parts++) {
        if (strstr(name, *parts)) {
            return true;
        }
    }
    return false;
}

/* cpu-thermal (Raspberry Pi), bigcore0-thermal, gpu-thermal, package-thermal (RK3588), x86_pkg_temp. */
static bool is_chip(const char *type)
{
    static const char *const parts[] = {"cpu", "gpu", "soc", "core", "package", "pkg", "center", NULL};
    return contains_any(type, parts);
}

/* cpufreq-cpu0, thermal-cpufreq-0, thermal-devfreq-0 (a GPU); not fans, and not the "Processor" of ACPI. */
static bool holds_back(const char *type)
{
    static const char *const parts[] = {"cpufreq", "devfreq", NULL};
    return contains_any(type, parts);
}

static bool is_supply(const char *name)
{
    return strcmp(name, "rpi_volt") == 0;
}

/* Where to look: folder, the beginning of its entries, the file that names one, whom to take, the file that is read. */
static const struct place {
    enum kind kind;
    const char *folder, *entry, *naming;
    bool (*takes)(const char *name);
    const char *file;
} PLACES[] = {
    {ZONE, "sys/class/thermal", "thermal_zone", "type", is_chip, "temp"},
    {COOLING, "sys/class/thermal", "cooling_device", "type", holds_back, "cur_state"},
    {SUPPLY, "sys/class/hwmon", "hwmon", "name", is_supply, "in0_lcrit_alarm"},
};

static void add_source(struct thermal *thermal, enum kind kind, const char *path, const char *name)
{
    size_t length = strlen(path);
    if (thermal->count < SOURCES_MOST && length < PATH_MOST && access(path, R_OK) == 0) {
        struct source *source = &thermal->sources[thermal->count++];
        source->kind = kind;
        memcpy(source->path, path, length + 1);
        snprintf(source->name, sizeof source->name, "%.31s", name);
    }
}

static void search_place(struct thermal *thermal, const char *root, const struct place *place)
{
    char folder[PATH_MOST], path[PATH_MOST + 300], name[64];
    snprintf(folder, sizeof folder, "%s/%s", root, place->folder);
    DIR *directory = opendir(folder);
    for (struct dirent *entry; directory && (entry = readdir(directory));) {
        if (strncmp(entry->d_name, place->entry, strlen(place->entry)) != 0) {
            continue;
        }
        snprintf(path, sizeof path, "%s/%s/%s", folder, entry->d_name, place->naming);
        if (!read_text(path, name, sizeof name) || !place->takes(name)) {
            continue;
        }
        snprintf(path, sizeof path, "%s/%s/%s", folder, entry->d_name, place->file);
        add_source(thermal, place->kind, path, name);
    }
    if (directory) {
        closedir(directory);
    }
}

/* "temperature by cpu-thermal and gpu-thermal": the names of one kind, each once, after what they are for. */
static void describe_kind(struct thermal *thermal, enum kind kind, const char *what)
{
    size_t size = sizeof thermal->description, length = strlen(thermal->description);
    int told = 0;
    for (int i = 0; i < thermal->count; i++) {
        const struct source *source = &thermal->sources[i];
        bool before = false;
        for (int j = 0; j < i; j++) {
            before =
                before || (thermal->sources[j].kind == kind && strcmp(thermal->sources[j].name, source->name) == 0);
        }
        if (source->kind != kind || before || length >= size) {
            continue;
        }
        const char *between = told++ > 0 ? " and " : length > 0 ? "; " : "";
        length += (size_t)snprintf(thermal->description + length, size - length, "%s%s%s%s", between,
                                   told == 1 ? what : "", told == 1 ? " by " : "", source->name);
    }
}

static void describe(struct thermal *thermal)
{
    describe_kind(thermal, ZONE, "temperature");
    describe_kind(thermal, COOLING, "throttling");
    describe_kind(thermal, SUPPLY, "under-voltage");
    describe_kind(thermal, FIRMWARE, "throttling and under-voltage");
    if (thermal->count == 0) {
        snprintf(thermal->description, sizeof thermal->description,
                 "this machine tells neither its temperature nor whether it throttles");
    }
}

struct thermal *thermal_create(const char *root)
{
    struct thermal *thermal = calloc(1, sizeof *thermal);
    char path[PATH_MOST];
    if (!thermal) {
        return NULL;
    }
    root = root ? root : "";
    for (size_t i = 0; i < sizeof PLACES / sizeof PLACES[0]; i++) {
        search_place(thermal, root, &PLACES[i]);
    }
    snprintf(path, sizeof path, "%s/sys/devices/platform/soc/soc:firmware/get_throttled", root);
    add_source(thermal, FIRMWARE, path, "the firmware");
    describe(thermal);
    thermal->read_us = -1;
    thermal->reading.celsius = NAN;
    return thermal;
}

void thermal_destroy(struct thermal *thermal)
{
    free(thermal);
}

const char *thermal_describe(const struct thermal *thermal)
{
    return thermal->description;
}

static void read_source(const struct source *source, struct thermal_reading *reading)
{
    long value = 0;
    if (!read_number(source->path, source->kind == FIRMWARE ? 16 : 10, &value)) {
        return;
    }
    float celsius = (float)value / 1000;
    switch (source->kind) {
    case ZONE: /* a sensor that is switched off tells 0 or nonsense */
        if (celsius > 0 && celsius < 200 && !(celsius <= reading->celsius)) {
            reading->celsius = celsius;
            snprintf(reading->zone, sizeof reading->zone, "%s", source->name);
        }
        break;
    case COOLING:
        reading->throttled = reading->throttled || value > 0;
        break;
    case SUPPLY:
        reading->under_voltage = reading->under_voltage || value > 0;
        break;
    case FIRMWARE:
        reading->throttled = reading->throttled || (value & (FIRMWARE_THROTTLED | FIRMWARE_SOFT_LIMIT)) != 0;
        reading->under_voltage = reading->under_voltage || (value & FIRMWARE_UNDER_VOLTAGE) != 0;
        break;
    case KINDS:
        break;
    }
}

struct thermal_reading thermal_read(struct thermal *thermal, int64_t now_us)
{
    if (thermal->count == 0 || (thermal->read_us >= 0 && now_us - thermal->read_us < THERMAL_INTERVAL_US)) {
        return thermal->reading;
    }
    thermal->read_us = now_us;
    thermal->reading = (struct thermal_reading){.celsius = NAN};
    for (int i = 0; i < thermal->count; i++) {
        read_source(&thermal->sources[i], &thermal->reading);
    }
    return thermal->reading;
}
