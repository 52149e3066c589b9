/* Frost and drying: all of the sheet is hidden at the end of what comes, nothing of it at the end of what leaves, each
 * step hides more than the one before, and the same seed is the same picture. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "first_passage.h"
#include "flash.h"
#include "transition.h"

#include <float.h>
#include <math.h>

enum { WIDTH = 240, HEIGHT = 150, PIXELS = WIDTH * HEIGHT, FRAMES_A_SECOND = 30, SECONDS = 3 };

static const enum transition_kind KINDS[] = {TRANSITION_DRY, TRANSITION_FREEZE};

static void make(struct transition *transition, enum transition_kind kind, uint32_t seed)
{
    assert_true(transition_init(transition, kind, seed, WIDTH, HEIGHT));
}

static void reveal(const struct transition *transition, double share, uint8_t *rgb, int below)
{
    memset(rgb, below, 3 * PIXELS);
    assert_true(transition_reveal(transition, share, rgb));
}

/* All that is laid over black and over white alike is hidden. */
static int count_hidden(const struct transition *transition, double share, int most_apart)
{
    static uint8_t dark[3 * PIXELS], light[3 * PIXELS];
    int hidden = 0;
    reveal(transition, share, dark, 0);
    reveal(transition, share, light, 255);
    for (int i = 0; i < PIXELS; i++) {
        hidden += light[3 * i] - dark[3 * i] <= most_apart;
    }
    return hidden;
}

static void it_hides_all_and_then_nothing(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        struct transition transition;
        make(&transition, KINDS[k], 4);
        for (int i = 0; i < PIXELS; i++) {
            assert_true(transition.over.birth[i] >= 0 && transition.away.birth[i] >= 0);
            assert_true(transition.over.birth[i] <= TRANSITION_TICKS - PLATE_SOFT);
            assert_true(transition.away.birth[i] <= TRANSITION_TICKS - PLATE_SOFT);
        }
        assert_int_equal(count_hidden(&transition, 1, 0), PIXELS);
        assert_int_equal(count_hidden(&transition, 0, 254), 0);
        assert_int_equal(count_hidden(&transition, 2, 254), 0);
        transition_finish(&transition);
        transition_finish(&transition);
        assert_null(transition.over.rgba);
    }
}

static void each_step_hides_more_and_then_less(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        struct transition transition;
        make(&transition, KINDS[k], 5);
        int before = 0, after = 0, half = 0;
        for (int step = 0; step <= 20; step++) {
            int come = count_hidden(&transition, 0.05 * step, 230),
                left = count_hidden(&transition, 2 - 0.05 * step, 230);
            assert_true(come >= before && left >= after);
            half = step == 8 ? come : half;
            before = come;
            after = left;
        }
        assert_true(half > PIXELS / 4 && half < 3 * PIXELS / 4); /* covered at one speed */
        transition_finish(&transition);
    }
}

/* It begins at the borders, and where it melts or is wetted first is not there. */
static void it_comes_from_the_borders_and_leaves_from_within(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        struct transition transition;
        make(&transition, KINDS[k], 6);
        double border = 0, middle = 0, away_border = 0, away_middle = 0;
        int borders = 0, middles = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                bool edge = x < 8 || y < 8 || x >= WIDTH - 8 || y >= HEIGHT - 8;
                bool inner = x > WIDTH / 4 && x < 3 * WIDTH / 4 && y > HEIGHT / 4 && y < 3 * HEIGHT / 4;
                int i = y * WIDTH + x;
                border += edge ? (double)transition.over.birth[i] : 0;
                away_border += edge ? (double)transition.away.birth[i] : 0;
                middle += inner ? (double)transition.over.birth[i] : 0;
                away_middle += inner ? (double)transition.away.birth[i] : 0;
                borders += edge;
                middles += inner;
            }
        }
        assert_true(border / borders + 15 < middle / middles);
        assert_true(away_border / borders + 15 < away_middle / middles); /* backwards: the later is gone the sooner */
        transition_finish(&transition);
    }
}

static uint64_t hash(const void *bytes, size_t size, uint64_t from)
{
    for (size_t i = 0; i < size; i++) {
        from = (from ^ ((const uint8_t *)bytes)[i]) * UINT64_C(0x100000001b3);
    }
    return from;
}

static uint64_t hash_of(const struct transition *transition)
{
    uint64_t sum = UINT64_C(0xcbf29ce484222325);
    for (int i = 0; i < 2; i++) {
        const struct plate *plate = i ? &transition->away : &transition->over;
        sum = hash(plate->birth, PIXELS * sizeof *plate->birth, sum);
        sum = hash(plate->rgba, (size_t)PIXELS * 4, sum);
    }
    return sum;
}

static void a_seed_is_a_picture_on_every_machine(void **state)
{
    static const uint64_t GOLDEN[] = {UINT64_C(0x0f4113831d1aba15), UINT64_C(0x3ed8507cf9ecfe56)};
    (void)state;
    for (int k = 0; k < 2; k++) {
        struct transition one, other;
        make(&one, KINDS[k], 7);
        make(&other, KINDS[k], 8);
        if (hash_of(&one) != GOLDEN[k]) {
            print_error("%s: 0x%016llx\n", transition_names[KINDS[k]], (unsigned long long)hash_of(&one));
        }
        assert_true(hash_of(&one) == GOLDEN[k]);
        assert_true(hash_of(&other) != GOLDEN[k]);
        transition_finish(&one);
        transition_finish(&other);
    }
}

/* Over what is dark and what is light, in three seconds each way. */
static void nothing_of_it_flashes(void **state)
{
    static uint8_t rgb[3 * PIXELS];
    (void)state;
    for (int k = 0; k < 4; k++) {
        struct transition transition;
        struct flash *flash = flash_begin(WIDTH, HEIGHT);
        make(&transition, KINDS[k % 2], 9);
        for (int i = 0; i <= 2 * SECONDS * FRAMES_A_SECOND; i += 2) {
            reveal(&transition, (double)i / (SECONDS * FRAMES_A_SECOND), rgb, k < 2 ? 0 : 150);
            flash_frame(flash, rgb, (uint64_t)i * 1000000 / FRAMES_A_SECOND + 1);
        }
        struct flash_worst worst = flash_worst(flash);
        assert_true(worst.general <= 1 && worst.red == 0);
        assert_true(worst.mean_change < 0.75);
        flash_end(flash);
        transition_finish(&transition);
    }
}

static void a_wash_has_no_plates(void **state)
{
    (void)state;
    struct transition transition;
    assert_false(transition_init(&transition, TRANSITION_WASH, 1, WIDTH, HEIGHT));
    assert_null(transition.over.rgba);
}

/* The smallest sheets, and ones that are no window. */
static void every_shape_is_covered(void **state)
{
    static const int SIZES[][2] = {{1, 1}, {2, 200}, {700, 3}, {33, 900}};
    (void)state;
    for (size_t i = 0; i < sizeof SIZES / sizeof SIZES[0]; i++) {
        for (int k = 0; k < 2; k++) {
            struct transition transition;
            assert_true(transition_init(&transition, KINDS[k], 3, SIZES[i][0], SIZES[i][1]));
            for (int p = 0; p < SIZES[i][0] * SIZES[i][1]; p++) {
                assert_true(transition.over.birth[p] >= 0 && transition.over.birth[p] <= TRANSITION_TICKS);
                assert_int_equal(transition.away.rgba[4 * p + 3], 255);
            }
            transition_finish(&transition);
        }
    }
}

static void a_front_takes_the_quickest_way(void **state)
{
    static const float SLOW[] = {1, 1, 1, 9, 9, 1, 1, 1, 1};
    float arrival[9];
    (void)state;
    for (int i = 0; i < 9; i++) {
        arrival[i] = FLT_MAX;
    }
    arrival[0] = 2;
    assert_true(first_passage(3, 3, SLOW, arrival));
    assert_float_equal(arrival[1], 3, 1e-6);
    assert_float_equal(arrival[5], 3 + sqrtf(2), 1e-5);
    assert_float_equal(arrival[8], 4 + sqrtf(2), 1e-5);
    assert_float_equal(arrival[7], 3 + 2 * sqrtf(2), 1e-5);
    assert_float_equal(arrival[3], 7, 1e-5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_hides_all_and_then_nothing),
        cmocka_unit_test(each_step_hides_more_and_then_less),
        cmocka_unit_test(it_comes_from_the_borders_and_leaves_from_within),
        cmocka_unit_test(a_seed_is_a_picture_on_every_machine),
        cmocka_unit_test(nothing_of_it_flashes),
        cmocka_unit_test(a_wash_has_no_plates),
        cmocka_unit_test(every_shape_is_covered),
        cmocka_unit_test(a_front_takes_the_quickest_way),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
