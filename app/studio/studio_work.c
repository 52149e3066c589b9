#include "studio_work.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench.h"
#include "painting_gpu.h"
#include "scene.h"
#include "studio_sheet.h"

enum { EFFORT_TICKS = 64 };

static const int64_t REST_TICKS = 20 * STUDIO_TICKS_PER_SECOND; /* a finished painting is looked at for so long */

/* The action, with the path that was copied. */
static struct action action_of(const struct studio_action *posted)
{
    struct action action = posted->action;
    if (posted->copied) {
        action.path.points = posted->points;
    }
    return action;
}

static void act(struct studio *studio, const struct studio_action *posted)
{
    struct action action = action_of(posted);
    studio->changed_since = studio->changed_since || scene_kind_of(action.verb) == SCENE_PAINTING;
    if (studio->history) {
        history_act(studio->history, studio->engine, &action);
    } else {
        studio->engine->ops->act(studio->engine, &action);
    }
    /* What goes back in time is not in a checkpoint that began before: a newer one is due. */
    studio->checkpoint_s = action_goes_back(action.verb) ? 0 : studio->checkpoint_s;
}

/* Does an action, and keeps it until a checkpoint holds it. */
static void act_and_keep(struct studio *studio, const struct studio_action *posted)
{
    struct action action = action_of(posted);
    studio_tell_action(studio, &action);
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

static int64_t session_tick(const struct studio *studio)
{
    return studio->engine->ops->ticks(studio->engine) - studio->session_start;
}

static void act_script(struct studio *studio)
{
    const struct script *script = studio->script;
    int64_t tick = session_tick(studio);
    while (studio->next_action < script->action_count && script->actions[studio->next_action].tick <= tick &&
           tick <= script->ticks) {
        struct studio_action entry = {.action = script->actions[studio->next_action++]};
        entry.action.visitor = entry.action.visitor > 0 ? entry.action.visitor : HISTORY_SCRIPT;
        act_and_keep(studio, &entry);
    }
}

static void take_posted(struct studio *studio, const struct studio_action *posted)
{
    switch (posted->what) {
    case POSTED_FRESH:
        if (studio_begin_session(studio)) {
            act_script(studio);
        } else {
            studio_set_trouble(studio, studio->error.text);
        }
        break;
    case POSTED_SCRIPT:
        studio_take_script(studio, posted->script);
        act_script(studio);
        break;
    default:
        act_and_keep(studio, posted);
        break;
    }
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
        take_posted(studio, &posted);
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
    studio_tell(studio, STUDIO_WHOLE);
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
        studio_tell(studio, STUDIO_TAKING);
    }
    if (studio->taking && engine_gpu_checkpoint_step(studio->engine, &studio->partial)) {
        end_checkpoint(studio);
    }
}

/* The engine's shaders, once a second where a folder has them: anew when it has changed; with an error the old go on.
 */
static void look_at_shaders(struct studio *studio)
{
    if (studio->def.engine != ENGINE_GPU || !studio->def.folder || bench_wall_s() - studio->second_s < 1) {
        return;
    }
    struct shader_error error;
    long long stamp = shader_folder_stamp(studio->def.folder);
    if (stamp != studio->shaders && !engine_gpu_reload(studio->engine, &error)) {
        studio_set_trouble(studio, error.text);
    }
    studio->shaders = stamp;
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
    studio->report.turns++;
    studio->report.ticks = session_tick(studio);
    studio->report.idle = studio->rest || studio->report.ticks >= studio->script->ticks;
    studio->report.ended = studio->def.once && studio->report.ticks >= studio->script->ticks;
    studio->report.can_undo = studio->history ? history_can_undo(studio->history) : 0;
    studio->report.can_redo = studio->history ? history_can_redo(studio->history) : 0;
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

/* Whether the tick has changed nothing, and those to come will not until something is done: then there is nothing new
 * to show. Of a GPU that is asked for seldom, since it waits. */
static bool sleeps(struct studio *studio)
{
    bool cheap = engine_cpu_painting(studio->engine);
    if (!studio->asleep && (cheap || studio->ticked % EFFORT_TICKS == 0)) {
        struct painting_effort effort = studio->engine->ops->effort(studio->engine);
        studio->asleep = effort.fluid_awake == 0 && effort.pattern_awake == 0;
    }
    return studio->asleep;
}

static bool tick(struct studio *studio)
{
    double began = bench_wall_s();
    act_script(studio);
    empty_inbox(studio);
    bool ticks = session_tick(studio) < studio->script->ticks;
    if (studio->history && ticks) {
        history_tick(studio->history, studio->engine);
    }
    if (ticks) {
        studio->engine->ops->tick(studio->engine);
        studio->engine->ops->finish(studio->engine);
        studio->asleep = studio->asleep && !studio->changed_since;
        studio->changed_since = !sleeps(studio) || studio->changed_since;
        double told = bench_wall_s();
        studio_tell_ticked(studio, told - began);
        began += bench_wall_s() - told; /* what listeners take is not the tick's */
    } else if (!studio->def.once && ++studio->rest_ticks > REST_TICKS && !studio_begin_session(studio)) {
        return false;
    }
    if (studio->changed_since && publisher_publish(studio->publisher, studio->engine, studio->published + 1)) {
        studio->published++;
        studio->changed_since = false;
    }
    roll_checkpoint(studio);
    look_at_shaders(studio);
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
        studio->report.rests = true;
        pthread_cond_wait(&studio->changed, &studio->lock);
    }
    studio->report.rests = false;
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
    if (!studio->has_whole && studio->def.from && studio->report.sessions == 0) {
        return studio_take_up(studio);
    }
    if (!studio->has_whole) { /* nothing was painted yet, or not for long */
        return studio_begin_session(studio);
    }
    studio->engine = studio_make_engine(studio, &studio->whole.def);
    if (!studio->engine || !studio->engine->ops->load(studio->engine, &studio->whole)) {
        return false;
    }
    if (studio->history) {
        history_forget(studio->history);
    }
    for (int i = 0; i < studio->journal_count; i++) {
        act(studio, &studio->journal[i]);
    }
    studio->taking = false;
    studio->journal_kept = 0;
    studio_tell_restored(studio, 0);
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
    studio->shaders = shader_folder_stamp(studio->def.folder);
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
        studio_set_trouble(studio, studio->error.text);
    }
    close_engine(studio);
    return NULL;
}
