#include "touch_device.h"

#include <libinput.h>
#include <libudev.h>
#include <linux/input.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "source_device.h"

static bool is_set(struct udev_device *node, const char *property)
{
    const char *value = udev_device_get_property_value(node, property);
    return value && strcmp(value, "1") == 0;
}

/* A number in hexadecimal that sysfs has of the device behind a node; 0: none. */
static unsigned long attribute(struct udev_device *input, const char *name)
{
    const char *text = input ? udev_device_get_sysattr_value(input, name) : NULL;
    return text ? strtoul(text, NULL, 16) : 0;
}

static void read_udev(struct touch_device *device, struct udev_device *node)
{
    struct udev_device *input = udev_device_get_parent_with_subsystem_devtype(node, "input", NULL);
    unsigned long properties = attribute(input, "properties");
    bool pointer = properties & 1u << INPUT_PROP_POINTER, direct = properties & 1u << INPUT_PROP_DIRECT;
    device->traits.touchpad = is_set(node, "ID_INPUT_TOUCHPAD") || (pointer && !direct);
    device->traits.phantom = attribute(input, "id/bustype") == BUS_CEC;
    device_copy_text(device->path, sizeof device->path, udev_device_get_devnode(node));
    device_copy_text(device->port, sizeof device->port, udev_device_get_property_value(node, "ID_PATH"));
    if (!device->port[0] && input) { /* "usb-0000:00:14.0-2/input0" */
        device_copy_text(device->port, sizeof device->port, udev_device_get_sysattr_value(input, "phys"));
    }
}

void touch_device_read(struct touch_device *device, struct libinput_device *from)
{
    struct touch_traits *traits = &device->traits;
    struct udev_device *node = libinput_device_get_udev_device(from);
    device_copy_text(traits->name, sizeof traits->name, libinput_device_get_name(from));
    traits->vendor = (uint16_t)libinput_device_get_id_vendor(from);
    traits->product = (uint16_t)libinput_device_get_id_product(from);
    traits->touch = libinput_device_has_capability(from, LIBINPUT_DEVICE_CAP_TOUCH);
    traits->pointer = libinput_device_has_capability(from, LIBINPUT_DEVICE_CAP_POINTER);
    traits->keys = libinput_device_has_capability(from, LIBINPUT_DEVICE_CAP_KEYBOARD);
    if (node) {
        read_udev(device, node);
        udev_device_unref(node);
    }
}

bool touch_device_read_node(struct touch_device *device, struct udev *udev, const char *path)
{
    struct stat status;
    struct touch_traits *traits = &device->traits;
    struct udev_device *node = stat(path, &status) == 0 ? udev_device_new_from_devnum(udev, 'c', status.st_rdev) : NULL;
    if (!node) {
        return false;
    }
    struct udev_device *input = udev_device_get_parent_with_subsystem_devtype(node, "input", NULL);
    device_copy_text(traits->name, sizeof traits->name, input ? udev_device_get_sysattr_value(input, "name") : NULL);
    traits->vendor = (uint16_t)attribute(input, "id/vendor");
    traits->product = (uint16_t)attribute(input, "id/product");
    traits->touch = is_set(node, "ID_INPUT_TOUCHSCREEN");
    traits->pointer = is_set(node, "ID_INPUT_MOUSE") || is_set(node, "ID_INPUT_TOUCHPAD");
    traits->keys = is_set(node, "ID_INPUT_KEYBOARD") || is_set(node, "ID_INPUT_KEY");
    read_udev(device, node);
    udev_device_unref(node);
    return true;
}

static int likeness(const struct touch_device *a, const struct touch_device *b)
{
    if (a->traits.vendor != b->traits.vendor || a->traits.product != b->traits.product ||
        strcmp(a->traits.name, b->traits.name) != 0) {
        return 0;
    }
    return strcmp(a->port, b->port) == 0 ? 2 : 1;
}

struct touch_device *touch_devices_add(struct touch_devices *devices, const struct touch_device *device)
{
    struct touch_device *own = NULL, *oldest = NULL;
    int best = 0;
    for (int i = 0; i < devices->count; i++) {
        struct touch_device *known = &devices->list[i];
        if (known->present) {
            continue;
        }
        if (likeness(known, device) > best) {
            best = likeness(known, device);
            own = known;
        }
        if (!oldest || known->id < oldest->id) {
            oldest = known;
        }
    }
    uint32_t id = own ? own->id : devices->last_id + 1;
    if (!own) {
        own = devices->count < SOURCE_TOUCH_DEVICES ? &devices->list[devices->count++] : oldest;
        devices->last_id += own != NULL;
    }
    if (own) {
        *own = *device;
        own->id = id;
        own->present = true;
    }
    return own;
}

struct touch_device *touch_devices_find(struct touch_devices *devices, const char *path)
{
    for (int i = 0; i < devices->count; i++) {
        if (devices->list[i].present && strcmp(devices->list[i].path, path) == 0) {
            return &devices->list[i];
        }
    }
    return NULL;
}

void touch_device_describe(const struct touch_device *device, struct device *described)
{
    *described =
        (struct device){.id = device->id,
                        .class = touch_class(&device->traits),
                        .vendor = device->traits.vendor,
                        .product = device->traits.product,
                        .admitted = device->admission.touch || device->admission.pointer || device->admission.keys};
    device_copy_text(described->name, sizeof described->name, device->traits.name);
    device_copy_text(described->path, sizeof described->path, device->path);
    device_copy_text(described->port, sizeof described->port, device->port);
    device_copy_text(described->trouble, sizeof described->trouble, device->trouble);
}
