#include "display.h"

#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <GLES3/gl31.h>

#include "display_rotation.h"
#include "display_source.h"

static const char *const KINDS[DISPLAY_KINDS] = {"auto", "kms", "window", "headless"};

struct display_def display_default_def(void)
{
    return (struct display_def){.kind = DISPLAY_AUTO, .robust = true};
}

const char *display_kind_name(enum display_kind kind)
{
    return KINDS[kind];
}

void display_post(struct display *display, struct event event)
{
    event.source = SOURCE_WINDOW;
    source_post(&display->queue, &event);
}

bool display_event(struct display *display, struct event *event)
{
    return source_take(&display->queue, event);
}

static bool is_desktop(void)
{
    const char *wayland = getenv("WAYLAND_DISPLAY"), *x11 = getenv("DISPLAY");
    return (wayland && *wayland) || (x11 && *x11);
}

struct choice {
    const struct display_source *sources[3];
    const char *why; /* the first of them is tried first */
    int count;
};

/* On a desktop a window, since another program is master of the screen there; else the screen; else memory. */
static struct choice choose(const struct display_def *def)
{
    static const struct display_source *const ALL[] = {&display_kms, &display_window, &display_headless};
    for (size_t i = 0; i < sizeof ALL / sizeof ALL[0]; i++) {
        if (def->kind == ALL[i]->kind) {
            return (struct choice){{ALL[i]}, "asked for", 1};
        }
    }
    return is_desktop() ? (struct choice){{&display_window, &display_kms, &display_headless}, "a desktop is running", 3}
                        : (struct choice){{&display_kms, &display_headless}, "no desktop is running", 2};
}

static const char *keep(char *place, size_t size, const char *text)
{
    if (text) {
        snprintf(place, size, "%s", text);
    }
    return text ? place : NULL;
}

static struct display *try_source(const struct display_def *def, const struct display_source *source, const char *why,
                                  struct device_error *error)
{
    struct display *display = calloc(1, sizeof *display);
    if (!display) {
        device_fail(error, "memory is short");
        return NULL;
    }
    display->def = *def;
    display->def.card = keep(display->card, sizeof display->card, def->card);
    display->def.connector = keep(display->connector, sizeof display->connector, def->connector);
    display->source = source;
    display->egl.display = EGL_NO_DISPLAY;
    display->egl.context = EGL_NO_CONTEXT;
    display->egl.surface = EGL_NO_SURFACE;
    snprintf(display->why, sizeof display->why, "%s", why);
    if (!source->create(display, error)) {
        display_destroy(display);
        return NULL;
    }
    return display;
}

static bool is_valid(const struct display_def *def, struct device_error *error)
{
    if (def->width < 0 || def->width > DISPLAY_SIZE_MAX || def->height < 0 || def->height > DISPLAY_SIZE_MAX) {
        return device_fail(error, "a display of %dx%d: 0..%d pixels a side are allowed", def->width, def->height,
                           DISPLAY_SIZE_MAX);
    }
    if (def->refresh_mhz < 0 || def->refresh_mhz > DISPLAY_REFRESH_MAX_MHZ) {
        return device_fail(error, "a display at %d mHz: 0..%d are allowed", def->refresh_mhz, DISPLAY_REFRESH_MAX_MHZ);
    }
    if (def->rotation % 90 != 0 || def->rotation < 0 || def->rotation > 270) {
        return device_fail(error, "a display turned by %d degrees: 0, 90, 180 or 270 are allowed", def->rotation);
    }
    return true;
}

struct display *display_create(const struct display_def *def, struct device_error *error)
{
    struct device_error reasons = {""};
    if (!is_valid(def, error)) {
        return NULL;
    }
    struct choice choice = choose(def);
    for (int i = 0; i < choice.count; i++) {
        struct display *display = try_source(def, choice.sources[i], i == 0 ? choice.why : reasons.text, error);
        if (display) {
            return display;
        }
        device_fail_too(&reasons, error);
    }
    *error = reasons;
    return NULL;
}

void display_destroy(struct display *display)
{
    if (display) {
        display->source->destroy(display);
        free(display);
    }
}

enum display_kind display_kind(const struct display *display)
{
    return display->source->kind;
}

enum display_state display_state(const struct display *display)
{
    return display->state;
}

const char *display_describe(const struct display *display)
{
    struct display *mine = (struct display *)display;
    snprintf(mine->text, sizeof mine->text, "%s%s%s, %dx%d%s; %s", KINDS[display->source->kind],
             display->note[0] ? ": " : "", display->note, display->panel.width, display->panel.height,
             display->def.rotation == 90    ? ", turned by 90 degrees"
             : display->def.rotation == 180 ? ", turned by 180 degrees"
             : display->def.rotation == 270 ? ", turned by 270 degrees"
                                            : "",
             display->why);
    return display->text;
}

struct display_size display_panel(const struct display *display)
{
    return display->panel;
}

struct display_size display_sheet(const struct display *display)
{
    struct display_size panel = display->panel;
    return display->def.rotation % 180 == 0 ? panel : (struct display_size){panel.height, panel.width};
}

void display_turn(const struct display *display, float turn[4])
{
    rotation_matrix(display->def.rotation, display->flipped, turn);
}

void display_untouch(const struct display *display, float *x, float *y)
{
    rotation_untouch(display->def.rotation, x, y);
}

void display_wait(struct display *display, int timeout_ms)
{
    display->source->wait(display, display->queue.count > 0 || display->closed ? 0 : timeout_ms);
}

void display_wake_on(struct display *display, const int *fds, int count)
{
    display->wake_count = count < DISPLAY_WAKES ? count : DISPLAY_WAKES;
    memcpy(display->wakes, fds, (size_t)display->wake_count * sizeof fds[0]);
}

bool display_poll(const struct display *display, const int own[2], int timeout_ms)
{
    struct pollfd fds[DISPLAY_WAKES + 2] = {{own[0], POLLIN, 0}, {own[1], POLLIN, 0}};
    for (int i = 0; i < display->wake_count; i++) {
        fds[i + 2] = (struct pollfd){display->wakes[i], POLLIN, 0};
    }
    if (poll(fds, (nfds_t)display->wake_count + 2, timeout_ms) < 0) {
        return true; /* a signal: the caller may have to end */
    }
    bool woken = false;
    for (int i = 0; i < display->wake_count; i++) {
        woken = woken || fds[i + 2].revents != 0;
    }
    return woken;
}

bool display_closed(const struct display *display)
{
    return display->closed;
}

bool display_begin(struct display *display)
{
    return display->state == DISPLAY_SHOWN && !display->lost && display_egl_enter(&display->egl) &&
           display->source->begin(display);
}

bool display_enter(struct display *display)
{
    return !display->lost && display_egl_enter(&display->egl);
}

void display_end(struct display *display)
{
    display->drawn = true;
    display->last = display->framebuffer;
    display->source->end(display);
}

unsigned display_framebuffer(const struct display *display)
{
    return display->framebuffer;
}

void display_power(struct display *display, bool on)
{
    if (display->source->power) {
        display->source->power(display, on);
    }
}

struct display_frames display_frames(const struct display *display)
{
    return display->frames;
}

/* GL_EXT_robustness */
typedef GLenum GL_APIENTRY reset_status(void);

bool display_lost(struct display *display)
{
    if (!display->lost && display->egl.robust && display_egl_enter(&display->egl)) {
        reset_status *status = (reset_status *)(void (*)(void))eglGetProcAddress("glGetGraphicsResetStatusEXT");
        display->lost = status && status() != GL_NO_ERROR;
    }
    return display->lost;
}

void display_inject_reset(struct display *display)
{
    display->lost = true;
}

bool display_renew(struct display *display, struct device_error *error)
{
    if (!display->source->renew(display, error)) {
        return false;
    }
    display->lost = false;
    return true;
}
