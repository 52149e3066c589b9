/* The kiosk: an exhibit and its visit. It hears every event before the controls do, and what the controls wish; it
 * tells a stage what to do, and says what is to be seen over the painting. Knows no GL, no device, no clock: a test
 * drives whole days of it in a second.
 *
 *     kiosk_controls(kiosk, controls);                 whenever there are others
 *     if (kiosk_feel(kiosk, &event, now_us)) { controls_feel(controls, &event); }
 *     while (controls_action(controls, &action, &us)) { kiosk_act(kiosk, &action, us, now_us); }
 *     while (controls_wish(controls, &wish)) { kiosk_wish(kiosk, &wish, now_us); }
 *     kiosk_run(kiosk, now_us, time);                  before each frame
 *     kiosk_look(kiosk, now_us)                        what is to be seen (kiosk_look.h)
 */
#ifndef FROND_KIOSK_H
#define FROND_KIOSK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>

#include "action.h"
#include "controls.h"
#include "event.h"
#include "exhibit.h"

/* The sheet that is painted now. */
struct kiosk_sheet {
    int number;                  /* counts fresh sheets */
    int64_t tick;                /* since it was fresh */
    uint64_t can_undo, can_redo; /* bit v: visitor v */
};

/* Whoever paints, shows and keeps. All of it is called from kiosk_create, _feel, _wish, _run and _exhibit. */
struct kiosk_stage {
    void *context;
    bool (*post)(void *context, const struct action *action, uint64_t event_us); /* as studio_post_event */
    void (*fresh)(void *context);                               /* another sheet; what was posted before is not done */
    void (*change)(void *context, const struct script *script); /* another scene, on the same sheet */
    void (*keep)(void *context);                                /* the picture as it is goes to the gallery */
    void (*power)(void *context, bool on);                      /* of the screen */
    struct kiosk_sheet (*sheet)(void *context);
    /* A field of a stock picture for a fresh sheet that paints itself (ACTION_GUIDE); false: none is ready. May be
     * NULL. */
    bool (*guide)(void *context, struct action *guide);
    /* Lines of "name\tvalue\n" for the staff; may be NULL. */
    void (*status)(void *context, char *lines, size_t size);
    /* A picture to grow over, in a scene of trees (ACTION_STOCK): the one that it grows over, or the next; its raster
     * is good until some more have been given. False: it is not read yet, or there is none. May be NULL. */
    bool (*stock)(void *context, bool next, struct action *stock);
    /* What scene `scene` takes from others, as actions on a fresh sheet, EXHIBIT_FEEDS at most; their rasters are good
     * until some more have been given. False: not all is ready yet. `actions` NULL: only asks. May be NULL. */
    bool (*inputs)(void *context, int scene, struct action *actions, int *count);
    /* What is to be seen on the sheet now is what scene `scene` has come to, which others take. May be NULL. */
    void (*hand)(void *context, int scene);
    /* A transition (enum transition_kind) lies over everything but the kiosk's pieces: from nothing at share 0 to all
     * at 1, and to nothing at 2 (transition.h). False: it is not ready to be seen yet, and is asked for again. A wash:
     * none does any more. Called each kiosk_run while one is there. NULL: nothing is seen of them. */
    bool (*cover)(void *context, int kind, uint32_t seed, double share);
};

struct kiosk_def {
    struct exhibit *exhibit; /* taken over */
    int width, height;       /* pixels of the sheet */
    uint64_t seed;           /* of the day: what paints by itself is another every time */
    time_t built;            /* of this program: a clock that is before it was never set */
    bool open;               /* whatever the schedule says */
    bool resume;             /* in the middle of a visit in this scene: the sheet that there is has a painting */
    int scene;
    struct kiosk_stage stage;
};

struct kiosk;

/* In attract, or where it is to resume. NULL when memory is short; the exhibit is destroyed then. */
struct kiosk *kiosk_create(const struct kiosk_def *def, uint64_t now_us);
void kiosk_destroy(struct kiosk *kiosk); /* takes NULL */

/* The controls that paint; the caller's. NULL: there are none for now, and nothing is held any more. */
void kiosk_controls(struct kiosk *kiosk, struct controls *controls);
/* Whether the controls may feel the event, which may come out at another place (a reach-limited zone). */
bool kiosk_feel(struct kiosk *kiosk, struct event *event, uint64_t now_us);
/* What a visitor does to the sheet: it is posted, unless the visit is not for painting now. False: the stage had no
 * room for it. */
bool kiosk_act(struct kiosk *kiosk, const struct action *action, uint64_t event_us, uint64_t now_us);
void kiosk_wish(struct kiosk *kiosk, const struct wish *wish, uint64_t now_us);
void kiosk_run(struct kiosk *kiosk, uint64_t now_us, time_t time);
/* When kiosk_run has something to do: ms, at most `most`. */
int kiosk_timeout_ms(const struct kiosk *kiosk, uint64_t now_us, int most);

/* Another exhibit in place of the one there is, at once; taken over. The old one, whose scripts the studio may still
 * have, comes back: the caller destroys it when the studio has let go. */
struct exhibit *kiosk_exhibit(struct kiosk *kiosk, struct exhibit *exhibit, uint64_t now_us);
/* The exhibit's file cannot be used as it is now, and why; NULL: it can. The staff sees a mark, and reads it in the
 * status view. */
void kiosk_trouble(struct kiosk *kiosk, const char *report);
/* Whether a picture of the gallery may be shown now, in attract: once for each time. */
bool kiosk_wants_slide(struct kiosk *kiosk);
/* Shows it for as long as the exhibit says, unless somebody comes: RGBA, multiplied by alpha, from malloc, taken over.
 */
void kiosk_slide(struct kiosk *kiosk, uint8_t *rgba, int width, int height, uint64_t now_us);

/* The scene of this id is shown as soon as nobody paints. False: the exhibit has none. */
bool kiosk_want_scene(struct kiosk *kiosk, const char *id);
enum kiosk_hours { KIOSK_BY_SCHEDULE, KIOSK_OPEN, KIOSK_CLOSED };
/* Open or closed, whatever the schedule says, until told otherwise. */
void kiosk_keep_hours(struct kiosk *kiosk, enum kiosk_hours hours);

const struct exhibit *kiosk_shows(const struct kiosk *kiosk);
const struct exhibit_scene *kiosk_scene(const struct kiosk *kiosk);
/* A transition is over the sheet, or is about to be: each frame is another. */
bool kiosk_is_covered(const struct kiosk *kiosk);
/* The staff's view is up. */
bool kiosk_staff(const struct kiosk *kiosk);
/* The staff wants to leave. */
bool kiosk_leaves(const struct kiosk *kiosk);
const char *kiosk_state(const struct kiosk *kiosk); /* "attract", "painting", ... */
/* Whether what is on the sheet is a visitor's. */
bool kiosk_is_visited(const struct kiosk *kiosk);
uint32_t kiosk_visits(const struct kiosk *kiosk); /* begun */

#endif
