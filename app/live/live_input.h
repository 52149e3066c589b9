/* What visitors do to a live session: events of the display and of all sources become actions for the studio, and how
 * long that takes is measured. */
#ifndef FROND_LIVE_INPUT_H
#define FROND_LIVE_INPUT_H

#include "controls.h"
#include "display.h"
#include "lamps.h"
#include "latency.h"
#include "live_clock.h"
#include "sources.h"
#include "studio.h"

struct kiosk;

struct live_input {
    struct kiosk *kiosk;     /* hears everything first, and posts; NULL: a session */
    struct live_clock clock; /* the kiosk's */
    struct inputs *own;      /* the default ones, where none were given */
    struct sources *sources;
    struct controls *controls;
    struct lamps lamps;
    struct latency latency;
    uint64_t number, before; /* fields on their way to the screen; frames presented before them */
    uint64_t refused;        /* actions that the studio had no room for */
};

struct live_input_def {
    const struct inputs *inputs;      /* NULL: the default ones; else the caller's, which outlive this */
    int rotation;                     /* of the display, degrees clockwise */
    bool hold;                        /* on a screen: no key reaches the system */
    const char *console;              /* with `hold`: the VT that takes no keys (source_touch.h); NULL: none */
    const struct exhibit_seat *seats; /* copied; NULL: one */
    int seat_count;
    struct kiosk *kiosk; /* as above */
    struct live_clock clock;
};

/* False when memory is short. */
bool live_input_open(struct live_input *input, const struct script *script, struct display *display,
                     const struct live_input_def *def);
void live_input_close(struct live_input *input); /* takes a zeroed one */
/* How long the display may wait before there is something to do here, at most `most`. */
int live_input_wait_ms(const struct live_input *input, int most);
/* Takes what has happened, and posts what follows. */
void live_input_feel(struct live_input *input, struct display *display, struct studio *studio);
/* A frame with the fields of this number is about to be presented (display_end). */
void live_input_draws(struct live_input *input, const struct display *display, uint64_t number);
/* Nobody sees what is painted: nothing of it is measured. */
void live_input_unseen(struct live_input *input);
/* The next line for the log. */
bool live_input_log(struct live_input *input, char *line, int size);

#endif
