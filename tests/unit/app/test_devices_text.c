/* What `frond devices` prints (app/devices_text.h), of devices that are not there. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "device_class.h"
#include "devices_text.h"
#include "hid_usage.h"
#include "source_fake.h"

static const char TEXT[] = "inputs: 1\n"
                           "keyboards: [{id: staff, name: Keys}]\n"
                           "controllers: [{id: knob, vendor: 077d, product: 0410}]\n"
                           "gpio: {buttons: [{id: red, line: A}], encoders: [{id: wheel, a: B, b: C}]}\n";

static struct inputs *open_inputs(void)
{
    struct script_def def = script_default_def();
    struct report report;
    report_init(&report, "inputs");
    struct inputs *inputs = inputs_parse(TEXT, strlen(TEXT), ".", NULL, &def, &report);
    report_finish(&report);
    assert_non_null(inputs);
    return inputs;
}

static void devices_are_listed_with_what_they_lack(void **state)
{
    (void)state;
    static const struct device devices[] = {{.class = DEVICE_CONTROLLER,
                                             .vendor = 0x77d,
                                             .product = 0x410,
                                             .name = "Knob",
                                             .path = "/dev/hidraw0",
                                             .port = "usb-1.2",
                                             .admitted = true,
                                             .trouble = "no permission; add the udev rule X"},
                                            {.class = DEVICE_KEYBOARD, .name = "Keys", .path = "/dev/hidraw1"}};
    struct device_error error;
    struct inputs *inputs = open_inputs();
    struct sources_def def = {.inputs = inputs, .look = true};
    struct sources *sources = sources_create(&def);
    struct source *fake = source_fake_create(&(struct source_fake_def){.devices = devices, .device_count = 2}, &error);
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    assert_true(sources && fake && out && sources_add(sources, fake));
    devices_print(sources, out);
    fclose(out);
    assert_non_null(strstr(text, "controller 'Knob' 077d:0410 /dev/hidraw0 at usb-1.2, admitted\n"
                                 "    missing: no permission; add the udev rule X\n"
                                 "keyboard 'Keys' /dev/hidraw1, not admitted\n"));
    free(text);
    struct event event = {.source = SOURCE_FAKE};
    struct device device;
    assert_true(sources_event(sources, &event) && event.kind == EVENT_ARRIVED);
    assert_true(sources_device(sources, &event, &device));
    assert_string_equal(device.name, "Knob");
    event.device = 77;
    assert_false(sources_device(sources, &event, &device));
    sources_destroy(sources);
    inputs_destroy(inputs);
}

struct say {
    struct event event;
    const char *device;
    const char *line, *binding; /* binding NULL: none */
};

#define CONTROL(origin, number, ...)                                                                                   \
    {                                                                                                                  \
        .kind = EVENT_CONTROL, .source = (origin), .control = (number), __VA_ARGS__                                    \
    }

static const struct say SAYS[] = {
    {CONTROL(SOURCE_HID, HID_USAGE(HID_PAGE_DESKTOP, 0x37), .relative = true, .value = -2), "Knob", "'Knob' Dial -2",
     "- {usage: Dial, controller: knob, turn: {coefficient: s_max, from: 0.1, to: 0.6}}"},
    {CONTROL(SOURCE_HID, HID_USAGE(HID_PAGE_DESKTOP, 0x37), .relative = true, .value = 1), "Knob", "'Knob' Dial +1",
     NULL},
    {CONTROL(SOURCE_HID, HID_USAGE(HID_PAGE_BUTTON, 3), .index = 1, .value = 1), "Pad",
     "'Pad' Button 3 (index 1) 1.000", "- {usage: Button 3, index: 1, drop: {}}"},
    {CONTROL(SOURCE_HID, HID_USAGE(HID_PAGE_DESKTOP, 0x39), .null = true), "Pad", "'Pad' Hat switch nowhere",
     "- {usage: Hat switch, cursor: {axis: both}}"},
    {CONTROL(SOURCE_HID, 0x000c00e9, .value = 1), "Pad", "'Pad' Consumer: Volume increment 1.000",
     "- {usage: 'Consumer: Volume increment', drop: {}}"},
    {CONTROL(SOURCE_HID, 0xff000001, .value = 0.25f), "Pad", "'Pad' page 0xff00 usage 0x0001 0.250", ""},
    {CONTROL(SOURCE_GPIO, 0, .value = 1), "chip", "'chip' red 1.000", "- {button: red, drop: {}}"},
    {CONTROL(SOURCE_GPIO, 1, .relative = true, .value = 1), "chip", "'chip' wheel +1",
     "- {encoder: wheel, turn: {coefficient: s_max, from: 0.1, to: 0.6}}"},
    {{.kind = EVENT_STANDING, .source = SOURCE_GPIO, .value = 1}, "chip", "'chip' red is on", NULL},
    {CONTROL(SOURCE_KEY, 30, .value = 1), "Keys", "'Keys' a 1.000", "- {key: a, controller: staff, next_ink: {}}"},
    {{.kind = EVENT_DOWN, .source = SOURCE_TOUCH, .slot = 2, .x = 0.5f, .y = 0.25f},
     "Panel",
     "'Panel' finger down 2 at 0.500, 0.250",
     "- {touch: press, drop: {}}"},
    {{.kind = EVENT_LEFT, .source = SOURCE_TOUCH}, "Panel", "'Panel' has left", NULL},
};

/* A binding that is printed can be pasted: it reads back as one. */
static void assert_valid(const char *binding)
{
    char text[1200];
    struct script_def def = script_default_def();
    struct report report;
    report_init(&report, "pasted");
    snprintf(text, sizeof text, "%sbindings:\n  %s\n", TEXT, binding);
    struct inputs *inputs = inputs_parse(text, strlen(text), ".", NULL, &def, &report);
    if (!inputs) {
        fail_msg("%s: %s", binding, report_text(&report));
    }
    assert_int_equal(inputs->written_count, 1);
    inputs_destroy(inputs);
    report_finish(&report);
}

static void what_is_watched_comes_with_a_binding_to_paste(void **state)
{
    (void)state;
    struct inputs *inputs = open_inputs();
    struct devices_seen seen = {.count = 0};
    for (size_t i = 0; i < sizeof SAYS / sizeof *SAYS; i++) {
        char text[DEVICES_LINE];
        const struct say *say = &SAYS[i];
        struct device device = {.vendor = 0x77d};
        device.product = strcmp(say->device, "Knob") == 0 ? 0x410 : 1;
        snprintf(device.name, sizeof device.name, "%s", say->device);
        assert_true(devices_event(&say->event, &device, inputs, text, sizeof text));
        assert_string_equal(text, say->line);
        bool bound = devices_binding(&say->event, &device, inputs, &seen, text, sizeof text);
        assert_int_equal(bound, say->binding != NULL);
        if (bound) {
            assert_valid(text);
        }
        if (bound && *say->binding) {
            assert_string_equal(text, say->binding);
        }
    }
    inputs_destroy(inputs);
}

static int count_of(const struct key *keys, const char *name)
{
    int count = 0;
    for (; keys->name; keys++) {
        count += strcmp(keys->name, name) == 0;
    }
    return count;
}

/* Whoever adds a class of devices hears here what it lacks. */
static void every_class_of_devices_is_whole(void **state)
{
    (void)state;
    struct inputs_tables memory;
    const struct inputs_table *tables = inputs_tables_of(&memory);
    int bindings = key_count(memory.bindings), count = 0;
    for (int i = 0; device_classes[i]; i++) {
        const struct device_class *class = device_classes[i];
        assert_true(class->source && class->noun && class->none && class->read && class->create);
        for (const struct key *key = class->sections; key->name; key++) {
            assert_int_equal(count_of(memory.top, key->name), 1);
        }
        for (const struct inputs_table *own = class->tables; own->name; own++) {
            count = 0;
            for (const struct inputs_table *table = tables; table->name; table++) {
                count += strcmp(table->name, own->name) == 0;
            }
            assert_int_equal(count, 1);
        }
        for (const struct binding_source *from = class->sources; from->key.name; from++) {
            struct event event = {.kind = EVENT_CONTROL, .source = from->source};
            assert_true(from->read && from->name && key_is_section(&from->key));
            assert_int_equal(!from->devices, !from->list);
            assert_int_equal(count_of(memory.bindings, from->key.name), 1);
            assert_true(action_find(from->key.name) == ACTION_VERBS); /* else a binding would not know which is meant */
            assert_true(!from->action || !from->action(&event) || strchr(from->action(&event), '{'));
        }
    }
    assert_int_equal(count_of(memory.top, "bindings"), 1); /* the last rows have found room */
    assert_int_equal(count_of(memory.bindings, "length"), 1);
    assert_true(bindings + ACTION_VERBS + DO_DIAL < INPUTS_ROWS); /* with the actions beside them */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_class_of_devices_is_whole),
        cmocka_unit_test(devices_are_listed_with_what_they_lack),
        cmocka_unit_test(what_is_watched_comes_with_a_binding_to_paste),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
