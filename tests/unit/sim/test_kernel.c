/* Every copy of the row kernels gives the same bits, whatever the width of its vectors. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

#include "kernel.h"
#include "random.h"

enum { WIDTH = 208, COPIES = 3, ROOM = FLUID_FIELDS * RING };

/* Rows of noise with what kernels must decide about: zeros, thresholds, both signs. */
static void fill(float *values, int count, float least, float most, int stream)
{
    for (int i = 0; i < count; i++) {
        float t = random_unit(i, stream, 11, RANDOM_GRAIN);
        values[i] = i % 7 == 3 ? 0.0f : i % 11 == 5 ? 0.25f : least + t * (most - least);
    }
}

struct rows {
    float a[ROOM], b[ROOM], c[ROOM], rates[3][RATE_FIELDS * RING], gates[3][GATE_FIELDS * RING];
    float out[COPIES][ROOM], more[COPIES][FLOW_FIELDS * RING];
    int32_t changed[COPIES][RING];
    uint16_t maps[5][RING];
    uint8_t weight[RING];
};

static struct rows rows; /* too large for a stack; one test at a time */

static int copies(const struct kernels *found[COPIES])
{
    int count = 0;
    found[count++] = &kernels_narrow;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) {
        found[count++] = &kernels_avx2;
    }
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512dq")) {
        found[count++] = &kernels_avx512;
    }
#endif
    return count;
}

static int make_rows(void **state)
{
    (void)state;
    memset(&rows, 0, sizeof rows);
    fill(rows.a, ROOM, 0.0f, 1.2f, 1);
    fill(rows.b, ROOM, 0.0f, 1.2f, 2);
    fill(rows.c, ROOM, 0.0f, 1.2f, 3);
    for (int i = 0; i < 3; i++) {
        fill(rows.rates[i], RATE_FIELDS * RING, -0.3f, 0.2f, 4 + i);
        fill(rows.gates[i], GATE_FIELDS * RING, 0.0f, 1.0f, 7 + i);
    }
    for (int x = 0; x < RING; x++) {
        for (int map = 0; map < 5; map++) {
            rows.maps[map][x] = (uint16_t)random_bits(x, map, 5, RANDOM_GRAIN);
        }
        rows.weight[x] = (uint8_t)random_bits(x, 9, 5, RANDOM_GRAIN);
    }
    return 0;
}

static void assert_same(int count)
{
    for (int i = 1; i < count; i++) {
        assert_memory_equal(rows.out[0], rows.out[i], sizeof rows.out[0]);
        assert_memory_equal(rows.more[0], rows.more[i], sizeof rows.more[0]);
        assert_memory_equal(rows.changed[0], rows.changed[i], sizeof rows.changed[0]);
    }
    float any = 0.0f;
    for (int x = 0; x < ROOM; x++) {
        any += rows.out[0][x];
    }
    assert_true(any != 0.0f);
}

static void fluids_and_pigment(void **state)
{
    (void)state;
    const struct kernels *found[COPIES];
    int count = copies(found);
    for (int i = 0; i < count; i++) {
        struct fluid_row row = {0,
                                WIDTH,
                                rows.a + RING_LEAD,
                                rows.b + RING_LEAD,
                                rows.c + RING_LEAD,
                                rows.gates[0] + RING_LEAD,
                                rows.gates[1] + RING_LEAD,
                                rows.gates[2] + RING_LEAD,
                                rows.out[i] + RING_LEAD,
                                RING,
                                rows.more[i] + RING_LEAD,
                                rows.changed[i] + RING_LEAD,
                                0.5f,
                                2.0f,
                                0.1f,
                                1.5f * 1024};
        found[i]->fluid(&row);
        found[i]->pigment(&row);
    }
    assert_same(count);
    /* The last step of a tick computes the same, to rows as far apart as the painting's. */
    struct fluid_row row = {0,
                            WIDTH,
                            rows.a + RING_LEAD,
                            rows.b + RING_LEAD,
                            rows.c + RING_LEAD,
                            rows.gates[0] + RING_LEAD,
                            rows.gates[1] + RING_LEAD,
                            rows.gates[2] + RING_LEAD,
                            rows.out[1] + RING_LEAD,
                            RING,
                            rows.more[1] + RING_LEAD,
                            rows.changed[1] + RING_LEAD,
                            0.5f,
                            2.0f,
                            0.1f,
                            1.5f * 1024};
    memset(rows.out[1], 0, sizeof rows.out[1]);
    found[0]->fluid_last(&row);
    found[0]->pigment_last(&row);
    assert_memory_equal(rows.out[0], rows.out[1], sizeof rows.out[0]);
}

static void openness_and_gates(void **state)
{
    (void)state;
    const struct kernels *found[COPIES];
    int count = copies(found);
    for (int i = 0; i < count; i++) {
        struct open_row open = {0, WIDTH, rows.a, rows.b, rows.c, rows.out[i]};
        struct gates_row gates = {0, WIDTH, rows.rates[0] + RING_LEAD, rows.rates[1] + RING_LEAD,
                                  rows.out[i] + 3 * RING};
        found[i]->open(&open);
        found[i]->gates(&gates);
    }
    assert_same(count);
}

static void rates_of_growth(void **state)
{
    (void)state;
    const struct kernels *found[COPIES];
    int count = copies(found);
    for (int i = 0; i < count; i++) {
        struct rates_row row = {0,
                                WIDTH,
                                rows.a,
                                rows.maps[0],
                                rows.maps[1],
                                rows.maps[2],
                                rows.maps[3],
                                rows.maps[4],
                                rows.weight,
                                rows.out[i],
                                0.1f,
                                0.1f * UNIT_ALPHA_A,
                                0.1f * UNIT_BETA_A,
                                0.1f * UNIT_ALPHA_Y,
                                -1.0f};
        found[i]->rates(&row);
    }
    assert_same(count);
}

static struct pattern_row pattern_of(float *out, float *sums)
{
    return (struct pattern_row){.begin = 0,
                                .end = WIDTH,
                                .above = rows.a + RING_LEAD,
                                .here = rows.b + RING_LEAD,
                                .below = rows.c + RING_LEAD,
                                .rates_above = rows.rates[0] + RING_LEAD,
                                .rates = rows.rates[1] + RING_LEAD,
                                .rates_below = rows.rates[2] + RING_LEAD,
                                .out = out,
                                .sums = sums,
                                .keep = 0.985f,
                                .carve = 0.015f,
                                .consume = 0.2f,
                                .seam = 0.25f,
                                .guide = 0.19f};
}

static void pattern_with_and_without_everything(void **state)
{
    (void)state;
    const struct kernels *found[COPIES];
    int count = copies(found);
    for (int i = 0; i < count; i++) {
        struct pattern_row row = pattern_of(rows.out[i] + RING_LEAD, rows.more[i] + RING_LEAD);
        found[i]->pattern(&row);
        row.out += 5 * RING;
        found[i]->pattern_full(&row);
        found[i]->square(rows.a, rows.out[i] + 12 * RING, 0, WIDTH);
        found[i]->raise(rows.a, rows.out[i] + 14 * RING, 0, WIDTH, 2.3f);
    }
    assert_same(count);
}

/* On free ground the full kernel is the plain one: which of them runs may depend on the shape of a run. */
static void the_full_kernel_is_the_plain_one_on_free_ground(void **state)
{
    (void)state;
    const struct kernels *found[COPIES];
    int count = copies(found);
    for (int i = 0; i < 3; i++) {
        for (int x = 0; x < RING; x++) {
            rows.rates[i][RATE_OPEN * RING + x] = 1.0f;
            rows.rates[i][RATE_GUIDE_X * RING + x] = rows.rates[i][RATE_GUIDE_Y * RING + x] = 0.0f;
        }
    }
    for (int i = 0; i < count; i++) {
        struct pattern_row row = pattern_of(rows.out[0] + RING_LEAD, rows.more[0] + RING_LEAD);
        found[i]->pattern(&row);
        row.out = rows.out[1] + RING_LEAD;
        found[i]->pattern_full(&row);
        assert_memory_equal(rows.out[0], rows.out[1], sizeof rows.out[0]);
    }
}

static void ends_of_rows(void **state)
{
    (void)state;
    const struct kernels *found[COPIES];
    int count = copies(found);
    for (int i = 0; i < count; i++) {
        memcpy(rows.out[i], rows.b, sizeof rows.out[i]);
        struct pattern_end_row row = {0, WIDTH, RING, rows.a, rows.out[i], rows.changed[i]};
        found[i]->pattern_end(&row);
        memcpy(rows.more[i], rows.c, RING * sizeof(float));
        found[i]->fluid_end(rows.a, rows.more[i], rows.maps[3], rows.changed[i] + WIDTH, 0, WIDTH, 0.1f);
    }
    assert_same(count);
    int opened = 0, fed = 0;
    for (int x = 0; x < WIDTH; x++) {
        opened += (rows.changed[0][x] & PATTERN_OPENED) != 0;
        fed += rows.changed[0][WIDTH + x] != 0;
    }
    assert_true(opened > 100 && fed > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(fluids_and_pigment, make_rows),
        cmocka_unit_test_setup(openness_and_gates, make_rows),
        cmocka_unit_test_setup(rates_of_growth, make_rows),
        cmocka_unit_test_setup(pattern_with_and_without_everything, make_rows),
        cmocka_unit_test_setup(the_full_kernel_is_the_plain_one_on_free_ground, make_rows),
        cmocka_unit_test_setup(ends_of_rows, make_rows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
