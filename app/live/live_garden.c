#include "live_garden.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "journal.h"
#include "live_garden_state.h"
#include "rinse.h"

static const double PERIOD_LEAST_S = 1.0 / 240, PERIOD_MOST_S = 0.25;

struct live_garden *live_garden_create(void)
{
    struct live_garden *live = calloc(1, sizeof *live);
    pthread_condattr_t attributes;
    if (!live) {
        return NULL;
    }
    live->front = 0;
    live->ready = 1;
    live->back = 2;
    live->period_s = PERIOD_MOST_S;
    pthread_mutex_init(&live->lock, NULL);
    pthread_condattr_init(&attributes);
    pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
    pthread_cond_init(&live->changed, &attributes);
    pthread_condattr_destroy(&attributes);
    if (pthread_create(&live->thread, NULL, live_garden_work, live) != 0) {
        pthread_cond_destroy(&live->changed);
        pthread_mutex_destroy(&live->lock);
        free(live);
        return NULL;
    }
    return live;
}

void live_garden_destroy(struct live_garden *live)
{
    if (!live) {
        return;
    }
    pthread_mutex_lock(&live->lock);
    live->stop = true;
    pthread_cond_broadcast(&live->changed);
    pthread_mutex_unlock(&live->lock);
    pthread_join(live->thread, NULL);
    inbox_finish(&live->inbox);
    for (int i = 0; i < 3; i++) {
        plate_finish(&live->plates[i].plate);
    }
    pthread_cond_destroy(&live->changed);
    pthread_mutex_destroy(&live->lock);
    free(live);
}

static void note_scene(struct live_garden *live, const struct script *script, bool has)
{
    live->scenes[live->scene_count++ % LIVE_GARDEN_SCENES] = (struct live_garden_scene){script, has};
}

void live_garden_scene(struct live_garden *live, const struct script *script, bool has)
{
    pthread_mutex_lock(&live->lock);
    note_scene(live, script, has);
    pthread_mutex_unlock(&live->lock);
}

/* What was told last of this script. */
static bool has_garden(const struct live_garden *live, const struct script *script)
{
    for (int i = live->scene_count - 1; i >= 0 && i >= live->scene_count - LIVE_GARDEN_SCENES; i--) {
        if (live->scenes[i % LIVE_GARDEN_SCENES].script == script) {
            return live->scenes[i % LIVE_GARDEN_SCENES].has;
        }
    }
    return false;
}

/* A garden on which nothing grows, or none; with the lock. */
static void begin(struct live_garden *live, bool on, int width, int height)
{
    bool was = live->sheet.on;
    live->sheet.on = on;
    live->cells = width;
    live->sheet.number += was || on;
    live->sheet.can_undo = live->sheet.can_redo = 0;
    live_garden_dry(live);
    if (on) {
        inbox_begin(&live->inbox, width, height);
    } else if (was) {
        inbox_end(&live->inbox);
    }
}

static void resize(struct live_garden *live, int width, int height)
{
    live->cells = width;
    inbox_resize(&live->inbox, width, height);
}

/* Another script on the same sheet: what grows there goes on, if anything may. */
static void change(struct live_garden *live, const struct studio_event *event)
{
    bool on = has_garden(live, event->script);
    if (on && live->sheet.on) {
        resize(live, event->def.width, event->def.height);
    } else {
        begin(live, on, event->def.width, event->def.height);
    }
}

/* Under a front it is as far as the front is past, under a disc what the disc has taken. */
static void rinse(struct live_garden *live, const struct action *action)
{
    const struct painting_def sheet = {.width = LIVE_WATER_WIDTH, .height = LIVE_WATER_HEIGHT};
    struct action legal = action_legal(action);
    struct rinse water;
    float turn;
    legal.radius *= (float)LIVE_WATER_WIDTH / (float)live->cells;
    rinse_begin(&water, &sheet, &legal);
    for (int y = water.cells.y0; y < water.cells.y1; y++) {
        for (int x = water.cells.x0; x < water.cells.x1; x++) {
            float *place = &live->water[y * LIVE_WATER_WIDTH + x], phase = rinse_phase(&water, x, y, &turn);
            float disc = 1 - (1 - *place) * (1 - rinse_shares(phase, legal.strength).thins);
            *place = water.disc ? disc : fmaxf(*place, phase);
        }
    }
    live->sheet.rinsed = true;
    live->sheet.rinse = live->inbox.sequence;
}

static bool is_wanted(enum action_verb verb)
{
    return garden_takes(verb) || verb == ACTION_CLEAR || verb == ACTION_UNDO || verb == ACTION_REDO ||
           verb == ACTION_RINSE;
}

static void act(struct live_garden *live, int64_t tick, const struct action *action)
{
    if (!live->sheet.on || !is_wanted(action->verb)) {
        return;
    }
    inbox_do(&live->inbox, tick, action);
    if (action->verb == ACTION_RINSE) {
        rinse(live, action);
    }
}

static void note_tick(struct live_garden *live, int64_t ticked)
{
    double now_s = bench_wall_s();
    live->period_s = fmin(fmax(now_s - live->ticked_s, PERIOD_LEAST_S), PERIOD_MOST_S);
    live->ticked_s = now_s;
    live->ticked = ticked;
}

void live_garden_tell(void *data, const struct studio_event *event)
{
    struct live_garden *live = data;
    pthread_mutex_lock(&live->lock);
    uint64_t sequence = live->inbox.sequence;
    switch (event->kind) {
    case STUDIO_SHEET:
        begin(live, has_garden(live, event->script), event->def.width, event->def.height);
        break;
    case STUDIO_SCENE:
        change(live, event);
        break;
    case STUDIO_GRID:
        if (live->sheet.on) {
            resize(live, event->def.width, event->def.height);
        }
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
    if (live->inbox.sequence != sequence) {
        pthread_cond_broadcast(&live->changed);
    }
    pthread_mutex_unlock(&live->lock);
}

/* Once through a journal, to its end, with the lock: what was done since the sheet was fresh, or had another scene. */
static void read_journal(struct live_garden *live, struct journal_reader *reader)
{
    struct journal_record record;
    char id[BYTES_TEXT] = "";
    while (journal_next(reader, &record)) {
        bool same = record.kind == JOURNAL_SCENE && live->sheet.on && strcmp(id, record.sheet.scene) == 0;
        if (record.kind == JOURNAL_SHEET || (record.kind == JOURNAL_SCENE && !same)) {
            inbox_finish(&live->inbox);
            memcpy(id, record.sheet.scene, sizeof id);
            begin(live, true, record.sheet.def.width, record.sheet.def.height);
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

bool live_garden_resume(struct live_garden *live, const struct script *script, const void *journal, size_t size)
{
    struct journal_reader reader;
    struct journal_error error;
    pthread_mutex_lock(&live->lock);
    note_scene(live, script, true);
    begin(live, true, script->width, script->height);
    bool good = journal && journal_open(&reader, journal, size, &error);
    if (good) {
        read_journal(live, &reader);
        journal_close(&reader);
    }
    pthread_cond_broadcast(&live->changed);
    pthread_mutex_unlock(&live->lock);
    return good;
}

void live_garden_size(struct live_garden *live, int width, int height)
{
    pthread_mutex_lock(&live->lock);
    if (live->width != width || live->height != height) {
        live->width = width;
        live->height = height;
        pthread_cond_broadcast(&live->changed);
    }
    pthread_mutex_unlock(&live->lock);
}

const struct live_garden_plate *live_garden_newest(struct live_garden *live, bool *fresh)
{
    pthread_mutex_lock(&live->lock);
    *fresh = live->fresh;
    if (live->fresh) {
        int front = live->front;
        live->front = live->ready;
        live->ready = front;
        live->fresh = false;
    }
    const struct live_garden_plate *newest = &live->plates[live->front];
    pthread_mutex_unlock(&live->lock);
    return newest;
}

bool live_garden_has_newer(struct live_garden *live)
{
    pthread_mutex_lock(&live->lock);
    bool newer = live->fresh;
    pthread_mutex_unlock(&live->lock);
    return newer;
}

bool live_garden_is_calm(struct live_garden *live)
{
    pthread_mutex_lock(&live->lock);
    bool calm = live->inbox.count == 0 && !live->works && !live->wanted;
    pthread_mutex_unlock(&live->lock);
    return calm;
}

struct live_garden_sheet live_garden_sheet(struct live_garden *live, double now_s)
{
    pthread_mutex_lock(&live->lock);
    struct live_garden_sheet sheet = live->sheet;
    double since = fmax(now_s - live->ticked_s, 0) / live->period_s;
    sheet.tick = (double)live->ticked + (live->ticked_s > 0 ? fmin(since, 1) : 0);
    pthread_mutex_unlock(&live->lock);
    return sheet;
}

void live_garden_water(struct live_garden *live, uint8_t water[LIVE_WATER_WIDTH * LIVE_WATER_HEIGHT])
{
    pthread_mutex_lock(&live->lock);
    for (int i = 0; i < LIVE_WATER_WIDTH * LIVE_WATER_HEIGHT; i++) {
        water[i] = (uint8_t)lrintf(255 * live->water[i]);
    }
    pthread_mutex_unlock(&live->lock);
}
