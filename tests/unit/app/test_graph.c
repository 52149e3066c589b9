/* What feeds what: types, order, circles, and what is said and drawn of them (app/graph/graph.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "exhibit_case.h"
#include "graph.h"
#include "script_case.h"

enum { TREES, INK, BOLT, DISH };

static struct graph four_scenes(void)
{
    struct graph graph = {.node_count = 0};
    assert_int_equal(graph_add(&graph, "trees", SCENE_TREES), TREES);
    assert_int_equal(graph_add(&graph, "ink", SCENE_PAINTING), INK);
    assert_int_equal(graph_add(&graph, "bolt", SCENE_LIGHTNING), BOLT);
    assert_int_equal(graph_add(&graph, "dish", SCENE_CHEMISTRY), DISH);
    return graph;
}

/* Every port takes the fields of its type, in scenes of its kind, and nothing else. */
static void ports_take_their_types(void **state)
{
    (void)state;
    static const int KINDS[SCENE_KINDS] = {INK, TREES, BOLT, DISH};
    struct graph graph = four_scenes();
    int fitting = 0;
    for (int as = 0; as < PORTS; as++) {
        for (int to = 0; to < graph.node_count; to++) {
            for (int of = 0; of < SCENE_FIELDS; of++) {
                struct graph_wrong wrong = {NULL, ""};
                struct graph_edge edge = {to == INK ? TREES : INK, to, of, as, GRAPH_AS_IT_IS};
                bool kind = to == KINDS[graph_ports[as].kind];
                bool type = scene_field_channels((enum scene_field)of) == graph_ports[as].channels;
                assert_int_equal(graph_check(&graph, &edge, &wrong), kind && type);
                assert_true((kind && type) || strcmp(wrong.key, kind ? "of" : "as") == 0);
                fitting += kind && type;
            }
        }
    }
    assert_int_equal(fitting, 20); /* 9 ports take one of two scalars, 2 the one vector */
}

static void readings_make_vectors(void **state)
{
    (void)state;
    struct graph graph = four_scenes();
    struct graph_wrong wrong;
    struct graph_edge edge = {BOLT, INK, FIELD_DARK, PORT_GUIDE, GRAPH_TOWARDS_DARK};
    assert_true(graph_check(&graph, &edge, &wrong));
    edge.of = FIELD_AROUND;
    edge.reading = GRAPH_ALONG_EDGES;
    assert_true(graph_check(&graph, &edge, &wrong));
    edge.of = FIELD_ALONG;
    assert_false(graph_check(&graph, &edge, &wrong));
    assert_string_equal(wrong.key, "reading");
    assert_string_equal(wrong.text,
                        "'along edges' makes a vector of a scalar, and 'along' is already a vector; no reading");
    edge = (struct graph_edge){BOLT, INK, FIELD_DARK, PORT_MASK, GRAPH_ALONG_EDGES};
    assert_false(graph_check(&graph, &edge, &wrong));
    assert_string_equal(wrong.text, "'along edges' makes a vector of a scalar, and 'mask' takes a scalar; no reading");
}

static void order_follows_the_arrows(void **state)
{
    (void)state;
    struct graph graph = four_scenes();
    int order[GRAPH_NODES], count;
    char text[GRAPH_TEXT];
    graph_connect(&graph, &(struct graph_edge){DISH, BOLT, FIELD_DARK, PORT_OUTLINE, GRAPH_AS_IT_IS});
    graph_connect(&graph, &(struct graph_edge){BOLT, INK, FIELD_DARK, PORT_MASK, GRAPH_AS_IT_IS});
    graph_connect(&graph, &(struct graph_edge){INK, TREES, FIELD_DARK, PORT_PICTURE, GRAPH_AS_IT_IS});
    assert_true(graph_order(&graph, order, &count, text, sizeof text));
    assert_int_equal(count, 4);
    const int expected[] = {DISH, BOLT, INK, TREES};
    assert_memory_equal(order, expected, sizeof expected);
}

static void circles_are_told(void **state)
{
    (void)state;
    struct graph graph = four_scenes();
    int order[GRAPH_NODES], count;
    char text[GRAPH_TEXT];
    graph_connect(&graph, &(struct graph_edge){INK, TREES, FIELD_DARK, PORT_PICTURE, GRAPH_AS_IT_IS}); /* beyond it */
    graph_connect(&graph, &(struct graph_edge){DISH, BOLT, FIELD_DARK, PORT_OUTLINE, GRAPH_AS_IT_IS});
    graph_connect(&graph, &(struct graph_edge){BOLT, INK, FIELD_DARK, PORT_MASK, GRAPH_AS_IT_IS});
    graph_connect(&graph, &(struct graph_edge){INK, DISH, FIELD_DARK, PORT_STYLE, GRAPH_AS_IT_IS});
    assert_false(graph_order(&graph, order, &count, text, sizeof text));
    assert_int_equal(count, 0);
    assert_string_equal(text, "ink -> dish -> bolt -> ink");
}

/* A graph that has no room says so. */
static void it_is_full(void **state)
{
    (void)state;
    struct graph graph = {.node_count = 0};
    struct graph_edge edge = {0, 1, FIELD_DARK, PORT_MASK, GRAPH_AS_IT_IS};
    for (int i = 0; i < GRAPH_NODES; i++) {
        assert_int_equal(graph_add(&graph, "a", SCENE_PAINTING), i);
    }
    assert_int_equal(graph_add(&graph, "b", SCENE_PAINTING), -1);
    for (int i = 0; i < GRAPH_EDGES; i++) {
        assert_true(graph_connect(&graph, &edge));
    }
    assert_false(graph_connect(&graph, &edge));
}

static void check_drawing(void (*draw)(const struct graph *graph, FILE *out), const char *expected)
{
    struct graph graph = {.node_count = 0};
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    assert_non_null(out);
    graph_add(&graph, "portr\"ät", SCENE_TREES);
    graph_add(&graph, "ink", SCENE_PAINTING);
    graph_connect(&graph, &(struct graph_edge){0, 1, FIELD_ALONG, PORT_GUIDE, GRAPH_AS_IT_IS});
    graph_connect(&graph, &(struct graph_edge){0, 1, FIELD_DARK, PORT_GUIDE, GRAPH_TOWARDS_DARK});
    draw(&graph, out);
    fclose(out);
    assert_string_equal(text, expected);
    free(text);
}

static void it_is_drawn(void **state)
{
    (void)state;
    check_drawing(graph_draw, "┌─────────────────┐\n"
                              "│ portr\"ät  trees │\n"
                              "└─────────────────┘\n"
                              "  ├─ along ──▶ guide of ink: growth follows it\n"
                              "  └─ dark, towards dark ──▶ guide of ink: growth follows it\n"
                              "\n"
                              "┌───────────────┐\n"
                              "│ ink  painting │\n"
                              "└───────────────┘\n");
    check_drawing(graph_draw_dot, "digraph exhibit {\n"
                                  "  rankdir = LR;\n"
                                  "  node [shape = box];\n"
                                  "  \"portr\\\"ät\" [tooltip = \"trees\"];\n"
                                  "  \"ink\" [tooltip = \"painting\"];\n"
                                  "  \"portr\\\"ät\" -> \"ink\" [taillabel = \"along\", headlabel = \"guide\"];\n"
                                  "  \"portr\\\"ät\" -> \"ink\" [taillabel = \"dark\", headlabel = \"guide\", "
                                  "label = \"towards dark\"];\n"
                                  "}\n");
    check_drawing(graph_draw_json,
                  "{\"scenes\": [{\"id\": \"portr\\\"ät\", \"kind\": \"trees\"}, {\"id\": \"ink\", \"kind\": "
                  "\"painting\"}], \"inputs\": [{\"from\": \"portr\\\"ät\", \"to\": \"ink\", \"of\": \"along\", "
                  "\"as\": \"guide\", \"reading\": \"as it is\"}, {\"from\": \"portr\\\"ät\", \"to\": \"ink\", "
                  "\"of\": \"dark\", \"as\": \"guide\", \"reading\": \"towards dark\"}]}\n");
}

#define HEAD   "exhibit: 1\nscenes:\n  - {id: bolt, kind: lightning}\n  - {id: dish, kind: chemistry}\n"
#define PORTS_ "guide, mask, coefficient, ink, relief, background"

static const struct script_case BAD[] = {
    {"a scene that is not there", BYTES(HEAD "  - {id: a, inputs: [{from: bolte, as: mask}]}\n"),
     "s.yaml:5:29: scenes[2].inputs[0].from: unknown scene 'bolte'; did you mean bolt? One of bolt, dish, a\n"},
    {"itself", BYTES(HEAD "  - {id: a, inputs: [{from: a, as: mask}]}\n"),
     "s.yaml:5:29: scenes[2].inputs[0].from: 'a' is this scene itself; another scene\n"},
    {"a vector for a scalar", BYTES(HEAD "  - {id: a, inputs: [{from: dish, of: along, as: mask}]}\n"),
     "s.yaml:5:39: scenes[2].inputs[0].of: 'along' is a vector, and 'mask' takes a scalar; of: dark, or of: around\n"},
    {"a scalar for a vector", BYTES(HEAD "  - {id: a, inputs: [{from: dish, as: guide}]}\n"),
     "s.yaml:5:22: scenes[2].inputs[0].of: 'dark' is a scalar, and 'guide' takes a vector; of: along, or a reading: "
     "towards dark, or along edges\n"},
    {"a port of another kind", BYTES(HEAD "  - {id: a, inputs: [{from: bolt, as: seeds}]}\n"),
     "s.yaml:5:39: scenes[2].inputs[0].as: 'seeds' is for scenes of kind chemistry, and 'a' is of kind painting; one "
     "of " PORTS_ "\n"},
    {"no port", BYTES(HEAD "  - {id: a, inputs: [{from: bolt}]}\n"),
     "s.yaml:5:22: scenes[2].inputs[0].as: missing; one of guide, mask, coefficient, ink, relief, background, picture, "
     "outline, style, seeds, orientation\n"},
    {"no coefficient", BYTES(HEAD "  - {id: a, inputs: [{from: bolt, as: coefficient, to: 9}]}\n"),
     "s.yaml:5:22: scenes[2].inputs[0].coefficient: missing; the name of a coefficient\n"
     "s.yaml:5:22: scenes[2].inputs[0].value: missing; a number, as of the coefficient\n"},
    {"a value out of range",
     BYTES(HEAD "  - {id: a, inputs: [{from: bolt, as: coefficient, coefficient: s_max, to: 9}]}\n"),
     "s.yaml:5:22: scenes[2].inputs[0].value: missing; 0 to 1.5 density per cell\n"
     "s.yaml:5:76: scenes[2].inputs[0].to: 9 is out of range; 0 to 1.5 density per cell\n"},
    {"what a mask has not",
     BYTES(HEAD "  - {id: a, inks: [cyan], inputs: [{from: bolt, as: mask, value: 1, ink: cyan}]}\n"),
     "s.yaml:5:66: scenes[2].inputs[0].value: of 'mask'; as: coefficient, or no value\n"
     "s.yaml:5:74: scenes[2].inputs[0].ink: of 'mask'; as: ink, as: background, or no ink\n"},
    {"a circle",
     BYTES("exhibit: 1\nscenes:\n"
           "  - {id: bolt, kind: lightning, inputs: [{from: a, as: outline}]}\n"
           "  - {id: a, inputs: [{from: dish, as: mask}]}\n"
           "  - {id: dish, kind: chemistry, inputs: [{from: bolt, as: style}]}\n"),
     "s.yaml:5:49: scenes[2].inputs[0].from: closes a circle, bolt -> dish -> a -> bolt; a scene that is not fed by "
     "this one\n"},
    {"too many",
     BYTES(HEAD
           "  - {id: a, inputs: [{from: bolt, as: mask}, {from: bolt, as: mask}, {from: bolt, as: mask}, {from: bolt, "
           "as: mask}, {from: bolt, as: mask}, {from: bolt, as: mask}, {from: bolt, as: mask}, {from: bolt, as: "
           "mask}, {from: bolt, as: mask}]}\n"),
     "s.yaml:5:21: scenes[2].inputs: a list of 9; at most 8\n"},
};

static void errors_are_told_word_for_word(void **state)
{
    (void)state;
    exhibit_case_told(BAD, sizeof BAD / sizeof *BAD);
}

/* Inputs of which nothing comes before somebody has been there; the file is good. */
static void what_nothing_comes_of_is_told(void **state)
{
    (void)state;
    static const char TEXT[] = "exhibit: 1\nscenes:\n"
                               "  - {id: bare, kind: lightning}\n"
                               "  - {id: struck, kind: lightning, opening: [{strike: {at: [0.5, 0.5]}}]}\n"
                               "  - {id: broth, kind: chemistry}\n"
                               "  - id: glaze\n    inputs:\n"
                               "      - {from: struck, as: mask}\n"
                               "      - {from: broth, as: mask}\n"
                               "      - {from: bare, as: mask}\n";
    struct script_def def = script_default_def();
    struct report report, warnings;
    report_init(&report, "s.yaml");
    report_init(&warnings, "s.yaml");
    struct exhibit *exhibit = exhibit_parse(TEXT, sizeof TEXT - 1, ".", &def, &report);
    assert_non_null(exhibit);
    exhibit_warn(exhibit, &warnings);
    char *told = report_text(&warnings);
    assert_int_equal(warnings.count, 1);
    assert_string_equal(told, "s.yaml:10:9: scenes[3].inputs[2].from: warning: nothing grows by itself in 'bare', and "
                              "nothing is taken from it until somebody has made something there; an opening for it\n");
    free(told);
    report_finish(&warnings);
    report_finish(&report);
    exhibit_destroy(exhibit);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ports_take_their_types),
        cmocka_unit_test(readings_make_vectors),
        cmocka_unit_test(order_follows_the_arrows),
        cmocka_unit_test(circles_are_told),
        cmocka_unit_test(it_is_full),
        cmocka_unit_test(it_is_drawn),
        cmocka_unit_test(what_nothing_comes_of_is_told),
        cmocka_unit_test(errors_are_told_word_for_word),
    };
    return cmocka_run_group_tests(tests, exhibit_case_begin, exhibit_case_end);
}
