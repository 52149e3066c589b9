/* A kiosk's painting kept against crashes (keep.h): taken up again at the start, kept while a visitor paints. Without a
 * state folder, or a session, it does nothing. */
#ifndef FROND_LIVE_KEEP_H
#define FROND_LIVE_KEEP_H

#include "exhibit.h"
#include "keep.h"
#include "live_scene.h"
#include "studio.h"

struct live_keep {
    struct keep *keep; /* NULL: nothing is kept */
    struct keep_found found;
    int scene; /* of the exhibit, that was found; -1: nothing that can be gone on with was */
    bool said; /* what was found */
};

/* `state`: folder; NULL: none. `exhibit` NULL: a session. What has grown is given back to the scene. Never fails:
 * what cannot be kept is told by the log. */
void live_keep_open(struct live_keep *keep, const char *state, const struct exhibit *exhibit, enum engine_kind engine,
                    struct live_scene *scene);
/* After the studio. */
void live_keep_close(struct live_keep *keep);
/* What the studio begins with, and whom it tells. */
void live_keep_studio(struct live_keep *keep, const struct exhibit *exhibit, struct studio_def *def);
/* A visitor paints, or nobody does. */
void live_keep_visit(struct live_keep *keep, bool on);
void live_keep_scene(struct live_keep *keep, const struct exhibit_scene *scene);
/* A descriptor with the whole journal of the sheet, for the caller to close; -1: there is none. */
int live_keep_journal(struct live_keep *keep);
/* The next line for the log. */
bool live_keep_log(struct live_keep *keep, char *line, int size);

#endif
