/* What can be done to a painting: the closed vocabulary that scripts, journals and bindings share.
 * Positions are in 0..1 of the sheet (x right, y down), radii in cells, amounts in density per cell, ticks in frames.
 * Each verb has a table of its parameters (unit, range, default, meaning) over `struct action`. */
#ifndef FROND_ACTION_H
#define FROND_ACTION_H

#include <stdint.h>

#include "key.h"
#include "verbs.h"

struct point {
    float x, y;
};

struct action_path {
    const struct point *points; /* owned by whoever made the action */
    int count;                  /* 0: no path */
};

/* Values over the whole sheet, row-major, sampled bilinearly and clamped at the border. Made by whoever can read
 * formulas and pictures; owned by them. A picture gives linear brightness in 0..1 (1 channel) or, as a vector field,
 * components in -1..1 (2 channels). */
struct action_raster {
    const float *values; /* NULL: none. channels * width * height, channel by channel */
    int width, height;
    int channels; /* 1, or 2 for a vector field (x right, y down) */
};

#define VERB(NAME, name) ACTION_##NAME,
enum action_verb { ACTION_VERB_LIST(VERB) ACTION_VERBS };
#undef VERB

enum action_edge {
    EDGE_HARD,   /* a disc, as in the paper */
    EDGE_SOFT,   /* fades over four cells (section 6.3.3 names this as wanted) */
    EDGE_RAGGED, /* the liquid is a disc, the growth starts from a torn small seed: no flat dot in the middle */
};

enum action_over {
    OVER_RESPECT, /* growth keeps clear of the line */
    OVER_RUN,     /* growth runs over it */
};

enum action_reading {                    /* how a picture becomes a vector field */
                      READ_TOWARDS_DARK, /* along the gradient of darkness */
                      READ_ALONG_EDGES,  /* across it */
                      READ_VECTORS,      /* red and green are x and y, one half is zero */
};

struct action {
    int64_t tick;
    enum action_verb verb;
    int visitor; /* who does it: 0 nobody or the script, 1.. a visitor; undo and redo of 0: whoever acted last */
    struct point at;
    struct point flow; /* where water runs, any length; 0, 0: down */
    bool has_at;
    struct action_path path;
    struct action_raster formula, picture;
    int ink, brush, edge, over, reading, coefficient;
    int option; /* in the table that action_options() names */
    float radius, reach, solvent, amount, strength, value, to, vary, size, ticks;
    bool invert;
};

/* The parameters of a verb, ends with a key whose name is NULL. A KEY_POINT named `at` sets has_at. */
const struct key *action_keys(enum action_verb verb);
/* The table that a value of this key is an index into: of KEY_COEFFICIENT and KEY_OPTION; else NULL. */
const struct key *action_options(const struct key *key);
/* The name of a verb as scripts write it: "drop", "brush_solvent", ... */
const char *action_name(enum action_verb verb);
/* One sentence about it. */
const char *action_meaning(enum action_verb verb);
/* Whether a history does it: undo, redo and the time brush. */
bool action_goes_back(enum action_verb verb);
/* The verb of that name, or ACTION_VERBS. */
enum action_verb action_find(const char *name);
/* An action with every default of its verb; nothing required is filled in. */
struct action action_default(enum action_verb verb);
/* Numbers brought into the range of their keys, inks and brushes into those there are. */
struct action action_legal(const struct action *action);

#endif
