#include "progress.h"

#include <time.h>
#include <unistd.h>

enum { SECOND = 1000000, PATIENCE = 2 * SECOND, PAUSE = SECOND / 5 };

static int64_t clock_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * SECOND + now.tv_nsec / 1000;
}

struct progress progress_start(const char *what, FILE *out)
{
    int64_t now = clock_now();
    return (struct progress){.out = out, .what = what, .terminal = isatty(fileno(out)), .start = now, .last = now};
}

void progress_line(const struct progress *progress, int64_t now, int64_t done, int64_t all, char *line, size_t size)
{
    double share = all > 0 ? (double)done / (double)all : 1;
    double left = share > 0 ? (double)(now - progress->start) / SECOND * (1 - share) / share : 0;
    int seconds = left < 1e6 ? (int)(left + 0.5) : 1000000;
    if (seconds < 60) {
        snprintf(line, size, "%s: %d %%, %d s left", progress->what, (int)(share * 100), seconds);
    } else {
        snprintf(line, size, "%s: %d %%, %d min %02d s left", progress->what, (int)(share * 100), seconds / 60,
                 seconds % 60);
    }
}

void progress_step(struct progress *progress, int64_t done, int64_t all)
{
    if (!progress->terminal) {
        return;
    }
    int64_t now = clock_now();
    if (now - progress->start < PATIENCE || now - progress->last < PAUSE) {
        return;
    }
    char line[160];
    progress_line(progress, now, done, all, line, sizeof line);
    fprintf(progress->out, "\r%s\x1b[K", line);
    fflush(progress->out);
    progress->last = now;
    progress->shown = true;
}

void progress_end(struct progress *progress)
{
    if (progress->shown) {
        fprintf(progress->out, "\r\x1b[K");
        fflush(progress->out);
        progress->shown = false;
    }
}
