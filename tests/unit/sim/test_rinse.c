/* What running water does to the cells, on a small sheet. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "brush.h"
#include "painting.h"
#include "rinse.h"

enum { SIZE = 96, CELLS = SIZE * SIZE, GROWN = 60 };

static struct painting *grow(int threads, bool dense)
{
    struct painting_def def = painting_default_def();
    def.width = def.height = SIZE;
    def.margin = 5;
    def.threads = threads;
    def.dense = dense;
    struct painting *painting = painting_create(&def);
    assert_non_null(painting);
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){0.5f, 0.5f};
    painting_act(painting, &drop);
    for (int tick = 0; tick < GROWN; tick++) {
        painting_tick(painting);
    }
    struct action dry = action_default(ACTION_DRY);
    dry.amount = 0.5f;
    painting_act(painting, &dry);
    return painting;
}

static struct action disc(float radius)
{
    struct action rinse = action_default(ACTION_RINSE);
    rinse.at = (struct point){0.5f, 0.5f};
    rinse.has_at = true;
    rinse.radius = radius;
    return rinse;
}

struct pigment {
    double sum, x, y; /* all of it; its middle, cells */
};

static struct pigment pigment_of(const struct painting *painting)
{
    static float plane[CELLS];
    struct pigment pigment = {0};
    for (int field = PAINTING_WET; field < PAINTING_DRY + PAINTING_INKS; field++) {
        painting_read(painting, (enum painting_field)field, plane);
        for (int i = 0; i < CELLS; i++) {
            pigment.sum += (double)plane[i];
            pigment.x += (double)plane[i] * (i % SIZE);
            int row = i / SIZE;
            pigment.y += (double)plane[i] * row;
        }
    }
    pigment.x /= pigment.sum;
    pigment.y /= pigment.sum;
    return pigment;
}

/* Ink goes where the water goes, and gets less. */
static void ink_runs_along_the_flow(void **state)
{
    (void)state;
    static const struct point FLOWS[] = {{1, 0}, {-0.5f, 0}, {0, -1}, {0, 0}, {0.7f, 0.7f}};
    for (size_t i = 0; i < sizeof FLOWS / sizeof FLOWS[0]; i++) {
        struct painting *painting = grow(1, false);
        struct pigment before = pigment_of(painting);
        struct action rinse = disc(60);
        rinse.flow = FLOWS[i];
        for (int tick = 0; tick < 20; tick++) {
            painting_act(painting, &rinse);
            painting_tick(painting);
        }
        struct pigment after = pigment_of(painting);
        double length = hypot((double)FLOWS[i].x, (double)FLOWS[i].y);
        double u = length > 0 ? (double)FLOWS[i].x / length : 0, v = length > 0 ? (double)FLOWS[i].y / length : 1;
        double x = after.x - before.x, y = after.y - before.y;
        assert_true(x * u + y * v > 2);
        assert_true(fabs(x * v - y * u) < 1.5);
        assert_true(after.sum < 0.9 * before.sum && after.sum > 0.2 * before.sum);
        painting_destroy(painting);
    }
}

static void strength_is_how_much_goes(void **state)
{
    (void)state;
    double left = 1e9;
    for (int step = 0; step <= 4; step++) {
        struct painting *painting = grow(1, false);
        double carved = painting_totals(painting).carved;
        uint64_t hash = painting_hash(painting);
        struct action rinse = disc(60);
        rinse.strength = 0.25f * (float)step;
        painting_act(painting, &rinse);
        struct pigment after = pigment_of(painting);
        assert_true(after.sum < left);
        left = after.sum;
        if (step == 0) { /* but in the middle, where the last of it begins */
            assert_true(painting_totals(painting).carved > 0.8 * carved && hash != painting_hash(painting));
        }
        painting_destroy(painting);
    }
}

static void what_leaves_is_counted(void **state)
{
    (void)state;
    struct painting *painting = grow(1, false);
    struct painting_totals before = painting_totals(painting);
    struct action rinse = action_default(ACTION_RINSE);
    rinse.reach = 1;
    rinse.vary = 0;
    for (int step = 0; step < 2; step++) {
        struct point front[] = {{0, 1.0f + 0.25f * (float)step}, {1, 1.0f + 0.25f * (float)step}};
        rinse.path = (struct action_path){front, 2};
        painting_act(painting, &rinse); /* the lower half, then the upper: no tick between */
    }
    struct painting_totals after = painting_totals(painting);
    double water = after.ink + after.ink_dried - before.ink - before.ink_dried;
    assert_true(fabs(after.solvent + after.solvent_evaporated - before.solvent - before.solvent_evaporated) <
                1e-3 * before.solvent);
    assert_true(after.solvent_evaporated > before.solvent_evaporated + 0.5 * before.solvent);
    /* All that is more is water that came: RINSE_WATER in a cell, twice at the most. */
    assert_true(water > 0 && water < 2 * (double)RINSE_WATER * (SIZE + 10) * (SIZE + 10));
    painting_destroy(painting);
}

static void nothing_comes_of_no_place(void **state)
{
    (void)state;
    struct painting *painting = grow(1, false);
    uint64_t hash = painting_hash(painting);
    struct action rinse = action_default(ACTION_RINSE);
    painting_act(painting, &rinse);
    static const struct point ABOVE[] = {{0, -1}, {0.5f, -0.9f}, {1, -1}};
    rinse.path = (struct action_path){ABOVE, 3};
    painting_act(painting, &rinse);
    assert_true(painting_hash(painting) == hash);
    painting_destroy(painting);
}

/* Any number, and points in any order, too many, or one. */
static void nonsense_does_no_harm(void **state)
{
    (void)state;
    static const float ODD[] = {NAN, INFINITY, -INFINITY, 1e30f, -1e30f, 0.5f, 0};
    enum { ODDS = sizeof ODD / sizeof ODD[0], POINTS = 40 };
    struct point points[POINTS];
    struct painting *painting = grow(1, false);
    for (int i = 0; i < ODDS * ODDS; i++) {
        struct action rinse = action_default(ACTION_RINSE);
        for (int k = 0; k < POINTS; k++) {
            points[k] = (struct point){ODD[(i + k) % ODDS], ODD[(i / ODDS + 3 * k) % ODDS]};
        }
        rinse.path = (struct action_path){points, i % 3 == 0 ? POINTS : i % 3};
        rinse.at = points[1];
        rinse.has_at = i % 2;
        rinse.flow = points[2];
        rinse.radius = rinse.reach = rinse.strength = rinse.vary = ODD[i % ODDS];
        painting_act(painting, &rinse);
        painting_tick(painting);
        struct painting_totals totals = painting_totals(painting);
        assert_true(isfinite(totals.ink) && isfinite(totals.carved) && isfinite(totals.catalyst));
        assert_true(totals.ink >= 0 && totals.ink < 1e5 && totals.carved >= 0);
    }
    painting_destroy(painting);
}

/* However many threads there are, and whatever sleeps. */
static void gives_the_same_bits(void **state)
{
    (void)state;
    uint64_t hashes[3];
    for (int i = 0; i < 3; i++) {
        struct painting *painting = grow(i + 1, i == 2);
        for (int tick = 0; tick < 40; tick++) {
            struct point front[] = {{0, 0.02f * (float)tick}, {0.6f, 0.03f * (float)tick}, {1, 0.02f * (float)tick}};
            struct action rinse = action_default(ACTION_RINSE);
            rinse.path = (struct action_path){front, 3};
            painting_act(painting, &rinse);
            painting_tick(painting);
        }
        hashes[i] = painting_hash(painting);
        painting_destroy(painting);
    }
    assert_true(hashes[0] == hashes[1] && hashes[0] == hashes[2]);
}

/* Under the last of the water all that was stamped, guided and closed is as at first; ahead of it nothing is. */
static void ground_is_fresh_behind_it(void **state)
{
    (void)state;
    struct painting *painting = grow(1, false);
    static float plane[CELLS], fresh[CELLS];
    struct painting_def def = painting_get_def(painting);
    struct painting *other = painting_create(&def);
    assert_non_null(other);
    struct action act = action_default(ACTION_DROP);
    act.at = (struct point){0.5f, 0.5f};
    act.brush = brush_find("fern");
    painting_act(painting, &act);
    act = action_default(ACTION_MASK);
    act.at = (struct point){0.5f, 0.5f};
    act.has_at = true;
    act.radius = 200;
    painting_act(painting, &act);
    static const struct point FRONT[] = {{0, 0.9f}, {1, 0.9f}};
    struct action rinse = action_default(ACTION_RINSE);
    rinse.path = (struct action_path){FRONT, 2};
    rinse.reach = 0.5f;
    rinse.vary = 0;
    painting_act(painting, &rinse); /* over are rows from .25 to .4 of the sheet */
    for (int field = PAINTING_GUIDE_U; field < PAINTING_FIELDS; field++) {
        painting_read(painting, (enum painting_field)field, plane);
        painting_read(other, (enum painting_field)field, fresh);
        int behind = 0, ahead = 0;
        for (int i = 0; i < CELLS; i++) {
            int row = i / SIZE;
            behind += row > SIZE * 27 / 100 && row < SIZE * 39 / 100 && plane[i] != fresh[i];
            ahead += row > SIZE * 45 / 100 && plane[i] != fresh[i];
        }
        assert_int_equal(behind, 0);
        assert_true(field != PAINTING_MASK || ahead > CELLS / 2);
        assert_true(field != PAINTING_ALPHA_A || ahead > CELLS / 8);
    }
    painting_destroy(painting);
    painting_destroy(other);
}

/* The phase of a cell never falls while the front goes on, and has no leaps from cell to cell. */
static void the_front_is_ragged_and_still(void **state)
{
    (void)state;
    static float phases[CELLS];
    struct painting_def def = painting_default_def();
    def.width = def.height = SIZE;
    for (int i = 0; i < CELLS; i++) {
        phases[i] = 0;
    }
    int ragged = 0;
    for (int step = 0; step < 30; step++) {
        struct point front[] = {{0, 0.03f * (float)step}, {1, 0.03f * (float)step}};
        struct action action = action_default(ACTION_RINSE);
        action.path = (struct action_path){front, 2};
        action.reach = 1;
        action.vary = 0.5f;
        struct rinse rinse;
        struct canvas canvas = painting_canvas(&def);
        rinse_begin(&rinse, &canvas, &action);
        for (int y = 0; y < SIZE; y++) {
            float turn, least = 1, most = 0, last = 0;
            for (int x = 0; x < SIZE; x++) {
                float phase = rinse_phase(&rinse, x, y, &turn);
                assert_true(phase >= phases[y * SIZE + x] && phase <= 1 && fabsf(turn) <= 1);
                assert_true(x == 0 || fabsf(phase - last) < 0.15f);
                phases[y * SIZE + x] = last = phase;
                least = fminf(least, phase);
                most = fmaxf(most, phase);
            }
            ragged += most - least > 0.2f;
        }
    }
    assert_true(ragged > 200);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ink_runs_along_the_flow),   cmocka_unit_test(strength_is_how_much_goes),
        cmocka_unit_test(what_leaves_is_counted),    cmocka_unit_test(nothing_comes_of_no_place),
        cmocka_unit_test(nonsense_does_no_harm),     cmocka_unit_test(gives_the_same_bits),
        cmocka_unit_test(ground_is_fresh_behind_it), cmocka_unit_test(the_front_is_ragged_and_still),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
