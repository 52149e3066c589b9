/* What there is to know of a verb. A new one is a file that defines its `struct verb`, and a line in verbs.h: scripts,
 * bindings, journals, `check` and `explain` have it then. What it does to a painting is in the same file
 * (painting_verb.h); what it does to a scene of another kind, in the `act` of that kind's scene_type (scene.h). */
#ifndef FROND_VERB_H
#define FROND_VERB_H

#include "scene.h"

struct painting_verb;

struct verb {
    const char *name;       /* as scripts write it */
    const char *meaning;    /* one sentence */
    const struct key *keys; /* its parameters, over struct action; ends with a key whose name is NULL */
    enum scene_kind scene;  /* that it is for */
    bool shared;            /* for scenes of every kind all the same */
    bool needs_place;       /* one of its places must be given: at, path, formula, picture, as many as it has */
    bool whole;             /* without a place it is for the whole sheet */
    bool one_place;         /* not both at and a path */
    bool back;              /* a history does it (history.h): what was done is taken back, or comes again */
    const struct painting_verb *painting; /* what it does to a painting; NULL: nothing */
};

extern const struct verb *const verbs[ACTION_VERBS];

#define VERB(NAME, name) extern const struct verb verb_##name;
ACTION_VERB_LIST(VERB)
#undef VERB

#endif
