/* A storm over its life: water, taking back, limits, what it gives to others, what is said to have changed, and that
 * the same actions make the same. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "storm_case.h"

enum { WIDTH = STORM_CASE_WIDTH, HEIGHT = STORM_CASE_HEIGHT };

/* Segments that have not faded by a tick; those within a disc, 0..1 of the sheet and cells. */
static int seen(const struct storm *storm, int64_t tick, float x, float y, float radius)
{
    float now = (float)(tick - storm->origin);
    int count = 0;
    for (int i = 0; i < storm->count; i++) {
        const struct bolt_segment *segment = &storm->segments[i];
        bool within = hypotf(segment->to[0] - x * WIDTH, segment->to[1] - y * HEIGHT) < radius;
        count += segment->death > now && segment->radius > 0 && within;
    }
    return count;
}

static struct storm *grown(enum bolt_kind kind, int particles)
{
    struct storm *storm = storm_case_of(kind);
    storm_case_set(storm, 0, "particles", (float)particles);
    storm_case_set(storm, 0, "pace", 100);
    storm_case_strike(storm, 0, 1, 0.5f, 0.5f);
    storm_case_until_calm(storm, 0, 200);
    return storm;
}

static void water_takes_what_it_passes(void **state)
{
    (void)state;
    struct storm *storm = grown(BOLT_CITY, 2000);
    int all = seen(storm, 200, 0.5f, 0.5f, 1000), there = seen(storm, 200, 0.6f, 0.5f, 8);
    int since;
    (void)storm_view(storm, 200, &since);
    struct action rinse = action_default(ACTION_RINSE);
    rinse.has_at = true;
    rinse.at = (struct point){0.6f, 0.5f};
    rinse.radius = 16;
    rinse.strength = 0.5f;
    for (int64_t tick = 200; tick < 230; tick++) {
        storm_act(storm, tick, &rinse);
        storm_tick(storm, tick);
    }
    (void)storm_view(storm, 230, &since);
    assert_true(since < storm->count);
    storm_case_ticks(storm, 230, 260);
    assert_true(there > 20);
    assert_int_equal(seen(storm, 260, 0.6f, 0.5f, 8), 0);
    assert_true(seen(storm, 260, 0.5f, 0.5f, 1000) > all / 3);
    const struct point front[2] = {{0, 1.4f}, {1, 1.4f}}; /* all of the sheet is behind it */
    rinse.has_at = false;
    rinse.path = (struct action_path){front, 2};
    rinse.reach = 1;
    rinse.strength = 0.5f;
    for (int64_t tick = 260; tick < 300; tick++) {
        storm_act(storm, tick, &rinse);
        storm_tick(storm, tick);
    }
    storm_case_ticks(storm, 300, 330);
    assert_int_equal(storm->count, 0);
    assert_int_equal(storm_particles(storm), 0);
    assert_true(storm_is_calm(storm, 330));
    storm_destroy(storm);
}

/* What grows on from where water was stays unseen; what was never wet goes on. */
static void a_cut_branch_does_not_float(void **state)
{
    (void)state;
    struct storm *storm = storm_case_of(BOLT_LICHTENBERG);
    storm_case_set(storm, 0, "particles", 3000);
    storm_case_set(storm, 0, "pace", 50);
    storm_case_strike(storm, 0, 1, 0.5f, 0.5f);
    storm_case_ticks(storm, 0, 20);
    struct action rinse = action_default(ACTION_RINSE);
    rinse.has_at = true;
    rinse.at = (struct point){0.5f, 0.5f};
    rinse.radius = 140;
    rinse.strength = 1;
    for (int64_t tick = 20; tick < 40; tick++) {
        storm_act(storm, tick, &rinse);
        storm_case_ticks(storm, tick, tick + 1);
    }
    storm_case_ticks(storm, 40, 90);
    assert_int_equal(storm->count, 0);
    assert_true(storm_is_calm(storm, 90));
    storm_destroy(storm);
}

static uint64_t places(const struct storm *storm)
{
    uint64_t sum = 0;
    for (int i = 0; i < storm->count; i++) {
        const struct bolt_segment *segment = &storm->segments[i];
        sum += (uint64_t)(segment->to[0] * 64) * 31 + (uint64_t)(segment->to[1] * 64);
    }
    return sum;
}

static void visitors_take_back_their_own(void **state)
{
    (void)state;
    struct storm *storm = grown(BOLT_LICHTENBERG, 600);
    storm_case_strike(storm, 200, 2, 0.2f, 0.5f);
    int64_t tick = storm_case_until_calm(storm, 200, 300) + 1;
    uint64_t both = places(storm);
    int count = storm->count, first = seen(storm, tick, 0.5f, 0.5f, 30);
    assert_int_equal(storm_type.can_undo(storm), 1 << 1 | 1 << 2);
    assert_int_equal(storm_type.can_redo(storm), 0);
    storm_case_by(storm, tick, ACTION_UNDO, 1);
    assert_false(storm_is_calm(storm, tick));
    storm_case_ticks(storm, tick, tick + 40);
    assert_int_equal(storm_type.can_undo(storm), 1 << 2);
    assert_int_equal(storm_type.can_redo(storm), 1 << 1);
    assert_true(first > 100 && seen(storm, tick + 40, 0.5f, 0.5f, 20) == 0 && storm->count > 200);
    storm_case_by(storm, tick + 40, ACTION_REDO, 2); /* has nothing to bring back */
    storm_case_by(storm, tick + 40, ACTION_REDO, 1);
    storm_case_ticks(storm, tick + 40, tick + 42);
    assert_int_equal(storm->count, count);
    assert_true(places(storm) == both && storm_type.can_redo(storm) == 0);
    storm_case_by(storm, tick + 42, ACTION_UNDO, 0); /* nobody's: whoever was last */
    assert_int_equal(storm_type.can_redo(storm), 1 << 2);
    storm_case_strike(storm, tick + 43, 2, 0.8f, 0.3f); /* what was taken back is lost */
    assert_int_equal(storm_type.can_redo(storm), 0);
    storm_case_by(storm, tick + 44, ACTION_CLEAR, 1);
    storm_case_ticks(storm, tick + 44, tick + 46);
    assert_true(storm->count == 0 && storm_type.can_undo(storm) == 0 && storm_is_calm(storm, tick + 46));
    storm_destroy(storm);
}

/* Segments by birth, and none before `since` changes. */
static void what_changes_is_said(void **state)
{
    (void)state;
    enum { MOST = 40000 };
    struct storm *storm = storm_case_of(BOLT_LIGHTNING);
    struct bolt_segment *kept = calloc(MOST, sizeof *kept);
    int count = 0, since, sooner = 0;
    assert_non_null(kept);
    for (int64_t tick = 0; tick < 260; tick++) {
        if (tick % 50 == 0) {
            storm_case_strike(storm, tick, 1 + (int)tick / 50 % 3, (float)(tick % 110) / 110, 0.7f);
        }
        if (tick == 120) {
            storm_case_by(storm, tick, ACTION_UNDO, 2);
            storm_case_set(storm, tick, "thickness", 2);
        }
        storm_case_ticks(storm, tick, tick + 1);
        struct bolt_view view = storm_view(storm, tick, &since);
        assert_true(view.count <= MOST && since <= view.count);
        assert_true(since <= count || since == view.count);
        assert_memory_equal(kept, view.segments, (size_t)(since < count ? since : count) * sizeof *kept);
        for (int i = 1; i < view.count; i++) {
            assert_true(view.segments[i].birth >= view.segments[i - 1].birth);
        }
        sooner += since > view.count / 2;
        count = view.count;
        memcpy(kept, view.segments, (size_t)count * sizeof *kept);
        (void)storm_view(storm, tick, &since);
        assert_int_equal(since, count); /* nothing since just now */
    }
    assert_true(sooner > 20);
    free(kept);
    storm_destroy(storm);
}

/* No more than three in any second, whatever strikes. */
static void flashes_are_few(void **state)
{
    (void)state;
    enum { TICKS = 400 };
    struct storm *storm = storm_case_of(BOLT_LIGHTNING);
    int begins[TICKS] = {0}, total = 0, most = 0, since;
    float before = 0;
    for (int64_t tick = 0; tick < TICKS; tick++) {
        if (tick % 9 == 0 && tick < 300) {
            storm_case_strike(storm, tick, (int)tick % 5, (float)(tick % 70) / 70, 0.2f);
        }
        storm_case_ticks(storm, tick, tick + 1);
        float flash = storm_view(storm, tick, &since).flash;
        begins[tick] = flash > before;
        before = flash;
        total += begins[tick];
        int within = 0;
        for (int64_t i = tick; i >= 0 && i > tick - 60; i--) {
            within += begins[i];
        }
        most = within > most ? within : most;
    }
    print_message("%d flashes, at most %d in a second\n", total, most);
    assert_true(total > 4 && most <= 3);
    storm_destroy(storm);
}

static void all_is_bounded(void **state)
{
    (void)state;
    struct storm *storm = storm_case_of(BOLT_LICHTENBERG);
    storm_case_set(storm, 0, "particles", 100);
    for (int i = 0; i < 200; i++) {
        storm_case_strike(storm, 0, i % 70, (float)(i % 20) / 20, (float)(i % 9) / 9);
        storm_case_attract(storm, 0, i, 0.5f, 0.5f, 1000);
        const struct point path[2] = {{(float)i / 200, 0}, {NAN, 1e30f}};
        struct action stroke = action_default(ACTION_ATTRACT);
        stroke.path = (struct action_path){path, 2};
        storm_act(storm, 0, &stroke);
    }
    int live = 0, hands = 0;
    storm_case_ticks(storm, 0, 3);
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        live += storm->bolts[slot].lives && !storm->bolts[slot].leaves && storm->bolts[slot].undone == 0;
    }
    for (int i = 0; i < STORM_HANDS; i++) {
        hands += storm->hands[i].lies;
    }
    assert_int_equal(live, STORM_BOLTS);
    assert_int_equal(hands, STORM_HANDS);
    storm_case_by(storm, 3, ACTION_CLEAR, 0);
    storm_case_set(storm, 3, "particles", 60000);
    storm_case_set(storm, 3, "pace", 1000);
    storm_case_set(storm, 3, "eta", 0);
    storm_case_set(storm, 3, "kind", BOLT_LIGHTNING);
    storm_case_set(storm, 3, "particles", 1e9f);
    assert_int_equal(storm_get_def(storm).particles, STORM_PARTICLES);
    storm_destroy(storm);
}

/* With one more than there may be, the oldest gives way, and fades. */
static void the_oldest_gives_way(void **state)
{
    (void)state;
    struct storm *storm = grown(BOLT_LICHTENBERG, 1500);
    storm_case_set(storm, 200, "particles", 60);
    for (int i = 0; i < STORM_BOLTS; i++) {
        assert_false(storm->bolts[0].leaves);
        storm_case_strike(storm, 200 + i, 2, (float)(i % 6) / 6, (float)(i / 6) / 4);
        storm_case_ticks(storm, 200 + i, 201 + i);
    }
    const struct storm_bolt *first = &storm->bolts[0];
    assert_true(first->lives && first->leaves && first->gone < STORM_AGES && seen(storm, 224, 0.5f, 0.5f, 30) > 100);
    storm_case_ticks(storm, 224, 290);
    assert_int_equal(storm_type.can_undo(storm), 1 << 2);
    storm_destroy(storm);
}

/* So it does where there are as many particles as there may be; the newest grows on. */
static void particles_are_bounded(void **state)
{
    (void)state;
    struct storm *storm = grown(BOLT_LICHTENBERG, 1500);
    assert_int_equal(storm->most, STORM_PARTICLES);
    storm->most = 2500;
    storm_case_set(storm, 200, "particles", 1400);
    storm_case_set(storm, 200, "pace", 30);
    storm_case_strike(storm, 200, 2, 0.2f, 0.5f);
    bool left = false;
    for (int64_t tick = 200; tick < 400; tick++) {
        storm_case_ticks(storm, tick, tick + 1);
        assert_true(storm_particles(storm) <= storm->most);
        left = left || storm->bolts[0].leaves;
    }
    assert_true(left && !storm->bolts[0].lives && storm_is_calm(storm, 400));
    assert_int_equal(storm_particles(storm), 1400);
    storm_case_set(storm, 400, "particles", 4000); /* alone, it ends there */
    storm_case_strike(storm, 400, 2, 0.7f, 0.5f);
    storm_case_until_calm(storm, 400, 700);
    assert_true(storm_particles(storm) == storm->most && storm_is_calm(storm, 700));
    storm_destroy(storm);
}

static void nothing_breaks_it(void **state)
{
    (void)state;
    struct storm *storm = storm_create(0, -5);
    assert_non_null(storm);
    storm_case_strike(storm, 0, 1, 0.5f, 0.5f);
    storm_case_ticks(storm, 0, 30);
    storm_resize(storm, WIDTH, HEIGHT);
    uint32_t bits = 12345;
    float odd[8] = {NAN, INFINITY, -INFINITY, 1e30f, -1e30f, 0, 0.5f, 1};
    for (int i = 0; i < 400; i++) {
        bits = bits * 1664525u + 1013904223u;
        struct action action = action_default((enum action_verb)(bits >> 8) % ACTION_VERBS);
        struct point path[3] = {{odd[bits >> 3 & 7], odd[bits >> 6 & 7]}, {odd[bits >> 9 & 7], 0.2f}, {0.9f, 0.4f}};
        action.has_at = bits >> 20 & 1;
        action.at = (struct point){odd[bits >> 12 & 7], odd[bits >> 15 & 7]};
        action.visitor = (int)(bits >> 24) - 100;
        action.amount = odd[bits >> 18 & 7];
        action.radius = odd[bits >> 21 & 7];
        action.value = odd[bits >> 4 & 7] * 10;
        action.option = (int)(bits >> 5 & 31) - 8;
        action.path = (struct action_path){path, (int)(bits >> 27 & 3)};
        action.flow = path[1];
        storm_act(storm, i, &action);
        if (storm_get_def(storm).pace > 60) {
            storm_case_set(storm, i, "pace", 60);
        }
        assert_true(storm_tick(storm, i));
        if (i % 100 == 50) {
            storm_resize(storm, 100 + i, 600 - i);
        }
    }
    int since;
    struct bolt_view view = storm_view(storm, 400, &since);
    for (int i = 0; i < view.count; i++) {
        for (int d = 0; d < 3; d++) {
            assert_true(isfinite(view.segments[i].from[d]) && isfinite(view.segments[i].to[d]));
        }
        assert_true(view.segments[i].radius >= 0 && view.segments[i].heat <= 1);
    }
    storm_destroy(storm);
    storm_destroy(NULL);
}

static void fields_say_where_it_is(void **state)
{
    (void)state;
    enum { ACROSS = 120, DOWN = 75, CELLS = ACROSS * DOWN };
    static float dark[CELLS], along[2 * CELLS], around[CELLS];
    struct storm *storm = grown(BOLT_LICHTENBERG, 1500);
    uint64_t before = storm_hash(storm);
    assert_true(storm_type.field(storm, FIELD_DARK, ACROSS, DOWN, dark));
    assert_true(storm_type.field(storm, FIELD_ALONG, ACROSS, DOWN, along));
    assert_true(storm_type.field(storm, FIELD_AROUND, ACROSS, DOWN, around));
    assert_true(storm_hash(storm) == before);
    double outwards = 0, told = 0;
    int covered = 0;
    for (int i = 0; i < CELLS; i++) {
        float x = ((float)(i % ACROSS) + 0.5f) - ACROSS / 2.0f, y = ((float)(i / ACROSS) + 0.5f) - DOWN / 2.0f;
        float length = hypotf(along[i], along[CELLS + i]), far = hypotf(x, y);
        assert_true(dark[i] >= 0 && dark[i] <= 1 && around[i] >= 0 && around[i] <= 1 && length < 1.0001f);
        assert_true(dark[i] * 65536 == floorf(dark[i] * 65536) && around[i] * 65536 == floorf(around[i] * 65536));
        if (dark[i] < 0.5f) {
            covered++;
            assert_true(around[i] == 0 && length > 0.3f);
            outwards += far > 3 ? (double)((along[i] * x + along[CELLS + i] * y) / far) : 0;
            told += far > 3;
        }
        if (far > 55) {
            assert_true(dark[i] == 1 && length == 0 && around[i] > 0.6f);
        }
    }
    print_message("covered %d, outwards %.2f\n", covered, outwards / told);
    assert_true(covered > 100 && outwards / told > 0.5);
    assert_true(around[0] > around[DOWN / 2 * ACROSS + 10]); /* the farther, the higher */
    storm_case_by(storm, 300, ACTION_CLEAR, 0);
    assert_true(storm_type.field(storm, FIELD_AROUND, ACROSS, DOWN, around) && around[CELLS / 2] == 1);
    storm_destroy(storm);
}

static int dark_of(struct storm *storm, float *dark, int width, int height)
{
    int covered = 0;
    assert_true(storm_type.field(storm, FIELD_DARK, width, height, dark));
    for (int i = 0; i < width * height; i++) {
        covered += dark[i] < 0.5f;
    }
    return covered;
}

/* Lightning that has faded and been forgotten is what has grown still, but for what was taken back or washed away. */
static void strikes_leave_scars(void **state)
{
    (void)state;
    enum { ACROSS = 120, DOWN = 75, CELLS = ACROSS * DOWN };
    static float dark[CELLS], along[2 * CELLS];
    struct storm *storm = storm_case_of(BOLT_LIGHTNING);
    storm_case_set(storm, 0, "life", 20);
    storm_case_strike(storm, 0, 1, 0.3f, 0.8f);
    int64_t struck = storm_case_until_calm(storm, 0, 900);
    assert_true(struck < 900 && storm->count == 0); /* nothing is to be seen */
    int one = dark_of(storm, dark, ACROSS, DOWN), told = 0;
    assert_true(storm_type.field(storm, FIELD_ALONG, ACROSS, DOWN, along));
    for (int i = 0; i < CELLS; i++) {
        told += dark[i] < 0.5f && fabsf(along[CELLS + i]) > 0.2f;
    }
    print_message("%d cells of a strike that has gone, %d with a way\n", one, told);
    assert_true(one > 40 && told > one / 4);
    uint64_t scarred = storm_hash(storm);
    print_message("scarred: 0x%016llx\n", (unsigned long long)scarred);
    assert_true(scarred == UINT64_C(0x35cbc1447872e29e));
    storm_case_strike(storm, struck + 1, 2, 0.8f, 0.8f);
    storm_case_ticks(storm, struck + 1, struck + 12);
    assert_true(dark_of(storm, dark, ACROSS, DOWN) > one + 5);
    storm_case_by(storm, struck + 12, ACTION_UNDO, 2);
    storm_case_ticks(storm, struck + 12, struck + 100);
    assert_int_equal(dark_of(storm, dark, ACROSS, DOWN), one);
    struct action rinse = action_default(ACTION_RINSE);
    rinse.has_at = true;
    rinse.at = (struct point){0.3f, 0.7f};
    rinse.radius = 30;
    rinse.strength = 0.5f;
    for (int64_t tick = struck + 100; tick < struck + 130; tick++) {
        storm_act(storm, tick, &rinse);
        storm_case_ticks(storm, tick, tick + 1);
    }
    int left = dark_of(storm, dark, ACROSS, DOWN);
    print_message("%d of %d left by water\n", left, one);
    assert_in_range(left, one / 5, one - 20);
    assert_true(storm->count == 0 && storm_hash(storm) != scarred);
    storm_case_by(storm, struck + 130, ACTION_CLEAR, 0);
    assert_int_equal(dark_of(storm, dark, ACROSS, DOWN), 0);
    storm_destroy(storm);
}

static void another_grid_keeps_what_has_grown(void **state)
{
    (void)state;
    struct storm *storm = grown(BOLT_LICHTENBERG, 800);
    struct bolt_segment before = storm->segments[200];
    int since;
    (void)storm_view(storm, 200, &since);
    storm_resize(storm, WIDTH / 2, HEIGHT / 2);
    struct bolt_segment after = storm->segments[200];
    assert_true(fabsf(after.to[0] - before.to[0] / 2) < 0.01f && fabsf(after.to[1] - before.to[1] / 2) < 0.01f);
    assert_true(fabsf(after.radius - before.radius / 2) < 0.01f);
    struct bolt_view view = storm_view(storm, 200, &since);
    assert_true(view.width == WIDTH / 2 && since == 0);
    storm_case_strike(storm, 200, 1, 0.2f, 0.3f);
    storm_case_ticks(storm, 200, 210);
    assert_true(storm->count > 1000);
    storm_destroy(storm);
}

static uint64_t session(enum bolt_kind kind)
{
    struct storm *storm = storm_case_of(kind);
    const struct point path[2] = {{0.8f, 0.2f}, {0.9f, 0.7f}};
    struct action stroke = action_default(ACTION_ATTRACT), mask = action_default(ACTION_MASK);
    uint64_t found = 0;
    stroke.visitor = 2;
    stroke.path = (struct action_path){path, 2};
    stroke.amount = 5;
    mask.has_at = true;
    mask.at = (struct point){0.55f, 0.45f};
    mask.radius = 12;
    storm_case_set(storm, 0, "particles", 1500);
    storm_case_set(storm, 0, "pace", 30);
    storm_act(storm, 0, &mask);
    storm_case_strike(storm, 0, 1, 0.4f, 0.7f);
    storm_case_ticks(storm, 0, 10);
    storm_act(storm, 10, &stroke);
    storm_case_strike(storm, 10, 2, 0.7f, 0.6f);
    for (int64_t tick = 10; tick < 40; tick++) {
        storm_case_attract(storm, tick, 1, 0.4f + 0.01f * (float)tick, 0.8f, 60);
        storm_case_ticks(storm, tick, tick + 1);
        int since;
        (void)storm_view(storm, tick, &since); /* looking changes nothing */
        found = found * 31 + storm_hash(storm);
    }
    storm_case_by(storm, 40, ACTION_UNDO, 1);
    storm_case_ticks(storm, 40, 60);
    found = found * 31 + storm_hash(storm);
    storm_destroy(storm);
    return found;
}

static void the_same_actions_make_the_same(void **state)
{
    (void)state;
    static const struct {
        enum bolt_kind kind;
        uint64_t hash;
    } CASES[] = {
        {BOLT_LIGHTNING, UINT64_C(0x44df0cbe7200360b)},
        {BOLT_CORAL, UINT64_C(0x6990258971bff6af)},
        {BOLT_CITY, UINT64_C(0x01d14a478aacd27e)},
    };
    bool good = true;
    for (size_t i = 0; i < sizeof CASES / sizeof *CASES; i++) {
        uint64_t hash = session(CASES[i].kind);
        print_message("%s: 0x%016llx\n", bolt_kind_names[CASES[i].kind], (unsigned long long)hash);
        good = good && hash == CASES[i].hash;
    }
    assert_true(good);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(water_takes_what_it_passes),
        cmocka_unit_test(a_cut_branch_does_not_float),
        cmocka_unit_test(visitors_take_back_their_own),
        cmocka_unit_test(what_changes_is_said),
        cmocka_unit_test(flashes_are_few),
        cmocka_unit_test(all_is_bounded),
        cmocka_unit_test(the_oldest_gives_way),
        cmocka_unit_test(particles_are_bounded),
        cmocka_unit_test(nothing_breaks_it),
        cmocka_unit_test(fields_say_where_it_is),
        cmocka_unit_test(strikes_leave_scars),
        cmocka_unit_test(another_grid_keeps_what_has_grown),
        cmocka_unit_test(the_same_actions_make_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
