/* Back in time, and forth again: a history (history.h) does it, engines leave it alone. */
#include "painting_verb.h"
#include "verb_keys.h"

static const struct key UNDO[] = {END};
static const struct key REWIND[] = {
    PATH(true),
    RADIUS(24, "Half the width of the stroke; it fades over its outer half."),
    NUMBER(ticks, "ticks", 1, 3600, 60, "How far the middle of the stroke goes back."),
    END,
};

const struct verb verb_undo = {
    .name = "undo",
    .meaning = "Takes back what a visitor did last.",
    .keys = UNDO,
    .scene = SCENE_PAINTING,
    .shared = true,
    .back = true,
};

const struct verb verb_redo = {
    .name = "redo",
    .meaning = "Brings back what undo took.",
    .keys = UNDO,
    .scene = SCENE_PAINTING,
    .shared = true,
    .back = true,
};

const struct verb verb_rewind = {
    .name = "rewind",
    .meaning = "Takes what is under a stroke back in time; it grows on from there.",
    .keys = REWIND,
    .scene = SCENE_PAINTING,
    .back = true,
    .painting = &(const struct painting_verb){.mark = MARK_STILL},
};
