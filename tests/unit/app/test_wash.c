/* A wash leaves the sheet as it was at first, whatever lay on it, and is gentle to look at. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "flash.h"
#include "painted.h"
#include "studio.h"
#include "wash.h"

enum { PAINTED_TICKS = 150 };

/* Its actions of a tick, but the clear. Returns whether that has come. */
static bool wash_tick(struct wash *wash, int64_t tick, struct painting *painting, int *actions)
{
    struct action action;
    bool clear = false;
    while (wash_action(wash, tick, &action)) {
        assert_false(clear); /* it is the last */
        clear = action.verb == ACTION_CLEAR;
        assert_true(clear || (action.verb == ACTION_RINSE && action.path.count <= STUDIO_PATH));
        for (int i = 0; i < action.path.count; i++) { /* as a script or a journal allows */
            assert_true(action.path.points[i].x >= -2 && action.path.points[i].x <= 3);
            assert_true(action.path.points[i].y >= -2 && action.path.points[i].y <= 3);
        }
        struct action legal = action_legal(&action);
        assert_memory_equal(&legal, &action, sizeof legal);
        if (painting && !clear) {
            painting_act(painting, &action);
        }
        (*actions)++;
    }
    return clear;
}

static uint64_t fresh_hash(const struct painting_def *def)
{
    struct painting *fresh = painting_create(def);
    assert_non_null(fresh);
    uint64_t hash = painting_hash(fresh);
    painting_destroy(fresh);
    return hash;
}

struct washing {
    int width, height, margin, rate;
    float seconds;
};

static struct painted paint_sheet(const struct washing *washing, uint32_t seed)
{
    struct painting_def def = painting_default_def();
    def.width = washing->width;
    def.height = washing->height;
    def.margin = washing->margin;
    def.seed = seed;
    struct painted painted = painted_create(&def, 160, 100);
    painted_paint(&painted, PAINTED_TICKS);
    return painted;
}

/* Before the clear every cell of the sheet, its margin and its ground are as new, to the bit. */
static void leaves_a_fresh_sheet(void **state)
{
    static const struct washing WASHINGS[] = {
        {64, 64, 0, 30, 4},   {64, 64, 20, 60, 6},  {300, 64, 8, 45, 5},   {64, 300, 8, 60, 4},
        {203, 117, 9, 30, 5}, {96, 128, 50, 60, 5}, {720, 450, 24, 30, 4},
    };
    (void)state;
    for (uint32_t i = 0; i < sizeof WASHINGS / sizeof WASHINGS[0]; i++) {
        const struct washing *washing = &WASHINGS[i];
        struct painted painted = paint_sheet(washing, 40 + i);
        struct painting_def def = painting_get_def(painted.painting);
        assert_true(painting_hash(painted.painting) != fresh_hash(&def));
        struct wash wash;
        int actions = 0;
        int64_t tick = 1000;
        wash_begin(&wash, tick, washing->seconds, washing->rate, 7 * i);
        for (; !wash_tick(&wash, tick, painted.painting, &actions); tick++) {
            assert_false(wash_over(&wash, tick));
            painting_tick(painted.painting);
        }
        assert_true(wash_over(&wash, tick));
        assert_int_equal(tick - 1000, (int)(washing->seconds * (float)washing->rate));
        assert_int_equal(actions, tick - 1000 + 1);
        assert_true(painting_hash(painted.painting) == fresh_hash(&def));
        struct painting_totals totals = painting_totals(painted.painting);
        assert_true(totals.solvent == 0 && totals.ink == 0 && totals.active == 0 && totals.carved == 0);
        painted_destroy(&painted);
    }
}

/* Where ticks are left out, the front goes all of its way, and once. */
static void makes_up_for_ticks_left_out(void **state)
{
    static const struct washing WASHING = {96, 80, 4, 60, 5};
    (void)state;
    for (int stride = 2; stride <= 1000; stride *= 5) {
        struct painted painted = paint_sheet(&WASHING, 3);
        struct painting_def def = painting_get_def(painted.painting);
        struct wash wash;
        int actions = 0;
        int64_t tick = 0;
        wash_begin(&wash, 0, WASHING.seconds, WASHING.rate, 1);
        while (!wash_tick(&wash, tick, painted.painting, &actions)) {
            painting_tick(painted.painting);
            tick += stride;
        }
        assert_true(tick >= 300 && tick < 300 + stride);
        assert_true(actions > 40);
        assert_true(painting_hash(painted.painting) == fresh_hash(&def));
        painted_destroy(&painted);
    }
}

static void comes_once_each_and_ends(void **state)
{
    (void)state;
    struct wash wash;
    struct action action;
    int actions = 0;
    wash_begin(&wash, 50, 0, 60, 9); /* too quick: as quick as may be */
    assert_false(wash_action(&wash, 49, &action));
    for (int tick = 50; tick < 50 + WASH_TICKS_MIN; tick++) {
        assert_false(wash_tick(&wash, tick, NULL, &actions));
        assert_false(wash_action(&wash, tick, &action));
        assert_false(wash_action(&wash, tick - 1, &action));
    }
    assert_true(wash_tick(&wash, 50 + WASH_TICKS_MIN, NULL, &actions));
    assert_int_equal(actions, WASH_TICKS_MIN + 1);
    assert_false(wash_action(&wash, 1000000, &action));
    assert_true(wash_over(&wash, 1000000));
    struct wash never = {0};
    assert_false(wash_action(&never, 7, &action));
}

static void another_seed_is_another_front(void **state)
{
    (void)state;
    struct wash one, other;
    struct action action;
    wash_begin(&one, 0, 5, 60, 1);
    wash_begin(&other, 0, 5, 60, 2);
    assert_true(wash_action(&one, 0, &action) && wash_action(&other, 0, &action));
    assert_memory_not_equal(one.points, other.points, sizeof one.points);
    wash_begin(&other, 0, 5, 60, 1);
    assert_true(wash_action(&other, 0, &action));
    assert_memory_equal(one.points, other.points, sizeof one.points);
}

enum { RATE = 60, SHOWN = 2 }; /* ticks a second; ticks a frame */

/* What is seen of some ticks, 30 frames a second. */
static void watch(struct painted *painted, struct flash *flash, int64_t tick)
{
    if (tick % SHOWN == 0) {
        painted_draw(painted);
        flash_frame(flash, painted->rgb, (uint64_t)tick * 1000000 / RATE);
    }
}

static void stop_growth(struct painted *painted)
{
    struct action stop = action_default(ACTION_SET);
    stop.coefficient = (int)(key_find(coefficient_keys, "beta_a") - coefficient_keys);
    painting_act(painted->painting, &stop);
}

/* The sheet as a whole gets no darker than a little, and lighter steadily; it ends as light as a fresh one. */
static void gets_lighter_steadily(void **state)
{
    static const struct washing WASHING = {160, 100, 6, RATE, 5};
    (void)state;
    struct painted painted = paint_sheet(&WASHING, 8);
    stop_growth(&painted);
    double means[5 * RATE / SHOWN + 1] = {0}, darkest = 1;
    int actions = 0, frames = 0;
    struct wash wash;
    wash_begin(&wash, 0, WASHING.seconds, RATE, 4);
    for (int64_t tick = 0; !wash_tick(&wash, tick, painted.painting, &actions); tick++) {
        painting_tick(painted.painting);
        if (tick % SHOWN == 0) {
            struct flash *one = flash_begin(painted.width, painted.height);
            watch(&painted, one, tick);
            means[frames++] = flash_worst(one).mean;
            flash_end(one);
        }
    }
    double first = means[0], last = means[frames - 1], most = 0, fallen = 0, lightest = 0;
    for (int i = 0; i < frames; i++) {
        darkest = fmin(darkest, means[i]);
        if (i >= RATE / SHOWN) {
            most = fmax(most, fabs(means[i] - means[i - RATE / SHOWN]));
        }
        if (i > frames / 3) { /* by then it has smeared */
            lightest = fmax(lightest, means[i]);
            fallen = fmax(fallen, lightest - means[i]);
        }
    }
    print_message("mean luminance %.3f, darkest %.3f, at the end %.3f; at most %.3f a second, darker again by %.3f\n",
                  first, darkest, last, most, fallen);
    assert_true(last - first > 0.1); /* there was something to wash away */
    assert_true(darkest > first - 0.06);
    assert_true(fallen < 0.03);
    assert_true(most < 0.35);
    struct painting_def def = painting_get_def(painted.painting);
    struct painted fresh = painted_create(&def, painted.width, painted.height);
    painted_draw(&fresh);
    painted_draw(&painted);
    assert_memory_equal(fresh.rgb, painted.rgb, (size_t)painted.width * (size_t)painted.height * 3);
    painted_destroy(&fresh);
    painted_destroy(&painted);
}

/* Drops fall, grow, more fall, all is washed away, and the next visitor begins. */
static void a_visit_does_not_flash(void **state)
{
    (void)state;
    struct painting_def def = painting_default_def();
    def.width = 320;
    def.height = 200;
    struct painted painted = painted_create(&def, def.width, def.height);
    struct flash *flash = flash_begin(painted.width, painted.height);
    int64_t tick = 0;
    int actions = 0;
    for (int drops = 0; drops < 3; drops++) {
        painted_paint(&painted, 0); /* five drops and two strokes at a time */
        for (int i = 0; i < RATE; i++, tick++) {
            watch(&painted, flash, tick);
            painting_tick(painted.painting);
        }
    }
    for (int round = 0; round < 1; round++) {
        struct wash wash;
        wash_begin(&wash, tick, 4, RATE, 5 + (uint32_t)round);
        for (; !wash_tick(&wash, tick, painted.painting, &actions); tick++) {
            watch(&painted, flash, tick);
            painting_tick(painted.painting);
        }
        struct action clear = action_default(ACTION_CLEAR);
        painting_act(painted.painting, &clear);
        painted_paint(&painted, 0);
        for (int i = 0; i < RATE; i++, tick++) {
            watch(&painted, flash, tick);
            painting_tick(painted.painting);
        }
    }
    struct flash_worst worst = flash_worst(flash);
    print_message("%d frames: %d general and %d red flashes in a second at most, at %.1f s; mean luminance changes by "
                  "%.3f within a second at most, at %.1f s\n",
                  worst.frames, worst.general, worst.red, 1e-6 * (double)worst.time_us, worst.mean_change,
                  1e-6 * (double)worst.mean_time_us);
    assert_true(worst.general <= FLASH_MOST && worst.red <= FLASH_MOST);
    assert_true(worst.mean_change < 0.3);
    flash_end(flash);
    painted_destroy(&painted);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(leaves_a_fresh_sheet),     cmocka_unit_test(makes_up_for_ticks_left_out),
        cmocka_unit_test(comes_once_each_and_ends), cmocka_unit_test(another_seed_is_another_front),
        cmocka_unit_test(gets_lighter_steadily),    cmocka_unit_test(a_visit_does_not_flash),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
