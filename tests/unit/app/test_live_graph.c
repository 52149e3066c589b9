/* What scenes take from one another, grown on a thread (app/graph/live_graph.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "live_graph.h"
#include "patience.h"

enum { WIDE = 160, HIGH = 100 };

static const char TEXT[] = "exhibit: 1\nsheet: {cells: 16384}\nscenes:\n"
                           "  - {id: drops, inks: [black], opening: [{drop: {at: [0.5, 0.5], ink: black}}]}\n"
                           "  - id: ink\n    inputs:\n"
                           "      - {from: drops, as: mask, tick: 20}\n"
                           "      - {from: drops, of: along, as: guide, tick: 20}\n";

static struct exhibit *read_exhibit(const char *text)
{
    struct script_def def = script_default_def();
    struct report report;
    report_init(&report, "s.yaml");
    struct exhibit *exhibit = exhibit_parse(text, strlen(text), ".", &def, &report);
    if (!exhibit) {
        fail_msg("%s", report_text(&report));
    }
    report_finish(&report);
    return exhibit;
}

static void wait_until_ready(struct live_graph *graph, int scene)
{
    const struct timespec moment = {.tv_nsec = 1000000};
    int count, waited = 0;
    while (!live_graph_actions(graph, scene, NULL, &count)) {
        assert_true(waited++ < PATIENCE_MS);
        nanosleep(&moment, NULL);
    }
}

static int dark_cells(const struct action_raster *raster)
{
    int dark = 0;
    for (int i = 0; i < raster->width * raster->height; i++) {
        dark += raster->values[i] < 0.5f;
    }
    return dark;
}

static void scenes_are_grown_and_handed_over(void **state)
{
    (void)state;
    struct script_def def = script_default_def();
    struct exhibit *exhibit = read_exhibit(TEXT);
    struct live_graph *graph = live_graph_create(&def);
    struct action actions[EXHIBIT_FEEDS], other[EXHIBIT_FEEDS];
    int count;
    assert_non_null(graph);
    assert_false(live_graph_actions(graph, 1, actions, &count)); /* there is no exhibit yet */
    live_graph_set(graph, exhibit);
    wait_until_ready(graph, 1);
    assert_true(live_graph_actions(graph, 1, actions, &count));
    assert_int_equal(count, 2);
    assert_int_equal(actions[0].verb, ACTION_MASK);
    assert_int_equal(actions[1].verb, ACTION_GUIDE);
    assert_int_equal(actions[1].picture.channels, 2);
    int grown = dark_cells(&actions[0].picture);
    assert_in_range(grown, 50, 2000); /* the drop */
    uint8_t rgb[3 * WIDE * HIGH];
    memset(rgb, 240, sizeof rgb);
    live_graph_hand(graph, 0, rgb, WIDE, HIGH); /* nothing was made: what has grown stays */
    assert_true(live_graph_actions(graph, 1, other, &count));
    assert_int_equal(dark_cells(&other[0].picture), grown);
    memset(rgb + 3 * 40 * WIDE, 30, 3 * 20 * WIDE); /* a black bar */
    live_graph_hand(graph, 0, rgb, WIDE, HIGH);
    assert_true(live_graph_actions(graph, 1, other, &count));
    assert_int_equal(other[0].picture.width, WIDE);
    assert_in_range(dark_cells(&other[0].picture), 20 * WIDE, 20 * WIDE);
    assert_int_equal(dark_cells(&actions[0].picture), grown); /* what was given stays good */
    live_graph_destroy(graph);
    exhibit_destroy(exhibit);
}

/* In the middle of growing for longer than anybody would wait. */
static void it_ends_at_once(void **state)
{
    (void)state;
    static const char LONG[] = "exhibit: 1\nsheet: {cells: 1000000}\nscenes:\n"
                               "  - {id: drops, inks: [black], opening: [{drop: {at: [0.5, 0.5], ink: black, solvent: "
                               "900}}]}\n"
                               "  - {id: ink, inputs: [{from: drops, as: mask, tick: 20000}]}\n";
    struct script_def def = script_default_def();
    struct exhibit *slow = read_exhibit(LONG), *exhibit = read_exhibit(TEXT);
    struct live_graph *graph = live_graph_create(&def);
    int count;
    char line[400];
    live_graph_set(graph, slow);
    assert_false(live_graph_actions(graph, 1, NULL, &count));
    live_graph_set(graph, exhibit);
    exhibit_destroy(slow);
    wait_until_ready(graph, 1);
    assert_false(live_graph_log(graph, line, sizeof line)); /* to be stopped is no fault */
    live_graph_destroy(graph);
    exhibit_destroy(exhibit);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scenes_are_grown_and_handed_over),
        cmocka_unit_test(it_ends_at_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
