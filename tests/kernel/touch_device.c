/* touch_device: a touchscreen, a touchpad or a mouse of the kernel's own, made through /dev/uinput.
 *
 *     touch_device screen|pad|mouse|keyed NAME     keyed: a mouse with keys, as remote controls on HDMI-CEC show one
 *
 * Prints "ready". Standard input, one line at a time: "down SLOT X Y", "move SLOT X Y", "palm SLOT", "up SLOT" (screens
 * and pads, 0..999), "by X Y", "button 0|1" (mice), "storm N" (N strokes of all ten fingers, a millisecond between
 * reports), "quit" unplugs it. */
#include <fcntl.h>
#include <linux/uinput.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum { FINGERS = 10, SIZE = 1000 };

struct pad {
    int fd, fingers, last;
};

static void demand(bool good, const char *what)
{
    if (!good) {
        perror(what);
        exit(1);
    }
}

static void emit(const struct pad *pad, unsigned type, unsigned code, int value)
{
    const struct input_event event = {.type = (unsigned short)type, .code = (unsigned short)code, .value = value};
    demand(write(pad->fd, &event, sizeof event) == (ssize_t)sizeof event, "touch_device: write");
}

static void report(const struct pad *pad)
{
    emit(pad, EV_SYN, SYN_REPORT, 0);
}

static void allow(const struct pad *pad, unsigned long request, const int *codes, int count)
{
    for (int i = 0; i < count; i++) {
        demand(ioctl(pad->fd, request, codes[i]) == 0, "touch_device: setup");
    }
}

static void allow_axis(const struct pad *pad, int code, int most, int resolution)
{
    struct uinput_abs_setup setup = {.code = (unsigned short)code,
                                     .absinfo = {.maximum = most, .resolution = resolution}};
    demand(ioctl(pad->fd, UI_ABS_SETUP, &setup) == 0, "touch_device: axis");
}

#define ALLOW(pad, request, ...)                                                                                       \
    allow(pad, request, (const int[]){__VA_ARGS__}, (int)(sizeof(int[]){__VA_ARGS__} / sizeof(int)))

static void become_surface(const struct pad *pad, bool screen)
{
    ALLOW(pad, UI_SET_EVBIT, EV_SYN, EV_KEY, EV_ABS);
    ALLOW(pad, UI_SET_KEYBIT, BTN_TOUCH);
    if (!screen) {
        ALLOW(pad, UI_SET_KEYBIT, BTN_LEFT, BTN_TOOL_FINGER, BTN_TOOL_DOUBLETAP);
        ALLOW(pad, UI_SET_PROPBIT, INPUT_PROP_POINTER, INPUT_PROP_BUTTONPAD);
    } else {
        ALLOW(pad, UI_SET_PROPBIT, INPUT_PROP_DIRECT);
    }
    allow_axis(pad, ABS_X, SIZE - 1, 10);
    allow_axis(pad, ABS_Y, SIZE - 1, 10);
    allow_axis(pad, ABS_MT_SLOT, FINGERS - 1, 0);
    allow_axis(pad, ABS_MT_TRACKING_ID, 65535, 0);
    allow_axis(pad, ABS_MT_TOOL_TYPE, MT_TOOL_PALM, 0);
    allow_axis(pad, ABS_MT_POSITION_X, SIZE - 1, 10);
    allow_axis(pad, ABS_MT_POSITION_Y, SIZE - 1, 10);
}

static void become_mouse(const struct pad *pad, bool keyed)
{
    ALLOW(pad, UI_SET_EVBIT, EV_SYN, EV_KEY, EV_REL);
    ALLOW(pad, UI_SET_KEYBIT, BTN_LEFT, BTN_RIGHT);
    ALLOW(pad, UI_SET_RELBIT, REL_X, REL_Y);
    if (keyed) {
        ALLOW(pad, UI_SET_KEYBIT, KEY_OK, KEY_UP, KEY_DOWN, KEY_POWER, KEY_PLAY, KEY_STOP);
    }
}

static void create(struct pad *pad, const char *kind, const char *name)
{
    struct uinput_setup setup = {.id = {.bustype = BUS_USB, .vendor = 0x1209, .product = 0x0010, .version = 1}};
    snprintf(setup.name, sizeof setup.name, "%s", name);
    pad->fd = open("/dev/uinput", O_RDWR | O_CLOEXEC);
    demand(pad->fd >= 0, "touch_device: /dev/uinput");
    if (strcmp(kind, "screen") == 0 || strcmp(kind, "pad") == 0) {
        become_surface(pad, strcmp(kind, "screen") == 0);
    } else {
        become_mouse(pad, strcmp(kind, "keyed") == 0);
    }
    demand(ioctl(pad->fd, UI_DEV_SETUP, &setup) == 0 && ioctl(pad->fd, UI_DEV_CREATE) == 0, "touch_device: create");
}

static void place(const struct pad *pad, int slot, int x, int y)
{
    emit(pad, EV_ABS, ABS_MT_SLOT, slot);
    emit(pad, EV_ABS, ABS_MT_POSITION_X, x);
    emit(pad, EV_ABS, ABS_MT_POSITION_Y, y);
}

static void put_down(struct pad *pad, int slot, int x, int y)
{
    emit(pad, EV_ABS, ABS_MT_SLOT, slot);
    emit(pad, EV_ABS, ABS_MT_TRACKING_ID, ++pad->last & 0xffff);
    emit(pad, EV_ABS, ABS_MT_TOOL_TYPE, MT_TOOL_FINGER);
    place(pad, slot, x, y);
    if (pad->fingers++ == 0) {
        emit(pad, EV_KEY, BTN_TOUCH, 1);
    }
}

static void lift(struct pad *pad, int slot)
{
    emit(pad, EV_ABS, ABS_MT_SLOT, slot);
    emit(pad, EV_ABS, ABS_MT_TRACKING_ID, -1);
    if (--pad->fingers == 0) {
        emit(pad, EV_KEY, BTN_TOUCH, 0);
    }
}

static void wait_ms(struct pad *pad)
{
    report(pad);
    usleep(1000);
}

static void storm(struct pad *pad, int strokes)
{
    for (int i = 0; i < strokes; i++) {
        for (int slot = 0; slot < FINGERS; slot++) {
            put_down(pad, slot, 90 * slot + 50, 100);
            wait_ms(pad);
        }
        for (int step = 0; step < 8; step++) {
            for (int slot = 0; slot < FINGERS; slot++) {
                place(pad, slot, 90 * slot + 50, 100 + 100 * step + i % 50);
            }
            wait_ms(pad);
        }
        for (int slot = 0; slot < FINGERS; slot++) {
            lift(pad, slot);
            wait_ms(pad);
        }
    }
    printf("storm is over\n");
}

/* False: to end. */
static bool obey(struct pad *pad, const char *line)
{
    int slot, x, y;
    /* NOLINTBEGIN(cert-err34-c): lines of the scenario's own */
    if (sscanf(line, "down %d %d %d", &slot, &x, &y) == 3) {
        put_down(pad, slot, x, y);
    } else if (sscanf(line, "move %d %d %d", &slot, &x, &y) == 3) {
        place(pad, slot, x, y);
    } else if (sscanf(line, "palm %d", &slot) == 1) {
        emit(pad, EV_ABS, ABS_MT_SLOT, slot);
        emit(pad, EV_ABS, ABS_MT_TOOL_TYPE, MT_TOOL_PALM);
    } else if (sscanf(line, "up %d", &slot) == 1) {
        lift(pad, slot);
    } else if (sscanf(line, "by %d %d", &x, &y) == 2) {
        emit(pad, EV_REL, REL_X, x);
        emit(pad, EV_REL, REL_Y, y);
    } else if (sscanf(line, "button %d", &x) == 1) {
        emit(pad, EV_KEY, BTN_LEFT, x);
    } else if (sscanf(line, "storm %d", &x) == 1) {
        storm(pad, x);
    } else {
        return false;
    }
    /* NOLINTEND(cert-err34-c) */
    report(pad);
    return true;
}

int main(int argc, char *argv[])
{
    struct pad pad = {0};
    char line[100];
    if (argc != 3) {
        fprintf(stderr, "touch_device screen|pad|mouse|keyed NAME\n");
        return 2;
    }
    setvbuf(stdout, NULL, _IOLBF, 0);
    create(&pad, argv[1], argv[2]);
    printf("ready\n");
    while (fgets(line, sizeof line, stdin) && obey(&pad, line)) {
    }
    ioctl(pad.fd, UI_DEV_DESTROY);
    return 0;
}
