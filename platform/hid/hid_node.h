/* What HID devices are plugged in: hidapi's list, with what udev and sysfs know besides. Private to source_hid.c. */
#ifndef FROND_HID_NODE_H
#define FROND_HID_NODE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hid_class.h"
#include "hid_descriptor.h"
#include "source.h"

struct udev;

struct hid_node {
    char path[SOURCE_NAME]; /* "/dev/hidraw0" */
    char name[SOURCE_NAME];
    char serial[64];          /* "" where it has none; cheap ones share theirs */
    char port[SOURCE_NAME];   /* where it is plugged in, down to the interface; "" where nothing tells */
    char parent[SOURCE_NAME]; /* the end of the sysfs path of the USB device that it is a part of; "" for others */
    uint16_t vendor, product;
    struct hid_descriptor *descriptor; /* owned; NULL: see trouble */
    enum hid_class class;
    char trouble[160];
};

/* Fills up to `most` nodes and returns how many there are. Opens no device. */
int hid_nodes_list(struct udev *udev, struct hid_node *nodes, int most);
void hid_node_finish(struct hid_node *node);
bool hid_node_is(const struct hid_node *a, const struct hid_node *b); /* the same device on the same node */
/* How sure it is that they are one device that came back: 0 not; 3 serial and port, 2 serial, 1 port or all it has. */
int hid_node_likeness(const struct hid_node *a, const struct hid_node *b);
/* Changes whenever a node comes or goes; costs a look into one folder. */
uint64_t hid_nodes_signature(void);

#endif
