/* Contacts as an oscilloscope sees them: times in us and levels go in, clean transitions must come out. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>

#include "debounce.h"

enum { SETTLE_US = 5000 };

struct edge {
    uint64_t time_us;
    bool level;
};

struct heard {
    struct transition transitions[16];
    int count;
};

static void hear(struct heard *heard, bool there, struct transition transition)
{
    if (there) {
        assert_true(heard->count < 16);
        heard->transitions[heard->count++] = transition;
    }
}

/* Plays a trace, with a look at the clock every `look_us` (0: only when a transition is due), up to `end_us`. */
static struct heard play(struct debounce *debounce, const struct edge *edges, int count, uint64_t look_us,
                         uint64_t end_us)
{
    struct heard heard = {.count = 0};
    struct transition transition = {0, false};
    uint64_t look = look_us;
    for (int i = 0; i <= count; i++) {
        uint64_t until = i < count ? edges[i].time_us : end_us;
        for (; look_us > 0 && look < until; look += look_us) {
            hear(&heard, debounce_time(debounce, look, &transition), transition);
        }
        uint64_t due = debounce_due_us(debounce);
        if (look_us == 0 && due > 0 && due < until) {
            hear(&heard, debounce_time(debounce, due, &transition), transition);
        }
        if (i < count) {
            hear(&heard, debounce_edge(debounce, edges[i].time_us, edges[i].level, &transition), transition);
        }
    }
    hear(&heard, debounce_time(debounce, end_us, &transition), transition);
    return heard;
}

#define PLAY(debounce, edges, look_us, end_us)                                                                         \
    play(debounce, edges, (int)(sizeof(edges) / sizeof((edges)[0])), look_us, end_us)

static void assert_transition(const struct heard *heard, int number, uint64_t time_us, bool level)
{
    assert_true(number < heard->count);
    assert_int_equal(heard->transitions[number].time_us, time_us);
    assert_int_equal(heard->transitions[number].level, level);
}

/* A worn microswitch: 4.7 ms of bounce going down, 2.1 ms coming up. */
static const struct edge worn[] = {
    {100000, true}, {100090, false}, {100310, true}, {100350, false}, {100880, true}, {101400, false},
    {101430, true}, {102900, false}, {103100, true}, {104650, false}, {104700, true}, {230000, false},
    {230020, true}, {230700, false}, {230750, true}, {232100, false},
};

static void a_train_of_bounces_is_one_transition_at_its_first_edge(void **state)
{
    (void)state;
    static const uint64_t looks[] = {0, 137, 1000, 16667};
    for (int i = 0; i < 4; i++) {
        struct debounce debounce;
        debounce_init(&debounce, SETTLE_US, false);
        struct heard heard = PLAY(&debounce, worn, looks[i], 300000);
        assert_int_equal(heard.count, 2);
        assert_transition(&heard, 0, 100000, true);
        assert_transition(&heard, 1, 230000, false);
        assert_int_equal(debounce_due_us(&debounce), 0);
    }
}

static void edges_alone_are_enough_when_nobody_looked_at_the_clock(void **state)
{
    (void)state;
    struct debounce debounce;
    debounce_init(&debounce, SETTLE_US, false);
    struct transition transition = {0, false};
    int heard = 0;
    for (int i = 0; i < 16; i++) {
        if (debounce_edge(&debounce, worn[i].time_us, worn[i].level, &transition)) {
            heard++;
            assert_int_equal(transition.time_us, 100000);
            assert_true(transition.level);
            assert_int_equal(worn[i].time_us, 230000); /* the first edge after it had settled */
        }
    }
    assert_int_equal(heard, 1);
    assert_false(debounce_time(&debounce, 237099, &transition));
    assert_true(debounce_time(&debounce, 237100, &transition));
    assert_int_equal(transition.time_us, 230000);
    assert_false(transition.level);
}

static void a_glitch_is_nothing(void **state)
{
    (void)state;
    /* A relay next door: spikes of 2 us to 1.5 ms, and one in the middle of a press. */
    static const struct edge spikes[] = {
        {10000, true}, {10002, false},  {50000, true},  {51500, false},
        {90000, true}, {120000, false}, {120400, true}, {180000, false},
    };
    struct debounce debounce;
    debounce_init(&debounce, SETTLE_US, false);
    struct heard heard = PLAY(&debounce, spikes, 0, 200000);
    assert_int_equal(heard.count, 2);
    assert_transition(&heard, 0, 90000, true);
    assert_transition(&heard, 1, 180000, false);
}

static void a_slow_edge_waits_until_it_is_over(void **state)
{
    (void)state;
    /* A long cable: the level crosses the threshold for 18 ms, with less than 5 ms between any two crossings. */
    static const struct edge slow[] = {
        {1000, true}, {4900, false}, {9100, true}, {9700, false}, {14000, true}, {18900, false}, {19000, true},
    };
    struct debounce debounce;
    debounce_init(&debounce, SETTLE_US, false);
    struct heard heard = PLAY(&debounce, slow, 500, 23999);
    assert_int_equal(heard.count, 0);
    struct transition transition;
    assert_true(debounce_time(&debounce, 24000, &transition));
    assert_int_equal(transition.time_us, 1000);
}

static void without_settling_every_change_counts_and_no_repetition_does(void **state)
{
    (void)state;
    static const struct edge twice[] = {{10, true}, {20, true}, {30, false}, {30, true}, {40, false}, {50, false}};
    struct debounce debounce;
    debounce_init(&debounce, 0, false);
    struct heard heard = PLAY(&debounce, twice, 0, 100);
    assert_int_equal(heard.count, 4);
    assert_transition(&heard, 0, 10, true);
    assert_transition(&heard, 1, 30, false);
    assert_transition(&heard, 2, 30, true);
    assert_transition(&heard, 3, 40, false);
}

static void a_level_that_was_read_mends_a_lost_edge(void **state)
{
    (void)state;
    /* The kernel kept the first edges of the bounce and dropped the last, which came up again. */
    static const struct edge kept[] = {{1000, true}, {1100, false}, {1200, true}};
    struct debounce debounce;
    debounce_init(&debounce, SETTLE_US, false);
    struct heard heard = PLAY(&debounce, kept, 0, 2000);
    struct transition transition;
    assert_int_equal(heard.count, 0);
    assert_false(debounce_edge(&debounce, 3000, false, &transition)); /* as read */
    assert_false(debounce_time(&debounce, 1000000, &transition));

    /* And a release of which no edge came at all. */
    assert_false(debounce_edge(&debounce, 2000000, true, &transition));
    assert_true(debounce_time(&debounce, 2005000, &transition));
    assert_false(debounce_edge(&debounce, 3000000, false, &transition));
    assert_true(debounce_time(&debounce, 3005000, &transition));
    assert_false(transition.level);
}

static void edges_that_come_out_of_order_do_not_turn_time_back(void **state)
{
    (void)state;
    struct debounce debounce;
    struct transition transition;
    debounce_init(&debounce, SETTLE_US, false);
    assert_false(debounce_edge(&debounce, 10000, true, &transition));
    assert_false(debounce_edge(&debounce, 9000, false, &transition));
    assert_false(debounce_edge(&debounce, 9500, true, &transition));
    assert_int_equal(debounce_due_us(&debounce), 15000);
    assert_true(debounce_time(&debounce, 15000, &transition));
    assert_int_equal(transition.time_us, 10000);
}

/* Noise for two seconds, then silence: the end is never lost, whatever it is, and in the noise nothing is reported. */
static void a_storm_ends_with_the_level_that_is_left(void **state)
{
    (void)state;
    for (int last = 0; last < 2; last++) {
        struct debounce debounce;
        struct transition transition;
        uint64_t now = 0;
        debounce_init(&debounce, SETTLE_US, false);
        for (int i = 0; i < 2000; i++) {
            now += 400 + (uint64_t)(i * 7919 % 1200);
            assert_false(debounce_edge(&debounce, now, i % 2 == last, &transition));
        }
        assert_true(debounce_restless_us(&debounce, now) > 1500000);
        bool level = 1999 % 2 == last;
        assert_int_equal(debounce_time(&debounce, now + SETTLE_US, &transition), level);
        assert_int_equal(debounce.stable, level);
        assert_int_equal(debounce_restless_us(&debounce, now + SETTLE_US), 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_train_of_bounces_is_one_transition_at_its_first_edge),
        cmocka_unit_test(edges_alone_are_enough_when_nobody_looked_at_the_clock),
        cmocka_unit_test(a_glitch_is_nothing),
        cmocka_unit_test(a_slow_edge_waits_until_it_is_over),
        cmocka_unit_test(without_settling_every_change_counts_and_no_repetition_does),
        cmocka_unit_test(a_level_that_was_read_mends_a_lost_edge),
        cmocka_unit_test(edges_that_come_out_of_order_do_not_turn_time_back),
        cmocka_unit_test(a_storm_ends_with_the_level_that_is_left),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
