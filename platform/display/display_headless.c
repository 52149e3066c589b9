/* Frames to memory: EGL without any surface. For tests, and for boards without a screen. */
#include <stdlib.h>

#include <GLES3/gl31.h>

#include "display_canvas.h"
#include "display_source.h"

struct headless {
    struct display_canvas canvas;
    uint64_t next_us; /* of the vertical blank that the last frame waits for */
};

static bool open_context(struct display *display, struct device_error *error)
{
    struct headless *headless = display->own;
    struct display_egl *egl = &display->egl;
    if (!display_egl_context(egl, display->def.robust, error)) {
        return false;
    }
    if (!display_egl_enter(egl)) {
        return device_fail(error, "headless: the context cannot be made current: %s", display_egl_reason());
    }
    if (!display_canvas_make(&headless->canvas, display->panel.width, display->panel.height)) {
        return device_fail(error, "headless: no framebuffer of %dx%d", display->panel.width, display->panel.height);
    }
    display->framebuffer = headless->canvas.framebuffer;
    return true;
}

static bool headless_create(struct display *display, struct device_error *error)
{
    display->own = calloc(1, sizeof(struct headless));
    if (!display->own) {
        return device_fail(error, "headless: memory is short");
    }
    display->panel.width = display->def.width ? display->def.width : DISPLAY_HEADLESS_WIDTH;
    display->panel.height = display->def.height ? display->def.height : DISPLAY_HEADLESS_HEIGHT;
    display->frames.refresh_mhz = display->def.refresh_mhz;
    display->egl.config = EGL_NO_CONFIG_KHR;
    display->egl.display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    if (display->egl.display == EGL_NO_DISPLAY || !eglInitialize(display->egl.display, NULL, NULL)) {
        display->egl.display = EGL_NO_DISPLAY;
        return device_fail(error, "headless: no EGL without a surface: %s", display_egl_reason());
    }
    return open_context(display, error);
}

static void drop_framebuffer(struct display *display)
{
    struct headless *headless = display->own;
    if (display->egl.context != EGL_NO_CONTEXT && display_egl_enter(&display->egl)) {
        display_canvas_drop(&headless->canvas);
    }
    display->framebuffer = 0;
    display->drawn = false;
    display_egl_finish(&display->egl);
}

static void headless_destroy(struct display *display)
{
    if (display->own) {
        drop_framebuffer(display);
    }
    /* Not terminated: EGL gives every headless display of the process the same one. */
    free(display->own);
}

static void headless_wait(struct display *display, int timeout_ms)
{
    const struct headless *headless = display->own;
    uint64_t now = source_now_us(), end = timeout_ms < 0 ? UINT64_MAX : now + (uint64_t)timeout_ms * 1000;
    uint64_t until = display->state == DISPLAY_SHOWN ? headless->next_us : end;
    until = until < end ? until : end;
    if (until == UINT64_MAX) { /* dark, and nobody will ever wake it: do not hang the thread */
        until = now + 1000000;
    }
    static const int NONE[2] = {-1, -1};
    display_poll(display, NONE, until > now ? (int)((until - now + 999) / 1000) : 0);
}

static bool headless_begin(struct display *display)
{
    const struct headless *headless = display->own;
    glBindFramebuffer(GL_FRAMEBUFFER, display->framebuffer);
    return source_now_us() >= headless->next_us;
}

static void headless_end(struct display *display)
{
    struct headless *headless = display->own;
    uint64_t now = source_now_us(), period = 0;
    if (display->def.refresh_mhz > 0) {
        period = UINT64_C(1000000000) / (uint64_t)display->def.refresh_mhz;
    }
    glFlush();
    if (period > 0 && headless->next_us > 0 && now > headless->next_us + period) {
        uint64_t late = (now - headless->next_us) / period;
        display->frames.missed += late;
        headless->next_us += late * period;
    }
    headless->next_us = headless->next_us > 0 ? headless->next_us + period : now + period;
    display->frames.presented++;
    display->frames.last_us = now;
}

static void headless_power(struct display *display, bool on)
{
    struct headless *headless = display->own;
    headless->next_us = 0; /* what the dark lasted is not missed */
    display->state = on ? DISPLAY_SHOWN : DISPLAY_DARK;
}

static bool headless_renew(struct display *display, struct device_error *error)
{
    drop_framebuffer(display);
    return open_context(display, error);
}

const struct display_source display_headless = {
    .kind = DISPLAY_HEADLESS,
    .create = headless_create,
    .destroy = headless_destroy,
    .wait = headless_wait,
    .begin = headless_begin,
    .end = headless_end,
    .power = headless_power,
    .renew = headless_renew,
};
