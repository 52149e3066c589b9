/* A garden (garden.h) beside the studio: a thread of its own that plans and paints what visitors plant, while the
 * display shows the newest plate. It hears of all that happens to the painting as the journal does, action by action
 * at its tick, so that the journal repeats it. Where the scene has no garden, and where nothing is done, it costs
 * nothing.
 *
 *     live_garden_scene(garden, script, true);      in the display's thread: this script has a garden
 *     teller = {live_garden_tell, garden};          in the studio's
 *     newest = live_garden_newest(garden, &fresh);  in the display's; never waits
 *
 * While one plan is made, what is done meanwhile is taken together. Dragging plans anew at most six times a second;
 * running water is left to whoever shows the plate (live_garden_water), until it has passed. */
#ifndef FROND_LIVE_GARDEN_H
#define FROND_LIVE_GARDEN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "garden.h"
#include "painting.h"
#include "plate.h"
#include "script.h"
#include "studio_tell.h"

enum { LIVE_WATER_WIDTH = 128, LIVE_WATER_HEIGHT = 80 };

struct live_garden;

/* NULL when memory is short or there is no thread to be had. */
struct live_garden *live_garden_create(void);
/* After the studio. Waits for a plan that is being made. Takes NULL. */
void live_garden_destroy(struct live_garden *live);

/* From the moment on that the studio paints this script (only compared), there is a garden (garden_default_def), or
 * none. The last four that were told are known; others have none. A fresh sheet has an empty garden, on which
 * ACTION_STOCK and ACTION_SHAPE come; under another script with a garden what has grown stays. */
void live_garden_scene(struct live_garden *live, const struct script *script, bool has);
/* For struct studio_teller, in the studio's thread; `data` is the garden. Quick. */
void live_garden_tell(void *data, const struct studio_event *event);
/* Before the studio begins: the garden as the journal of a sheet leaves it, with what was done since the sheet was
 * fresh or had another scene. False: there is no journal, or it cannot be read; the garden is empty then. */
bool live_garden_resume(struct live_garden *live, const struct script *script, const void *journal, size_t size);

/* Pixels of the plates from now on; 0: none is painted. */
void live_garden_size(struct live_garden *live, int width, int height);

struct live_garden_plate {
    struct plate plate;
    bool any;          /* there is something to see: now, or later */
    int64_t last_tick; /* when the last of it is there */
    int sheet;         /* as of live_garden_sheet */
    uint64_t sequence; /* of what was done before it was planned */
};
/* The newest plate; it stays as it is until the next call. `fresh`: it is another than the last time. */
const struct live_garden_plate *live_garden_newest(struct live_garden *live, bool *fresh);
/* Whether another one is there. */
bool live_garden_has_newer(struct live_garden *live);
/* Whether all that was told has been planned. */
bool live_garden_is_calm(struct live_garden *live);

struct live_garden_sheet {
    bool on;                     /* the scene has a garden */
    int number;                  /* counts fresh sheets and scenes: plates of others are not to be shown */
    double tick;                 /* now, with a fraction, as actions are counted */
    uint64_t can_undo, can_redo; /* bit v: visitor v */
    bool rinsed;                 /* water runs over it, or has */
    uint64_t rinse;              /* sequence of the last of it */
    double grow_ms, paint_ms;    /* what the newest plate took */
    int plans;                   /* made so far */
};
struct live_garden_sheet live_garden_sheet(struct live_garden *live, double now_s);
/* Where the water has come: LIVE_WATER_HEIGHT rows of LIVE_WATER_WIDTH values, 0 dry .. 255 gone, over the sheet. */
void live_garden_water(struct live_garden *live, uint8_t water[LIVE_WATER_WIDTH * LIVE_WATER_HEIGHT]);

#endif
