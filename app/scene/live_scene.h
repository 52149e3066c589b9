/* A scene (scene.h) beside the studio: a thread of its own in which it grows, while the
 * display shows the newest view of it. It hears of all that happens to the painting as the journal does, action by
 * action at its tick, and of the ticks, in the order of app/session/plot.h, so that a journal repeats it. Where a
 * script has no such scene, and where nothing is done, it costs nothing.
 *
 *     live_scene_scene(live, script, SCENE_TREES, id);  in the display's thread: what this script has
 *     teller = {live_scene_tell, live};                 in the studio's
 *     newest = live_scene_newest(live, sheet, &fresh);  in the display's; never waits
 *
 * Trees are planned when there is something new, and while one plan is made, what is done meanwhile is taken together;
 * dragging plans anew at most six times a second; running water is left to whoever shows the plate (live_scene_water),
 * until it has passed. Lightning and chemistry go on with every tick. Where they are slower than the studio, it waits
 * for them (live_scene_tell). */
#ifndef FROND_LIVE_SCENE_H
#define FROND_LIVE_SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "dish.h"
#include "outcome.h"
#include "painting.h"
#include "plate.h"
#include "scene.h"
#include "script.h"
#include "storm.h"
#include "studio_tell.h"

enum {
    LIVE_WATER_WIDTH = 128,
    LIVE_WATER_HEIGHT = 80,
    LIVE_SCENE_LEAD = 30,      /* ticks that the studio may be ahead */
    LIVE_SCENE_WAIT_MS = 1000, /* that it waits at most, a tick */
};

struct live_scene;

/* `types`: scene_types, or others of the same kinds whose scenes are a garden's, a storm's, a dish's, too. NULL when
 * memory is short or there is no thread to be had. */
struct live_scene *live_scene_create(const struct scene_type *const *types);
/* After the studio. Waits for a plan or a tick that is being made. Takes NULL. */
void live_scene_destroy(struct live_scene *live);

/* From the moment on that the studio paints this script (only compared), there is a scene of this kind, or none
 * (SCENE_PAINTING). The last four that were told are known; others have none. A fresh sheet has an empty one; under
 * another script of the same kind and id (as struct journal_sheet's) what has grown stays. */
void live_scene_scene(struct live_scene *live, const struct script *script, enum scene_kind kind, const char *id);
/* The kind that a session needs: that of the first verb that is for one kind alone. */
enum scene_kind live_scene_kind(const struct script *script);
/* For struct studio_teller, in the studio's thread; `data` is the scene. Quick, but for STUDIO_TICKED: that waits, up
 * to LIVE_SCENE_WAIT_MS, while lightning or chemistry is more than LIVE_SCENE_LEAD ticks behind. What live_scene_resume
 * leaves to be done may stay; the studio does not get further ahead then. */
void live_scene_tell(void *data, const struct studio_event *event);
/* The studio is about to be stopped, or the like: nobody waits in live_scene_tell, from now on until told otherwise. */
void live_scene_release(struct live_scene *live, bool on);
/* Before the studio begins: the scene as the journal of a sheet leaves it, with what was done since the sheet was fresh
 * or had another scene; it is made in the thread, tick by tick. False: there is no journal, or it cannot be read; the
 * scene is empty then. */
bool live_scene_resume(struct live_scene *live, const struct script *script, enum scene_kind kind, const char *id,
                       const void *journal, size_t size);

/* Pixels of the plates from now on; 0: none is painted. */
void live_scene_size(struct live_scene *live, int width, int height);

/* What is to be seen; of its kind alone. */
struct live_view {
    enum scene_kind kind;
    bool any;          /* there is something to see: now, or later */
    bool calm;         /* it looks the same until another view is there; of trees: from last_tick on */
    int sheet;         /* as of live_scene_sheet */
    uint64_t sequence; /* of what was done before it was made */
    int64_t tick;      /* that was the last to be done */
    struct plate plate;
    int64_t last_tick; /* when the last of the plate is there */
    struct bolt_view bolts;
    int since; /* segments before it are as in the view that was taken before, if that was of the same sheet */
    struct live_picture_view {
        const uint8_t *rgba; /* sRGB, multiplied by alpha */
        int width, height;   /* cells of the sheet */
    } picture;
    struct dish_view dish;
    uint64_t look; /* another number: dish.shade is another */
};
/* The newest view, if it is of this sheet, else the one that was taken last; it stays as it is until the next call.
 * `fresh`: it is another than the last time. */
const struct live_view *live_scene_newest(struct live_scene *live, int sheet, bool *fresh);
/* Whether another one is there. */
bool live_scene_has_newer(struct live_scene *live);
/* Whether all that was told has been done, and there is a view of it. */
bool live_scene_is_calm(struct live_scene *live);

/* What the scene has come to, as fields for others to grow from, HAND_SIDE cells along the longer side: asked for as it
 * is left, before the studio is told so, and made in the thread before anything that is told later. `number` is the
 * caller's. What was asked for before is lost. False: there is no scene. */
bool live_scene_hand(struct live_scene *live, int number);
/* It, once it is made; the caller's then. Never waits. */
bool live_scene_handed(struct live_scene *live, int *number, struct outcome *outcome);

struct live_scene_sheet {
    enum scene_kind kind;        /* SCENE_PAINTING: there is no scene */
    enum scene_show shows;       /* of a kind that there is */
    int number;                  /* counts fresh sheets and scenes: views of others are not to be shown */
    double tick;                 /* now, with a fraction, as actions are counted */
    double done;                 /* the same of what lightning and chemistry have done; not after `tick` */
    uint64_t can_undo, can_redo; /* bit v: visitor v */
    bool rinsed;                 /* water runs over trees, or has */
    uint64_t rinse;              /* sequence of the last of it */
    double grow_ms, paint_ms; /* what the newest plate took; or the ticks that were done last, and the view of them */
    int plans;                /* views made so far */
    int behind;               /* ticks that the studio is ahead */
};
struct live_scene_sheet live_scene_sheet(struct live_scene *live, double now_s);
/* struct scene_type's hash of the scene, once it is calm; for tests. 0: there is none. */
uint64_t live_scene_hash(struct live_scene *live);
/* Where the water has come: LIVE_WATER_HEIGHT rows of LIVE_WATER_WIDTH values, 0 dry .. 255 gone, over the sheet. */
void live_scene_water(struct live_scene *live, uint8_t water[LIVE_WATER_WIDTH * LIVE_WATER_HEIGHT]);

#endif
