#include "script_session.h"

#include <stdlib.h>
#include <string.h>

#include "file_rows.h"
#include "outcome.h"
#include "raster.h"
#include "rounded.h"
#include "script_action.h"
#include "script_include.h"

enum { PATH_BYTES = 1000, TICKS = 20000 };

struct script_session {
    const char *file;
    int of; /* enum scene_field */
    float strength;
    int tick; /* 0: its own end */
    bool invert;
};

/* One that has been grown. */
struct script_grown {
    struct script_grown *next;
    const char *file;
    int tick;
    int width, height;
    float *fields[SCENE_FIELDS]; /* the script's memory */
};

#define SESSION struct script_session
const struct key script_session_keys[] = {
    TEXT("file", SESSION, file, "the path of a session script in this file's folder", PATH_BYTES, true,
         "The session that is grown."),
    FIELD_KEY(offsetof(SESSION, of)),
    NUMBER("strength", SESSION, strength, "share", 0, 1, 1, false,
           "How dark what is dark is, or how long the vectors are."),
    WHOLE("tick", SESSION, tick, "ticks", 0, TICKS, 0, false, "How long it grows; 0: as long as it says itself."),
    FLAG("invert", SESSION, invert, 0, "Whether dark and light change places; of vectors, forward and back."),
    END,
};

static struct script_grown *find(struct reader *reader, const struct script_session *session)
{
    struct script_grown *grown = reader->grown;
    while (grown && (grown->tick != session->tick || strcmp(grown->file, session->file) != 0)) {
        grown = grown->next;
    }
    return grown;
}

/* The outcome into the script's memory. */
static struct script_grown *keep(struct reader *reader, const struct script_session *session, struct outcome *outcome)
{
    struct script_grown *grown = reader_take(reader, sizeof *grown);
    bool good = grown;
    for (int i = 0; i < SCENE_FIELDS; i++) {
        float *field = outcome->fields[i];
        outcome->fields[i] = NULL; /* it is taken over, or gone */
        good = reader_adopt(reader, field) && good;
        if (good) {
            grown->fields[i] = field;
        }
    }
    if (!good) {
        return NULL;
    }
    grown->file = session->file;
    grown->tick = session->tick;
    grown->width = outcome->width;
    grown->height = outcome->height;
    grown->next = reader->grown;
    reader->grown = grown;
    return grown;
}

/* Cells times ticks against what a file may have. */
static bool take_work(struct reader *reader, const struct yaml_node *at, const struct script *script, int64_t ticks)
{
    int64_t *spent = reader->def->spent ? reader->def->spent : &reader->spent;
    int64_t work = (int64_t)script->width * script->height * ticks, most = reader->def->work_max;
    if (ticks > TICKS) {
        reader_problem(reader, at, "%lld ticks; at most %d, by a tick or by its own", (long long)ticks, TICKS);
        return false;
    }
    if (work > most - *spent) {
        reader_problem(reader, at,
                       "too much to grow for one file; %lld million cells times ticks in all its sessions together",
                       (long long)(most / 1000000));
        return false;
    }
    *spent += work;
    return true;
}

static struct script_grown *grow(struct reader *reader, const struct yaml_node *at,
                                 const struct script_session *session)
{
    struct script_grown *grown = NULL;
    struct file_error error;
    struct outcome outcome = {.width = 0};
    struct script *script = script_include(reader, at, session->file);
    int64_t ticks = script ? session->tick > 0 ? session->tick : script->ticks : 0;
    size_t values = script ? 4 * (size_t)script->width * (size_t)script->height : 0;
    if (script && script_take_values(reader, at, values) && take_work(reader, at, script, ticks)) {
        if (outcome_grow(&outcome, script, ticks, 0, NULL, &error)) {
            grown = keep(reader, session, &outcome);
        } else {
            reader_problem(reader, at, "%s", error.text);
        }
    }
    outcome_finish(&outcome);
    script_destroy(script);
    return grown;
}

static void scale(float *values, size_t count, bool vectors, const struct script_session *session)
{
    for (size_t i = 0; i < count; i++) {
        float value = vectors ? session->invert ? -values[i] : values[i] : session->invert ? 1 - values[i] : values[i];
        value = vectors ? value * session->strength : 1 - session->strength * (1 - value);
        values[i] = rounded(value);
    }
}

/* What is asked for as the picture of the action. */
static bool take_raster(struct reader *reader, const struct yaml_node *node, const struct script_grown *grown,
                        const struct script_session *session, struct action *action)
{
    bool vectors = session->of == FIELD_ALONG, turned = action->verb == ACTION_GUIDE && !vectors;
    size_t cells = (size_t)grown->width * (size_t)grown->height;
    size_t given = cells * (vectors ? 2 : 1), count = action->verb == ACTION_GUIDE ? 2 * cells : given;
    if (!script_take_values(reader, node, count)) {
        return false;
    }
    float *values = reader_take(reader, count * sizeof *values);
    if (!values) {
        return false;
    }
    memcpy(values, grown->fields[session->of], given * sizeof *values);
    scale(values, given, vectors, session);
    if (turned) {
        struct script_picture picture = {grown->width, grown->height, 1, malloc(cells * sizeof(float))};
        enum raster_kind kind = action->reading == READ_ALONG_EDGES ? RASTER_ALONG_EDGES : RASTER_TOWARDS_DARK;
        bool good = picture.values;
        if (good) {
            memcpy(picture.values, values, cells * sizeof *values);
            good = raster_from_picture(&picture, kind, grown->width, grown->height, values);
        }
        free(picture.values);
        if (!good) {
            reader_problem(reader, node, "memory is short");
            return false;
        }
    }
    action->picture = (struct action_raster){values, grown->width, grown->height, action->verb == ACTION_GUIDE ? 2 : 1};
    return true;
}

/* Whether the action takes what is asked for. */
static bool check_type(struct reader *reader, const struct yaml_node *node, const struct script_session *session,
                       const struct action *action)
{
    const struct yaml_node *of = yaml_get(node, "of");
    size_t length = reader_enter(reader, "of");
    bool good = session->of != FIELD_ALONG || action->verb == ACTION_GUIDE;
    if (!good) {
        reader_problem(reader, of, "'along' is a vector, and %s takes a scalar; dark, or around",
                       action_name(action->verb));
    } else if (session->of != FIELD_ALONG && action->verb == ACTION_GUIDE && action->reading == READ_VECTORS) {
        reader_problem(reader, of ? of : node, "'%s' is a scalar; along, or the reading towards dark, or along edges",
                       scene_field_names[session->of]);
        good = false;
    }
    reader_leave(reader, length);
    return good;
}

bool script_session_read(struct reader *reader, const struct yaml_node *node, struct action *action)
{
    struct script_session session = {.file = NULL};
    int before = reader->report->count + reader->report->dropped;
    if (node->kind != YAML_MAPPING) {
        value_wrong_kind(reader, node, "{file: SESSION, of: dark, ...}; see frond explain session");
        return false;
    }
    key_defaults(script_session_keys, &session);
    mapping_read(reader, script_session_keys, node, &session, NULL);
    if (reader->report->count + reader->report->dropped != before || !check_type(reader, node, &session, action)) {
        return false;
    }
    const struct yaml_node *at = yaml_get(node, "file");
    size_t length = reader_enter(reader, "file");
    struct script_grown *grown = find(reader, &session);
    if (!grown && !reader->def->load) {
        reader_problem(reader, at, "sessions cannot be read here; a formula can");
    } else if (!grown) {
        grown = grow(reader, at, &session);
    }
    bool good = grown && take_raster(reader, node, grown, &session, action);
    reader_leave(reader, length);
    return good;
}
