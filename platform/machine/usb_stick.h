/* A USB stick that staff plug in, seen as what it becomes: a file system mounted at a place of its own.
 *
 * Frond mounts nothing, which would want a privilege. A rule of udev does (config/udev/71-frond-stick.rules): a
 * partition with FAT or exFAT of a USB disk is mounted by systemd at USB_STICK_FOLDER, with nosuid, nodev, noexec and
 * owned by the kiosk's user; those file systems have no links, no devices and no owners of their own. The unit of the
 * kiosk must see mounts come (MountFlags=slave, which is systemd's way wherever it gives a unit mounts of its own) and
 * may write there (ReadWritePaths=-/run/frond/stick). */
#ifndef FROND_USB_STICK_H
#define FROND_USB_STICK_H

#define USB_STICK_FOLDER "/run/frond/stick"

struct usb_stick;

enum usb_stick_news {
    USB_STICK_SAME,
    USB_STICK_CAME, /* or another one is there now */
    USB_STICK_GONE,
};

/* Looks for a mount on this folder, which need not be there; an absolute path without links, copied. `mounts`: a file
 * as /proc/self/mountinfo, NULL: that. NULL when there is none, or memory is short. A stick that is there already comes
 * with the first look. */
struct usb_stick *usb_stick_create(const char *folder, const char *mounts);
void usb_stick_destroy(struct usb_stick *stick); /* takes NULL */
enum usb_stick_news usb_stick_look(struct usb_stick *stick);

#endif
