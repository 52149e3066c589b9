#include "soak_gauge.h"

#include <dirent.h>
#include <malloc.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include "kiosk_state.h"

static const uint32_t WRITTEN = IN_CREATE | IN_MODIFY | IN_MOVED_TO | IN_DELETE;
static const char *const FOLDERS[GAUGE_FOLDERS] = {"gallery", "painting"};
static const double SETTLE_S = 3; /* what was begun before attract is done then */
static const double WARM = 0.25;  /* of the windows are not counted */
/* Growth: an hour, or a thousand visits; and what is let pass beside the noise of the windows, since allocators take
 * memory in steps. */
static const double MOST_KB_H = 1024, MOST_KB_THOUSAND = 64, NOISE_KB = 1024;
/* Under a sanitizer time says nothing. */
#ifdef SANITIZED
enum { UNHURRIED = true };
#else
enum { UNHURRIED = false };
#endif
/* Of frames at their vertical blank: all of it is drawn by the processor here, beside the painting and the faults. */
static const double SHARE_LEAST = 0.5;
/* p95; where the machine does too much besides to reach the display's rate, so many of the frames that it does reach.
 */
static const double MS_MOST = 70, FRAME_MS_GOOD = 20, FRAMES_MOST = 20;

static int entries(const char *folder)
{
    DIR *all = opendir(folder);
    int count = 0;
    while (all && readdir(all)) {
        count++;
    }
    if (all) {
        closedir(all);
    }
    return count - 2;
}

static double resident_kb(void)
{
    long pages = 0, resident = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (file && fscanf(file, "%ld %ld", &pages, &resident) != 2) {
        resident = 0;
    }
    if (file) {
        fclose(file);
    }
    return (double)resident * (double)sysconf(_SC_PAGESIZE) / 1024;
}

bool gauge_open(struct gauge *gauge, struct soak *soak, double window_s)
{
    *gauge = (struct gauge){.window_s = window_s, .told_s = soak_s(soak)};
    gauge->writes = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    return gauge->writes >= 0 && inotify_add_watch(gauge->writes, soak->state, WRITTEN) >= 0;
}

void gauge_close(struct gauge *gauge)
{
    close(gauge->writes);
}

static void sample(struct gauge *gauge, struct soak *soak, double now)
{
    struct mallinfo2 heap = mallinfo2();
    struct gauge_window seen = {now,
                                resident_kb(),
                                (double)(heap.uordblks + heap.hblkhd) / 1024,
                                entries("/proc/self/fd") - 1,
                                entries("/proc/self/task"),
                                0,
                                0,
                                kiosk_visits(soak->live.kiosk.kiosk)};
    seen.descriptors_most = seen.descriptors;
    seen.threads_most = seen.threads;
    bool next = gauge->count == 0 || now >= gauge->windows[gauge->count - 1].s + gauge->window_s;
    if (next && gauge->count < GAUGE_WINDOWS) {
        gauge->windows[gauge->count++] = seen;
        return;
    }
    struct gauge_window *window = &gauge->windows[gauge->count - 1];
    window->resident_kb = fmin(window->resident_kb, seen.resident_kb);
    window->used_kb = fmin(window->used_kb, seen.used_kb);
    window->descriptors = seen.descriptors < window->descriptors ? seen.descriptors : window->descriptors;
    window->threads = seen.threads < window->threads ? seen.threads : window->threads;
    window->descriptors_most =
        seen.descriptors > window->descriptors_most ? seen.descriptors : window->descriptors_most;
    window->threads_most = seen.threads > window->threads_most ? seen.threads : window->threads_most;
    window->visits = seen.visits;
}

/* What the gallery has kept never exceeds its caps, but for the picture that is being written. */
static void look_at_gallery(struct gauge *gauge, struct soak *soak)
{
    char folder[120], path[420];
    int pictures = 0;
    long long bytes = 0;
    struct stat status;
    struct dirent *entry;
    snprintf(folder, sizeof folder, "%s/gallery", soak->state);
    DIR *all = opendir(folder);
    while (all && (entry = readdir(all))) {
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        bool file = stat(path, &status) == 0 && S_ISREG(status.st_mode);
        pictures += file && strstr(entry->d_name, ".png") != NULL;
        bytes += file ? status.st_size : 0;
    }
    if (all) {
        closedir(all);
    }
    gauge->kept_most = pictures > gauge->kept_most ? pictures : gauge->kept_most;
    gauge->bytes_most = bytes > gauge->bytes_most ? bytes : gauge->bytes_most;
    for (int i = 0; i < GAUGE_FOLDERS; i++) { /* whenever they are there */
        snprintf(path, sizeof path, "%s/%s", soak->state, FOLDERS[i]);
        gauge->watched[i] = gauge->watched[i] || inotify_add_watch(gauge->writes, path, WRITTEN) >= 0;
    }
}

static void look_at_writes(struct gauge *gauge, struct soak *soak)
{
    _Alignas(struct inotify_event) char bytes[4096];
    const struct live_kiosk *kiosk = &soak->live.kiosk;
    int count = 0;
    char name[100] = "";
    while (read(gauge->writes, bytes, sizeof bytes) > 0) {
        const struct inotify_event *event = (const struct inotify_event *)(const void *)bytes;
        snprintf(name, sizeof name, "%.90s", event->len > 0 ? event->name : "");
        count++;
    }
    bool calm = strcmp(kiosk_state(kiosk->kiosk), "attract") == 0 && !kiosk->keep;
    gauge->calm_s = !calm ? 0 : gauge->calm_s > 0 ? gauge->calm_s : soak_s(soak);
    bool quiet = calm && soak_s(soak) > gauge->calm_s + (UNHURRIED ? 4 * SETTLE_S : SETTLE_S);
    if (count > 0 && quiet && gauge->quiet) {
        soak_fail(soak, "in attract '%s' is written", name);
    }
    gauge->kept_seen += count > 0;
    gauge->quiet_turns += quiet;
    gauge->quiet = quiet;
}

/* What is new in a window of latency.h; another one begins where inputs are opened again. */
static void read_delays(struct delays *delays, const struct latency_window *window)
{
    if (window->count < delays->read) {
        delays->read = 0;
    }
    int64_t from = window->count - delays->read > LATENCY_WINDOW ? window->count - LATENCY_WINDOW : delays->read;
    for (int64_t i = from; i < window->count; i++) {
        uint32_t us = window->us[i % LATENCY_WINDOW], ms = us / 1000;
        if (us == 0) { /* a button of the palette: its time is of the visit's clock */
            continue;
        }
        delays->ms[ms < GAUGE_MS ? ms : GAUGE_MS - 1]++;
        delays->total++;
    }
    delays->read = window->count;
}

static int percentile(const struct delays *delays, double share)
{
    int64_t seen = 0, wanted = (int64_t)ceil(share * (double)delays->total);
    for (int i = 0; i < GAUGE_MS; i++) {
        seen += delays->ms[i];
        if (seen >= wanted) {
            return i + 1;
        }
    }
    return GAUGE_MS;
}

void gauge_turn(struct gauge *gauge, struct soak *soak)
{
    double now = soak_s(soak);
    look_at_writes(gauge, soak);
    if (now < gauge->sample_s) {
        return;
    }
    gauge->sample_s = now + 0.5;
    read_delays(&gauge->tick, &soak->live.input.latency.tick);
    read_delays(&gauge->flip, &soak->live.input.latency.flip);
    look_at_gallery(gauge, soak);
    if (!gauge->resting) {
        sample(gauge, soak, now);
    }
}

void gauge_tell(struct gauge *gauge, struct soak *soak)
{
    double now = soak_s(soak), length = now - gauge->told_s;
    struct display_frames frames = display_frames(soak->display);
    const struct gauge_window *window = &gauge->windows[gauge->count - 1];
    uint32_t visits = kiosk_visits(soak->live.kiosk.kiosk);
    double load[1] = {0};
    getloadavg(load, 1);
    soak_say("%4.0f s: %u visits (%.0f a minute), RSS %.1f MB, malloc %.1f MB, %d..%d descriptors, %d..%d threads, "
             "%.1f frames a second, missed %llu; to the tick p50 %d p95 %d, to the frame p50 %d p95 %d ms; load %.1f",
             now, visits, 60 * (visits - gauge->visits_told) / length, window->resident_kb / 1024,
             window->used_kb / 1024, window->descriptors, window->descriptors_most, window->threads,
             window->threads_most, (double)(frames.presented - gauge->frames_told.presented) / length,
             (unsigned long long)(frames.missed - gauge->frames_told.missed), percentile(&gauge->tick, 0.5),
             percentile(&gauge->tick, 0.95), percentile(&gauge->flip, 0.5), percentile(&gauge->flip, 0.95), load[0]);
    gauge->told_s = now;
    gauge->frames_told = frames;
    gauge->visits_told = visits;
}

struct slope {
    double kb_h, noise_kb_h; /* with its standard error */
    double kb_thousand;      /* visits */
};

static struct slope slope_of(const struct gauge_window *windows, int count, bool used)
{
    double s = 0, y = 0, ss = 0, sy = 0, rest = 0;
    for (int i = 0; i < count; i++) {
        s += windows[i].s / count;
        y += (used ? windows[i].used_kb : windows[i].resident_kb) / count;
    }
    for (int i = 0; i < count; i++) {
        double ds = windows[i].s - s;
        ss += ds * ds;
        sy += ds * ((used ? windows[i].used_kb : windows[i].resident_kb) - y);
    }
    double rise = ss > 0 ? sy / ss : 0;
    for (int i = 0; i < count; i++) {
        double off = (used ? windows[i].used_kb : windows[i].resident_kb) - y - rise * (windows[i].s - s);
        rest += off * off;
    }
    double visits = (double)(windows[count - 1].visits - windows[0].visits);
    double length = windows[count - 1].s - windows[0].s;
    return (struct slope){3600 * rise, count > 2 ? 3600 * sqrt(rest / (count - 2) / ss) : 0,
                          visits > 0 ? 1000 * rise * length / visits : 0};
}

/* The least of some windows: what there is when nothing is under way. */
static struct gauge_window floor_of(const struct gauge_window *windows, int count)
{
    struct gauge_window least = windows[0];
    for (int i = 1; i < count; i++) {
        const struct gauge_window *window = &windows[i];
        least.resident_kb = fmin(least.resident_kb, window->resident_kb);
        least.used_kb = fmin(least.used_kb, window->used_kb);
        least.descriptors = window->descriptors < least.descriptors ? window->descriptors : least.descriptors;
        least.threads = window->threads < least.threads ? window->threads : least.threads;
    }
    return least;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double middle_of(double *values, int count)
{
    qsort(values, (size_t)count, sizeof *values, compare);
    return values[count / 2];
}

struct level { /* what most windows have: now and then one has a buffer of 16 MB less, between two visits */
    double kb, noise_kb;
};

/* The median, and twice its standard error by the median of the distances from it. */
static struct level level_of(const struct gauge_window *windows, int count, bool used)
{
    static double values[GAUGE_WINDOWS];
    for (int i = 0; i < count; i++) {
        values[i] = used ? windows[i].used_kb : windows[i].resident_kb;
    }
    double kb = middle_of(values, count);
    for (int i = 0; i < count; i++) {
        values[i] = fabs(values[i] - kb);
    }
    return (struct level){kb, 2 * 1.2533 * 1.4826 * middle_of(values, count) / sqrt(count)};
}

static void judge_growth(struct soak *soak, const struct gauge_window *windows, int count, bool used)
{
    int half = count / 2;
    struct level first = level_of(windows, half, used), second = level_of(windows + half, count - half, used);
    const char *name = used ? "malloc" : "RSS";
    double growth = second.kb - first.kb, noise = NOISE_KB + hypot(first.noise_kb, second.noise_kb);
    double hours = (windows[half].s - windows[0].s) / 3600, visits = windows[half].visits - windows[0].visits;
    soak_say("%s: %.0f KB in the first half, %.0f in the second: %+.0f, noise %.0f", name, first.kb, second.kb, growth,
             noise);
    if (growth > noise + MOST_KB_H * hours && growth > noise + MOST_KB_THOUSAND * visits / 1000) {
        soak_fail(soak, "%s grows", name);
    }
}

static void judge_memory(struct gauge *gauge, struct soak *soak, bool slopes)
{
    int warm = (int)ceil(WARM * gauge->count), count = gauge->count - 1 - warm; /* the last one is not full */
    const struct gauge_window *windows = gauge->windows + warm;
    for (int i = 0; slopes && i < gauge->count; i++) {
        const struct gauge_window *window = &gauge->windows[i];
        soak_say("%5.0f s: %u visits, RSS %.0f KB, malloc %.0f KB%s", window->s, window->visits, window->resident_kb,
                 window->used_kb, i < warm ? ", warming up" : "");
    }
    if (count < 4) {
        return;
    }
    for (int used = 0; used < 2; used++) {
        struct slope slope = slope_of(windows, count, used);
        soak_say("%s: %+.0f KB an hour (standard error %.0f), %+.1f KB a thousand visits, over %d windows of %.0f s",
                 used ? "malloc" : "RSS", slope.kb_h, slope.noise_kb_h, slope.kb_thousand, count, gauge->window_s);
    }
    struct gauge_window first = floor_of(windows, count / 2), second = floor_of(windows + count / 2, count - count / 2);
    soak_say("at least %d, then %d descriptors; %d, then %d threads", first.descriptors, second.descriptors,
             first.threads, second.threads);
    if (slopes) {
        judge_growth(soak, windows, count, false);
        judge_growth(soak, windows, count, true);
    }
    if (slopes && (second.descriptors > first.descriptors || second.threads > first.threads)) {
        soak_fail(soak, "descriptors or threads are more and more");
    }
}

void gauge_judge(struct gauge *gauge, struct soak *soak, bool slopes)
{
    struct display_frames frames = display_frames(soak->display);
    double frame_ms = 1000 * soak_s(soak) / (double)(frames.presented + 1);
    double most = frame_ms <= FRAME_MS_GOOD ? MS_MOST : MS_MOST + FRAMES_MOST * frame_ms;
    double p95[2] = {percentile(&gauge->tick, 0.95), percentile(&gauge->flip, 0.95)};
    judge_memory(gauge, soak, slopes);
    soak_say("delays of %lld actions: to the tick p50 %d p95 %.0f ms, of %lld to the frame p50 %d p95 %.0f ms",
             (long long)gauge->tick.total, percentile(&gauge->tick, 0.5), p95[0], (long long)gauge->flip.total,
             percentile(&gauge->flip, 0.5), p95[1]);
    soak_say("%llu frames in %.0f s, %.2f %% of vertical blanks missed", (unsigned long long)frames.presented,
             soak_s(soak), 100.0 * (double)frames.missed / (double)(frames.presented + frames.missed + 1));
    soak_say("%d turns of the loop, %d of them longer than half a second, the longest %.1f s", soak->turns,
             soak->slow_turns, soak->turn_most_s);
    soak_say("the gallery had %d pictures and %.0f KB at most", gauge->kept_most, (double)gauge->bytes_most / 1024);
    bool late = slopes && (p95[0] > most || p95[1] > most) && !UNHURRIED;
    if (gauge->tick.total == 0 || gauge->flip.total == 0 || late) {
        soak_fail(soak, "95 of 100 actions must reach their tick and their frame in %.0f ms, with frames of %.0f ms",
                  most, frame_ms);
    }
    double share = (double)frames.presented / (double)(frames.presented + frames.missed + 1);
    if (slopes && !UNHURRIED && (share < SHARE_LEAST || soak->slow_turns > soak->turns / 1000 + 1)) {
        soak_fail(soak,
                  "%.0f %% of frames must come at their time, and turns within half a second, but for one in 1000",
                  100 * SHARE_LEAST);
    }
    if (gauge->kept_most < 1 || gauge->kept_most > SOAK_PICTURES + 1 ||
        gauge->bytes_most > (SOAK_MEGABYTES << 20) + (SOAK_MEGABYTES << 20) / 4) {
        soak_fail(soak, "the gallery may keep %d pictures and %d MB, and one more for a moment", SOAK_PICTURES,
                  SOAK_MEGABYTES);
    }
    if (gauge->quiet_turns < 1 || gauge->kept_seen < 1) {
        soak_fail(soak, "attract was seen for %d turns, writes %d times", gauge->quiet_turns, gauge->kept_seen);
    }
}
