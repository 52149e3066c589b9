#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "bench.h"
#include "garden.h"
#include "journal.h"
#include "live_scene_state.h"
#include "rinse.h"

static const double PERIOD_LEAST_S = 1.0 / 240, PERIOD_MOST_S = 0.25;

void live_scene_note(struct live_scene *live, const struct script *script, enum scene_kind kind, const char *id)
{
    struct live_script *note = &live->scripts[live->script_count++ % LIVE_SCENE_SCRIPTS];
    *note = (struct live_script){.script = script, .kind = kind};
    snprintf(note->id, sizeof note->id, "%s", id);
}

/* What was told last of this script. */
static struct live_script told_of(const struct live_scene *live, const struct script *script)
{
    for (int i = live->script_count - 1; i >= 0 && i >= live->script_count - LIVE_SCENE_SCRIPTS; i--) {
        if (live->scripts[i % LIVE_SCENE_SCRIPTS].script == script) {
            return live->scripts[i % LIVE_SCENE_SCRIPTS];
        }
    }
    return (struct live_script){.kind = SCENE_PAINTING};
}

void live_scene_dry(struct live_scene *live)
{
    live->sheet.rinsed = false;
    memset(live->water, 0, sizeof live->water);
}

/* Another scene, on which nothing is, from this tick on, or none; with the lock. */
static void begin_scene(struct live_scene *live, enum scene_kind kind, const char *id, int64_t tick, int width,
                        int height)
{
    enum scene_kind before = live->sheet.kind;
    live->sheet.kind = kind;
    live->sheet.shows = live->types[kind] ? live->types[kind]->shows : SHOW_PICTURE;
    snprintf(live->id, sizeof live->id, "%s", id);
    live->cells = width;
    live->sheet.number += before != SCENE_PAINTING || kind != SCENE_PAINTING;
    live->sheet.can_undo = live->sheet.can_redo = 0;
    live->next_tick = tick;
    live->done = tick;
    live->behind = live->allowed = 0;
    live->fresh = false;
    live->epoch++;
    live_scene_dry(live);
    if (before != SCENE_PAINTING || kind != SCENE_PAINTING) {
        inbox_begin(&live->inbox, kind, width, height);
        live->calm = false;
    }
}

static void resize(struct live_scene *live, int width, int height)
{
    live->cells = width;
    if (live->sheet.kind != SCENE_PAINTING) {
        inbox_resize(&live->inbox, width, height);
        live->calm = false;
    }
}

/* Another script on the same sheet: what grows there goes on, if it is the same scene. */
static void change(struct live_scene *live, const struct studio_event *event)
{
    struct live_script script = told_of(live, event->script);
    if (script.kind == live->sheet.kind && strcmp(script.id, live->id) == 0) {
        resize(live, event->def.width, event->def.height);
    } else {
        begin_scene(live, script.kind, script.id, event->ticked, event->def.width, event->def.height);
    }
}

/* Under a front it is as far as the front is past, under a disc what the disc has taken. */
static void rinse(struct live_scene *live, const struct action *action)
{
    const struct canvas canvas = {.width = LIVE_WATER_WIDTH, .height = LIVE_WATER_HEIGHT};
    struct action legal = action_legal(action);
    struct rinse water;
    float turn;
    legal.radius *= (float)LIVE_WATER_WIDTH / (float)live->cells;
    rinse_begin(&water, &canvas, &legal);
    for (int y = water.cells.y0; y < water.cells.y1; y++) {
        for (int x = water.cells.x0; x < water.cells.x1; x++) {
            float *place = &live->water[y * LIVE_WATER_WIDTH + x], phase = rinse_phase(&water, x, y, &turn);
            float disc = 1 - (1 - *place) * (1 - rinse_takes(phase, legal.strength));
            *place = water.disc ? disc : fmaxf(*place, phase);
        }
    }
    live->sheet.rinsed = true;
    live->sheet.rinse = live->inbox.sequence;
}

/* Scenes hear of everything; a garden leaves most alone. */
static bool is_wanted(enum scene_kind kind, enum action_verb verb)
{
    return kind != SCENE_PAINTING && (kind != SCENE_TREES || scene_takes(kind, verb));
}

static void act(struct live_scene *live, int64_t tick, const struct action *action)
{
    if (!is_wanted(live->sheet.kind, action->verb)) {
        return;
    }
    inbox_do(&live->inbox, tick, action);
    live->calm = false;
    if (action->verb == ACTION_RINSE && live->sheet.kind == SCENE_TREES) {
        rinse(live, action);
    }
}

/* All ticks until this one, of what goes on with every tick. */
static void pass(struct live_scene *live, int64_t until)
{
    bool goes_on = live->sheet.kind != SCENE_PAINTING && live->sheet.kind != SCENE_TREES;
    int64_t count = until - live->next_tick;
    if (count > 0 && goes_on && inbox_ticks(&live->inbox, live->next_tick, count)) {
        live->behind += count;
    }
    live->next_tick = count > 0 ? until : live->next_tick;
}

static void note_tick(struct live_scene *live, int64_t ticked)
{
    double now_s = bench_wall_s();
    live->period_s = fmin(fmax(now_s - live->ticked_s, PERIOD_LEAST_S), PERIOD_MOST_S);
    live->ticked_s = now_s;
    live->ticked = ticked;
    pass(live, ticked);
}

/* Ticks of what is calm are done some at a time. */
static bool is_pressing(const struct live_scene *live)
{
    return inbox_any(&live->inbox) || (live->behind > 0 && (!live->calm || live->behind >= LIVE_SCENE_LEAD / 2));
}

/* Until the scene is not far behind. */
static void wait_for_it(struct live_scene *live)
{
    int64_t most = LIVE_SCENE_LEAD > live->allowed ? LIVE_SCENE_LEAD : live->allowed;
    double end = bench_wall_s() + 1e-3 * LIVE_SCENE_WAIT_MS;
    struct timespec until = {(time_t)end, (long)((end - floor(end)) * 1e9)};
    while (live->behind > most && !live->stop && !live->released && bench_wall_s() < end) {
        pthread_cond_timedwait(&live->caught, &live->lock, &until);
    }
}

static void take(struct live_scene *live, const struct studio_event *event)
{
    struct live_script script;
    switch (event->kind) {
    case STUDIO_SHEET:
        script = told_of(live, event->script);
        begin_scene(live, script.kind, script.id, event->ticked, event->def.width, event->def.height);
        break;
    case STUDIO_SCENE:
        change(live, event);
        break;
    case STUDIO_GRID:
        resize(live, event->def.width, event->def.height);
        break;
    case STUDIO_ACTION:
        act(live, event->ticked, event->action);
        break;
    case STUDIO_TICKED:
        note_tick(live, event->ticked);
        break;
    default:
        break;
    }
}

void live_scene_tell(void *data, const struct studio_event *event)
{
    struct live_scene *live = data;
    pthread_mutex_lock(&live->lock);
    take(live, event);
    if (is_pressing(live)) {
        pthread_cond_broadcast(&live->changed);
    }
    if (event->kind == STUDIO_TICKED) {
        wait_for_it(live);
    }
    pthread_mutex_unlock(&live->lock);
}

/* Once through a journal, to its end, with the lock: what was done since the sheet was fresh, or had another scene. */
static void read_journal(struct live_scene *live, enum scene_kind kind, struct journal_reader *reader)
{
    struct journal_record record;
    char id[BYTES_TEXT] = "";
    while (journal_next(reader, &record)) {
        bool same = record.kind == JOURNAL_SCENE && strcmp(id, record.sheet.scene) == 0;
        pass(live, record.ticked);
        if (record.kind == JOURNAL_SHEET || (record.kind == JOURNAL_SCENE && !same)) {
            memcpy(id, record.sheet.scene, sizeof id);
            begin_scene(live, kind, id, record.ticked, record.sheet.def.width, record.sheet.def.height);
        } else if (same) {
            resize(live, record.sheet.def.width, record.sheet.def.height);
        } else if (record.kind == JOURNAL_GRID) {
            resize(live, record.grid.width, record.grid.height);
        } else if (record.kind == JOURNAL_ACTION) {
            act(live, record.ticked, &record.action);
        }
    }
    live->ticked = reader->ticked;
}

bool live_scene_resume(struct live_scene *live, const struct script *script, enum scene_kind kind, const char *id,
                       const void *journal, size_t size)
{
    struct journal_reader reader;
    struct journal_error error;
    pthread_mutex_lock(&live->lock);
    live_scene_note(live, script, kind, id);
    begin_scene(live, kind, id, 0, script->width, script->height);
    bool good = journal && journal_open(&reader, journal, size, &error);
    if (good) {
        read_journal(live, kind, &reader);
        journal_close(&reader);
        snprintf(live->id, sizeof live->id, "%s", id);
    }
    live->allowed = live->behind + LIVE_SCENE_LEAD;
    pthread_cond_broadcast(&live->changed);
    pthread_mutex_unlock(&live->lock);
    return good;
}
