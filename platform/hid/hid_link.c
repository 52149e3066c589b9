#include "hid_link.h"

#include <errno.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <hidapi.h>

#include "hid_report.h"
#include "source_queue.h"

enum {
    STOP_MS = 200,     /* how long a silent device may keep its reader from seeing that it shall stop */
    STALL_US = 1000000 /* of a write */
};

struct waiting { /* a report that was read */
    uint64_t time_us;
    size_t size;
};

struct outgoing {
    size_t size; /* 0: none */
    uint8_t bytes[HID_LINK_WRITE];
};

struct hid_link {
    bool numbered, lamps;
    int wake_fd;
    hid_device *reading, *writing;
    pthread_t reader, writer;
    pthread_mutex_t mutex;
    pthread_cond_t ordered;
    size_t report;
    uint8_t *bytes; /* HID_LINK_REPORTS of `report` bytes */
    struct waiting waiting[HID_LINK_REPORTS];
    unsigned first, count;
    struct outgoing outgoing[HID_LINK_WRITES];
    atomic_bool stop, failed, reader_ended, writer_ended, refuses;
    atomic_uint_least64_t lost, write_began_us; /* 0: nothing is being written */
};

static uint8_t *place(const struct hid_link *link, unsigned which)
{
    return link->bytes + (size_t)((link->first + which) % HID_LINK_REPORTS) * link->report;
}

/* Where the next report goes: a free place, or that of the newest of the same id, whose state it replaces. */
static unsigned find_place(struct hid_link *link, uint8_t id)
{
    if (link->count < HID_LINK_REPORTS) {
        return link->count++;
    }
    atomic_fetch_add(&link->lost, 1);
    for (unsigned i = link->count; link->numbered && i-- > 0;) {
        if (place(link, i)[0] == id) {
            return i;
        }
    }
    return link->count - 1;
}

static void *read_reports(void *argument)
{
    struct hid_link *link = argument;
    const uint64_t one = 1;
    uint8_t bytes[HID_REPORT_BYTES];
    while (!atomic_load(&link->stop)) {
        int size = hid_read_timeout(link->reading, bytes, link->report, STOP_MS);
        if (size < 0) {
            atomic_store(&link->failed, true);
            break;
        }
        if (size > 0) {
            uint64_t now = source_now_us();
            pthread_mutex_lock(&link->mutex);
            unsigned which = find_place(link, bytes[0]);
            memcpy(place(link, which), bytes, (size_t)size);
            link->waiting[(link->first + which) % HID_LINK_REPORTS] = (struct waiting){now, (size_t)size};
            pthread_mutex_unlock(&link->mutex);
            (void)!write(link->wake_fd, &one, sizeof one);
        }
    }
    atomic_store(&link->reader_ended, true);
    (void)!write(link->wake_fd, &one, sizeof one);
    return NULL;
}

static struct outgoing *next_outgoing(struct hid_link *link)
{
    for (int i = 0; i < HID_LINK_WRITES; i++) {
        if (link->outgoing[i].size > 0) {
            return &link->outgoing[i];
        }
    }
    return NULL;
}

static void *write_reports(void *argument)
{
    struct hid_link *link = argument;
    const uint64_t one = 1;
    pthread_mutex_lock(&link->mutex);
    while (!atomic_load(&link->stop)) {
        struct outgoing *next = next_outgoing(link);
        if (!next) {
            pthread_cond_wait(&link->ordered, &link->mutex);
            continue;
        }
        struct outgoing taken = *next;
        next->size = 0;
        pthread_mutex_unlock(&link->mutex);
        atomic_store(&link->write_began_us, source_now_us());
        bool written = hid_write(link->writing, taken.bytes, taken.size) >= 0;
        atomic_store(&link->write_began_us, 0);
        atomic_store(&link->refuses, !written);
        pthread_mutex_lock(&link->mutex);
    }
    pthread_mutex_unlock(&link->mutex);
    atomic_store(&link->writer_ended, true);
    (void)!write(link->wake_fd, &one, sizeof one);
    return NULL;
}

/* Threads take no signals: hidapi takes an interrupted wait for the loss of the device. */
static bool start_thread(pthread_t *thread, void *(*run)(void *), void *argument)
{
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    int code = pthread_create(thread, NULL, run, argument);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return code == 0;
}

static void close_handles(struct hid_link *link)
{
    if (link->reading) {
        hid_close(link->reading);
    }
    if (link->writing) {
        hid_close(link->writing);
    }
}

struct hid_link *hid_link_open(const struct hid_link_def *def)
{
    struct hid_link *link = calloc(1, sizeof *link);
    size_t report = def->report < HID_REPORT_BYTES - 64 ? def->report + 64 : HID_REPORT_BYTES; /* some send too much */
    uint8_t *bytes = calloc(HID_LINK_REPORTS, report);
    errno = 0;
    if (link && bytes) {
        link->reading = hid_open_path(def->path);
        link->writing = link->reading && def->lamps ? hid_open_path(def->path) : NULL;
    }
    if (!link || !bytes || !link->reading || (def->lamps && !link->writing)) {
        int code = errno ? errno : EIO;
        if (link) {
            close_handles(link);
        }
        free(bytes);
        free(link);
        errno = code;
        return NULL;
    }
    link->numbered = def->numbered;
    link->wake_fd = def->wake_fd;
    link->report = report;
    link->bytes = bytes;
    pthread_mutex_init(&link->mutex, NULL);
    pthread_cond_init(&link->ordered, NULL);
    if (!start_thread(&link->reader, read_reports, link)) {
        atomic_store(&link->reader_ended, true);
        atomic_store(&link->failed, true);
        link->report = 0; /* none to join */
    }
    link->lamps = def->lamps && start_thread(&link->writer, write_reports, link);
    atomic_store(&link->writer_ended, !link->lamps);
    return link;
}

size_t hid_link_take(struct hid_link *link, uint8_t *bytes, size_t most, uint64_t *time_us)
{
    size_t size = 0;
    pthread_mutex_lock(&link->mutex);
    if (link->count > 0) {
        const struct waiting *waiting = &link->waiting[link->first];
        size = waiting->size < most ? waiting->size : most;
        *time_us = waiting->time_us;
        memcpy(bytes, place(link, 0), size);
        link->first = (link->first + 1) % HID_LINK_REPORTS;
        link->count--;
    }
    pthread_mutex_unlock(&link->mutex);
    return size;
}

uint64_t hid_link_lost(const struct hid_link *link)
{
    return atomic_load(&link->lost);
}

bool hid_link_failed(const struct hid_link *link)
{
    return atomic_load(&link->failed);
}

void hid_link_write(struct hid_link *link, const uint8_t *bytes, size_t size)
{
    if (!link->lamps || size == 0 || size > HID_LINK_WRITE) {
        return;
    }
    pthread_mutex_lock(&link->mutex);
    struct outgoing *to = NULL;
    for (int i = HID_LINK_WRITES - 1; i >= 0; i--) {
        struct outgoing *outgoing = &link->outgoing[i];
        bool same = outgoing->size > 0 && outgoing->bytes[0] == bytes[0];
        if (same || (outgoing->size == 0 && !(to && to->size > 0))) {
            to = outgoing;
        }
    }
    if (to) {
        to->size = size;
        memcpy(to->bytes, bytes, size);
        pthread_cond_signal(&link->ordered);
    }
    pthread_mutex_unlock(&link->mutex);
}

bool hid_link_refuses(const struct hid_link *link)
{
    uint64_t began = atomic_load(&link->write_began_us);
    return atomic_load(&link->refuses) || (began > 0 && source_now_us() - began > STALL_US);
}

void hid_link_stop(struct hid_link *link)
{
    pthread_mutex_lock(&link->mutex);
    atomic_store(&link->stop, true);
    pthread_cond_signal(&link->ordered);
    pthread_mutex_unlock(&link->mutex);
}

bool hid_link_ended(const struct hid_link *link)
{
    return atomic_load(&link->reader_ended) && atomic_load(&link->writer_ended);
}

void hid_link_destroy(struct hid_link *link)
{
    if (!link) {
        return;
    }
    hid_link_stop(link);
    if (link->report > 0) {
        pthread_join(link->reader, NULL);
    }
    if (link->lamps) {
        pthread_join(link->writer, NULL);
    }
    close_handles(link);
    pthread_cond_destroy(&link->ordered);
    pthread_mutex_destroy(&link->mutex);
    free(link->bytes);
    free(link);
}
