#include "kms_screen.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "display_source.h"

static bool is_denied(int code)
{
    return code == EACCES || code == EPERM;
}

static bool is_busy(int code)
{
    return code == EBUSY || code == EAGAIN || code == EINTR;
}

/* FNV-1a, a word at a time. */
static uint64_t hash_more(uint64_t hash, uint64_t word)
{
    return (hash ^ word) * UINT64_C(1099511628211);
}

static uint64_t hash_mode(uint64_t hash, const drmModeModeInfo *mode)
{
    const uint32_t words[] = {mode->clock,  mode->hdisplay, mode->hsync_start, mode->hsync_end,
                              mode->htotal, mode->vdisplay, mode->vsync_start, mode->vsync_end,
                              mode->vtotal, mode->vscan,    mode->flags,       mode->type};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_more(hash, words[i]);
    }
    return hash;
}

/* Of what wants another choice when it changes. */
static uint64_t signature_of(const struct kms_scan *scan)
{
    uint64_t hash = UINT64_C(14695981039346656037);
    for (int i = 0; i < scan->connector_count; i++) {
        const struct kms_connector *connector = &scan->connectors[i];
        hash = hash_more(hash, connector->id);
        hash = hash_more(hash, (uint64_t)connector->connected << 1 | connector->broken);
        for (int mode = 0; mode < connector->mode_count; mode++) {
            hash = hash_mode(hash, &connector->modes[mode]);
        }
    }
    return hash;
}

static void become_lent(struct kms_screen *screen, uint64_t now_us)
{
    screen->lent = true;
    screen->master_due_us = now_us + KMS_MASTER_US;
    screen->pending = screen->to_darken = false;
    screen->next = 0;
    screen->token++;
    if (screen->to_switch_off) { /* what the output shows now is the other's affair */
        screen->to_switch_off = false;
        kms_output_close(&screen->output, screen->card);
    }
    if (screen->stage == KMS_RUNNING) {
        screen->stage = KMS_FITTED;
    }
}

static void leave(struct kms_screen *screen, uint64_t now_us)
{
    screen->pending = screen->to_darken = false;
    screen->next = 0;
    screen->token++;
    screen->frames.refresh_mhz = 0;
    if (screen->stage == KMS_RUNNING) {
        screen->to_switch_off = true;
        screen->busy_due_us = now_us;
        screen->off_until_us = now_us + KMS_FLIP_US;
    } else if (screen->stage != KMS_EMPTY) {
        kms_output_close(&screen->output, screen->card);
    }
    screen->stage = KMS_EMPTY;
}

static void say_why_no_mode(struct kms_screen *screen, const struct kms_connector *connector)
{
    char wish[KMS_MODE_TEXT] = "of any size", have[KMS_MODE_TEXT] = "none";
    if (screen->wish.width || screen->wish.height) {
        snprintf(wish, sizeof wish, "%dx%d", screen->wish.width, screen->wish.height);
    }
    if (connector->mode_count > 0) {
        kms_mode_text(&connector->modes[0], have);
    }
    char at[KMS_MODE_TEXT] = "";
    if (screen->wish.refresh_mhz) {
        snprintf(at, sizeof at, " at %g Hz", screen->wish.refresh_mhz / 1000.);
    }
    device_fail(&screen->reason, "%s has no mode %s%s; it has %s and %d more", connector->name, wish, at, have,
                connector->mode_count > 0 ? connector->mode_count - 1 : 0);
}

static bool is_refused(const struct kms_screen *screen, const struct kms_connector *connector)
{
    return screen->refused_of == connector->id && screen->refused_due_us != 0;
}

static void choose(struct kms_screen *screen, uint64_t now_us)
{
    struct kms_scan *scan = screen->scan;
    bool has = screen->stage != KMS_EMPTY;
    int index = kms_choose_connector(scan, &screen->wish, screen->connector);
    if (index < 0) {
        leave(screen, now_us);
        device_fail(&screen->reason, "%s is plugged in",
                    screen->wish.connector ? "nothing that was asked for" : "nothing");
        return;
    }
    const struct kms_connector *connector = &scan->connectors[index];
    bool tried = is_refused(screen, connector);
    int mode = kms_choose_mode(connector, &screen->wish, tried ? screen->refused : NULL);
    if (mode < 0) {
        leave(screen, now_us);
        if (!tried) {
            say_why_no_mode(screen, connector);
        }
        return;
    }
    if (has && screen->output.connector == connector->id &&
        kms_mode_same(&screen->output.mode, &connector->modes[mode])) {
        screen->chosen = mode;
        if (connector->broken && screen->stage == KMS_RUNNING) {
            screen->stage = KMS_FITTED;
        }
        return;
    }
    leave(screen, now_us);
    if (screen->to_switch_off) {
        return; /* chosen again when that is done */
    }
    uint32_t crtc = kms_choose_crtc(scan, connector);
    if (crtc == 0) {
        device_fail(&screen->reason, "%s: no CRTC can feed it", connector->name);
    } else if (kms_output_open(&screen->output, screen->card, scan, connector, crtc, &connector->modes[mode],
                               &screen->reason)) {
        screen->stage = KMS_CHOSEN;
        screen->chosen = mode;
        screen->connector = connector->id;
        screen->frames.refresh_mhz = kms_mode_refresh_mhz(&connector->modes[mode]);
    } else {
        kms_output_close(&screen->output, screen->card);
    }
}

/* Looks at the connectors; `probe`: at the wires too. */
static void look(struct kms_screen *screen, uint64_t now_us, bool probe)
{
    screen->scan_due_us = now_us + KMS_SCAN_US;
    int code = screen->card->calls->scan(screen->card, probe, screen->scan);
    bool changed = code == 0 && signature_of(screen->scan) != screen->signature;
    if (changed && !probe) {
        code = screen->card->calls->scan(screen->card, true, screen->scan);
    }
    if (code != 0) {
        leave(screen, now_us);
        device_fail(&screen->reason, "%s: its connectors cannot be read: %s", screen->card->path, strerror(code));
        return;
    }
    screen->signature = signature_of(screen->scan);
    bool again = screen->refused_due_us != 0 && now_us >= screen->refused_due_us;
    if (changed || again) {
        screen->refused_due_us = 0;
        memset(screen->refused, 0, sizeof screen->refused);
    }
    if (changed || probe || again || screen->stage == KMS_EMPTY) {
        if (!screen->to_switch_off) {
            choose(screen, now_us);
        }
    }
}

static void refuse(struct kms_screen *screen, uint64_t now_us)
{
    if (screen->refused_of != screen->output.connector || screen->refused_due_us == 0) {
        memset(screen->refused, 0, sizeof screen->refused);
    }
    screen->refused_of = screen->output.connector;
    screen->refused[screen->chosen] = true;
    screen->refused_due_us = now_us + KMS_REFUSED_US;
    leave(screen, now_us);
    if (!screen->to_switch_off) {
        choose(screen, now_us);
    }
}

bool kms_screen_fit(struct kms_screen *screen, uint32_t framebuffer, bool last, uint64_t now_us)
{
    int code = kms_output_test(&screen->output, screen->card, framebuffer);
    if (is_denied(code)) {
        become_lent(screen, now_us);
        return true;
    }
    if (code == 0) {
        screen->stage = KMS_FITTED;
        return true;
    }
    kms_output_explain(&screen->output, screen->card, framebuffer, code, &screen->reason);
    if (last) {
        refuse(screen, now_us);
    }
    return false;
}

void kms_screen_unfit(struct kms_screen *screen, const struct device_error *reason, uint64_t now_us)
{
    screen->reason = *reason;
    refuse(screen, now_us);
}

static void read_past(struct kms_screen *screen)
{
    if (screen->past_crtc == 0 &&
        screen->card->calls->read_crtc(screen->card, screen->output.crtc, &screen->past) == 0) {
        screen->past_crtc = screen->output.crtc;
    }
}

static void submit(struct kms_screen *screen, uint32_t framebuffer, uint64_t now_us)
{
    bool sets = screen->stage == KMS_FITTED, flips = true;
    if (sets) {
        read_past(screen);
        display_pace_stop(&screen->pace);
    }
    screen->next = 0;
    screen->token = (uint32_t)(screen->token + 1); /* so that 32 bits bring it back whole */
    int code = sets ? kms_output_set(&screen->output, screen->card, framebuffer, screen->token, &flips)
                    : kms_output_flip(&screen->output, screen->card, framebuffer, screen->token);
    if (code == 0) {
        screen->stage = KMS_RUNNING;
        screen->pending = flips;
        screen->flip_us = now_us;
        if (!flips) {
            screen->frames.presented++;
            screen->frames.last_us = now_us;
        }
    } else if (is_busy(code)) {
        screen->next = framebuffer;
        screen->busy_due_us = now_us + KMS_BUSY_US;
    } else if (is_denied(code)) {
        become_lent(screen, now_us);
    } else if (sets) {
        kms_output_explain(&screen->output, screen->card, framebuffer, code, &screen->reason);
        refuse(screen, now_us);
    } else {
        screen->stage = KMS_FITTED; /* the mode may have been lost: set it with the next frame */
    }
}

static void read_flips(struct kms_screen *screen)
{
    struct kms_flip flips[KMS_FLIPS];
    int count = 0;
    if (screen->card->calls->flips(screen->card, flips, &count) != 0) {
        return;
    }
    for (int i = 0; i < count; i++) {
        if (!screen->pending || flips[i].token != screen->token) {
            continue; /* of a mode that is no more */
        }
        screen->pending = false;
        screen->frames.presented++;
        screen->frames.last_us = flips[i].time_us;
        screen->frames.missed +=
            display_pace_missed(&screen->pace, flips[i].sequence, flips[i].time_us, screen->frames.refresh_mhz);
    }
}

static void try_master(struct kms_screen *screen, uint64_t now_us)
{
    screen->master_due_us = now_us + KMS_MASTER_US;
    int code = screen->card->calls->take_master(screen->card);
    screen->stale = code == ESTALE;
    if (code == 0) {
        screen->lent = false;
        look(screen, now_us, true);
    }
}

static void switch_off(struct kms_screen *screen, uint64_t now_us)
{
    int code = kms_output_off(&screen->output, screen->card, false);
    if (is_busy(code) && now_us < screen->off_until_us) {
        screen->busy_due_us = now_us + KMS_BUSY_US;
        return;
    }
    if (is_denied(code)) {
        become_lent(screen, now_us);
        return;
    }
    screen->to_switch_off = false;
    kms_output_close(&screen->output, screen->card);
    choose(screen, now_us);
}

static void darken(struct kms_screen *screen, uint64_t now_us)
{
    int code = kms_output_dark(&screen->output, screen->card);
    if (is_busy(code)) {
        screen->busy_due_us = now_us + KMS_BUSY_US;
    } else if (is_denied(code)) {
        become_lent(screen, now_us);
    } else {
        screen->to_darken = false;
    }
}

void kms_screen_attend(struct kms_screen *screen, uint64_t now_us, bool hot)
{
    read_flips(screen);
    if (screen->pending && now_us >= screen->flip_us + KMS_FLIP_US) {
        screen->pending = false;
        screen->stage = KMS_FITTED;
    }
    if (hot || now_us >= screen->scan_due_us) {
        look(screen, now_us, hot);
    }
    if (screen->lent && now_us >= screen->master_due_us) {
        try_master(screen, now_us);
    }
    if (now_us < screen->busy_due_us || screen->lent) {
        return;
    }
    if (screen->to_switch_off) {
        switch_off(screen, now_us);
    } else if (screen->to_darken) {
        darken(screen, now_us);
    } else if (screen->next) {
        submit(screen, screen->next, now_us);
    }
}

static uint64_t earlier(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

uint64_t kms_screen_due_us(const struct kms_screen *screen)
{
    uint64_t due = screen->scan_due_us;
    if (screen->lent) {
        return earlier(due, screen->master_due_us);
    }
    if (screen->to_switch_off || screen->to_darken || screen->next) {
        due = earlier(due, screen->busy_due_us);
    }
    if (screen->pending) {
        due = earlier(due, screen->flip_us + KMS_FLIP_US);
    }
    return due;
}

enum display_state kms_screen_state(const struct kms_screen *screen)
{
    if (screen->dark) { /* on purpose: a monitor that unplugs itself in its sleep is no fault */
        return DISPLAY_DARK;
    }
    if (screen->lent) {
        return DISPLAY_LENT;
    }
    return screen->stage == KMS_FITTED || screen->stage == KMS_RUNNING ? DISPLAY_SHOWN : DISPLAY_ABSENT;
}

bool kms_screen_reads(const struct kms_screen *screen)
{
    return screen->to_switch_off || screen->stage == KMS_RUNNING;
}

bool kms_screen_free(const struct kms_screen *screen)
{
    return kms_screen_state(screen) == DISPLAY_SHOWN && !screen->pending && !screen->next;
}

void kms_screen_present(struct kms_screen *screen, uint32_t framebuffer, uint64_t now_us)
{
    if (kms_screen_free(screen)) {
        submit(screen, framebuffer, now_us);
    }
}

void kms_screen_power(struct kms_screen *screen, bool on, uint64_t now_us)
{
    if (screen->dark == !on) {
        return;
    }
    screen->dark = !on;
    screen->to_darken = !on && screen->stage == KMS_RUNNING;
    screen->next = 0;
    if (screen->to_darken) {
        screen->busy_due_us = now_us;
        screen->pending = false;
        screen->token++;
    } else if (on && screen->stage == KMS_RUNNING) {
        screen->stage = KMS_FITTED;
    }
    kms_screen_attend(screen, now_us, false);
}

bool kms_screen_start(struct kms_screen *screen, struct kms_card *card, const struct kms_wish *wish, uint64_t now_us,
                      struct device_error *error)
{
    *screen = (struct kms_screen){.card = card, .wish = *wish, .stage = KMS_EMPTY};
    screen->scan = calloc(1, sizeof *screen->scan);
    if (!screen->scan) {
        return device_fail(error, "memory is short");
    }
    if (card->calls->take_master(card) != 0) {
        become_lent(screen, now_us);
    }
    look(screen, now_us, true);
    if (kms_card_score(screen->scan, wish) == 0) {
        char names[KMS_CONNECTORS * KMS_NAME];
        kms_connector_names(screen->scan, names, sizeof names);
        return device_fail(error, "%s has no connector %s, but %.120s", card->path,
                           wish->connector ? wish->connector : "for a screen", names);
    }
    int index = kms_choose_connector(screen->scan, wish, 0);
    if (index >= 0 && kms_choose_mode(&screen->scan->connectors[index], wish, NULL) < 0) {
        *error = screen->reason;
        return false;
    }
    return true;
}

void kms_screen_finish(struct kms_screen *screen)
{
    struct kms_card *card = screen->card;
    bool mine = !screen->lent && (screen->stage == KMS_RUNNING || screen->to_switch_off ||
                                  (screen->stage == KMS_FITTED && screen->past_crtc != 0));
    bool restored = false;
    if (mine && screen->past_crtc == screen->output.crtc && screen->past.mode_valid && screen->past.framebuffer) {
        restored = card->calls->set_crtc(card, screen->output.crtc, screen->past.framebuffer, screen->past.x,
                                         screen->past.y, screen->output.connector, &screen->past.mode) == 0;
    }
    if (mine && !restored) {
        kms_output_off(&screen->output, card, true);
    }
    if (screen->output.connector) {
        kms_output_close(&screen->output, card);
    }
    free(screen->scan);
    screen->scan = NULL;
}
