#include "exhibit.h"
#include "hid_report.h"
#include "inputs_read.h"
#include "key_rows.h"

static const char *const VISITORS[] = {"each", "shared", NULL};
static const char *const BIASES[] = {"as is", "none", "pull up", "pull down", NULL};
static const char *const MODES[] = {"absolute", "relative", "counter", NULL};
static const char *const TOUCHES[] = {"press", "tap", "long press", "drag", "two-finger drag", "pinch", NULL};
static const char *const WHENS[] = {"press", "release", "short", "long", "double", "hold", "move", NULL};
static const char *const WAYS[] = {"any", "up", "down", "left", "right", NULL};
static const char *const WHERES[] = {"there", "sheet", "along", NULL};
static const char *const CURVES[] = {"linear", "square", "exponential", NULL};
static const char *const ACROSS[] = {"x", "y", "both", NULL};
static const char *const PARAMETERS_OF_DROPS[] = {"radius", "solvent", "amount", NULL};

enum { ID_BYTES = 40, NAME_BYTES = 63 };


const struct key inputs_keys[] = {
    WHOLE("inputs", struct inputs, version, "", INPUTS_VERSION, INPUTS_VERSION, INPUTS_VERSION, true,
          "The version of the inputs file."),
    CHOICE("visitors", struct inputs, visitors, VISITORS, VISITORS_EACH, false,
           "Whether each finger and each controller has an ink of its own, or all paint in one."),
    SECTION("touch", "Touchscreens and mice."),
    SECTION("keyboards", "A list of the staff's keyboards; all others are ignored."),
    SECTION("controllers", "A list of HID controllers that bindings name, or whose reports want a map."),
    FLAG("other_controllers", struct inputs, others, 1, "Whether controllers that are not in the list may act."),
    SECTION("gpio", "Buttons, encoders and lamps on lines of the board."),
    SECTION("bindings", "What each of them does: a list of {source, condition, action}."),
    END,
};

const struct key touch_keys[] = {
    FLAG("touchscreens", struct inputs, touchscreens, 1, "Whether fingers on touchscreens act."),
    FLAG("pointers", struct inputs, pointers, 0, "Whether mice act, as one finger while a button is down."),
    END,
};

#define DEVICE                                                                                                         \
    TEXT("id", struct inputs_device, id, "a word", ID_BYTES, true, "What bindings call it."),                          \
        TEXT("vendor", struct inputs_device, name, "one to four digits of base 16", 6, false,                          \
             "USB vendor id, as lsusb and `frond devices` print it: 077d. Any if left out."),                          \
        TEXT("product", struct inputs_device, name, "one to four digits of base 16", 6, false,                         \
             "USB product id. Any if left out."),                                                                      \
        TEXT("name", struct inputs_device, name, "a part of the name", NAME_BYTES, false,                              \
             "A part of the name that the device gives itself. Any if left out.")

const struct key keyboard_keys[] = {DEVICE, END};
const struct key controller_keys[] = {
    DEVICE,
    FLAG("refuse", struct inputs_device, refuse, 0, "Whether it is never to act, whatever it is."),
    SECTION("map", "A list of what bits of its reports mean, where it does not say so itself."),
    SECTION("lights", "A list of its lamps."),
    END,
};

#define MAP struct inputs_map
const struct key map_keys[] = {
    TEXT("usage", MAP, usage_name, "a HID usage", NAME_BYTES, true, "What the bits become: Button 1, Dial, X."),
    WHOLE("report", MAP, report, "", 0, 255, 0, false, "Id of the report; 0 where reports have none."),
    WHOLE("bit", MAP, bit, "bits", 0, 65535, 0, true, "First bit, from the lowest of the first byte after the id."),
    WHOLE("bits", MAP, bits, "bits", 1, 32, 1, false, "How many."),
    FLAG("signed", MAP, is_signed, 0, "Whether the highest bit is a sign."),
    FLAG("centred", MAP, centred, 0, "Whether it rests in the middle of its range."),
    CHOICE("mode", MAP, mode, MODES, HID_MAP_ABSOLUTE, false,
           "A value, steps since the report before, or a counter that runs on."),
    WHOLE("min", MAP, min, "", -2147483647, 2147483647, 0, false,
          "Value at one end; with max 0 as well: all that the bits hold."),
    WHOLE("max", MAP, max, "", -2147483647, 2147483647, 0, false, "Value at the other end; below min it is turned."),
    END,
};

#define LIGHT struct inputs_light
const struct key light_keys[] = {
    TEXT("id", LIGHT, id, "a word", ID_BYTES, true, "What the log calls it."),
    TEXT("usage", LIGHT, usage_name, "a HID usage", NAME_BYTES, false,
         "The output that lights it, where the controller names one: `LED: Power`."),
    WHOLE("index", LIGHT, index, "", 0, 1023, 0, false, "Which of several outputs of that usage."),
    WHOLE("report", LIGHT, report, "", 0, 255, 0, false,
          "Without usage: id of the output report; 0 where they have none."),
    WHOLE("bit", LIGHT, bit, "bits", 0, 65535, 0, false, "Without usage: first bit, after the id."),
    WHOLE("bits", LIGHT, bits, "bits", 1, 32, 1, false, "Without usage: how many."),
    WHOLE("most", LIGHT, most, "", 0, 2147483647, 0, false, "Without usage: full brightness; 0: all bits."),
    TEXT("button", LIGHT, button_name, "a HID usage", NAME_BYTES, false,
         "The control of this controller whose presses light it: Button 1."),
    END,
};

const struct key gpio_keys[] = {
    SECTION("buttons", "A list of buttons."),
    SECTION("encoders", "A list of rotary encoders, each on two lines; a push button in it is a button."),
    SECTION("lamps", "A list of lamps."),
    END,
};

#define LINES    struct inputs_lines
#define LINES_ID TEXT("id", LINES, id, "a word", ID_BYTES, true, "What bindings call it.")
#define LINES_CHIP                                                                                                     \
    TEXT("chip", LINES, chip, "a label, name or path", NAME_BYTES, false,                                              \
         "Its chip, as `frond devices` prints it; any that has a line of the name if left out.")
#define LINES_BIAS(def)      CHOICE("bias", LINES, bias, BIASES, def, false, "Resistor of the board on the line.")
#define LINES_LOW(def, text) FLAG("active_low", LINES, active_low, def, text)
#define LINE_A(key, about)   TEXT(key, LINES, a.name, "a line\'s name or number", NAME_BYTES, true, about)
#define LINE_B(key, about)   TEXT(key, LINES, b.name, "a line\'s name or number", NAME_BYTES, true, about)

const struct key button_keys[] = {
    LINES_ID,
    LINES_CHIP,
    LINE_A("line", "Its line: a name, GPIO17, or with a chip a number."),
    LINES_BIAS(INPUTS_PULL_UP),
    LINES_LOW(1, "Whether it is pressed when the line is low: a button between the line and ground."),
    WHOLE("debounce", LINES, debounce, "ms", 0, 100, 5, false, "How long the contact may bounce."),
    END,
};
const struct key encoder_keys[] = {
    LINES_ID,
    LINES_CHIP,
    LINE_A("a", "Its first line."),
    LINE_B("b", "Its second line."),
    LINES_BIAS(INPUTS_PULL_UP),
    LINES_LOW(1, "Whether its contacts go to ground."),
    WHOLE("steps", LINES, steps, "changes a detent", 1, 4, 4, false, "1, 2 or 4."),
    FLAG("reversed", LINES, reversed, 0, "Whether it counts the other way."),
    END,
};
const struct key lamp_keys[] = {
    LINES_ID,
    LINES_CHIP,
    LINE_A("line", "Its line: a name, GPIO17, or with a chip a number."),
    LINES_LOW(0, "Whether it is lit when the line is low."),
    TEXT("button", LINES, button_id, "the id of a button", ID_BYTES, false, "The button whose presses light it."),
    END,
};

#define BINDING struct binding
const struct key binding_keys[] = {
    CHOICE("touch", BINDING, touch, TOUCHES, TOUCH_PRESS, false, "Source: what a finger does, or two of one hand."),
    CHOICE("tool", BINDING, tool, exhibit_tool_names, TOOL_DROP, false,
           "Condition, with touch: what the finger's visitor has chosen. A tool without bindings does what it usually "
           "does."),
    SECTION("usage", "Source: a control of a HID controller, by name (X, Dial, Button 3) or number (0x00090003)."),
    SECTION("button", "Source: a button on a GPIO line, by its id."),
    SECTION("encoder", "Source: a rotary encoder on GPIO lines, by its id."),
    SECTION("key", "Source: a key of a staff keyboard: a, 7, F1, space, enter."),
    SECTION("controller", "With usage or key: the id of the controller or keyboard; any that is admitted if left out."),
    WHOLE("index", BINDING, index, "", -1, 1023, -1, false,
          "With usage: which of several controls of that usage, from 0; -1 is any."),
    CHOICE("when", BINDING, when, WHENS, PRESS_DOWN, false,
           "Condition. An axis is pressed beyond half its way. Values follow `move` if it is left out."),
    WHOLE("ms", BINDING, ms, "ms", 1, INPUTS_MS_MAX, PRESS_LONG_MS, false,
          "Where short ends and long begins; for double 350, for hold 2000 if left out."),
    CHOICE("way", BINDING, way, WAYS, WAY_ANY, false, "The side of an axis or a hat, or the sense of a dial."),
    CHOICE("where", BINDING, where, WHERES, WHERE_THERE, false,
           "Where a verb without a place acts: at the finger or the cursor, on the whole sheet, or along what is "
           "drawn, for what else is a hand that lies there."),
    SECTION("length", "With release, short or long: how long it was held sets a parameter of the action."),
    END,
};

const struct key binding_do_keys[] = {
    SECTION("next_ink", "Action: the visitor's next ink."),
    SECTION("undo", "Action: takes back what this visitor did last."),
    SECTION("redo", "Action: does again what this visitor took back last."),
    SECTION("finish", "Action: the painting is finished: it is kept, and washed away."),
    SECTION("staff", "Action: the staff's view. A button that is on from the start, a key switch, has been pressed."),
    SECTION("next_tool", "Action: the visitor's next tool."),
    SECTION("next_scene", "Action: the next scene."),
    SECTION("next_language", "Action: the next language."),
    SECTION("next_picture", "Action: the next picture, in a scene of trees."),
    SECTION("next_metaphor", "Action: what grows becomes another kind, in a scene of trees."),
    SECTION("next_kind", "Action: the next kind of what grows, or the next preset, in a scene that is no painting."),
    SECTION("switch", "Action: the one button of one-switch play; pressed and let go."),
    SECTION("cursor", "Action: moves the controller's point on the sheet."),
    SECTION("turn", "Action: sets a coefficient, or how a scene grows or reacts, to where an axis or a dial stands."),
    SECTION("dial", "Action: sets a parameter of all drops to come to where an axis or a dial stands."),
    END,
};

#define AXIS(steps_def, smooth_def)                                                                                    \
    CHOICE("curve", BINDING, axis.curve, CURVES, AXIS_LINEAR, false, "How the way becomes the value."),                \
        NUMBER("dead_zone", BINDING, axis.dead, "share of the way", 0, 0.9, 0.05, false,                               \
               "How far from its rest an axis still counts as resting."),                                              \
        NUMBER("smooth", BINDING, axis.smooth_ms, "ms", 0, 5000, smooth_def, false, "How slowly the value follows."),  \
        NUMBER("steps", BINDING, axis.steps, "steps", 1, 10000, steps_def, false, "Of a dial, from end to end.")

const struct key turn_keys[] = {
    {"coefficient", KEY_COEFFICIENT, "", 0, 0, 0, NULL, offsetof(BINDING, coefficient), false,
     "The coefficient; one that is a number."},
    {"growth", KEY_GROWTH, "", 0, 0, 0, NULL, offsetof(BINDING, option), false,
     "Instead of it, in scenes of trees: an option of frond grow that is one value. Choices have a detent each."},
    {"lightning", KEY_STORM, "", 0, 0, 0, NULL, offsetof(BINDING, option), false,
     "Instead of it, in scenes of lightning: an option of theirs that is one value."},
    {"chemistry", KEY_DISH, "", 0, 0, 0, NULL, offsetof(BINDING, option), false,
     "Instead of it, in scenes of chemistry: an option of theirs that is one value."},
    NUMBER("from", BINDING, axis.from, "as what it turns", -10000, 100000, 0, false,
           "Its value at one end; the first, of choices, if left out."),
    NUMBER("to", BINDING, axis.to, "as what it turns", -10000, 100000, 1, false,
           "Its value at the other; the last, of choices, if left out."),
    AXIS(24, 80),
    END,
};
const struct key dial_keys[] = {
    CHOICE("parameter", BINDING, parameter, PARAMETERS_OF_DROPS, PARAMETER_RADIUS, true, "Of drops."),
    NUMBER("from", BINDING, axis.from, "as the parameter", 0, 1000, 0, true, "Its value at one end."),
    NUMBER("to", BINDING, axis.to, "as the parameter", 0, 1000, 1, true, "Its value at the other."),
    AXIS(24, 0),
    END,
};
const struct key cursor_keys[] = {
    CHOICE("axis", BINDING, across, ACROSS, 0, true, "The way it moves; both: a hat switch."),
    NUMBER("speed", BINDING, speed, "sheets a second", -10, 10, 0.4, false,
           "Of an axis that springs back, at its end; negative turns it round."),
    AXIS(100, 0),
    END,
};
const struct key length_keys[] = {
    CHOICE("parameter", struct inputs_length, parameter, PARAMETERS_OF_DROPS, PARAMETER_RADIUS, true,
           "The parameter that it sets."),
    NUMBER("from", struct inputs_length, from, "as the parameter", 0, 1000, 0, true, "For the shortest press."),
    NUMBER("to", struct inputs_length, to, "as the parameter", 0, 1000, 0, true, "After `ms` and more."),
    WHOLE("ms", struct inputs_length, ms, "ms", 1, INPUTS_MS_MAX, 1500, false, "How long the longest press is."),
    END,
};

const struct inputs_table inputs_tables[] = {
    {"inputs", "An inputs file in YAML: devices, and what they do.", inputs_keys},
    {"touch", "Touchscreens and mice.", touch_keys},
    {"keyboards", "A keyboard of the staff.", keyboard_keys},
    {"controllers", "A HID controller.", controller_keys},
    {"map", "What some bits of a controller's reports mean.", map_keys},
    {"lights", "A lamp of a controller.", light_keys},
    {"gpio", "What hangs on lines of the board.", gpio_keys},
    {"buttons", "A button on a GPIO line.", button_keys},
    {"encoders", "A rotary encoder on two GPIO lines.", encoder_keys},
    {"lamps", "A lamp on a GPIO line.", lamp_keys},
    {"bindings", "A binding: a source, a condition, and a verb of the script or one of the actions below.",
     binding_keys},
    {"do", "Actions of bindings beside the verbs.", binding_do_keys},
    {"turn", "Sets a coefficient, or how a scene grows or reacts.", turn_keys},
    {"dial", "Sets a parameter of drops.", dial_keys},
    {"cursor", "Moves a point on the sheet.", cursor_keys},
    {"length", "Press length to size.", length_keys},
    {.name = NULL},
};

bool inputs_is_section(const struct key *key)
{
    return key_is_section(key);
}
