/* How hot the board is, and whether it holds back: by the kernel's thermal zones and cooling devices, and what the
 * firmware of a Raspberry Pi tells besides. Where a machine tells none of it (most virtual machines), reading costs
 * nothing and knows nothing.
 *
 * - /sys/class/thermal/thermal_zone*: temperatures; the zones of processors, GPU and chip, not of radios or batteries
 * - /sys/class/thermal/cooling_device*: a processor or GPU whose frequency the kernel holds down
 * - /sys/class/hwmon/hwmon*: rpi_volt, the supply is too weak
 * - /sys/devices/platform/soc/soc:firmware/get_throttled: all three, by the kernels of Raspberry Pi OS */
#ifndef FROND_THERMAL_H
#define FROND_THERMAL_H

#include <stdbool.h>
#include <stdint.h>

enum {
    THERMAL_INTERVAL_US = 1000000, /* files are read no more often */
};

struct thermal_reading {
    float celsius;      /* of the hottest zone; NAN: not known */
    char zone[32];      /* its type, "cpu-thermal"; "" */
    bool throttled;     /* it runs slower than it could, because of heat */
    bool under_voltage; /* the supply is too weak now */
};

struct thermal;

/* Looks for what there is. `root` NULL: "/"; else the folder of a made-up tree. NULL when memory is short. */
struct thermal *thermal_create(const char *root);
void thermal_destroy(struct thermal *thermal); /* takes NULL */
/* One line for the log: "temperature by cpu-thermal and gpu-thermal; throttling by the firmware". */
const char *thermal_describe(const struct thermal *thermal);
/* What is known at this time, of any clock that does not jump: read now, or less than a second old. */
struct thermal_reading thermal_read(struct thermal *thermal, int64_t now_us);

#endif
