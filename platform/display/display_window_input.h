/* What SDL says of mouse and touchscreen, as fingers. */
#ifndef FROND_DISPLAY_WINDOW_INPUT_H
#define FROND_DISPLAY_WINDOW_INPUT_H

#include <stdbool.h>
#include <stdint.h>

#include <SDL_events.h>

#include "event.h"

enum { WINDOW_FINGERS = 16 }; /* slots: 0 is the mouse, fingers are 1.. */

struct window_input {
    bool pressed; /* the mouse's left button */
    bool down[WINDOW_FINGERS];
    int64_t finger[WINDOW_FINGERS]; /* SDL's name of the finger in the slot */
};

/* False when the event is none of a finger. The position is that on the panel, not turned; the time is not set. The
 * window has width x height points. */
bool window_input_take(struct window_input *input, const SDL_Event *event, int width, int height, struct event *finger);

#endif
