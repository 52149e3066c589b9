/* The thread that writes. It takes the lock to see what there is to do and to take it over, and does it without. */
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

#include "keep_files.h"
#include "keep_state.h"

static enum keep_state state_of(int code)
{
    switch (code) {
    case 0:
        return KEEP_GOOD;
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
        return KEEP_FULL;
    case EROFS:
    case EACCES:
    case EPERM:
        return KEEP_READ_ONLY;
    default:
        return KEEP_FAILING;
    }
}

/* What has become of a write: a line when that is another thing than before. After a failure nothing of the journal's
 * file is trusted any more: the whole of it is written anew. */
static void note_result(struct keep *keep, const char *path, int code)
{
    struct file_error error;
    enum keep_state state = state_of(code);
    if (code != 0) {
        keep->retry_at = keep_now_s() + keep->def.retry_s;
        if (keep->fd >= 0) {
            close(keep->fd);
            keep->fd = -1;
        }
    }
    pthread_mutex_lock(&keep->lock);
    if (state != keep->report.state) {
        if (code == 0) {
            keep_say(keep, "the painting is kept again");
        } else {
            file_fail_code(&error, path, code);
            keep_say(keep, "the painting is not kept: %.250s", error.text);
        }
    }
    keep->report.state = state;
    pthread_mutex_unlock(&keep->lock);
}

static void count_bytes(struct keep *keep, size_t size, int64_t ticked)
{
    pthread_mutex_lock(&keep->lock);
    keep->report.bytes += (int64_t)size;
    keep->report.kept_ticked = ticked > keep->report.kept_ticked ? ticked : keep->report.kept_ticked;
    pthread_mutex_unlock(&keep->lock);
}

static void make_folder(struct keep *keep, uint64_t generation)
{
    if (!keep->folder_made) {
        keep->folder_made = file_make_folder(keep->folder, NULL);
        keep_files_remove(keep->calls, keep->folder, generation, 0); /* what a killed write has left */
    }
}

/* The whole journal as a file of its own, in one step; then it is open for what comes after. */
static int write_journal(struct keep *keep, const char *path)
{
    int code = file_write_atomic_by(keep->calls, path, keep->pending.data, keep->pending.size);
    if (code != 0) {
        return code;
    }
    keep->fd = keep->calls->openat(AT_FDCWD, path, O_WRONLY | O_CLOEXEC, 0);
    return keep->fd < 0 ? errno : 0;
}

/* What is pending of the journal, to the disk. False when that failed. */
static bool flush(struct keep *keep, uint64_t generation, int64_t ticked)
{
    char path[KEEP_PATH];
    int code = 0;
    size_t size = keep->pending.size;
    bool fresh = keep->fd < 0;
    if (!keep_files_path(keep->folder, &(struct keep_file){.journal = true, .generation = generation}, path)) {
        code = ENAMETOOLONG;
    } else if (fresh) {
        make_folder(keep, generation);
        code = write_journal(keep, path);
        keep->flushed = 0;
    } else if (size > 0) {
        bool good = file_pwrite_whole(keep->calls, keep->fd, keep->pending.data, size, (off_t)keep->flushed) &&
                    keep->calls->fdatasync(keep->fd) == 0;
        code = good ? 0 : errno;
    }
    note_result(keep, path, code);
    if (code == 0) {
        keep->flushed += size;
        count_bytes(keep, size, ticked);
    }
    if (code == 0 && fresh && keep->journal_generation != generation) {
        keep_files_remove(keep->calls, keep->folder, generation, 0);
    }
    keep->journal_generation = code == 0 ? generation : 0;
    return code == 0;
}

/* With the lock held: what is pending, taken over. */
static void gather(struct keep *keep)
{
    struct journal_writer *writer = &keep->writer;
    if (keep->fd >= 0 && keep->journal_generation != keep->generation) {
        close(keep->fd);
        keep->fd = -1;
    }
    if (!keep->still && !keep->overflown && keep->ticked > writer->ticked) {
        journal_mark(writer, keep->ticked);
    }
    uint64_t from = keep->fd >= 0 ? keep->flushed : 0;
    keep->pending.size = 0;
    keep->pending.failed = false;
    if (!writer->out.failed && writer->out.size > from) {
        bytes_put(&keep->pending, writer->out.data + from, writer->out.size - from);
    }
}

static void say_written(struct keep *keep, double pack_s, double began, bool spared)
{
    pthread_mutex_lock(&keep->lock);
    keep->report.pack_ms = 1e3 * pack_s;
    keep->report.write_ms = 1e3 * (keep_now_s() - began);
    keep->report.spared += spared;
    keep->report.checkpoints += !spared;
    keep->report.checkpoint_bytes = spared ? keep->report.checkpoint_bytes : (int64_t)keep->packed.size;
    /* Nothing was told since: as it is now it will stay. */
    keep->still = spared && keep->events == keep->note_events;
    keep->number = spared || keep->generation != keep->note.generation ? keep->number : keep->note.number;
    pthread_mutex_unlock(&keep->lock);
}

/* The checkpoint that is the disk's now. */
static void write_checkpoint(struct keep *keep)
{
    char path[KEEP_PATH];
    uint64_t hash = 0;
    double began = keep_now_s();
    struct keep_file file = {.generation = keep->note.generation, .number = keep->note.number};
    keep->packed.size = 0;
    keep->packed.failed = false;
    if (!checkpoint_pack(&keep->packer, &keep->checkpoint, &keep->note, &keep->packed, &hash)) {
        note_result(keep, keep->folder, ENOMEM);
        return;
    }
    double packed = keep_now_s();
    bool spared = hash == keep->hash && file.generation == keep->hash_generation;
    if (!spared) {
        int code = keep_files_path(keep->folder, &file, path)
                       ? file_write_atomic_by(keep->calls, path, keep->packed.data, keep->packed.size)
                       : ENAMETOOLONG;
        note_result(keep, path, code);
        if (code != 0) {
            return;
        }
        keep->hash = hash;
        keep->hash_generation = file.generation;
        count_bytes(keep, keep->packed.size, keep->note.ticked);
        keep_files_remove(keep->calls, keep->folder, file.generation, file.number - 1);
    }
    say_written(keep, packed - began, packed, spared);
}

/* Room for checkpoints of the sheet of now; with the lock held, which is let go meanwhile. */
static void make_room(struct keep *keep)
{
    struct painting_def wanted = keep->wanted;
    keep->turn = TURN_DISK;
    pthread_mutex_unlock(&keep->lock);
    checkpoint_finish(&keep->checkpoint);
    bool good = checkpoint_init(&keep->checkpoint, &wanted);
    pthread_mutex_lock(&keep->lock);
    if (!good) {
        keep_say(keep, "the painting is not kept: memory is short");
        keep->retry_at = keep_now_s() + keep->def.retry_s;
    }
    keep->turn = TURN_FREE;
}

static bool needs_room(const struct keep *keep)
{
    return keep->on && keep->turn == TURN_FREE && keep->wanted.width > 0 &&
           !checkpoint_fits(&keep->checkpoint, &keep->wanted);
}

/* Attract: nothing of a painting stays, once. */
static void clear(struct keep *keep)
{
    keep->clear = false;
    if (keep->turn == TURN_FULL) {
        keep->turn = TURN_FREE;
    }
    pthread_mutex_unlock(&keep->lock);
    if (keep->fd >= 0) {
        close(keep->fd);
        keep->fd = -1;
    }
    keep->journal_generation = 0;
    keep->hash_generation = 0;
    keep_files_remove(keep->calls, keep->folder, UINT64_MAX, 0);
    pthread_mutex_lock(&keep->lock);
}

/* Whether the journal has something for the disk. */
static bool has_pending(const struct keep *keep)
{
    return keep->fd < 0 || keep->journal_generation != keep->generation ||
           (!keep->writer.out.failed && keep->writer.out.size > keep->flushed) ||
           (!keep->still && !keep->overflown && keep->ticked > keep->writer.ticked);
}

/* One round of writing; the lock is held, and let go meanwhile. */
static void write_all(struct keep *keep)
{
    bool full = keep->turn == TURN_FULL;
    uint64_t generation = keep->generation;
    int64_t ticked = keep->ticked;
    keep->turn = full ? TURN_DISK : keep->turn;
    gather(keep);
    pthread_mutex_unlock(&keep->lock);
    bool good = flush(keep, generation, ticked);
    if (full && good && keep->note.generation == generation) {
        write_checkpoint(keep);
    }
    keep->flush_at = keep_now_s() + keep->def.flush_s;
    pthread_mutex_lock(&keep->lock);
    keep->turn = full ? TURN_FREE : keep->turn;
    keep->urgent = keep->urgent || (full && keep->report.state != KEEP_GOOD);
}

static void wait_until(struct keep *keep, double when)
{
    struct timespec until = {(time_t)when, (long)((when - floor(when)) * 1e9)};
    pthread_cond_timedwait(&keep->changed, &keep->lock, &until);
}

void *keep_work(void *context)
{
    static const double LONG_S = 3600;
    struct keep *keep = context;
    pthread_mutex_lock(&keep->lock);
    while (!keep->stop) {
        double now = keep_now_s();
        if (keep->clear) {
            clear(keep);
        } else if (!keep->on) {
            wait_until(keep, now + LONG_S);
        } else if (now < keep->retry_at) {
            wait_until(keep, keep->retry_at);
        } else if (needs_room(keep)) {
            make_room(keep);
        } else if (keep->turn == TURN_FULL || (now >= keep->flush_at && has_pending(keep))) {
            write_all(keep);
        } else {
            wait_until(keep, now >= keep->flush_at ? now + keep->def.flush_s : keep->flush_at);
        }
    }
    if (keep->on && keep_now_s() >= keep->retry_at && has_pending(keep)) {
        write_all(keep);
    }
    pthread_mutex_unlock(&keep->lock);
    return NULL;
}
