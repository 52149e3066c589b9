#include <stdlib.h>
#include <string.h>

#include "kiosk_state.h"

enum { STATUS_EVERY_US = 500000, FADE_MS = 16 };

static const float CORNER = 0.12f; /* of the longer side: where the staff's taps count */

static float radius_share(const struct kiosk *kiosk, int pixels)
{
    return kiosk->exhibit->access.dwell_radius * kiosk->hud.mm / (float)pixels;
}

/* The palettes, for the exhibit, the scene and the size that there are; what is shown and chosen stays. */
static void lay_hud(struct kiosk *kiosk)
{
    struct hud_def hud = {kiosk->exhibit, kiosk->def.width, kiosk->def.height, kiosk->scene};
    if (kiosk->hud.def.exhibit) {
        kiosk->hud.def = hud;
        hud_layout(&kiosk->hud);
    } else {
        hud_init(&kiosk->hud, &hud);
    }
}

/* Whatever follows from exhibit and size. What is half done with a switch or by the staff is forgotten: not for less.
 */
static void lay_out(struct kiosk *kiosk)
{
    int width = kiosk->def.width, height = kiosk->def.height, longer = width > height ? width : height;
    lay_hud(kiosk);
    access_init(&kiosk->access, &kiosk->exhibit->access, radius_share(kiosk, width), radius_share(kiosk, height));
    kiosk->access.seated = kiosk->hud.seated;
    staff_init(&kiosk->staff, &kiosk->exhibit->staff, CORNER * (float)longer / (float)width,
               CORNER * (float)longer / (float)height);
}

struct kiosk *kiosk_create(const struct kiosk_def *def, uint64_t now_us)
{
    struct kiosk *kiosk = calloc(1, sizeof *kiosk);
    struct attract *attract = kiosk ? attract_create(def->exhibit, def->seed) : NULL;
    if (!attract) {
        exhibit_destroy(def->exhibit);
        free(kiosk);
        return NULL;
    }
    kiosk->def = *def;
    kiosk->exhibit = def->exhibit;
    kiosk->attract = attract;
    kiosk->hours.open = true;
    kiosk->sheet = def->stage.sheet(def->stage.context).number;
    if (def->resume) {
        kiosk->scene = def->scene;
        kiosk->grounded = kiosk->stocked = true;
        visit_resume(&kiosk->visit, kiosk->exhibit, now_us);
    } else {
        visit_init(&kiosk->visit, kiosk->exhibit, now_us);
    }
    kiosk->options = kiosk_scene(kiosk)->options;
    lay_out(kiosk);
    hud_reset(&kiosk->hud);
    return kiosk;
}

void kiosk_destroy(struct kiosk *kiosk)
{
    if (!kiosk) {
        return;
    }
    for (int i = 0; i < KIOSK_PIECES; i++) {
        hud_image_finish(&kiosk->images[i]);
    }
    attract_destroy(kiosk->attract);
    exhibit_destroy(kiosk->exhibit);
    free(kiosk->trouble);
    free(kiosk);
}

static void choose_again(struct kiosk *kiosk)
{
    for (int i = 0; kiosk->controls && i < kiosk->hud.count; i++) {
        kiosk_choose(kiosk, i);
    }
}

void kiosk_controls(struct kiosk *kiosk, struct controls *controls)
{
    kiosk->controls = controls;
    if (!controls) {
        kiosk_let_all_go(kiosk);
    }
    kiosk_stand_dials(kiosk);
    choose_again(kiosk);
}

bool kiosk_post(struct kiosk *kiosk, const struct action *action, uint64_t event_us)
{
    return kiosk->def.stage.post(kiosk->def.stage.context, action, event_us);
}

static struct kiosk_sheet sheet_of(const struct kiosk *kiosk)
{
    return kiosk->def.stage.sheet(kiosk->def.stage.context);
}

/* What it takes from other scenes, if that is ready. */
static void lay_inputs(struct kiosk *kiosk, const struct exhibit_scene *scene)
{
    const struct kiosk_stage *stage = &kiosk->def.stage;
    struct action actions[EXHIBIT_FEEDS];
    int count = 0;
    if (scene->feed_count > 0 && stage->inputs && stage->inputs(stage->context, kiosk->scene, actions, &count)) {
        for (int i = 0; i < count; i++) {
            kiosk_post(kiosk, &actions[i], 0);
        }
    }
}

/* The scene is about to be washed away, or to change: others may take what there is of it. */
static void hand_over(struct kiosk *kiosk)
{
    const struct kiosk_stage *stage = &kiosk->def.stage;
    bool taken = false;
    for (int i = 0; i < kiosk->exhibit->scene_count; i++) {
        const struct exhibit_scene *scene = &kiosk->exhibit->scenes[i];
        for (int k = 0; k < scene->feed_count; k++) {
            taken = taken || scene->feeds[k].from == kiosk->scene;
        }
    }
    if (taken && stage->hand) {
        stage->hand(stage->context, kiosk->scene);
    }
}

/* Whether attract may show a scene: all that it takes is ready. */
static bool is_ready(const struct kiosk *kiosk, int scene)
{
    const struct kiosk_stage *stage = &kiosk->def.stage;
    int count;
    return kiosk->exhibit->scenes[scene].feed_count == 0 || !stage->inputs ||
           stage->inputs(stage->context, scene, NULL, &count);
}

/* What a scene has on every fresh sheet: a picture to grow over, what is set in it; a guide, a mask, its opening. */
static void lay_ground(struct kiosk *kiosk)
{
    const struct exhibit_scene *scene = kiosk_scene(kiosk);
    if (kiosk->grounded) {
        return;
    }
    kiosk->grounded = true;
    kiosk_lay_garden(kiosk);
    kiosk_lay_options(kiosk);
    for (int i = 0; i < scene->opening; i++) {
        kiosk_post(kiosk, &scene->ground[i], 0);
    }
    lay_inputs(kiosk, scene);
    for (int i = scene->opening; i < scene->ground_count; i++) {
        kiosk_post(kiosk, &scene->ground[i], 0);
    }
}

static void fresh_sheet(struct kiosk *kiosk, uint64_t now_us)
{
    kiosk_leave_sheet(kiosk, now_us);
    kiosk->sheet = sheet_of(kiosk).number + 1;
    kiosk->grounded = kiosk->begun = kiosk->washing = false;
    kiosk->def.stage.fresh(kiosk->def.stage.context);
    if (kiosk_kind(kiosk) != SCENE_PAINTING) { /* at once: what visitors plant, strike or dose comes after it */
        lay_ground(kiosk);
    }
}

static void show_scene(struct kiosk *kiosk, int scene)
{
    kiosk->scene = scene;
    kiosk->paintings = 0;
    kiosk->def.stage.change(kiosk->def.stage.context, kiosk->exhibit->scenes[kiosk->scene].script);
    lay_hud(kiosk);
    if (kiosk->controls) {
        const struct script *script = kiosk_scene(kiosk)->script;
        controls_scene(kiosk->controls, script->ink_count, &script->coefficients);
    }
    kiosk->options = kiosk_scene(kiosk)->options;
    kiosk_stand_dials(kiosk);
    choose_again(kiosk);
}

static void next_scene(struct kiosk *kiosk)
{
    int count = kiosk->exhibit->scene_count, next = (kiosk->scene + 1) % count;
    for (int i = 0; i < count && kiosk->attracting && !is_ready(kiosk, next); i++) {
        next = (next + 1) % count;
    }
    show_scene(kiosk, next);
}

void kiosk_begin_wash(struct kiosk *kiosk, uint64_t now_us)
{
    struct kiosk_sheet sheet = sheet_of(kiosk);
    if (!kiosk->leave.told) {
        hand_over(kiosk);
    }
    kiosk->washing = true;
    if (kiosk_leave(kiosk, now_us)) {
        return;
    }
    wash_begin(&kiosk->wash, sheet.tick, kiosk->exhibit->visit.wash, kiosk->exhibit->sheet.rate,
               (uint32_t)sheet.number);
}

static void welcome(struct kiosk *kiosk)
{
    hud_reset(&kiosk->hud);
    access_rest(&kiosk->access);
    if (kiosk->controls) {
        controls_reset(kiosk->controls);
    }
    choose_again(kiosk);
}

static void obey(struct kiosk *kiosk, const struct visit_order *order, uint64_t now_us)
{
    const struct kiosk_stage *stage = &kiosk->def.stage;
    switch (order->kind) {
    case ORDER_SHEET:
        fresh_sheet(kiosk, now_us);
        break;
    case ORDER_ATTRACT:
        kiosk->attracting = order->on;
        kiosk->begun = false;
        break;
    case ORDER_PALETTE:
        hud_show(&kiosk->hud, order->on, now_us);
        break;
    case ORDER_KEEP:
        if (!kiosk->leave.told) {
            stage->keep(stage->context);
        }
        break;
    case ORDER_WASH:
        kiosk_begin_wash(kiosk, now_us);
        break;
    case ORDER_POWER:
        kiosk->dark = !order->on;
        kiosk_leave_stop(kiosk);
        stage->power(stage->context, order->on);
        break;
    case ORDER_STATUS:
        kiosk->hud.status = order->on;
        kiosk->lines_us = 0;
        break;
    case ORDER_SCENE:
        if (!kiosk->leave.told) {
            hand_over(kiosk);
        }
        next_scene(kiosk);
        break;
    case ORDER_WELCOME:
        welcome(kiosk);
        kiosk_leave_hurry(kiosk, now_us);
        break;
    case ORDER_KINDS:
        break;
    }
}

void kiosk_obey(struct kiosk *kiosk, uint64_t now_us)
{
    struct visit_order order;
    while (visit_order(&kiosk->visit, &order)) {
        obey(kiosk, &order, now_us);
    }
}

static void run_wash(struct kiosk *kiosk, int64_t tick, uint64_t now_us)
{
    struct action action;
    while (wash_action(&kiosk->wash, tick, &action)) {
        kiosk_post(kiosk, &action, 0);
    }
    if (wash_over(&kiosk->wash, tick)) {
        kiosk_gone(kiosk, now_us);
    }
}

void kiosk_gone(struct kiosk *kiosk, uint64_t now_us)
{
    kiosk->washing = false;
    if (kiosk->leave.asked || !kiosk->attracting) {
        visit_feel(&kiosk->visit, kiosk->leave.asked ? VISIT_SCENE : VISIT_WASHED, now_us);
        kiosk_obey(kiosk, now_us);
        return;
    }
    kiosk->paintings++;
    if (kiosk->wanted > 0) {
        show_scene(kiosk, kiosk->wanted - 1);
        kiosk->wanted = 0;
    } else if (kiosk->exhibit->visit.next_scene > 0 && kiosk->paintings >= kiosk->exhibit->visit.next_scene) {
        next_scene(kiosk);
    }
    fresh_sheet(kiosk, now_us);
}

static void run_attract(struct kiosk *kiosk, int64_t tick, uint64_t now_us)
{
    struct action action;
    if (!kiosk->begun) {
        attract_begin(kiosk->attract, kiosk->scene, (float)kiosk->def.width / (float)kiosk->def.height);
        kiosk->begun = true;
        if (kiosk_kind(kiosk) == SCENE_PAINTING && ++kiosk->painted % 2 == 0 && kiosk->def.stage.guide &&
            kiosk->def.stage.guide(kiosk->def.stage.context, &action)) {
            kiosk_post(kiosk, &action, 0);
        }
    }
    while (attract_action(kiosk->attract, tick, &action)) {
        kiosk_post(kiosk, &action, 0);
    }
    if (kiosk->wanted == kiosk->scene + 1) {
        kiosk->wanted = 0;
    }
    if (attract_over(kiosk->attract, tick) || kiosk->wanted > 0) {
        kiosk_begin_wash(kiosk, now_us);
        kiosk->slide_due = kiosk->exhibit->gallery.slides > 0;
    }
}

/* The sheet does something by itself. Not before the studio has the sheet that is meant. */
static void run_sheet(struct kiosk *kiosk, uint64_t now_us)
{
    struct kiosk_sheet sheet = sheet_of(kiosk);
    for (int i = 0; i < kiosk->hud.count; i++) {
        kiosk->hud.panels[i].can_undo = sheet.can_undo >> (i + 1) & 1;
        kiosk->hud.panels[i].can_redo = sheet.can_redo >> (i + 1) & 1;
    }
    if (sheet.number < kiosk->sheet) {
        return;
    }
    lay_ground(kiosk);
    kiosk_run_garden(kiosk);
    kiosk_run_maps(kiosk, now_us);
    if (kiosk->leave.state == LEAVE_WAITS || kiosk->leave.state == LEAVE_COVERS) {
        return; /* kiosk_run_leave */
    }
    if (kiosk->washing) {
        run_wash(kiosk, sheet.tick, now_us);
    } else if (kiosk->attracting) {
        run_attract(kiosk, sheet.tick, now_us);
    }
}

/* Once a second of the wall's clock. */
static void keep_hours(struct kiosk *kiosk, uint64_t now_us, time_t time)
{
    if (time == kiosk->time) {
        return;
    }
    kiosk->time = time;
    kiosk->hours = schedule_at(kiosk->exhibit, time, kiosk->def.built);
    bool open = kiosk->told == KIOSK_BY_SCHEDULE ? kiosk->hours.open || kiosk->def.open : kiosk->told == KIOSK_OPEN;
    visit_feel(&kiosk->visit, open ? VISIT_OPEN : VISIT_CLOSE, now_us);
}

static void tell_status(struct kiosk *kiosk, uint64_t now_us)
{
    const struct kiosk_stage *stage = &kiosk->def.stage;
    if (!kiosk->hud.status || (kiosk->lines_us > 0 && now_us < kiosk->lines_us + STATUS_EVERY_US)) {
        return;
    }
    kiosk->lines_us = now_us;
    int length = snprintf(kiosk->lines, sizeof kiosk->lines, "exhibit\t%s\nstate\t%s, %u visits\nhours\t%s\n",
                          kiosk->exhibit->path ? kiosk->exhibit->path : "", visit_state_name(kiosk->visit.state),
                          kiosk->visit.visits, kiosk->hours.text);
    if (kiosk->trouble) {
        length += snprintf(kiosk->lines + length, sizeof kiosk->lines - (size_t)length, "not taken up\t%.900s\n",
                           kiosk->trouble);
    }
    if (stage->status) {
        stage->status(stage->context, kiosk->lines + length, sizeof kiosk->lines - (size_t)length);
    }
}

void kiosk_run(struct kiosk *kiosk, uint64_t now_us, time_t time)
{
    bool held = kiosk->controls && controls_are_held(kiosk->controls);
    keep_hours(kiosk, now_us, time);
    if (staff_called(&kiosk->staff, now_us)) {
        visit_feel(&kiosk->visit, VISIT_STAFF, now_us);
    }
    if (held) {
        visit_feel(&kiosk->visit, VISIT_HOLD, now_us);
    }
    kiosk_tell_dials(kiosk, now_us);
    kiosk_busy(kiosk, now_us);
    kiosk_run_access(kiosk, now_us);
    visit_run(&kiosk->visit, now_us);
    kiosk_obey(kiosk, now_us);
    kiosk_run_leave(kiosk, now_us);
    run_sheet(kiosk, now_us);
    tell_status(kiosk, now_us);
}

static int sooner(int a, int b)
{
    return b >= 0 && b < a ? b : a;
}

int kiosk_timeout_ms(const struct kiosk *kiosk, uint64_t now_us, int most)
{
    most = kiosk_is_covered(kiosk) ? sooner(most, FADE_MS) : most;
    int ms = sooner(most, visit_timeout_ms(&kiosk->visit, now_us)), fade = hud_timeout_ms(&kiosk->hud, now_us);
    ms = sooner(ms, fade == 0 || access_moves(&kiosk->access) ? FADE_MS : fade);
    ms = sooner(ms, access_timeout_ms(&kiosk->access, now_us));
    return sooner(ms, staff_timeout_ms(&kiosk->staff, now_us));
}

struct exhibit *kiosk_exhibit(struct kiosk *kiosk, struct exhibit *exhibit, uint64_t now_us)
{
    struct attract *attract = attract_create(exhibit, kiosk->def.seed + now_us);
    struct exhibit *old = kiosk->exhibit;
    const struct exhibit_scene *before = kiosk_scene(kiosk);
    const char *id = before->id;
    if (!attract) {
        return exhibit; /* memory is short: it stays as it is */
    }
    kiosk->wanted = 0;
    attract_destroy(kiosk->attract);
    kiosk->attract = attract;
    kiosk->exhibit = exhibit;
    kiosk->begun = false;
    kiosk->scene = 0;
    for (int i = 0; i < exhibit->scene_count; i++) {
        kiosk->scene = strcmp(exhibit->scenes[i].id, id) == 0 ? i : kiosk->scene;
    }
    kiosk->time = 0;
    kiosk->controls = NULL;
    lay_out(kiosk);
    visit_reload(&kiosk->visit, exhibit, now_us);
    kiosk->def.stage.change(kiosk->def.stage.context, kiosk_scene(kiosk)->script);
    kiosk_obey(kiosk, now_us);
    bool other = kiosk_scene(kiosk)->kind != before->kind;
    if (kiosk->attracting || other) { /* what paints itself begins anew; what a visitor has painted stays */
        fresh_sheet(kiosk, now_us);
    } else if (kiosk_kind(kiosk) != SCENE_PAINTING) {
        kiosk_change_options(kiosk, &before->options);
    }
    return old;
}

void kiosk_trouble(struct kiosk *kiosk, const char *report)
{
    free(kiosk->trouble);
    kiosk->trouble = report ? strdup(report) : NULL;
    kiosk->lines_us = 0;
}

bool kiosk_wants_slide(struct kiosk *kiosk)
{
    bool wants = kiosk->slide_due && kiosk->visit.state == VISIT_ATTRACT && !kiosk->hud.status;
    kiosk->slide_due = false;
    return wants;
}

void kiosk_slide(struct kiosk *kiosk, uint8_t *rgba, int width, int height, uint64_t now_us)
{
    struct hud_image *image = &kiosk->images[LOOK_SLIDE];
    hud_image_finish(image);
    image->rgba = rgba;
    image->width = width;
    image->height = height;
    image->key = ++kiosk->slides;
    kiosk->slide_us = now_us;
}

const struct exhibit *kiosk_shows(const struct kiosk *kiosk)
{
    return kiosk->exhibit;
}

const struct exhibit_scene *kiosk_scene(const struct kiosk *kiosk)
{
    return &kiosk->exhibit->scenes[kiosk->scene];
}

bool kiosk_is_covered(const struct kiosk *kiosk)
{
    return kiosk->leave.state != LEAVE_NOT;
}

bool kiosk_staff(const struct kiosk *kiosk)
{
    return kiosk->hud.status;
}

bool kiosk_leaves(const struct kiosk *kiosk)
{
    return kiosk->leaves;
}

const char *kiosk_state(const struct kiosk *kiosk)
{
    return visit_state_name(kiosk->visit.state);
}

bool kiosk_want_scene(struct kiosk *kiosk, const char *id)
{
    for (int i = 0; i < kiosk->exhibit->scene_count; i++) {
        if (kiosk->exhibit->scenes[i].id && strcmp(kiosk->exhibit->scenes[i].id, id) == 0) {
            kiosk->wanted = i + 1;
            return true;
        }
    }
    return false;
}

void kiosk_keep_hours(struct kiosk *kiosk, enum kiosk_hours hours)
{
    kiosk->told = hours;
    kiosk->time = 0; /* looked at at once */
}

bool kiosk_is_visited(const struct kiosk *kiosk)
{
    return kiosk->visit.painted && kiosk->visit.state != VISIT_ATTRACT && kiosk->visit.state != VISIT_CLOSED;
}

uint32_t kiosk_visits(const struct kiosk *kiosk)
{
    return kiosk->visit.visits;
}
