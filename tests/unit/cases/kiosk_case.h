/* A kiosk in a hall with a clock of its own: real controls, a fake stage that counts ticks and remembers what it was
 * told. */
#ifndef FROND_KIOSK_CASE_H
#define FROND_KIOSK_CASE_H

#include <time.h>

#include "kiosk.h"
#include "kiosk_look.h"

enum { HALL_TOLD = 65536, HALL_FRAME_US = 16667, HALL_WIDTH = 1920, HALL_HEIGHT = 1080 };

enum hall_what { HALL_POST, HALL_FRESH, HALL_CHANGE, HALL_KEEP, HALL_POWER };

struct hall_told {
    enum hall_what what;
    enum action_verb verb; /* of HALL_POST */
    int visitor, ink;
    struct point at;
    bool has_at;
    int option;  /* of ACTION_SHAPE, ACTION_CONDUCT, ACTION_REACT */
    float value; /* of it; of ACTION_TEND and ACTION_ATTRACT the amount */
    int picture; /* of ACTION_STOCK: hall.picture */
    bool on;     /* of HALL_POWER */
    uint64_t us;
};

struct hall {
    int width, height; /* pixels of the sheet */
    struct kiosk *kiosk;
    struct controls *controls;
    uint64_t now_us;
    time_t wall; /* at now_us 0 */
    struct kiosk_sheet sheet;
    bool dark;
    struct hall_told told[HALL_TOLD];
    int count;
    int picture;  /* that is grown over */
    bool reading; /* the next one is not there yet */
    float shade;
    bool unready; /* what scenes take from others is not ready */
    int handed;   /* times that a scene was handed over, */
    int hands;    /* the last of them, */
    int taken;    /* times that a scene took what others give */
    int cover;    /* transition that is seen now, enum transition_kind */
    uint32_t cover_seed;
    double cover_share;
    double fresh_share;                                      /* of it, when the sheet was fresh last */
    int uncovered;                                           /* frames that it takes until it is ready to be seen */
    const struct script *script;                             /* that was changed to last */
    bool (*act)(void *context, const struct action *action); /* NULL, or who does what is posted */
    void (*tick)(void *context, bool fresh);
    void *context;
};

/* The exhibit is one in YAML with inputs; it must be right. HALL_WIDTH x HALL_HEIGHT. */
struct hall *hall_open(const char *yaml);
struct hall *hall_open_resumed(const char *yaml); /* in the middle of a visit */
struct hall *hall_open_sized(const char *yaml, int width, int height);
void hall_close(struct hall *hall);
struct exhibit *hall_exhibit(const char *yaml);
/* So many seconds of frames. */
void hall_wait(struct hall *hall, double seconds);
void hall_feel(struct hall *hall, const struct event *event);
/* A finger comes down and leaves after so long, 0..1 of the sheet. */
void hall_tap(struct hall *hall, float x, float y, double seconds);
/* A finger of the first touchscreen. */
void hall_touch(struct hall *hall, enum event_kind kind, int slot, float x, float y);
/* A button of the palette, once that is back; fails when it has none. */
void hall_press(struct hall *hall, int kind, int value);
void hall_drag(struct hall *hall, float x, float y, float to_x, float to_y, double seconds);
void hall_button(struct hall *hall, uint32_t number, double seconds);
/* How often it was told that, since the `since`th; of posts only those of this verb, if it is one. */
int hall_count(const struct hall *hall, int since, enum hall_what what, enum action_verb verb);
/* How often visitors did that. */
int hall_painted(const struct hall *hall, int since, enum action_verb verb);
/* The middle of the first button of this kind and value on a panel, 0..1 of the sheet; false: there is none. */
bool hall_find(const struct hall *hall, int panel, int kind, int value, struct point *at);

#endif
