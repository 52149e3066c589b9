/* A storm: the scene of lightning. Visitors strike, attract and repel; bolts, corals, frost and rivers grow by
 * Laplacian growth (laplacian.h), tick by tick, and keep clear of each other; strikes glow and fade, what is slow stays
 * until it is washed away.
 *
 * The same actions make the same storm to the bit, whatever the machine. A lightning strike runs from above to where
 * the hand is (and follows it, while it grows, as the hand attracts); all other kinds begin where the hand is.
 *
 * Undo and redo are of bolts and of painted charges. A mask stays until it is unmasked or all is cleared, and what was
 * washed away stays so: bolts have grown along them. */
#ifndef FROND_STORM_H
#define FROND_STORM_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"
#include "bolt.h"
#include "bolt_light.h"
#include "scene.h"

enum {
    STORM_BOLTS = 24,         /* at once; with one more the oldest goes */
    STORM_HANDS = 64,         /* visitors that attract at once */
    STORM_STROKES = 64,       /* painted charges; with one more the oldest goes */
    STORM_PARTICLES = 100000, /* of all bolts together */
};

struct storm_def {
    int kind; /* enum bolt_kind; another brings its own values of all others but the seed */
    float eta;
    int particles;   /* of a bolt */
    float pace;      /* particles a tick */
    float life;      /* ticks that a strike glows after it has come; 0: it stays */
    float thickness; /* times that of its kind */
    int dimensions;  /* 2 or 3 */
    float turn;      /* turns a minute, in three dimensions */
    float repel;     /* charge of a particle of another bolt, of one of its own */
    bool clear;      /* the painting shows behind it */
    int seed;
};
extern const struct key storm_keys[]; /* of struct storm_def; ends with a key whose name is NULL */
struct storm_def storm_preset(enum bolt_kind kind);
/* Sets a value, brought into its range; another kind brings its own values of all but the seed. */
void storm_take(struct storm_def *def, int key, float value);

struct storm;
struct storm *storm_create(int width,
                           int height);  /* cells of the sheet; of BOLT_LIGHTNING. NULL when memory is short */
void storm_destroy(struct storm *storm); /* takes NULL */
/* The sheet has another grid: what has grown is where it was, in its shares. */
void storm_resize(struct storm *storm, int width, int height);
/* Rasters and paths are copied. Ticks do not go back. */
void storm_act(struct storm *storm, int64_t tick, const struct action *action);
/* False when memory was short, now or in what was done before. */
bool storm_tick(struct storm *storm, int64_t tick);
struct storm_def storm_get_def(const struct storm *storm);
/* What is to be seen; good until the next call that changes anything. `since`: segments before it are as they were
 * when the last view was taken (radii, too). */
struct bolt_view storm_view(struct storm *storm, int64_t tick, int *since);
/* Whether it is at rest: nothing grows, glows or turns. */
bool storm_is_calm(const struct storm *storm, int64_t tick);

extern const struct scene_type storm_type;

#endif
