#include "studio_work.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench.h"
#include "painting_gpu.h"
#include "script_sheet.h"

static const int64_t REST_TICKS = 20 * STUDIO_TICKS_PER_SECOND; /* a finished painting is looked at for so long */

static int scaled(int cells, float scale, int least)
{
    int count = (int)lroundf((float)cells * scale);
    return count > least ? count : least;
}

struct painting_def studio_painting(const struct studio *studio, float scale)
{
    struct painting_def def = script_painting(studio->def.script);
    def.width = scaled(def.width, scale, PAINTING_SIZE_MIN);
    def.height = scaled(def.height, scale, PAINTING_SIZE_MIN);
    def.margin = scaled(def.margin, scale, 0);
    def.seed += (uint32_t)(studio->report.sessions > 0 ? studio->report.sessions - 1 : 0);
    def.threads = studio->def.threads;
    return def;
}

static struct engine *make_engine(struct studio *studio, const struct painting_def *def)
{
    struct shader_error error;
    struct engine *engine;
    if (studio->def.engine == ENGINE_CPU) {
        engine = engine_cpu_create(def);
        snprintf(error.text, sizeof error.text, "memory is short for a sheet of %dx%d cells", def->width, def->height);
    } else {
        engine = engine_gpu_create(def, studio->def.folder, &error);
    }
    if (!engine) {
        snprintf(studio->error.text, sizeof studio->error.text, "engine %s: %s", engine_kind_name(studio->def.engine),
                 error.text);
    }
    return engine;
}

static void set_trouble(struct studio *studio, const char *text)
{
    pthread_mutex_lock(&studio->lock);
    snprintf(studio->report.trouble, sizeof studio->report.trouble, "%.190s", text);
    pthread_mutex_unlock(&studio->lock);
}

static void act(struct studio *studio, const struct studio_action *posted)
{
    struct action action = posted->action;
    studio->changed_since = true;
    if (posted->copied) {
        action.path.points = posted->points;
    }
    studio->engine->ops->act(studio->engine, &action);
}

/* Does an action, and keeps it until a checkpoint holds it. */
static void act_and_keep(struct studio *studio, const struct studio_action *posted)
{
    act(studio, posted);
    if (studio->def.engine == ENGINE_GPU && studio->journal_count < STUDIO_JOURNAL) {
        studio->journal[studio->journal_count++] = *posted;
    }
}

/* For whoever measures; with the lock held. The oldest goes when nobody has looked for long. */
static void note_consumed(struct studio *studio, uint64_t event_us)
{
    if (studio->consumed_count == STUDIO_CONSUMED) {
        studio->consumed_first = (studio->consumed_first + 1) % STUDIO_CONSUMED;
        studio->consumed_count--;
    }
    int last = (studio->consumed_first + studio->consumed_count++) % STUDIO_CONSUMED;
    studio->consumed[last] =
        (struct studio_consumed){event_us, (uint64_t)(1e6 * bench_wall_s()), studio->published + 1};
}

/* After a pause something new begins: the painting is kept as it is before. */
static void keep_before(struct studio *studio)
{
    double now = bench_wall_s();
    if (now - studio->posted_s > 1e-3 * STUDIO_PAUSE_MS) {
        studio->has_before = studio->engine->ops->save(studio->engine, &studio->before);
    }
    studio->posted_s = now;
}

/* Takes what was posted; the lock is not held while the engine works. */
static void empty_inbox(struct studio *studio)
{
    for (int done = 0;; done++) {
        struct studio_action posted;
        pthread_mutex_lock(&studio->lock);
        bool any = done < studio->inbox_count;
        if (any) {
            posted = studio->inbox[done];
            if (posted.event_us > 0) {
                note_consumed(studio, posted.event_us);
            }
        } else {
            studio->inbox_count = 0;
        }
        pthread_mutex_unlock(&studio->lock);
        if (!any) {
            return;
        }
        keep_before(studio);
        act_and_keep(studio, &posted);
    }
}

void studio_act(struct studio *studio, const struct action *action)
{
    act_and_keep(studio, &(struct studio_action){.action = *action});
}

static int64_t session_tick(const struct studio *studio)
{
    return studio->engine->ops->ticks(studio->engine) - studio->session_start;
}

static void act_script(struct studio *studio)
{
    const struct script *script = studio->def.script;
    int64_t tick = session_tick(studio);
    while (studio->next_action < script->action_count && script->actions[studio->next_action].tick <= tick &&
           tick <= script->ticks) {
        struct studio_action entry = {.action = script->actions[studio->next_action++]};
        act_and_keep(studio, &entry);
    }
}

/* A checkpoint whole: what was done before it began needs no doing again. */
static void end_checkpoint(struct studio *studio)
{
    struct checkpoint whole = studio->partial;
    studio->partial = studio->whole;
    studio->whole = whole;
    studio->has_whole = true;
    studio->taking = false;
    studio->journal_count -= studio->journal_kept;
    memmove(studio->journal, studio->journal + studio->journal_kept,
            (size_t)studio->journal_count * sizeof studio->journal[0]);
    pthread_mutex_lock(&studio->lock);
    studio->report.checkpoint_tick = studio->whole.tick;
    pthread_mutex_unlock(&studio->lock);
}

static void roll_checkpoint(struct studio *studio)
{
    double now = bench_wall_s();
    if (studio->def.engine != ENGINE_GPU) {
        return;
    }
    bool due = !studio->has_whole || now - studio->checkpoint_s > STUDIO_CHECKPOINT_S ||
               studio->journal_count > STUDIO_JOURNAL / 2;
    if (!studio->taking && due && engine_gpu_checkpoint_begin(studio->engine)) {
        studio->taking = true;
        studio->checkpoint_s = now;
        studio->journal_kept = studio->journal_count;
    }
    if (studio->taking && engine_gpu_checkpoint_step(studio->engine, &studio->partial)) {
        end_checkpoint(studio);
    }
}

/* Room for checkpoints of the engine's sheet; forgets the old. */
static bool fit_checkpoints(struct studio *studio, const struct painting_def *def)
{
    bool gpu = studio->def.engine == ENGINE_GPU;
    if (studio->before.planes && checkpoint_fits(&studio->before, def) && (!gpu || studio->whole.planes)) {
        studio->has_whole = studio->taking = studio->has_before = false;
        studio->journal_count = studio->journal_kept = 0;
        return true;
    }
    checkpoint_finish(&studio->whole);
    checkpoint_finish(&studio->partial);
    checkpoint_finish(&studio->before);
    studio->has_whole = studio->taking = studio->has_before = false;
    studio->journal_count = studio->journal_kept = 0;
    return checkpoint_init(&studio->before, def) &&
           (!gpu || (checkpoint_init(&studio->whole, def) && checkpoint_init(&studio->partial, def)));
}

/* The painting as it was before what was posted last. What the script does from then on, it does again. */
static void take_back(struct studio *studio)
{
    const struct script *script = studio->def.script;
    pthread_mutex_lock(&studio->lock);
    bool wanted = studio->undo && studio->has_before;
    studio->undo = false;
    pthread_mutex_unlock(&studio->lock);
    if (!wanted || !studio->engine->ops->load(studio->engine, &studio->before)) {
        return;
    }
    studio->has_before = studio->has_whole = studio->taking = false; /* rolling checkpoints hold what is gone */
    studio->journal_count = studio->journal_kept = 0;
    studio->posted_s = 0;
    studio->changed_since = true;
    for (studio->next_action = 0; studio->next_action < script->action_count; studio->next_action++) {
        if (script->actions[studio->next_action].tick > session_tick(studio)) {
            break;
        }
    }
}

/* The painting on another grid. When that fails the old one stays. */
void studio_change_scale(struct studio *studio, float scale)
{
    struct painting_def def = studio_painting(studio, scale), now = studio->engine->ops->get_def(studio->engine);
    struct checkpoint from = {0}, to = {0};
    struct engine *next = NULL;
    def.seed = now.seed;
    def.coefficients = now.coefficients;
    bool good =
        checkpoint_init(&from, &now) && checkpoint_init(&to, &def) && studio->engine->ops->save(studio->engine, &from);
    if (good) {
        checkpoint_resample(&from, &to);
        next = make_engine(studio, &def);
        good = next && next->ops->load(next, &to) && fit_checkpoints(studio, &def);
    }
    if (good) {
        engine_destroy(studio->engine);
        studio->engine = next;
        studio->changed_since = true;
    } else {
        engine_destroy(next);
        set_trouble(studio, "the grid cannot be changed: memory is short");
    }
    checkpoint_finish(&from);
    checkpoint_finish(&to);
    pthread_mutex_lock(&studio->lock);
    studio->report.scale = good ? scale : studio->report.scale;
    studio->scale = studio->report.scale;
    pthread_mutex_unlock(&studio->lock);
}

/* A fresh sheet with a seed of its own. */
bool studio_begin_session(struct studio *studio)
{
    pthread_mutex_lock(&studio->lock);
    studio->report.sessions++;
    studio->report.ticks = 0;
    pthread_mutex_unlock(&studio->lock);
    struct painting_def def = studio_painting(studio, studio->report.scale);
    struct engine *next = make_engine(studio, &def);
    if (!next || !fit_checkpoints(studio, &def)) {
        engine_destroy(next);
        return false;
    }
    engine_destroy(studio->engine);
    studio->engine = next;
    studio->next_action = 0;
    studio->rest_ticks = 0;
    studio->session_start = 0;
    studio->changed_since = true;
    return true;
}

/* Counts what ticks cost, and says so once a second; `ticked`: there was one. */
static void measure(struct studio *studio, double began, bool ticked)
{
    double now = bench_wall_s();
    if (ticked) {
        studio->busy_s += now - began;
        studio->second_ticks++;
    }
    pthread_mutex_lock(&studio->lock);
    studio->report.ticks = session_tick(studio);
    studio->report.idle = studio->rest || studio->report.ticks >= studio->def.script->ticks;
    studio->report.ended = studio->def.once && studio->report.ticks >= studio->def.script->ticks;
    if (studio->second_ticks > 0) { /* after a session it is known what its last ticks took */
        studio->report.tick_ms = 1000 * studio->busy_s / studio->second_ticks;
    }
    if (now - studio->second_s >= 1) {
        studio->report.ticks_per_second = studio->second_ticks / (now - studio->second_s);
        studio->second_s = now;
        studio->busy_s = 0;
        studio->second_ticks = 0;
    }
    pthread_mutex_unlock(&studio->lock);
}

static bool tick(struct studio *studio)
{
    double began = bench_wall_s();
    if (!studio_take_orders(studio)) {
        return false;
    }
    take_back(studio);
    act_script(studio);
    empty_inbox(studio);
    bool ticks = session_tick(studio) < studio->def.script->ticks;
    if (ticks) {
        studio->engine->ops->tick(studio->engine);
        studio->engine->ops->finish(studio->engine);
        studio->changed_since = true;
    } else if (!studio->def.once && ++studio->rest_ticks > REST_TICKS && !studio_begin_session(studio)) {
        return false;
    }
    if (studio->changed_since && publisher_publish(studio->publisher, studio->engine, studio->published + 1)) {
        studio->published++;
        studio->changed_since = false;
    }
    roll_checkpoint(studio);
    measure(studio, began, ticks);
    return true;
}

/* Until the next tick is due, or longer while nobody looks. What it is late by is not made up for: then fewer ticks
 * happen. False when the studio is to stop. */
static bool wait_turn(struct studio *studio, double *next_s, float *scale)
{
    double period = studio->def.ticks_per_second > 0 ? 1 / studio->def.ticks_per_second : 0;
    double now = bench_wall_s();
    *next_s = *next_s + period > now - period ? *next_s + period : now;
    struct timespec until = {(time_t)*next_s, (long)((*next_s - floor(*next_s)) * 1e9)};
    pthread_mutex_lock(&studio->lock);
    while (!studio->stop && studio->rest) {
        pthread_cond_wait(&studio->changed, &studio->lock);
    }
    while (!studio->stop && bench_wall_s() < *next_s &&
           pthread_cond_timedwait(&studio->changed, &studio->lock, &until) == 0) {
    }
    bool go_on = !studio->stop;
    *scale = studio->scale;
    pthread_mutex_unlock(&studio->lock);
    return go_on;
}

/* The engine for this thread: the one that outlived a lost GPU, or a new one, with the painting as it was. */
static bool open_engine(struct studio *studio)
{
    if (studio->kept) {
        studio->engine = studio->kept;
        studio->kept = NULL;
        return true;
    }
    if (!studio->has_whole) { /* nothing was painted yet, or not for long */
        return studio_begin_session(studio);
    }
    studio->engine = make_engine(studio, &studio->whole.def);
    if (!studio->engine || !studio->engine->ops->load(studio->engine, &studio->whole)) {
        return false;
    }
    for (int i = 0; i < studio->journal_count; i++) {
        act(studio, &studio->journal[i]);
    }
    studio->taking = false;
    studio->journal_kept = 0;
    return true;
}

static void close_engine(struct studio *studio)
{
    if (studio->lost && studio->def.engine == ENGINE_CPU) {
        studio->kept = studio->engine;
    } else {
        engine_destroy(studio->engine);
    }
    studio->engine = NULL;
    display_context_leave(studio->context);
}

static void tell_start(struct studio *studio, bool good)
{
    pthread_mutex_lock(&studio->lock);
    studio->started = good ? STUDIO_WORKS : STUDIO_FAILED;
    pthread_cond_broadcast(&studio->changed);
    pthread_mutex_unlock(&studio->lock);
}

void *studio_work(void *context)
{
    struct studio *studio = context;
    float scale;
    bool good = display_context_enter(studio->context);
    studio->changed_since = true;
    if (!good) {
        snprintf(studio->error.text, sizeof studio->error.text, "the studio's GL context cannot be made current");
    }
    good = good && open_engine(studio);
    tell_start(studio, good);
    double next_s = bench_wall_s();
    studio->second_s = next_s;
    while (good && wait_turn(studio, &next_s, &scale)) {
        if (scale < studio->report.scale || scale > studio->report.scale) {
            studio_change_scale(studio, scale);
        }
        good = tick(studio);
    }
    if (!good) {
        set_trouble(studio, studio->error.text);
    }
    close_engine(studio);
    return NULL;
}
