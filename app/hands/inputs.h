/* Inputs: which devices an exhibit admits, what hangs on its GPIO lines, and what each of them does. YAML, version 1:
 *
 *     inputs: 1
 *     touch: {touchscreens: true, pointers: false}
 *     controllers:
 *       - {id: knob, vendor: 077d, product: 0410}
 *     gpio:
 *       buttons:
 *         - {id: red, line: GPIO17}
 *     bindings:
 *       - {touch: drag, brush_ink: {amount: 12}}
 *       - {usage: Dial, controller: knob, turn: {coefficient: s_max, from: 0.1, to: 0.6}}
 *       - {button: red, when: hold, ms: 3000, clear: {}}
 *
 * Read as scripts are: every value against its struct key, every problem with its place. */
#ifndef FROND_INPUTS_H
#define FROND_INPUTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "action.h"
#include "axis.h"
#include "event.h"
#include "press.h"
#include "report.h"
#include "script.h"

enum {
    INPUTS_VERSION = 1,
    INPUTS_KEYBOARDS = 8,
    INPUTS_CONTROLLERS = 16,
    INPUTS_MAP = 64,       /* entries of one controller */
    INPUTS_LINES = 32,     /* buttons, encoders, lamps: of each */
    INPUTS_WRITTEN = 128,  /* bindings of a file */
    INPUTS_BINDINGS = 192, /* with the default ones of tools that it has none for */
    INPUTS_MS_MAX = 60000,
    INPUTS_ID_BYTES = 40,
    INPUTS_NAME_BYTES = 63,
};

enum inputs_visitors {
    VISITORS_EACH,   /* every finger takes the next ink, every controller has one that next_ink changes */
    VISITORS_SHARED, /* all paint in one ink, which next_ink changes */
};

struct inputs_device {
    const char *id;           /* of a controller or keyboard, as bindings name it */
    uint16_t vendor, product; /* USB ids; 0: any */
    const char *name;         /* a part of its own name, case aside; NULL: any */
    bool refuse;              /* never admitted */
    struct inputs_map {
        uint32_t usage;
        const char *usage_name; /* as it was written */
        int report, bit, bits;
        bool is_signed, centred;
        int mode; /* enum hid_map_mode */
        int min, max;
    } * map;
    int map_count;
};

enum inputs_bias { INPUTS_AS_IS, INPUTS_NO_BIAS, INPUTS_PULL_UP, INPUTS_PULL_DOWN };

/* A line by its name, or by its number on its chip. */
struct inputs_line {
    const char *name; /* NULL: the number counts */
    int offset;
};

struct inputs_lines {        /* a button, an encoder or a lamp */
    const char *id, *chip;   /* chip NULL: any that has a line of this name */
    struct inputs_line a, b; /* b: of an encoder */
    int bias;                /* enum inputs_bias */
    bool active_low, reversed;
    int debounce;          /* ms */
    int steps;             /* changes of a line in a detent of an encoder */
    const char *button_id; /* lamp: the button that it lights */
    int button;            /* in buttons[]; -1: none */
};

/* A lamp of a controller: an output of its own usage, or bits of an output report. */
struct inputs_light {
    const char *id;
    int controller; /* in controllers[] */
    uint32_t usage; /* 0: the bits */
    const char *usage_name;
    int index, report, bit, bits;
    int most;        /* what is full brightness; 0: all bits */
    uint32_t button; /* the usage whose presses light it; 0: none */
    const char *button_name;
};

enum binding_touch { TOUCH_PRESS, TOUCH_TAP, TOUCH_LONG, TOUCH_DRAG, TOUCH_TWO, TOUCH_PINCH };
/* enum press_when, and: */
enum { BINDING_MOVE = PRESS_WHENS, BINDING_WHENS };
enum binding_way { WAY_ANY, WAY_UP, WAY_DOWN, WAY_LEFT, WAY_RIGHT };
enum binding_where { WHERE_THERE, WHERE_SHEET, WHERE_ALONG };
/* What happens once, wishes (enum wish_kind) among it, then what follows a value. */
enum binding_do {
    DO_VERB,
    DO_NEXT_INK,
    DO_UNDO,
    DO_REDO,
    DO_FINISH,
    DO_STAFF,
    DO_NEXT_TOOL,
    DO_NEXT_SCENE,
    DO_NEXT_LANGUAGE,
    DO_NEXT_PICTURE,
    DO_NEXT_METAPHOR,
    DO_NEXT_KIND,
    DO_SWITCH,
    DO_CURSOR,
    DO_TURN,
    DO_DIAL,
};
enum binding_parameter { PARAMETER_RADIUS, PARAMETER_SOLVENT, PARAMETER_AMOUNT, PARAMETERS };

struct binding {
    /* Where it comes from. */
    const struct binding_source *source; /* of device_class.h; NULL: what fingers do */
    int touch;                           /* enum binding_touch, of fingers */
    int tool;                            /* enum exhibit_tool: only of fingers that have it */
    uint32_t control;                    /* as in struct event */
    int device;                          /* among those of the source; -1: any */
    int index;                           /* HID: which of several of one usage; -1: any */
    /* When. */
    int when; /* enum press_when or BINDING_MOVE */
    int ms;
    uint32_t wait_ms; /* as in struct press_def */
    int way;
    /* What. */
    enum binding_do what;
    struct action action; /* DO_VERB: ink -1: the visitor's; without a place: where it happens */
    int where;            /* WHERE_SHEET: the verb is for the whole sheet unless it names a place; WHERE_ALONG: it
                             paints, although it could be a hand that lies there (ACTION_ATTRACT) */
    struct axis_def axis; /* of DO_TURN, DO_DIAL, DO_CURSOR */
    int coefficient;      /* DO_TURN, in scenes of paintings; -1: `option` */
    int scene;            /* DO_TURN: enum scene_kind that it is for */
    int option;           /* DO_TURN: in scene_options_keys(scene); -1: the coefficient */
    int parameter;        /* DO_DIAL: of drops to come */
    int across;           /* DO_CURSOR: 0 x, 1 y, 2 both: a hat */
    float speed;          /* DO_CURSOR: sheets a second at full deflection */
    /* Press length to size; only where `length` is given. */
    bool has_length;
    struct inputs_length {
        int parameter; /* enum binding_parameter */
        float from, to;
        int ms;
    } length;
};

static inline bool binding_follows(const struct binding *binding)
{
    return binding->what >= DO_CURSOR;
}

struct inputs {
    int version;
    bool touchscreens, pointers;
    bool others;  /* controllers that are not listed may act too */
    int visitors; /* enum inputs_visitors */
    struct inputs_device keyboards[INPUTS_KEYBOARDS], controllers[INPUTS_CONTROLLERS];
    int keyboard_count, controller_count;
    struct inputs_lines buttons[INPUTS_LINES], encoders[INPUTS_LINES], lamps[INPUTS_LINES];
    int button_count, encoder_count, lamp_count;
    struct inputs_light lights[INPUTS_LINES]; /* lamps of controllers; their numbers follow those of lamps[] */
    int light_count;
    struct binding bindings[INPUTS_BINDINGS];
    int binding_count, written_count; /* those that the file itself has come first */
    struct script *memory;            /* texts and rasters */
};

/* Reads a file or a text. `session`: the script whose inks and grid it is for; NULL: inks by any name. NULL comes back
 * when anything is wrong, and the report then has at least one problem. */
struct inputs *inputs_read(const char *path, const struct script *session, const struct script_def *def,
                           struct report *report);
struct inputs *inputs_parse(const char *text, size_t size, const char *folder, const struct script *session,
                            const struct script_def *def, struct report *report);
void inputs_destroy(struct inputs *inputs); /* takes NULL */
/* What counts where no file is given: fingers do what their tool is for, gamepads have a cursor, space mice and dials
 * turn coefficients, and in other scenes how they grow or react. A file without any touch binding for a tool has those
 * of the default for it, and one that turns nothing of a kind of scenes, paintings aside, has the default dials for
 * that. */
const char *inputs_default_text(void);
struct inputs *inputs_default(const struct script *session);
/* Whether a text means to be an inputs file: its top has the key `inputs`. */
bool inputs_is(const char *text, size_t size);
/* The parameter of drops, enum binding_parameter, as a key of action_keys(ACTION_DROP). */
const struct key *inputs_drop_key(int parameter);
/* Whether this is the device that is meant. */
bool inputs_match(const struct inputs_device *wanted, uint16_t vendor, uint16_t product, const char *name);

/* The tables behind it, with what they are called in `frond explain`. */
struct inputs_table {
    const char *name, *about;
    const struct key *keys;
};
enum { INPUTS_TABLES = 40, INPUTS_ROWS = 64 };
struct inputs_tables { /* what they are put together in */
    struct inputs_table tables[INPUTS_TABLES];
    struct key top[INPUTS_ROWS], bindings[INPUTS_ROWS];
};
/* The first of them; the last one's name is NULL. Good as long as `memory`. */
const struct inputs_table *inputs_tables_of(struct inputs_tables *memory);

#endif
