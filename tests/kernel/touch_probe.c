/* touch_probe: what source_touch says, and how many microseconds ago it happened.
 *
 *     touch_probe [--rotation DEGREES] [--hold CONSOLE] [--pointers] [--staff NAME]
 *
 * Keyboards of that name are bound with F1. Standard input: "devices", "count", "quiet" and "loud" (fingers
 * are counted, or printed too), "nap" (a second without listening), "console" (what the VT in front makes
 * of keys: 4 is nothing), "quit". */
#include <fcntl.h>
#include <linux/input-event-codes.h>
#include <linux/kd.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "source_queue.h"
#include "source_touch.h"

struct seen {
    bool quiet; /* fingers are counted, not printed */
    unsigned downs, left, twice;
    bool down[64];
};

static struct source *create(int argc, char *argv[])
{
    static const uint32_t keys[] = {KEY_F1};
    static struct source_touch_device_def staff = {.keys = true};
    struct source_touch_def def = {.width = 1000, .height = 1000, .touchscreens = true};
    struct device_error error;
    for (int i = 1; i < argc; i++) {
        const char *value = i + 1 < argc ? argv[i + 1] : "";
        if (strcmp(argv[i], "--pointers") == 0) {
            def.pointers = true;
            continue;
        }
        if (strcmp(argv[i], "--rotation") == 0) {
            def.rotation = (int)strtol(value, NULL, 10);
        } else if (strcmp(argv[i], "--hold") == 0) {
            def.hold = true;
            def.console = value;
        } else if (strcmp(argv[i], "--staff") == 0) {
            staff.match.name = value;
            def.devices = &staff;
            def.device_count = def.key_count = 1;
            def.keys = keys;
        }
        i++;
    }
    struct source *source = source_touch_create(&def, &error);
    if (!source) {
        fprintf(stderr, "%s\n", error.text);
        exit(1);
    }
    return source;
}

static void count(struct seen *seen, const struct event *event)
{
    bool down = event->kind == EVENT_DOWN;
    seen->downs += down;
    if (event->kind != EVENT_MOVE) {
        seen->twice += seen->down[event->slot] == down;
        seen->left += down ? 1u : -1u;
        seen->down[event->slot] = down;
    }
}

static void say_event(struct seen *seen, const struct event *event)
{
    static const char *const kinds[] = {
        [EVENT_NONE] = "none",       [EVENT_DOWN] = "down",       [EVENT_MOVE] = "move",
        [EVENT_UP] = "up",           [EVENT_CANCEL] = "cancel",   [EVENT_CONTROL] = "control",
        [EVENT_STANDING] = "stands", [EVENT_ARRIVED] = "arrived", [EVENT_LEFT] = "left"};
    if (event->kind == EVENT_ARRIVED || event->kind == EVENT_LEFT) {
        printf("device %u %s\n", event->device, kinds[event->kind]);
    } else if (event->kind == EVENT_CONTROL) {
        printf("key %u is %g device %u\n", event->control, (double)event->value, event->device);
    } else {
        count(seen, event);
        if (seen->quiet) {
            return;
        }
        printf("%s %d at %.2f %.2f device %u ago %lld\n", kinds[event->kind], event->slot, (double)event->x,
               (double)event->y, event->device, (long long)(source_now_us() - event->time_us));
    }
}

static void say_devices(const struct source *source)
{
    struct device devices[SOURCE_TOUCH_DEVICES];
    int found = source->ops->devices(source, devices, SOURCE_TOUCH_DEVICES);
    for (int i = 0; i < found; i++) {
        printf("listed %s '%s' %04x:%04x %s %s%s%s\n", devices[i].class, devices[i].name, devices[i].vendor,
               devices[i].product, devices[i].path, devices[i].admitted ? "admitted" : "not admitted",
               devices[i].trouble[0] ? ": " : "", devices[i].trouble);
    }
    printf("listed all\n");
}

static void say_console(void)
{
    int mode = -1, fd = open("/dev/tty0", O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (fd < 0 || ioctl(fd, KDGKBMODE, &mode) != 0) {
        perror("touch_probe: /dev/tty0");
    }
    close(fd);
    printf("console mode %d\n", mode);
}

/* False: to end. */
static bool obey(struct source *source, struct seen *seen)
{
    char text[200];
    ssize_t length = read(STDIN_FILENO, text, sizeof text - 1);
    text[length > 0 ? length : 0] = '\0';
    if (strncmp(text, "devices", 7) == 0) {
        say_devices(source);
    } else if (strncmp(text, "count", 5) == 0) {
        printf("downs %u left %u twice %u\n", seen->downs, seen->left, seen->twice);
    } else if (strncmp(text, "quiet", 5) == 0 || strncmp(text, "loud", 4) == 0) {
        seen->quiet = text[0] == 'q';
    } else if (strncmp(text, "console", 7) == 0) {
        say_console();
    } else if (strncmp(text, "nap", 3) == 0) {
        sleep(1);
    }
    return length > 0 && strncmp(text, "quit", 4) != 0;
}

int main(int argc, char *argv[])
{
    struct source *source = create(argc, argv);
    struct seen seen = {0};
    bool on = true;
    setvbuf(stdout, NULL, _IOLBF, 0);
    printf("listening\n");
    while (on) {
        struct event event;
        char line[200];
        while (source->ops->log(source, line, sizeof line)) {
            printf("log: %s\n", line);
        }
        while (source->ops->event(source, &event)) {
            say_event(&seen, &event);
        }
        struct pollfd wait[2] = {{.fd = STDIN_FILENO, .events = POLLIN},
                                 {.fd = source->ops->fd(source), .events = POLLIN}};
        poll(wait, 2, source->ops->timeout_ms(source));
        if (wait[0].revents) {
            on = obey(source, &seen);
        }
        source->ops->dispatch(source);
    }
    source_destroy(source);
    return 0;
}
