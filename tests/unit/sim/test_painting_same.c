/* The same bits whatever computes them: vectors, sleep, threads. Long runs; test_painting.c has short ones. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "busy.h"
#include "painting.h"

/* A change of the model changes it: set it anew from what the test prints. */
#define GOLDEN_BUSY 0x201c19ce56aa36e4u

static void act_on(void *painting, const struct action *action)
{
    painting_act(painting, action);
}

static uint64_t busy_hash(struct painting_def def)
{
    struct busy busy;
    busy_init(&busy);
    struct painting *painting = painting_create(&def);
    assert_non_null(painting);
    for (int tick = 0; tick < BUSY_TICKS; tick++) {
        busy_act(&busy, tick, act_on, painting);
        painting_tick(painting);
    }
    uint64_t hash = painting_hash(painting);
    painting_destroy(painting);
    return hash;
}

static void is_the_same_for_every_vector(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    uint64_t best = busy_hash(def);
    if (best != GOLDEN_BUSY) {
        fail_msg("a busy sheet: 0x%016llx", (unsigned long long)best);
    }
    for (int vectors = VECTORS_NARROW; vectors <= VECTORS_AVX512; vectors++) {
        def.vectors = (enum vectors)vectors;
        assert_true(busy_hash(def) == best);
    }
}

static void is_the_same_dense_or_asleep(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    def.dense = true;
    assert_true(busy_hash(def) == GOLDEN_BUSY);
}

static void is_the_same_for_any_number_of_threads(void **state)
{
    (void)state;
    for (int threads = 2; threads <= 7; threads += 5) {
        struct painting_def def = busy_def();
        def.threads = threads;
        assert_true(busy_hash(def) == GOLDEN_BUSY);
    }
}

/* Long enough for ink to be carried along the upper edge, beyond which there is nothing to ask. */
static void is_the_same_at_the_edge_for_any_number_of_threads(void **state)
{
    (void)state;
    enum { TICKS = 520 };
    uint64_t hashes[2];
    for (int i = 0; i < 2; i++) {
        struct painting_def def = busy_def();
        struct busy busy;
        def.threads = i == 0 ? 1 : 5;
        busy_init(&busy);
        struct painting *painting = painting_create(&def);
        assert_non_null(painting);
        for (int tick = 0; tick < TICKS; tick++) {
            busy_act(&busy, tick, act_on, painting);
            painting_tick(painting);
        }
        hashes[i] = painting_hash(painting);
        painting_destroy(painting);
    }
    assert_true(hashes[0] == hashes[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(is_the_same_for_every_vector),
        cmocka_unit_test(is_the_same_dense_or_asleep),
        cmocka_unit_test(is_the_same_for_any_number_of_threads),
        cmocka_unit_test(is_the_same_at_the_edge_for_any_number_of_threads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
