#include "devices_text.h"

#include <string.h>

#include "hid_report.h"
#include "hid_usage.h"
#include "key_names.h"
#include "source_gpio.h"
#include "source_hid.h"

enum { LINES_SHOWN = 64, WIDTH = 100 };

static const char *class_name(enum device_class class)
{
    static const char *const NAMES[] = {[DEVICE_TOUCH] = "touchscreen",
                                        [DEVICE_POINTER] = "pointer",
                                        [DEVICE_KEYBOARD] = "keyboard",
                                        [DEVICE_CONTROLLER] = "controller",
                                        [DEVICE_LINES] = "lines"};
    return NAMES[class];
}

/* Words with commas between them, in lines of bounded length. */
struct words {
    FILE *out;
    int column;
};

static void add_word(struct words *words, const char *text)
{
    if (words->column == 0 || words->column + (int)strlen(text) > WIDTH) {
        words->column = fprintf(words->out, "%s    %s", words->column > 0 ? ",\n" : "", text);
    } else {
        words->column += fprintf(words->out, ", %s", text);
    }
}

static void end_words(struct words *words)
{
    if (words->column > 0) {
        fputc('\n', words->out);
    }
}

/* Consecutive buttons as one: "Button 1 to Button 12". */
static int run_of(const struct hid_control *controls, int count)
{
    int length = 1;
    while (length < count && controls[0].kind == HID_BUTTON &&
           controls[length].usage == controls[0].usage + (uint32_t)length &&
           controls[length].kind == controls[0].kind) {
        length++;
    }
    return length;
}

static void print_usages(const struct hid_descriptor *descriptor, FILE *out)
{
    const struct hid_control *controls;
    struct hid_decoder_def def = {.descriptor = descriptor, .everything = true, .vendor = true};
    struct hid_decoder *decoder = hid_decoder_create(&def);
    struct words words = {out, 0};
    int count = decoder ? hid_decoder_controls(decoder, &controls) : 0;
    for (int i = 0; i < count;) {
        char first[HID_USAGE_NAME], last[HID_USAGE_NAME], text[2 * HID_USAGE_NAME + 8];
        int length = run_of(&controls[i], count - i);
        const struct hid_control *end = &controls[i + length - 1];
        hid_usage_name(controls[i].usage, first, sizeof first);
        hid_usage_name(end->usage_last, last, sizeof last);
        bool one = controls[i].usage == end->usage_last;
        snprintf(text, sizeof text, "%s%s%s", first, one ? "" : " to ", one ? "" : last);
        add_word(&words, text);
        i += length;
    }
    end_words(&words);
    hid_decoder_destroy(decoder);
}

static void print_lines(const struct source *source, uint32_t device, FILE *out)
{
    struct gpio_line_info lines[LINES_SHOWN];
    struct words words = {out, 0};
    int count = source_gpio_lines(source, device, lines, LINES_SHOWN);
    for (int i = 0; i < count && i < LINES_SHOWN; i++) {
        const struct gpio_line_info *line = &lines[i];
        char text[2 * GPIO_NAME + 32], taken[GPIO_NAME + 16] = "";
        if (line->used) {
            snprintf(taken, sizeof taken, " (taken%s%.60s)", *line->consumer ? " by " : "", line->consumer);
        }
        snprintf(text, sizeof text, "%d%s%.60s%s", i, *line->name ? " " : "", line->name, taken);
        add_word(&words, text);
    }
    if (count > LINES_SHOWN) {
        char text[32];
        snprintf(text, sizeof text, "and %d more", count - LINES_SHOWN);
        add_word(&words, text);
    }
    end_words(&words);
}

static void print_device(const struct source *source, const struct device *device, FILE *out)
{
    fprintf(out, "%s '%s'", class_name(device->class), device->name);
    if (device->vendor || device->product) {
        fprintf(out, " %04x:%04x", device->vendor, device->product);
    }
    fprintf(out, "%s%s%s%s, %s\n", *device->path ? " " : "", device->path, *device->port ? " at " : "", device->port,
            device->admitted ? "admitted" : "not admitted");
    if (strcmp(source->ops->name, "hid") == 0) {
        const struct hid_descriptor *descriptor = source_hid_descriptor(source, device->id);
        if (descriptor) {
            print_usages(descriptor, out);
        }
    } else if (strcmp(source->ops->name, "gpio") == 0) {
        print_lines(source, device->id, out);
    }
    if (*device->trouble) {
        fprintf(out, "    missing: %s\n", device->trouble);
    }
}

void devices_print(const struct sources *sources, FILE *out)
{
    static const struct {
        const char *name, *none;
    } KINDS[] = {
        {"touch", "no touchscreen, mouse or keyboard: none is plugged in, or libinput has no leave to look "
                  "(group input)"},
        {"hid", "no controller: none is plugged in, or the kernel has no hidraw (CONFIG_HIDRAW)"},
        {"gpio", "no GPIO chip: the board has none, or the kernel offers none (/dev/gpiochip*)"},
        {"fake", "no device that is not there"},
    };
    struct device devices[SOURCES_DEVICES];
    for (size_t i = 0; i < sizeof KINDS / sizeof *KINDS; i++) {
        const struct source *source = sources_find(sources, KINDS[i].name);
        int count = source ? source->ops->devices(source, devices, SOURCES_DEVICES) : 0;
        if (source && count == 0) {
            fprintf(out, "%s\n", KINDS[i].none);
        }
        for (int k = 0; k < count && k < SOURCES_DEVICES; k++) {
            print_device(source, &devices[k], out);
        }
    }
}

/* The name of a GPIO button or encoder; its number where the file has none. */
static const char *line_id(const struct inputs *inputs, uint32_t control, bool *encoder, char *number, size_t size)
{
    uint32_t buttons = (uint32_t)inputs->button_count;
    *encoder = control >= buttons;
    snprintf(number, size, "%u", control);
    if (control < buttons) {
        return inputs->buttons[control].id;
    }
    return control - buttons < (uint32_t)inputs->encoder_count ? inputs->encoders[control - buttons].id : number;
}

static const char *control_name(const struct event *event, const struct inputs *inputs, char *text, size_t size)
{
    bool encoder;
    const char *key = NULL;
    switch (event->source) {
    case SOURCE_HID:
        return hid_usage_name(event->control, text, (int)size);
    case SOURCE_GPIO:
        return line_id(inputs, event->control, &encoder, text, size);
    case SOURCE_KEY:
        key = key_name_of(event->control);
        break;
    default:
        break;
    }
    snprintf(text, size, "%u", event->control);
    return key ? key : text;
}

bool devices_event(const struct event *event, const struct device *device, const struct inputs *inputs, char *text,
                   size_t size)
{
    static const char *const KINDS[] = {
        [EVENT_DOWN] = "finger down",       [EVENT_MOVE] = "finger moves", [EVENT_UP] = "finger up",
        [EVENT_CANCEL] = "finger was none", [EVENT_ARRIVED] = "has come",  [EVENT_LEFT] = "has left"};
    char name[2 * HID_USAGE_NAME];
    switch (event->kind) {
    case EVENT_DOWN:
    case EVENT_MOVE:
    case EVENT_UP:
    case EVENT_CANCEL:
        snprintf(text, size, "'%s' %s %d at %.3f, %.3f", device->name, KINDS[event->kind], event->slot,
                 (double)event->x, (double)event->y);
        return true;
    case EVENT_ARRIVED:
    case EVENT_LEFT:
        snprintf(text, size, "'%s' %s", device->name, KINDS[event->kind]);
        return true;
    case EVENT_STANDING:
        snprintf(text, size, "'%s' %s is on", device->name, control_name(event, inputs, name, sizeof name));
        return true;
    case EVENT_CONTROL: {
        const char *control = control_name(event, inputs, name, sizeof name);
        int length = snprintf(text, size, "'%s' %s", device->name, control);
        if (event->index > 0 && length > 0 && (size_t)length < size) {
            length += snprintf(text + length, size - (size_t)length, " (index %d)", event->index);
        }
        if (length > 0 && (size_t)length < size) {
            snprintf(text + length, size - (size_t)length,
                     event->null       ? " nowhere"
                     : event->relative ? " %+g"
                                       : " %.3f",
                     (double)event->value);
        }
        return true;
    }
    default:
        return false;
    }
}

static bool is_seen(struct devices_seen *seen, const struct event *event)
{
    for (int i = 0; i < seen->count; i++) {
        if (seen->controls[i].source == event->source && seen->controls[i].device == event->device &&
            seen->controls[i].control == event->control && seen->controls[i].index == event->index) {
            return true;
        }
    }
    if (seen->count < DEVICES_SEEN) {
        seen->controls[seen->count].source = event->source;
        seen->controls[seen->count].device = event->device;
        seen->controls[seen->count].control = event->control;
        seen->controls[seen->count++].index = event->index;
    }
    return false;
}

/* The controller of the file that this is, as "controller: knob, "; nothing where it is not listed. */
static void controller_part(const struct device *device, const struct inputs_device *devices, int count, char *text,
                            size_t size)
{
    text[0] = '\0';
    for (int i = 0; i < count; i++) {
        if (inputs_match(&devices[i], device->vendor, device->product, device->name)) {
            snprintf(text, size, "controller: %s, ", devices[i].id);
            return;
        }
    }
}

static const char *usual_action(const struct event *event)
{
    static const uint32_t HAT = HID_USAGE(HID_PAGE_DESKTOP, 0x39);
    bool hid = event->source == SOURCE_HID;
    if (hid && event->control == HAT) {
        return "cursor: {axis: both}";
    }
    if (hid &&
        (event->control == HID_USAGE(HID_PAGE_DESKTOP, 0x30) || event->control == HID_USAGE(HID_PAGE_DESKTOP, 0x31))) {
        return event->control == HID_USAGE(HID_PAGE_DESKTOP, 0x30) ? "cursor: {axis: x}" : "cursor: {axis: y}";
    }
    bool axis = event->relative || event->centred || (event->value > 0 && event->value < 1);
    return axis || (hid && event->control >> 16 == HID_PAGE_DESKTOP) ? "turn: {coefficient: s_max, from: 0.1, to: 0.6}"
                                                                     : "drop: {}";
}

bool devices_binding(const struct event *event, const struct device *device, const struct inputs *inputs,
                     struct devices_seen *seen, char *text, size_t size)
{
    char name[2 * HID_USAGE_NAME], controller[64], index[24] = "";
    bool finger = event->kind == EVENT_DOWN;
    struct event one = *event;
    if (finger) {
        one.control = 0;
        one.index = 0;
    }
    if ((!finger && event->kind != EVENT_CONTROL) || is_seen(seen, &one)) {
        return false;
    }
    const char *control = control_name(event, inputs, name, sizeof name);
    if (event->index > 0) {
        snprintf(index, sizeof index, "index: %d, ", event->index);
    }
    switch (finger ? SOURCE_TOUCH : event->source) {
    case SOURCE_TOUCH:
        snprintf(text, size, "- {touch: press, drop: {}}");
        return true;
    case SOURCE_HID:
        controller_part(device, inputs->controllers, inputs->controller_count, controller, sizeof controller);
        if (hid_usage_of(control) != event->control) {
            snprintf(name, sizeof name, "0x%08x", event->control);
        }
        bool quoted = strchr(control, ':') && hid_usage_of(control) == event->control;
        snprintf(text, size, "- {usage: %s%s%s, %s%s%s}", quoted ? "'" : "", name, quoted ? "'" : "", controller, index,
                 usual_action(event));
        return true;
    case SOURCE_KEY:
        controller_part(device, inputs->keyboards, inputs->keyboard_count, controller, sizeof controller);
        snprintf(text, size, "- {key: %s, %snext_ink: {}}", control, controller);
        return key_name_of(event->control);
    case SOURCE_GPIO: {
        bool encoder;
        control = line_id(inputs, event->control, &encoder, name, sizeof name);
        snprintf(text, size, "- {%s: %s, %s}", encoder ? "encoder" : "button", control, usual_action(event));
        return true;
    }
    default:
        return false;
    }
}
