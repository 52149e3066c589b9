/* Lightning cracks a glaze: what visitors strike in one scene is the mask of the painting that follows, by the real
 * parts: the scene's thread (app/scene/live_scene.h) and what scenes take from one another (app/graph/live_graph.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "live_graph.h"
#include "live_scene.h"
#include "patience.h"
#include "pictures.h"
#include "script_sheet.h"

enum { WIDTH = 320, HEIGHT = 200, HANDED = 7 };

struct place {
    struct exhibit *exhibit;
    struct live_scene *live;
    struct live_graph *graph;
    int64_t ticked;
};

static const struct script *script_of(const struct place *place, int scene)
{
    return place->exhibit->scenes[scene].script;
}

static void tell(struct place *place, enum studio_event_kind kind, int scene, const struct action *action)
{
    const struct script *script = script_of(place, scene);
    struct studio_event event = {.kind = kind,
                                 .ticked = place->ticked,
                                 .script = script,
                                 .def = {.width = script->width, .height = script->height},
                                 .action = action};
    live_scene_tell(place->live, &event);
}

static void ticks(struct place *place, int count)
{
    for (int i = 0; i < count; i++) {
        place->ticked++;
        tell(place, STUDIO_TICKED, 0, NULL);
    }
}

static struct place open_place(struct exhibit *exhibit)
{
    struct place place = {.exhibit = exhibit, .live = live_scene_create(scene_types)};
    struct script_def def = script_default_def();
    for (int i = 0; i < exhibit->scene_count; i++) {
        script_fit(exhibit->scenes[i].script, WIDTH, HEIGHT);
    }
    place.graph = live_graph_create(&def);
    assert_true(place.live && place.graph);
    live_graph_set(place.graph, exhibit);
    struct action actions[SCENE_OPTIONS_ACTIONS];
    int count = scene_options_actions(&exhibit->scenes[0].options, actions);
    live_scene_scene(place.live, script_of(&place, 0), (enum scene_kind)exhibit->scenes[0].kind, "cracks");
    live_scene_scene(place.live, script_of(&place, 1), SCENE_PAINTING, "glaze");
    tell(&place, STUDIO_SHEET, 0, NULL);
    for (int i = 0; i < count; i++) {
        tell(&place, STUDIO_ACTION, 0, &actions[i]);
    }
    return place;
}

static void close_place(struct place *place)
{
    live_scene_destroy(place->live);
    live_graph_destroy(place->graph);
    exhibit_destroy(place->exhibit);
}

static void strike(struct place *place, float x, float y)
{
    struct action action = action_default(ACTION_STRIKE);
    action.visitor = 1;
    action.at = (struct point){x, y};
    action.has_at = true;
    tell(place, STUDIO_ACTION, 0, &action);
}

/* The scene is left at once, as the kiosk leaves it; what comes of it is waited for. */
static void leave(struct place *place)
{
    struct outcome outcome;
    int number, waited = 0;
    while (!live_scene_is_calm(place->live)) { /* it has struck */
        assert_true(waited++ < PATIENCE_MS);
        nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
    }
    assert_false(live_scene_handed(place->live, &number, &outcome));
    assert_true(live_scene_hand(place->live, HANDED));
    tell(place, STUDIO_SCENE, 1, NULL);
    while (!live_scene_handed(place->live, &number, &outcome)) {
        assert_true(waited++ < PATIENCE_MS);
        nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
    }
    assert_int_equal(number, HANDED);
    live_graph_take(place->graph, 0, &outcome);
    assert_false(live_scene_handed(place->live, &number, &outcome));
    assert_false(live_scene_hand(place->live, HANDED)); /* a painting is the studio's */
}

/* Dark cells of a raster within a disc; middle and radius as shares of the longer side. */
static int dark_within(const struct action_raster *raster, float x, float y, float radius)
{
    int dark = 0;
    for (int i = 0; i < raster->width * raster->height; i++) {
        int column = i % raster->width, row = i / raster->width;
        float across = ((float)column + 0.5f) / (float)raster->width - x;
        float down = (((float)row + 0.5f) / (float)raster->height - y) * (float)raster->height / (float)raster->width;
        dark += raster->values[i] < 0.5f && hypotf(across, down) < radius;
    }
    return dark;
}

static struct exhibit *parse(const char *text)
{
    struct script_def def = script_default_def();
    struct report report;
    report_init(&report, "s.yaml");
    struct exhibit *exhibit = exhibit_parse(text, strlen(text), ".", &def, &report);
    report_print(&report, stderr);
    report_finish(&report);
    assert_non_null(exhibit);
    return exhibit;
}

static void lightning_cracks_the_shipped_glaze(void **state)
{
    (void)state;
    struct script_def def = script_default_def();
    struct report report;
    struct action actions[EXHIBIT_FEEDS];
    int count;
    def.load = pictures_load;
    report_init(&report, "");
    struct exhibit *exhibit = exhibit_read(FROND_EXHIBITS "/cracked-glaze.yaml", &def, &report);
    assert_non_null(exhibit);
    report_finish(&report);
    struct place place = open_place(exhibit);
    strike(&place, 0.5f, 0.5f);
    ticks(&place, 60);
    leave(&place);
    assert_true(live_graph_actions(place.graph, 1, actions, &count));
    assert_int_equal(count, 2);
    assert_int_equal(actions[0].verb, ACTION_MASK);
    assert_int_equal(actions[1].verb, ACTION_GUIDE);
    const struct action_raster *mask = &actions[0].picture;
    int all = dark_within(mask, 0.5f, 0.5f, 2), near = dark_within(mask, 0.5f, 0.5f, 0.05f);
    print_message("%d cells of cracks, %d where it struck\n", all, near);
    assert_true(near > 20 && all > 200 && all < mask->width * mask->height / 3);
    close_place(&place);
}

static void so_does_what_has_faded(void **state)
{
    (void)state;
    struct action actions[EXHIBIT_FEEDS];
    int count;
    struct place place = open_place(
        parse("exhibit: 1\nsheet: {cells: 16384}\nscenes:\n  - {id: cracks, kind: lightning, lightning: {life: 15}}\n"
              "  - {id: glaze, inputs: [{from: cracks, as: mask, tick: 20000}]}\n"));
    strike(&place, 0.7f, 0.8f);
    ticks(&place, 400);
    leave(&place);
    assert_true(live_graph_actions(place.graph, 1, actions, &count)); /* what grows by itself is not ready for long */
    assert_true(dark_within(&actions[0].picture, 0.7f, 0.8f, 0.05f) > 5);
    assert_int_equal(dark_within(&actions[0].picture, 0.1f, 0.8f, 0.1f), 0);
    struct outcome nothing = {.width = 1, .height = 1};
    for (int i = 0; i < SCENE_FIELDS; i++) {
        nothing.fields[i] = calloc(2, sizeof(float));
        nothing.fields[i][0] = 1;
    }
    live_graph_take(place.graph, 0, &nothing); /* of a sheet that was washed: what was there stays */
    assert_true(live_graph_actions(place.graph, 1, actions, &count));
    assert_true(actions[0].picture.width > 1);
    close_place(&place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lightning_cracks_the_shipped_glaze),
        cmocka_unit_test(so_does_what_has_faded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
