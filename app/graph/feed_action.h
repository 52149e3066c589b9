/* What one scene of an exhibit takes from another, as an action on a fresh sheet: journals, undo and the rest know
 * nothing else. */
#ifndef FROND_FEED_ACTION_H
#define FROND_FEED_ACTION_H

#include <stdbool.h>

#include "action.h"
#include "exhibit.h"
#include "outcome.h"

/* The action that an input of scene `to` does, from what the other scene has come to. Its raster is `*values`, from
 * malloc, at the outcome's size. False when memory is short. */
bool feed_action(const struct exhibit_feed *feed, const struct exhibit_scene *to, const struct outcome *from,
                 struct action *action, float **values);

#endif
