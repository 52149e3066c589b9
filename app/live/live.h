/* A session on a display: what `frond run` does where there is one. */
#ifndef FROND_LIVE_H
#define FROND_LIVE_H

#include "display.h"
#include "engine_choice.h"
#include "exhibit.h"
#include "inputs.h"
#include "live_clock.h"
#include "program.h"
#include "script.h"

struct live_def {
    enum engine_kind engine;
    const char *shaders;     /* folder of shader sources, looked at again when they change; NULL: the embedded ones */
    struct exhibit *exhibit; /* taken over: a kiosk; NULL: a session */
    bool open;               /* a kiosk: whatever its schedule says */
    const char *state;       /* folder that a kiosk may write to; NULL: none */
    const struct inputs *inputs; /* what visitors do; NULL: the default (inputs.h) */
    const char *trouble;         /* why the exhibit's file cannot be used and this one stands in for it; NULL: it can */
    bool hold;                   /* on a screen: no key reaches the system (source_touch.h) */
    const char *console;         /* with `hold`: the VT that takes no keys either; NULL: none */
    int rotation;                /* of the display, degrees clockwise: fingers turn along */
    const char *shot;            /* PNG of the last frame, written at the end; NULL: none */
    int frames;                  /* end after so many; 0: when told to */
    double ticks_per_second;     /* 0: as fast as they come */
    bool once;                   /* the session is painted once and stays; else it begins again and again */
    bool xray;                   /* the layers instead of the picture */
    bool governed;               /* less is computed where the machine is too slow or too hot */
    struct live_clock clock;     /* of a kiosk; all zero: the real ones */
};

struct live_def live_default_def(void);

/* Shows the session, or the exhibit whose first scene it is, until the window is closed, SIGINT or SIGTERM comes, or
 * the frames are done. What happens is said on stderr, a line each. False when it could not begin, or the last frame
 * not be written, with the reason said. The display stays the caller's. */
bool live(const struct script *script, struct display *display, const struct live_def *def);

#endif
