/* What is set in a scene, whatever its kind: the values that exhibits give, that dials turn, that its verb sets
 * (struct scene_type). */
#ifndef FROND_SCENE_OPTIONS_H
#define FROND_SCENE_OPTIONS_H

#include <stdalign.h>
#include <stddef.h>

#include "dish.h"
#include "growth.h"
#include "scene.h"
#include "storm.h"

struct scene_options {
    enum scene_kind kind;
    union {
        alignas(max_align_t) unsigned char any[SCENE_OPTIONS_BYTES];
        struct growth_def trees;    /* of SCENE_TREES */
        struct storm_def lightning; /* of SCENE_LIGHTNING */
        struct dish_def chemistry;  /* of SCENE_CHEMISTRY */
    };
};

/* As at first. */
struct scene_options scene_options_default(enum scene_kind kind);
/* The table of the kind, over the struct that scene_options_object gives; of a painting an empty one. Ends with a key
 * whose name is NULL. */
const struct key *scene_options_keys(enum scene_kind kind);
void *scene_options_object(struct scene_options *options);
/* Whether a key is one value, which a dial or an action can set; others are places and rasters. */
bool scene_option_is_value(const struct key *key);
/* Keys that bring the values of others (metaphor, tree, kind, preset): to be set before them. */
bool scene_option_brings(enum scene_kind kind, const struct key *key);
/* The value of a key of the table as a number, and setting it: brought into its range, with what it brings. */
float scene_option_value(const struct scene_options *options, int key);
void scene_option_take(struct scene_options *options, int key, float value);
/* The actions that make the options of a fresh scene these, those that bring others first. Returns how many; at most
 * SCENE_OPTIONS_ACTIONS are written. */
enum { SCENE_OPTIONS_ACTIONS = 64 };
int scene_options_actions(const struct scene_options *options, struct action actions[SCENE_OPTIONS_ACTIONS]);

#endif
