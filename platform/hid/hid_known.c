#include "hid_known.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "source_device.h"

static size_t longest_report(const struct hid_descriptor *descriptor)
{
    size_t longest = 0;
    for (int i = 0; i < descriptor->report_count; i++) {
        size_t bytes = (descriptor->reports[i].bits + 7) / 8 + 1;
        longest = descriptor->reports[i].kind == HID_INPUT && bytes > longest ? bytes : longest;
    }
    return longest;
}

static void describe_failure(const struct hid_node *node, int code, char *text, size_t size)
{
    char rule[120];
    snprintf(rule, sizeof rule, "SUBSYSTEM==\"hidraw\", KERNELS==\"*:%04X:%04X.*\", GROUP=\"input\", MODE=\"0660\"",
             node->vendor, node->product);
    device_explain(text, size, node->path, code, rule);
}

bool hid_known_open(struct hid_known *known, const struct hid_opening *opening, char *text, size_t size)
{
    const struct hid_descriptor *descriptor = known->node.descriptor;
    const struct hid_decoder_def decoder = {.descriptor = descriptor,
                                            .map = known->def ? known->def->map : NULL,
                                            .map_count = known->def ? known->def->map_count : 0,
                                            .everything = known->def != NULL,
                                            .vendor = opening->vendor};
    known->decoder = hid_decoder_create(&decoder);
    known->outputs = opening->lamps ? hid_outputs_create(descriptor) : NULL;
    const struct hid_link_def link = {.path = known->node.path,
                                      .report = longest_report(descriptor),
                                      .numbered = descriptor->numbered,
                                      .lamps = known->outputs != NULL,
                                      .wake_fd = opening->wake_fd};
    known->link = known->decoder ? hid_link_open(&link) : NULL;
    known->lost = 0;
    known->refuses = false;
    if (!known->link) {
        describe_failure(&known->node, known->decoder ? errno : ENOMEM, text, size);
        hid_known_close(known);
    }
    return known->link != NULL;
}

struct hid_link *hid_known_close(struct hid_known *known)
{
    struct hid_link *link = known->link;
    if (link) {
        hid_link_stop(link);
    }
    hid_decoder_destroy(known->decoder);
    hid_outputs_destroy(known->outputs);
    known->link = NULL;
    known->decoder = NULL;
    known->outputs = NULL;
    return link;
}

bool hid_known_light(struct hid_known *known, const struct hid_lamp_def *lamp, float level)
{
    uint8_t bytes[HID_LINK_WRITE];
    size_t size;
    bool set = lamp->usage
                   ? hid_outputs_set(known->outputs, lamp->usage, lamp->index, level)
                   : hid_outputs_set_bits(known->outputs, lamp->report, lamp->bit, lamp->bits, lamp->most, level);
    while ((size = hid_outputs_take(known->outputs, bytes, sizeof bytes)) > 0) {
        hid_link_write(known->link, bytes, size);
    }
    return set;
}

void hid_known_describe(const struct hid_known *known, struct device *device)
{
    static const char *const classes[] = {
        [HID_CLASS_OTHER] = DEVICE_CONTROLLER,  [HID_CLASS_CONTROLLER] = DEVICE_CONTROLLER,
        [HID_CLASS_POINTER] = DEVICE_POINTER,   [HID_CLASS_TOUCH] = DEVICE_TOUCH,
        [HID_CLASS_KEYBOARD] = DEVICE_KEYBOARD,
    };
    const struct hid_node *node = &known->node;
    *device = (struct device){.id = known->id,
                              .class = classes[node->class],
                              .vendor = node->vendor,
                              .product = node->product,
                              .admitted = known->admitted};
    memcpy(device->name, node->name, sizeof device->name);
    memcpy(device->path, node->path, sizeof device->path);
    memcpy(device->port, node->port, sizeof device->port);
    memcpy(device->trouble, known->trouble, sizeof device->trouble);
}
