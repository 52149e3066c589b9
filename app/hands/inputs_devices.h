/* Lists of devices in an inputs file, which bindings name by an id: keyboards, controllers. Private to class_*.c. */
#ifndef FROND_INPUTS_DEVICES_H
#define FROND_INPUTS_DEVICES_H

#include "file_rows.h"
#include "inputs_read.h"

/* Over struct inputs_device. */
#define INPUTS_DEVICE_ROWS                                                                                             \
    TEXT("id", struct inputs_device, id, "a word", INPUTS_ID_BYTES, true, "What bindings call it."),                   \
        TEXT("vendor", struct inputs_device, name, "one to four digits of base 16", 6, false,                          \
             "USB vendor id, as lsusb and `frond devices` print it: 077d. Any if left out."),                          \
        TEXT("product", struct inputs_device, name, "one to four digits of base 16", 6, false,                         \
             "USB product id. Any if left out."),                                                                      \
        TEXT("name", struct inputs_device, name, "a part of the name", INPUTS_NAME_BYTES, false,                       \
             "A part of the name that the device gives itself. Any if left out.")

struct inputs_devices {
    const char *list;       /* its key */
    const struct key *keys; /* INPUTS_DEVICE_ROWS, and more where there is more to say */
    struct inputs_device *devices;
    int *count, most;
    /* What stands in sections of a device, the last of `devices` as yet; NULL: none has any. */
    void (*sections)(struct reader *reader, const struct yaml_node *item, struct inputs *inputs);
};

/* Reads the list from the top of an inputs file; problems go to the report. */
void inputs_read_devices(struct reader *reader, const struct yaml_node *root, const struct inputs_devices *def,
                         struct inputs *inputs);
/* Digits of base 16, at most `most` of them, with or without 0x. */
bool inputs_base16(const char *text, size_t most, uint32_t *number);

#endif
