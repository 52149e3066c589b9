/* Colours as people see them, and which palettes stay apart for whom. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>

#include "vision.h"

/* Of the table of Sharma, Wu and Dalal 2005: the pairs that go wrong most easily. */
static void distance_is_ciede2000(void **state)
{
    static const struct {
        float one[3], other[3];
        double distance;
    } PAIRS[] = {
        {{50, 2.6772f, -79.7751f}, {50, 0, -82.7485f}, 2.0425},
        {{50, -1.3802f, -84.2814f}, {50, 0, -82.7485f}, 1.0000},
        {{50, 0, 0}, {50, -1, 2}, 2.3669},
        {{50, 2.49f, -0.001f}, {50, -2.49f, 0.0009f}, 7.1792},
        {{50, 2.49f, -0.001f}, {50, -2.49f, 0.0011f}, 7.2195},
        {{50, 2.5f, 0}, {73, 25, -18}, 27.1492},
        {{50, 2.5f, 0}, {56, -27, -3}, 31.9030},
        {{60.2574f, -34.0099f, 36.2677f}, {60.4626f, -34.1751f, 39.4387f}, 1.2644},
        {{22.7233f, 20.0904f, -46.6940f}, {23.0331f, 14.9730f, -42.5619f}, 2.0373},
        {{90.8027f, -2.0831f, 1.4410f}, {91.1528f, -1.6435f, 0.0447f}, 1.4441},
        {{2.0776f, 0.0795f, -1.1350f}, {0.9033f, -0.0636f, -0.5514f}, 0.9082},
    };
    (void)state;
    for (size_t i = 0; i < sizeof PAIRS / sizeof PAIRS[0]; i++) {
        double there = (double)vision_distance(PAIRS[i].one, PAIRS[i].other);
        double back = (double)vision_distance(PAIRS[i].other, PAIRS[i].one);
        assert_true(fabs(there - PAIRS[i].distance) < 1e-4 && fabs(back - there) < 1e-4);
    }
}

static void lab_has_its_landmarks(void **state)
{
    (void)state;
    static const float WHITE[3] = {1, 1, 1}, RED[3] = {1, 0, 0};
    float lab[3];
    vision_lab(WHITE, lab);
    assert_true(fabsf(lab[0] - 100) < 1e-2f && fabsf(lab[1]) < 2e-2f && fabsf(lab[2]) < 2e-2f);
    vision_lab(RED, lab);
    assert_true(fabsf(lab[0] - 53.24f) < 0.05f && fabsf(lab[1] - 80.09f) < 0.05f && fabsf(lab[2] - 67.20f) < 0.05f);
}

/* Greys stay as they are; red and green come together where they should, and nowhere else. */
static void sees_as_they_see(void **state)
{
    (void)state;
    static const float RED[3] = {0.5f, 0.12f, 0.1f}, GREEN[3] = {0.12f, 0.24f, 0.1f};
    float apart[VISIONS];
    for (enum vision vision = VISION_USUAL; vision < VISIONS; vision++) {
        float grey[3] = {0.4f, 0.4f, 0.4f}, labs[2][3], seen[3];
        vision_see(vision, grey, grey); /* in place, too */
        assert_true(fabsf(grey[0] - 0.4f) < 1e-4f && fabsf(grey[1] - 0.4f) < 1e-4f && fabsf(grey[2] - 0.4f) < 1e-4f);
        vision_see(vision, RED, seen);
        vision_lab(seen, labs[0]);
        vision_see(vision, GREEN, seen);
        vision_lab(seen, labs[1]);
        apart[vision] = vision_distance(labs[0], labs[1]);
    }
    assert_true(apart[VISION_USUAL] > 40 && apart[VISION_TRITANOPIA] > 40);
    assert_true(apart[VISION_PROTANOPIA] < 10 && apart[VISION_DEUTERANOPIA] < 10 && apart[VISION_GREY] < 2);
}

/* What becomes of a green and of a blue of one half, by the paper's table of severity 1. */
static void matrices_are_the_published_ones(void **state)
{
    (void)state;
    static const float SEEN[3][2][3] = {{{0.5262915f, 0.3931405f, 0}, {0, 0.0496080f, 0.5259990f}},
                                        {{0.4303230f, 0.3362505f, 0.0214700f}, {0, 0.0237065f, 0.4844405f}},
                                        {{0, 0.4654045f, 0.3456835f}, {0, 0.0738010f, 0.1519500f}}};
    for (int row = 0; row < 3; row++) {
        for (int channel = 1; channel < 3; channel++) {
            float rgb[3] = {0}, seen[3];
            rgb[channel] = 0.5f;
            vision_see((enum vision)(VISION_PROTANOPIA + row), rgb, seen);
            for (int c = 0; c < 3; c++) {
                assert_true(fabsf(seen[c] - SEEN[row][channel - 1][c]) < 1e-6f);
            }
        }
    }
}

static void print_row(const struct palette *palette, const int ink[INK_PALETTE])
{
    printf("%-11s %-5s %-5s", palette->name, palette->safe ? "safe" : "", palette->grey ? "grey" : "");
    for (enum vision vision = VISION_USUAL; vision < VISIONS; vision++) {
        printf("  %4.1f %4.1f %4.1f %4.1f", (double)vision_between(vision, ink, VISION_INKED),
               (double)vision_from_ground(vision, ink, VISION_INKED), (double)vision_between(vision, ink, VISION_TINT),
               (double)vision_from_ground(vision, ink, VISION_TINT));
    }
    putchar('\n');
}

static void palettes_are_as_safe_as_they_say(void **state)
{
    (void)state;
    int safe = 0, grey = 0, count = 0;
    printf("least CIEDE2000: inks well inked, from the ground; tints, from the ground\n%-23s", "");
    for (enum vision vision = VISION_USUAL; vision < VISIONS; vision++) {
        printf("  %-19s", vision_name(vision));
    }
    putchar('\n');
    for (const struct palette *palette = palettes; palette->name; palette++, count++) {
        int ink[INK_PALETTE];
        for (int i = 0; i < INK_PALETTE; i++) {
            ink[i] = ink_find(palette->inks[i]);
        }
        print_row(palette, ink);
        if (vision_is_safe(ink) != palette->safe || (palette->safe && vision_is_grey(ink)) != palette->grey) {
            fail_msg("palette %s is %ssafe and %sgrey", palette->name, vision_is_safe(ink) ? "" : "not ",
                     vision_is_grey(ink) ? "" : "not ");
        }
        safe += palette->safe;
        grey += palette->grey;
    }
    assert_true(safe >= 2 && grey >= 1 && safe < count); /* and the measure tells some from others */
}

static void the_nearest_pair_counts(void **state)
{
    (void)state;
    int cobalt = ink_find("cobalt"), black = ink_find("black");
    const int twice[INK_PALETTE] = {cobalt, black, cobalt, ink_find("yellow")};
    assert_true(vision_between(VISION_USUAL, twice, 1) < 1e-3f);
    assert_true(vision_from_ground(VISION_USUAL, twice, 0) < 1e-3f);
    assert_true(vision_from_ground(VISION_USUAL, twice, 1) > 10);
    assert_false(vision_is_safe(twice));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distance_is_ciede2000),
        cmocka_unit_test(lab_has_its_landmarks),
        cmocka_unit_test(sees_as_they_see),
        cmocka_unit_test(matrices_are_the_published_ones),
        cmocka_unit_test(palettes_are_as_safe_as_they_say),
        cmocka_unit_test(the_nearest_pair_counts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
