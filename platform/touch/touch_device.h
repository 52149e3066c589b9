/* A device that the source for touch knows: what it is, and what of it is heard. Private to source_touch.c. */
#ifndef FROND_TOUCH_DEVICE_H
#define FROND_TOUCH_DEVICE_H

#include <stddef.h>

#include "touch_admission.h"

struct libinput_device;
struct udev;
struct udev_device;

struct touch_device {
    uint32_t id;
    bool present;
    bool open; /* libinput has it; else it is there and cannot be opened */
    struct touch_traits traits;
    struct touch_admission admission;
    bool arrived; /* that it is there has been said, and that it leaves must be */
    char path[SOURCE_NAME], port[SOURCE_NAME];
    char trouble[160];
};

struct touch_devices {
    struct touch_device list[SOURCE_TOUCH_DEVICES];
    int count;
    uint32_t last_id;
};

/* What it is, in `traits`, `path` and `port`; the rest is left alone. */
void touch_device_read(struct touch_device *device, struct libinput_device *from);
/* The same of a node that cannot be opened, from what udev says; false: udev does not know it. */
bool touch_device_read_node(struct touch_device *device, struct udev *udev, const char *path);

/* The place for a device that has come, with all that `device` says: its own of before, if it has been here. NULL: too
 * many are. */
struct touch_device *touch_devices_add(struct touch_devices *devices, const struct touch_device *device);
struct touch_device *touch_devices_find(struct touch_devices *devices, const char *path);
void touch_device_describe(const struct touch_device *device, struct device *described);

#endif
