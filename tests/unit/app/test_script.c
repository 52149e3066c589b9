#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "brush.h"
#include "ink.h"
#include "script.h"

static struct script *parse(const char *text, const struct script_def *def)
{
    struct report report;
    report_init(&report, "s.yaml");
    struct script *script = script_parse(text, strlen(text), ".", def, &report);
    if (!script) {
        report_print(&report, stderr);
    }
    report_finish(&report);
    assert_non_null(script);
    return script;
}

static struct script *parse_plain(const char *text)
{
    struct script_def def = script_default_def();
    return parse(text, &def);
}

static void refuse(const char *text, size_t size, const struct script_def *def, const char *expected)
{
    struct report report;
    report_init(&report, "s.yaml");
    assert_null(script_parse(text, size, ".", def, &report));
    char *found = report_text(&report);
    assert_string_equal(found, expected);
    free(found);
    report_finish(&report);
}

static struct script *read_session(const char *name)
{
    char path[512];
    struct report report;
    struct script_def def = script_default_def();
    snprintf(path, sizeof path, "%s/sessions/%s", FROND_TEST_DATA, name);
    report_init(&report, path);
    struct script *script = script_read(path, &def, &report);
    report_print(&report, stderr);
    report_finish(&report);
    assert_non_null(script);
    return script;
}

static void assert_number(float found, double expected)
{
    assert_true(found == (float)expected);
}

static void assert_drop(const struct action *drop, int tick, double x, double y, int ink, double radius, double solvent,
                        double amount)
{
    assert_int_equal(drop->tick, tick);
    assert_int_equal(drop->verb, ACTION_DROP);
    assert_true(drop->has_at);
    assert_number(drop->at.x, x);
    assert_number(drop->at.y, y);
    assert_int_equal(drop->ink, ink);
    assert_number(drop->radius, radius);
    assert_number(drop->solvent, solvent);
    assert_number(drop->amount, amount);
    assert_int_equal(drop->edge, EDGE_HARD);
    assert_int_equal(drop->brush, BRUSH_NONE);
}

static void test_one_drop(void **state)
{
    (void)state;
    struct script *script = read_session("one-drop.yaml");
    assert_int_equal(script->width, 256);
    assert_int_equal(script->height, 256);
    assert_int_equal(script->margin, 0);
    assert_int_equal(script->seed, 1);
    assert_int_equal(script->ticks, 700);
    assert_int_equal(script->ink_count, 4);
    assert_string_equal(inks[script->inks[0]].name, "cyan");
    assert_string_equal(inks[script->inks[1]].name, "magenta");
    assert_string_equal(inks[script->inks[2]].name, "yellow");
    assert_string_equal(inks[script->inks[3]].name, "carbon black");
    struct coefficients expected = coefficients_default();
    assert_number(script->coefficients.alpha_a, 0.25);
    assert_number(script->coefficients.s_max, 0.3);
    assert_memory_equal(&script->coefficients, &expected, sizeof expected);
    assert_int_equal(script->action_count, 1);
    assert_drop(&script->actions[0], 0, 0.5, 0.5, 0, 8, 60, 30);
    script_destroy(script);
}

static void test_two_drops(void **state)
{
    (void)state;
    struct script *script = read_session("two-drops.yaml");
    assert_int_equal(script->width, 320);
    assert_int_equal(script->height, 256);
    assert_int_equal(script->seed, 2);
    assert_int_equal(script->ticks, 1000);
    assert_int_equal(script->action_count, 3);
    assert_drop(&script->actions[0], 0, 0.3, 0.5, 0, 8, 60, 30);
    assert_drop(&script->actions[1], 0, 0.7, 0.5, 1, 8, 60, 30);
    assert_drop(&script->actions[2], 600, 0.3, 0.5, 2, 8, 40, 40);
    script_destroy(script);
}

static void test_guided(void **state)
{
    (void)state;
    struct script *script = read_session("guided.yaml");
    assert_int_equal(script->width, 384);
    assert_int_equal(script->ticks, 900);
    assert_int_equal(script->action_count, 6);

    const struct action *mask = &script->actions[0];
    assert_int_equal(mask->verb, ACTION_MASK);
    assert_false(mask->has_at);
    assert_int_equal(mask->formula.width, 384);
    assert_int_equal(mask->formula.height, 384);
    assert_int_equal(mask->formula.channels, 1);
    assert_number(mask->formula.values[0], 1);
    assert_number(mask->formula.values[192 * 384 + 192], 0);
    assert_number(mask->formula.values[192 * 384 + 383], 1);

    const struct action *guide = &script->actions[1];
    assert_int_equal(guide->verb, ACTION_GUIDE);
    assert_int_equal(guide->path.count, 3);
    assert_number(guide->path.points[1].x, 0.7);
    assert_number(guide->path.points[1].y, 0.4);
    assert_number(guide->path.points[2].x, 0.85);
    assert_number(guide->radius, 40);
    assert_number(guide->strength, 1.2);

    assert_drop(&script->actions[2], 1, 0.5, 0.5, 0, 8, 80, 30);
    const struct action *brush = &script->actions[3];
    assert_int_equal(brush->verb, ACTION_BRUSH_SOLVENT);
    assert_int_equal(brush->tick, 200);
    assert_int_equal(brush->path.count, 2);
    assert_number(brush->path.points[1].y, 0.7);
    assert_number(brush->radius, 5);
    assert_number(brush->amount, 10);
    const struct action *pour = &script->actions[4];
    assert_int_equal(pour->verb, ACTION_POUR);
    assert_int_equal(pour->tick, 500);
    assert_number(pour->at.x, 0.45);
    assert_number(pour->radius, 30);
    assert_drop(&script->actions[5], 700, 0.6, 0.6, 1, 6, 40, 20);
    script_destroy(script);
}

static void a_visitor_stands_beside_the_verb(void **state)
{
    (void)state;
    struct script *script = parse_plain("frond: 1\n"
                                        "actions:\n"
                                        "  - {tick: 1, visitor: 3, drop: {at: [0.5, 0.5]}}\n"
                                        "  - {tick: 2, undo: , visitor: 4}\n"
                                        "  - {tick: 3, rewind: {path: [[0.5, 0.5]], ticks: 90}}\n");
    assert_int_equal(script->actions[0].visitor, 3);
    assert_int_equal(script->actions[1].verb, ACTION_UNDO);
    assert_int_equal(script->actions[1].visitor, 4);
    assert_int_equal(script->actions[2].verb, ACTION_REWIND);
    assert_int_equal(script->actions[2].visitor, 0);
    assert_number(script->actions[2].ticks, 90);
    assert_number(script->actions[2].radius, 24);
    script_destroy(script);
}

static void test_defaults(void **state)
{
    (void)state;
    struct script *script = parse_plain("frond: 1\n");
    struct coefficients expected = coefficients_default();
    assert_int_equal(script->width, 720);
    assert_int_equal(script->height, 720);
    assert_int_equal(script->margin, 0);
    assert_int_equal(script->seed, 1);
    assert_int_equal(script->ticks, 700);
    assert_int_equal(script->mode, 0);
    assert_int_equal(script->ink_count, 4);
    assert_string_equal(inks[script->inks[0]].name, palettes[0].inks[0]);
    assert_memory_equal(&script->coefficients, &expected, sizeof expected);
    assert_int_equal(script->action_count, 0);
    script_destroy(script);
}

/* By tick; within a tick as in the file; inks may stand below the actions that name them. */
static void test_order(void **state)
{
    (void)state;
    struct script *script = parse_plain("frond: 1\nactions:\n"
                                        "  - {tick: 5, dry: {amount: 0.1}}\n"
                                        "  - {tick: 2, drop: {at: [0, 1], ink: black}}\n"
                                        "  - {tick: 5, dry: {amount: 0.2}}\n"
                                        "  - {tick: 0, clear: }\n"
                                        "  - {tick: 5, dry: {amount: 0.3}}\n"
                                        "inks: [ochre, carbon black]\n");
    assert_int_equal(script->action_count, 5);
    assert_int_equal(script->actions[0].verb, ACTION_CLEAR);
    assert_int_equal(script->actions[1].ink, 1);
    assert_number(script->actions[2].amount, 0.1);
    assert_number(script->actions[3].amount, 0.2);
    assert_number(script->actions[4].amount, 0.3);
    script_destroy(script);
}

static void test_set(void **state)
{
    (void)state;
    struct script *script = parse_plain("frond: 1\ncanvas: {width: 16, height: 32}\nactions:\n"
                                        "  - {tick: 0, set: {coefficient: noise, value: lognormal}}\n"
                                        "  - {tick: 0, set: {coefficient: beta_y, value: 0.1, to: 8, formula: y}}\n");
    assert_number(script->actions[0].value, NOISE_LOGNORMAL);
    assert_ptr_equal(coefficient_keys + script->actions[0].coefficient, key_find(coefficient_keys, "noise"));
    assert_number(script->actions[1].to, 8);
    assert_number(script->actions[1].formula.values[0], 0.5 / 32);
    assert_number(script->actions[1].formula.values[16 * 32 - 1], 31.5 / 32);
    script_destroy(script);
}

static void test_guide_formula(void **state)
{
    (void)state;
    struct script *script = parse_plain("frond: 1\ncanvas: {width: 16, height: 16}\nactions:\n"
                                        "  - {tick: 0, guide: {formula: [\"x\", \"-y\"]}}\n");
    const struct action_raster *raster = &script->actions[0].formula;
    assert_int_equal(raster->channels, 2);
    assert_number(raster->values[15], 15.5 / 16);
    assert_number(raster->values[256 + 255], -15.5 / 16);
    script_destroy(script);
}

/* Dark on the left, bright on the right; the name says which file was asked for. */
static bool load_ramp(void *data, const char *folder, const char *path, struct script_picture *picture,
                      struct file_error *error)
{
    enum { SIDE = 32 };
    int *calls = data;
    assert_string_equal(folder, ".");
    if (strcmp(path, "ramp.png") != 0) {
        snprintf(error->text, sizeof error->text, "'%s' is not there; a picture", path);
        return false;
    }
    *picture = (struct script_picture){SIDE, SIDE, 3, malloc(SIDE * SIDE * 3 * sizeof(float))};
    assert_non_null(picture->values);
    for (int i = 0; i < SIDE * SIDE * 3; i++) {
        picture->values[i] = ((float)(i / 3 % SIDE) + 0.5f) / SIDE;
    }
    (*calls)++;
    return true;
}

static void test_pictures(void **state)
{
    (void)state;
    int calls = 0;
    struct script_def def = script_default_def();
    def.load = load_ramp;
    def.data = &calls;
    struct script *script = parse("frond: 1\ncanvas: {width: 32, height: 32}\nactions:\n"
                                  "  - {tick: 0, mask: {picture: ramp.png}}\n"
                                  "  - {tick: 1, set: {picture: ramp.png, coefficient: xi0, value: 0.1, to: 0.5}}\n"
                                  "  - {tick: 2, guide: {picture: ramp.png}}\n"
                                  "  - {tick: 3, guide: {picture: ramp.png, reading: along edges}}\n"
                                  "  - {tick: 4, guide: {picture: ramp.png, reading: vectors}}\n",
                                  &def);
    assert_int_equal(calls, 5);
    enum { ROW = 16 * 32, CELLS = 32 * 32 };
    const struct action *actions = script->actions;
    assert_float_equal(actions[0].picture.values[ROW + 4], 4.5 / 32,
                       1e-4); /* brightness: the engine masks what is dark */
    assert_float_equal(actions[1].picture.values[ROW + 4], 4.5 / 32, 1e-4); /* brightness */
    assert_int_equal(actions[2].picture.channels, 2);
    assert_true(actions[2].picture.values[ROW + 16] < -0.9f); /* to the left, where it is dark */
    assert_float_equal(actions[2].picture.values[CELLS + ROW + 16], 0, 1e-4);
    assert_float_equal(actions[3].picture.values[ROW + 16], 0, 1e-4);
    assert_true(actions[3].picture.values[CELLS + ROW + 16] < -0.9f);
    assert_float_equal(actions[4].picture.values[ROW + 4], 2 * 4.5 / 32 - 1, 1e-4);
    script_destroy(script);

    static const char MISSING[] = "frond: 1\nactions:\n  - {tick: 0, mask: {picture: no.png}}\n";
    refuse(MISSING, sizeof MISSING - 1, &def,
           "s.yaml:3:31: actions[0].mask.picture: 'no.png' is not there; a picture\n");
}

static void test_limits(void **state)
{
    (void)state;
    struct script_def def = script_default_def();
    def.raster_values_max = 16 * 16 * 2;
    static const char MANY[] = "frond: 1\ncanvas: {width: 16, height: 16}\nactions:\n"
                               "  - {tick: 0, mask: {formula: x}}\n  - {tick: 0, guide: {formula: [x, y]}}\n";
    refuse(MANY, sizeof MANY - 1, &def,
           "s.yaml:5:32: actions[1].guide.formula: too much for one file; 512 values in all formulas and pictures "
           "together\n");

    enum { SIZE = (1 << 20) + 1 };
    char *text = malloc(SIZE);
    assert_non_null(text);
    memset(text, '#', SIZE);
    refuse(text, SIZE, &def, "s.yaml: the file is larger than 1 MiB; a script is at most 1 MiB\n");

    size_t length = (size_t)snprintf(text, SIZE, "frond: 1\nactions: [");
    for (int i = 0; i <= SCRIPT_ACTIONS_MAX; i++) {
        text[length++] = '1';
        text[length++] = ',';
    }
    text[length++] = ']';
    refuse(text, length, &def, "s.yaml:2:10: actions: 100001 actions; at most 100000\n");
    free(text);
}

/* Hostile texts of the largest size are refused in a moment, and no report grows without end. */
static void test_hostile(void **state)
{
    (void)state;
    enum { SIZE = 1 << 20 };
    static const char *const PARTS[] = {"[",  "- ",  "? ", "{a: ", "a: 1\n", "&a *a ", "x,", "- {tick: 1}\n",
                                        "\"", "!!a "};
    struct script_def def = script_default_def();
    char *text = malloc(SIZE);
    assert_non_null(text);
    for (size_t i = 0; i < sizeof PARTS / sizeof *PARTS; i++) {
        size_t length = strlen(PARTS[i]), at = 0;
        for (; at + length <= SIZE; at += length) {
            memcpy(text + at, PARTS[i], length);
        }
        clock_t start = clock();
        struct report report;
        report_init(&report, "s.yaml");
        assert_null(script_parse(text, at, ".", &def, &report));
        assert_false(report_empty(&report));
        assert_true(report.count <= REPORT_PROBLEMS_MAX);
        report_finish(&report);
        assert_true((double)(clock() - start) / CLOCKS_PER_SEC < 20);
    }
    free(text);
}

static void test_missing_file(void **state)
{
    (void)state;
    struct report report;
    struct script_def def = script_default_def();
    report_init(&report, "no-such.yaml");
    assert_null(script_read("no-such.yaml", &def, &report));
    char *text = report_text(&report);
    assert_string_equal(text, "no-such.yaml: cannot be read: No such file or directory\n");
    free(text);
    report_finish(&report);
    report_init(&report, "folder");
    assert_null(script_read(FROND_TEST_DATA, &def, &report));
    text = report_text(&report);
    assert_string_equal(text, "folder: cannot be read: Is a directory\n");
    free(text);
    report_finish(&report);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_one_drop), cmocka_unit_test(test_two_drops),
        cmocka_unit_test(test_guided),   cmocka_unit_test(a_visitor_stands_beside_the_verb),
        cmocka_unit_test(test_defaults), cmocka_unit_test(test_order),
        cmocka_unit_test(test_set),      cmocka_unit_test(test_guide_formula),
        cmocka_unit_test(test_pictures), cmocka_unit_test(test_limits),
        cmocka_unit_test(test_hostile),  cmocka_unit_test(test_missing_file),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
