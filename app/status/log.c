#include "log.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "hash.h"

enum { BYTES = 2 * LOG_TEXT };

void log_init(struct log *log, int fd)
{
    const char *stream = getenv("JOURNAL_STREAM");
    struct stat is;
    char text[64];
    *log = (struct log){.journal = false};
    if (stream && fstat(fd, &is) == 0) {
        snprintf(text, sizeof text, "%ju:%ju", (uintmax_t)is.st_dev, (uintmax_t)is.st_ino);
        log->journal = strcmp(text, stream) == 0;
    }
}

static uint64_t hash_of(const char *text)
{
    return hash_bytes(HASH_START, text, strlen(text));
}

static struct log_known *find(struct log *log, uint64_t hash, uint64_t now_us)
{
    struct log_known *oldest = &log->known[0];
    for (int i = 0; i < LOG_KNOWN; i++) {
        struct log_known *known = &log->known[i];
        if (known->said > 0 && known->hash == hash) {
            return known;
        }
        if (oldest->said > 0 && (known->said == 0 || known->since_us < oldest->since_us)) {
            oldest = known;
        }
    }
    *oldest = (struct log_known){.hash = hash, .since_us = now_us};
    return oldest;
}

/* Whether there is room for another one; *held: how many there was none for, in the span that has just ended. */
static bool admit(uint64_t *since_us, uint32_t *said, uint32_t *holding, uint32_t most, uint64_t now_us, uint32_t *held)
{
    *held = 0;
    if (now_us - *since_us >= LOG_SPAN_US) {
        *held = *holding;
        *since_us = now_us;
        *said = *holding = 0;
    }
    if (*said >= most) {
        (*holding)++;
        return false;
    }
    (*said)++;
    return true;
}

struct page {
    char *bytes;
    size_t size, length;
};

static void put(struct page *page, const char *text, size_t length)
{
    size_t room = page->size - page->length;
    length = length < room ? length : room;
    memcpy(page->bytes + page->length, text, length);
    page->length += length;
}

static void put_line(const struct log *log, struct page *page, enum log_level level, const char *text, size_t length)
{
    char prefix[16];
    int used = snprintf(prefix, sizeof prefix, log->journal ? "<%d>" : "frond: ", (int)level);
    put(page, prefix, (size_t)used);
    put(page, text, length);
}

size_t log_bytes(struct log *log, enum log_level level, uint64_t now_us, const char *text, char *bytes, size_t size)
{
    struct page page = {bytes, size, 0};
    struct log_known *known = find(log, hash_of(text), now_us);
    uint32_t same, all;
    char note[80];
    bytes[0] = '\0';
    if (!admit(&known->since_us, &known->said, &known->held, LOG_SAME, now_us, &same) ||
        !admit(&log->since_us, &log->said, &log->held, LOG_LINES, now_us, &all)) {
        return 0;
    }
    if (all > 0) {
        int used = snprintf(note, sizeof note, "%u lines were held back: there were too many\n", all);
        put_line(log, &page, LOG_LEVEL_WARNING, note, (size_t)used);
    }
    while (*text) {
        size_t length = strcspn(text, "\n");
        put_line(log, &page, level, text, length);
        text += length + (text[length] == '\n');
        if (!*text && same > 0) {
            int used = snprintf(note, sizeof note, " (%u times more since it was said last)", same);
            put(&page, note, (size_t)used);
        }
        put(&page, "\n", 1);
    }
    return page.length;
}

void log_say(struct log *log, enum log_level level, uint64_t now_us, const char *format, ...)
{
    char text[LOG_TEXT], bytes[BYTES];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    size_t length = log_bytes(log, level, now_us, text, bytes, sizeof bytes);
    fwrite(bytes, 1, length, stderr);
}
