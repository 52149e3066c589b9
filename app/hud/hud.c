#include "hud.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "hud_layout.h"
#include "hud_map.h"
#include "hud_told.h"

static const float FADE = 0.5f; /* s from nothing to all */
static const float CALM = 0.6f; /* s that hands have been away until the palette comes back */
static const float HIDE = 1;    /* s that they are busy at least until it goes: with CALM and FADE this bounds the rate
                                   at which anything changes, far below three flashes a second */
static const float REST = 4;    /* s that it has not been touched until it is as at rest */
static const float FELT = 0.3f; /* how visible it must be to take a finger */
enum { NO_BUTTON = -1, NO_PANEL = -1 };

static float seconds(uint64_t from_us, uint64_t to_us)
{
    return to_us > from_us ? (float)(to_us - from_us) * 1e-6f : 0;
}

static float clamp(float value)
{
    return fminf(fmaxf(value, 0), 1);
}

static bool takes_any(const struct hud *hud, int panel)
{
    const struct exhibit *exhibit = hud->def.exhibit;
    return exhibit->seats[panel].ink < 0 && (!exhibit->inputs || exhibit->inputs->visitors == VISITORS_EACH);
}

/* What is chosen must still be offered. */
static void check_panel(struct hud *hud, int panel)
{
    const struct exhibit *exhibit = hud->def.exhibit;
    struct hud_panel *of = &hud->panels[panel];
    int inks = hud_inks(hud), seat = exhibit->seats[panel].ink;
    of->ink = seat >= 0 ? seat : of->ink;
    of->ink = of->ink >= 0 && of->ink < inks ? of->ink : 0;
    int kind = hud_kind_of_scene(hud);
    of->tool = tool_fits(of->tool, kind) && exhibit->palette.tools[of->tool] ? of->tool : (int)tool_first(kind);
}

static void check_language(struct hud *hud)
{
    const struct exhibit *exhibit = hud->def.exhibit;
    for (int i = 0; i < exhibit->language_count; i++) {
        if (exhibit->languages[i] == hud->language) {
            return;
        }
    }
    hud->language = exhibit->language_count > 0 ? exhibit->languages[0] : 0;
}

int hud_next_language(const struct hud *hud)
{
    const struct exhibit *exhibit = hud->def.exhibit;
    for (int i = 0; i < exhibit->language_count; i++) {
        if (exhibit->languages[i] == hud->language) {
            return exhibit->languages[(i + 1) % exhibit->language_count];
        }
    }
    return hud->language;
}

/* A panel that has changed under them: fingers that are down there press nothing any more. */
static void lay(struct hud *hud, int panel)
{
    hud_layout_panel(hud, panel);
    for (int i = 0; i < HUD_FINGERS; i++) {
        if (hud->fingers[i].used && hud->fingers[i].panel == panel) {
            hud->fingers[i].button = NO_BUTTON;
        }
    }
}

void hud_init(struct hud *hud, const struct hud_def *def)
{
    *hud = (struct hud){.def = *def};
    hud->language = def->exhibit->language_count > 0 ? def->exhibit->languages[0] : 0;
    hud_layout(hud);
}

void hud_layout(struct hud *hud)
{
    const struct exhibit *exhibit = hud->def.exhibit;
    int count = exhibit->seat_count < EXHIBIT_SEATS ? exhibit->seat_count : EXHIBIT_SEATS;
    hud->mm = (float)hud->def.width / (exhibit->display.width > 0 ? exhibit->display.width : 530);
    for (; hud->count < count; hud->count++) {
        hud->panels[hud->count] =
            (struct hud_panel){.open = -1, .scanned = -1, .busy_opacity = 1, .any_ink = takes_any(hud, hud->count)};
    }
    hud->count = count;
    check_language(hud);
    for (int i = 0; i < count; i++) {
        check_panel(hud, i);
        lay(hud, i);
    }
    hud_layout_staff(hud);
}

void hud_choose(struct hud *hud, int panel, int tool, int ink)
{
    struct hud_panel *of = &hud->panels[panel];
    of->tool = tool >= 0 ? tool : of->tool;
    of->ink = ink >= 0 ? ink : of->ink;
    of->any_ink = of->any_ink && ink < 0;
    check_panel(hud, panel);
    hud_layout_panel(hud, panel); /* moves nothing, but a folded button shows what is chosen */
}

void hud_show_picture(struct hud *hud, const struct action_raster *picture)
{
    struct hud_thumb *thumb = &hud->thumb;
    int width = picture->width, height = picture->height, longer = width > height ? width : height;
    memset(thumb, 0, sizeof *thumb);
    if (!picture->values || longer < 1) {
        return;
    }
    thumb->width = width * HUD_THUMB / longer > 0 ? width * HUD_THUMB / longer : 1;
    thumb->height = height * HUD_THUMB / longer > 0 ? height * HUD_THUMB / longer : 1;
    for (int y = 0; y < thumb->height; y++) {
        int from = y * height / thumb->height, to = (y + 1) * height / thumb->height;
        for (int x = 0; x < thumb->width; x++) {
            int left = x * width / thumb->width, right = (x + 1) * width / thumb->width;
            float sum = 0;
            int count = 0;
            for (int v = from; v < to || v == from; v++) {
                for (int u = left; u < right || u == left; u++, count++) {
                    sum += picture->values[(size_t)v * (size_t)width + (size_t)u];
                }
            }
            thumb->grey[y * thumb->width + x] = (uint8_t)(255 * powf(clamp(sum / (float)count), 1 / 2.2f) + 0.5f);
        }
    }
}

void hud_reset(struct hud *hud)
{
    for (int i = 0; i < hud->count; i++) {
        struct hud_panel *of = &hud->panels[i], old = *of;
        *of = (struct hud_panel){.open = -1,
                                 .scanned = -1,
                                 .any_ink = takes_any(hud, i),
                                 .busy = old.busy,
                                 .busy_us = old.busy_us,
                                 .busy_opacity = old.busy_opacity,
                                 .held = old.held,
                                 .held_us = old.held_us,
                                 .left_us = old.left_us,
                                 .held_solid = old.held_solid};
    }
    hud->seated = false;
    hud->told_count = 0;
    hud->language = hud->def.exhibit->language_count > 0 ? hud->def.exhibit->languages[0] : 0;
    hud_layout(hud);
}

int hud_seat(const struct hud *hud, float x, float y)
{
    int nearest = 0;
    float least = INFINITY;
    for (int i = 0; i < hud->count; i++) {
        const float *zone = hud->def.exhibit->seats[i].zone;
        float across = fmaxf(fmaxf(zone[0] - x, x - zone[2]), 0) * (float)hud->def.width;
        float down = fmaxf(fmaxf(zone[1] - y, y - zone[3]), 0) * (float)hud->def.height;
        float distance = across * across + down * down;
        if (distance < least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

/* Visibility by the visit alone. */
static float visit_opacity(const struct hud *hud, uint64_t now_us)
{
    float change = seconds(hud->shown_us, now_us) / FADE;
    return clamp(hud->shown_opacity + (hud->shown ? change : -change));
}

/* By the hands of a seat alone. */
static float hands_opacity(const struct hud *hud, int panel, uint64_t now_us)
{
    const struct hud_panel *of = &hud->panels[panel];
    float wait = of->busy ? fmaxf(hud->def.exhibit->visit.hide, HIDE) : CALM;
    float change = fmaxf(seconds(of->busy_us, now_us) - wait, 0) / FADE;
    return clamp(of->busy_opacity + (of->busy ? -change : change));
}

/* Both, without the curator's opacity. */
static float visibility(const struct hud *hud, int panel, uint64_t now_us)
{
    return fminf(visit_opacity(hud, now_us), hands_opacity(hud, panel, now_us));
}

/* 0 as at rest, 1 solid. */
static float solid(const struct hud_panel *of, uint64_t now_us)
{
    uint64_t until_us = of->left_us + (uint64_t)(REST * 1e6f);
    if (of->held || now_us <= until_us) {
        return clamp(of->held_solid + seconds(of->held_us, now_us) / FADE);
    }
    float most = clamp(of->held_solid + seconds(of->held_us, until_us) / FADE);
    return clamp(most - seconds(until_us, now_us) / FADE);
}

static void hold(struct hud_panel *of, uint64_t now_us)
{
    of->held_solid = solid(of, now_us);
    of->held_us = now_us;
    of->held = true;
}

static void let_go(struct hud_panel *of, uint64_t now_us)
{
    of->held = false;
    of->left_us = now_us;
}

float hud_opacity(const struct hud *hud, int panel, uint64_t now_us)
{
    float rest = clamp(hud->def.exhibit->palette.opacity);
    return visibility(hud, panel, now_us) * (rest + (1 - rest) * solid(&hud->panels[panel], now_us));
}

void hud_show(struct hud *hud, bool shown, uint64_t now_us)
{
    if (shown != hud->shown) {
        hud->shown_opacity = visit_opacity(hud, now_us);
        hud->shown = shown;
        hud->shown_us = now_us;
        for (int i = 0; i < hud->count && shown; i++) {
            hold(&hud->panels[i], now_us);
            let_go(&hud->panels[i], now_us);
        }
    }
}

bool hud_busy(struct hud *hud, int seat, bool busy, uint64_t now_us)
{
    if (seat < 0 || seat >= hud->count) {
        return false;
    }
    struct hud_panel *of = &hud->panels[seat];
    if (busy != of->busy) {
        of->busy_opacity = hands_opacity(hud, seat, now_us);
        of->busy = busy;
        of->busy_us = now_us;
    }
    return hud_opacity(hud, seat, now_us) > 0;
}

/* Until a change that begins `wait` after `since` and takes FADE at most: 0 while it is under way, -1 after it. */
static int timeout_of(float from, bool up, uint64_t since_us, float wait, uint64_t now_us)
{
    float left = (up ? 1 - from : from) * FADE, gone = seconds(since_us, now_us);
    if (left <= 0 || gone >= wait + left) {
        return -1;
    }
    return gone >= wait ? 0 : (int)ceilf(1000 * (wait - gone));
}

static int sooner(int a, int b)
{
    return a < 0 ? b : b < 0 || a < b ? a : b;
}

int hud_timeout_ms(const struct hud *hud, uint64_t now_us)
{
    bool rests = hud->def.exhibit->palette.opacity < 1;
    int least =
        sooner(timeout_of(hud->shown_opacity, hud->shown, hud->shown_us, 0, now_us), hud_told_timeout_ms(hud, now_us));
    for (int i = 0; i < hud->count; i++) {
        const struct hud_panel *of = &hud->panels[i];
        float wait = of->busy ? fmaxf(hud->def.exhibit->visit.hide, HIDE) : CALM;
        least = sooner(least, timeout_of(of->busy_opacity, !of->busy, of->busy_us, wait, now_us));
        if (rests && hud->shown) {
            least = sooner(least, timeout_of(of->held_solid, true, of->held_us, 0, now_us));
            least = sooner(least, of->held ? -1 : timeout_of(1, false, of->left_us, REST, now_us));
        }
    }
    return least;
}

static bool inside(float x, float y, const struct hud_button *button, float slack)
{
    return x >= button->x - slack && x < button->x + button->width + slack && y >= button->y - slack &&
           y < button->y + button->height + slack;
}

static const struct hud_button *button_of(const struct hud *hud, int panel, int button)
{
    if (panel == NO_PANEL) {
        return button >= 0 && button < 2 ? &hud->staff[button] : NULL;
    }
    return panel >= 0 && panel < hud->count && button >= 0 && button < hud->panels[panel].count
               ? &hud->panels[panel].buttons[button]
               : NULL;
}

bool hud_enabled(const struct hud *hud, int panel, int button)
{
    const struct hud_button *of = button_of(hud, panel, button);
    if (!of) {
        return false;
    }
    return of->kind == HUD_UNDO   ? hud->panels[panel].can_undo
           : of->kind == HUD_REDO ? hud->panels[panel].can_redo
                                  : true;
}

bool hud_pressed(const struct hud *hud, int panel, int button)
{
    for (int i = 0; i < HUD_FINGERS; i++) {
        const struct hud_finger *finger = &hud->fingers[i];
        if (finger->used && finger->over && finger->panel == panel && finger->button == button && button >= 0) {
            return true;
        }
    }
    return false;
}

static void open_group(struct hud *hud, int panel, int open)
{
    if (hud->panels[panel].open != open) {
        hud->panels[panel].open = open;
        lay(hud, panel);
    }
}

/* What a press changes of the palette itself. Returns the value that is told. */
static int take(struct hud *hud, int panel, const struct hud_button *button)
{
    struct hud_panel *of = &hud->panels[panel];
    switch (button->kind) {
    case HUD_INK:
        of->ink = button->value;
        of->any_ink = false;
        break;
    case HUD_TOOL:
        of->tool = button->value;
        break;
    case HUD_HAND:
        of->swapped = !of->swapped;
        break;
    case HUD_SEATED:
        hud->seated = !hud->seated;
        break;
    case HUD_LANGUAGE:
        hud->language = button->value;
        break;
    default:
        return button->value;
    }
    of->open = -1;
    if (button->kind == HUD_SEATED || button->kind == HUD_LANGUAGE) {
        hud_layout(hud);
    } else if (button->kind == HUD_HAND) {
        lay(hud, panel);
    } else {
        hud_layout_panel(hud,
                         panel); /* a choice moves nothing unless a group was open: fingers stay on their buttons */
    }
    return button->kind == HUD_HAND ? of->swapped : button->kind == HUD_SEATED ? hud->seated : button->value;
}

bool hud_press(struct hud *hud, int panel, int button, uint64_t time_us, struct hud_press *press)
{
    const struct hud_button *of = button_of(hud, panel, button);
    if (!of || !hud_enabled(hud, panel, button)) {
        return false;
    }
    struct hud_button copy = *of; /* the layout may change under it */
    if (copy.folded) {
        open_group(hud, panel, (int)copy.kind);
        return false;
    }
    if (copy.kind == HUD_MORE) {
        open_group(hud, panel, -1);
        return false;
    }
    bool grouped = panel != NO_PANEL && hud->panels[panel].open >= 0;
    *press = (struct hud_press){.seat = panel == NO_PANEL ? 0 : panel, .kind = copy.kind, .time_us = time_us};
    press->value = panel == NO_PANEL ? copy.value : take(hud, panel, &copy);
    if (grouped) {
        lay(hud, panel);
    }
    return true;
}

static struct hud_finger *find(struct hud *hud, const struct event *event)
{
    for (int i = 0; i < HUD_FINGERS; i++) {
        struct hud_finger *finger = &hud->fingers[i];
        if (finger->used && finger->source == event->source && finger->slot == event->slot) {
            return finger;
        }
    }
    return NULL;
}

static struct hud_finger *unused(struct hud *hud)
{
    for (int i = 0; i < HUD_FINGERS; i++) {
        if (!hud->fingers[i].used) {
            return &hud->fingers[i];
        }
    }
    return NULL;
}

/* The panel whose strip holds a place, if it is to be seen. */
static int panel_at(const struct hud *hud, float x, float y, uint64_t now_us)
{
    for (int i = 0; i < hud->count; i++) {
        const struct hud_panel *of = &hud->panels[i];
        bool within = x >= of->x && x < of->x + of->width && y >= of->y && y < of->y + of->height;
        if (of->count > 0 && within && visibility(hud, i, now_us) >= FELT) {
            return i;
        }
    }
    return NO_PANEL;
}

/* The button at a place that no other finger holds. */
static int button_at(const struct hud *hud, int panel, float x, float y)
{
    int count = panel == NO_PANEL ? 2 : hud->panels[panel].count;
    for (int i = 0; i < count; i++) {
        if (inside(x, y, button_of(hud, panel, i), 0)) {
            for (int k = 0; k < HUD_FINGERS; k++) {
                const struct hud_finger *finger = &hud->fingers[k];
                if (finger->used && finger->panel == panel && finger->button == i) {
                    return NO_BUTTON;
                }
            }
            return i;
        }
    }
    return NO_BUTTON;
}

static void leave(struct hud *hud, struct hud_finger *finger, uint64_t now_us)
{
    bool others = false;
    finger->used = false;
    for (int i = 0; i < HUD_FINGERS; i++) {
        others = others || (hud->fingers[i].used && hud->fingers[i].panel == finger->panel);
    }
    if (!others && finger->panel >= 0 && finger->panel < hud->count) {
        let_go(&hud->panels[finger->panel], now_us);
    }
}

/* A finger comes down. Returns whether it is the palette's. */
static bool come_down(struct hud *hud, const struct event *event, float x, float y)
{
    int panel = hud->status ? NO_PANEL : panel_at(hud, x, y, event->time_us);
    int map = hud->status || panel != NO_PANEL ? NO_PANEL : hud_map_at(hud, x, y, event->time_us);
    panel = map != NO_PANEL ? map : panel;
    if (panel == NO_PANEL && !hud->status) {
        int seat = hud_seat(hud, event->x, event->y);
        if (seat < hud->count) {
            open_group(hud, seat, -1);
        }
        return false;
    }
    struct hud_finger *finger = unused(hud);
    if (!finger) {
        return false;
    }
    if (panel != NO_PANEL) {
        hold(&hud->panels[panel], event->time_us);
    }
    if (map != NO_PANEL) {
        hud_map_pick(hud, map, x, y);
    }
    int button = map != NO_PANEL ? NO_BUTTON : button_at(hud, panel, x, y);
    *finger =
        (struct hud_finger){true, event->source, event->slot, panel, button, button != NO_BUTTON, map != NO_PANEL};
    return true;
}

bool hud_feel(struct hud *hud, const struct event *event, struct hud_press *press, bool *pressed)
{
    *pressed = false;
    if (event->kind < EVENT_DOWN || event->kind > EVENT_CANCEL) {
        return false;
    }
    float x = event->x * (float)hud->def.width, y = event->y * (float)hud->def.height;
    struct hud_finger *finger = find(hud, event);
    if (event->kind == EVENT_DOWN) {
        if (finger) { /* its end was lost */
            leave(hud, finger, event->time_us);
        }
        return come_down(hud, event, x, y);
    }
    if (!finger) {
        return false;
    }
    const struct hud_button *button = button_of(hud, finger->panel, finger->button);
    if (finger->map && event->kind == EVENT_MOVE) {
        hud_map_pick(hud, finger->panel, x, y);
    }
    finger->over = button && inside(x, y, button, 0.5f * HUD_GAP * hud->mm);
    if (event->kind != EVENT_MOVE) {
        leave(hud, finger, event->time_us);
    }
    if (event->kind == EVENT_UP && finger->over) {
        *pressed = hud_press(hud, finger->panel, finger->button, event->time_us, press);
    }
    return true;
}
