/* What `frond devices --descriptor FILE [--json]` prints: a HID report descriptor that was captured elsewhere, with
 * every report and field that it declares. */
#ifndef FROND_DEVICES_DESCRIPTOR_H
#define FROND_DEVICES_DESCRIPTOR_H

#include <stdbool.h>
#include <stdio.h>

#include "file.h"

/* The file holds the bytes as they are (/sys/class/hidraw/hidraw0/device/report_descriptor), or as numbers in base 16,
 * with or without 0x and commas, comments after # or // (as usbhid-dump, lsusb and makers of firmware write them). "-"
 * is standard input. False: it cannot be read or is malformed; the error is one line, "FILE: byte 12: what is wrong".
 */
bool devices_descriptor(const char *path, bool json, FILE *out, struct file_error *error);

#endif
