/* A device that the HID source knows: what it is, and while it is open its decoder, its lamps and its link. Private to
 * source_hid.c. */
#ifndef FROND_HID_KNOWN_H
#define FROND_HID_KNOWN_H

#include "hid_link.h"
#include "hid_node.h"
#include "source_hid.h"

struct hid_known {
    uint32_t id;
    bool present, admitted, arrived; /* plugged in; allowed to act; that it is there has been said */
    struct hid_node node;
    const struct hid_device_def *def; /* NULL: admitted by its class, or not */
    struct hid_decoder *decoder;
    struct hid_outputs *outputs; /* NULL: no lamps */
    struct hid_link *link;       /* NULL: not open */
    uint64_t lost;               /* as last looked at */
    bool refuses;
    char trouble[160];
};

struct hid_opening {
    bool vendor, lamps; /* vendor-defined fields are heard; lamps are wanted */
    int wake_fd;
};

/* False: see `text`, which says what to do. */
bool hid_known_open(struct hid_known *known, const struct hid_opening *opening, char *text, size_t size);
/* Frees what is open, and returns at once. The link, which may take longer, is the caller's to destroy; NULL: none. */
struct hid_link *hid_known_close(struct hid_known *known);
bool hid_known_light(struct hid_known *known, const struct hid_lamp_def *lamp, float level);
void hid_known_describe(const struct hid_known *known, struct device *device);

#endif
