/* Light, lines and bodies on the processor: what is seen where, when, and of segments that are no good. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bolt_case.h"

enum { WIDTH = 160, HEIGHT = 120, BYTES = 3 * WIDTH * HEIGHT, COUNT = 150 };

static const int NEVER = 100000; /* ticks, by which all has come */

static struct bolt_view view_of(enum bolt_style style, const struct bolt_segment *segments, int count)
{
    return (struct bolt_view){
        .segments = segments, .count = count, .width = WIDTH, .height = HEIGHT, .look = bolt_case_look(style)};
}

/* From (40, 60) to (120, 60), of a radius. */
static struct bolt_segment bar(float radius)
{
    return (struct bolt_segment){
        .from = {40, 60, 0}, .to = {120, 60, 0}, .radius = radius, .radius_from = radius, .death = FLT_MAX, .heat = 1};
}

static int sum_at(const uint8_t *rgb, int x, int y)
{
    const uint8_t *pixel = rgb + 3 * (y * WIDTH + x);
    return pixel[0] + pixel[1] + pixel[2];
}

static long total(const uint8_t *rgb)
{
    long sum = 0;
    for (int i = 0; i < BYTES; i++) {
        sum += rgb[i];
    }
    return sum;
}

static void lay(const struct bolt_view *view, double tick, uint8_t *rgb)
{
    memset(rgb, 90, BYTES);
    assert_true(bolt_light_lay(view, tick, WIDTH, HEIGHT, rgb));
}

static void light_falls_off(void **state)
{
    (void)state;
    uint8_t rgb[BYTES];
    struct bolt_segment segment = bar(1.5f);
    struct bolt_view view = view_of(BOLT_GLOW, &segment, 1);
    lay(&view, NEVER, rgb);
    assert_true(sum_at(rgb, 80, 60) > 740); /* white-hot */
    for (int y = 66; y < 110; y += 4) {
        assert_true(sum_at(rgb, 80, y) >= sum_at(rgb, 80, y + 4));
    }
    const uint8_t *halo = rgb + 3 * (70 * WIDTH + 80);
    assert_true(halo[2] > halo[0] + 20); /* of its colour */
    assert_true(sum_at(rgb, 80, 70) > sum_at(rgb, 80, 110) + 40);
    assert_true(abs(sum_at(rgb, 80, 50) - sum_at(rgb, 80, 69)) <=
                20); /* alike on both sides, but for blocks of samples */
    segment.heat = 0.2f;
    uint8_t dim[BYTES];
    lay(&view, NEVER, dim);
    assert_true(sum_at(dim, 80, 60) < sum_at(rgb, 80, 60) && total(dim) < total(rgb));
}

/* Lines have the width that they say, and no gaps where they meet. */
static void lines_cover(void **state)
{
    (void)state;
    uint8_t rgb[BYTES];
    struct bolt_segment chain[40];
    for (int i = 0; i < 40; i++) {
        chain[i] = bar(2.5f + 0.05f * (float)i);
        chain[i].from[0] = 40 + 2 * (float)i;
        chain[i].to[0] = 42 + 2 * (float)i;
    }
    struct bolt_view view = view_of(BOLT_LINE, chain, 40);
    memcpy(view.look.core, view.look.colour, sizeof view.look.core);
    lay(&view, NEVER, rgb);
    int paper = sum_at(rgb, 5, 5), ink = sum_at(rgb, 80, 60);
    assert_true(paper > ink + 200);
    for (int x = 42; x < 120; x++) {
        double covered = 0;
        for (int y = 40; y < 80; y++) {
            covered += (double)(paper - sum_at(rgb, x, y)) / (paper - ink);
        }
        assert_true(fabs(covered - 2 * (2.5 + 0.05 * ((x + 0.5 - 40) / 2))) < 0.2);
        assert_true(abs(sum_at(rgb, x, 60) - ink) <= 3);
    }
    struct bolt_segment hair = bar(0.1f); /* thinner than a pixel: fainter */
    view.segments = &hair;
    view.count = 1;
    hair.from[1] = hair.to[1] = 60.5f;
    lay(&view, NEVER, rgb);
    assert_true(fabs((double)(paper - sum_at(rgb, 80, 60)) / (paper - ink) - 0.2) < 0.03);
}

/* What is nearer hides what is behind it, whichever comes first; a turn brings the other to the front. */
static void bodies_hide(void **state)
{
    (void)state;
    uint8_t rgb[BYTES], other[BYTES];
    struct bolt_segment two[2] = {bar(8), bar(8)};
    two[0].from[2] = two[0].to[2] = -20;
    two[0].heat = 1;
    two[1].from[2] = two[1].to[2] = 20;
    two[1].heat = 0.1f;
    struct bolt_view view = view_of(BOLT_BODY, two, 2);
    lay(&view, NEVER, rgb);
    struct bolt_segment swapped[2] = {two[1], two[0]};
    view.segments = swapped;
    lay(&view, NEVER, other);
    assert_memory_equal(rgb, other, BYTES);
    view.segments = two;
    view.turn = 0.5f;
    lay(&view, NEVER, other);
    assert_true(sum_at(rgb, 80, 60) > sum_at(other, 80, 60) + 60);
    /* Lit from above, on the left. */
    assert_true(sum_at(rgb, 80, 55) > sum_at(rgb, 80, 66) + 60);
}

static void it_turns(void **state)
{
    (void)state;
    uint8_t rgb[BYTES], other[BYTES];
    struct bolt_segment segments[COUNT];
    bolt_case_fill(segments, COUNT, WIDTH, HEIGHT, true);
    for (enum bolt_style style = 0; style < BOLT_STYLES; style++) {
        struct bolt_view view = view_of(style, segments, COUNT);
        lay(&view, 300, rgb);
        view.turn = 0.25f;
        lay(&view, 300, other);
        assert_memory_not_equal(rgb, other, BYTES);
        view.turn = 1;
        lay(&view, 300, other);
        assert_memory_equal(rgb, other, BYTES);
        view.turn = 0;
        view.tilt = 0.1f;
        lay(&view, 300, other);
        assert_memory_not_equal(rgb, other, BYTES);
    }
}

/* Not there before it is born, gone when it has died, and on the way in between (bodies by whole samples). */
static void birth_and_death(void **state)
{
    (void)state;
    uint8_t empty[BYTES], rgb[BYTES];
    for (enum bolt_style style = 0; style < BOLT_STYLES; style++) {
        struct bolt_segment segment = bar(3);
        struct bolt_view view = view_of(style, &segment, 0);
        double way = style == BOLT_GLOW ? 1 : -1, slack = style == BOLT_BODY ? 5000 : 0, before = 0, full = 0;
        view.tick = 1000;
        if (style == BOLT_BODY) { /* on a light ground */
            view.look.ground[0] = view.look.ground[1] = view.look.ground[2] = 0.9f;
        }
        lay(&view, 1e6, empty);
        segment.birth = 50;
        segment.death = 200;
        view.count = 1;
        for (int i = 0; i <= 60; i++) {
            double tick = 1040 + 0.5 * i;
            lay(&view, tick, rgb);
            double changed = way * (double)(total(rgb) - total(empty));
            assert_true(tick <= 1050 ? changed == 0 : changed >= before - slack);
            before = changed;
        }
        full = before;
        assert_true(full > 0);
        for (int i = 0; i <= 30; i++) {
            double tick = 1130 + 2.5 * i;
            lay(&view, tick, rgb);
            double changed = way * (double)(total(rgb) - total(empty));
            assert_true(changed <= before + slack && (tick < 1200 || changed == 0));
            before = changed;
        }
        segment.death = FLT_MAX;
        lay(&view, 1e6, rgb);
        assert_true(fabs(way * (double)(total(rgb) - total(empty)) - full) < 1);
    }
}

/* Over a painting: light makes nothing darker, nothing is laid where nothing is, and a flash is white. */
static void over_a_painting(void **state)
{
    (void)state;
    uint8_t rgb[BYTES], painting[BYTES];
    struct bolt_segment segment = bar(3);
    for (enum bolt_style style = 0; style < BOLT_STYLES; style++) {
        struct bolt_view view = view_of(style, &segment, 1);
        view.clear = true;
        for (uint32_t i = 0; i < BYTES; i++) {
            painting[i] = (uint8_t)bolt_case_bits(i);
        }
        memcpy(rgb, painting, BYTES);
        assert_true(bolt_light_lay(&view, NEVER, WIDTH, HEIGHT, rgb));
        assert_memory_not_equal(rgb, painting, BYTES);
        for (int i = 0; i < BYTES; i++) {
            int y = i / 3 / WIDTH;
            assert_true(style == BOLT_GLOW ? rgb[i] >= painting[i] : abs(y - 60) < 8 || rgb[i] == painting[i]);
        }
        view.flash = 0.5f;
        view.count = 0;
        memcpy(rgb, painting, BYTES);
        assert_true(bolt_light_lay(&view, NEVER, WIDTH, HEIGHT, rgb));
        for (int i = 0; i < BYTES; i++) {
            assert_true(abs(2 * rgb[i] - painting[i] - 255) <= 2);
        }
        view.flash = 7;
        assert_true(bolt_light_lay(&view, NEVER, WIDTH, HEIGHT, rgb));
        for (int i = 0; i < BYTES; i++) {
            assert_int_equal(rgb[i], 255);
        }
    }
}

/* What is no segment is not drawn, and the others are. */
static void no_good(void **state)
{
    (void)state;
    uint8_t rgb[BYTES], other[BYTES];
    static const float values[] = {NAN, INFINITY, -INFINITY, -1, 0, FLT_MAX, -FLT_MAX, 1e7f, -9e5f, 9e5f, 1e-40f};
    struct bolt_segment segments[COUNT], bad[sizeof values / sizeof *values * 12];
    size_t wrong = 0;
    bolt_case_fill(segments, COUNT, WIDTH, HEIGHT, true);
    for (size_t field = 0; field < 12; field++) {
        for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
            bad[wrong] = segments[wrong % COUNT];
            memcpy((char *)&bad[wrong] + field * sizeof(float), &values[i], sizeof(float));
            wrong++;
        }
    }
    for (enum bolt_style style = 0; style < BOLT_STYLES; style++) {
        struct bolt_view view = view_of(style, bad, (int)wrong);
        lay(&view, 100, rgb);
        view.turn = 0.2f;
        lay(&view, 100, rgb);
        struct bolt_segment good[3] = {segments[0], segments[1], segments[2]};
        view.segments = good;
        view.count = 3;
        lay(&view, 300, rgb);
        good[1].from[1] = NAN;
        good[2].to[2] = 2e6f;
        lay(&view, 300, other);
        view.count = 1;
        lay(&view, 300, rgb);
        assert_memory_equal(rgb, other, BYTES);
        view.turn = NAN;
        view.tilt = INFINITY;
        view.flash = NAN;
        view.look = (struct bolt_look){.style = 77, .trunk = NAN, .colour = {NAN, -5, 1e30f}, .life = NAN};
        lay(&view, NAN, rgb);
        view.width = view.height = 0;
        lay(&view, 1e300, rgb);
        assert_true(bolt_light_lay(&view, 0, 0, 5, NULL));
        assert_true(bolt_light_lay(&view, 0, 1, 1, rgb));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_falls_off), cmocka_unit_test(lines_cover),     cmocka_unit_test(bodies_hide),
        cmocka_unit_test(it_turns),        cmocka_unit_test(birth_and_death), cmocka_unit_test(over_a_painting),
        cmocka_unit_test(no_good),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
