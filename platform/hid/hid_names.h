/* The table behind hid_usage.h: numbers and names from the HID Usage Tables 1.5. Private to it. */
#ifndef FROND_HID_NAMES_H
#define FROND_HID_NAMES_H

#include <stdint.h>

struct hid_name {
    uint32_t usage; /* page << 16 | usage */
    const char *name;
};

/* Each by rising usage. */
extern const struct hid_name hid_names_controls[]; /* Generic Desktop, Simulation, Game, LED, Digitizer */
extern const int hid_names_controls_count;
extern const struct hid_name hid_names_keys[]; /* Keyboard, Consumer */
extern const int hid_names_keys_count;

#endif
