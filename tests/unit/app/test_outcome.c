/* What a session comes to, for others to grow from: scripts (app/session/script_session.h), scenes of an exhibit
 * (app/graph/feeder.h), and the fields themselves (sim/grid/along.h, app/session/outcome.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "along.h"
#include "feed_action.h"
#include "feeder.h"
#include "folder_case.h"
#include "hand.h"
#include "outcome.h"
#include "script.h"

enum { SIDE = 64 };

static char folder[FOLDER_CASE_PATH];

static void write_text(const char *name, const char *text)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    assert_true(folder_case_put(path, text));
}

/* A picture that is dark on the left. */
static bool load(void *data, const char *in, const char *path, struct script_picture *picture, struct file_error *error)
{
    (void)data, (void)in;
    if (strcmp(path, "half.png") != 0) {
        snprintf(error->text, sizeof error->text, "'%s' is not there; a picture", path);
        return false;
    }
    *picture = (struct script_picture){SIDE, SIDE, 1, calloc(SIDE * SIDE, sizeof(float))};
    for (int i = 0; i < SIDE * SIDE; i++) {
        picture->values[i] = i % SIDE >= SIDE / 2;
    }
    return true;
}

static struct script_def loading(void)
{
    struct script_def def = script_default_def();
    def.load = load;
    return def;
}

static struct script *parse(const char *text, struct report *report)
{
    struct script_def def = loading();
    report_init(report, "s.yaml");
    return script_parse(text, strlen(text), folder, &def, report);
}

#define DROP                                                                                                           \
    "frond: 1\ncanvas: {width: 64, height: 64}\nticks: 60\ninks: [black]\nactions:\n"                                  \
    "  - {tick: 0, drop: {at: [0.5, 0.5], ink: black}}\n"

static int make_folder(void **state)
{
    (void)state;
    if (!folder_case_make(folder)) {
        return -1;
    }
    write_text("drop.yaml", DROP);
    write_text("bad.yaml", "frond: 1\nticks: x\n");
    write_text("one.yaml", "frond: 1\ncanvas: {width: 32, height: 32}\nactions:\n"
                           "  - {tick: 0, mask: {session: {file: other.yaml}}}\n");
    write_text("other.yaml", "frond: 1\ncanvas: {width: 32, height: 32}\nactions:\n"
                             "  - {tick: 0, mask: {session: {file: one.yaml}}}\n");
    write_text("long.yaml", "frond: 1\ncanvas: {width: 1024, height: 1024}\nticks: 15000\n");
    return 0;
}

static int remove_folder(void **state)
{
    (void)state;
    return folder_case_remove(folder) ? 0 : -1;
}

/* Lines from a dense place in the middle run away from it. */
static void patterns_have_directions(void **state)
{
    (void)state;
    float dark[SIDE * SIDE], along[2 * SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        bool disc = (x - 16) * (x - 16) + (y - 32) * (y - 32) < 64;
        dark[i] = disc || (x > 16 && x < 56 && y >= 31 && y <= 33) ? 0 : 1;
    }
    assert_true(along_of_pattern(dark, SIDE, SIDE, along));
    assert_true(along[32 * SIDE + 44] > 0.8f);
    assert_true(fabsf(along[SIDE * SIDE + 32 * SIDE + 44]) < 0.1f);
    assert_true(fabsf(along[4 * SIDE + 4]) < 0.001f); /* where nothing is */
}

static void births_have_directions(void **state)
{
    (void)state;
    float birth[SIDE * SIDE], along[2 * SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; i++) { /* a stroke that comes upwards */
        birth[i] = i % SIDE >= 30 && i % SIDE <= 33 ? (float)(SIDE - i / SIDE) : FLT_MAX;
    }
    assert_true(along_of_births(birth, SIDE, SIDE, along));
    assert_true(along[SIDE * SIDE + 32 * SIDE + 31] < -0.9f);
    assert_true(fabsf(along[32 * SIDE + 31]) < 0.05f);
    assert_true(fabsf(along[32 * SIDE + 2]) < 0.001f && fabsf(along[SIDE * SIDE + 32 * SIDE + 2]) < 0.001f);
}

static void scripts_take_sessions(void **state)
{
    (void)state;
    struct report report;
    struct script *script = parse("frond: 1\ncanvas: {width: 100, height: 50}\nactions:\n"
                                  "  - {tick: 0, mask: {session: {file: drop.yaml}}}\n"
                                  "  - {tick: 0, guide: {session: {file: drop.yaml, of: along, invert: true}}}\n"
                                  "  - {tick: 0, guide: {session: {file: drop.yaml}, reading: along edges}}\n"
                                  "  - {tick: 0, stock: {session: {file: drop.yaml, invert: true, strength: 0.5}}}\n"
                                  "  - {tick: 0, set: {coefficient: s_max, value: 0.2, to: 0.4, session: {file: "
                                  "drop.yaml, of: around, tick: 20}}}\n",
                                  &report);
    if (!script) {
        fail_msg("%s", report_text(&report));
    }
    const struct action *actions = script->actions;
    report_finish(&report);
    struct script *drop = parse(DROP, &report);
    struct outcome outcome;
    struct file_error error;
    assert_true(outcome_grow(&outcome, drop, 60, 1, NULL, &error));
    size_t middle = SIDE / 2 * SIDE + SIDE / 2;
    assert_true(outcome.fields[FIELD_DARK][middle] < 0.3f && outcome.fields[FIELD_DARK][0] > 0.99f);
    assert_memory_equal(actions[0].picture.values, outcome.fields[FIELD_DARK], SIDE * SIDE * sizeof(float));
    for (int i = 0; i < 5; i++) {
        assert_int_equal(actions[i].picture.width, SIDE);
        assert_int_equal(actions[i].picture.channels, i == 1 || i == 2 ? 2 : 1);
    }
    for (size_t i = 0; i < SIDE * SIDE; i++) {
        assert_true(fabsf(actions[1].picture.values[i] + outcome.fields[FIELD_ALONG][i]) < 1e-6f);
        float stocked = 1 - 0.5f * outcome.fields[FIELD_DARK][i];
        assert_true(fabsf(actions[3].picture.values[i] - stocked) < 1e-4f);
    }
    assert_true(actions[4].picture.values[middle] < 0.1f && actions[4].picture.values[0] > 0.99f);
    outcome_finish(&outcome);
    script_destroy(drop);
    script_destroy(script);
    report_finish(&report);
}

static void bad_sessions_are_told(void **state)
{
    (void)state;
    static const char *const CASES[][2] = {
        {"mask: {session: drop.yaml}", "mask.session: 'drop.yaml'; {file: SESSION, of: dark, ...}"},
        {"mask: {session: {of: dark}}",
         "mask.session.file: missing; the path of a session script in this file's folder, 1 to 1000 bytes"},
        {"mask: {session: {file: drop.yaml, of: along}}",
         "mask.session.of: 'along' is a vector, and mask takes a scalar; dark, or around"},
        {"guide: {session: {file: drop.yaml}, reading: vectors}",
         "guide.session.of: 'dark' is a scalar; along, or the reading towards dark, or along edges"},
        {"mask: {session: {file: no.yaml}}", "mask.session.file: 'no.yaml' is not there; a session"},
        {"mask: {session: {file: bad.yaml}}", "mask.session.file: bad.yaml:2:8: ticks: 'x'"},
        {"mask: {session: {file: one.yaml}}",
         "mask.session.file: one.yaml:4:38: actions[0].mask.session.file: other.yaml:4:38: "
         "actions[0].mask.session.file: 'one.yaml' is inside itself; another session"},
        {"mask: {session: {file: long.yaml}}",
         "mask.session.file: too much to grow for one file; 2147 million cells times ticks"},
        {"mask: {session: {file: drop.yaml, tick: 30000}}", "mask.session.tick: 30000 is out of range; 0 to 20000"},
        {"mask: {session: {file: drop.yaml}, formula: x}", "mask: both a formula and a session; one of them"},
        {"mask: {session: {file: ../drop.yaml}}", "mask.session.file: '../drop.yaml'"},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof *CASES; i++) {
        char text[400];
        struct report report;
        snprintf(text, sizeof text, "frond: 1\nactions:\n  - {tick: 0, %s}\n", CASES[i][0]);
        struct script *script = parse(text, &report);
        char *told = report_text(&report);
        if (script || !told || !strstr(told, CASES[i][1])) {
            fail_msg("%s:\nexpected: %s\nfound: %s", CASES[i][0], CASES[i][1], told ? told : "nothing");
        }
        free(told);
        report_finish(&report);
    }
}

static const char EXHIBIT[] = "exhibit: 1\nsheet: {cells: 16384}\nscenes:\n"
                              "  - {id: trees, kind: trees, trees: {over: half.png, endpoints: 60}, opening: [{plant: "
                              "{at: [0.5, 0.9]}}]}\n"
                              "  - id: ink\n    inks: [black, cobalt]\n    inputs:\n"
                              "      - {from: trees, as: mask, tick: 3}\n"
                              "      - {from: trees, as: background, tick: 3}\n"
                              "      - {from: trees, of: along, as: guide, strength: 0.4, tick: 3}\n"
                              "    opening: [{drop: {at: [0.5, 0.5], ink: cobalt}}]\n"
                              "  - {id: again, kind: trees, inputs: [{from: ink, as: picture, tick: 5}]}\n";

/* A scene is a session: options, ground, what other scenes give, and then its opening. */
static void scenes_are_fed(void **state)
{
    (void)state;
    struct report report;
    struct script_def def = loading();
    report_init(&report, "s.yaml");
    struct exhibit *exhibit = exhibit_parse(EXHIBIT, strlen(EXHIBIT), folder, &def, &report);
    if (!exhibit) {
        fail_msg("%s", report_text(&report));
    }
    struct feeder *feeder = feeder_create(&(struct feeder_def){exhibit, def, 1, NULL});
    struct feeder_session *session = calloc(1, sizeof *session);
    struct file_error error;
    assert_true(feeder && session);
    assert_true(feeder_open(feeder, 1, 10, session, &error));
    static const enum action_verb VERBS[] = {ACTION_MASK, ACTION_DRAW, ACTION_GUIDE, ACTION_DROP};
    assert_int_equal(session->script.action_count, 4);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(session->actions[i].verb, VERBS[i]);
    }
    assert_true(session->actions[0].invert); /* growth keeps to it */
    assert_int_equal(session->actions[1].ink, 1);
    assert_true(fabsf(session->actions[2].strength - 0.4f) < 1e-6f);
    const struct outcome *trees = feeder_outcome(feeder, 0, 3, &error);
    assert_ptr_equal(trees, feeder_outcome(feeder, 0, 3, &error)); /* grown once */
    assert_memory_equal(session->actions[0].picture.values, trees->fields[FIELD_DARK],
                        (size_t)trees->width * (size_t)trees->height * sizeof(float));
    feeder_close(session);
    assert_true(feeder_open(feeder, 2, 10, session, &error)); /* of a scene that is fed itself */
    int stocks = 0;
    for (int i = 0; i < session->script.action_count; i++) {
        stocks += session->actions[i].verb == ACTION_STOCK;
    }
    assert_int_equal(stocks, 1);
    feeder_close(session);
    free(session);
    feeder_destroy(feeder);
    exhibit_destroy(exhibit);
    report_finish(&report);
}

/* What stands out is dark, on paper as in the night; where nothing does, nothing comes of it. */
static void pictures_are_handed_over(void **state)
{
    (void)state;
    enum { WIDE = 960, HIGH = 480 };
    uint8_t *rgb = malloc(3 * WIDE * HIGH);
    struct outcome outcome;
    assert_non_null(rgb);
    for (int night = 0; night < 2; night++) {
        for (int i = 0; i < WIDE * HIGH; i++) {
            bool line = i / WIDE >= 230 && i / WIDE < 250 && i % WIDE >= 300;
            memset(rgb + (size_t)i * 3, (line ? 20 : 240) * (1 - night) + (line ? 230 : 10) * night, 3);
        }
        assert_true(hand_picture(&outcome, rgb, WIDE, HIGH));
        assert_int_equal(outcome.width, HAND_SIDE);
        assert_int_equal(outcome.height, HAND_SIDE / 2);
        int on = 120 * HAND_SIDE + 300, cells = outcome.width * outcome.height;
        assert_true(outcome.fields[FIELD_DARK][on] < 0.01f && outcome.fields[FIELD_DARK][0] > 0.99f);
        assert_true(fabsf(outcome.fields[FIELD_ALONG][on]) > 0.7f);
        assert_true(fabsf(outcome.fields[FIELD_ALONG][cells + on]) < 0.1f);
        assert_true(outcome.fields[FIELD_AROUND][on - 16 * HAND_SIDE] < 0.99f);
        outcome_finish(&outcome);
    }
    memset(rgb, 200, 3 * WIDE * HIGH);
    assert_false(hand_picture(&outcome, rgb, WIDE, HIGH));
    assert_null(outcome.fields[FIELD_DARK]);
    free(rgb);
}

/* One that is told to stop says so, and keeps nothing. */
static void growing_can_be_stopped(void **state)
{
    (void)state;
    struct report report;
    struct script *script = parse(DROP, &report);
    struct outcome outcome;
    struct file_error error;
    atomic_bool stop = true;
    assert_false(outcome_grow(&outcome, script, 60, 1, &stop, &error));
    assert_null(outcome.fields[FIELD_DARK]);
    assert_non_null(strstr(error.text, "stopped"));
    script_destroy(script);
    report_finish(&report);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(patterns_have_directions), cmocka_unit_test(births_have_directions),
        cmocka_unit_test(scripts_take_sessions),    cmocka_unit_test(bad_sessions_are_told),
        cmocka_unit_test(scenes_are_fed),           cmocka_unit_test(growing_can_be_stopped),
        cmocka_unit_test(pictures_are_handed_over),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
