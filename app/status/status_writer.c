#include "status_writer.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "file.h"

enum { PATH_BYTES = 1200 };

struct status_writer {
    char *json, *metrics; /* paths */
    uint64_t posted_us;
    bool begun; /* one was posted */
    pthread_t thread;
    pthread_mutex_t mutex; /* for all that follows */
    pthread_cond_t changed;
    struct status next;
    bool waiting, ends, failed, has_line;
    char line[FILE_ERROR_TEXT];
    /* The thread's own. */
    struct status status;
    char text[STATUS_BYTES];
};

static char *join(const char *folder, const char *name)
{
    size_t size = strlen(folder) + strlen(name) + 2;
    char *path = malloc(size);
    if (path) {
        snprintf(path, size, "%s/%s", folder, name);
    }
    return path;
}

/* Whole or not at all, as readers see it. Not file_write_atomic: in memory there is nothing to wait for, and everybody
 * may read it, whatever the umask of a kiosk is. */
static bool replace(const char *path, const char *text, size_t length, struct file_error *error)
{
    char part[PATH_BYTES];
    if ((size_t)snprintf(part, sizeof part, "%s.part", path) >= sizeof part) {
        return file_fail(error, path, "the name is too long");
    }
    int fd = open(part, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0644);
    if (fd < 0) {
        return file_fail_code(error, path, errno);
    }
    bool good = file_write_whole(fd, text, length) && fchmod(fd, 0644) == 0 && rename(part, path) == 0;
    int code = errno;
    close(fd);
    if (!good) {
        unlink(part);
        return file_fail_code(error, path, code);
    }
    return true;
}

static bool write_one(struct status_writer *writer, const char *path,
                      size_t (*fill)(const struct status *, char *, size_t), struct file_error *error)
{
    size_t length = fill(&writer->status, writer->text, sizeof writer->text);
    return length == 0 ? file_fail(error, path, "the status is too long for it")
                       : replace(path, writer->text, length, error);
}

static void *work(void *context)
{
    struct status_writer *writer = context;
    struct file_error error;
    pthread_mutex_lock(&writer->mutex);
    while (!writer->ends) {
        if (!writer->waiting) {
            pthread_cond_wait(&writer->changed, &writer->mutex);
            continue;
        }
        writer->waiting = false;
        writer->status = writer->next;
        pthread_mutex_unlock(&writer->mutex);
        bool good = write_one(writer, writer->json, status_json, &error) &&
                    write_one(writer, writer->metrics, status_metrics, &error);
        pthread_mutex_lock(&writer->mutex);
        if (good == writer->failed) {
            writer->failed = !good;
            writer->has_line = true;
            snprintf(writer->line, sizeof writer->line, "%s", good ? "the status is written again" : error.text);
        }
    }
    pthread_mutex_unlock(&writer->mutex);
    return NULL;
}

static void finish(struct status_writer *writer)
{
    pthread_cond_destroy(&writer->changed);
    pthread_mutex_destroy(&writer->mutex);
    free(writer->json);
    free(writer->metrics);
    free(writer);
}

struct status_writer *status_writer_create(const char *folder)
{
    struct status_writer *writer = calloc(1, sizeof *writer);
    if (!writer) {
        return NULL;
    }
    pthread_mutex_init(&writer->mutex, NULL);
    pthread_cond_init(&writer->changed, NULL);
    writer->json = join(folder, STATUS_JSON);
    writer->metrics = join(folder, STATUS_METRICS);
    if (!writer->json || !writer->metrics || pthread_create(&writer->thread, NULL, work, writer) != 0) {
        finish(writer);
        return NULL;
    }
    return writer;
}

void status_writer_destroy(struct status_writer *writer)
{
    if (!writer) {
        return;
    }
    pthread_mutex_lock(&writer->mutex);
    writer->ends = true;
    pthread_cond_signal(&writer->changed);
    pthread_mutex_unlock(&writer->mutex);
    pthread_join(writer->thread, NULL);
    unlink(writer->json);
    unlink(writer->metrics);
    finish(writer);
}

bool status_writer_due(const struct status_writer *writer, uint64_t now_us)
{
    return !writer->begun || now_us - writer->posted_us >= STATUS_EVERY_US;
}

void status_writer_post(struct status_writer *writer, const struct status *status, uint64_t now_us)
{
    writer->begun = true;
    writer->posted_us = now_us;
    pthread_mutex_lock(&writer->mutex);
    writer->next = *status;
    writer->waiting = true;
    pthread_cond_signal(&writer->changed);
    pthread_mutex_unlock(&writer->mutex);
}

bool status_writer_log(struct status_writer *writer, char *line, int size)
{
    pthread_mutex_lock(&writer->mutex);
    bool has = writer->has_line;
    if (has) {
        snprintf(line, (size_t)size, "%s", writer->line);
        writer->has_line = false;
    }
    pthread_mutex_unlock(&writer->mutex);
    return has;
}
