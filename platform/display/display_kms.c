/* A screen of the board itself: KMS (kms_screen.h) shows what GL draws into its buffers (kms_buffers.h). */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <GLES3/gl31.h>

#include "display_source.h"
#include "kms_buffers.h"
#include "kms_card.h"
#include "kms_screen.h"
#include "kms_watch.h"

enum { LOST_MS = 100 }; /* the longest wait while there is no card */

struct kms {
    struct kms_card *card;
    struct kms_watch *watch;
    struct kms_buffers buffers;
    struct kms_screen screen;
    int shown;     /* index of the buffer that was presented last */
    int drawn;     /* index of the buffer that is drawn into */
    bool software; /* GL draws with the CPU, and the kernel does not know when it has finished */
};

static void drop_buffers(struct display *display)
{
    struct kms *kms = display->own;
    if (kms_buffers_made(&kms->buffers)) {
        kms_buffers_drop(&kms->buffers, &display->egl);
    }
    display->framebuffer = 0;
    display->drawn = false;
}

/* Buffers for what the screen has chosen: in a layout that its plane names, else in any. */
static void fit(struct display *display)
{
    struct kms *kms = display->own;
    const struct kms_output *output = &kms->screen.output;
    int width = output->mode.hdisplay, height = output->mode.vdisplay;
    int offered = kms->card->modifiers ? output->shape.modifier_count : 0;
    struct device_error error = {""};
    drop_buffers(display);
    if (!display_egl_enter(&display->egl)) {
        device_fail(&error, "%s: the context cannot be made current: %s", output->name, display_egl_reason());
        kms_screen_unfit(&kms->screen, &error, source_now_us());
        return;
    }
    if (offered > 0 &&
        kms_buffers_make(&kms->buffers, &display->egl, width, height, output->shape.modifiers, offered, &error)) {
        if (kms_screen_fit(&kms->screen, kms->buffers.each[0].id, false, source_now_us())) {
            return;
        }
        drop_buffers(display);
    }
    if (!kms_buffers_make(&kms->buffers, &display->egl, width, height, NULL, 0, &error)) {
        struct device_error named;
        char mode[KMS_MODE_TEXT];
        kms_mode_text(&output->mode, mode);
        device_fail(&named, "%s %s: %.200s", output->name, mode, error.text);
        kms_screen_unfit(&kms->screen, &named, source_now_us());
        return;
    }
    kms_screen_fit(&kms->screen, kms->buffers.each[0].id, true, source_now_us());
}

/* Every choice that was made, and why. */
static void note(struct display *display)
{
    struct kms *kms = display->own;
    const struct kms_screen *screen = &kms->screen;
    const struct display_def *def = &display->def;
    char mode[KMS_MODE_TEXT];
    int used = snprintf(display->note, sizeof display->note, "%s (%s, %s), ", kms->card->path, kms->card->driver,
                        kms->card->atomic ? "atomic" : "legacy");
    size_t room = sizeof display->note - (size_t)used;
    if (screen->stage == KMS_EMPTY) {
        snprintf(display->note + used, room, "%.280s", screen->reason.text[0] ? screen->reason.text : "no screen");
        return;
    }
    kms_mode_text(&screen->output.mode, mode);
    snprintf(display->note + used, room, "%s%s %s%s%s%s%.200s", screen->output.name,
             def->connector ? " (asked for)" : "", mode,
             def->width || def->height || def->refresh_mhz        ? " (asked for)"
             : screen->output.mode.type & DRM_MODE_TYPE_PREFERRED ? " (preferred)"
                                                                  : "",
             screen->lent ? ", another program is master of it" : "", screen->refused_due_us ? "; " : "",
             screen->refused_due_us ? screen->reason.text : "");
}

/* What the screen has come to, for display.c. */
static void tell(struct display *display)
{
    struct kms *kms = display->own;
    const struct kms_screen *screen = &kms->screen;
    display->state = kms_screen_state(screen);
    display->frames = screen->frames;
    display->lost = display->lost || screen->stale;
    bool sized = screen->stage != KMS_EMPTY;
    display->panel.width = sized ? screen->output.mode.hdisplay : 0;
    display->panel.height = sized ? screen->output.mode.vdisplay : 0;
    note(display);
}

static void settle(struct display *display)
{
    struct kms *kms = display->own;
    while (kms->screen.stage == KMS_CHOSEN && !kms->screen.lent) {
        fit(display);
    }
    if (kms->screen.stage == KMS_EMPTY && !kms_screen_reads(&kms->screen)) {
        drop_buffers(display);
    }
    tell(display);
}

static bool open_egl(struct display *display, struct device_error *error)
{
    struct kms *kms = display->own;
    struct display_egl *egl = &display->egl;
    kms->buffers.gbm = gbm_create_device(kms->card->fd);
    if (!kms->buffers.gbm) {
        return device_fail(error, "kms: %s (%s): no GBM", kms->card->path, kms->card->driver);
    }
    egl->config = EGL_NO_CONFIG_KHR;
    egl->display = eglGetPlatformDisplay(EGL_PLATFORM_GBM_KHR, kms->buffers.gbm, NULL);
    if (egl->display == EGL_NO_DISPLAY || !eglInitialize(egl->display, NULL, NULL)) {
        egl->display = EGL_NO_DISPLAY;
        return device_fail(error, "kms: %s (%s): no EGL: %s", kms->card->path, kms->card->driver, display_egl_reason());
    }
    return true;
}

static bool open_context(struct display *display, struct device_error *error)
{
    struct kms *kms = display->own;
    if (!display_egl_context(&display->egl, display->def.robust, error)) {
        return false;
    }
    if (!display_egl_enter(&display->egl)) {
        return device_fail(error, "kms: the context cannot be made current without a surface: %s",
                           display_egl_reason());
    }
    kms->software = display_egl_software();
    return true;
}

static bool start(struct display *display, struct device_error *error)
{
    struct kms *kms = display->own;
    const struct display_def *def = &display->def;
    struct kms_wish wish = {def->connector, def->width, def->height, def->refresh_mhz};
    kms->card = kms_card_open(def->card, &wish, def->legacy, error);
    if (!kms->card) {
        return false;
    }
    kms->buffers.card = kms->card;
    if (!open_egl(display, error) || !open_context(display, error)) {
        return false;
    }
    kms->watch = kms_watch_create();
    struct device_error why;
    if (!kms_screen_start(&kms->screen, kms->card, &wish, source_now_us(), &why)) {
        return device_fail(error, "kms: %s", why.text);
    }
    settle(display);
    if (kms->screen.refused_due_us != 0 && kms->screen.stage == KMS_EMPTY) {
        return device_fail(error, "kms: %s", kms->screen.reason.text);
    }
    return true;
}

static bool kms_create(struct display *display, struct device_error *error)
{
    display->own = calloc(1, sizeof(struct kms));
    if (!display->own) {
        return device_fail(error, "kms: memory is short");
    }
    display->flipped = true;
    return start(display, error);
}

/* Everything but `own` itself, which may be started again. */
static void stop(struct display *display)
{
    struct kms *kms = display->own;
    if (kms->screen.card) {
        kms_screen_finish(&kms->screen);
    }
    if (display->egl.display != EGL_NO_DISPLAY) {
        drop_buffers(display);
        display_egl_finish(&display->egl);
        eglTerminate(display->egl.display);
        display->egl.display = EGL_NO_DISPLAY;
    }
    if (kms->buffers.gbm) {
        gbm_device_destroy(kms->buffers.gbm);
    }
    kms_watch_destroy(kms->watch);
    kms_card_close(kms->card);
    *kms = (struct kms){.card = NULL};
}

static void kms_destroy(struct display *display)
{
    if (display->own) {
        stop(display);
        free(display->own);
    }
}

static void attend(struct display *display)
{
    struct kms *kms = display->own;
    if (kms->card) {
        kms_screen_attend(&kms->screen, source_now_us(), kms_watch_read(kms->watch));
        settle(display);
    }
}

static int milliseconds_until(uint64_t due_us)
{
    uint64_t now_us = source_now_us();
    return due_us <= now_us ? 0 : (int)((due_us - now_us + 999) / 1000);
}

static void kms_wait(struct display *display, int timeout_ms)
{
    struct kms *kms = display->own;
    if (!kms->card) { /* waits to be renewed */
        static const int NONE[2] = {-1, -1};
        display_poll(display, NONE, timeout_ms < 0 || timeout_ms > LOST_MS ? LOST_MS : timeout_ms);
        return;
    }
    enum display_state before = display->state;
    uint64_t end_us = timeout_ms < 0 ? UINT64_MAX : source_now_us() + (uint64_t)timeout_ms * 1000;
    attend(display);
    while (!kms_screen_free(&kms->screen) && display->state == before && source_now_us() < end_us) {
        uint64_t due_us = kms_screen_due_us(&kms->screen);
        const int own[2] = {kms->card->fd, kms_watch_fd(kms->watch)};
        bool woken = display_poll(display, own, milliseconds_until(due_us < end_us ? due_us : end_us));
        attend(display);
        if (woken) {
            return;
        }
    }
}

static bool kms_begin(struct display *display)
{
    struct kms *kms = display->own;
    if (!kms_screen_free(&kms->screen)) {
        return false;
    }
    kms->drawn = (kms->shown + 1) % KMS_BUFFERS;
    display->framebuffer = kms->buffers.each[kms->drawn].framebuffer;
    glBindFramebuffer(GL_FRAMEBUFFER, display->framebuffer);
    return true;
}

static void kms_end(struct display *display)
{
    struct kms *kms = display->own;
    if (kms->software) {
        glFinish();
    } else {
        glFlush(); /* the kernel flips when the GPU has finished: drivers put a fence on the buffer */
    }
    kms->shown = kms->drawn;
    kms_screen_present(&kms->screen, kms->buffers.each[kms->drawn].id, source_now_us());
    settle(display);
}

static void kms_power(struct display *display, bool on)
{
    struct kms *kms = display->own;
    if (!kms->card) {
        display->state = on ? DISPLAY_LENT : DISPLAY_DARK;
        return;
    }
    kms_screen_power(&kms->screen, on, source_now_us());
    settle(display);
}

/* The card as well, where this opening of it will never be master again. Counts and darkness go on. */
static bool start_again(struct display *display, struct device_error *error)
{
    struct kms *kms = display->own;
    struct display_frames frames = display->frames;
    bool dark = kms->card ? kms->screen.dark : display->state == DISPLAY_DARK;
    stop(display);
    display->state = dark ? DISPLAY_DARK : DISPLAY_LENT;
    display->frames = frames;
    if (!start(display, error)) {
        stop(display);
        return false;
    }
    frames.refresh_mhz = kms->screen.frames.refresh_mhz;
    kms->screen.frames = frames;
    kms_power(display, !dark);
    return true;
}

static bool kms_renew(struct display *display, struct device_error *error)
{
    struct kms *kms = display->own;
    if (!kms->card || kms->screen.stale) {
        return start_again(display, error);
    }
    kms_buffers_unbind(&kms->buffers, &display->egl);
    display->framebuffer = 0;
    display->drawn = false;
    display_egl_finish(&display->egl);
    return open_context(display, error) &&
           (!kms_buffers_made(&kms->buffers) || kms_buffers_bind(&kms->buffers, &display->egl, error));
}

const struct display_source display_kms = {
    .kind = DISPLAY_KMS,
    .create = kms_create,
    .destroy = kms_destroy,
    .wait = kms_wait,
    .begin = kms_begin,
    .end = kms_end,
    .power = kms_power,
    .renew = kms_renew,
};
