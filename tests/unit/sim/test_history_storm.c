/* Anything by anybody: the same actions give the same painting, with a history beside it, for any number of threads. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "brush.h"
#include "coefficients.h"
#include "history_case.h"
#include "key.h"
#include "patience.h"
#include "vectors_seen.h"

/* The thread sanitizer takes forty times as long, and sees as much in a short storm. */
#ifdef SANITIZED_THREAD
enum { STORM_TICKS = 30 };
#else
enum { STORM_TICKS = 160 };
#endif

static uint32_t storms(void)
{
    return is_whole() ? 2 : 1;
}

static uint32_t next_random(uint32_t *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return *seed >> 8;
}

static struct point somewhere(uint32_t *seed)
{
    return (struct point){(float)(next_random(seed) % 1000) / 999, (float)(next_random(seed) % 1000) / 999};
}

/* Anything by anybody. */
static void act_at_random(struct sheet *sheet, uint32_t *seed)
{
    static const enum action_verb VERBS[] = {
        ACTION_DROP, ACTION_DROP, ACTION_BRUSH_SOLVENT, ACTION_BRUSH_INK, ACTION_DRAW,  ACTION_GUIDE, ACTION_POUR,
        ACTION_MASK, ACTION_DRY,  ACTION_WET,           ACTION_SET,       ACTION_UNDO,  ACTION_UNDO,  ACTION_UNDO,
        ACTION_REDO, ACTION_REDO, ACTION_REWIND,        ACTION_REWIND,    ACTION_UNMASK};
    struct point points[3] = {somewhere(seed), somewhere(seed), somewhere(seed)};
    struct action action = action_default(VERBS[next_random(seed) % (sizeof VERBS / sizeof VERBS[0])]);
    action.visitor = (int)(next_random(seed) % 6) - 1;
    action.at = points[0];
    action.has_at = next_random(seed) % 4 > 0;
    bool path = key_find(action_keys(action.verb), "path") && (!action.has_at || action.verb == ACTION_REWIND);
    action.path = (struct action_path){points, path ? 1 + (int)(next_random(seed) % 3) : 0};
    action.ink = (int)(next_random(seed) % 4);
    action.brush = action.verb == ACTION_DROP && next_random(seed) % 2 ? 2 : BRUSH_NONE;
    action.reach = 30;
    action.radius = 2 + (float)(next_random(seed) % 20);
    action.coefficient = (int)(key_find(coefficient_keys, "alpha_a") - coefficient_keys);
    action.value = 0.2f;
    act(sheet, &action);
}

static void storm(struct sheet *sheet, int ticks, uint32_t seed)
{
    for (int tick = 0; tick < ticks; tick++) {
        while (next_random(&seed) % 5 == 0) {
            act_at_random(sheet, &seed);
        }
        assert_true(history_used(sheet->history) <= 4 << 20);
        run(sheet, 1);
    }
}

static uint64_t storm_hash(int threads, bool dense, bool quick, uint32_t seed)
{
    struct painting_def def = sheet_def();
    struct history_def history = history_default_def();
    def.threads = threads;
    def.vectors = VECTORS_SEEN;
    def.dense = dense;
    history.bytes = quick ? 1 << 20 : 4 << 20;
    history.interval = quick ? 7 : 60;
    history.tiles_a_tick = quick ? 5 : 64;
    history.age = quick ? 100 : 7200;
    struct sheet sheet = sheet_make_of(&def, &history);
    storm(&sheet, quick ? STORM_TICKS + 100 : STORM_TICKS, seed);
    uint64_t hash = hash_of(&sheet);
    struct painting_totals totals = sheet.engine->ops->totals(sheet.engine);
    assert_true(isfinite(totals.solvent) && isfinite(totals.ink) && isfinite(totals.carved));
    assert_true(totals.solvent >= 0 && totals.ink >= 0);
    sheet_drop(&sheet);
    return hash;
}

/* The same actions at the same ticks: the same painting, for any number of threads, tiles asleep or awake. */
static void the_same_actions_give_the_same_painting(void **state)
{
    (void)state;
    for (uint32_t seed = 1; seed <= storms(); seed++) {
        uint64_t hash = storm_hash(1, false, false, seed);
        assert_true(storm_hash(4, false, false, seed) == hash);
        assert_true(storm_hash(2, true, false, seed) == hash);
    }
}

/* A store far too small, rounds that never end: much cannot be undone, and nothing else goes wrong. */
static void a_small_store_only_forgets(void **state)
{
    (void)state;
    for (uint32_t seed = 7; seed <= 7 + storms(); seed++) {
        assert_true(storm_hash(1, false, true, seed) == storm_hash(1, false, true, seed));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_same_actions_give_the_same_painting),
        cmocka_unit_test(a_small_store_only_forgets),
    };
#ifdef SANITIZED_THREAD
    if (!is_whole()) { /* the other has one thread */
        cmocka_set_test_filter("the_same_actions_give_the_same_painting");
    }
#endif
    return cmocka_run_group_tests(tests, NULL, NULL);
}
