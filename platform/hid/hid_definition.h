/* A definition of the HID source that stays as it is, whatever becomes of the one that was given. Private to the
 * source. */
#ifndef FROND_HID_DEFINITION_H
#define FROND_HID_DEFINITION_H

#include "hid_node.h"
#include "source_hid.h"

struct hid_definition;

/* NULL: it is wrong, or memory is short. */
struct hid_definition *hid_definition_create(const struct source_hid_def *def, struct device_error *error);
void hid_definition_destroy(struct hid_definition *definition); /* takes NULL */
const struct source_hid_def *hid_definition_get(const struct hid_definition *definition);

bool hid_matches(const struct device_match *match, const struct hid_node *node);
/* The entry that counts for a device; NULL: none does. */
const struct hid_device_def *hid_definition_find(const struct hid_definition *definition, const struct hid_node *node);

#endif
