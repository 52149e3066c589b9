#include "hid_node.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <wchar.h>

#include <hidapi.h>
#include <libudev.h>

#include "source_device.h"

/* UTF-8, whatever the locale is; what a terminal might obey becomes '?'. */
static void copy_wide(char *to, size_t size, const wchar_t *from)
{
    size_t length = 0;
    for (; from && *from; from++) {
        uint32_t c = (uint32_t)*from;
        char bytes[4];
        size_t count = 0;
        if (c < 0x20 || (c >= 0x7f && c < 0xa0) || c > 0x10ffff) {
            bytes[count++] = '?';
        } else if (c < 0x80) {
            bytes[count++] = (char)c;
        } else if (c < 0x800) {
            bytes[count++] = (char)(0xc0 | c >> 6);
            bytes[count++] = (char)(0x80 | (c & 0x3f));
        } else if (c < 0x10000) {
            bytes[count++] = (char)(0xe0 | c >> 12);
            bytes[count++] = (char)(0x80 | (c >> 6 & 0x3f));
            bytes[count++] = (char)(0x80 | (c & 0x3f));
        } else {
            bytes[count++] = (char)(0xf0 | c >> 18);
            bytes[count++] = (char)(0x80 | (c >> 12 & 0x3f));
            bytes[count++] = (char)(0x80 | (c >> 6 & 0x3f));
            bytes[count++] = (char)(0x80 | (c & 0x3f));
        }
        if (length + count >= size) {
            break;
        }
        memcpy(to + length, bytes, count);
        length += count;
    }
    to[length] = '\0';
}

static void read_descriptor(struct hid_node *node, const char *folder)
{
    char path[1024];
    uint8_t bytes[HID_DESCRIPTOR_BYTES + 1];
    struct hid_error error;
    snprintf(path, sizeof path, "%s/report_descriptor", folder);
    int fd = open(path, O_RDONLY | O_CLOEXEC);
    if (fd < 0) {
        snprintf(node->trouble, sizeof node->trouble, "its report descriptor cannot be read from sysfs");
        return;
    }
    size_t size = 0;
    ssize_t got;
    while (size < sizeof bytes && (got = read(fd, bytes + size, sizeof bytes - size)) > 0) {
        size += (size_t)got;
    }
    close(fd);
    node->descriptor = hid_descriptor_create(bytes, size, &error);
    if (node->descriptor) {
        node->class = hid_class_of(node->descriptor);
    } else {
        snprintf(node->trouble, sizeof node->trouble, "its report descriptor is malformed: %.100s", error.text);
    }
}

/* hidapi 0.13 tells neither the port nor the descriptor; sysfs has both, also for nodes that may not be opened. */
static void ask_udev(struct hid_node *node, struct udev *udev)
{
    const char *slash = strrchr(node->path, '/');
    struct udev_device *device = udev_device_new_from_subsystem_sysname(udev, "hidraw", slash ? slash + 1 : node->path);
    struct udev_device *hid = device ? udev_device_get_parent_with_subsystem_devtype(device, "hid", NULL) : NULL;
    struct udev_device *usb =
        device ? udev_device_get_parent_with_subsystem_devtype(device, "usb", "usb_device") : NULL;
    if (hid) {
        device_copy_text(node->port, sizeof node->port, udev_device_get_property_value(hid, "HID_PHYS"));
        read_descriptor(node, udev_device_get_syspath(hid));
    } else {
        snprintf(node->trouble, sizeof node->trouble, "sysfs says nothing of it");
    }
    if (usb) {
        const char *path = udev_device_get_syspath(usb);
        size_t length = strlen(path);
        device_copy_text(node->parent, sizeof node->parent,
                         length < SOURCE_NAME ? path : path + length - SOURCE_NAME + 1);
    }
    if (device) {
        udev_device_unref(device);
    }
}

static bool is_listed(const struct hid_node *nodes, int count, const char *path)
{
    for (int i = 0; i < count; i++) {
        if (strcmp(nodes[i].path, path) == 0) {
            return true;
        }
    }
    return false;
}

int hid_nodes_list(struct udev *udev, struct hid_node *nodes, int most)
{
    struct hid_device_info *all = hid_enumerate(0, 0);
    int count = 0;
    for (const struct hid_device_info *info = all; info && count < most; info = info->next) {
        /* One that has several collections is listed once for each. */
        if (!info->path || strlen(info->path) >= SOURCE_NAME || is_listed(nodes, count, info->path)) {
            continue;
        }
        struct hid_node *node = &nodes[count++];
        *node = (struct hid_node){.vendor = info->vendor_id, .product = info->product_id};
        device_copy_text(node->path, sizeof node->path, info->path);
        copy_wide(node->name, sizeof node->name, info->product_string);
        copy_wide(node->serial, sizeof node->serial, info->serial_number);
        if (!node->name[0]) {
            snprintf(node->name, sizeof node->name, "%04x:%04x", node->vendor, node->product);
        }
        ask_udev(node, udev);
    }
    hid_free_enumeration(all);
    return count;
}

void hid_node_finish(struct hid_node *node)
{
    hid_descriptor_destroy(node->descriptor);
    node->descriptor = NULL;
}

static bool same_model(const struct hid_node *a, const struct hid_node *b)
{
    return a->vendor == b->vendor && a->product == b->product && strcmp(a->name, b->name) == 0;
}

bool hid_node_is(const struct hid_node *a, const struct hid_node *b)
{
    return same_model(a, b) && strcmp(a->path, b->path) == 0 && strcmp(a->serial, b->serial) == 0 &&
           strcmp(a->port, b->port) == 0;
}

/* The last part of a port, "input1", is the interface: those of one device share its serial. */
static const char *interface_of(const struct hid_node *node)
{
    const char *slash = strrchr(node->port, '/');
    return slash ? slash : "";
}

int hid_node_likeness(const struct hid_node *a, const struct hid_node *b)
{
    if (!same_model(a, b) || strcmp(interface_of(a), interface_of(b)) != 0) {
        return 0;
    }
    bool port = strcmp(a->port, b->port) == 0, serial = strcmp(a->serial, b->serial) == 0;
    if (a->serial[0] || b->serial[0]) {
        return serial ? (port ? 3 : 2) : 0;
    }
    return port ? 1 : 0;
}

uint64_t hid_nodes_signature(void)
{
    uint64_t signature = 0;
    DIR *folder = opendir("/sys/class/hidraw");
    if (!folder) {
        return 0;
    }
    for (const struct dirent *entry; (entry = readdir(folder));) {
        uint64_t hash = UINT64_C(0xcbf29ce484222325) ^ (uint64_t)entry->d_ino; /* FNV-1a */
        for (const char *c = entry->d_name; *c; c++) {
            hash = (hash ^ (unsigned char)*c) * UINT64_C(0x100000001b3);
        }
        signature += hash;
    }
    closedir(folder);
    return signature;
}
