#include <math.h>

#include "hud_map.h"
#include "kiosk_state.h"

enum {
    CURSORS = 16,
    CURSOR_ID = 1 << 24, /* beyond all fingers */
};

static const float AXIS_MOVES = 0.1f; /* of its way: less is drift */

static bool is_axis(const struct kiosk_axis *axis, const struct event *event)
{
    return axis->used && axis->source == event->source && axis->device == event->device;
}

/* Where an axis is at first is not what somebody did; that a button is on is. */
static bool axis_moved(struct kiosk *kiosk, const struct event *event)
{
    struct kiosk_axis *free_one = NULL;
    for (int i = 0; i < KIOSK_AXES; i++) {
        struct kiosk_axis *axis = &kiosk->axes[i];
        if (is_axis(axis, event) && axis->control == event->control && axis->index == event->index) {
            bool moved = fabsf(event->value - axis->value) >= AXIS_MOVES;
            axis->value = moved ? event->value : axis->value;
            return moved;
        }
        free_one = !axis->used && !free_one ? axis : free_one;
    }
    if (free_one) {
        *free_one = (struct kiosk_axis){true, event->source, event->device, event->control, event->index, event->value};
    }
    return !event->centred && event->value >= 1;
}

static void forget_axes(struct kiosk *kiosk, const struct event *left)
{
    for (int i = 0; i < KIOSK_AXES; i++) {
        kiosk->axes[i].used = kiosk->axes[i].used && !is_axis(&kiosk->axes[i], left);
    }
}

/* Whether an event is something that somebody did. */
static bool is_input(struct kiosk *kiosk, const struct event *event)
{
    switch (event->kind) {
    case EVENT_DOWN:
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

/* What ends something, or tells who is there, and so is heard in the dark as well. */
static bool is_end(const struct event *event)
{
    bool up = event->kind == EVENT_UP || event->kind == EVENT_CANCEL || event->kind == EVENT_LEFT;
    return up || event->kind == EVENT_STANDING ||
           (event->kind == EVENT_CONTROL && !event->relative && !(fabsf(event->value) > 0));
}

/* The room is closed: a touch wakes the screen where the exhibit says so, and does nothing else. */
static void feel_dark(struct kiosk *kiosk, const struct event *event, uint64_t now_us)
{
    bool begins = event->kind == EVENT_DOWN || (event->kind == EVENT_CONTROL && is_input(kiosk, event));
    if (begins && kiosk->exhibit->wake > 0) {
        swallow_begin(&kiosk->swallow);
        visit_feel(&kiosk->visit, VISIT_INPUT, now_us);
    }
    swallow_pass(&kiosk->swallow, event);
}

static int finger_id(const struct event *event)
{
    return (int)event->source << 16 | event->slot;
}

/* Which seats have a hand on the sheet. */
static void follow_hand(struct kiosk *kiosk, const struct event *event)
{
    struct kiosk_hand *hand = NULL;
    bool comes = event->kind == EVENT_DOWN;
    for (int i = 0; i < KIOSK_HANDS; i++) {
        struct kiosk_hand *other = &kiosk->hands[i];
        if (other->used && other->id == finger_id(event)) {
            hand = other;
            break;
        }
        hand = comes && !hand && !other->used ? other : hand;
    }
    if (hand && comes) {
        *hand = (struct kiosk_hand){true, finger_id(event), hud_seat(&kiosk->hud, event->x, event->y)};
    } else if (hand && event->kind != EVENT_MOVE) {
        hand->used = false;
    }
}

void kiosk_busy(struct kiosk *kiosk, uint64_t now_us)
{
    bool busy[EXHIBIT_SEATS] = {false};
    for (int i = 0; i < KIOSK_HANDS; i++) {
        busy[kiosk->hands[i].seat] = busy[kiosk->hands[i].seat] || kiosk->hands[i].used;
    }
    for (int i = 0; i < kiosk->hud.count; i++) {
        hud_busy(&kiosk->hud, i, busy[i], now_us);
    }
}

static void follow_dwelling(struct kiosk *kiosk, const struct event *event, uint64_t now_us)
{
    if (event->kind == EVENT_UP || event->kind == EVENT_CANCEL) {
        access_leave(&kiosk->access, finger_id(event));
    } else {
        access_point(&kiosk->access, finger_id(event), event->x, event->y, now_us);
    }
}

/* What nobody shall act on still ends what was begun before: no hand stays that has gone. Whether the controls hear it.
 */
static bool let_go(struct kiosk *kiosk, const struct event *event)
{
    struct hud_press press;
    bool pressed;
    if (is_finger(event) && is_end(event)) {
        hud_feel(&kiosk->hud, event, &press, &pressed);
        follow_hand(kiosk, event);
        access_leave(&kiosk->access, finger_id(event));
    }
    return is_end(event);
}

void kiosk_let_all_go(struct kiosk *kiosk)
{
    struct event event = {.kind = EVENT_CANCEL};
    for (int i = 0; i < HUD_FINGERS; i++) {
        const struct hud_finger *finger = &kiosk->hud.fingers[i];
        event.source = finger->source;
        event.slot = finger->slot;
        if (finger->used) {
            let_go(kiosk, &event);
        }
    }
    for (int i = 0; i < KIOSK_HANDS; i++) {
        event.source = (enum event_source)(kiosk->hands[i].id >> 16);
        event.slot = kiosk->hands[i].id & 0xffff;
        if (kiosk->hands[i].used) {
            let_go(kiosk, &event);
        }
    }
}

static void post_verb(struct kiosk *kiosk, enum action_verb verb, int visitor, uint64_t time_us)
{
    struct action action = action_default(verb);
    action.visitor = visitor;
    if (visit_paints(&kiosk->visit)) {
        kiosk_post(kiosk, &action, time_us);
    }
}

static void press_piece(struct kiosk *kiosk, const struct hud_press *press, uint64_t now_us)
{
    switch (press->kind) {
    case HUD_INK:
    case HUD_TOOL:
        kiosk_choose(kiosk, press->seat);
        break;
    case HUD_UNDO:
        post_verb(kiosk, ACTION_UNDO, press->seat + 1, press->time_us);
        break;
    case HUD_REDO:
        post_verb(kiosk, ACTION_REDO, press->seat + 1, press->time_us);
        break;
    case HUD_PICTURE:
        kiosk_next_picture(kiosk);
        break;
    case HUD_METAPHOR:
        kiosk_next_kind(kiosk, now_us);
        break;
    case HUD_FINISH:
        visit_feel(&kiosk->visit, VISIT_FINISH, now_us);
        break;
    case HUD_SEATED:
        kiosk->access.seated = kiosk->hud.seated;
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

bool kiosk_feel(struct kiosk *kiosk, struct event *event, uint64_t now_us)
{
    struct hud_press press;
    bool pressed = false;
    if (event->kind == EVENT_LEFT) {
        forget_axes(kiosk, event);
    }
    if (is_finger(event)) {
        staff_feel(&kiosk->staff, event);
    }
    if (kiosk->dark) {
        feel_dark(kiosk, event, now_us);
        return let_go(kiosk, event);
    }
    if (!swallow_pass(&kiosk->swallow, event)) {
        return let_go(kiosk, event);
    }
    bool palette = is_finger(event) && hud_feel(&kiosk->hud, event, &press, &pressed);
    if (is_input(kiosk, event)) {
        visit_feel(&kiosk->visit, VISIT_INPUT, now_us);
        kiosk_obey(kiosk, now_us); /* a first touch is for a fresh sheet: that comes before its drop */
    } else if (is_finger(event)) {
        visit_feel(&kiosk->visit, VISIT_HOLD, now_us);
    }
    if (!is_finger(event)) {
        return true;
    }
    if (pressed) {
        press_piece(kiosk, &press, now_us);
    }
    if (palette) {
        return false;
    }
    access_reach(&kiosk->access, event);
    follow_hand(kiosk, event);
    follow_dwelling(kiosk, event, now_us);
    return true;
}

bool kiosk_act(struct kiosk *kiosk, const struct action *action, uint64_t event_us, uint64_t now_us)
{
    if (!scene_takes(kiosk_kind(kiosk), action->verb)) {
        return true;
    }
    kiosk_leave_touched(kiosk, now_us);
    visit_feel(&kiosk->visit, VISIT_PAINT, now_us);
    kiosk_obey(kiosk, now_us);
    if (!visit_paints(&kiosk->visit)) {
        return true;
    }
    kiosk_take_option(kiosk, action, now_us);
    return kiosk_post(kiosk, action, event_us);
}

/* What is chosen on a palette, for the controls. */
void kiosk_choose(struct kiosk *kiosk, int seat)
{
    const struct hud_panel *panel = &kiosk->hud.panels[seat];
    if (kiosk->controls) {
        controls_set_tool(kiosk->controls, seat, (enum exhibit_tool)panel->tool);
        controls_set_ink(kiosk->controls, seat, panel->any_ink ? -1 : panel->ink);
    }
}

/* The next tool of those that are offered in this scene. */
static int next_tool(const struct kiosk *kiosk, int tool)
{
    for (int i = 1; i <= TOOLS; i++) {
        int next = (tool + i) % TOOLS;
        if (tool_fits(next, kiosk_scene(kiosk)->kind) && kiosk->exhibit->palette.tools[next]) {
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
    if (wish->kind != WISH_STAFF) {
        visit_feel(&kiosk->visit, VISIT_INPUT, now_us);
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
        hud_choose(&kiosk->hud, seat, next_tool(kiosk, kiosk->hud.panels[seat].tool), -1);
        kiosk_choose(kiosk, seat);
        break;
    case WISH_NEXT_SCENE:
        kiosk_ask_scene(kiosk, now_us);
        break;
    case WISH_NEXT_LANGUAGE:
        kiosk->hud.language = hud_next_language(&kiosk->hud);
        hud_layout(&kiosk->hud);
        break;
    case WISH_NEXT_PICTURE:
        kiosk_next_picture(kiosk);
        break;
    case WISH_NEXT_METAPHOR:
        if (kiosk_has_trees(kiosk)) {
            kiosk_next_kind(kiosk, now_us);
        }
        break;
    case WISH_NEXT_KIND:
        kiosk_next_kind(kiosk, now_us);
        break;
    case WISH_SWITCH:
        access_switch(&kiosk->access, wish->down, buttons_of(kiosk), wish->time_us);
        break;
    case WISHES:
        break;
    }
}

/* A drop of a point that has rested, or of the switch. */
static void tap(struct kiosk *kiosk, const struct access_result *result)
{
    if (hud_map_tap(&kiosk->hud, result->x, result->y, result->time_us)) {
        return;
    }
    int visitor = result->id >= CURSOR_ID ? result->id - CURSOR_ID : 0;
    if (kiosk->controls) {
        controls_tap(kiosk->controls, visitor, (struct point){result->x, result->y}, result->time_us);
    }
}

/* Points of controllers may dwell as well. */
static void follow_cursors(struct kiosk *kiosk, uint64_t now_us)
{
    struct controls_cursor cursors[CURSORS];
    int count = kiosk->controls ? controls_cursors(kiosk->controls, now_us, cursors, CURSORS) : 0;
    for (int i = 0; i < count && i < CURSORS; i++) {
        int id = CURSOR_ID + cursors[i].visitor;
        if (cursors[i].used) {
            access_point(&kiosk->access, id, cursors[i].at.x, cursors[i].at.y, now_us);
        } else {
            access_leave(&kiosk->access, id);
        }
    }
}

void kiosk_run_access(struct kiosk *kiosk, uint64_t now_us)
{
    struct access_result result;
    follow_cursors(kiosk, now_us);
    while ((result = access_run(&kiosk->access, now_us)).what != ACCESS_NOTHING) {
        visit_feel(&kiosk->visit, VISIT_INPUT, now_us);
        if (result.what == ACCESS_DROP) {
            tap(kiosk, &result);
        } else if (result.button >= 0 && result.button < buttons_of(kiosk)) {
            struct hud_press press;
            if (hud_press(&kiosk->hud, 0, result.button, now_us, &press)) {
                press_piece(kiosk, &press, now_us);
            }
        }
    }
    if (kiosk->hud.count > 0) {
        kiosk->hud.panels[0].scanned = kiosk->access.state == ACCESS_BUTTONS ? kiosk->access.button : -1;
    }
}
