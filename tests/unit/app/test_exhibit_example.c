/* The self-documenting exhibit: every key of every table stands in it, under the very words of `frond explain`.
 *
 * After a change of a table: test_exhibit_example --write, which puts the comments right, and options of scenes in;
 * other keys that are missing are named by the test, and are put in by hand. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "example.h"
#include "exhibit.h"
#include "exhibit_case.h"
#include "explain.h"

static const char PATH[] = FROND_EXHIBITS "/touch-table.yaml";

static void every_key_stands_in_it(void **state)
{
    const struct example *example = *state;
    int missing = 0;
    for (int i = 0; i < example->row_count; i++) {
        const struct example_row *row = &example->rows[i];
        if (row->line < 0) {
            print_error("%s: the key %s is missing\n", row->place, row->key.name);
            missing++;
        }
    }
    assert_true(example->row_count > 250);
    assert_int_equal(missing, 0);
}

static void every_comment_is_that_of_its_table(void **state)
{
    const struct example *example = *state;
    char found[EXAMPLE_COMMENT], wanted[EXAMPLE_COMMENT];
    int wrong = 0;
    for (int i = 0; i < example->row_count; i++) {
        const struct example_row *row = &example->rows[i];
        if (row->line < 0) {
            continue;
        }
        example_comment(example, row->line, found, sizeof found);
        example_wanted(&row->key, wanted, sizeof wanted);
        if (strcmp(found, wanted) != 0) {
            print_error("line %d, %s.%s:\n  is:     %s\n  should: %s\n", row->line + 1, row->place, row->key.name,
                        found, wanted);
            wrong++;
        }
    }
    assert_int_equal(wrong, 0);
}

/* What `frond explain` prints, found again: meaning and range of every row. */
static void explain_says_the_same(void **state)
{
    const struct example *example = *state;
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    assert_non_null(out);
    assert_true(explain(NULL, out));
    assert_int_equal(fclose(out), 0);
    for (int i = 0; i < example->row_count; i++) {
        const struct key *key = &example->rows[i].key;
        char range[EXAMPLE_COMMENT], line[2 * EXAMPLE_COMMENT];
        enum action_verb found = action_find(key->name);
        bool verb = found != ACTION_VERBS && key->meaning == action_meaning(found);
        if (verb) {
            snprintf(line, sizeof line, "%s: %s\n", key->name, key->meaning);
        } else {
            snprintf(line, sizeof line, "  %s (%s)\n      %s\n", key->name, explain_range(key, range, sizeof range),
                     key->meaning);
        }
        if (!strstr(text, line)) {
            fail_msg("explain lacks:\n%s", line);
        }
    }
    free(text);
}

/* A value that is commented out is the default. */
static void what_is_commented_out_is_the_default(void **state)
{
    const struct example *example = *state;
    int compared = 0;
    for (int i = 0; i < example->line_count; i++) {
        const struct example_line *line = &example->kinds[i];
        const struct key *key = line->row >= 0 ? &example->rows[line->row].key : NULL;
        char initial[64];
        if (!key || !line->commented || key->required || strcmp(key->unit, "section") == 0 ||
            example->rows[line->row].line != i) {
            continue;
        }
        if (key->type == KEY_NUMBER || key->type == KEY_INTEGER || key->type == KEY_TIME) {
            snprintf(initial, sizeof initial, "%.10g", key->initial);
        } else if (key->type == KEY_FLAG) {
            snprintf(initial, sizeof initial, "%s", key->initial != 0 ? "true" : "false");
        } else if (key->type == KEY_CHOICE) {
            snprintf(initial, sizeof initial, "%s", key->choices[(int)key->initial]);
        } else {
            continue;
        }
        if (strcmp(line->value, initial) != 0) {
            fail_msg("line %d: %s: %s; the default is %s", i + 1, key->name, line->value, initial);
        }
        compared++;
    }
    assert_true(compared > 100);
}

static void shipped_words_are_shown(void **state)
{
    const struct example *example = *state;
    for (int i = 0; i < TEXTS; i++) {
        enum exhibit_text text = (enum exhibit_text)i;
        char wanted[400];
        bool found = false;
        snprintf(wanted, sizeof wanted, "  #%s: {en: \"%s\"}", words_key(text), words_shipped(text, 0));
        for (int k = 0; k < example->line_count; k++) {
            found = found || strcmp(example->lines[k], wanted) == 0;
        }
        if (!found) {
            fail_msg("lacks: %s", wanted);
        }
    }
}

/* What names a file that is not there, an ink that not every scene has, goes with no other key beside it, or is for
 * scenes of trees. */
static bool is_only_an_example(const struct example_row *row)
{
    static const char *const NAMES[][2] = {{"scenes[]", "inks"},
                                           {"scenes[]", "structures"},
                                           {"scenes[]", "inputs"},
                                           {"", "sessions"},
                                           {"inputs.controllers[].lamps[]", "usage"},
                                           {"inputs.bindings[].rinse", "at"}};
    const struct key *key = &row->key;
    bool named = false;
    for (size_t i = 0; i < sizeof NAMES / sizeof *NAMES; i++) {
        named = named || (strcmp(row->place, NAMES[i][0]) == 0 && strcmp(key->name, NAMES[i][1]) == 0);
    }
    for (int kind = SCENE_PAINTING + 1; kind < SCENE_KINDS; kind++) { /* its one scene is a painting */
        char place[EXAMPLE_PLACE];
        snprintf(place, sizeof place, "scenes[].%s", scene_kind_names[kind]);
        named = named || strcmp(row->place, place) == 0 ||
                (strcmp(row->place, "scenes[]") == 0 && strcmp(key->name, scene_kind_names[kind]) == 0);
    }
    return named || strncmp(row->place, "scenes[].structures", 19) == 0 ||
           strncmp(row->place, "scenes[].inputs", 15) == 0 || key->type == KEY_INK || key->type == KEY_PICTURE ||
           key->type == KEY_RASTER || (key->type == KEY_TEXT && strncmp(key->unit, "the path", 8) == 0);
}

/* Everything can be tried by taking its # away. */
static void it_is_right_without_its_marks(void **state)
{
    const struct example *example = *state;
    struct script_def def = script_default_def();
    struct report report;
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    assert_non_null(out);
    for (int i = 0; i < example->line_count; i++) {
        const struct example_line *line = &example->kinds[i];
        const char *from = example->lines[i];
        bool taken = line->commented && line->row >= 0 && !is_only_an_example(&example->rows[line->row]);
        fprintf(out, "%.*s%s\n", line->column, from, from + line->column + taken);
    }
    assert_int_equal(fclose(out), 0);
    report_init(&report, "example.yaml");
    struct exhibit *exhibit = exhibit_parse(text, size, ".", &def, &report);
    if (!exhibit) {
        report_print(&report, stderr);
    }
    assert_non_null(exhibit);
    assert_int_equal(exhibit->inputs->keyboard_count, 1);
    exhibit_destroy(exhibit);
    report_finish(&report);
    free(text);
}

/* The keys of a kind of scene, in a scene of that kind, say what is so without them. */
static void check_options(const struct example *example, enum scene_kind kind)
{
    struct report report;
    char *text = NULL, place[EXAMPLE_PLACE];
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    assert_non_null(out);
    snprintf(place, sizeof place, "scenes[].%s", scene_kind_names[kind]);
    fprintf(out, "exhibit: 1\nscenes:\n  - id: a\n    kind: %s\n    %s:\n", scene_kind_names[kind],
            scene_kind_names[kind]);
    for (int i = 0; i < example->line_count; i++) {
        const struct example_line *line = &example->kinds[i];
        if (line->row >= 0 && strcmp(example->rows[line->row].place, place) == 0) {
            bool over = example->rows[line->row].key.type == KEY_TEXT;
            fprintf(out, "      %s\n", over ? "over: good.png" : example->lines[i] + line->column + line->commented);
        }
    }
    assert_int_equal(fclose(out), 0);
    report_init(&report, "example.yaml");
    exhibit_case_folder();
    struct exhibit *exhibit = exhibit_case_parse(text, size, &report);
    report_print(&report, stderr);
    assert_non_null(exhibit);
    struct growth_def ink = growth_preset(METAPHOR_INK, false);
    if (kind == SCENE_TREES) {
        assert_memory_equal(&exhibit->scenes[0].options.trees, &ink, sizeof ink);
        assert_string_equal(exhibit->scenes[0].picture, "good.png");
    }
    exhibit_destroy(exhibit);
    exhibit_case_remove();
    report_finish(&report);
    free(text);
}

static void its_scenes_are_right_without_their_marks(void **state)
{
    for (int kind = SCENE_PAINTING + 1; kind < SCENE_KINDS; kind++) {
        check_options(*state, (enum scene_kind)kind);
    }
}

static int read_example(void **state)
{
    *state = example_read(PATH);
    return 0;
}

static int destroy_example(void **state)
{
    example_destroy(*state);
    return 0;
}

int main(int argc, char *argv[])
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_key_stands_in_it),        cmocka_unit_test(every_comment_is_that_of_its_table),
        cmocka_unit_test(explain_says_the_same),         cmocka_unit_test(what_is_commented_out_is_the_default),
        cmocka_unit_test(shipped_words_are_shown),       cmocka_unit_test(its_scenes_are_right_without_their_marks),
        cmocka_unit_test(it_is_right_without_its_marks),
    };
    if (argc == 2 && strcmp(argv[1], "--write") == 0) {
        struct example *example = example_read(PATH);
        example_write(example, PATH);
        example_destroy(example);
        return 0;
    }
    return cmocka_run_group_tests(tests, read_example, destroy_example);
}
