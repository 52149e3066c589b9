#include "seat_hold.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/input.h>
#include <linux/kd.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum { HELD_MAX = 128 };

struct seat_hold {
    struct source_queue *queue;
    struct held {
        int fd; /* another name for what libinput has open */
        bool grabbed;
        char path[SOURCE_NAME];
    } held[HELD_MAX];
    int count;
    int console, mode; /* -1: none is held; what it was */
};

static void hold_console(struct seat_hold *hold, const char *path)
{
    int fd = open(path, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0 && errno == ENOENT) { /* a kernel without VTs: nothing to keep keys from */
        return;
    }
    if (fd < 0 || ioctl(fd, KDGKBMODE, &hold->mode) != 0 || ioctl(fd, KDSKBMODE, K_OFF) != 0) {
        source_note(hold->queue,
                    "console %.40s still takes keys: %s (the unit wants TTYPath=%.40s, or its process "
                    "CAP_SYS_TTY_CONFIG)",
                    path, strerror(errno), path);
        if (fd >= 0) {
            close(fd);
        }
        return;
    }
    hold->console = fd;
    if (hold->mode == K_OFF) { /* left behind by one that was killed */
        hold->mode = K_UNICODE;
    }
}

struct seat_hold *seat_hold_create(const char *console, struct source_queue *queue)
{
    struct seat_hold *hold = calloc(1, sizeof *hold);
    if (hold) {
        hold->queue = queue;
        hold->console = -1;
        if (console) {
            hold_console(hold, console);
        }
    }
    return hold;
}

void seat_hold_destroy(struct seat_hold *hold)
{
    if (!hold) {
        return;
    }
    for (int i = 0; i < hold->count; i++) {
        close(hold->held[i].fd);
    }
    if (hold->console >= 0) {
        ioctl(hold->console, KDSKBMODE, hold->mode);
        close(hold->console);
    }
    free(hold);
}

/* Not buttons (BTN_), of which no console knows. */
static bool has_keys(int fd)
{
    unsigned char bits[KEY_CNT / 8 + 1] = {0};
    if (ioctl(fd, EVIOCGBIT(EV_KEY, sizeof bits), bits) < 0) {
        return false;
    }
    for (unsigned code = KEY_ESC; code < KEY_CNT; code++) {
        bool button = (code >= BTN_MISC && code < KEY_OK) || (code >= BTN_DPAD_UP && code <= BTN_DPAD_RIGHT) ||
                      code >= BTN_TRIGGER_HAPPY;
        if (!button && bits[code / 8] & (1u << code % 8)) {
            return true;
        }
    }
    return false;
}

void seat_hold_take(struct seat_hold *hold, int fd, const char *path)
{
    if (!has_keys(fd)) {
        return;
    }
    bool grabbed = ioctl(fd, EVIOCGRAB, 1) == 0;
    int kept = hold->count < HELD_MAX ? fcntl(fd, F_DUPFD_CLOEXEC, 0) : -1;
    if (!grabbed || kept < 0) {
        source_note(hold->queue, "the keys of %.60s are not kept from others: %s", path,
                    grabbed ? "too many devices are open" : strerror(errno));
    }
    if (kept >= 0) {
        struct held *held = &hold->held[hold->count++];
        held->fd = kept;
        held->grabbed = grabbed;
        snprintf(held->path, sizeof held->path, "%s", path);
    }
}

bool seat_hold_missed(const struct seat_hold *hold, const char *path)
{
    for (int i = 0; i < hold->count; i++) {
        if (!hold->held[i].grabbed && strcmp(hold->held[i].path, path) == 0) {
            return true;
        }
    }
    return false;
}

int seat_hold_sweep(struct seat_hold *hold)
{
    struct pollfd polls[HELD_MAX];
    int count = 0;
    for (int i = 0; i < hold->count; i++) {
        polls[i] = (struct pollfd){.fd = hold->held[i].fd};
    }
    int gone = poll(polls, (nfds_t)hold->count, 0);
    for (int i = 0; i < hold->count; i++) {
        struct held held = hold->held[i];
        if (gone > 0 && polls[i].revents) { /* POLLERR and POLLHUP come unasked */
            close(held.fd);
            continue;
        }
        if (!held.grabbed && ioctl(held.fd, EVIOCGRAB, 1) == 0) {
            source_note(hold->queue, "the keys of %.60s are kept from others now", held.path);
            held.grabbed = true;
        }
        hold->held[count++] = held;
    }
    hold->count = count;
    return count;
}
