/* The text of a plan: what plotters and embroidery machines can read, and nothing else. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <locale.h>
#include <math.h>

#include "branches.h"
#include "plan.h"

enum { WIDTH = 160, HEIGHT = 100, CELLS = WIDTH * HEIGHT };

/* A comb: a spine with teeth, and a dot beside. */
static float *make_depth(void)
{
    float *depth = calloc(CELLS, sizeof *depth);
    assert_non_null(depth);
    for (int i = 0; i < CELLS; i++) {
        int x = i % WIDTH, y = i / WIDTH;
        float spine = x >= 10 && x < 150 ? 1 - fabsf((float)y - 50) / 4 : 0;
        float tooth = y >= 20 && y <= 50 ? 1 - fabsf((float)(x % 20) - 10) / 4 : 0;
        float dot = 1 - hypotf((float)x - 80, (float)y - 80) / 3.5f;
        depth[i] = 0.7f * fmaxf(fmaxf(spine, x >= 10 && x < 150 ? tooth : 0), fmaxf(dot, 0));
    }
    return depth;
}

/* Numbers of a path's data; letters between them are counted. */
static int read_numbers(const char *at, double *numbers, int most, char *letters)
{
    int count = 0;
    for (; *at != '"';) {
        char *end;
        if (strchr("MLC", *at)) {
            *letters++ = *at++;
        } else if (*at == ' ') {
            at++;
        } else {
            assert_true(count < most);
            numbers[count++] = strtod(at, &end);
            assert_ptr_not_equal(end, at); /* nothing else stands there */
            at = end;
        }
    }
    *letters = '\0';
    return count;
}

static void strokes_only(void **state)
{
    (void)state;
    float *depth = make_depth();
    struct branches branches;
    size_t size;
    char *text = plan_svg(depth, WIDTH, HEIGHT, 320, &size);
    assert_non_null(text);
    assert_int_equal(strlen(text), size);
    assert_true(branches_find(depth, WIDTH, HEIGHT, &branches));
    static const char HEAD[] =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"320mm\" height=\"200mm\" viewBox=\"0 0 320 200\">\n"
        "<g fill=\"none\" stroke=\"black\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    assert_int_equal(strncmp(text, HEAD, strlen(HEAD)), 0);
    const char *at = text + strlen(HEAD);
    for (int i = 0; i < branches.count; i++) {
        const struct branch *branch = &branches.list[i];
        const struct branch_point *points = branches.points + branch->first;
        double numbers[2000], width;
        char letters[400];
        int taken = 0;
        assert_int_equal(sscanf(at, "<path stroke-width=\"%lf\" d=\"%n", &width, &taken), 1);
        assert_true(taken > 0 && fabs(width - 2 * (double)branch->width) < 0.001);
        at += taken;
        int count = read_numbers(at, numbers, 2000, letters);
        if (branch->count == 1) {
            assert_string_equal(letters, "ML");
            assert_true(fabs((numbers[0] + numbers[2]) / 2 - 2 * (double)points[0].x) < 0.002);
        } else {
            assert_int_equal(letters[0], 'M');
            assert_int_equal(strlen(letters), branch->count);
            assert_int_equal(count, branch->count == 2 ? 4 : 2 + 6 * (branch->count - 1));
            assert_true(fabs(numbers[0] - 2 * (double)points[0].x) < 0.001);
            assert_true(fabs(numbers[count - 1] - 2 * (double)points[branch->count - 1].y) < 0.001);
        }
        for (int j = 0; j < count; j++) {
            assert_true(numbers[j] >= -1 && numbers[j] <= (j % 2 ? 201 : 321));
        }
        at = strchr(at, '"');
        assert_int_equal(strncmp(at, "\"/>\n", 4), 0);
        at += 4;
    }
    assert_string_equal(at, "</g>\n</svg>\n");
    assert_in_range(branches.count, 8, 40); /* teeth, the spine between them, and the dot */
    branches_finish(&branches);
    free(text);
    free(depth);
}

/* Where a comma parts a number from its fraction, a plan has points. */
static void any_locale(void **state)
{
    (void)state;
    float *depth = make_depth();
    size_t size;
    char *plain = plan_svg(depth, WIDTH, HEIGHT, 100, &size);
    assert_non_null(plain);
    assert_non_null(strstr(plain, "viewBox=\"0 0 100 62.5\""));
    if (!setlocale(LC_NUMERIC, "de_DE.UTF-8") && !setlocale(LC_NUMERIC, "fr_FR.UTF-8")) {
        printf("no locale with a comma is here\n");
    }
    char *text = plan_svg(depth, WIDTH, HEIGHT, 100, &size);
    assert_string_equal(text, plain);
    setlocale(LC_NUMERIC, "C");
    free(text);
    free(plain);
    free(depth);
}

static void an_empty_sheet(void **state)
{
    (void)state;
    float *depth = calloc(CELLS, sizeof *depth);
    size_t size;
    char *text = plan_svg(depth, WIDTH, HEIGHT, PLAN_PAPER_MM, &size);
    assert_non_null(text);
    assert_non_null(strstr(text, "width=\"200mm\" height=\"125mm\""));
    assert_null(strstr(text, "<path"));
    free(text);
    free(depth);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strokes_only),
        cmocka_unit_test(any_locale),
        cmocka_unit_test(an_empty_sheet),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
