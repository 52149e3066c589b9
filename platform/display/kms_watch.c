#include "kms_watch.h"

#include <stdlib.h>

#include <libudev.h>

struct kms_watch {
    struct udev *udev;
    struct udev_monitor *monitor;
};

/* The kernel's own events: those that udevd sends on come later, and not at all where there is no udevd. */
static const char SOURCE[] = "kernel";

struct kms_watch *kms_watch_create(void)
{
    struct kms_watch *watch = calloc(1, sizeof *watch);
    if (!watch) {
        return NULL;
    }
    watch->udev = udev_new();
    watch->monitor = watch->udev ? udev_monitor_new_from_netlink(watch->udev, SOURCE) : NULL;
    if (!watch->monitor || udev_monitor_filter_add_match_subsystem_devtype(watch->monitor, "drm", "drm_minor") < 0 ||
        udev_monitor_enable_receiving(watch->monitor) < 0) {
        kms_watch_destroy(watch);
        return NULL;
    }
    return watch;
}

void kms_watch_destroy(struct kms_watch *watch)
{
    if (watch) {
        if (watch->monitor) {
            udev_monitor_unref(watch->monitor);
        }
        if (watch->udev) {
            udev_unref(watch->udev);
        }
        free(watch);
    }
}

int kms_watch_fd(const struct kms_watch *watch)
{
    return watch ? udev_monitor_get_fd(watch->monitor) : -1;
}

bool kms_watch_read(struct kms_watch *watch)
{
    bool news = false;
    struct udev_device *device = watch ? udev_monitor_receive_device(watch->monitor) : NULL;
    while (device) {
        news = true;
        udev_device_unref(device);
        device = udev_monitor_receive_device(watch->monitor);
    }
    return news;
}
