#include "kiosk_case.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "kiosk_state.h"

static struct hall_told *tell(struct hall *hall, enum hall_what what)
{
    assert_true(hall->count < HALL_TOLD);
    struct hall_told *told = &hall->told[hall->count++];
    *told = (struct hall_told){.what = what, .verb = ACTION_VERBS, .us = hall->now_us};
    return told;
}

static bool post(void *context, const struct action *action, uint64_t event_us)
{
    struct hall *hall = context;
    struct hall_told *told = tell(hall, HALL_POST);
    (void)event_us;
    told->verb = action->verb;
    told->visitor = action->visitor;
    told->ink = action->ink;
    told->picture = action->verb == ACTION_STOCK ? (int)action->picture.values[0] : 0;
    told->option = action->option;
    bool amount = action->verb == ACTION_TEND || action->verb == ACTION_ATTRACT;
    told->value = amount ? action->amount : action->value;
    told->has_at = action->has_at;
    told->at = action->path.count > 0 ? action->path.points[action->path.count - 1] : action->at;
    return !hall->act || hall->act(hall->context, action);
}

/* Pictures as numbers: one value each. */
static bool stock(void *context, bool next, struct action *action)
{
    struct hall *hall = context;
    if (hall->reading) {
        return false;
    }
    hall->picture += next;
    *action = action_default(ACTION_STOCK);
    hall->shade = (float)hall->picture;
    action->picture = (struct action_raster){&hall->shade, 1, 1, 1};
    return true;
}

static void fresh(void *context)
{
    struct hall *hall = context;
    tell(hall, HALL_FRESH);
    hall->sheet = (struct kiosk_sheet){.number = hall->sheet.number + 1};
    hall->fresh_share = hall->cover == TRANSITION_WASH ? -1 : hall->cover_share;
    if (hall->tick) {
        hall->tick(hall->context, true);
    }
}

static void change(void *context, const struct script *script)
{
    struct hall *hall = context;
    tell(hall, HALL_CHANGE);
    hall->script = script;
}

static void keep(void *context)
{
    tell(context, HALL_KEEP);
}

static void power(void *context, bool on)
{
    struct hall *hall = context;
    tell(hall, HALL_POWER)->on = on;
    hall->dark = !on;
}

static struct kiosk_sheet sheet(void *context)
{
    return ((struct hall *)context)->sheet;
}

/* One mask for all. */
static bool inputs(void *context, int scene, struct action *actions, int *count)
{
    static const float HALF = 0.5f;
    struct hall *hall = context;
    (void)scene;
    *count = 0;
    if (actions && !hall->unready) {
        actions[(*count)++] = action_default(ACTION_MASK);
        actions[0].picture = (struct action_raster){&HALF, 1, 1, 1};
        hall->taken++;
    }
    return !hall->unready;
}

static void hand(void *context, int scene)
{
    struct hall *hall = context;
    hall->handed++;
    hall->hands = scene;
}

static bool cover(void *context, int kind, uint32_t seed, double share)
{
    struct hall *hall = context;
    hall->cover = kind;
    hall->cover_seed = seed;
    hall->cover_share = share;
    return hall->uncovered-- <= 0;
}

struct exhibit *hall_exhibit(const char *yaml)
{
    struct script_def def = script_default_def();
    struct report report;
    report_init(&report, "exhibit.yaml");
    struct exhibit *exhibit = exhibit_parse(yaml, strlen(yaml), ".", &def, &report);
    if (!exhibit) {
        report_print(&report, stderr);
    }
    assert_non_null(exhibit);
    report_finish(&report);
    return exhibit;
}

static struct controls *controls_of(const struct exhibit *exhibit, struct inputs **own)
{
    const struct script *script = exhibit->scenes[0].script;
    *own = exhibit->inputs ? NULL : inputs_default(script);
    struct controls *controls =
        controls_create(&(struct controls_def){.inputs = exhibit->inputs ? exhibit->inputs : *own,
                                               .inks = script->ink_count,
                                               .coefficients = script->coefficients,
                                               .seats = exhibit->seats,
                                               .seat_count = exhibit->seat_count});
    assert_non_null(controls);
    return controls;
}

static struct hall *open_hall(const char *yaml, int width, int height, bool resume)
{
    struct hall *hall = calloc(1, sizeof *hall);
    assert_non_null(hall);
    hall->width = width;
    hall->height = height;
    hall->now_us = 1000000;
    hall->wall = 1800000000;
    hall->sheet.number = 1;
    struct exhibit *exhibit = hall_exhibit(yaml);
    assert_non_null(exhibit->inputs); /* give them, so that nobody else owns them */
    struct inputs *own;
    hall->controls = controls_of(exhibit, &own);
    struct kiosk_def def = {
        .exhibit = exhibit,
        .width = width,
        .height = height,
        .seed = 1,
        .built = 1700000000,
        .resume = resume,
        .stage = {hall, post, fresh, change, keep, power, sheet, NULL, NULL, stock, inputs, hand, cover}};
    hall->kiosk = kiosk_create(&def, hall->now_us);
    assert_non_null(hall->kiosk);
    kiosk_controls(hall->kiosk, hall->controls);
    return hall;
}

struct hall *hall_open(const char *yaml)
{
    return open_hall(yaml, HALL_WIDTH, HALL_HEIGHT, false);
}

struct hall *hall_open_sized(const char *yaml, int width, int height)
{
    return open_hall(yaml, width, height, false);
}

struct hall *hall_open_resumed(const char *yaml)
{
    return open_hall(yaml, HALL_WIDTH, HALL_HEIGHT, true);
}

void hall_close(struct hall *hall)
{
    controls_destroy(hall->controls);
    kiosk_destroy(hall->kiosk);
    free(hall);
}

/* What the main loop does once a frame. */
static void turn(struct hall *hall)
{
    struct action action;
    struct wish wish;
    uint64_t us;
    controls_run(hall->controls, hall->now_us);
    while (controls_action(hall->controls, &action, &us)) {
        assert_true(kiosk_act(hall->kiosk, &action, us, hall->now_us));
    }
    while (controls_wish(hall->controls, &wish)) {
        kiosk_wish(hall->kiosk, &wish, hall->now_us);
    }
    kiosk_run(hall->kiosk, hall->now_us, hall->wall + (time_t)(hall->now_us / 1000000));
}

void hall_wait(struct hall *hall, double seconds)
{
    uint64_t until = hall->now_us + (uint64_t)(1e6 * seconds);
    while (hall->now_us < until) {
        hall->now_us += HALL_FRAME_US;
        turn(hall);
        hall->sheet.tick += !hall->dark;
        if (hall->tick && !hall->dark) {
            hall->tick(hall->context, false);
        }
    }
}

void hall_feel(struct hall *hall, const struct event *event)
{
    struct event own = *event;
    own.time_us = hall->now_us;
    if (kiosk_feel(hall->kiosk, &own, hall->now_us)) {
        controls_feel(hall->controls, &own);
    }
    turn(hall);
}

void hall_drag(struct hall *hall, float x, float y, float to_x, float to_y, double seconds)
{
    struct event event = {.kind = EVENT_DOWN, .source = SOURCE_TOUCH, .device = 1, .x = x, .y = y};
    int steps = (int)(seconds * 60) + 1;
    hall_feel(hall, &event);
    for (int i = 1; i <= steps; i++) {
        hall_wait(hall, seconds / steps);
        event.kind = EVENT_MOVE;
        event.x = x + (to_x - x) * (float)i / (float)steps;
        event.y = y + (to_y - y) * (float)i / (float)steps;
        hall_feel(hall, &event);
    }
    event.kind = EVENT_UP;
    hall_feel(hall, &event);
}

void hall_tap(struct hall *hall, float x, float y, double seconds)
{
    struct event event = {.kind = EVENT_DOWN, .source = SOURCE_TOUCH, .device = 1, .x = x, .y = y};
    hall_feel(hall, &event);
    hall_wait(hall, seconds);
    event.kind = EVENT_UP;
    hall_feel(hall, &event);
}

void hall_button(struct hall *hall, uint32_t number, double seconds)
{
    struct event event = {.kind = EVENT_CONTROL, .source = SOURCE_GPIO, .device = 1, .control = number, .value = 1};
    hall_feel(hall, &event);
    hall_wait(hall, seconds);
    event.value = 0;
    hall_feel(hall, &event);
}

int hall_count(const struct hall *hall, int since, enum hall_what what, enum action_verb verb)
{
    int count = 0;
    for (int i = since; i < hall->count; i++) {
        const struct hall_told *told = &hall->told[i];
        count += told->what == what && (verb == ACTION_VERBS || told->verb == verb);
    }
    return count;
}

int hall_painted(const struct hall *hall, int since, enum action_verb verb)
{
    int count = 0;
    for (int i = since; i < hall->count; i++) {
        count += hall->told[i].what == HALL_POST && hall->told[i].verb == verb && hall->told[i].visitor > 0;
    }
    return count;
}

bool hall_find(const struct hall *hall, int panel, int kind, int value, struct point *at)
{
    const struct hud_panel *on = &hall->kiosk->hud.panels[panel];
    for (int i = 0; i < on->count; i++) {
        const struct hud_button *button = &on->buttons[i];
        if ((int)button->kind == kind && button->value == value) {
            at->x = (button->x + 0.5f * button->width) / (float)hall->width;
            at->y = (button->y + 0.5f * button->height) / (float)hall->height;
            return true;
        }
    }
    return false;
}

void hall_touch(struct hall *hall, enum event_kind kind, int slot, float x, float y)
{
    struct event event = {.kind = kind, .source = SOURCE_TOUCH, .device = 1, .slot = slot, .x = x, .y = y};
    hall_feel(hall, &event);
}

void hall_press(struct hall *hall, int kind, int value)
{
    struct point at = {0, 0};
    hall_wait(hall, 3); /* it comes back */
    assert_true(hall_find(hall, 0, kind, value, &at));
    hall_tap(hall, at.x, at.y, 0.1);
}
