/* Rotary encoders: the levels of two lines go in, with all that real contacts do; detents must come out. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>

#include "encoder.h"

/* Clockwise, A before B. */
static const unsigned circle[4] = {0, 2, 3, 1};

struct turned {
    struct encoder encoder;
    uint64_t now_us;
    int place;     /* on the circle */
    int sum, most; /* of detents; the most at once, either way */
};

static void start(struct turned *turned, int steps, int place)
{
    *turned = (struct turned){.place = place};
    encoder_init(&turned->encoder, steps, circle[place] >> 1, circle[place] & 1);
}

static void levels(struct turned *turned, uint64_t after_us, unsigned state)
{
    turned->now_us += after_us;
    int detents = encoder_levels(&turned->encoder, turned->now_us, state >> 1, state & 1);
    turned->sum += detents;
    turned->most = abs(detents) > turned->most ? abs(detents) : turned->most;
}

/* One step; the line that changes bounces so many times on its way. */
static void step(struct turned *turned, int way, int bounces, uint64_t after_us)
{
    unsigned from = circle[turned->place], to = circle[(turned->place + way + 4) % 4];
    turned->place = (turned->place + way + 4) % 4;
    levels(turned, after_us, to);
    for (int i = 0; i < bounces; i++) {
        levels(turned, 40 + (uint64_t)i * 90, from);
        levels(turned, 25 + (uint64_t)i * 60, to);
    }
}

static void detents(struct turned *turned, int count, int bounces, uint64_t after_us)
{
    for (int i = 0; i < abs(count) * turned->encoder.steps; i++) {
        step(turned, count < 0 ? -1 : 1, bounces, after_us);
    }
}

static void every_kind_counts_its_detents(void **state)
{
    (void)state;
    static const int kinds[] = {1, 2, 4};
    for (int k = 0; k < 3; k++) {
        for (int place = 0; place < 4; place++) {
            struct turned turned;
            start(&turned, kinds[k], place);
            detents(&turned, 10, 0, 5000);
            assert_int_equal(turned.sum, 10);
            detents(&turned, -25, 0, 5000);
            assert_int_equal(turned.sum, -15);
            assert_int_equal(turned.most, 1);
            assert_int_equal(turned.encoder.errors, 0);
        }
    }
}

static void bounce_on_both_lines_adds_nothing(void **state)
{
    (void)state;
    for (int steps = 2; steps <= 4; steps += 2) {
        for (int bounces = 1; bounces < 8; bounces++) {
            struct turned turned;
            start(&turned, steps, 0);
            detents(&turned, 7, bounces, 3000);
            assert_int_equal(turned.sum, 7);
            detents(&turned, -3, bounces, 3000);
            assert_int_equal(turned.sum, 4);
            assert_int_equal(turned.encoder.errors, 0);
        }
    }
    struct turned turned; /* where every step is a detent, bounce comes out there and back */
    start(&turned, 1, 0);
    detents(&turned, 9, 3, 3000);
    assert_int_equal(turned.sum, 9);
}

/* A contact on the edge of its detent, for as long as somebody leans on the table. */
static void chatter_around_the_detent_is_nothing(void **state)
{
    (void)state;
    for (int place = 0; place < 4; place++) {
        struct turned turned;
        start(&turned, 4, place);
        for (int i = 0; i < 1000; i++) {
            step(&turned, i % 2 == 0 ? 1 : -1, 0, 700);
        }
        for (int i = 0; i < 1000; i++) {
            step(&turned, i % 2 == 0 ? -1 : 1, 0, 700);
        }
        assert_int_equal(turned.most, 0);
    }
}

static void a_turn_back_half_way_is_nothing(void **state)
{
    (void)state;
    struct turned turned;
    start(&turned, 4, 0);
    for (int far = 1; far < 4; far++) {
        for (int way = -1; way <= 1; way += 2) {
            for (int i = 0; i < far; i++) {
                step(&turned, way, 2, 4000);
            }
            for (int i = 0; i < far; i++) {
                step(&turned, -way, 2, 4000);
            }
        }
    }
    assert_int_equal(turned.most, 0);
    /* And one that goes on to the detent behind is one the other way. */
    step(&turned, 1, 1, 4000);
    step(&turned, 1, 1, 4000);
    for (int i = 0; i < 6; i++) {
        step(&turned, -1, 1, 4000);
    }
    assert_int_equal(turned.sum, -1);
}

/* Twenty turns a second of 24 detents: a step every half millisecond, and some of them are lost. */
static void a_fast_spin_may_lose_steps_but_not_its_way(void **state)
{
    (void)state;
    struct turned turned;
    start(&turned, 4, 0);
    for (int i = 0; i < 240 * 4; i++) {
        turned.place = (turned.place + 1) % 4;
        if (i % 10 != 9) { /* every tenth is not seen, the next shows both lines changed */
            levels(&turned, 520, circle[turned.place]);
        }
    }
    levels(&turned, 520, circle[turned.place]);
    assert_in_range(turned.encoder.errors, 90, 96);
    assert_in_range(turned.sum, 238, 240);
    /* Back in a detent nothing is left over: as many clicks as fingers feel. */
    int sum = turned.sum;
    detents(&turned, -5, 0, 5000);
    assert_int_equal(turned.sum, sum - 5);
}

/* So fast that only every second step is seen: once it is known which way, that is enough. */
static void half_of_the_steps_tell_the_way_when_it_was_known(void **state)
{
    (void)state;
    for (int way = -1; way <= 1; way += 2) {
        struct turned turned;
        start(&turned, 4, 0);
        detents(&turned, way, 0, 5000);
        for (int i = 0; i < 20; i++) {
            turned.place = (turned.place + 2) % 4;
            levels(&turned, 500, circle[turned.place]);
        }
        assert_int_equal(turned.sum, way * 11);
        assert_int_equal(turned.encoder.errors, 20);
    }
}

static void one_lost_step_in_a_detent_costs_nothing(void **state)
{
    (void)state;
    for (int lost = 1; lost < 4; lost++) {
        struct turned turned;
        start(&turned, 4, 0);
        detents(&turned, 2, 0, 5000);
        for (int i = 1; i <= 4; i++) {
            turned.place = (turned.place + 1) % 4;
            if (i != lost) {
                levels(&turned, 5000, circle[turned.place]);
            }
        }
        assert_int_equal(turned.sum, 3);
        assert_int_equal(turned.encoder.errors, 1);
        detents(&turned, -3, 0, 5000);
        assert_int_equal(turned.sum, 0);
    }
}

/* Where every step is a detent no rest makes up for a lost one: it counts as it was, the way of the last. */
static void a_lost_step_is_counted_where_every_step_is_a_detent(void **state)
{
    (void)state;
    for (int way = -1; way <= 1; way += 2) {
        struct turned turned;
        start(&turned, 1, 0);
        detents(&turned, way, 0, 5000);
        turned.place = (turned.place + 2 + 4) % 4;
        levels(&turned, 5000, circle[turned.place]);
        assert_int_equal(turned.sum, 3 * way);
        assert_int_equal(turned.encoder.errors, 1);
    }
}

/* Frond started while somebody turned: it takes the wrong place for the detent, and finds out. */
static void the_place_of_rest_is_learnt(void **state)
{
    (void)state;
    struct turned turned;
    start(&turned, 4, 0);
    step(&turned, 1, 0, 5000);
    step(&turned, 1, 0, 5000); /* the true detent */
    for (int i = 0; i < 4; i++) {
        step(&turned, 1, 0, 900000);
        step(&turned, 1, 0, 5000);
        step(&turned, 1, 0, 5000);
        step(&turned, 1, 0, 5000);
    }
    assert_int_equal(turned.encoder.rest, circle[2]);
    /* From now on chatter where it was thought to rest makes nothing, and a detent is one where the fingers feel it. */
    int sum = turned.sum;
    for (int i = 0; i < 100; i++) {
        step(&turned, 1, 0, 5000);
        step(&turned, 1, 0, 5000);
        step(&turned, -1, 0, 5000);
        step(&turned, -1, 0, 5000);
    }
    assert_int_equal(turned.sum, sum);
    detents(&turned, 1, 0, 5000);
    assert_int_equal(turned.sum, sum + 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_counts_its_detents),
        cmocka_unit_test(bounce_on_both_lines_adds_nothing),
        cmocka_unit_test(chatter_around_the_detent_is_nothing),
        cmocka_unit_test(a_turn_back_half_way_is_nothing),
        cmocka_unit_test(a_fast_spin_may_lose_steps_but_not_its_way),
        cmocka_unit_test(half_of_the_steps_tell_the_way_when_it_was_known),
        cmocka_unit_test(one_lost_step_in_a_detent_costs_nothing),
        cmocka_unit_test(a_lost_step_is_counted_where_every_step_is_a_detent),
        cmocka_unit_test(the_place_of_rest_is_learnt),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
