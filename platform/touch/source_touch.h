/* Touchscreens, mice and keyboards as a source of input, by libinput over udev.
 *
 * A finger is EVENT_DOWN, _MOVE, _UP; what turns out to be a palm, EVENT_CANCEL. Slots are unique over all devices, the
 * lowest free one first. A mouse is one finger while any of its buttons is down; it has no cursor, begins in the middle
 * of the display and is where it went since. Keys are EVENT_CONTROL of SOURCE_KEY. Times are the kernel's. What a
 * device holds down when it leaves comes up or is cancelled first. Calibration is libinput's: the udev property
 * LIBINPUT_CALIBRATION_MATRIX.
 *
 * Holding the seat (`hold`): every device with keys that libinput opens, admitted or not, keyboards, power buttons and
 * remote controls, is grabbed (EVIOCGRAB) before a key of it is read. The kernel then gives its keys to Frond alone:
 * not to the console (no VT switch, no Ctrl-Alt-Del, no echo), not to SysRq, not to a logind that waits for power keys.
 * The grab ends when the source is destroyed, or the process dies. In the tenths of a second between plugging in and
 * the grab, and for a keyboard that cannot be opened, `console` stands in: that VT takes no keys at all (K_OFF). It
 * cannot stop: SysRq before the grab (kernel.sysrq=0 does), a logind's power key before the grab (HandlePowerKey=
 * ignore does), what acpid hears from ACPI itself, a power button held down for seconds, which is hardware's, programs
 * that change the VT, a keyboard that another program has grabbed, devices of other seats and those that udev hides
 * from libinput (LIBINPUT_IGNORE_DEVICE, no ID_INPUT). A process that is killed leaves the console without keys:
 * TTYReset=yes in its unit mends that, or kbd_mode -u, or the next Frond when it ends. */
#ifndef FROND_SOURCE_TOUCH_H
#define FROND_SOURCE_TOUCH_H

#include "source.h"

enum {
    SOURCE_TOUCH_DEVICES = 64, /* known at a time, those that may come back among them */
    SOURCE_TOUCH_KEYS = 64,    /* of a definition */
};

/* The first that matches a device counts, and says what of it is heard. Nothing: it is refused. */
struct source_touch_device_def {
    struct device_match match;
    bool touch, pointer, keys;
};

struct source_touch_def { /* all of it is copied */
    const char *seat;     /* NULL: "seat0" */
    int rotation;         /* 0, 90, 180 or 270 degrees clockwise, that of the display (struct display_def) */
    int width, height;    /* of the display as it is looked at, in pixels, by which mice move; 0: 1000 */
    const struct source_touch_device_def *devices;
    int device_count;
    bool touchscreens; /* every touchscreen is admitted. Touchpads never are, whatever they are taken for */
    bool pointers;     /* every pointer that has no keys and is no phantom (HDMI-CEC) is admitted */
    /* Codes of linux/input-event-codes.h that staff are bound to: other keys are thrown away. Keys are heard of those
     * keyboards only that an entry of `devices` admits. */
    const uint32_t *keys;
    int key_count;
    bool hold;           /* the seat, as above; not in a window on a desktop, not for a look at what is plugged in */
    const char *console; /* with `hold`: "/dev/tty1"; NULL: no VT is touched. It must be the process's own
                            (TTYPath=), or the process needs CAP_SYS_TTY_CONFIG; then "/dev/tty0" is that in front */
};

/* NULL: the definition is wrong, udev or libinput cannot be reached, or memory is short. No device, or no permission
 * for any, is no error. */
struct source *source_touch_create(const struct source_touch_def *def, struct device_error *error);

#endif
