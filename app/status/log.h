/* Lines for those who look after a kiosk: on a terminal `frond: text`, in the journal of systemd `<4>text`, with its
 * level. A fault that repeats at sixty frames a second must neither fill a disk nor hide the others: the same line is
 * written LOG_SAME times in LOG_SPAN_US and then held back until that is over; of all lines together LOG_LINES are.
 * What was held back is counted and told. Knows no clock. */
#ifndef FROND_LOG_H
#define FROND_LOG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum log_level { LOG_LEVEL_ERROR = 3, LOG_LEVEL_WARNING = 4, LOG_LEVEL_NOTICE = 5, LOG_LEVEL_INFO = 6 }; /* syslog(3) */

enum {
    LOG_SAME = 3,
    LOG_LINES = 120,
    LOG_SPAN_US = 60000000,
    LOG_KNOWN = 32, /* lines that are told apart; the one that was said longest ago makes room */
    LOG_TEXT = 1400 /* bytes of a line, with the final NUL; more is cut */
};

struct log {
    bool journal;
    struct log_known {
        uint64_t hash, since_us; /* since_us: when its span began */
        uint32_t said, held;     /* in the span */
    } known[LOG_KNOWN];
    uint64_t since_us;
    uint32_t said, held; /* all of them */
};

/* For what is written to this descriptor. It is the journal where JOURNAL_STREAM says so (systemd.exec(5)). */
void log_init(struct log *log, int fd);
/* The bytes to write for `text`, which may have more than one line; each of them gets its prefix. Returns their number,
 * 0: it is held back. */
size_t log_bytes(struct log *log, enum log_level level, uint64_t now_us, const char *text, char *bytes, size_t size);
/* Writes them to stderr. `now_us` of any clock that does not jump. */
void log_say(struct log *log, enum log_level level, uint64_t now_us, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

#endif
