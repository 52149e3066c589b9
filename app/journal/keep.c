#include "keep.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "keep_files.h"
#include "keep_state.h"
#include "recorder.h"

struct keep_def keep_default_def(void)
{
    return (struct keep_def){.every_s = 4,
                             .most_s = 20,
                             .repeat_s = 0.6,
                             .flush_s = 2,
                             .retry_s = 30,
                             .journal_most = 16u << 20,
                             .head = {.version = FROND_VERSION}};
}

double keep_now_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void keep_say(struct keep *keep, const char *format, ...)
{
    va_list arguments;
    if (keep->line_count == KEEP_LINES) {
        memmove(keep->lines[0], keep->lines[1], sizeof keep->lines - sizeof keep->lines[0]);
        keep->line_count--;
    }
    va_start(arguments, format);
    vsnprintf(keep->lines[keep->line_count++], KEEP_LINE, format, arguments);
    va_end(arguments);
}

/* The journal goes on behind what was found of it. */
static void go_on(struct keep *keep, struct keep_found *found)
{
    keep->generation = found->generation;
    keep->number = found->number;
    keep->lost = found->lost;
    keep->ticked = found->ticked;
    keep->sheet = found->sheet;
    keep->urgent = true;
    keep->wanted = found->checkpoint.def;
    snprintf(keep->scene, sizeof keep->scene, "%s", found->sheet.scene);
    if (found->journal.size > 0) {
        journal_continue(&keep->writer, &found->place);
        keep->writer.out = found->journal;
        found->journal = (struct bytes){.data = NULL};
        keep->alone = true;
    } else {
        journal_begin(&keep->writer, &keep->def.head);
        keep->since = found->ticked;
        keep->ticked = 0;
    }
}

static bool start(struct keep *keep)
{
    pthread_condattr_t attributes;
    pthread_mutex_init(&keep->lock, NULL);
    pthread_condattr_init(&attributes);
    pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
    pthread_cond_init(&keep->changed, &attributes);
    pthread_condattr_destroy(&attributes);
    return pthread_create(&keep->thread, NULL, keep_work, keep) == 0;
}

struct keep *keep_create(const struct keep_def *def, struct keep_found *found)
{
    struct keep *keep = calloc(1, sizeof *keep);
    if (!keep) {
        return NULL;
    }
    keep->def = *def;
    keep->calls = def->calls ? def->calls : &file_calls_system;
    keep->folder = strdup(def->folder);
    keep->fd = -1;
    keep->began_s = keep->taken_s = keep_now_s();
    if (found && found->checkpoint.planes) {
        go_on(keep, found);
    } else {
        struct keep_files files = keep_files_list(def->folder);
        keep->generation = files.count > 0 ? files.files[0].generation : 0;
        journal_begin(&keep->writer, &def->head);
    }
    if (!keep->folder || !start(keep)) {
        journal_finish(&keep->writer);
        free(keep->folder);
        free(keep);
        return NULL;
    }
    return keep;
}

void keep_destroy(struct keep *keep)
{
    if (!keep) {
        return;
    }
    pthread_mutex_lock(&keep->lock);
    keep->stop = true;
    pthread_cond_broadcast(&keep->changed);
    pthread_mutex_unlock(&keep->lock);
    pthread_join(keep->thread, NULL);
    if (keep->fd >= 0) {
        close(keep->fd);
    }
    checkpoint_finish(&keep->checkpoint);
    packer_finish(&keep->packer);
    bytes_finish(&keep->packed);
    bytes_finish(&keep->pending);
    journal_finish(&keep->writer);
    pthread_cond_destroy(&keep->changed);
    pthread_mutex_destroy(&keep->lock);
    free(keep->folder);
    free(keep);
}

/* A fresh sheet begins another journal; what lies in the folder is of the old one. */
static void begin_sheet(struct keep *keep, const struct studio_event *event)
{
    journal_finish(&keep->writer);
    journal_begin(&keep->writer, &keep->def.head);
    keep->since = event->ticked;
    keep->generation++;
    keep->number = 0;
    keep->lost = 0;
    keep->alone = true;
    keep->overflown = keep->urgent = false;
    keep->taken_s = keep_now_s();
    keep->busy_s = 0;
}

static struct pack_note note_of(const struct keep *keep)
{
    return (struct pack_note){.sheet = keep->sheet,
                              .generation = keep->generation,
                              .number = keep->number + 1,
                              .ticked = keep->ticked,
                              .records = keep->writer.records,
                              .written = keep->alone ? keep->writer.written : 0, /* 0: no journal leads here */
                              .crc = keep->writer.crc,
                              .exhibit_hash = keep->def.head.exhibit_hash};
}

static void record(struct keep *keep, const struct studio_event *event)
{
    struct studio_event told = *event;
    if (event->kind == STUDIO_SHEET) {
        begin_sheet(keep, event);
    }
    if (event->kind == STUDIO_RESTORED) {
        told.lost += keep->lost;
        keep->lost = 0;
    }
    if (event->kind == STUDIO_SHEET || event->kind == STUDIO_SCENE) {
        keep->sheet = recorder_sheet(event, keep->scene);
    }
    if (event->kind != STUDIO_ACTION) {
        keep->wanted = event->def;
    }
    bool back = event->kind == STUDIO_ACTION && action_goes_back(event->action->verb);
    keep->urgent = keep->urgent || back || event->kind == STUDIO_SCENE || event->kind == STUDIO_GRID;
    keep->still = false;
    keep->events++;
    keep->ticked = event->ticked - keep->since;
    if (keep->overflown) {
        return;
    }
    recorder_write(&keep->writer, &told, keep->since, keep->scene);
    if (keep->writer.out.failed || keep->writer.out.size > keep->def.journal_most) {
        keep->overflown = true;
        keep->alone = false;
        keep->urgent = true;
        keep_say(keep, "the journal of this sheet is too long to be kept; the painting is");
    }
}

/* Whether a checkpoint should be taken now. */
static bool is_due(const struct keep *keep, double now)
{
    double passed = now - keep->taken_s;
    return keep->on && keep->turn == TURN_FREE && keep->checkpoint.planes && !keep->still &&
           checkpoint_fits(&keep->checkpoint, &keep->wanted) && passed >= keep->def.every_s &&
           (keep->urgent || !keep->alone || keep->busy_s >= keep->def.repeat_s || passed >= keep->def.most_s);
}

static bool copy_checkpoint(struct checkpoint *to, const struct checkpoint *from)
{
    struct checkpoint copy = *from;
    if (!checkpoint_fits(to, &from->def) || !ground_copy(to->ground, from->ground)) {
        return false;
    }
    memcpy(to->planes, from->planes,
           (size_t)from->width * (size_t)from->height * CHECKPOINT_PLANES * sizeof *from->planes);
    copy.planes = to->planes;
    copy.ground = to->ground;
    *to = copy;
    return true;
}

/* Takes a checkpoint: of the engine, or of what the GPU has given. The lock is held, but not while it is taken. */
static void take(struct keep *keep, const struct studio_event *event, const struct pack_note *note)
{
    double began = keep_now_s();
    struct pack_note taken = *note;
    keep->turn = TURN_STUDIO;
    keep->taken_s = began;
    keep->busy_s = 0;
    keep->urgent = false;
    pthread_mutex_unlock(&keep->lock);
    bool good = event->whole ? copy_checkpoint(&keep->checkpoint, event->whole)
                             : event->engine->ops->save(event->engine, &keep->checkpoint);
    pthread_mutex_lock(&keep->lock);
    taken.number = keep->number + 1;
    keep->note = taken;
    keep->report.save_ms = 1e3 * (keep_now_s() - began);
    keep->turn = good ? TURN_FULL : TURN_FREE;
    keep->urgent = keep->urgent || !good;
    pthread_cond_broadcast(&keep->changed);
}

void keep_tell(void *data, const struct studio_event *event)
{
    struct keep *keep = data;
    struct pack_note note;
    pthread_mutex_lock(&keep->lock);
    switch (event->kind) {
    case STUDIO_TICKED:
        keep->ticked = event->ticked - keep->since;
        keep->busy_s += event->busy_s;
        if (engine_cpu_painting(event->engine) && is_due(keep, keep_now_s())) {
            note = note_of(keep);
            keep->note_events = keep->events;
            take(keep, event, &note);
        }
        break;
    case STUDIO_TAKING:
        keep->begun = note_of(keep);
        keep->begun_events = keep->events;
        break;
    case STUDIO_WHOLE:
        if (keep->begun.generation == keep->generation && is_due(keep, keep_now_s())) {
            note = keep->begun;
            keep->note_events = keep->begun_events;
            take(keep, event, &note);
        }
        break;
    default:
        record(keep, event);
        break;
    }
    pthread_mutex_unlock(&keep->lock);
}

void keep_visit(struct keep *keep, bool on)
{
    pthread_mutex_lock(&keep->lock);
    if (on != keep->on) {
        keep->on = on;
        keep->clear = !on;
        keep->taken_s = keep_now_s();
        pthread_cond_broadcast(&keep->changed);
    }
    pthread_mutex_unlock(&keep->lock);
}

void keep_scene(struct keep *keep, const char *scene)
{
    pthread_mutex_lock(&keep->lock);
    snprintf(keep->scene, sizeof keep->scene, "%s", scene);
    pthread_mutex_unlock(&keep->lock);
}

bool keep_journal(struct keep *keep, struct bytes *journal)
{
    *journal = (struct bytes){.data = NULL};
    pthread_mutex_lock(&keep->lock);
    struct journal_writer ended = keep->writer;
    bool alone = keep->alone;
    if (alone) {
        bytes_put(journal, keep->writer.out.data, keep->writer.out.size);
        ended.out = *journal;
        journal_end(&ended, keep->ticked);
        *journal = ended.out;
    }
    pthread_mutex_unlock(&keep->lock);
    if (!alone || journal->failed) {
        bytes_finish(journal);
    }
    return alone && journal->data;
}

struct keep_report keep_report(struct keep *keep)
{
    pthread_mutex_lock(&keep->lock);
    struct keep_report report = keep->report;
    double hours = (keep_now_s() - keep->began_s) / 3600;
    report.bytes_per_hour = hours > 0 ? (double)report.bytes / hours : 0;
    pthread_mutex_unlock(&keep->lock);
    return report;
}

bool keep_log(struct keep *keep, char *line, int size)
{
    pthread_mutex_lock(&keep->lock);
    bool any = keep->line_count > 0;
    if (any) {
        snprintf(line, (size_t)size, "%s", keep->lines[0]);
        memmove(keep->lines[0], keep->lines[1], sizeof keep->lines - sizeof keep->lines[0]);
        keep->line_count--;
    }
    pthread_mutex_unlock(&keep->lock);
    return any;
}
