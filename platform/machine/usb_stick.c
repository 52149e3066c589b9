#include "usb_stick.h"

#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { TEXT_MOST = 1 << 20, WHAT_MOST = 64 };

struct usb_stick {
    int fd;
    char *folder;
    char *text;           /* the list, TEXT_MOST */
    char what[WHAT_MOST]; /* number of the mount and of its device; "": none */
};

struct usb_stick *usb_stick_create(const char *folder, const char *mounts)
{
    struct usb_stick *stick = calloc(1, sizeof *stick);
    if (!stick) {
        return NULL;
    }
    stick->fd = open(mounts ? mounts : "/proc/self/mountinfo", O_RDONLY | O_CLOEXEC);
    stick->folder = strdup(folder);
    stick->text = malloc(TEXT_MOST);
    if (stick->fd < 0 || !stick->folder || !stick->text) {
        usb_stick_destroy(stick);
        return NULL;
    }
    return stick;
}

void usb_stick_destroy(struct usb_stick *stick)
{
    if (!stick) {
        return;
    }
    if (stick->fd >= 0) {
        close(stick->fd);
    }
    free(stick->folder);
    free(stick->text);
    free(stick);
}

/* Space, tab, line feed and backslash stand as \ooo: proc(5). */
static void unescape(char *path)
{
    char *to = path;
    for (const char *from = path; *from; to++) {
        bool escaped = from[0] == '\\' && from[1] >= '0' && from[1] <= '3' && from[2] >= '0' && from[2] <= '7' &&
                       from[3] >= '0' && from[3] <= '7';
        unsigned code = (unsigned char)*from;
        if (escaped) {
            code = (unsigned)(from[1] - '0') * 64 + (unsigned)(from[2] - '0') * 8 + (unsigned)(from[3] - '0');
        }
        *(unsigned char *)to = (unsigned char)code;
        from += escaped ? 4 : 1;
    }
    *to = '\0';
}

/* "36 35 98:0 /mnt1 /mnt2 rw,noatime master:1 - ext3 /dev/root rw,errors=continue": number, parent, device, its part,
 * where, options, fields until "-", kind, and more. The last mount of a place lies on top. */
static void read_line(struct usb_stick *stick, char *line, char what[WHAT_MOST])
{
    enum { NUMBER, DEVICE = 2, WHERE = 4, FIELDS };
    char *fields[FIELDS], *rest = line;
    for (int i = 0; i < FIELDS; i++) {
        fields[i] = strsep(&rest, " ");
        if (!fields[i]) {
            return;
        }
    }
    unescape(fields[WHERE]);
    if (strcmp(fields[WHERE], stick->folder) == 0) {
        snprintf(what, WHAT_MOST, "%s %s", fields[NUMBER], fields[DEVICE]);
    }
}

/* False when the list cannot be read. */
static bool read_list(struct usb_stick *stick)
{
    size_t size = 0;
    ssize_t count = 0;
    if (lseek(stick->fd, 0, SEEK_SET) != 0) {
        return false;
    }
    while (size < TEXT_MOST - 1 && (count = read(stick->fd, stick->text + size, TEXT_MOST - 1 - size)) > 0) {
        size += (size_t)count;
    }
    stick->text[size] = '\0';
    return count >= 0;
}

enum usb_stick_news usb_stick_look(struct usb_stick *stick)
{
    char what[WHAT_MOST] = "";
    if (!read_list(stick)) {
        return USB_STICK_SAME;
    }
    char *rest = stick->text;
    for (char *line; (line = strsep(&rest, "\n"));) {
        read_line(stick, line, what);
    }
    if (strcmp(what, stick->what) == 0) {
        return USB_STICK_SAME;
    }
    memcpy(stick->what, what, sizeof what);
    return what[0] ? USB_STICK_CAME : USB_STICK_GONE;
}
