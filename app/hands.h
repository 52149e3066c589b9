/* What fingers do to a painting, until an exhibit says otherwise: a finger that comes down lays a drop, in the next of
 * the inks; one that moves draws solvent and ink after it. */
#ifndef FROND_HANDS_H
#define FROND_HANDS_H

#include <stdbool.h>

#include "action.h"
#include "event.h"

enum { HANDS_FINGERS = 10, HANDS_ACTIONS = 2 };

struct hands {
    int inks; /* of the palette, 1 or more */
    int next; /* ink of the next finger */
    struct hand {
        bool down;
        int ink;
        struct point at;
    } hand[HANDS_FINGERS];
    struct point path[2]; /* of the actions given out last */
};

/* Actions for an event, `count` of them; their paths are good until the next call. */
int hands_feel(struct hands *hands, const struct event *event, struct action actions[HANDS_ACTIONS]);

/* Whether any finger is on the sheet. */
bool hands_are_down(const struct hands *hands);

#endif
