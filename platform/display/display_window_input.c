#include "display_window_input.h"

/* A mouse whose button is down is heard beyond the window too. */
static float clamp(float value)
{
    return value < 0 ? 0 : value > 1 ? 1 : value;
}

/* SDL names its own mouse events made of touches, and we asked for none. */
static bool take_mouse(struct window_input *input, const SDL_Event *event, int width, int height, struct event *finger)
{
    int x = event->type == SDL_MOUSEMOTION ? event->motion.x : event->button.x;
    int y = event->type == SDL_MOUSEMOTION ? event->motion.y : event->button.y;
    bool left = event->type == SDL_MOUSEMOTION || event->button.button == SDL_BUTTON_LEFT;
    if (!left || (event->type == SDL_MOUSEBUTTONDOWN) == input->pressed) {
        return false;
    }
    finger->kind = event->type == SDL_MOUSEMOTION       ? EVENT_MOVE
                   : event->type == SDL_MOUSEBUTTONDOWN ? EVENT_DOWN
                                                        : EVENT_UP;
    input->pressed = finger->kind != EVENT_UP;
    finger->slot = 0;
    finger->x = clamp(((float)x + .5f) / (float)width); /* the point's middle */
    finger->y = clamp(((float)y + .5f) / (float)height);
    return true;
}

static int slot_of(const struct window_input *input, int64_t name)
{
    for (int i = 1; i < WINDOW_FINGERS; i++) {
        if (input->down[i] && input->finger[i] == name) {
            return i;
        }
    }
    return 0;
}

static int free_slot(const struct window_input *input)
{
    for (int i = 1; i < WINDOW_FINGERS; i++) {
        if (!input->down[i]) {
            return i;
        }
    }
    return 0;
}

static bool take_touch(struct window_input *input, const SDL_TouchFingerEvent *touch, struct event *finger)
{
    int slot = slot_of(input, touch->fingerId);
    if (touch->type == SDL_FINGERDOWN && slot == 0) {
        slot = free_slot(input);
        finger->kind = EVENT_DOWN;
    } else {
        finger->kind = touch->type == SDL_FINGERUP ? EVENT_UP : EVENT_MOVE;
    }
    if (slot == 0) {
        return false; /* more fingers than slots, or one that never came down */
    }
    input->down[slot] = finger->kind != EVENT_UP;
    input->finger[slot] = touch->fingerId;
    finger->slot = slot;
    finger->x = clamp(touch->x);
    finger->y = clamp(touch->y);
    return true;
}

bool window_input_take(struct window_input *input, const SDL_Event *event, int width, int height, struct event *finger)
{
    *finger = (struct event){.kind = EVENT_NONE};
    switch (event->type) {
    case SDL_MOUSEMOTION:
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
        return take_mouse(input, event, width, height, finger);
    case SDL_FINGERDOWN:
    case SDL_FINGERMOTION:
    case SDL_FINGERUP:
        return take_touch(input, &event->tfinger, finger);
    default:
        return false;
    }
}
