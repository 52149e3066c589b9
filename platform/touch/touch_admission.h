/* What devices say of themselves, and what a definition makes of them. Private to the source for touch. */
#ifndef FROND_TOUCH_ADMISSION_H
#define FROND_TOUCH_ADMISSION_H

#include "source_touch.h"

struct touch_traits {
    char name[SOURCE_NAME];
    uint16_t vendor, product;
    bool touch, pointer, keys; /* what libinput takes it for */
    bool touchpad;             /* its surface is no screen, whatever it is taken for */
    bool phantom;              /* a remote control that speaks through the display (HDMI-CEC) */
};

struct touch_admission {
    bool touch, pointer, keys; /* is heard */
};

struct touch_definition {
    struct source_touch_def def;
    struct source_touch_device_def *devices;
    uint32_t *keys;
};

/* NULL: see `error`. */
struct touch_definition *touch_definition_create(const struct source_touch_def *def, struct device_error *error);
void touch_definition_destroy(struct touch_definition *definition); /* takes NULL */

struct touch_admission touch_admit(const struct source_touch_def *def, const struct touch_traits *traits);
bool touch_key_is_bound(const struct source_touch_def *def, uint32_t code);
/* Keyboards with a pointer count as keyboards, screens with keys as screens. */
const char *touch_class(const struct touch_traits *traits); /* DEVICE_TOUCH, ... */

#endif
