#include "source_touch.h"

#include <errno.h>
#include <fcntl.h>
#include <libinput.h>
#include <libudev.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "seat_hold.h"
#include "source_device.h"
#include "source_queue.h"
#include "touch_device.h"
#include "touch_fingers.h"

enum {
    SWEEP_MS = 1000, /* libinput does not tell of devices that it could not open, or had no use for */
    PIXELS = 1000,   /* across a display of unknown size */
};

struct source_touch {
    struct source source;
    struct source_queue queue;
    struct touch_definition *definition;
    struct udev *udev;
    struct libinput *libinput;
    struct seat_hold *hold; /* NULL: the seat is not held */
    struct touch_fingers fingers;
    struct touch_devices devices;
    bool sweep; /* something wants it */
    uint64_t sweep_us;
};

static struct source_touch *touch_of(struct source *source)
{
    return (struct source_touch *)source;
}

static const struct source_touch *const_touch_of(const struct source *source)
{
    return (const struct source_touch *)source;
}

/* ---- Opening ---- */

static void note_refusal(struct source_touch *touch, const char *path, int code)
{
    struct touch_device device = {0};
    if (code == ENOENT || code == ENODEV || code == ENXIO || touch_devices_find(&touch->devices, path)) {
        return; /* it has left already, or this has been said */
    }
    if (!touch_device_read_node(&device, touch->udev, path)) {
        return;
    }
    device_explain(device.trouble, sizeof device.trouble, path, code,
                   "SUBSYSTEM==\"input\", KERNEL==\"event*\", GROUP=\"input\", MODE=\"0660\"");
    device.admission = touch_admit(&touch->definition->def, &device.traits);
    source_note(&touch->queue, "%s '%.40s' (%.40s): %s", touch_class(&device.traits), device.traits.name, path,
                device.trouble);
    touch_devices_add(&touch->devices, &device);
    touch->sweep = true;
}

/* Reading is enough where writing is not allowed: libinput writes lamps of keyboards only. */
static int open_restricted(const char *path, int flags, void *user)
{
    struct source_touch *touch = user;
    int fd = open(path, flags | O_CLOEXEC);
    if (fd < 0 && (errno == EACCES || errno == EPERM)) {
        fd = open(path, (flags & ~O_ACCMODE) | O_RDONLY | O_CLOEXEC);
    }
    if (fd < 0) {
        int code = errno;
        note_refusal(touch, path, code);
        return -code;
    }
    if (touch->hold) {
        seat_hold_take(touch->hold, fd, path);
        touch->sweep = true;
    }
    return fd;
}

static void close_restricted(int fd, void *user)
{
    (void)user;
    close(fd);
}

/* ---- Devices come and go ---- */

static bool is_heard(const struct touch_device *device)
{
    return device->admission.touch || device->admission.pointer || device->admission.keys;
}

static void post_presence(struct source_touch *touch, const struct touch_device *device, enum event_kind kind)
{
    bool keyboard = strcmp(touch_class(&device->traits), DEVICE_KEYBOARD) == 0;
    const struct event event = {
        .kind = kind, .source = keyboard ? SOURCE_KEY : SOURCE_TOUCH, .time_us = source_now_us(), .device = device->id};
    source_post(&touch->queue, &event);
}

static void arrive(struct source_touch *touch, struct libinput_device *from)
{
    struct touch_device read = {.open = true};
    touch_device_read(&read, from);
    const struct touch_traits *traits = &read.traits;
    if (!traits->touch && !traits->pointer && !traits->keys) { /* a lid, a pen */
        libinput_device_config_send_events_set_mode(from, LIBINPUT_CONFIG_SEND_EVENTS_DISABLED);
        return;
    }
    struct touch_device *before = touch_devices_find(&touch->devices, read.path);
    if (before) { /* it could not be opened then */
        before->present = false;
    }
    read.admission = touch_admit(&touch->definition->def, traits);
    struct touch_device *device = touch_devices_add(&touch->devices, &read);
    libinput_device_set_user_data(from, device);
    const char *class = touch_class(traits);
    if (!device || !is_heard(device)) {
        /* What has keys stays grabbed all the same. */
        libinput_device_config_send_events_set_mode(from, LIBINPUT_CONFIG_SEND_EVENTS_DISABLED);
        source_note(&touch->queue, "%s '%.60s' (%04x:%04x, %s) is not admitted: it is ignored", class, traits->name,
                    traits->vendor, traits->product, read.path);
        return;
    }
    libinput_device_config_accel_set_profile(from, LIBINPUT_CONFIG_ACCEL_PROFILE_FLAT);
    device->arrived = true;
    post_presence(touch, device, EVENT_ARRIVED);
    source_note(&touch->queue, "%s '%.60s' (%04x:%04x) has arrived on %s", class, traits->name, traits->vendor,
                traits->product, device->path);
}

static void leave(struct source_touch *touch, struct touch_device *device)
{
    const struct touch_report gone = {.kind = TOUCH_REPORT_GONE, .device = device->id, .time_us = source_now_us()};
    touch_fingers_feel(&touch->fingers, &gone);
    device->present = false;
    if (device->arrived) {
        device->arrived = false;
        post_presence(touch, device, EVENT_LEFT);
        source_note(&touch->queue, "%s '%.60s' (%s) has left", touch_class(&device->traits), device->traits.name,
                    device->path);
    }
}

static void sweep(struct source_touch *touch)
{
    bool more = touch->hold && seat_hold_sweep(touch->hold) > 0;
    for (int i = 0; i < touch->devices.count; i++) {
        struct touch_device *device = &touch->devices.list[i];
        if (device->present && !device->open) {
            device->present = access(device->path, F_OK) == 0;
            more = more || device->present;
        }
    }
    touch->sweep = more;
    touch->sweep_us = source_now_us() + 1000u * SWEEP_MS;
}

/* ---- What devices say ---- */

static void hear_touch(struct source_touch *touch, const struct touch_device *device, struct libinput_event *from,
                       enum touch_report_kind kind)
{
    struct libinput_event_touch *finger = libinput_event_get_touch_event(from);
    struct touch_report report = {.kind = kind,
                                  .device = device->id,
                                  .time_us = libinput_event_touch_get_time_usec(finger),
                                  .touch = libinput_event_touch_get_slot(finger)};
    if (kind == TOUCH_REPORT_DOWN || kind == TOUCH_REPORT_MOVE) {
        report.x = (float)libinput_event_touch_get_x_transformed(finger, 1);
        report.y = (float)libinput_event_touch_get_y_transformed(finger, 1);
    }
    /* A screen of one finger has no slots. */
    report.touch = report.touch < 0 ? 0 : report.touch;
    if (device->admission.touch) {
        touch_fingers_feel(&touch->fingers, &report);
    }
}

static void hear_pointer(struct source_touch *touch, const struct touch_device *device, struct libinput_event *from,
                         enum touch_report_kind kind)
{
    struct libinput_event_pointer *pointer = libinput_event_get_pointer_event(from);
    struct touch_report report = {
        .kind = kind, .device = device->id, .time_us = libinput_event_pointer_get_time_usec(pointer)};
    if (kind == TOUCH_REPORT_MOTION) {
        report.x = (float)libinput_event_pointer_get_dx(pointer);
        report.y = (float)libinput_event_pointer_get_dy(pointer);
    } else if (kind == TOUCH_REPORT_PLACE) {
        report.x = (float)libinput_event_pointer_get_absolute_x_transformed(pointer, 1);
        report.y = (float)libinput_event_pointer_get_absolute_y_transformed(pointer, 1);
    } else {
        report.code = libinput_event_pointer_get_button(pointer);
        report.pressed = libinput_event_pointer_get_button_state(pointer) == LIBINPUT_BUTTON_STATE_PRESSED;
    }
    if (device->admission.pointer) {
        touch_fingers_feel(&touch->fingers, &report);
    }
}

static void hear_key(struct source_touch *touch, const struct touch_device *device, struct libinput_event *from)
{
    struct libinput_event_keyboard *key = libinput_event_get_keyboard_event(from);
    const struct touch_report report = {
        .kind = TOUCH_REPORT_KEY,
        .device = device->id,
        .time_us = libinput_event_keyboard_get_time_usec(key),
        .code = libinput_event_keyboard_get_key(key),
        .pressed = libinput_event_keyboard_get_key_state(key) == LIBINPUT_KEY_STATE_PRESSED,
    };
    if (device->admission.keys && touch_key_is_bound(&touch->definition->def, report.code)) {
        touch_fingers_feel(&touch->fingers, &report);
    }
}

static void hear(struct source_touch *touch, struct libinput_event *event)
{
    struct libinput_device *from = libinput_event_get_device(event);
    enum libinput_event_type type = libinput_event_get_type(event);
    struct touch_device *device = libinput_device_get_user_data(from);
    if (type == LIBINPUT_EVENT_DEVICE_ADDED) {
        arrive(touch, from);
        return;
    }
    if (!device) {
        return;
    }
    /* NOLINTNEXTLINE(clang-diagnostic-switch-enum): libinput has kinds that nobody here asks for, and gets new ones */
    switch ((int)type) {
    case LIBINPUT_EVENT_DEVICE_REMOVED:
        leave(touch, device);
        break;
    case LIBINPUT_EVENT_TOUCH_DOWN:
        hear_touch(touch, device, event, TOUCH_REPORT_DOWN);
        break;
    case LIBINPUT_EVENT_TOUCH_MOTION:
        hear_touch(touch, device, event, TOUCH_REPORT_MOVE);
        break;
    case LIBINPUT_EVENT_TOUCH_UP:
        hear_touch(touch, device, event, TOUCH_REPORT_UP);
        break;
    case LIBINPUT_EVENT_TOUCH_CANCEL:
        hear_touch(touch, device, event, TOUCH_REPORT_CANCEL);
        break;
    case LIBINPUT_EVENT_POINTER_MOTION:
        hear_pointer(touch, device, event, TOUCH_REPORT_MOTION);
        break;
    case LIBINPUT_EVENT_POINTER_MOTION_ABSOLUTE:
        hear_pointer(touch, device, event, TOUCH_REPORT_PLACE);
        break;
    case LIBINPUT_EVENT_POINTER_BUTTON:
        hear_pointer(touch, device, event, TOUCH_REPORT_BUTTON);
        break;
    case LIBINPUT_EVENT_KEYBOARD_KEY:
        hear_key(touch, device, event);
        break;
    default:
        break;
    }
}

/* ---- The source ---- */

static void dispatch(struct source *source)
{
    struct source_touch *touch = touch_of(source);
    struct libinput_event *event;
    int code = libinput_dispatch(touch->libinput);
    (void)code; /* what fails now is tried again next time */
    while ((event = libinput_get_event(touch->libinput))) {
        hear(touch, event);
        libinput_event_destroy(event);
    }
    if (touch->sweep && source_now_us() >= touch->sweep_us) {
        sweep(touch);
    }
}

static int get_fd(const struct source *source)
{
    return libinput_get_fd(const_touch_of(source)->libinput);
}

static int get_timeout(const struct source *source)
{
    const struct source_touch *touch = const_touch_of(source);
    uint64_t now = source_now_us();
    if (touch->queue.count > 0) {
        return 0;
    }
    if (!touch->sweep) {
        return -1;
    }
    return now >= touch->sweep_us ? 0 : (int)((touch->sweep_us - now + 999) / 1000);
}

static bool get_event(struct source *source, struct event *event)
{
    return source_take(&touch_of(source)->queue, event);
}

static bool get_line(struct source *source, char *line, int size)
{
    return source_take_line(&touch_of(source)->queue, line, size);
}

static int get_devices(const struct source *source, struct device *devices, int most)
{
    const struct source_touch *touch = const_touch_of(source);
    int count = 0;
    for (int i = 0; i < touch->devices.count; i++) {
        const struct touch_device *device = &touch->devices.list[i];
        if (!device->present) {
            continue;
        }
        if (count < most) {
            touch_device_describe(device, &devices[count]);
            if (touch->hold && seat_hold_missed(touch->hold, device->path)) {
                snprintf(devices[count].trouble, sizeof devices[count].trouble,
                         "another program has grabbed it: its keys are not kept from the system");
            }
        }
        count++;
    }
    return count;
}

static void destroy(struct source *source)
{
    struct source_touch *touch = touch_of(source);
    if (touch->libinput) {
        libinput_unref(touch->libinput);
    }
    if (touch->udev) {
        udev_unref(touch->udev);
    }
    seat_hold_destroy(touch->hold);
    touch_definition_destroy(touch->definition);
    free(touch);
}

static const struct source_ops ops = {.name = "touch",
                                      .destroy = destroy,
                                      .fd = get_fd,
                                      .timeout_ms = get_timeout,
                                      .dispatch = dispatch,
                                      .event = get_event,
                                      .devices = get_devices,
                                      .log = get_line};

static void hear_log(struct libinput *libinput, enum libinput_log_priority priority, const char *format, va_list values)
    __attribute__((format(printf, 3, 0)));
static void hear_log(struct libinput *libinput, enum libinput_log_priority priority, const char *format, va_list values)
{
    struct source_touch *touch = libinput_get_user_data(libinput);
    char line[SOURCE_LOG_LENGTH];
    if (priority >= LIBINPUT_LOG_PRIORITY_ERROR) {
        vsnprintf(line, sizeof line, format, values);
        line[strcspn(line, "\n")] = '\0';
        source_note(&touch->queue, "libinput: %s", line);
    }
}

static bool start(struct source_touch *touch, struct device_error *error)
{
    static const struct libinput_interface interface = {open_restricted, close_restricted};
    const struct source_touch_def *def = &touch->definition->def;
    if (def->hold && !(touch->hold = seat_hold_create(def->console, &touch->queue))) {
        return device_fail(error, "touch: memory is short");
    }
    touch->udev = udev_new();
    touch->libinput = touch->udev ? libinput_udev_create_context(&interface, touch, touch->udev) : NULL;
    if (!touch->libinput) {
        return device_fail(error, "touch: udev or libinput cannot be reached");
    }
    libinput_log_set_handler(touch->libinput, hear_log);
    if (libinput_udev_assign_seat(touch->libinput, def->seat) != 0) {
        return device_fail(error, "touch: udev does not tell of devices on %.60s", def->seat);
    }
    return true;
}

struct source *source_touch_create(const struct source_touch_def *def, struct device_error *error)
{
    struct source_touch *touch = calloc(1, sizeof *touch);
    if (!touch) {
        device_fail(error, "touch: memory is short");
        return NULL;
    }
    touch->source.ops = &ops;
    touch->definition = touch_definition_create(def, error);
    if (!touch->definition) {
        destroy(&touch->source);
        return NULL;
    }
    touch->fingers = (struct touch_fingers){.queue = &touch->queue,
                                            .rotation = def->rotation,
                                            .width = (float)(def->width ? def->width : PIXELS),
                                            .height = (float)(def->height ? def->height : PIXELS)};
    if (!start(touch, error)) {
        destroy(&touch->source);
        return NULL;
    }
    dispatch(&touch->source); /* what is plugged in */
    return &touch->source;
}
