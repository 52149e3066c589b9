#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "formula.h"

/* The value at the middle of a sheet of one cell: x = y = 0.5. */
static float value(const char *expression)
{
    struct formula_problem problem = {0};
    struct formula *formula = formula_create(expression, &problem);
    if (!formula) {
        print_error("%s: %s\n", expression, problem.text);
    }
    assert_non_null(formula);
    float result = 0;
    assert_true(formula_sample(formula, 1, 1, &result, &problem));
    formula_destroy(formula);
    return result;
}

static void refuse(const char *expression, int at, const char *text)
{
    struct formula_problem problem = {0};
    assert_null(formula_create(expression, &problem));
    assert_int_equal(problem.at, at);
    assert_string_equal(problem.text, text);
}

static void test_values(void **state)
{
    (void)state;
    static const struct {
        const char *expression;
        float value;
    } CASES[] = {
        {"x", 0.5f},
        {"1 + 2 * 3", 7},
        {"-2^2", -4},
        {"(1 + 2) * 3", 9},
        {"x > 0.4", 1},
        {"x > 0.5", 0},
        {"x >= 0.5 && y <= 0.5", 1},
        {"x == y", 1},
        {"x != y || x < y", 0},
        {"x > 1 ? 3 : 4", 4},
        {"hypot(3, 4)", 5},
        {"mod(-1, 3)", 2},
        {"floor(-0.5) + ceil(0.5)", 0},
        {"clamp(7, 0, 2)", 2},
        {"smoothstep(0, 1, x)", 0.5f},
        {"min(x, 2) + max(1, 2) + abs(-1)", 3.5f},
        {"sqrt(16) + sign(-3)", 3},
        {"1e3", 1000},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof *CASES; i++) {
        assert_true(value(CASES[i].expression) == CASES[i].value);
    }
    assert_float_equal(value("sin(pi / 6)"), 0.5, 1e-5);
    assert_float_equal(value("atan2(1, 1)"), 0.7853982, 1e-5);
}

/* Values come in steps of 1/65536, so that a last bit decides nothing. */
static void test_steps(void **state)
{
    (void)state;
    assert_true(value("1/3") == 21845.0f / 65536);
    assert_true(value("1/3 + 1e-9") == 21845.0f / 65536);
    assert_true(value("1e-9") == 0);
}

static void test_sampling(void **state)
{
    (void)state;
    float values[8];
    struct formula_problem problem;
    struct formula *formula = formula_create("x + 10 * y", &problem);
    assert_non_null(formula);
    assert_true(formula_sample(formula, 4, 2, values, &problem));
    assert_true(values[0] == 2.625f);
    assert_true(values[3] == 3.375f);
    assert_true(values[7] == 8.375f);
    formula_destroy(formula);
}

static void test_not_finite(void **state)
{
    (void)state;
    float values[4];
    struct formula_problem problem;
    struct formula *formula = formula_create("1 / (x - 0.75)", &problem);
    assert_non_null(formula);
    assert_false(formula_sample(formula, 2, 2, values, &problem));
    assert_int_equal(problem.at, 0);
    assert_string_equal(problem.text, "is inf at x = 0.75, y = 0.25; -65536 to 65536 everywhere");
    formula_destroy(formula);
    formula = formula_create("y > 0.5 ? 1e6 : 0", &problem);
    assert_non_null(formula);
    assert_false(formula_sample(formula, 2, 2, values, &problem));
    assert_string_equal(problem.text, "is 1e+06 at x = 0.25, y = 0.75; -65536 to 65536 everywhere");
    formula_destroy(formula);
    formula = formula_create("ln(-x)", &problem);
    assert_non_null(formula);
    assert_false(formula_sample(formula, 2, 2, values, &problem));
    assert_string_equal(problem.text, "is not a number at x = 0.25, y = 0.25; -65536 to 65536 everywhere");
    formula_destroy(formula);
}

static void test_problems(void **state)
{
    (void)state;
#define ALLOWED "; x, y, pi, numbers, + - * / ^ ( ), < <= > >= == != && || ?:, and functions like sin(x)"
    refuse("", 0, "empty" ALLOWED);
    refuse("foo", 1, "unknown: 'foo'" ALLOWED);
    refuse("x + foo(y)", 5, "unknown: 'foo'" ALLOWED);
    refuse("\xc3\xa9 + x", 1, "unknown: '\xc3\xa9 + x'" ALLOWED);
    refuse("sin(x", 6, "a bracket is not closed" ALLOWED);
    refuse("x)", 2, "a bracket that does not fit there: ')'" ALLOWED);
    refuse("x y", 3, "a name where an operator should be: 'y'" ALLOWED);
    refuse("x 3", 3, "a value where an operator should be: '3'" ALLOWED);
    refuse("x = 3", 3, "a single =; == compares");
    refuse("x == 3 = y", 8, "a single =; == compares");
    refuse("\"abc\"", 6, "text in quotes: 'abc'" ALLOWED);
    refuse("1, 2", 0, "several values; one expression gives one value");
    refuse("hypot(1)", 8, "too few values for the function: 'hypot'" ALLOWED);
    char longest[FORMULA_LENGTH_MAX + 2];
    memset(longest, '1', sizeof longest - 1);
    longest[sizeof longest - 1] = '\0';
    refuse(longest, 0, "too long; an expression is at most 1000 bytes");
    memset(longest, '(', sizeof longest - 1);
    longest[FORMULA_LENGTH_MAX] = '\0';
    struct formula_problem problem;
    assert_null(formula_create(longest, &problem));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values),     cmocka_unit_test(test_steps),    cmocka_unit_test(test_sampling),
        cmocka_unit_test(test_not_finite), cmocka_unit_test(test_problems),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
