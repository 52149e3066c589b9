#include "storm.h"

#include <stdlib.h>
#include <string.h>

#include "storm_state.h"

struct storm *storm_create(int width, int height)
{
    struct storm *storm = calloc(1, sizeof *storm);
    if (storm) {
        storm->def = storm_preset(BOLT_LIGHTNING);
        storm->most = STORM_PARTICLES;
        storm->width = width > 1 ? width : 1;
        storm->height = height > 1 ? height : 1;
        if (!storm_lattice_init(storm)) {
            storm_destroy(storm);
            storm = NULL;
        }
    }
    return storm;
}

void storm_destroy(struct storm *storm)
{
    if (storm) {
        for (int slot = 0; slot < STORM_SLOTS; slot++) {
            storm_bolt_free(&storm->bolts[slot]);
        }
        storm_lattice_finish(storm);
        free(storm->segments);
        free(storm->owners);
        free(storm);
    }
}

static void dress_all(struct storm *storm)
{
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        if (storm->bolts[slot].lives) {
            storm_dress(storm, slot);
        }
    }
}

void storm_resize(struct storm *storm, int width, int height)
{
    width = width > 1 ? width : 1;
    height = height > 1 ? height : 1;
    if (width == storm->width && height == storm->height) {
        return;
    }
    storm->width = width; /* the lattice and the mask are in shares of the sheet, bolts in their own cells */
    storm->height = height;
    storm->strokes_changed = true;
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        struct storm_bolt *bolt = &storm->bolts[slot];
        bool complete = bolt->complete;
        bolt->complete = true; /* so that nothing is kept as it was */
        if (bolt->lives) {
            storm_dress(storm, slot);
        }
        bolt->complete = complete;
    }
    for (int i = 0; i < storm->count; i++) { /* restrikes go: they are short */
        storm->segments[i].heat = storm->owners[i].again ? 0 : storm->segments[i].heat;
    }
    storm_touch(storm, 0);
}

static void clear(struct storm *storm)
{
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        storm_bolt_free(&storm->bolts[slot]);
    }
    memset(storm->hands, 0, sizeof storm->hands);
    memset(storm->strokes, 0, sizeof storm->strokes);
    for (int i = 0; i < storm->mask_columns * storm->mask_rows; i++) {
        storm->mask[i] = 1;
    }
    storm_scar_clear(storm);
    storm->hands_changed++;
    storm->strokes_changed = true;
    storm->count = 0;
    storm->since = 0;
}

static void conduct(struct storm *storm, const struct action *action)
{
    struct storm_def was = storm->def;
    storm_take(&storm->def, action->option, action->value);
    const struct storm_def *def = &storm->def;
    for (int slot = 0; slot < STORM_SLOTS && def->kind == was.kind && def->eta != was.eta; slot++) {
        if (storm->bolts[slot].laplacian) {
            laplacian_eta(storm->bolts[slot].laplacian, def->eta);
        }
    }
    if (def->thickness != was.thickness) {
        dress_all(storm);
    }
    storm->changed += def->repel != was.repel;
}

static void take(struct storm *storm, const struct action *action)
{
    switch (action->verb) {
    case ACTION_STRIKE:
        storm_strike(storm, action);
        break;
    case ACTION_ATTRACT:
        storm_attract(storm, action);
        break;
    case ACTION_CONDUCT:
        conduct(storm, action);
        break;
    case ACTION_MASK:
    case ACTION_UNMASK:
        storm_mask(storm, action);
        break;
    case ACTION_RINSE:
        storm_rinse(storm, action);
        break;
    case ACTION_CLEAR:
        clear(storm);
        break;
    case ACTION_UNDO:
        storm_undo(storm, action->visitor);
        break;
    case ACTION_REDO:
        storm_redo(storm, action->visitor);
        break;
    default:
        break;
    }
}

static void go_to(struct storm *storm, int64_t tick)
{
    storm->origin = storm->begun ? storm->origin : tick;
    storm->now = storm->begun && tick < storm->now ? storm->now : tick;
    storm->begun = true;
}

void storm_act(struct storm *storm, int64_t tick, const struct action *action)
{
    struct action legal = action_legal(action);
    go_to(storm, tick);
    take(storm, &legal);
}

bool storm_tick(struct storm *storm, int64_t tick)
{
    go_to(storm, tick);
    storm_rebase(storm);
    storm_grow(storm);
    bool good = !storm->failed;
    storm->failed = false;
    return good;
}

struct storm_def storm_get_def(const struct storm *storm)
{
    return storm->def;
}

bool storm_is_calm(const struct storm *storm, int64_t tick)
{
    bool calm = true, deep = false;
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        const struct storm_bolt *bolt = &storm->bolts[slot];
        bool fades = bolt->lives && bolt->gone < STORM_AGES, swells = bolt->complete && tick < bolt->swells;
        calm = calm && !storm_bolt_grows(bolt) && !fades && !swells;
        deep = deep || bolt->lives;
    }
    bool turns = deep && storm->def.dimensions == 3 && storm->def.turn != 0;
    bool flashes = storm->flash > 0 && tick - storm->flashed < STORM_FLASH;
    return calm && !turns && !flashes && !storm->strokes_changed;
}

static void *create(int width, int height)
{
    return storm_create(width, height);
}

static void destroy(void *scene)
{
    storm_destroy(scene);
}

static void resize(void *scene, int width, int height)
{
    storm_resize(scene, width, height);
}

static void act(void *scene, int64_t tick, const struct action *action)
{
    storm_act(scene, tick, action);
}

static bool tick(void *scene, int64_t now)
{
    return storm_tick(scene, now);
}

static uint64_t can_undo(const void *scene)
{
    return storm_visitors(scene, false);
}

static uint64_t can_redo(const void *scene)
{
    return storm_visitors(scene, true);
}

/* Leaves it to others to ask what has changed since they did. */
static bool lay(void *scene, int64_t now, int width, int height, uint8_t *rgb)
{
    struct storm *storm = scene;
    int since = storm->since, ignored;
    struct bolt_view view = storm_view(storm, now, &ignored);
    storm->since = since;
    return bolt_light_lay(&view, (double)now, width, height, rgb);
}

static void initial_options(void *options)
{
    *(struct storm_def *)options = storm_preset(BOLT_LIGHTNING);
}

static void take_option(void *options, int key, float value)
{
    storm_take(options, key, value);
}

static const char *const BRINGS[] = {"kind", NULL};

static bool is_calm(const void *scene, int64_t now)
{
    return storm_is_calm(scene, now);
}

const struct scene_type storm_type = {
    .shows = SHOW_BOLTS,
    .options = storm_keys,
    .brings = BRINGS,
    .sets = ACTION_CONDUCT,
    .begins = ACTION_STRIKE,
    .initial = initial_options,
    .take = take_option,
    .create = create,
    .destroy = destroy,
    .resize = resize,
    .act = act,
    .tick = tick,
    .can_undo = can_undo,
    .can_redo = can_redo,
    .lay = lay,
    .field = storm_field,
    .hash = storm_hash,
    .is_calm = is_calm,
    .figures = storm_figures,
};
