/* An exhibit: everything that a curator decides, in one YAML file, version 1.
 *
 *     exhibit: 1
 *     title: {en: Frost garden}
 *     display: {rotation: 0, width: 530}
 *     sheet: {cells: 345600}
 *     scenes:
 *       - {id: dawn, inks: [turquoise, ochre], painting: {s_max: 0.3}}
 *     inputs: {visitors: each, bindings: [...]}
 *     visit: {idle: 60, countdown: 15}
 *
 * Read as scripts are: every value against its struct key (exhibit_tables.c), every problem with its place, all of
 * them. Whatever is not given has the default of its key; `exhibit: 1` alone is an exhibit. An exhibit never changes
 * once it is read; a kiosk that reads its file again gets another one. */
#ifndef FROND_EXHIBIT_H
#define FROND_EXHIBIT_H

#include <stdbool.h>
#include <stddef.h>

#include "engine_choice.h"
#include "graph.h"
#include "inputs.h"
#include "report.h"
#include "scene.h"
#include "scene_options.h"
#include "script.h"
#include "words.h"

enum {
    EXHIBIT_VERSION = 1,
    EXHIBIT_SCENES = 16,
    EXHIBIT_PALETTES = 16,
    EXHIBIT_SESSIONS = 32,  /* recorded ones, for attract */
    EXHIBIT_PICTURES = 200, /* in the folder */
    EXHIBIT_SEATS = 8,
    EXHIBIT_HOURS = 28, /* entries of the schedule */
    EXHIBIT_TAPS = 8,   /* of the staff's chain */
    EXHIBIT_FEEDS = 8,  /* inputs of a scene */
    EXHIBIT_FILES = 96, /* pictures and sessions that it is read from */
};

struct exhibit_display {
    const char *connector;       /* as struct display_def; NULL: its choice */
    int mode_width, mode_height; /* pixels; 0: what the screen prefers */
    float refresh;               /* Hz; 0: what it prefers */
    int rotation;                /* degrees clockwise: 0, 90, 180, 270; of picture and touch together */
    float width;                 /* mm of the picture as it is looked at, across: what makes a target 15 mm */
    float floor;                 /* mm from the floor to its lower edge */
    bool lying;                  /* a table: nothing is out of reach by height */
};

struct exhibit_sheet {
    int cells;  /* in all; the sheet has the shape of the screen */
    int margin; /* cells beyond each side */
    int seed;
    int rate; /* ticks a second */
};

/* What a scene takes from another, on every fresh sheet: one of its `inputs`. */
struct exhibit_feed {
    const char *id;   /* of the other scene */
    int from;         /* the other scene's place in scenes[] */
    int of;           /* enum scene_field */
    int as;           /* enum graph_port */
    int reading;      /* enum graph_reading */
    int coefficient;  /* of PORT_COEFFICIENT: in coefficient_keys[] */
    float value, to;  /* of PORT_COEFFICIENT: its value where the other scene has grown, and where it has not */
    int ink;          /* of PORT_INK and PORT_BACKGROUND: of the scene's; -1: the first, the last */
    float strength;   /* 0..1: of a field, of a drawing, of relief */
    int tick;         /* how far the other scene grows by itself, when nobody has just made it here */
    bool invert;      /* dark is light, and forward is back */
    int line, column; /* where it stands in the file */
};

/* A scene is what is painted: inks, coefficients, a ground from a picture. `script` is a session without actions, for
 * the studio and the picture; its canvas is sheet.cells at 16:10 until script_fit gives it the shape of the screen. */
struct exhibit_scene {
    const char *id;
    struct words title;
    int kind;                     /* enum scene_kind */
    int leave;                    /* enum transition_kind: how it goes */
    struct scene_options options; /* of this kind, as at first: what the metaphor, kind or preset brings, and what the
                                     file gives */
    const char *picture; /* of SCENE_TREES: the first picture it grows over (path relative to the exhibit), and the
                            only one where there is no folder `pictures`; NULL: the first of the folder */
    struct script *script;
    const char *guide;     /* a picture (path relative to the exhibit) whose edges growth follows; NULL: none */
    const char *mask;      /* a picture whose dark parts stay free; NULL: none */
    struct action *ground; /* those as actions, then the opening, done on every fresh sheet; rasters and paths owned by
                              the script */
    int ground_count;
    int opening; /* ground[opening..]: what comes after the inputs of other scenes */
    struct exhibit_feed feeds[EXHIBIT_FEEDS];
    int feed_count;
};

/* What a finger on the sheet does, in the order on the palette; how files name it; the kind of scene that it is for. */
#define EXHIBIT_TOOLS(TOOL)                                                                                            \
    TOOL(TOOL_DROP, "drop", SCENE_PAINTING)                                                                            \
    TOOL(TOOL_BRUSH, "brush", SCENE_PAINTING)                                                                          \
    TOOL(TOOL_GUIDE, "guide", SCENE_PAINTING)                                                                          \
    TOOL(TOOL_POUR, "pour", SCENE_PAINTING)                                                                            \
    TOOL(TOOL_MASK, "mask", SCENE_PAINTING)                                                                            \
    TOOL(TOOL_REWIND, "rewind", SCENE_PAINTING) /* the time brush */                                                   \
    TOOL(TOOL_PLANT, "plant", SCENE_TREES)                                                                             \
    TOOL(TOOL_TEND, "tend", SCENE_TREES)         /* what is under the finger is more important */                      \
    TOOL(TOOL_THIN, "thin", SCENE_TREES)         /* less important */                                                  \
    TOOL(TOOL_STRIKE, "strike", SCENE_LIGHTNING) /* a finger that stays attracts */                                    \
    TOOL(TOOL_REPEL, "repel", SCENE_LIGHTNING)   /* a finger that stays repels */                                      \
    TOOL(TOOL_STROKE, "stroke", SCENE_LIGHTNING) /* a line that attracts, and stays */                                 \
    TOOL(TOOL_DOSE, "dose", SCENE_CHEMISTRY)                                                                           \
    TOOL(TOOL_ERASE, "erase", SCENE_CHEMISTRY)                                                                         \
    TOOL(TOOL_MAP, "map", SCENE_CHEMISTRY) /* opens the map of feed and kill */

#define TOOL_ENUMERATOR(tool, name, kind) tool,
enum exhibit_tool { EXHIBIT_TOOLS(TOOL_ENUMERATOR) TOOLS };
#undef TOOL_ENUMERATOR
extern const char *const exhibit_tool_names[];          /* "drop", "brush", ...; ends with NULL */
extern const enum scene_kind exhibit_tool_kinds[TOOLS]; /* the scenes that a tool is for */

static inline bool tool_fits(int tool, int kind)
{
    return tool >= 0 && tool < TOOLS && (int)exhibit_tool_kinds[tool] == kind;
}

/* The tool that every scene of a kind has, the first of its tools; TOOL_DROP, which is any binding's that names none,
 * where the kind has no tools of its own. */
static inline enum exhibit_tool tool_first(int kind)
{
    int tool = TOOLS - 1;
    for (int i = tool; i >= 0; i--) {
        tool = tool_fits(i, kind) ? i : tool;
    }
    return tool_fits(tool, kind) ? (enum exhibit_tool)tool : TOOL_DROP;
}

enum exhibit_side { SIDE_OF_LEFT, SIDE_OF_RIGHT, SIDE_OF_BOTTOM, SIDE_OF_NONE };

struct exhibit_palette { /* the heads-up one, not that of inks */
    bool tools[TOOLS];   /* which are offered; the first of each kind of scene always is */
    bool undo, finish;   /* undo: with redo */
    bool hand;           /* a button that moves it to the other side, for the other hand */
    bool seated;         /* a button that makes the reach-limited zone */
    bool language;       /* a button for the next language, where there are several */
    float target;        /* mm: side of a button, 15 or more */
    float opacity;       /* 0..1 at rest */
};

/* A visitor's place: fingers in its zone are its visitor's, with tool, ink and undo of their own. */
struct exhibit_seat {
    float zone[4]; /* left, top, right, bottom in 0..1 of the sheet */
    int ink;       /* of the scene's; -1: chosen on the palette */
    int side;      /* enum exhibit_side: of the zone, where its palette is */
};

struct exhibit_visit {
    float idle;      /* s without input until the countdown */
    float countdown; /* s */
    float thanks;    /* s that a finished picture is looked at before it is washed */
    float wash;      /* s */
    float attract;   /* s that a painting of attract takes, rest included */
    int next_scene;  /* paintings of attract until the next scene; 0: it stays */
    float hide;      /* s that hands are busy until the palette is out of the way */
};

struct exhibit_access {
    float scan;         /* s that a scanning cursor takes across the sheet; 0: no one-switch play */
    float dwell;        /* s that a point must rest until a drop falls; 0: never */
    float dwell_radius; /* mm within which it rests */
    float zone[4];      /* left, top, right, bottom in 0..1 of the sheet: what is in reach of a seated visitor */
};

struct exhibit_hours { /* open from..to on these days */
    bool days[7];      /* Monday first */
    int from, to;      /* minutes since midnight, 0..1440; to <= from: until then on the next day */
};

struct exhibit_gallery {
    const char *folder; /* in the state folder; NULL: nothing is kept */
    int pictures;       /* kept at most, oldest out first */
    int megabytes;      /* all together */
    float slides;       /* s that one is shown between two paintings of attract; 0: none is */
    const char *stick;  /* folder on a stick that they are copied to; NULL: EXPORT_FOLDER */
};

/* A broker, for those who look after many kiosks (group.h). Files are beside the exhibit. */
struct exhibit_mqtt {
    const char *host;              /* NULL: there is none */
    int port, every;               /* every: s from one status to the next */
    const char *topic;             /* in front of all topics */
    const char *name, *group;      /* of this kiosk; of those that are told together, NULL: none */
    const char *ca;                /* NULL: without TLS */
    const char *certificate, *key; /* of this kiosk; NULL: none */
    const char *credentials;       /* two lines: user, password; NULL: none */
};

struct exhibit_staff {
    int taps[EXHIBIT_TAPS], tap_count; /* corners: 0 top left, 1 top right, 2 bottom right, 3 bottom left */
    float within;                      /* s from one tap to the next */
    float hold;                        /* s that the last is held */
};

struct exhibit {
    int version;
    const char *path, *folder; /* as it was read */
    struct words title;
    struct exhibit_display display;
    struct exhibit_sheet sheet;
    int engine;            /* enum engine_kind */
    uint64_t inputs_mark;  /* of what stands in the file under inputs: the same, the same inputs */
    struct inputs *inputs; /* NULL: the default ones; inks are those of the first scene */
    struct exhibit_scene scenes[EXHIBIT_SCENES];
    int scene_count;                        /* 1.. */
    const char *pictures;                   /* folder of stock pictures, relative to the exhibit; NULL: none */
    const char *sessions[EXHIBIT_SESSIONS]; /* recorded ones, read with the exhibit */
    struct script *recorded[EXHIBIT_SESSIONS];
    int session_count;
    int languages[WORDS_LANGUAGES], language_count; /* of words.h, the first is the first shown */
    struct words texts[TEXTS];
    struct exhibit_palette palette;
    struct exhibit_seat seats[EXHIBIT_SEATS];
    int seat_count; /* 1.. */
    struct exhibit_visit visit;
    struct exhibit_access access;
    struct exhibit_hours hours[EXHIBIT_HOURS];
    int hours_count; /* 0: always open */
    int wake;        /* minutes that a touch opens it while it is closed; 0: it does not */
    struct exhibit_gallery gallery;
    struct exhibit_staff staff;
    struct exhibit_mqtt mqtt;
    /* Pictures and sessions that openings name, and those that sessions do: each by the folder of whoever names it.
     * More than that are not watched for changes. */
    struct exhibit_file {
        const char *folder, *path;
    } files[EXHIBIT_FILES];
    int file_count;
    struct script *memory; /* texts */
};

/* Reads a file or a text. `def` loads pictures, as for scripts. NULL when anything is wrong; then the report has at
 * least one problem. */
struct exhibit *exhibit_read(const char *path, const struct script_def *def, struct report *report);
struct exhibit *exhibit_parse(const char *text, size_t size, const char *folder, const struct script_def *def,
                              struct report *report);
void exhibit_destroy(struct exhibit *exhibit); /* takes NULL */
/* What can be shown, but is hardly meant: inputs from scenes in which nothing grows by itself, so that nothing comes of
 * them until somebody has made something there. */
void exhibit_warn(const struct exhibit *exhibit, struct report *report);
/* Whether a text means to be an exhibit: its top has the key `exhibit`. */
bool exhibit_is(const char *text, size_t size);

/* The keys of `trees`, `lightning` or `chemistry` in a scene, over struct exhibit_scene: its own, and those of
 * scene_options_keys that are one value. Written to `keys`, the last one without a name. None of a painting. */
enum { EXHIBIT_OPTIONS_KEYS = 64 };
void exhibit_options_keys(enum scene_kind kind, struct key keys[EXHIBIT_OPTIONS_KEYS]);

/* Its scenes and their inputs. Nodes are numbered as scenes are. */
struct graph exhibit_graph(const struct exhibit *exhibit);

/* The names of the pictures in the folder `pictures` now, sorted, EXHIBIT_PICTURES of them at most; their paths are
 * relative to exhibit->folder. None when it has no such folder, or it cannot be read. */
struct exhibit_pictures {
    char **paths; /* owned, as each of them is */
    int count;    /* listed; `more` of them are not */
    int more;
};
struct exhibit_pictures exhibit_pictures(const struct exhibit *exhibit);
void exhibit_pictures_finish(struct exhibit_pictures *pictures); /* takes a zeroed one */

/* The tables behind it; ends with a table whose name is NULL. */
extern const struct inputs_table exhibit_tables[];

#endif
