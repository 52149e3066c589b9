/* gpio_probe: two buttons, an encoder and a lamp on a chip labelled "board", by source_gpio; prints what comes, with
 * how many microseconds ago it happened.
 *
 *     button 0: line "BTN_OK" of any chip, to ground, debounced      button 1: line 1, plain
 *     control 2: an encoder on lines 2 and 3, 4 steps a detent       lamp 0: line 4
 *
 * Standard input: "lamp LEVEL", "devices", "quit". */
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "source_gpio.h"
#include "source_queue.h"

static struct source *create(void)
{
    static const struct gpio_button_def buttons[] = {
        {.name = "ok", .line = {.line = "BTN_OK", .bias = GPIO_BIAS_PULL_UP, .active_low = true}, .debounce_ms = 5},
        {.name = "plain", .line = {.chip = "board", .offset = 1}},
    };
    static const struct gpio_encoder_def encoder = {
        .name = "dial", .a = {.chip = "board", .offset = 2}, .b = {.chip = "board", .offset = 3}, .steps = 4};
    static const struct gpio_lamp_def lamp = {.name = "glow", .line = {.chip = "board", .offset = 4}};
    struct device_error error;
    struct source *source = source_gpio_create(&(struct source_gpio_def){.buttons = buttons,
                                                                         .button_count = 2,
                                                                         .encoders = &encoder,
                                                                         .encoder_count = 1,
                                                                         .lamps = &lamp,
                                                                         .lamp_count = 1},
                                               &error);
    if (!source) {
        fprintf(stderr, "%s\n", error.text);
        exit(1);
    }
    return source;
}

static void say_event(const struct event *event)
{
    long long ago = (long long)(source_now_us() - event->time_us);
    switch (event->kind) {
    case EVENT_CONTROL:
        printf("control %u %s %g device %u ago %lld\n", event->control, event->relative ? "turns" : "is",
               (double)event->value, event->device, ago);
        break;
    case EVENT_STANDING:
        printf("control %u stands\n", event->control);
        break;
    case EVENT_ARRIVED:
        printf("device %u arrived\n", event->device);
        break;
    case EVENT_LEFT:
        printf("device %u left\n", event->device);
        break;
    default:
        printf("event of kind %d\n", (int)event->kind);
    }
}

static void say_devices(const struct source *source)
{
    struct device devices[8];
    struct gpio_line_info lines[64];
    int count = source->ops->devices(source, devices, 8);
    for (int i = 0; i < count && i < 8; i++) {
        printf("device %u '%s' %s at '%s'%s%s\n", devices[i].id, devices[i].name, devices[i].path, devices[i].port,
               devices[i].trouble[0] ? ": " : "", devices[i].trouble);
        int most = source_gpio_lines(source, devices[i].id, lines, 64);
        for (int line = 0; line < most && line < 64; line++) {
            printf("line %d '%s' %s\n", line, lines[line].name, lines[line].used ? lines[line].consumer : "is free");
        }
    }
    printf("devices end\n");
}

/* False: to end. */
static bool obey(struct source *source)
{
    char text[200];
    float level;
    ssize_t length = read(STDIN_FILENO, text, sizeof text - 1);
    text[length > 0 ? length : 0] = '\0';
    if (sscanf(text, "lamp %f", &level) == 1) {
        printf("lamp %s\n", source->ops->lamp(source, 0, level) ? "taken" : "refused");
    } else if (strncmp(text, "devices", 7) == 0) {
        say_devices(source);
    }
    return length > 0 && strncmp(text, "quit", 4) != 0;
}

int main(void)
{
    struct source *source = create();
    bool on = true;
    setvbuf(stdout, NULL, _IOLBF, 0);
    while (on) {
        struct event event;
        char line[200];
        while (source->ops->log(source, line, sizeof line)) {
            printf("log: %s\n", line);
        }
        while (source->ops->event(source, &event)) {
            say_event(&event);
        }
        struct pollfd wait[2] = {{.fd = STDIN_FILENO, .events = POLLIN},
                                 {.fd = source->ops->fd(source), .events = POLLIN}};
        poll(wait, 2, source->ops->timeout_ms(source));
        if (wait[0].revents) {
            on = obey(source);
        }
        source->ops->dispatch(source);
    }
    source_destroy(source);
    return 0;
}
