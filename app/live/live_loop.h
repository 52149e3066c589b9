/* The loop of a live session, a turn at a time: live() for those who do something between the turns. Private to live.c
 * and to tests. */
#ifndef FROND_LIVE_LOOP_H
#define FROND_LIVE_LOOP_H

#include "live.h"
#include "live_care.h"
#include "live_group.h"
#include "live_input.h"
#include "live_kiosk.h"
#include "live_picture.h"
#include "live_scene.h"
#include "live_scene_draw.h"
#include "live_service.h"
#include "log.h"
#include "studio.h"

enum { LIVE_LISTENERS = 2 };

struct live {
    const struct script *script;
    const struct live_def *def;
    struct display *display;
    struct studio *studio;
    struct live_picture picture;
    struct live_care care;
    struct live_input input;
    struct live_keep painting;
    struct live_scene *scene;                      /* NULL: a session of nothing but painting */
    struct live_scene_draw scene_draw;             /* of the scene */
    struct studio_teller listener[LIVE_LISTENERS]; /* to what happens in the studio */
    struct live_service service;
    struct live_group group;
    struct log log;
    struct live_kiosk kiosk; /* without an exhibit it does nothing */
    struct shader_folder folder;
    struct engine_choice choice;
    int signals; /* a descriptor that becomes readable when it is time to go */
    enum display_state state;
    char described[300]; /* what was said of the display last */
    double presented_s;  /* when a frame was presented last */
    bool moved;          /* something on it was new */
    double second_s;     /* when it was looked after last */
    bool said_end;
};

/* As live() begins; `live` stays where it is, `def` is kept. False with the reason said; to be closed in any case. */
bool live_open(struct live *live, const struct script *script, struct display *display, const struct live_def *def);
/* Whether it is time to go. */
bool live_over(const struct live *live);
/* Waits until there is something to do, 100 ms at most, and does it. False with the reason said: it cannot go on. */
bool live_turn(struct live *live);
void live_close(struct live *live);

#endif
