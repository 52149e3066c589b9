#include "hands.h"

#include <math.h>

/* How far a finger moves before it leaves another stroke: share of the sheet. */
static const float STROKE = 0.01f;

static struct action drop_at(const struct hand *hand)
{
    struct action drop = action_default(ACTION_DROP);
    drop.at = hand->at;
    drop.has_at = true;
    drop.ink = hand->ink;
    return drop;
}

static int stroke_to(struct hands *hands, struct hand *hand, struct point to, struct action actions[HANDS_ACTIONS])
{
    float dx = to.x - hand->at.x, dy = to.y - hand->at.y;
    if (sqrtf(dx * dx + dy * dy) < STROKE) {
        return 0;
    }
    hands->path[0] = hand->at;
    hands->path[1] = to;
    hand->at = to;
    actions[0] = action_default(ACTION_BRUSH_SOLVENT);
    actions[1] = action_default(ACTION_BRUSH_INK);
    actions[1].ink = hand->ink;
    for (int i = 0; i < HANDS_ACTIONS; i++) {
        actions[i].path = (struct action_path){hands->path, 2};
    }
    return HANDS_ACTIONS;
}

int hands_feel(struct hands *hands, const struct event *event, struct action actions[HANDS_ACTIONS])
{
    if (event->slot < 0 || event->slot >= HANDS_FINGERS) {
        return 0;
    }
    struct hand *hand = &hands->hand[event->slot];
    struct point at = {event->x, event->y};
    switch (event->kind) {
    case EVENT_DOWN:
        *hand = (struct hand){true, hands->next, at};
        hands->next = (hands->next + 1) % hands->inks;
        actions[0] = drop_at(hand);
        return 1;
    case EVENT_MOVE:
        return hand->down ? stroke_to(hands, hand, at, actions) : 0;
    case EVENT_UP:
    case EVENT_CANCEL:
        hand->down = false;
        return 0;
    case EVENT_NONE:
    default:
        return 0;
    }
}

bool hands_are_down(const struct hands *hands)
{
    for (int i = 0; i < HANDS_FINGERS; i++) {
        if (hands->hand[i].down) {
            return true;
        }
    }
    return false;
}
