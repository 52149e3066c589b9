/* HID devices made of umockdev: the real hidapi and udev find them, open them, read them and write to them. */
#ifndef FROND_HID_MOCK_H
#define FROND_HID_MOCK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { HID_MOCK_NODES = 32 };

struct hid_mock_def {
    const char *name, *serial; /* serial: NULL for none */
    uint16_t vendor, product;
    const char *usb; /* the USB device that it is a part of, "1-1" */
    int interface;
    const uint8_t *descriptor;
    size_t size;
};

struct hid_mock;

struct hid_mock *hid_mock_create(void); /* NULL: the program does not run under umockdev-wrapper */
void hid_mock_destroy(struct hid_mock *mock);

int hid_mock_plug(struct hid_mock *mock, const struct hid_mock_def *def);    /* returns N of /dev/hidrawN */
void hid_mock_announce(struct hid_mock *mock, int node, const char *action); /* "add": udev has seen to it */
void hid_mock_unplug(struct hid_mock *mock, int node);
void hid_mock_report(struct hid_mock *mock, int node, const uint8_t *bytes, size_t size);
void hid_mock_break(struct hid_mock *mock, int node, bool broken);  /* reading fails */
void hid_mock_stall(struct hid_mock *mock, int node, bool stalled); /* writing does not come back */
void hid_mock_forbid(struct hid_mock *mock, int node, bool forbidden);
void hid_mock_open_to_all(struct hid_mock *mock); /* its folders, for a user who does not own them */
/* What was last written to a node, and how often anything was. */
size_t hid_mock_written(struct hid_mock *mock, int node, uint8_t *bytes, size_t most, int *count);

#endif
