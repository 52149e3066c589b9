/* A named value: the one description of it that scripts, `check`, `explain`, the README and the on-screen dials share.
 */
#ifndef FROND_KEY_H
#define FROND_KEY_H

#include <stdbool.h>
#include <stddef.h>

enum key_type {
    KEY_NUMBER,  /* float */
    KEY_INTEGER, /* int */
    KEY_FLAG,    /* bool */
    KEY_CHOICE,  /* int: index into choices */
    KEY_POINT,   /* struct point: [x, y] in 0..1 of the sheet, x to the right and y down */
    KEY_PATH,    /* struct action_path: at least one point */
    KEY_INK,     /* int: index into the inks of the session; written as the ink's name */
    KEY_BRUSH,   /* int: index into brushes[] (brush.h); -1 none; written as the brush's name */
    KEY_RASTER,  /* struct action_raster, from a formula in x and y: an expression, or [expression, expression] for a
                    vector */
    KEY_PICTURE, /* struct action_raster, from a picture: a path relative to the file that names it */
    KEY_TEXT,    /* const char *: a word or some, of `min` to `max` bytes; owned by whoever read it */
    KEY_OPTION,  /* int: index into the options of the kind of scene (scene.h) that `min` is; written as the name there
                  */
    KEY_COEFFICIENT, /* int: index into coefficient_keys[] (coefficients.h); written as the coefficient's name */
    KEY_ZONE,        /* float[4]: [left, top, right, bottom] in 0..1 of the sheet; its default reaches from a top of
                        `initial` down, all across */
    KEY_SIZE,        /* int[2]: WxH; 0, 0 where it is left out */
    KEY_TIME,        /* int: minutes since midnight, 0..1440; written as H:MM */
};

struct key {
    const char *name;
    enum key_type type;
    const char *unit; /* "" where there is none */
    double min,
        max; /* inclusive; of KEY_NUMBER and KEY_INTEGER (and of each coordinate of a point); bytes of KEY_TEXT */
    double initial;             /* the default; flags and choices as integers */
    const char *const *choices; /* of KEY_CHOICE, ends with NULL; else NULL */
    size_t offset;              /* of the value in the struct that the table describes */
    bool required;
    const char *meaning; /* one sentence for a curator */
};

/* The key called `name`, or NULL. `keys` ends with a key whose name is NULL. */
const struct key *key_find(const struct key *keys, const char *name);
/* The number of keys before the end of the table. */
int key_count(const struct key *keys);
/* The name in the table nearest to a misspelt one (edit distance at most 3, and less than half its length), or NULL. */
const char *key_suggest(const struct key *keys, const char *misspelt);
/* Fills every value of `object` with its default; points are made 0, paths and rasters empty, texts NULL. */
void key_defaults(const struct key *keys, void *object);

/* A value as a number: choices and flags by theirs from 0; of what is no number 0. */
float key_value(const struct key *key, const void *object);
/* A number brought into the key's range, not rounded; NaN becomes the least. */
float key_bound(const struct key *key, float value);
/* Sets it, brought into its range (NaN becomes the least) and rounded where it is whole. */
void key_take(const struct key *key, void *object, float value);
/* Whether every number, whole number and choice of `object` is within its range. */
bool keys_are_legal(const struct key *keys, const void *object);
/* Brings them there: numbers to the nearer end (NaN to the least), choices that there are none to the default. */
void keys_make_legal(const struct key *keys, void *object);

#endif
