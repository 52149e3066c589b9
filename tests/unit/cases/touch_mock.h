/* Devices of the kernel's input layer that are not there, for libinput and udev to find (umockdev). */
#ifndef FROND_TOUCH_MOCK_H
#define FROND_TOUCH_MOCK_H

#include <stdbool.h>

/* A decoy is a touchpad that udev takes for a screen. */
enum touch_mock_kind { MOCK_SCREEN, MOCK_PAD, MOCK_MOUSE, MOCK_KEYBOARD, MOCK_DECOY };

enum { TOUCH_MOCK_NODES = 8, TOUCH_MOCK_SIZE = 1000 }; /* screens are of that many units each way */

struct touch_mock;

/* To be called before anything else: gives the process a /run of its own, for udev's records, which umockdev does not
 * stand in for. False: that is not permitted. */
bool touch_mock_isolate(void);

struct touch_mock *touch_mock_create(void); /* NULL: this program does not run under umockdev-wrapper */
void touch_mock_destroy(struct touch_mock *mock);

/* `matrix`: LIBINPUT_CALIBRATION_MATRIX; NULL: none. `bus`: BUS_... Returns the number of its node, /dev/input/eventN.
 */
int touch_mock_plug(struct touch_mock *mock, enum touch_mock_kind kind, const char *name, const char *matrix, int bus);
void touch_mock_announce(struct touch_mock *mock, int number); /* to those who are listening already */
void touch_mock_unplug(struct touch_mock *mock, int number);
void touch_mock_forbid(struct touch_mock *mock, int number, unsigned mode); /* who may open it */
void touch_mock_open_to_all(struct touch_mock *mock);                       /* the mock itself, to any user */

/* A report: those values, and then a SYN_REPORT, all of that time. */
struct touch_mock_value {
    int type, code, value;
};
void touch_mock_report(struct touch_mock *mock, int number, unsigned long time_us,
                       const struct touch_mock_value *values, int count);

int touch_mock_grabs(struct touch_mock *mock, int number); /* how often it was grabbed */

#endif
