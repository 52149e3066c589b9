#include <math.h>

#include "kiosk_state.h"

enum {
    SYNTHETIC_SLOT = 900, /* fingers of dwelling and of the switch: beyond all real slots */
    WAKE_US_A_MINUTE = 60000000,
};

static const float AXIS_MOVES = 0.1f; /* of its way: less is drift */
static const float STROKE = 0.004f;   /* of the sheet: what a drop by another tool than drops is drawn along */

static bool axis_moved(struct kiosk *kiosk, const struct event *event)
{
    struct kiosk_axis *free_one = NULL;
    for (int i = 0; i < KIOSK_AXES; i++) {
        struct kiosk_axis *axis = &kiosk->axes[i];
        if (axis->used && axis->device == event->device && axis->control == event->control &&
            axis->index == event->index) {
            bool moved = fabsf(event->value - axis->value) >= AXIS_MOVES;
            axis->value = moved ? event->value : axis->value;
            return moved;
        }
        free_one = !axis->used && !free_one ? axis : free_one;
    }
    if (free_one) { /* where it is at first is not what somebody did */
        *free_one = (struct kiosk_axis){event->device, event->control, event->index, event->value, true};
    }
    return false;
}

bool kiosk_is_input(struct kiosk *kiosk, const struct event *event)
{
    switch (event->kind) {
    case EVENT_DOWN:
    case EVENT_MOVE:
        return true;
    case EVENT_CONTROL:
        if (event->relative) {
            return fabsf(event->value) > 0;
        }
        if (event->source == SOURCE_GPIO || event->source == SOURCE_KEY) {
            return event->value > 0;
        }
        return axis_moved(kiosk, event);
    default:
        return false;
    }
}

static bool is_finger(const struct event *event)
{
    return event->kind >= EVENT_DOWN && event->kind <= EVENT_CANCEL;
}

/* The room is closed: a touch wakes the screen where the exhibit says so, and does nothing else. */
static bool feel_dark(struct kiosk *kiosk, const struct event *event, uint64_t now_us)
{
    bool begins = event->kind == EVENT_DOWN || (event->kind == EVENT_CONTROL && kiosk_is_input(kiosk, event));
    if (begins && kiosk->exhibit->wake > 0) {
        kiosk->woken_us = now_us + (uint64_t)kiosk->exhibit->wake * WAKE_US_A_MINUTE;
        swallow_begin(&kiosk->swallow);
        visit_feel(&kiosk->visit, VISIT_OPEN, now_us);
    }
    swallow_pass(&kiosk->swallow, event);
    return false;
}

/* In the staff's view fingers reach its two buttons, and nothing else. */
static bool feel_status(struct kiosk *kiosk, const struct event *event, uint64_t now_us)
{
    float x = event->x * (float)kiosk->def.width, y = event->y * (float)kiosk->def.height;
    for (int i = 0; event->kind == EVENT_UP && i < 2; i++) {
        const struct hud_button *button = &kiosk->status_buttons[i];
        if (x >= button->x && x < button->x + button->width && y >= button->y && y < button->y + button->height) {
            kiosk_press(kiosk, &(struct hud_press){0, button->kind, 0, event->time_us}, now_us);
        }
    }
    return false;
}

static int seats_finger(const struct event *event)
{
    return (int)event->source << 16 | event->slot;
}

static void follow_dwelling(struct kiosk *kiosk, const struct event *event, uint64_t now_us)
{
    if (event->kind == EVENT_UP || event->kind == EVENT_CANCEL) {
        access_leave(&kiosk->access, seats_finger(event));
    } else {
        access_point(&kiosk->access, seats_finger(event), event->x, event->y, now_us);
    }
}

bool kiosk_feel(struct kiosk *kiosk, struct event *event, uint64_t now_us)
{
    struct hud_press press;
    bool pressed = false;
    if (kiosk->dark) {
        return feel_dark(kiosk, event, now_us);
    }
    if (!swallow_pass(&kiosk->swallow, event)) {
        return false;
    }
    if (is_finger(event)) {
        staff_feel(&kiosk->staff, event);
    }
    if (kiosk->status && is_finger(event)) {
        return feel_status(kiosk, event, now_us);
    }
    if (kiosk_is_input(kiosk, event)) {
        visit_feel(&kiosk->visit, VISIT_INPUT, now_us);
        kiosk_run(kiosk, now_us, kiosk->time); /* a first touch is for a fresh sheet: that comes before its drop */
    }
    if (!is_finger(event)) {
        return true;
    }
    access_reach(&kiosk->access, event);
    if (hud_feel(&kiosk->hud, event, &press, &pressed)) {
        if (pressed) {
            kiosk_press(kiosk, &press, now_us);
        }
        return false;
    }
    follow_dwelling(kiosk, event, now_us);
    return true;
}

static void post_verb(struct kiosk *kiosk, enum action_verb verb, int visitor, uint64_t time_us)
{
    struct action action = action_default(verb);
    action.visitor = visitor;
    kiosk_post(kiosk, &action, time_us);
}

static void next_language(struct kiosk *kiosk)
{
    const struct exhibit *exhibit = kiosk->exhibit;
    int at = 0;
    for (int i = 0; i < exhibit->language_count; i++) {
        at = exhibit->languages[i] == kiosk->hud.language ? i : at;
    }
    kiosk->hud.language = exhibit->languages[(at + 1) % exhibit->language_count];
    hud_layout(&kiosk->hud);
}

static void choose(struct kiosk *kiosk, int seat, int tool, int ink)
{
    struct hud_panel *panel = &kiosk->hud.panels[seat];
    panel->tool = tool;
    panel->ink = ink;
    if (kiosk->controls) {
        controls_set_tool(kiosk->controls, seat, tool);
        controls_set_ink(kiosk->controls, seat, ink);
    }
}

void kiosk_press(struct kiosk *kiosk, const struct hud_press *press, uint64_t now_us)
{
    struct hud_panel *panel = &kiosk->hud.panels[press->seat];
    switch (press->kind) {
    case HUD_INK:
        choose(kiosk, press->seat, panel->tool, press->value);
        break;
    case HUD_TOOL:
        choose(kiosk, press->seat, press->value, panel->ink);
        break;
    case HUD_UNDO:
        post_verb(kiosk, ACTION_UNDO, press->seat + 1, press->time_us);
        break;
    case HUD_REDO:
        post_verb(kiosk, ACTION_REDO, press->seat + 1, press->time_us);
        break;
    case HUD_FINISH:
        visit_feel(&kiosk->visit, VISIT_FINISH, now_us);
        break;
    case HUD_HAND:
        kiosk->hud.swapped = !kiosk->hud.swapped;
        hud_layout(&kiosk->hud);
        break;
    case HUD_SEATED:
        kiosk->hud.seated = kiosk->access.seated = !kiosk->hud.seated;
        hud_layout(&kiosk->hud);
        break;
    case HUD_LANGUAGE:
        next_language(kiosk);
        break;
    case HUD_EXIT:
        kiosk->leaves = true;
        break;
    case HUD_BACK:
        visit_feel(&kiosk->visit, VISIT_STAFF, now_us);
        break;
    default:
        break;
    }
}

/* The next tool of those that are offered. */
static int next_tool(const struct kiosk *kiosk, int tool)
{
    for (int i = 1; i <= TOOLS; i++) {
        int next = (tool + i) % TOOLS;
        if (next == TOOL_DROP || kiosk->exhibit->palette.tools[next]) {
            return next;
        }
    }
    return tool;
}

static int buttons_of(const struct kiosk *kiosk)
{
    return kiosk->hud.count > 0 ? kiosk->hud.panels[0].count : 0;
}

void kiosk_wish(struct kiosk *kiosk, const struct wish *wish, uint64_t now_us)
{
    int seat = wish->visitor >= 1 && wish->visitor <= kiosk->hud.count ? wish->visitor - 1 : 0;
    if (kiosk->dark && wish->kind != WISH_STAFF) {
        return;
    }
    switch (wish->kind) {
    case WISH_UNDO:
        post_verb(kiosk, ACTION_UNDO, wish->visitor, wish->time_us);
        break;
    case WISH_REDO:
        post_verb(kiosk, ACTION_REDO, wish->visitor, wish->time_us);
        break;
    case WISH_FINISH:
        visit_feel(&kiosk->visit, VISIT_FINISH, now_us);
        break;
    case WISH_STAFF:
        visit_feel(&kiosk->visit, VISIT_STAFF, now_us);
        break;
    case WISH_NEXT_TOOL:
        choose(kiosk, seat, next_tool(kiosk, kiosk->hud.panels[seat].tool), kiosk->hud.panels[seat].ink);
        break;
    case WISH_NEXT_SCENE:
        visit_feel(&kiosk->visit, VISIT_SCENE, now_us);
        break;
    case WISH_NEXT_LANGUAGE:
        next_language(kiosk);
        break;
    case WISH_SWITCH:
        access_switch(&kiosk->access, wish->down, buttons_of(kiosk), now_us);
        break;
    }
}

/* A drop of a point that has rested, or of the switch: as if a finger had come down there. */
static void tap(struct kiosk *kiosk, float x, float y, uint64_t now_us)
{
    struct event event = {
        .kind = EVENT_DOWN, .source = SOURCE_TOUCH, .slot = SYNTHETIC_SLOT, .x = x, .y = y, .time_us = now_us};
    if (!kiosk->controls) {
        return;
    }
    controls_feel(kiosk->controls, &event);
    event.kind = EVENT_MOVE;
    event.x = x + STROKE;
    controls_feel(kiosk->controls, &event);
    event.kind = EVENT_UP;
    controls_feel(kiosk->controls, &event);
}

void kiosk_run_access(struct kiosk *kiosk, uint64_t now_us)
{
    struct access_result result;
    while ((result = access_run(&kiosk->access, now_us)).what != ACCESS_NOTHING) {
        visit_feel(&kiosk->visit, VISIT_INPUT, now_us);
        if (result.what == ACCESS_DROP) {
            tap(kiosk, result.x, result.y, now_us);
        } else if (result.button >= 0 && result.button < buttons_of(kiosk)) {
            const struct hud_button *button = &kiosk->hud.panels[0].buttons[result.button];
            kiosk_press(kiosk, &(struct hud_press){0, button->kind, button->value, now_us}, now_us);
        }
    }
    if (kiosk->hud.count > 0) {
        kiosk->hud.panels[0].scanned = kiosk->access.state == ACCESS_BUTTONS ? kiosk->access.button : -1;
    }
}
