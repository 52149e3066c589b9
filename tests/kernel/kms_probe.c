/* kms_probe [options]: shows a known picture on a display and puts it through what befalls displays, in this order.
 *
 *   --kind KIND          auto, kms, window, headless           (kms)
 *   --card PATH --connector NAME --mode WxH[@HZ] --rotation DEGREES --legacy
 *   --start-unplugged    the connector is forced off before the start, and plugged in again after
 *   --frames N           frames to be shown                    (60)
 *   --plain              frames of one colour, which take no time: for what needs many
 *   --capture FILE       the last of them as a PPM, after it has been compared with what it should be
 *   --shot COMMAND       runs it while the picture stands still (a screenshot from outside), with PROBE_SHOT in its
 *                        environment: shown, dark or lent
 *   --lend SECONDS       another process becomes master, sets a mode and leaves again
 *   --power N            N times off and on
 *   --unplug N           N times the connector is forced off and plugged in again by sysfs; every 10th time nobody
 * tells
 *   --reset              the context is lost and made anew
 *   --stay               then shows frames until a line comes on standard input; `mark` says what has been shown and is
 *                        held, anything else ends it
 *   --hold SECONDS --fd N  is the other process: master of the open card N; shows another mode, leaves
 *
 * Prints every state as it comes. Ends with 0 when everything happened; 1: it did not; 2: no display. */
#include <errno.h>
#include <fcntl.h>
#include <getopt.h>
#include <glob.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <xf86drm.h>
#include <xf86drmMode.h>

#include <GLES3/gl31.h>

#include "display.h"
#include "pattern.h"

struct probe {
    struct display_def def;
    struct display *display;
    struct pattern pattern;
    enum display_state state;
    int frames, lend, power, unplug, hold, fd;
    bool start_unplugged, reset, stay, plain;
    const char *capture, *shot;
    long drawn;
};

static double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static bool fail(const char *what)
{
    printf("FAIL: %s\n", what);
    return false;
}

static void tell(struct probe *probe)
{
    static const char *const STATES[] = {"shown", "dark", "absent", "lent"};
    enum display_state state = display_state(probe->display);
    if (state != probe->state) {
        struct display_frames frames = display_frames(probe->display);
        printf("state %s, %llu frames: %s\n", STATES[state], (unsigned long long)frames.presented,
               display_describe(probe->display));
        probe->state = state;
    }
}

static void turn_loop(struct probe *probe)
{
    display_wait(probe->display, 20);
    tell(probe);
    if (display_begin(probe->display)) {
        if (probe->plain) {
            glClearColor((float)(probe->drawn % 2), 0, 1, 1);
            glClear(GL_COLOR_BUFFER_BIT);
        } else {
            pattern_draw(&probe->pattern, probe->display);
        }
        display_end(probe->display);
        probe->drawn++;
    }
    tell(probe);
}

static bool await_state(struct probe *probe, enum display_state state, double limit)
{
    double end = seconds_now() + limit;
    while (display_state(probe->display) != state && seconds_now() < end) {
        turn_loop(probe);
    }
    return display_state(probe->display) == state;
}

static bool await_frames(struct probe *probe, int count, double limit)
{
    uint64_t until = display_frames(probe->display).presented + (uint64_t)count;
    double end = seconds_now() + limit;
    while (display_frames(probe->display).presented < until && seconds_now() < end) {
        turn_loop(probe);
    }
    return display_frames(probe->display).presented >= until;
}

/* The first connector's file of that name, or that of the connector asked for. */
static bool write_connector(const struct probe *probe, const char *text)
{
    char pattern[200];
    glob_t found = {0};
    const char *card = probe->def.card ? strrchr(probe->def.card, '/') + 1 : "card0";
    snprintf(pattern, sizeof pattern, "/sys/class/drm/%s-%s/status", card,
             probe->def.connector ? probe->def.connector : "*");
    bool done = false;
    if (glob(pattern, 0, NULL, &found) == 0) {
        int fd = open(found.gl_pathv[0], O_WRONLY | O_CLOEXEC);
        done = fd >= 0 && write(fd, text, strlen(text)) > 0;
        close(fd);
    }
    globfree(&found);
    return done || fail("the connector's status cannot be written");
}

/* What the kernel says when a wire tells it. */
static void send_uevent(const struct probe *probe)
{
    char path[200];
    snprintf(path, sizeof path, "/sys/class/drm/%s/uevent",
             probe->def.card ? strrchr(probe->def.card, '/') + 1 : "card0");
    int fd = open(path, O_WRONLY | O_CLOEXEC);
    if (fd >= 0 && write(fd, "change", 6) < 0) {
        perror(path);
    }
    close(fd);
}

struct holdings {
    int fds, framebuffers, maps; /* of buffers */
};

/* -1: the kernel's debugging files are not mounted. */
static int count_framebuffers(void)
{
    FILE *file = fopen("/sys/kernel/debug/dri/0/framebuffer", "r");
    char line[200];
    int count = 0;
    while (file && fgets(line, sizeof line, file)) {
        count += strncmp(line, "framebuffer[", 12) == 0;
    }
    if (file) {
        fclose(file);
    }
    return file ? count : -1;
}

static int count_maps(void)
{
    FILE *file = fopen("/proc/self/maps", "r");
    char line[500];
    int count = 0;
    while (file && fgets(line, sizeof line, file)) {
        count += strstr(line, "/dev/dri/") != NULL;
    }
    if (file) {
        fclose(file);
    }
    return count;
}

static struct holdings holdings(void)
{
    glob_t found = {0};
    glob("/proc/self/fd/*", 0, NULL, &found);
    struct holdings now = {(int)found.gl_pathc, count_framebuffers(), count_maps()};
    globfree(&found);
    return now;
}

static bool take_shot(const struct probe *probe, const char *name)
{
    return !probe->shot || (setenv("PROBE_SHOT", name, 1) == 0 && system(probe->shot) == 0) || fail("no screenshot");
}

static void mark(const struct probe *probe)
{
    struct holdings now = holdings();
    printf("mark: %llu frames, %d fds, %d framebuffers\n", (unsigned long long)display_frames(probe->display).presented,
           now.fds, now.framebuffers);
}

/* Standard input is read without a buffer, since poll knows of none. No more than fifty frames a second, also where
 * there is no vertical blank. */
static bool stay(struct probe *probe)
{
    struct pollfd input = {STDIN_FILENO, POLLIN, 0};
    for (;;) {
        turn_loop(probe);
        if (poll(&input, 1, 20) > 0) {
            char line[16] = "";
            ssize_t got = read(STDIN_FILENO, line, sizeof line - 1);
            mark(probe);
            if (got <= 0 || strncmp(line, "mark", 4) != 0) {
                return true;
            }
        }
    }
}

static bool unplug_often(struct probe *probe)
{
    struct holdings before = {0};
    double start = seconds_now();
    for (int i = 0; i < probe->unplug; i++) {
        bool told = i % 10 != 9;
        if (!write_connector(probe, "off")) {
            return false;
        }
        if (told) {
            send_uevent(probe);
        }
        if (!await_state(probe, DISPLAY_ABSENT, 20)) {
            return fail("unplugging went unnoticed");
        }
        if (display_begin(probe->display)) {
            return fail("a frame may be drawn without a screen");
        }
        if (!write_connector(probe, "detect")) {
            return false;
        }
        if (told) {
            send_uevent(probe);
        }
        if (!await_state(probe, DISPLAY_SHOWN, 20) || !await_frames(probe, 2, 20)) {
            return fail("plugging in went unnoticed");
        }
        if (i == 0) {
            before = holdings();
        }
    }
    struct holdings after = holdings();
    printf("unplugged %d times in %.1f s: fds %d then %d, framebuffers %d then %d, maps of buffers %d then %d\n",
           probe->unplug, seconds_now() - start, before.fds, after.fds, before.framebuffers, after.framebuffers,
           before.maps, after.maps);
    if (probe->unplug > 1 && memcmp(&before, &after, sizeof before) != 0) {
        return fail("something is left behind by each turn");
    }
    return true;
}

static bool power_often(struct probe *probe)
{
    for (int i = 0; i < probe->power; i++) {
        display_power(probe->display, false);
        if (!await_state(probe, DISPLAY_DARK, 1)) {
            return fail("not dark when switched off");
        }
        uint64_t before = display_frames(probe->display).presented;
        double end = seconds_now() + .3;
        while (seconds_now() < end) {
            turn_loop(probe);
        }
        if (display_frames(probe->display).presented != before) {
            return fail("frames are shown on a dark screen");
        }
        if (i == 0 && !take_shot(probe, "dark")) {
            return false;
        }
        display_power(probe->display, true);
        if (!await_frames(probe, 5, 30)) {
            return fail("no frames after switching on");
        }
    }
    printf("off and on %d times\n", probe->power);
    return true;
}

static int card_fd(void)
{
    for (int fd = 3; fd < 256; fd++) {
        char link[64], target[64] = "";
        snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
        if (readlink(link, target, sizeof target - 1) > 0 && strncmp(target, "/dev/dri/card", 13) == 0 &&
            drmIsMaster(fd)) {
            return fd;
        }
    }
    return -1;
}

static bool lend(struct probe *probe)
{
    const char *card = probe->def.card ? probe->def.card : "/dev/dri/card0";
    int mine = card_fd();
    if (mine < 0 || drmDropMaster(mine) != 0) {
        return fail("not master of the card");
    }
    int other = open(card, O_RDWR); /* who opens a card without a master becomes it; the child inherits that */
    char seconds[16], fd[16];
    snprintf(seconds, sizeof seconds, "%d", probe->lend);
    snprintf(fd, sizeof fd, "%d", other);
    pid_t child = fork();
    if (child == 0) {
        execl("/proc/self/exe", "kms_probe", "--hold", seconds, "--fd", fd, (char *)NULL);
        _exit(127);
    }
    close(other);
    if (!await_state(probe, DISPLAY_LENT, 20)) {
        return fail("losing the master went unnoticed");
    }
    double start = seconds_now();
    if (!await_state(probe, DISPLAY_SHOWN, probe->lend + 20)) {
        return fail("never master again");
    }
    printf("lent for %.1f s\n", seconds_now() - start);
    int status = 1;
    waitpid(child, &status, 0);
    if (status != 0) {
        return fail("the other master ended badly");
    }
    return await_frames(probe, 5, 30) || fail("no frames after being master again");
}

/* The other master: a white picture, by the simplest calls. */
static int hold(const struct probe *probe)
{
    int fd = probe->fd;
    drmModeRes *resources = drmModeGetResources(fd);
    drmModeConnector *connector = resources ? drmModeGetConnector(fd, resources->connectors[0]) : NULL;
    if (!connector || connector->count_modes == 0) {
        return 1;
    }
    drmModeModeInfo *mode = &connector->modes[connector->count_modes > 1];
    struct drm_mode_create_dumb dumb = {.width = mode->hdisplay, .height = mode->vdisplay, .bpp = 32};
    uint32_t id = 0;
    int result = drmIoctl(fd, DRM_IOCTL_MODE_CREATE_DUMB, &dumb);
    result |= drmModeAddFB(fd, mode->hdisplay, mode->vdisplay, 24, 32, dumb.pitch, dumb.handle, &id);
    result |= drmModeSetCrtc(fd, resources->crtcs[0], id, 0, 0, &connector->connector_id, 1, mode);
    printf("another master: %ux%u, %s\n", mode->hdisplay, mode->vdisplay, result ? strerror(errno) : "set");
    fflush(stdout);
    sleep((unsigned)probe->hold);
    drmModeFreeConnector(connector);
    drmModeFreeResources(resources);
    return result != 0;
}

static bool save(const char *path, struct display_size size, const uint8_t *rgb)
{
    FILE *file = fopen(path, "wb");
    if (!file) {
        return fail("the capture cannot be written");
    }
    fprintf(file, "P6\n%d %d\n255\n", size.width, size.height);
    size_t bytes = (size_t)size.width * (size_t)size.height * 3;
    bool done = fwrite(rgb, 1, bytes, file) == bytes;
    return (fclose(file) == 0 && done) || fail("the capture cannot be written");
}

/* A frame that is begun and never ended: nobody may see it. */
static void begin_in_vain(const struct probe *probe)
{
    double end = seconds_now() + 20;
    while (!display_begin(probe->display) && seconds_now() < end) {
        display_wait(probe->display, 20);
    }
    glClearColor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

static bool capture(const struct probe *probe)
{
    if (display_kind(probe->display) == DISPLAY_KMS) {
        begin_in_vain(probe);
    }
    struct display_size size = display_sheet(probe->display);
    uint8_t *rgb = malloc((size_t)size.width * (size_t)size.height * 3 + 1);
    bool done = rgb && display_capture(probe->display, rgb);
    long wrong = done ? pattern_wrong(size, rgb) : -1;
    printf("captured %dx%d, %ld pixels differ\n", size.width, size.height, wrong);
    done = wrong == 0 ? save(probe->capture, size, rgb) : fail("the capture is not what was drawn");
    free(rgb);
    return done;
}

static bool show_frames(struct probe *probe)
{
    double start = seconds_now();
    if (probe->frames > 0 && !await_frames(probe, probe->frames, 60 + probe->frames * 2.)) {
        return fail("frames do not reach the screen");
    }
    double took = seconds_now() - start;
    struct display_frames frames = display_frames(probe->display);
    uint64_t now_us = (uint64_t)(seconds_now() * 1e6);
    printf("%d frames in %.2f s, %.1f a second; missed %llu, last %lld us ago, mode at %d mHz\n", probe->frames, took,
           probe->frames / took, (unsigned long long)frames.missed, (long long)(now_us - frames.last_us),
           frames.refresh_mhz);
    if (probe->frames > 0 && (frames.last_us > now_us || now_us - frames.last_us > 1e6 * took + 5000000)) {
        return fail("the time of the last frame is not of this clock");
    }
    return (!probe->capture || capture(probe)) && take_shot(probe, "shown");
}

static bool renew(struct probe *probe)
{
    struct device_error error = {""};
    display_inject_reset(probe->display);
    if (!display_lost(probe->display) || display_begin(probe->display)) {
        return fail("a loss of the context goes unnoticed");
    }
    if (!display_renew(probe->display, &error)) {
        return fail(error.text);
    }
    printf("context renewed\n");
    return (pattern_make(&probe->pattern) && await_frames(probe, 5, 30)) || fail("no frames after a reset");
}

static bool start(struct probe *probe)
{
    struct device_error error = {""};
    if (probe->start_unplugged && !write_connector(probe, "off")) {
        return false;
    }
    probe->display = display_create(&probe->def, &error);
    if (!probe->display) {
        printf("no display: %s\n", error.text);
        return false;
    }
    probe->state = display_state(probe->display);
    printf("start, state %d: %s\n", probe->state, display_describe(probe->display));
    if (!pattern_make(&probe->pattern)) {
        return fail("the pattern does not compile");
    }
    if (!probe->start_unplugged) {
        return true;
    }
    struct display_context *other = display_share(probe->display);
    bool works = probe->state == DISPLAY_ABSENT && other && glGetError() == GL_NO_ERROR;
    display_context_destroy(other);
    return (works || fail("no GL without a screen")) && write_connector(probe, "detect") &&
           (await_state(probe, DISPLAY_SHOWN, 20) || fail("plugging in went unnoticed"));
}

static bool run(struct probe *probe)
{
    return show_frames(probe) && (probe->lend == 0 || lend(probe)) && (probe->power == 0 || power_often(probe)) &&
           (!probe->reset || renew(probe)) && (probe->unplug == 0 || unplug_often(probe)) &&
           (!probe->stay || stay(probe));
}

static bool read_mode(struct display_def *def, const char *text)
{
    double hertz = 0;
    int count = sscanf(text, "%dx%d@%lf", &def->width, &def->height, &hertz);
    def->refresh_mhz = (int)(hertz * 1000 + .5);
    return count >= 2;
}

static bool read_kind(struct display_def *def, const char *text)
{
    for (int kind = 0; kind < DISPLAY_KINDS; kind++) {
        if (strcmp(text, display_kind_name((enum display_kind)kind)) == 0) {
            def->kind = (enum display_kind)kind;
            return true;
        }
    }
    return false;
}

static bool read_option(struct probe *probe, int option)
{
    switch (option) {
    case 'k':
        return read_kind(&probe->def, optarg);
    case 'c':
        probe->def.card = optarg;
        return true;
    case 'n':
        probe->def.connector = optarg;
        return true;
    case 'm':
        return read_mode(&probe->def, optarg);
    case 'r':
        probe->def.rotation = atoi(optarg);
        return true;
    case 'o':
        probe->capture = optarg;
        return true;
    case 's':
        probe->shot = optarg;
        return true;
    default:
        return false;
    }
}

static bool read_options(struct probe *probe, int count, char **arguments)
{
    int legacy = 0, start_unplugged = 0, reset = 0, remain = 0, plain = 0;
    const struct option options[] = {
        {"kind", 1, NULL, 'k'},  {"card", 1, NULL, 'c'},     {"connector", 1, NULL, 'n'},
        {"mode", 1, NULL, 'm'},  {"rotation", 1, NULL, 'r'}, {"capture", 1, NULL, 'o'},
        {"shot", 1, NULL, 's'},  {"frames", 1, NULL, 1},     {"lend", 1, NULL, 2},
        {"power", 1, NULL, 3},   {"unplug", 1, NULL, 4},     {"hold", 1, NULL, 5},
        {"fd", 1, NULL, 6},      {"legacy", 0, &legacy, 1},  {"start-unplugged", 0, &start_unplugged, 1},
        {"reset", 0, &reset, 1}, {"stay", 0, &remain, 1},    {"plain", 0, &plain, 1},
        {NULL, 0, NULL, 0}};
    int *const numbers[] = {&probe->frames, &probe->lend, &probe->power, &probe->unplug, &probe->hold, &probe->fd};
    int option = 0;
    while ((option = getopt_long(count, arguments, "", options, NULL)) != -1) {
        if (option >= 1 && option <= 6) {
            *numbers[option - 1] = atoi(optarg);
        } else if (option != 0 && !read_option(probe, option)) {
            return false;
        }
    }
    probe->def.legacy = legacy;
    probe->start_unplugged = start_unplugged;
    probe->reset = reset;
    probe->stay = remain;
    probe->plain = plain;
    return optind == count;
}

int main(int count, char **arguments)
{
    struct probe probe = {.def = display_default_def(), .frames = 60};
    probe.def.kind = DISPLAY_KMS;
    setvbuf(stdout, NULL, _IOLBF, 0);
    if (!read_options(&probe, count, arguments)) {
        fprintf(stderr, "kms_probe: see the head of its source\n");
        return 2;
    }
    if (probe.hold) {
        return hold(&probe);
    }
    int status = !start(&probe) ? (probe.display ? 1 : 2) : run(&probe) ? 0 : 1;
    display_destroy(probe.display);
    printf("%s\n", status == 0 ? "pass" : "did not pass");
    return status;
}
