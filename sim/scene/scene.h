/* Scenes beside the painting: trees (garden.h), lightning (storm.h), chemistry (dish.h). Each hears the same actions as
 * everything else, by their ticks, and only those, so that a journal repeats it; each gives a picture that lies over
 * the painting, and fields for whatever else wants to grow from it.
 *
 *     const struct scene_type *type = scene_types[SCENE_LIGHTNING];
 *     void *scene = type->create(width, height);
 *     type->act(scene, ticked, &action);              every action of the tick, also those that are not for it
 *     type->tick(scene, ticked);                      once they are done, once for each tick
 *     type->lay(scene, ticked, width, height, rgb);   over a picture of the painting
 *
 * A new kind of scene is a pair of files that defines a scene_type, and a line in SCENE_TYPES. */
#ifndef FROND_SCENE_H
#define FROND_SCENE_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"

/* Every kind but the painting, which is the engine's (engine.h): enum scene_kind, its name in files, its struct
 * scene_type, and a sentence for curators about its section in an exhibit. */
#define SCENE_TYPES(KIND)                                                                                              \
    KIND(SCENE_TREES, "trees", trees_type,                                                                             \
         "How they grow in a scene of trees, as `frond grow` does it, and over which picture first; defaults are "     \
         "those of ink.")                                                                                              \
    KIND(SCENE_LIGHTNING, "lightning", storm_type,                                                                     \
         "How it grows in a scene of lightning: bolts, corals, rivers, frost; defaults are those of the first kind.")  \
    KIND(SCENE_CHEMISTRY, "chemistry", dish_type,                                                                      \
         "How chemicals react in a scene of chemistry, and what they look like.")

#define SCENE_ENUMERATOR(kind, name, type, about) kind,
enum scene_kind { SCENE_PAINTING, SCENE_TYPES(SCENE_ENUMERATOR) SCENE_KINDS };
#undef SCENE_ENUMERATOR
extern const char *const scene_kind_names[SCENE_KINDS + 1]; /* "painting", ...; ends with NULL */
extern const char *const scene_kind_meanings[SCENE_KINDS];  /* those sentences; NULL for SCENE_PAINTING */

/* What a scene gives to another, as rasters over the sheet. */
enum scene_field {
    FIELD_DARK,   /* one channel, 0..1: 0 where it has grown, 1 where nothing is, as ink on paper */
    FIELD_ALONG,  /* two channels, -1..1: the direction in which it grew there, x right and y down, length at most 1 */
    FIELD_AROUND, /* one channel, 0..1: what it makes of its surroundings: the potential of a bolt (0 on it), the fresh
                     chemical u, the importance of a picture; of a painting 0 where solvent is */
    SCENE_FIELDS,
};
extern const char *const scene_field_names[SCENE_FIELDS + 1]; /* "dark", "along", "around"; ends with NULL */

/* A figure of a scene, for those who measure: a number, or a word. */
struct scene_figure {
    const char *name;
    const char *word; /* NULL: it is the number */
    double number;
};
enum { SCENE_FIGURES = 32 };

/* How a display shows it (app/scene/live_drawer.h). */
enum scene_show {
    SHOW_PICTURE, /* by what `lay` gives, whatever it is */
    SHOW_PLATE,   /* a garden's (plate.h) */
    SHOW_BOLTS,   /* a storm's (bolt_light.h) */
    SHOW_PATTERN, /* a dish's (gray_scott_shade.h) */
};

struct scene_type {
    enum scene_show shows;
    const char *about;              /* a sentence about its options, for a curator */
    const struct key *options;      /* what can be set, over a struct of its own of SCENE_OPTIONS_BYTES at most */
    const char *const *brings;      /* names of options that bring the values of others; ends with NULL */
    enum action_verb sets;          /* the verb that sets one */
    enum action_verb begins;        /* the verb by which something begins to grow at a place, whatever the tool */
    void (*initial)(void *options); /* fills that struct as at first */
    /* Sets a value of the table: brought into its range, with what it brings. */
    void (*take)(void *options, int key, float value);
    void *(*create)(int width, int height); /* cells of the sheet. Nothing is on it. NULL when memory is short */
    void (*destroy)(void *scene);           /* takes NULL */
    void (*resize)(void *scene, int width, int height); /* the sheet has another grid; what has grown stays */
    void (*act)(void *scene, int64_t tick, const struct action *action); /* rasters and paths are copied */
    /* The tick itself. Ticks do not go back, and none is left out. False when memory is short. */
    bool (*tick)(void *scene, int64_t tick);
    uint64_t (*can_undo)(const void *scene); /* bit v: visitor v has something to take back */
    uint64_t (*can_redo)(const void *scene);
    /* Lays what is to be seen at that tick over width * height * 3 bytes of sRGB. False when memory is short. */
    bool (*lay)(void *scene, int64_t tick, int width, int height, uint8_t *rgb);
    /* Fills channels * width * height values, channel by channel, rounded to 1/65536. False when memory is short. */
    bool (*field)(void *scene, enum scene_field field, int width, int height, float *values);
    uint64_t (*hash)(const void *scene); /* of all that decides what it looks like, for tests */
    /* Those below may be NULL. Whether it looks the same from this tick on until something is done; NULL: never. */
    bool (*is_calm)(const void *scene, int64_t tick);
    /* Planes of its own model, for files: "u", "v"; ends with NULL; and filling width * height
     * values with one. False when memory is short. */
    const char *const *planes;
    bool (*plane)(void *scene, int plane, int width, int height, float *values);
    /* Figures of it, at most SCENE_FIGURES; how many. The scene stays as it is. */
    int (*figures)(const void *scene, struct scene_figure *figures);
};
enum { SCENE_OPTIONS_BYTES = 1024 };
/* By kind; NULL for SCENE_PAINTING. */
extern const struct scene_type *const scene_types[SCENE_KINDS];
/* The kind that a verb is for alone (a session with one has such a scene), or SCENE_PAINTING. */
enum scene_kind scene_kind_of(enum action_verb verb);
/* Whether an action is for scenes of a kind: what is for that kind alone, and what washes, clears and takes back. */
bool scene_takes(enum scene_kind kind, enum action_verb verb);
/* 1, or 2 for FIELD_ALONG. */
int scene_field_channels(enum scene_field field);

#endif
