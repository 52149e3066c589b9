/* Inputs files: what they become, and word for word what is said of bad ones (app/inputs.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "device_class.h"
#include "exhibit.h"
#include "inputs.h"
#include "near.h"
#include "script_case.h"

#define INPUTS_KEYS "inputs, visitors, touch, keyboards, controllers, other_controllers, gpio, bindings"
#define GROWTHS                                                                                                        \
    "one of metaphor, tree, metric, emphasis, endpoints, seed, plant, gradient, intensity, blur, light, base, "        \
    "picture, random, upward, sideways, smooth, jitter, tip, gain, power, window, branch, step, trunk, mix, leaves, "  \
    "tendrils, needles, iterations, primary, layers, side, radius, spacing, crown, fork"
#define USAGES "a HID usage by name (X, Dial, Button 3) or number (0x00090003)"

static const struct script_case BAD[] = {
    {"empty", BYTES(""), "s.yaml:1:1: the file is empty; inputs: 1, and a list of bindings\n"},
    {"a list", BYTES("- 1\n"), "s.yaml:1:1: a list where inputs should be; inputs: 1, and a list of bindings\n"},
    {"no version", BYTES("bindings: []\n"), "s.yaml:1:1: inputs: missing; only 1\n"},
    {"another version", BYTES("inputs: 2\n"), "s.yaml:1:9: inputs: 2 is out of range; only 1\n"},
    {"unknown section", BYTES("inputs: 1\nbinding: []\n"),
     "s.yaml:2:1: binding: unknown key; did you mean bindings? One of " INPUTS_KEYS "\n"},
    {"visitors", BYTES("inputs: 1\nvisitors: share\n"),
     "s.yaml:2:11: visitors: unknown choice 'share'; did you mean shared? One of each, shared\n"},
    {"touch a word", BYTES("inputs: 1\ntouch: all\n"),
     "s.yaml:2:8: touch: 'all'; {touchscreens: true, pointers: false}\n"},
    {"touch's key", BYTES("inputs: 1\ntouch: {pointer: true}\n"),
     "s.yaml:2:9: touch.pointer: unknown key; did you mean pointers? One of touchscreens, pointers\n"},
    {"a controller of nobody", BYTES("inputs: 1\ncontrollers: [{id: a}]\n"),
     "s.yaml:2:15: controllers[0]: any device would be it; vendor, product or a part of its name\n"},
    {"a vendor", BYTES("inputs: 1\ncontrollers: [{id: a, vendor: 12345}]\n"),
     "s.yaml:2:15: controllers[0]: any device would be it; vendor, product or a part of its name\n"
     "s.yaml:2:31: controllers[0].vendor: '12345' is no USB id; one to four digits of base 16, 077d\n"},
    {"an id twice", BYTES("inputs: 1\ncontrollers: [{id: a, name: x}, {id: a, name: y}]\n"),
     "s.yaml:2:38: controllers[1].id: 'a' is there already; another word\n"},
    {"a map", BYTES("inputs: 1\ncontrollers: [{id: a, name: x, map: [{usage: Buton 1}]}]\n"),
     "s.yaml:2:38: controllers[0].map[0].bit: missing; 0 to 65535 bits\n"
     "s.yaml:2:46: controllers[0].map[0].usage: unknown usage 'Buton 1'; " USAGES "\n"},
    {"a number without its chip", BYTES("inputs: 1\ngpio: {buttons: [{id: a, line: 17}]}\n"),
     "s.yaml:2:32: gpio.buttons[0].line: the number of a line on no chip; chip: LABEL beside it, or the line's name\n"},
    {"debounce", BYTES("inputs: 1\ngpio: {buttons: [{id: a, line: GPIO1, debounce: 101}]}\n"),
     "s.yaml:2:49: gpio.buttons[0].debounce: 101 is out of range; 0 to 100 ms\n"},
    {"three steps", BYTES("inputs: 1\ngpio: {encoders: [{id: a, a: GPIO1, b: GPIO2, steps: 3}]}\n"),
     "s.yaml:2:54: gpio.encoders[0].steps: 3 is not it; 1, 2 or 4 changes a detent\n"},
    {"a lamp of no button", BYTES("inputs: 1\ngpio: {lamps: [{id: a, line: GPIO1, button: red}]}\n"),
     "s.yaml:2:45: gpio.lamps[0].button: unknown button 'red'; there are none in gpio.buttons\n"},
    {"no source", BYTES("inputs: 1\nbindings:\n  - {drop: {}}\n"),
     "s.yaml:3:5: bindings[0]: no source is given; one of touch, key, usage, button, encoder\n"},
    {"no action", BYTES("inputs: 1\nbindings:\n  - {touch: tap}\n"),
     "s.yaml:3:5: bindings[0]: no action is given; one of " VERBS ", next_ink, finish, staff, next_tool, next_scene, "
     "next_language, next_picture, next_metaphor, next_kind, switch, cursor, turn, dial\n"},
    {"two sources", BYTES("inputs: 1\nbindings:\n  - {touch: tap, usage: X, drop: {}}\n"),
     "s.yaml:3:25: bindings[0].usage: a second source, after touch; a binding has one\n"},
    {"two actions", BYTES("inputs: 1\nbindings:\n  - {touch: tap, drop: {}, clear: {}}\n"),
     "s.yaml:3:35: bindings[0].clear: a second action, after drop; a binding has one\n"},
    {"a gesture", BYTES("inputs: 1\nbindings:\n  - {touch: drg, drop: {}}\n"),
     "s.yaml:3:13: bindings[0].touch: unknown choice 'drg'; did you mean drag? One of press, tap, long press, drag, "
     "two-finger drag, pinch\n"},
    {"a usage", BYTES("inputs: 1\nbindings:\n  - {usage: Knob, drop: {}}\n"),
     "s.yaml:3:13: bindings[0].usage: unknown usage 'Knob'; " USAGES "\n"},
    {"a controller",
     BYTES("inputs: 1\ncontrollers: [{id: knob, name: x}]\nbindings:\n"
           "  - {usage: X, controller: knop, drop: {}}\n"),
     "s.yaml:4:28: bindings[0].controller: unknown controller 'knop'; did you mean knob? One of knob\n"},
    {"a controller with a long name",
     BYTES("inputs: 1\ncontrollers: [{id: the-knob-on-the-left-of-the-window, name: x}]\nbindings:\n"
           "  - {usage: X, controller: knop, drop: {}}\n"),
     "s.yaml:4:28: bindings[0].controller: unknown controller 'knop'; one of the-knob-on-the-left-of-the-window\n"},
    {"a button", BYTES("inputs: 1\nbindings:\n  - {button: red, drop: {}}\n"),
     "s.yaml:3:14: bindings[0].button: unknown button 'red'; there are none in gpio.buttons\n"},
    {"a key without its keyboard", BYTES("inputs: 1\nbindings:\n  - {key: a, drop: {}}\n"),
     "s.yaml:3:11: bindings[0].key: no keyboard is admitted; keyboards: [{id: WORD, vendor: ID, product: ID}]\n"},
    {"a key", BYTES("inputs: 1\nkeyboards: [{id: s, name: x}]\nbindings:\n  - {key: F13, drop: {}}\n"),
     "s.yaml:4:11: bindings[0].key: unknown key 'F13'; a to z, 0 to 9, F1 to F12, space, enter, escape, left, ...\n"},
    {"a condition", BYTES("inputs: 1\nbindings:\n  - {touch: tap, when: hold, drop: {}}\n"),
     "s.yaml:3:24: bindings[0].when: goes with touch: press alone; the others are conditions themselves\n"},
    {"an encoder pressed",
     BYTES("inputs: 1\ngpio: {encoders: [{id: w, a: GPIO1, b: GPIO2}]}\nbindings:\n"
           "  - {encoder: w, when: hold, drop: {}}\n"),
     "s.yaml:4:24: bindings[0].when: an encoder is turned, not pressed; move, or a button for its push button\n"},
    {"a range", BYTES("inputs: 1\nbindings:\n  - {usage: X, turn: {coefficient: s_max, from: 0, to: 3}}\n"),
     "s.yaml:3:56: bindings[0].turn.to: 3 is out of range; 0 to 1.5 density per cell\n"},
    {"a choice turned", BYTES("inputs: 1\nbindings:\n  - {usage: X, turn: {coefficient: noise, from: 0, to: 1}}\n"),
     "s.yaml:3:36: bindings[0].turn.coefficient: noise is no number; set chooses it\n"},
    {"turn without an end", BYTES("inputs: 1\nbindings:\n  - {usage: X, turn: {coefficient: s_max, from: 0}}\n"),
     "s.yaml:3:22: bindings[0].turn.to: missing; 0 to 1.5 density per cell\n"},
    {"turn of nothing", BYTES("inputs: 1\nbindings:\n  - {usage: X, turn: {from: 0, to: 1}}\n"),
     "s.yaml:3:22: bindings[0].turn.coefficient: missing; the name of a coefficient, or of an option: growth, "
     "lightning or chemistry\n"},
    {"turn of two things",
     BYTES("inputs: 1\nbindings:\n  - {usage: X, turn: {coefficient: s_max, growth: gain, from: 0, to: 1}}\n"),
     "s.yaml:3:51: bindings[0].turn.growth: a coefficient is given too; one of the two\n"},
    {"turn of two scenes",
     BYTES("inputs: 1\nbindings:\n  - {usage: X, turn: {chemistry: feed, lightning: eta, from: 0, to: 0.1}}\n"),
     "s.yaml:3:34: bindings[0].turn.chemistry: an option: lightning is given too; one of the two\n"},
    {"turn of lightning too far",
     BYTES("inputs: 1\nbindings:\n  - {usage: X, turn: {lightning: eta, from: 0, to: 50}}\n"),
     "s.yaml:3:52: bindings[0].turn.to: 50 is out of range; 0 to 20\n"},
    {"turn without the end of a rate",
     BYTES("inputs: 1\nbindings:\n  - {usage: X, turn: {chemistry: feed, from: 0.01}}\n"),
     "s.yaml:3:22: bindings[0].turn.to: missing; 0 to 0.15 per unit of time\n"},
    {"along what has no path", BYTES("inputs: 1\nbindings:\n  - {touch: drag, where: along, strike: {}}\n"),
     "s.yaml:3:26: bindings[0].where: the action has no path; there or sheet\n"},
    {"turn of growth", BYTES("inputs: 1\nbindings:\n  - {usage: X, turn: {growth: gian, from: 0, to: 1}}\n"),
     "s.yaml:3:31: bindings[0].turn.growth: unknown option 'gian'; " GROWTHS "\n"},
    {"turn of growth too far", BYTES("inputs: 1\nbindings:\n  - {usage: X, turn: {growth: gain, from: 0, to: 17}}\n"),
     "s.yaml:3:50: bindings[0].turn.to: 17 is out of range; 0 to 16 pixels\n"},
    {"turn of a place", BYTES("inputs: 1\nbindings:\n  - {usage: X, turn: {growth: fork, from: 0, to: 1}}\n"),
     "s.yaml:3:31: bindings[0].turn.growth: fork is no single value; another option of trees\n"},
    {"length of what is not over",
     BYTES("inputs: 1\nbindings:\n  - {touch: press, drop: {}, "
           "length: {parameter: radius, from: 4, to: 9}}\n"),
     "s.yaml:3:38: bindings[0].length: the length of a press is known when it is over; when: release, short or long\n"},
    {"length of nothing",
     BYTES("inputs: 1\nbindings:\n  - {touch: press, when: long, clear: {}, "
           "length: {parameter: radius, from: 4, to: 9}}\n"),
     "s.yaml:3:51: bindings[0].length: the action has no radius; a verb that has one\n"},
    {"a long path",
     BYTES("inputs: 1\nbindings:\n  - {touch: tap, draw: {path: [[0, 0], [0, 0], [0, 0], [0, 0], [0, 0], "
           "[0, 0], [0, 0], [0, 0], [0, 0]]}}\n"),
     "s.yaml:3:31: bindings[0].draw.path: a path of 9 points; at most 8 in a binding\n"},
    {"a tool", BYTES("inputs: 1\nbindings:\n  - {touch: tap, tool: musk, drop: {}}\n"),
     "s.yaml:3:24: bindings[0].tool: unknown choice 'musk'; did you mean mask? One of drop, brush, guide, pour, mask, "
     "rewind, plant, tend, thin, strike, repel, stroke, dose, erase, map\n"},
    {"a tool of no finger", BYTES("inputs: 1\nbindings:\n  - {usage: Button 1, tool: brush, drop: {}}\n"),
     "s.yaml:3:29: bindings[0].tool: goes with touch, not with usage; fingers have tools\n"},
    {"a tool of a key without its keyboard", BYTES("inputs: 1\nbindings:\n  - {key: F9, tool: brush, finish: {}}\n"),
     "s.yaml:3:11: bindings[0].key: no keyboard is admitted; keyboards: [{id: WORD, vendor: ID, product: ID}]\n"
     "s.yaml:3:21: bindings[0].tool: goes with touch, not with key; fingers have tools\n"},
    {"a tool that is a list", BYTES("inputs: 1\nbindings:\n  - {touch: tap, tool: [brush, guide], drop: {}}\n"),
     "s.yaml:3:24: bindings[0].tool: a list where a name should be; one of drop, brush, guide, pour, mask, rewind, "
     "plant, tend, thin, strike, repel, stroke, dose, erase, map\n"},
    {"a switch that is dragged", BYTES("inputs: 1\nbindings:\n  - {touch: drag, switch: {}}\n"),
     "s.yaml:3:27: bindings[0].switch: goes down and comes up; touch: press, a usage, a button or a key\n"},
    {"a switch that is tapped", BYTES("inputs: 1\nbindings:\n  - {touch: tap, switch: {}}\n"),
     "s.yaml:3:26: bindings[0].switch: goes down and comes up; touch: press, a usage, a button or a key\n"},
    {"a switch with a condition", BYTES("inputs: 1\nbindings:\n  - {touch: press, when: long, switch: {}}\n"),
     "s.yaml:3:40: bindings[0].switch: is told of every press and its end; without when\n"},
    {"a switch that moves", BYTES("inputs: 1\nbindings:\n  - {usage: Dial, when: move, switch: {}}\n"),
     "s.yaml:3:39: bindings[0].switch: is told of every press and its end; without when\n"},
    {"redo of what", BYTES("inputs: 1\nbindings:\n  - {touch: tap, redo: {steps: 2}}\n"),
     "s.yaml:3:25: bindings[0].redo.steps: unknown key; it takes none\n"},
    {"finish what", BYTES("inputs: 1\nbindings:\n  - {touch: tap, finish: now}\n"),
     "s.yaml:3:26: bindings[0].finish: 'now'; a mapping: {parameter: value, ...}, or {}\n"},
    {"staff twice", BYTES("inputs: 1\nbindings:\n  - {touch: tap, staff: {}, next_scene: {}}\n"),
     "s.yaml:3:41: bindings[0].next_scene: a second action, after staff; a binding has one\n"},
    {"a language", BYTES("inputs: 1\nbindings:\n  - {usage: Button 1, next_language: fr}\n"),
     "s.yaml:3:38: bindings[0].next_language: 'fr'; a mapping: {parameter: value, ...}, or {}\n"},
    {"a switch that is turned",
     BYTES("inputs: 1\ngpio: {encoders: [{id: w, a: GPIO1, b: GPIO2}]}\nbindings:\n  - {encoder: w, switch: {}}\n"),
     "s.yaml:4:26: bindings[0].switch: goes down and comes up; touch: press, a usage, a button or a key\n"},
    {"a lamp nowhere", BYTES("inputs: 1\ncontrollers: [{id: a, name: x, lights: [{id: l, bits: 4}]}]\n"),
     "s.yaml:2:41: controllers[0].lights[0]: nothing says where it is; usage, or bit: its first bit in the output "
     "report\n"},
    {"a lamp in two places",
     BYTES("inputs: 1\ncontrollers: [{id: a, name: x, lights: [{id: l, bit: 4, usage: 'LED: Power'}]}]\n"),
     "s.yaml:2:54: controllers[0].lights[0]: usage says where it is already; one of both\n"},
    {"a lamp of no usage",
     BYTES("inputs: 1\ncontrollers: [{id: a, name: x, lights: [{id: l, usage: Lamp, button: 3}]}]\n"),
     "s.yaml:2:56: controllers[0].lights[0].usage: unknown usage 'Lamp'; a HID usage by name (X, Dial, Button 3) or "
     "number (0x00090003)\n"
     "s.yaml:2:70: controllers[0].lights[0].button: unknown usage '3'; a HID usage by name (X, Dial, Button 3) or "
     "number (0x00090003)\n"},
    {"a lamp of no list", BYTES("inputs: 1\ncontrollers: [{id: a, name: x, lights: yes}]\n"),
     "s.yaml:2:40: controllers[0].lights: 'yes'; a list of {id: WORD, usage: NAME, ...}\n"},
    {"a lamp of a keyboard", BYTES("inputs: 1\nkeyboards: [{id: a, name: x, lights: []}]\n"),
     "s.yaml:2:30: keyboards[0].lights: unknown key; one of id, vendor, product, name\n"},
    {"a lamp in a word", BYTES("inputs: 1\ncontrollers: [{id: a, name: x, lights: [on]}]\n"),
     "s.yaml:2:41: controllers[0].lights[0]: 'on'; {id: WORD, usage: NAME, ...} or {id: WORD, bit: N, bits: N, ...}\n"},
    {"an ink", BYTES("inputs: 1\nbindings:\n  - {touch: tap, drop: {ink: ochr}}\n"),
     "s.yaml:3:30: bindings[0].drop.ink: unknown ink 'ochr'; did you mean ochre? One of " INKS "\n"},
};

static void bad_files_are_told_word_for_word(void **state)
{
    (void)state;
    struct script_def def = script_default_def();
    for (size_t i = 0; i < sizeof BAD / sizeof *BAD; i++) {
        struct report report;
        report_init(&report, "s.yaml");
        struct inputs *inputs = inputs_parse(BAD[i].text, BAD[i].size, ".", NULL, &def, &report);
        char *text = report_text(&report);
        if (inputs || !text || strcmp(text, BAD[i].expected) != 0) {
            fail_msg("%s:\nexpected:\n%sfound:\n%s", BAD[i].name, BAD[i].expected, text ? text : "nothing");
        }
        free(text);
        inputs_destroy(inputs);
        report_finish(&report);
    }
}

static struct inputs *parse(const char *text, const struct script *session)
{
    struct script_def def = script_default_def();
    struct report report;
    report_init(&report, "s.yaml");
    struct inputs *inputs = inputs_parse(text, strlen(text), ".", session, &def, &report);
    char *problems = report_text(&report);
    if (!inputs) {
        fail_msg("%s", problems);
    }
    free(problems);
    report_finish(&report);
    return inputs;
}

static void a_file_becomes_what_it_says(void **state)
{
    (void)state;
    struct inputs *inputs =
        parse("inputs: 1\n"
              "visitors: shared\n"
              "touch: {pointers: true}\n"
              "other_controllers: false\n"
              "controllers:\n"
              "  - {id: knob, vendor: 077d, product: 0x0410, map: [{usage: Dial, bit: 9, bits: 7}]}\n"
              "gpio:\n"
              "  buttons: [{id: red, chip: soc, line: 17, bias: none, active_low: false}]\n"
              "  encoders: [{id: w, a: GPIO1, b: GPIO2}]\n"
              "  lamps: [{id: l, line: GPIO9, button: red}]\n"
              "bindings:\n"
              "  - {usage: '0x00010037', controller: knob, index: 2, dial: {parameter: amount, from: "
              "9, to: 1}}\n"
              "  - {button: red, when: short, clear: {}}\n"
              "  - {button: red, when: double, ms: 500, dry: {}}\n"
              "  - {encoder: w, drop: {}}\n"
              "  - {touch: long press, set: {coefficient: k, value: 3}, where: there}\n",
              NULL);
    assert_true(inputs->visitors == VISITORS_SHARED && inputs->touchscreens && inputs->pointers && !inputs->others);
    assert_int_equal(inputs->controllers[0].vendor, 0x077d);
    assert_int_equal(inputs->controllers[0].product, 0x0410);
    assert_int_equal(inputs->controllers[0].map[0].usage, 0x00010037);
    assert_int_equal(inputs->controllers[0].map[0].bits, 7);
    assert_true(!inputs->buttons[0].a.name && inputs->buttons[0].a.offset == 17);
    assert_true(inputs->buttons[0].bias == INPUTS_NO_BIAS && !inputs->buttons[0].active_low);
    assert_true(inputs->encoders[0].bias == INPUTS_PULL_UP && inputs->encoders[0].steps == 4);
    assert_int_equal(inputs->lamps[0].button, 0);
    const struct binding *bindings = inputs->bindings;
    assert_true(bindings[0].control == 0x00010037 && bindings[0].device == 0 && bindings[0].index == 2);
    assert_true(bindings[0].when == BINDING_MOVE && bindings[0].what == DO_DIAL);
    assert_true(bindings[1].when == PRESS_SHORT && bindings[1].ms == PRESS_LONG_MS && bindings[1].wait_ms == 500);
    assert_true(bindings[2].where == WHERE_SHEET && bindings[2].ms == 500);
    assert_true(bindings[3].source->turned && bindings[3].control == 1); /* after the only button */
    assert_true(bindings[4].when == PRESS_HOLD && bindings[4].where == WHERE_THERE);
    assert_int_equal(inputs->written_count, 5);
    inputs_destroy(inputs);
}

static int count_touches(const struct inputs *inputs, enum exhibit_tool tool)
{
    int count = 0;
    for (int i = 0; i < inputs->binding_count; i++) {
        count += !inputs->bindings[i].source && inputs->bindings[i].tool == (int)tool;
    }
    return count;
}

static void tools_without_a_binding_have_the_default_ones(void **state)
{
    (void)state;
    struct inputs *whole = inputs_default(NULL);
    assert_int_equal(whole->written_count, whole->binding_count);
    struct inputs *inputs =
        parse("inputs: 1\n"
              "bindings:\n"
              "  - {usage: Button 1, drop: {}, when: release, length: {parameter: radius, from: 4, to: 9}}\n"
              "  - {touch: tap, tool: brush, clear: {}}\n",
              NULL);
    assert_int_equal(inputs->written_count, 2);
    for (int tool = 0; tool < TOOLS; tool++) {
        int expected = tool == TOOL_BRUSH ? 1 : count_touches(whole, (enum exhibit_tool)tool);
        assert_int_equal(count_touches(inputs, (enum exhibit_tool)tool), expected);
        assert_true(expected > 0);
    }
    for (int i = 2; i < inputs->binding_count; i++) {
        const struct binding *binding = &inputs->bindings[i];
        assert_true(!binding->source || (binding->what == DO_TURN && binding->option >= 0));
        assert_false(binding->has_length);
    }
    inputs_destroy(inputs);
    inputs_destroy(whole);
}

static int count_dials(const struct inputs *inputs, enum scene_kind kind)
{
    int count = 0;
    for (int i = 0; i < inputs->binding_count; i++) {
        count += inputs->bindings[i].what == DO_TURN && inputs->bindings[i].scene == (int)kind;
    }
    return count;
}

static void growth_is_turned_by_the_default_dials_or_by_those_of_a_file(void **state)
{
    (void)state;
    struct inputs *inputs =
        parse("inputs: 1\nbindings: [{usage: Dial, turn: {coefficient: k, from: 1, to: 2}}]\n", NULL);
    assert_int_equal(count_dials(inputs, SCENE_PAINTING), 1);
    for (int kind = SCENE_PAINTING + 1; kind < SCENE_KINDS; kind++) {
        assert_int_equal(count_dials(inputs, (enum scene_kind)kind), 3);
    }
    assert_true(inputs->bindings[0].option == -1);
    inputs_destroy(inputs);
    inputs = parse("inputs: 1\n"
                   "bindings:\n"
                   "  - {usage: Dial, turn: {growth: gain, from: 0.4, to: 4}}\n"
                   "  - {usage: Wheel, turn: {growth: metaphor}}\n"
                   "  - {usage: Wheel, turn: {growth: metric, from: 3, to: 1, steps: 8}}\n"
                   "  - {usage: Wheel, turn: {growth: light}}\n",
                   NULL);
    assert_int_equal(count_dials(inputs, SCENE_TREES), 4);
    assert_int_equal(count_dials(inputs, SCENE_CHEMISTRY), 3);
    const struct binding *bindings = inputs->bindings;
    assert_string_equal(growth_keys[bindings[0].option].name, "gain");
    assert_true(bindings[0].coefficient == -1 && bindings[0].axis.steps == 24);
    assert_true(bindings[1].axis.from == 0 && bindings[1].axis.to == METAPHORS - 1); /* a detent each */
    assert_true(bindings[1].axis.steps == METAPHORS - 1 && bindings[1].axis.smooth_ms == 0);
    assert_true(bindings[2].axis.from == 3 && bindings[2].axis.to == 1 && bindings[2].axis.steps == 8);
    assert_true(bindings[3].axis.to == 1 && bindings[3].axis.steps == 1);
    inputs_destroy(inputs);
}

static void as_many_bindings_as_a_file_may_have(void **state)
{
    (void)state;
    static char text[INPUTS_WRITTEN * 64];
    struct script_def def = script_default_def();
    struct report report;
    for (int most = INPUTS_WRITTEN; most <= INPUTS_WRITTEN + 1; most++) {
        int length = snprintf(text, sizeof text, "inputs: 1\nbindings:\n");
        for (int i = 0; i < most; i++) {
            length += snprintf(text + length, sizeof text - (size_t)length, "  - {usage: Button 1, drop: {}}\n");
        }
        report_init(&report, "s.yaml");
        struct inputs *inputs = inputs_parse(text, (size_t)length, ".", NULL, &def, &report);
        char *problems = report_text(&report);
        if (most == INPUTS_WRITTEN) {
            assert_int_equal(inputs->written_count, most);
            assert_true(count_touches(inputs, TOOL_REWIND) > 0); /* the default ones have room of their own */
        } else {
            assert_null(inputs);
            assert_string_equal(problems, "s.yaml:3:3: bindings: a list of 129; at most 128\n");
        }
        free(problems);
        report_finish(&report);
        inputs_destroy(inputs);
    }
}

static void inks_are_the_sessions(void **state)
{
    (void)state;
    static const char SESSION[] = "frond: 1\ninks: [cyan, ochre]\n";
    struct script_def def = script_default_def();
    struct report report;
    report_init(&report, "session");
    struct script *session = script_parse(SESSION, strlen(SESSION), ".", &def, &report);
    struct inputs *inputs =
        parse("inputs: 1\nbindings: [{touch: tap, drop: {ink: ochre}}, {touch: tap, drop: {}}]\n", session);
    assert_int_equal(inputs->bindings[0].action.ink, 1);
    assert_int_equal(inputs->bindings[1].action.ink, -1);
    inputs_destroy(inputs);
    static const char OTHER[] = "inputs: 1\nbindings: [{touch: tap, drop: {ink: black}}]\n";
    assert_null(inputs_parse(OTHER, strlen(OTHER), ".", session, &def, &report));
    char *text = report_text(&report);
    assert_string_equal(
        text, "session:2:37: bindings[0].drop.ink: 'black' is not among the session's inks; one of cyan, ochre\n");
    free(text);
    script_destroy(session);
    report_finish(&report);
}

static void the_default_is_valid(void **state)
{
    (void)state;
    struct inputs *inputs = inputs_default(NULL);
    assert_non_null(inputs);
    assert_true(inputs->binding_count > 10 && inputs->others && inputs->touchscreens && inputs->keyboard_count == 0);
    inputs_destroy(inputs);
    assert_true(inputs_is(inputs_default_text(), strlen(inputs_default_text())));
    assert_false(inputs_is("frond: 1\n", 9));
    assert_false(inputs_is("[1", 2));
}

static void names_match_in_parts_case_aside(void **state)
{
    (void)state;
    struct inputs_device wanted = {.vendor = 0x046d, .name = "space"};
    assert_true(inputs_match(&wanted, 0x046d, 1, "3Dconnexion SpaceMouse"));
    assert_false(inputs_match(&wanted, 0x046e, 1, "3Dconnexion SpaceMouse"));
    assert_false(inputs_match(&wanted, 0x046d, 1, "3Dconnexion spac"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_files_are_told_word_for_word),
        cmocka_unit_test(a_file_becomes_what_it_says),
        cmocka_unit_test(tools_without_a_binding_have_the_default_ones),
        cmocka_unit_test(growth_is_turned_by_the_default_dials_or_by_those_of_a_file),
        cmocka_unit_test(as_many_bindings_as_a_file_may_have),
        cmocka_unit_test(inks_are_the_sessions),
        cmocka_unit_test(the_default_is_valid),
        cmocka_unit_test(names_match_in_parts_case_aside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
