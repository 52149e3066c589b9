#include "soak_guest.h"

#include <string.h>

#include "kiosk_state.h"
#include "patience.h"

static const double STEP_S = 0.010, BEHIND_S = 0.2, LOOK_S = 0.1, REST_S = 0.12, LONG_REST_S = 4.5;

static float place(struct soak *soak)
{
    return 0.05f + 0.9f * (float)soak_random(soak, 1000) / 1000;
}

static void finger(struct guest *guest, struct soak *soak, enum event_kind kind, int slot)
{
    struct event event = {.kind = kind, .slot = slot, .x = guest->x[slot], .y = guest->y[slot]};
    soak_post(soak, SOAK_TOUCH, guest->device, &event);
}

static void press(struct soak *soak, enum soak_source source, int device, uint32_t control, float value)
{
    struct event event = {.kind = EVENT_CONTROL, .control = control, .value = value};
    soak_post(soak, source, device, &event);
}

static void tap_line(struct soak *soak, enum soak_line line)
{
    press(soak, SOAK_LINES, 0, (uint32_t)line, 1);
    press(soak, SOAK_LINES, 0, (uint32_t)line, 0);
}

/* The middle of a button of the palette; any but the one to finish, or that one. */
static bool find_button(struct guest *guest, struct soak *soak, bool finish)
{
    const struct hud *hud = &soak->live.kiosk.kiosk->hud;
    const struct hud_panel *panel = &hud->panels[soak_random(soak, (uint32_t)hud->count)];
    if (panel->count == 0 || hud->status || !hud->shown) {
        return false;
    }
    uint32_t any = soak_random(soak, (uint32_t)panel->count);
    for (int i = 0; i < panel->count; i++) {
        const struct hud_button *button = &panel->buttons[i];
        bool is = finish ? button->kind == HUD_FINISH : (uint32_t)i == any && button->kind != HUD_FINISH;
        if (is) {
            guest->x[0] = (button->x + 0.5f * button->width) / SOAK_WIDTH;
            guest->y[0] = (button->y + 0.5f * button->height) / SOAK_HEIGHT;
            return true;
        }
    }
    return false;
}

static void touch_button(struct guest *guest, struct soak *soak, bool finish)
{
    if (find_button(guest, soak, finish)) {
        finger(guest, soak, EVENT_DOWN, 0);
        guest->button = true;
    }
}

static void come(struct guest *guest, struct soak *soak)
{
    guest->state = GUEST_PAINTS;
    guest->strokes = 1 + (int)soak_random(soak, 3);
    guest->device = (int)soak_random(soak, 8) == 0;
    if (soak_random(soak, 40) == 0) {
        tap_line(soak, LINE_STAFF);
        guest->staff = true;
    }
}

static void begin_stroke(struct guest *guest, struct soak *soak)
{
    guest->fingers = soak_random(soak, 4) == 0 ? 1 + (int)soak_random(soak, SOAK_FINGERS) : 1;
    guest->moves = 1 + (int)soak_random(soak, 6);
    for (int i = 0; i < guest->fingers; i++) {
        guest->x[i] = place(soak);
        guest->y[i] = place(soak);
        finger(guest, soak, EVENT_DOWN, i);
    }
    guest->strokes--;
}

static void go_on_with_stroke(struct guest *guest, struct soak *soak)
{
    guest->moves--;
    for (int i = 0; i < guest->fingers; i++) {
        guest->x[i] += 0.02f * (float)((int)soak_random(soak, 5) - 2);
        guest->y[i] += 0.02f * (float)((int)soak_random(soak, 5) - 2);
        finger(guest, soak, guest->moves > 0 ? EVENT_MOVE : EVENT_UP, i);
    }
}

static void leave(struct guest *guest, struct soak *soak)
{
    uint32_t how = soak_random(soak, 20);
    guest->state = GUEST_LEAVES;
    guest->since_s = soak_s(soak);
    if (how < 13) {
        touch_button(guest, soak, true);
        guest->finished++;
    } else if (how < 15) {
        tap_line(soak, LINE_FINISH);
        guest->finished++;
    } else {
        guest->teases = how == 19;
        guest->walked++;
    }
}

static void paint(struct guest *guest, struct soak *soak)
{
    uint32_t what = soak_random(soak, 12);
    if (guest->staff) {
        tap_line(soak, LINE_STAFF);
        guest->staff = false;
    } else if (guest->moves > 0) {
        go_on_with_stroke(guest, soak);
    } else if (guest->strokes == 0 && guest->looks_s <= 0) {
        guest->looks_s = LOOK_S; /* while the palette comes back */
        guest->act_s += guest->looks_s;
    } else if (guest->strokes == 0) {
        guest->looks_s = 0;
        leave(guest, soak);
    } else if (what == 0) {
        touch_button(guest, soak, false);
    } else if (what == 1) {
        uint32_t control = 9u << 16 | (1 + soak_random(soak, 3));
        int pad = (int)soak_random(soak, 2);
        press(soak, SOAK_PAD, pad, control, 1);
        press(soak, SOAK_PAD, pad, control, 0);
    } else if (what == 2) {
        press(soak, SOAK_LINES, 0, LINE_SWITCH, 1);
        guest->holds = true;
        guest->switched++;
    } else {
        begin_stroke(guest, soak);
    }
}

static void wait(struct guest *guest, struct soak *soak)
{
    const char *state = kiosk_state(soak->live.kiosk.kiosk);
    double now = soak_s(soak), waited = now - guest->since_s;
    if (guest->teases && strcmp(state, "countdown") == 0) {
        guest->x[0] = guest->y[0] = 0.5f;
        finger(guest, soak, EVENT_DOWN, 0);
        finger(guest, soak, EVENT_UP, 0);
        guest->teases = false;
        guest->teased++;
        guest->since_s = now;
        return;
    }
    bool gone = strcmp(state, "attract") == 0 || strcmp(state, "closed") == 0;
    bool meets = strcmp(state, "washing") == 0 && soak_random(soak, 3) == 0; /* the next one is already there */
    if (waited > PATIENCE_S) {
        soak_fail(soak, "%.0f s after a visitor has gone the visit is stuck in %s", waited, state);
        gone = true;
    }
    if (gone || meets) {
        guest->longest_s = waited > guest->longest_s ? waited : guest->longest_s;
        guest->state = GUEST_AWAY;
        guest->act_s = now + (soak_random(soak, 40) == 0 ? LONG_REST_S : REST_S * soak_random(soak, 100) / 100);
    }
}

static void act(struct guest *guest, struct soak *soak)
{
    if (guest->button) {
        finger(guest, soak, EVENT_UP, 0);
        guest->button = false;
    } else if (guest->holds) {
        press(soak, SOAK_LINES, 0, LINE_SWITCH, 0);
        guest->holds = false;
    } else if (guest->state == GUEST_PAINTS) {
        paint(guest, soak);
    } else if (guest->state == GUEST_LEAVES) {
        wait(guest, soak);
    } else if (!guest->retired) {
        come(guest, soak);
    }
}

/* As devices do it: a hundred times a second, however long a turn of the loop takes, each with its time. */
void guest_turn(struct guest *guest, struct soak *soak)
{
    double now = soak_s(soak), due;
    if (guest->act_s < now - BEHIND_S) {
        guest->act_s = now - BEHIND_S;
    }
    while ((due = guest->act_s) <= now) {
        bool waits = guest->state == GUEST_LEAVES && !guest->button;
        guest->act_s = due + STEP_S;
        soak->event_us = soak->began_us + (uint64_t)(1e6 * due);
        act(guest, soak);
        if (waits) { /* it can only see what there is now */
            break;
        }
    }
    soak->event_us = 0;
}
