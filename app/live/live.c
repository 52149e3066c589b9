#include "live.h"

#include <malloc.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/signalfd.h>
#include <time.h>
#include <unistd.h>

#include "bench.h"
#include "gpu_limits.h"
#include "image.h"
#include "live_loop.h"
#include "log.h"
#include "script_sheet.h"

enum {
    WAIT_MS = 100,        /* for something to happen, at most */
    NAP_US = 2000,        /* while the next picture is being painted */
    RENEW_EVERY_MS = 250, /* tries to come back from a lost GPU */
    LARGE_BYTES = 256 << 10,
    ARENAS = 2,
};

static const double AGAIN_S = 0.25; /* the last picture is presented again: a window may have been uncovered */

struct live_def live_default_def(void)
{
    return (struct live_def){.ticks_per_second = STUDIO_TICKS_PER_SECOND, .governed = true};
}

static uint64_t now_us(void)
{
    return (uint64_t)(1e6 * bench_wall_s());
}

static void say(struct live *live, enum log_level level, const char *format, ...) __attribute__((format(printf, 3, 4)));
static void say(struct live *live, enum log_level level, const char *format, ...)
{
    char text[LOG_TEXT];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    log_say(&live->log, level, now_us(), "%s", text);
}

/* SIGINT and SIGTERM come as something to read; threads made after this do not see them. */
static int catch_signals(void)
{
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return sigprocmask(SIG_BLOCK, &set, NULL) == 0 ? signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC) : -1;
}

static void release_signals(int descriptor)
{
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    if (descriptor >= 0) {
        close(descriptor);
    }
    sigprocmask(SIG_UNBLOCK, &set, NULL);
}

bool live_over(const struct live *live)
{
    struct signalfd_siginfo info;
    return display_closed(live->display) || live_kiosk_leaves(&live->kiosk) ||
           read(live->signals, &info, sizeof info) == (ssize_t)sizeof info ||
           (live->def->frames > 0 && display_frames(live->display).presented >= (uint64_t)live->def->frames);
}

static void feel(struct live *live)
{
    char line[1300];
    live_input_feel(&live->input, live->display, live->studio);
    enum log_level level;
    live_kiosk_run(&live->kiosk);
    while (live_input_log(&live->input, line, sizeof line) || live_service_log(&live->service, line, sizeof line) ||
           live_group_log(&live->group, line, sizeof line)) {
        say(live, LOG_LEVEL_NOTICE, "%s", line);
    }
    while (live_kiosk_log(&live->kiosk, line, sizeof line, &level)) {
        say(live, level, "%s", line);
    }
}

/* What has become of the screen, whenever that is another line than before. */
static void note_state(struct live *live)
{
    static const char *const STATES[] = {"shown", "switched off", "no display is connected", "lent to another program"};
    enum display_state state = display_state(live->display);
    const char *text = display_describe(live->display);
    if (state == live->state && strcmp(text, live->described) == 0) {
        return;
    }
    if (state != live->state) {
        studio_rest(live->studio, state != DISPLAY_SHOWN);
        live_input_unseen(&live->input);
    }
    live->state = state;
    snprintf(live->described, sizeof live->described, "%s", text);
    say(live, LOG_LEVEL_NOTICE, "display: %s%s%s", state == DISPLAY_SHOWN ? "" : STATES[state],
        state == DISPLAY_SHOWN ? "" : "; ", text);
}

static void nap(void)
{
    struct timespec time = {0, NAP_US * 1000L};
    nanosleep(&time, NULL);
}

/* Draws a frame if there is something new to show, or the old one has stood for long. */
static bool draw(struct live *live)
{
    bool fresh;
    double now = bench_wall_s();
    if (!display_begin(live->display)) {
        return true;
    }
    const struct fields *fields = studio_newest(live->studio, &fresh);
    bool moves = fresh || live_scene_draw_moves(&live->scene_draw);
    if (!fields || (!moves && !live_kiosk_changed(&live->kiosk) && !live_picture_fades(&live->picture) &&
                    now - live->presented_s < AGAIN_S)) {
        nap();
        return true;
    }
    struct shader_error error;
    if (!live_picture_draw(&live->picture, live->display, fields, fresh, &error) ||
        !live_scene_draw(&live->scene_draw, live->display, &error) || !live_kiosk_draw(&live->kiosk, &error)) {
        say(live, LOG_LEVEL_ERROR, "%s", error.text);
        return false;
    }
    live_input_draws(&live->input, live->display, fields->number);
    display_end(live->display);
    bool goes_on = live->moved && live->presented_s > 0; /* after a rest, no frame was late */
    live->moved = moves;
    if (goes_on && moves) {
        status_frame(&live->service.status.frames, now - live->presented_s);
    }
    if (live->def->governed && goes_on && fresh) {
        const char *line = live_care_frame(&live->care, live->studio, 1000 * (now - live->presented_s),
                                           controls_are_held(live->input.controls));
        if (line) {
            say(live, LOG_LEVEL_NOTICE, "%s", line);
        }
    }
    live->presented_s = now;
    return true;
}

/* Before and after the studio is stopped: it waits for nobody then. */
static void release(struct live *live, bool on)
{
    if (live->scene) {
        live_scene_release(live->scene, on);
    }
}

/* From a lost GPU to the painting on the screen again: a new context, new textures, the engine as the newest checkpoint
 * has it. */
static bool recover(struct live *live)
{
    struct device_error device_error;
    struct studio_error error;
    double start = bench_wall_s();
    live->service.status.gpu_resets++;
    say(live, LOG_LEVEL_WARNING, "GL is lost");
    live_picture_finish(&live->picture);
    live_scene_draw_finish(&live->scene_draw);
    live_kiosk_lost(&live->kiosk);
    live_input_unseen(&live->input);
    release(live, true);
    studio_suspend(live->studio);
    release(live, false);
    while (!display_renew(live->display, &device_error)) {
        if (live_over(live)) {
            return false;
        }
        display_wait(live->display, RENEW_EVERY_MS);
    }
    if (!studio_resume(live->studio, live->display, &error)) {
        say(live, LOG_LEVEL_ERROR, "%s", error.text);
        return false;
    }
    say(live, LOG_LEVEL_NOTICE, "the painting is back after %.0f ms", 1000 * (bench_wall_s() - start));
    return true;
}

/* Once a second: what there is to say, and to decide. */
static void look_after(struct live *live)
{
    double now = bench_wall_s();
    if (now - live->second_s < 1) {
        return;
    }
    struct studio_report report = studio_report(live->studio);
    live->second_s = now;
    if (report.trouble[0]) {
        say(live, LOG_LEVEL_WARNING, "%s", report.trouble);
    }
    if (report.ended && !live->said_end) {
        live->said_end = true;
        say(live, LOG_LEVEL_INFO, "the session has ended at tick %lld", (long long)report.ticks);
    }
    live_picture_reload(&live->picture);
}

static void say_totals(struct live *live)
{
    struct studio_report report = studio_report(live->studio);
    struct display_frames frames = display_frames(live->display);
    say(live, LOG_LEVEL_INFO, "%llu frames presented, %llu vertical blanks missed, %lld ticks of %.1f ms",
        (unsigned long long)frames.presented, (unsigned long long)frames.missed, (long long)report.ticks,
        report.tick_ms);
    char text[200];
    if (*latency_text(&live->input.latency, text, sizeof text)) {
        say(live, LOG_LEVEL_INFO, "delays %s", text);
    }
}

static bool write_shot(struct live *live)
{
    struct display_size size = display_sheet(live->display);
    uint8_t *rgb = live->def->shot ? malloc((size_t)size.width * (size_t)size.height * 3 + 1) : NULL;
    struct file_error error;
    bool good = true;
    if (live->def->shot && !(rgb && display_capture(live->display, rgb))) {
        say(live, LOG_LEVEL_ERROR, "%s: there is no frame to write", live->def->shot);
        good = false;
    } else if (live->def->shot && !image_write_png(live->def->shot, rgb, size.width, size.height, NULL, &error)) {
        say(live, LOG_LEVEL_ERROR, "%s", error.text);
        good = false;
    }
    free(rgb);
    return good;
}

bool live_turn(struct live *live)
{
    display_wait(live->display, live_input_wait_ms(&live->input, live_kiosk_wait_ms(&live->kiosk, WAIT_MS)));
    if (display_lost(live->display)) {
        return recover(live);
    }
    feel(live);
    note_state(live);
    bool good = draw(live);
    look_after(live);
    live_service_turn(&live->service, &live->kiosk, now_us());
    live_group_turn(&live->group, &live->kiosk, &live->service.status, now_us());
    return good;
}

/* In the studio's thread: to whoever listens. */
static void tell(void *data, const struct studio_event *event)
{
    const struct live *live = data;
    for (int i = 0; i < LIVE_LISTENERS; i++) {
        if (live->listener[i].tell) {
            live->listener[i].tell(live->listener[i].data, event);
        }
    }
}

/* A scene for an exhibit, in which they come and go, or for a session in which something else than paint grows. */
static bool open_scene(struct live *live)
{
    const struct exhibit *exhibit = live->def->exhibit;
    enum scene_kind kind = live_scene_kind(live->script);
    const char *id = "";
    for (int i = 0; exhibit && i < exhibit->scene_count; i++) {
        if (exhibit->scenes[i].script == live->script) {
            kind = (enum scene_kind)exhibit->scenes[i].kind;
            id = exhibit->scenes[i].id;
        }
    }
    if (exhibit || kind != SCENE_PAINTING) {
        live->scene = live_scene_create(scene_types);
        if (!live->scene) {
            say(live, LOG_LEVEL_ERROR, "memory is short for a scene");
            return false;
        }
        live_scene_scene(live->scene, live->script, kind, id);
    }
    live_scene_draw_init(&live->scene_draw, live->def->xray ? NULL : live->scene,
                         live->def->shaders ? &live->folder : NULL);
    return true;
}

static bool open_studio(struct live *live)
{
    char path[1200];
    struct studio_def def = studio_default_def();
    struct studio_error error;
    struct painting_def painting = script_painting(live->script);
    const struct shader_folder *folder = live->folder.path ? &live->folder : NULL;
    struct shader_error limits;
    if (!gpu_limits_check(&limits)) { /* what will not work says so itself */
        say(live, LOG_LEVEL_WARNING, "%s", limits.text);
    }
    live->choice = engine_choose(live->def->engine, &painting, gpu_limits_renderer(), folder,
                                 engine_choice_path(path, sizeof path) ? path : NULL);
    say(live, LOG_LEVEL_INFO, "%s", live->choice.why);
    def.script = live->script;
    def.engine = live->choice.kind;
    def.folder = folder;
    def.ticks_per_second = live->def->ticks_per_second;
    def.xray = live->def->xray;
    def.once = live->def->once;
    live_keep_open(&live->painting, live->def->state, live->def->exhibit, live->choice.kind, live->scene);
    live_keep_studio(&live->painting, live->def->exhibit, &def);
    live->listener[0] = def.teller;
    live->listener[1] = live->scene ? (struct studio_teller){live_scene_tell, live->scene} : live->listener[1];
    def.teller = (struct studio_teller){tell, live};
    live->studio = studio_create(&def, live->display, &error);
    if (!live->studio) {
        say(live, LOG_LEVEL_ERROR, "%s", error.text);
    }
    return live->studio;
}

/* The exhibit's kiosk with its input, or the input of a session. */
static bool open_input(struct live *live)
{
    const struct live_input_def input = {.inputs = live->def->inputs,
                                         .rotation = live->def->rotation,
                                         .hold = live->def->hold,
                                         .console = live->def->console};
    const struct live_kiosk_def def = {.exhibit = live->def->exhibit,
                                       .open = live->def->open,
                                       .painting = &live->painting,
                                       .scene = live->scene,
                                       .scene_draw = &live->scene_draw,
                                       .state = live->def->state,
                                       .trouble = live->def->trouble,
                                       .clock = live->def->clock};
    const struct live_status_def status = {.display = live->display,
                                           .studio = live->studio,
                                           .input = &live->input,
                                           .care = &live->care,
                                           .engine = live->choice.why,
                                           .kind = engine_kind_name(live->choice.kind)};
    bool good = live_kiosk_open(&live->kiosk, &def, &status, &live->picture, &live->input, &input,
                                live->def->shaders ? &live->folder : NULL) &&
                (def.exhibit || live_input_open(&live->input, live->script, live->display, &input));
    if (!good) {
        say(live, LOG_LEVEL_ERROR, "memory is short for what visitors do");
    }
    return good;
}

/* What is large goes back to the system as soon as it is free. By itself glibc (mallopt(3)) raises the size from which
 * it does that to what was freed last, up to 32 MiB, and a process that runs for months keeps the most it ever had,
 * once an arena. */
static void keep_memory_low(void)
{
#ifdef M_MMAP_THRESHOLD
    mallopt(M_MMAP_THRESHOLD, LARGE_BYTES);
    mallopt(M_TRIM_THRESHOLD, LARGE_BYTES);
    mallopt(M_ARENA_MAX, ARENAS);
#endif
}

bool live_open(struct live *live, const struct script *script, struct display *display, const struct live_def *def)
{
    *live = (struct live){
        .script = script, .def = def, .display = display, .folder = {def->shaders}, .state = display_state(display)};
    log_init(&live->log, STDERR_FILENO);
    keep_memory_low();
    live->signals = catch_signals();
    live_picture_init(&live->picture, script, def->xray, def->shaders ? &live->folder : NULL);
    snprintf(live->described, sizeof live->described, "%s", display_describe(display));
    say(live, LOG_LEVEL_INFO, "display: %s", live->described);
    bool good = live->signals >= 0 &&
                live_care_init(&live->care, script, display_frames(display).refresh_mhz, def->ticks_per_second) &&
                open_scene(live) && open_studio(live) && open_input(live) &&
                live_service_open(&live->service, now_us());
    if (good) {
        studio_rest(live->studio, live->state != DISPLAY_SHOWN);
    }
    return good;
}

void live_close(struct live *live)
{
    live_group_close(&live->group);
    live_service_close(&live->service);
    release(live, true);
    studio_destroy(live->studio);
    live_keep_close(&live->painting);
    live_scene_draw_finish(&live->scene_draw);
    live_scene_destroy(live->scene);
    live_input_close(&live->input);
    live_kiosk_close(&live->kiosk);
    live_picture_finish(&live->picture);
    live_care_finish(&live->care);
    release_signals(live->signals);
}

bool live(const struct script *script, struct display *display, const struct live_def *def)
{
    struct live live;
    bool good = live_open(&live, script, display, def);
    if (good) {
        while (good && !live_over(&live)) {
            good = live_turn(&live);
        }
        note_state(&live); /* what has ended it, if the screen has */
        say_totals(&live);
        good = write_shot(&live) && good;
    }
    live_close(&live);
    return good;
}
