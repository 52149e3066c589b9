/* Scenes that go on with every tick, beside the studio: told as the studio tells, compared with a plot. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <limits.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "bench.h"
#include "journal.h"
#include "live_scene.h"
#include "plot.h"

enum { CELLS_X = 96, CELLS_Y = 60, PATIENCE_S = 60, TICKS = 40, SLOW_MS = 4, ACTIONS = 8, VISITOR = 2 };

struct place {
    struct live_scene *live;
    struct script script, other; /* scenes; nothing of them is read but the size */
    int64_t ticked;
};

struct deed {
    int64_t tick;
    struct action action;
};

static void nap(int ms)
{
    nanosleep(&(struct timespec){0, ms * 1000000L}, NULL);
}

static void open_place(struct place *place, const struct scene_type *const *types, enum scene_kind kind)
{
    *place = (struct place){.script = {.width = CELLS_X, .height = CELLS_Y}, .ticked = 100};
    place->live = live_scene_create(types);
    assert_non_null(place->live);
    live_scene_scene(place->live, &place->script, kind, "first");
}

static void tell(struct place *place, enum studio_event_kind kind, const struct script *script,
                 const struct action *action)
{
    struct studio_event event = {.kind = kind,
                                 .ticked = place->ticked,
                                 .script = script,
                                 .def = {.width = CELLS_X, .height = CELLS_Y},
                                 .action = action};
    live_scene_tell(place->live, &event);
}

static void tick(struct place *place)
{
    place->ticked++;
    tell(place, STUDIO_TICKED, &place->script, NULL);
}

static struct live_scene_sheet sheet_of(const struct place *place)
{
    return live_scene_sheet(place->live, bench_wall_s());
}

static const struct live_view *settle(struct place *place)
{
    double end_s = bench_wall_s() + PATIENCE_S;
    bool fresh;
    while (!live_scene_is_calm(place->live)) {
        assert_true(bench_wall_s() < end_s);
        nap(2);
    }
    return live_scene_newest(place->live, sheet_of(place).number, &fresh);
}

static struct action at(enum action_verb verb, float x, float y)
{
    struct action action = action_default(verb);
    action.visitor = VISITOR;
    action.at = (struct point){x, y};
    action.has_at = true;
    return action;
}

static struct action setting(enum scene_kind kind, const char *key, float value)
{
    struct action action = action_default(scene_types[kind]->sets);
    action.option = (int)(key_find(scene_types[kind]->options, key) - scene_types[kind]->options);
    action.value = value;
    return action;
}

/* What is done, with things that are for no scene, and some before there is one. Returns how many. */
static int write_deeds(enum scene_kind kind, struct deed deeds[ACTIONS])
{
    bool storm = kind == SCENE_LIGHTNING;
    enum action_verb begins = storm ? ACTION_STRIKE : ACTION_DOSE;
    struct action drop = at(ACTION_DROP, 0.5f, 0.5f), rinse = at(ACTION_RINSE, 0.3f, 0.5f);
    rinse.radius = 12;
    deeds[0] = (struct deed){100, action_default(ACTION_CLEAR)};
    deeds[1] = (struct deed){103, storm ? setting(kind, "eta", 2) : setting(kind, "feed", 0.03f)};
    deeds[2] = (struct deed){104, at(begins, 0.3f, 0.6f)};
    deeds[3] = (struct deed){104, drop};
    deeds[4] = (struct deed){109, at(begins, 0.7f, 0.4f)};
    deeds[5] = (struct deed){120, rinse};
    return 6;
}

/* The hash of a plot after those ticks. */
static uint64_t hash_of_plot(enum scene_kind kind, const struct deed *deeds, int count, int ticks)
{
    struct plot *plot = plot_create(CELLS_X, CELLS_Y);
    int next = 0;
    assert_non_null(plot);
    for (int64_t ticked = 100; ticked < 100 + ticks; ticked++) {
        for (; next < count && deeds[next].tick == ticked; next++) {
            plot_act(plot, ticked, &deeds[next].action);
        }
        assert_true(plot_tick(plot, ticked));
    }
    void *scene = plot_scene(plot, kind);
    uint64_t hash = scene ? scene_types[kind]->hash(scene) : 0;
    plot_destroy(plot);
    return hash;
}

static void do_deeds(struct place *place, const struct deed *deeds, int count, int ticks)
{
    int next = 0;
    while (place->ticked < 100 + ticks) {
        for (; next < count && deeds[next].tick == place->ticked; next++) {
            tell(place, STUDIO_ACTION, &place->script, &deeds[next].action);
        }
        tick(place);
    }
}

static void as_a_plot_does(enum scene_kind kind)
{
    struct place place;
    struct deed deeds[ACTIONS];
    int count = write_deeds(kind, deeds);
    uint64_t want = hash_of_plot(kind, deeds, count, TICKS);
    open_place(&place, scene_types, kind);
    tell(&place, STUDIO_SHEET, &place.script, NULL);
    do_deeds(&place, deeds, count, TICKS);
    const struct live_view *view = settle(&place);
    assert_true(want != 0 && live_scene_hash(place.live) == want);
    assert_true(view->any && view->kind == kind && view->sheet == sheet_of(&place).number);
    assert_int_equal(view->tick, 100 + TICKS - 1);
    assert_true(sheet_of(&place).done <= sheet_of(&place).tick);
    live_scene_destroy(place.live);
}

static void lightning_is_as_a_plot_has_it(void **state)
{
    (void)state;
    as_a_plot_does(SCENE_LIGHTNING);
}

static void chemistry_is_as_a_plot_has_it(void **state)
{
    (void)state;
    as_a_plot_does(SCENE_CHEMISTRY);
}

/* Where ticks of slow dishes wait. A type of scenes has no place for it. */
static struct gate {
    pthread_mutex_t lock;
    pthread_cond_t opened;
    int left, done; /* ticks that may pass, that have */
} gate = {.lock = PTHREAD_MUTEX_INITIALIZER, .opened = PTHREAD_COND_INITIALIZER};

static void open_gate(int left)
{
    pthread_mutex_lock(&gate.lock);
    gate.left = left;
    pthread_cond_broadcast(&gate.opened);
    pthread_mutex_unlock(&gate.lock);
}

static int passed_gate(void)
{
    pthread_mutex_lock(&gate.lock);
    int done = gate.done;
    pthread_mutex_unlock(&gate.lock);
    return done;
}

static bool slow_tick(void *scene, int64_t now)
{
    pthread_mutex_lock(&gate.lock);
    while (gate.left == 0) {
        pthread_cond_wait(&gate.opened, &gate.lock);
    }
    gate.left--;
    gate.done++;
    pthread_mutex_unlock(&gate.lock);
    nap(SLOW_MS);
    return dish_type.tick(scene, now);
}

/* Dishes that take their time. */
static struct scene_type slow_type(void)
{
    struct scene_type type = dish_type;
    type.tick = slow_tick;
    return type;
}

/* Nothing is waited for, by far: each tick would take LIVE_SCENE_WAIT_MS. */
static void tick_without_waiting(struct place *place, int count)
{
    double began_s = bench_wall_s();
    for (int i = 0; i < count; i++) {
        tick(place);
    }
    assert_true(bench_wall_s() - began_s < 0.5e-3 * LIVE_SCENE_WAIT_MS * count);
}

static void the_studio_waits(void **state)
{
    (void)state;
    struct place place;
    struct scene_type slow = slow_type();
    const struct scene_type *const types[SCENE_KINDS] = {[SCENE_CHEMISTRY] = &slow};
    struct action dose = at(ACTION_DOSE, 0.5f, 0.5f);
    open_gate(INT_MAX);
    open_place(&place, types, SCENE_CHEMISTRY);
    tell(&place, STUDIO_SHEET, &place.script, NULL);
    tell(&place, STUDIO_ACTION, &place.script, &dose);
    int passed = passed_gate();
    for (int i = 0; i < 3 * LIVE_SCENE_LEAD; i++) {
        tick(&place);
        assert_in_range(sheet_of(&place).behind, 0, LIVE_SCENE_LEAD);
    }
    assert_true(passed_gate() - passed >= 2 * LIVE_SCENE_LEAD);

    live_scene_release(place.live, true); /* it is to stop */
    open_gate(0);
    passed = passed_gate();
    tick_without_waiting(&place, 2 * LIVE_SCENE_LEAD);
    assert_true(sheet_of(&place).behind > LIVE_SCENE_LEAD && passed_gate() == passed);
    tell(&place, STUDIO_SHEET, &place.script, NULL); /* what is left is of no use any more */
    open_gate(INT_MAX);
    settle(&place);
    assert_in_range(passed_gate() - passed, 0, LIVE_SCENE_LEAD / 2);
    live_scene_destroy(place.live);
}

static struct bytes write_journal(const struct deed *deeds, int count, int64_t end)
{
    struct journal_writer writer;
    struct journal_head head = {.version = "test", .engine = "cpu"};
    struct journal_sheet sheet = {.def = {.width = CELLS_X, .height = CELLS_Y}, .ink_count = 1};
    struct action dose = at(ACTION_DOSE, 0.1f, 0.1f);
    sheet.def.coefficients = coefficients_default();
    journal_begin(&writer, &head);
    snprintf(sheet.scene, sizeof sheet.scene, "another");
    journal_sheet(&writer, 0, &sheet);
    journal_action(&writer, 50, &dose);
    snprintf(sheet.scene, sizeof sheet.scene, "first");
    journal_scene(&writer, 100, &sheet);
    for (int i = 0; i < count; i++) {
        journal_action(&writer, deeds[i].tick, &deeds[i].action);
    }
    journal_mark(&writer, end);
    return writer.out;
}

/* A view, while much is still to be done. */
static void see_it_on_its_way(const struct place *place)
{
    double end_s = bench_wall_s() + PATIENCE_S;
    for (bool seen = false; !seen;) {
        bool fresh;
        assert_true(bench_wall_s() < end_s);
        nap(2);
        seen = live_scene_newest(place->live, sheet_of(place).number, &fresh)->any;
    }
    assert_true(sheet_of(place).behind > 0);
}

static void it_catches_up_with_the_journal(void **state)
{
    (void)state;
    struct place place;
    struct deed deeds[ACTIONS];
    struct scene_type slow = slow_type();
    const struct scene_type *const types[SCENE_KINDS] = {[SCENE_CHEMISTRY] = &slow};
    int count = write_deeds(SCENE_CHEMISTRY, deeds), played = 2 * TICKS;
    uint64_t want = hash_of_plot(SCENE_CHEMISTRY, deeds, count, played + TICKS);
    struct bytes journal = write_journal(deeds, count, 100 + played);
    open_place(&place, types, SCENE_CHEMISTRY);
    open_gate(0);
    assert_true(live_scene_resume(place.live, &place.script, SCENE_CHEMISTRY, "first", journal.data, journal.size));
    int left = sheet_of(&place).behind;
    assert_true(left > LIVE_SCENE_LEAD);
    place.ticked = 100 + played;
    tell(&place, STUDIO_RESTORED, &place.script, NULL); /* the studio has taken up the painting */
    tick_without_waiting(&place, LIVE_SCENE_LEAD);
    assert_int_equal(sheet_of(&place).behind, left + LIVE_SCENE_LEAD);
    open_gate(LIVE_SCENE_LEAD);
    see_it_on_its_way(&place);
    open_gate(INT_MAX);
    for (int i = LIVE_SCENE_LEAD; i < TICKS; i++) {
        tick(&place); /* which waits for what it has added */
        assert_in_range(sheet_of(&place).behind, 0, left + LIVE_SCENE_LEAD);
    }
    settle(&place);
    assert_true(want != 0 && live_scene_hash(place.live) == want);
    assert_int_equal(sheet_of(&place).behind, 0);
    live_scene_destroy(place.live);
    bytes_finish(&journal);
}

static void kinds_come_and_go(void **state)
{
    (void)state;
    struct place place;
    struct deed deeds[ACTIONS];
    struct action plant = at(ACTION_PLANT, 0.5f, 0.5f);
    int count = write_deeds(SCENE_CHEMISTRY, deeds);
    open_place(&place, scene_types, SCENE_CHEMISTRY);
    live_scene_scene(place.live, &place.other, SCENE_TREES, "second");
    live_scene_size(place.live, CELLS_X, CELLS_Y);
    tell(&place, STUDIO_SHEET, &place.script, NULL);
    do_deeds(&place, deeds, count, TICKS);
    uint64_t hash = live_scene_hash(place.live);
    int number = sheet_of(&place).number;

    tell(&place, STUDIO_SCENE, &place.script, NULL); /* the file was edited: all stays */
    settle(&place);
    assert_true(hash != 0 && live_scene_hash(place.live) == hash && sheet_of(&place).number == number);

    tell(&place, STUDIO_SCENE, &place.other, NULL);
    tell(&place, STUDIO_ACTION, &place.other, &plant);
    const struct live_view *view = settle(&place);
    assert_true(sheet_of(&place).kind == SCENE_TREES && sheet_of(&place).number == number + 1);
    assert_true(view->kind == SCENE_TREES && !view->any && view->sheet == number + 1);

    tell(&place, STUDIO_SCENE, &place.script, NULL); /* and back: nothing is left of it */
    tick(&place);
    view = settle(&place);
    assert_true(view->kind == SCENE_CHEMISTRY && !view->any && live_scene_hash(place.live) == 0);
    live_scene_scene(place.live, &place.script, SCENE_CHEMISTRY, "third"); /* another scene of the same kind */
    tell(&place, STUDIO_ACTION, &place.script, &deeds[2].action);
    tick(&place);
    settle(&place);
    assert_true(live_scene_hash(place.live) != 0);
    tell(&place, STUDIO_SCENE, &place.script, NULL);
    settle(&place);
    assert_true(live_scene_hash(place.live) == 0);
    live_scene_destroy(place.live);
}

/* Nothing has begun: no views, no work, and the ticks are not lost. */
static void what_is_calm_costs_nothing(void **state)
{
    (void)state;
    struct place place;
    struct action start = setting(SCENE_CHEMISTRY, "feed", 0.03f), dose = at(ACTION_DOSE, 0.5f, 0.5f);
    const struct deed deeds[] = {{100, start}, {160, dose}};
    open_place(&place, scene_types, SCENE_CHEMISTRY);
    tell(&place, STUDIO_SHEET, &place.script, NULL);
    tell(&place, STUDIO_ACTION, &place.script, &start);
    tick(&place);
    assert_true(settle(&place)->calm);
    int plans = sheet_of(&place).plans;
    for (int i = 1; i < 60; i++) {
        tick(&place);
        assert_true(live_scene_is_calm(place.live));
    }
    assert_int_equal(sheet_of(&place).plans, plans);
    assert_false(live_scene_has_newer(place.live));
    tell(&place, STUDIO_ACTION, &place.script, &dose);
    tick(&place);
    tick(&place);
    assert_false(settle(&place)->calm);
    assert_true(live_scene_hash(place.live) == hash_of_plot(SCENE_CHEMISTRY, deeds, 2, 62));
    live_scene_destroy(place.live);
}

static void a_session_has_the_kind_of_its_verbs(void **state)
{
    (void)state;
    struct action drop = action_default(ACTION_DROP), strike = action_default(ACTION_STRIKE);
    struct action actions[] = {drop, strike};
    struct script script = {.actions = actions, .action_count = 2};
    assert_int_equal(live_scene_kind(&script), SCENE_LIGHTNING);
    script.action_count = 1;
    assert_int_equal(live_scene_kind(&script), SCENE_PAINTING);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lightning_is_as_a_plot_has_it),
        cmocka_unit_test(chemistry_is_as_a_plot_has_it),
        cmocka_unit_test(the_studio_waits),
        cmocka_unit_test(it_catches_up_with_the_journal),
        cmocka_unit_test(kinds_come_and_go),
        cmocka_unit_test(what_is_calm_costs_nothing),
        cmocka_unit_test(a_session_has_the_kind_of_its_verbs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
