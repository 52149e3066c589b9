#include "studio.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "studio_work.h"

struct studio_def studio_default_def(void)
{
    return (struct studio_def){
        .engine = ENGINE_CPU, .ticks_per_second = STUDIO_TICKS_PER_SECOND, .history = history_default_def()};
}

/* Ends the thread, if there is one. */
static void stop_thread(struct studio *studio)
{
    if (!studio->context) {
        return;
    }
    pthread_mutex_lock(&studio->lock);
    studio->stop = true;
    pthread_cond_broadcast(&studio->changed);
    pthread_mutex_unlock(&studio->lock);
    pthread_join(studio->thread, NULL);
    display_context_destroy(studio->context);
    studio->context = NULL;
}

/* Starts the thread and waits until it has its engine, or has not. */
static bool start(struct studio *studio, struct display *display, struct studio_error *error)
{
    studio->context = display_share(display);
    if (!studio->context) {
        snprintf(error->text, sizeof error->text, "no GL context for the studio can be had");
        return false;
    }
    studio->stop = false;
    studio->started = STUDIO_STARTING;
    if (pthread_create(&studio->thread, NULL, studio_work, studio) != 0) {
        display_context_destroy(studio->context);
        studio->context = NULL;
        snprintf(error->text, sizeof error->text, "the studio's thread cannot be started");
        return false;
    }
    pthread_mutex_lock(&studio->lock);
    while (studio->started == STUDIO_STARTING) {
        pthread_cond_wait(&studio->changed, &studio->lock);
    }
    bool good = studio->started == STUDIO_WORKS;
    pthread_mutex_unlock(&studio->lock);
    if (!good) {
        *error = studio->error;
        stop_thread(studio);
    }
    return good;
}

struct studio *studio_create(const struct studio_def *def, struct display *display, struct studio_error *error)
{
    struct studio *studio = calloc(1, sizeof *studio);
    pthread_condattr_t attributes;
    if (!studio) {
        snprintf(error->text, sizeof error->text, "memory is short");
        return NULL;
    }
    studio->def = *def;
    studio->script = def->script;
    studio->report.scale = studio->scale = 1;
    studio->report.checkpoint_tick = -1;
    pthread_mutex_init(&studio->lock, NULL);
    pthread_condattr_init(&attributes);
    pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
    pthread_cond_init(&studio->changed, &attributes);
    pthread_condattr_destroy(&attributes);
    studio->publisher = publisher_create(def->xray);
    if (!studio->publisher) {
        snprintf(error->text, sizeof error->text, "memory is short");
        studio_destroy(studio);
        return NULL;
    }
    if (!start(studio, display, error)) {
        studio_destroy(studio);
        return NULL;
    }
    return studio;
}

void studio_destroy(struct studio *studio)
{
    if (!studio) {
        return;
    }
    stop_thread(studio);
    engine_destroy(studio->kept);
    publisher_destroy(studio->publisher, false);
    checkpoint_finish(&studio->whole);
    checkpoint_finish(&studio->partial);
    history_destroy(studio->history);
    pthread_cond_destroy(&studio->changed);
    pthread_mutex_destroy(&studio->lock);
    free(studio);
}

bool studio_post(struct studio *studio, const struct action *action)
{
    return studio_post_event(studio, action, 0);
}

/* Puts it in the inbox; some places are kept for orders. */
static bool post(struct studio *studio, const struct studio_action *posted)
{
    int most = posted->what == POSTED_ACTION ? STUDIO_INBOX : STUDIO_INBOX + STUDIO_ORDERS;
    pthread_mutex_lock(&studio->lock);
    bool fits = studio->inbox_count < most;
    if (fits) {
        studio->inbox[studio->inbox_count++] = *posted;
    }
    pthread_cond_broadcast(&studio->changed);
    pthread_mutex_unlock(&studio->lock);
    return fits;
}

bool studio_post_event(struct studio *studio, const struct action *action, uint64_t event_us)
{
    struct studio_action posted = {.action = *action, .copied = true, .event_us = event_us};
    if (action->path.count > STUDIO_PATH) {
        return false;
    }
    for (int i = 0; i < action->path.count; i++) {
        posted.points[i] = action->path.points[i];
    }
    return post(studio, &posted);
}

bool studio_fresh(struct studio *studio)
{
    return post(studio, &(struct studio_action){.what = POSTED_FRESH});
}

bool studio_change(struct studio *studio, const struct script *script)
{
    return post(studio, &(struct studio_action){.what = POSTED_SCRIPT, .script = script});
}

const struct script *studio_script(struct studio *studio)
{
    pthread_mutex_lock(&studio->lock);
    const struct script *script = studio->script;
    pthread_mutex_unlock(&studio->lock);
    return script;
}

bool studio_consumed(struct studio *studio, struct studio_consumed *consumed)
{
    pthread_mutex_lock(&studio->lock);
    bool any = studio->consumed_count > 0;
    if (any) {
        *consumed = studio->consumed[studio->consumed_first];
        studio->consumed_first = (studio->consumed_first + 1) % STUDIO_CONSUMED;
        studio->consumed_count--;
    }
    pthread_mutex_unlock(&studio->lock);
    return any;
}

const struct fields *studio_newest(struct studio *studio, bool *fresh)
{
    return publisher_newest(studio->publisher, fresh);
}

void studio_rest(struct studio *studio, bool rest)
{
    pthread_mutex_lock(&studio->lock);
    studio->rest = rest;
    pthread_cond_broadcast(&studio->changed);
    pthread_mutex_unlock(&studio->lock);
}

void studio_scale(struct studio *studio, float scale)
{
    pthread_mutex_lock(&studio->lock);
    studio->scale = scale;
    pthread_mutex_unlock(&studio->lock);
}

struct studio_report studio_report(struct studio *studio)
{
    pthread_mutex_lock(&studio->lock);
    struct studio_report report = studio->report;
    pthread_mutex_unlock(&studio->lock);
    return report;
}

void studio_suspend(struct studio *studio)
{
    studio->lost = true;
    stop_thread(studio);
    publisher_destroy(studio->publisher, true);
    studio->publisher = NULL;
}

bool studio_resume(struct studio *studio, struct display *display, struct studio_error *error)
{
    studio->publisher = publisher_create(studio->def.xray);
    if (!studio->publisher) {
        snprintf(error->text, sizeof error->text, "memory is short");
        return false;
    }
    studio->lost = false;
    return start(studio, display, error);
}
