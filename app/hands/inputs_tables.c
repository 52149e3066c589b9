#include "device_class.h"
#include "exhibit.h"
#include "file_rows.h"
#include "inputs_read.h"

static const char *const VISITORS[] = {"each", "shared", NULL};
static const char *const TOUCHES[] = {"press", "tap", "long press", "drag", "two-finger drag", "pinch", NULL};
static const char *const WHENS[] = {"press", "release", "short", "long", "double", "hold", "move", NULL};
static const char *const WAYS[] = {"any", "up", "down", "left", "right", NULL};
static const char *const WHERES[] = {"there", "sheet", "along", NULL};
static const char *const CURVES[] = {"linear", "square", "exponential", NULL};
static const char *const ACROSS[] = {"x", "y", "both", NULL};
static const char *const PARAMETERS_OF_DROPS[] = {"radius", "solvent", "amount", NULL};

/* What classes of devices have comes between these and `bindings`. */
static const struct key inputs_keys[] = {
    WHOLE("inputs", struct inputs, version, "", INPUTS_VERSION, INPUTS_VERSION, INPUTS_VERSION, true,
          "The version of the inputs file."),
    CHOICE("visitors", struct inputs, visitors, VISITORS, VISITORS_EACH, false,
           "Whether each finger and each controller has an ink of its own, or all paint in one."),
    END,
};
static const struct key inputs_last_keys[] = {
    SECTION("bindings", "What each of them does: a list of {source, condition, action}."),
    END,
};

#define BINDING struct binding
/* What bindings come from in classes of devices comes between these and the others. */
static const struct key binding_keys[] = {
    CHOICE("touch", BINDING, touch, TOUCHES, TOUCH_PRESS, false, "Source: what a finger does, or two of one hand."),
    CHOICE("tool", BINDING, tool, exhibit_tool_names, TOOL_DROP, false,
           "Condition, with touch: what the finger's visitor has chosen. A tool without bindings does what it usually "
           "does."),
    END,
};
static const struct key binding_last_keys[] = {
    SECTION("controller",
            "With a control of a device, as usage and key are: the device's id; any that is admitted if left out."),
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
    {"growth", KEY_OPTION, "", SCENE_TREES, SCENE_TREES, 0, NULL, offsetof(BINDING, option), false,
     "Instead of it, in scenes of trees: an option of frond grow that is one value. Choices have a detent each."},
    {"lightning", KEY_OPTION, "", SCENE_LIGHTNING, SCENE_LIGHTNING, 0, NULL, offsetof(BINDING, option), false,
     "Instead of it, in scenes of lightning: an option of theirs that is one value."},
    {"chemistry", KEY_OPTION, "", SCENE_CHEMISTRY, SCENE_CHEMISTRY, 0, NULL, offsetof(BINDING, option), false,
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

const struct key *inputs_drop_key(int parameter)
{
    return key_find(action_keys(ACTION_DROP), PARAMETERS_OF_DROPS[parameter]);
}

static int add_rows(struct key *rows, int count, const struct key *more)
{
    for (; more->name && count + 1 < INPUTS_ROWS; more++) {
        rows[count++] = *more;
    }
    rows[count] = (struct key){.name = NULL};
    return count;
}

void inputs_rows(struct key rows[INPUTS_ROWS])
{
    int count = add_rows(rows, 0, inputs_keys);
    for (int i = 0; device_classes[i]; i++) {
        count = add_rows(rows, count, device_classes[i]->sections);
    }
    add_rows(rows, count, inputs_last_keys);
}

void inputs_binding_rows(struct key rows[INPUTS_ROWS])
{
    int count = add_rows(rows, 0, binding_keys);
    for (int i = 0; device_classes[i]; i++) {
        for (const struct binding_source *from = device_classes[i]->sources; from->key.name; from++) {
            count = add_rows(rows, count, (struct key[]){from->key, END});
        }
    }
    add_rows(rows, count, binding_last_keys);
}

static int add_tables(struct inputs_table *tables, int count, const struct inputs_table *more)
{
    for (; more->name && count + 1 < INPUTS_TABLES; more++) {
        tables[count++] = *more;
    }
    tables[count] = (struct inputs_table){.name = NULL};
    return count;
}

const struct inputs_table *inputs_tables_of(struct inputs_tables *memory)
{
    const struct inputs_table first[] = {
        {"inputs", "An inputs file in YAML: devices, and what they do.", memory->top},
        {.name = NULL},
    };
    const struct inputs_table last[] = {
        {"bindings", "A binding: a source, a condition, and a verb of the script or one of the actions below.",
         memory->bindings},
        {"do", "Actions of bindings beside the verbs.", binding_do_keys},
        {"turn", "Sets a coefficient, or how a scene grows or reacts.", turn_keys},
        {"dial", "Sets a parameter of drops.", dial_keys},
        {"cursor", "Moves a point on the sheet.", cursor_keys},
        {"length", "Press length to size.", length_keys},
        {.name = NULL},
    };
    inputs_rows(memory->top);
    inputs_binding_rows(memory->bindings);
    int count = add_tables(memory->tables, 0, first);
    for (int i = 0; device_classes[i]; i++) {
        count = add_tables(memory->tables, count, device_classes[i]->tables);
    }
    add_tables(memory->tables, count, last);
    return memory->tables;
}
