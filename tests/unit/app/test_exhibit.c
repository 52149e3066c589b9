/* Exhibits: what a file becomes, section by section, and what stands where nothing is given (app/exhibit/exhibit.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "exhibit_case.h"
#include "gray_scott_classes.h"
#include "ink.h"
#include "near.h"
#include "script_sheet.h"
#include "transition.h"

static void a_version_alone_is_an_exhibit(void **state)
{
    (void)state;
    struct exhibit *exhibit = exhibit_case_good("exhibit: 1\n");
    assert_int_equal(exhibit->version, 1);
    assert_null(exhibit->title.in[0]);
    assert_null(exhibit->display.connector);
    assert_int_equal(exhibit->display.mode_width, 0);
    assert_int_equal(exhibit->display.mode_height, 0);
    assert_int_equal(exhibit->display.rotation, 0);
    assert_near(exhibit->display.width, 530, 0);
    assert_false(exhibit->display.lying);
    assert_int_equal(exhibit->sheet.cells, 345600);
    assert_int_equal(exhibit->sheet.rate, 60);
    assert_int_equal(exhibit->engine, ENGINE_AUTO);
    assert_null(exhibit->inputs);
    assert_int_equal(exhibit->scene_count, 1);
    assert_string_equal(exhibit->scenes[0].id, "paper");
    assert_int_equal(exhibit->scenes[0].ground_count, 0);
    const struct script *script = exhibit->scenes[0].script;
    assert_int_equal(script->width, 744);
    assert_int_equal(script->height, 465);
    assert_int_equal(script->ink_count, 4);
    assert_int_equal(script->inks[0], ink_find(palettes[0].inks[0]));
    assert_near(script->coefficients.beta_a, coefficients_default().beta_a, 0);
    assert_int_equal(script->action_count, 0);
    assert_null(exhibit->pictures);
    assert_int_equal(exhibit->session_count, 0);
    assert_int_equal(exhibit->language_count, 1);
    assert_int_equal(exhibit->languages[0], words_find("en"));
    for (int i = 0; i < TOOLS; i++) {
        assert_true(exhibit->palette.tools[i]);
    }
    assert_true(exhibit->palette.undo && exhibit->palette.finish && exhibit->palette.hand);
    assert_true(exhibit->palette.seated && exhibit->palette.language);
    assert_near(exhibit->palette.target, 18, 0);
    assert_int_equal(exhibit->seat_count, 1);
    static const float WHOLE[4] = {0, 0, 1, 1};
    assert_memory_equal(exhibit->seats[0].zone, WHOLE, sizeof WHOLE);
    assert_int_equal(exhibit->seats[0].ink, -1);
    assert_int_equal(exhibit->seats[0].side, SIDE_OF_LEFT);
    assert_near(exhibit->visit.idle, 60, 0);
    assert_near(exhibit->visit.countdown, 15, 0);
    assert_near(exhibit->access.scan, 0, 0);
    assert_near(exhibit->access.zone[1], 0.5, 0);
    assert_int_equal(exhibit->hours_count, 0);
    assert_int_equal(exhibit->wake, 0);
    assert_null(exhibit->gallery.folder);
    assert_int_equal(exhibit->staff.tap_count, 4);
    assert_int_equal(exhibit->staff.taps[3], 3);
    exhibit_destroy(exhibit);
}

static void screen_sheet_and_times_are_read(void **state)
{
    (void)state;
    struct exhibit *exhibit = exhibit_case_good(
        "exhibit: 1\n"
        "display: {connector: HDMI-A-2, mode: 1920x1080, refresh: 50, rotation: 270, width: 1210.5, lying: true}\n"
        "sheet: {cells: 100000, margin: 32, seed: 9, rate: 30}\n"
        "engine: cpu\n"
        "visit: {idle: 40, countdown: 10.5, thanks: 0, wash: 3, attract: 90, next_scene: 0, hide: 2}\n"
        "inputs: {bindings: [{touch: press, switch: {}}]}\n"
        "access: {scan: 8, dwell: 1.5, dwell_radius: 20, zone: [0.1, 0.4, 0.9, 0.95]}\n"
        "gallery: {folder: pictures, pictures: 7, megabytes: 9}\n"
        "wake: 30\n"
        "staff: {taps: [bottom left, top right, bottom left], within: 1, hold: 2}\n");
    const struct exhibit_display *display = &exhibit->display;
    assert_string_equal(display->connector, "HDMI-A-2");
    assert_int_equal(display->mode_width, 1920);
    assert_int_equal(display->mode_height, 1080);
    assert_int_equal(display->rotation, 270);
    assert_near(display->refresh, 50, 0);
    assert_near(display->width, 1210.5, 0);
    assert_true(display->lying);
    assert_int_equal(exhibit->engine, ENGINE_CPU);
    const struct script *script = exhibit->scenes[0].script;
    assert_int_equal(script->width, 400);
    assert_int_equal(script->height, 250);
    assert_int_equal(script->margin, 32);
    assert_int_equal(script->seed, 9);
    assert_int_equal(exhibit->sheet.rate, 30);
    assert_near(exhibit->visit.countdown, 10.5, 0);
    assert_int_equal(exhibit->visit.next_scene, 0);
    assert_near(exhibit->access.dwell_radius, 20, 0);
    assert_near(exhibit->access.zone[3], 0.95, 1e-6);
    assert_string_equal(exhibit->gallery.folder, "pictures");
    assert_int_equal(exhibit->gallery.megabytes, 9);
    assert_int_equal(exhibit->wake, 30);
    assert_int_equal(exhibit->staff.tap_count, 3);
    assert_int_equal(exhibit->staff.taps[0], 3);
    assert_int_equal(exhibit->staff.taps[1], 1);
    assert_near(exhibit->staff.hold, 2, 0);
    exhibit_destroy(exhibit);
}

static void scenes_have_inks_coefficients_and_a_ground(void **state)
{
    (void)state;
    struct exhibit *exhibit =
        exhibit_case_good("exhibit: 1\n"
                          "languages: [fr, en]\n"
                          "sheet: {cells: 16384}\n"
                          "palettes:\n"
                          "  - {id: mine, inks: [ochre, cyan, black, magenta]}\n"
                          "scenes:\n"
                          "  - {id: dawn, title: {fr: L’aube}, palette: mine, painting: {s_max: 0.25}}\n"
                          "  - {id: noon, palette: earth, mode: cmy}\n"
                          "  - {id: dusk, inks: [sienna, cyan], guide: good.png, mask: good.png}\n"
                          "  - {id: night}\n");
    assert_int_equal(exhibit->scene_count, 4);
    const struct exhibit_scene *scene = exhibit->scenes;
    assert_string_equal(words_of((struct words[TEXTS]){scene[0].title}, TEXT_INVITE, words_find("fr")), "L’aube");
    assert_int_equal(scene[0].script->inks[2], ink_find("carbon black"));
    assert_near(scene[0].script->coefficients.s_max, 0.25, 1e-6);
    assert_near(scene[1].script->coefficients.s_max, coefficients_default().s_max, 0);
    assert_int_equal(scene[1].script->inks[1], ink_find(palettes[palette_find("earth")].inks[1]));
    assert_int_equal(scene[1].script->mode, 1);
    assert_int_equal(scene[2].script->ink_count, 2);
    assert_int_equal(scene[2].script->inks[0], ink_find("burnt sienna"));
    assert_int_equal(scene[3].script->ink_count, 4);
    assert_int_equal(scene[2].ground_count, 2);
    const struct action *mask = &scene[2].ground[0], *guide = &scene[2].ground[1];
    assert_int_equal(mask->verb, ACTION_MASK);
    assert_int_equal(mask->picture.channels, 1);
    assert_int_equal(mask->picture.width, scene[2].script->width);
    assert_true(mask->picture.values[0] < 0.5f); /* dark: free */
    assert_true(mask->picture.values[mask->picture.width - 1] > 0.5f);
    assert_int_equal(guide->verb, ACTION_GUIDE);
    assert_int_equal(guide->reading, READ_ALONG_EDGES);
    assert_int_equal(guide->picture.channels, 2);
    exhibit_destroy(exhibit);
}

/* What they lay on a fresh sheet, in order; the raster is that of the sheet, dark on the branches. */
static void structures_become_ground(void **state)
{
    (void)state;
    struct exhibit *exhibit = exhibit_case_good("exhibit: 1\n"
                                                "sheet: {cells: 16384}\n"
                                                "scenes:\n"
                                                "  - id: face\n"
                                                "    painting: {s_max: 0.2}\n"
                                                "    structures:\n"
                                                "      - {over: good.png, detail: 64, endpoints: 30}\n"
                                                "      - {over: good.png, detail: 64, as: mask, width: 3}\n"
                                                "      - {over: good.png, detail: 64, as: ink, strength: 0.5}\n"
                                                "      - {over: good.png, as: relief, metaphor: frost}\n");
    const struct exhibit_scene *scene = exhibit->scenes;
    assert_int_equal(scene->ground_count, 4);
    static const enum action_verb VERBS[] = {ACTION_GUIDE, ACTION_MASK, ACTION_DRAW, ACTION_SET};
    for (int i = 0; i < 4; i++) {
        const struct action *action = &scene->ground[i];
        assert_int_equal(action->verb, VERBS[i]);
        assert_int_equal(action->picture.channels, i == 0 ? 2 : 1);
        assert_int_equal(action->picture.width, scene->script->width);
        int dark = 0, cells = action->picture.width * action->picture.height;
        for (int k = 0; k < cells; k++) {
            dark += action->picture.values[k] < 0.5f;
        }
        assert_true(i == 0 || (dark > 20 && dark < cells));
    }
    assert_near(scene->ground[0].strength, 0.7, 1e-6);
    assert_true(scene->ground[1].invert);
    assert_near(scene->ground[2].amount, 0.5, 1e-6);
    assert_int_equal(scene->ground[2].over, OVER_RUN);
    assert_string_equal(coefficient_keys[scene->ground[3].coefficient].name, "s_max");
    assert_near(scene->ground[3].value, 0.2, 1e-6);
    assert_near(scene->ground[3].to, 0.06, 1e-6);
    exhibit_destroy(exhibit);
}

static void files_are_found_beside_it(void **state)
{
    (void)state;
    struct exhibit *exhibit = exhibit_case_good("exhibit: 1\npictures: fine\nsessions: [good.yaml, good.yaml]\n");
    assert_int_equal(exhibit->session_count, 2);
    assert_string_equal(exhibit->sessions[1], "good.yaml");
    assert_int_equal(exhibit->recorded[1]->ticks, 77);
    assert_int_equal(exhibit->recorded[0]->actions[0].verb, ACTION_DROP);
    struct exhibit_pictures pictures = exhibit_pictures(exhibit);
    assert_int_equal(pictures.count, 2);
    assert_int_equal(pictures.more, 0);
    assert_string_equal(pictures.paths[0], "fine/good a.png");
    assert_string_equal(pictures.paths[1], "fine/good b.JPG");
    exhibit_pictures_finish(&pictures);
    exhibit_destroy(exhibit);
}

static void of_too_many_pictures_the_first_are_listed(void **state)
{
    (void)state;
    struct exhibit exhibit = {.pictures = "many", .folder = *state};
    struct exhibit_pictures pictures = exhibit_pictures(&exhibit);
    assert_int_equal(pictures.count, EXHIBIT_PICTURES);
    assert_int_equal(pictures.more, 1);
    assert_string_equal(pictures.paths[0], "many/000.png");
    assert_string_equal(pictures.paths[EXHIBIT_PICTURES - 1], "many/199.png");
    exhibit_pictures_finish(&pictures);
    exhibit.pictures = "nowhere";
    pictures = exhibit_pictures(&exhibit);
    assert_int_equal(pictures.count, 0);
    exhibit_pictures_finish(&pictures);
}

static void texts_are_those_of_the_file_then_the_shipped(void **state)
{
    (void)state;
    struct exhibit *exhibit = exhibit_case_good("exhibit: 1\n"
                                                "languages: [ja, de, en]\n"
                                                "texts:\n"
                                                "  invite: {en: Paint here, de: Hier malen}\n"
                                                "  countdown: {de: 'Noch {seconds} s'}\n");
    int en = words_find("en"), de = words_find("de"), ja = words_find("ja");
    assert_int_equal(exhibit->language_count, 3);
    assert_int_equal(exhibit->languages[0], ja);
    assert_string_equal(words_of(exhibit->texts, TEXT_INVITE, de), "Hier malen");
    assert_string_equal(words_of(exhibit->texts, TEXT_INVITE, ja), words_shipped(TEXT_INVITE, ja));
    assert_string_equal(words_of(exhibit->texts, TEXT_COUNTDOWN, de), "Noch {seconds} s");
    assert_string_equal(words_of(exhibit->texts, TEXT_THANKS, de), words_shipped(TEXT_THANKS, en));
    assert_string_equal(words_of(exhibit->texts, TEXT_INVITE, words_find("es")), "Paint here");
    assert_string_equal(words_of(exhibit->texts, TEXT_LANGUAGE, de), "Deutsch");
    exhibit_destroy(exhibit);
}

static void palette_and_seats_are_read(void **state)
{
    (void)state;
    struct exhibit *exhibit = exhibit_case_good("exhibit: 1\n"
                                                "scenes: [{id: a, inks: [cyan, yellow]}, {id: b, inks: [cyan]}]\n"
                                                "palette: {tools: [pour], undo: false, target: 25, opacity: 1}\n"
                                                "seats:\n"
                                                "  - {zone: [0, 0, 0.5, 1], ink: cyan, side: bottom}\n"
                                                "  - {zone: [0.5, 0, 1, 1], side: none}\n");
    assert_true(exhibit->palette.tools[TOOL_DROP] && exhibit->palette.tools[TOOL_POUR]);
    assert_false(exhibit->palette.tools[TOOL_BRUSH] || exhibit->palette.tools[TOOL_REWIND]);
    assert_false(exhibit->palette.undo);
    assert_true(exhibit->palette.finish);
    assert_int_equal(exhibit->seat_count, 2);
    assert_int_equal(exhibit->seats[0].ink, 0);
    assert_int_equal(exhibit->seats[0].side, SIDE_OF_BOTTOM);
    assert_near(exhibit->seats[0].zone[2], 0.5, 0);
    assert_int_equal(exhibit->seats[1].ink, -1);
    assert_int_equal(exhibit->seats[1].side, SIDE_OF_NONE);
    exhibit_destroy(exhibit);
}

static void hours_are_read(void **state)
{
    (void)state;
    struct exhibit *exhibit = exhibit_case_good("exhibit: 1\n"
                                                "schedule:\n"
                                                "  - {days: mon-fri, open: 9:30, close: \"18:00\"}\n"
                                                "  - {days: [sat, sun-mon], open: 22:00, close: 2:00}\n"
                                                "  - {days: fri-tue, open: 0:00, close: 24:00}\n"
                                                "  - {open: 1:00, close: 2:00}\n");
    static const bool DAYS[4][7] = {
        {1, 1, 1, 1, 1, 0, 0}, {1, 0, 0, 0, 0, 1, 1}, {1, 1, 0, 0, 1, 1, 1}, {1, 1, 1, 1, 1, 1, 1}};
    assert_int_equal(exhibit->hours_count, 4);
    for (int i = 0; i < 4; i++) {
        assert_memory_equal(exhibit->hours[i].days, DAYS[i], sizeof DAYS[i]);
    }
    assert_int_equal(exhibit->hours[0].from, 570);
    assert_int_equal(exhibit->hours[0].to, 1080);
    assert_int_equal(exhibit->hours[1].to, 120);
    assert_int_equal(exhibit->hours[2].to, 1440);
    exhibit_destroy(exhibit);
}

static void inputs_are_those_of_an_inputs_file(void **state)
{
    (void)state;
    struct exhibit *exhibit =
        exhibit_case_good("exhibit: 1\n"
                          "scenes: [{id: a, inks: [cyan, yellow]}, {id: b, inks: [black, yellow]}]\n"
                          "inputs:\n"
                          "  visitors: shared\n"
                          "  gpio: {buttons: [{id: red, line: GPIO17}], lamps: [{id: l, line: GPIO4, button: red}]}\n"
                          "  bindings:\n"
                          "    - {button: red, drop: {ink: yellow}}\n"
                          "    - {touch: drag, brush_ink: {}}\n");
    const struct inputs *inputs = exhibit->inputs;
    assert_non_null(inputs);
    assert_int_equal(inputs->visitors, VISITORS_SHARED);
    assert_true(inputs->touchscreens);
    assert_int_equal(inputs->written_count, 2);
    assert_int_equal(inputs->bindings[0].action.ink, 1);
    assert_int_equal(inputs->bindings[1].action.ink, -1);
    assert_int_equal(inputs->lamps[0].button, 0);
    exhibit_destroy(exhibit);
}

static uint64_t mark_of(const char *text)
{
    struct exhibit *exhibit = exhibit_case_good(text);
    uint64_t mark = exhibit->inputs_mark;
    exhibit_destroy(exhibit);
    return mark;
}

static void other_inputs_have_another_mark(void **state)
{
    (void)state;
    static const char INPUTS[] = "exhibit: 1\ninputs: {bindings: [{touch: tap, drop: {ink: ochre}}]}\n";
    uint64_t mark = mark_of(INPUTS);
    assert_true(mark != 0 && mark_of("exhibit: 1\n") == 0);
    assert_true(mark == mark_of("exhibit: 1\nwake: 5\ninputs:\n  bindings:\n    - {touch: tap, drop: {ink: ochre}}\n"));
    assert_true(mark != mark_of("exhibit: 1\ninputs: {bindings: [{touch: tap, drop: {ink: turquoise}}]}\n"));
    assert_true(mark != mark_of("exhibit: 1\ninputs: {bindings: [{touch: tap, drop: {}}]}\n"));
    assert_true(mark_of("exhibit: 1\ninputs: {bindings: [{touch: tap, drop: {radius: 8}}]}\n") !=
                mark_of("exhibit: 1\ninputs: {bindings: [{touch: tap, drop: {radius: 9}}]}\n"));
    assert_true(mark != mark_of("exhibit: 1\nscenes: [{id: a, inks: [ochre, cyan]}]\n"
                                "inputs: {bindings: [{touch: tap, drop: {ink: ochre}}]}\n"));
}

static void a_text_tells_what_it_is(void **state)
{
    (void)state;
    assert_true(exhibit_is("exhibit: 1\ninputs: {}\n", 22));
    assert_true(exhibit_is("exhibit: 7\n", 11));
    assert_false(exhibit_is("inputs: 1\n", 10));
    assert_false(exhibit_is("frond: 1\n", 9));
    assert_false(exhibit_is("- exhibit: 1\n", 13));
    assert_false(exhibit_is("exhibit: [1\n", 12));
    assert_false(exhibit_is("", 0));
}

static void scenes_of_trees_grow_as_their_metaphor_does_and_as_is_given(void **state)
{
    (void)state;
    struct exhibit *exhibit = exhibit_case_good(
        "exhibit: 1\n"
        "pictures: fine\n"
        "scenes:\n"
        "  - {id: a, leave: dry}\n"
        "  - {id: b, kind: trees, leave: freeze}\n"
        "  - {id: c, kind: trees, inks: [ochre], trees: {light: true, endpoints: 900, metaphor: vine, "
        "over: good.png, gain: 1.25, metric: cumulative}}\n"
        "  - {id: d, kind: trees, trees: {tree: true, picture: 0.5}}\n"
        "seats: [{zone: [0, 0, 1, 1], ink: turquoise}]\n"); /* which trees need not have */
    const struct exhibit_scene *scenes = exhibit->scenes;
    struct growth_def ink = growth_preset(METAPHOR_INK, false), vine = growth_preset(METAPHOR_VINE, false);
    assert_int_equal(scenes[0].kind, SCENE_PAINTING);
    assert_int_equal(scenes[1].kind, SCENE_TREES);
    assert_int_equal(scenes[0].leave, TRANSITION_DRY);
    assert_int_equal(scenes[1].leave, TRANSITION_FREEZE);
    assert_int_equal(scenes[2].leave, TRANSITION_WASH);
    assert_null(scenes[1].picture);
    assert_memory_equal(&scenes[1].options.trees, &ink, sizeof ink);
    vine.light = true;
    vine.endpoints = 900;
    vine.gain = 1.25f;
    vine.metric = METRIC_CUMULATIVE;
    assert_memory_equal(&scenes[2].options.trees, &vine, sizeof vine);
    assert_string_equal(scenes[2].picture, "good.png");
    struct growth_def tree = growth_preset(METAPHOR_INK, true);
    tree.picture = 0.5f;
    assert_memory_equal(&scenes[3].options.trees, &tree, sizeof tree);
    exhibit_destroy(exhibit);
    exhibit = exhibit_case_good("exhibit: 1\nscenes: [{id: a, kind: trees, trees: {over: good.png}}]\n");
    exhibit_destroy(exhibit);
    exhibit = exhibit_case_good("exhibit: 1\npalette: {tools: [pour, thin]}\n");
    assert_true(exhibit->palette.tools[TOOL_PLANT] && exhibit->palette.tools[TOOL_THIN]);
    assert_false(exhibit->palette.tools[TOOL_TEND]);
    exhibit_destroy(exhibit);
}

static void scenes_of_lightning_and_chemistry_have_what_is_given(void **state)
{
    (void)state;
    struct exhibit *exhibit = exhibit_case_good(
        "exhibit: 1\n"
        "scenes:\n"
        "  - {id: a, kind: lightning}\n"
        "  - {id: b, kind: lightning, lightning: {eta: 4.5, seed: 2147483647, kind: coral}}\n"
        "  - {id: c, kind: chemistry, chemistry: {feed: 0.031, preset: maze}, opening: [{dose: {at: [0.5, 0.25], "
        "radius: 9}}, {style: {formula: \"x\"}}, {clear: {}}]}\n"
        "  - {id: d, opening: [{drop: {at: [0.1, 0.2]}}], guide: good.png}\n"
        "palette: {tools: [repel]}\n");
    const struct exhibit_scene *scenes = exhibit->scenes;
    struct storm_def coral = storm_preset(BOLT_CORAL), lightning = storm_preset(BOLT_LIGHTNING);
    assert_int_equal(scenes[0].options.kind, SCENE_LIGHTNING);
    assert_memory_equal(&scenes[0].options.lightning, &lightning, sizeof lightning);
    coral.eta = 4.5f;
    coral.seed = 2147483647; /* to the last digit */
    assert_memory_equal(&scenes[1].options.lightning, &coral, sizeof coral);
    const struct gray_scott_preset *maze = gray_scott_preset_find("maze");
    assert_int_equal(scenes[2].options.chemistry.preset, (int)(maze - gray_scott_presets));
    assert_near(scenes[2].options.chemistry.reaction.feed, 0.031, 1e-7); /* what is given, after what is brought */
    assert_near(scenes[2].options.chemistry.reaction.kill, maze->kill, 1e-7);
    assert_int_equal(scenes[2].ground_count, 3);
    assert_true(scenes[2].ground[0].verb == ACTION_DOSE && scenes[2].ground[0].radius == 9);
    assert_true(scenes[2].ground[1].verb == ACTION_STYLE && scenes[2].ground[1].formula.values);
    assert_int_equal(scenes[3].ground_count, 2); /* the picture first */
    assert_true(scenes[3].ground[0].verb == ACTION_GUIDE && scenes[3].ground[1].verb == ACTION_DROP);
    for (int kind = 0; kind < SCENE_KINDS; kind++) {
        assert_true(exhibit->palette.tools[tool_first(kind)]);
    }
    assert_true(exhibit->palette.tools[TOOL_REPEL]);
    assert_false(exhibit->palette.tools[TOOL_STROKE] || exhibit->palette.tools[TOOL_MAP]);
    exhibit_destroy(exhibit);
}

static void a_file_is_read_where_it_lies(void **state)
{
    struct script_def def = script_default_def();
    struct report report;
    char path[128];
    snprintf(path, sizeof path, "%s/s.yaml", (const char *)*state);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs("exhibit: 1\nsessions: [good.yaml]\n", file);
    assert_int_equal(fclose(file), 0);
    report_init(&report, path);
    struct exhibit *exhibit = exhibit_read(path, &def, &report);
    assert_non_null(exhibit);
    assert_string_equal(exhibit->path, path);
    assert_string_equal(exhibit->folder, *state);
    exhibit_destroy(exhibit);
    assert_null(exhibit_read("/nowhere/s.yaml", &def, &report));
    assert_int_equal(report.count, 1);
    report_finish(&report);
    exhibit_destroy(NULL);
}

/* Every shipped sentence: there, not empty, and the countdown counts. */
static void every_word_is_shipped(void **state)
{
    static const char *const SHIPPED[] = {"en", "fr", "ar", "ja"};
    static const struct words NONE[TEXTS];
    (void)state;
    for (int i = 0; i < TEXTS; i++) {
        enum exhibit_text text = (enum exhibit_text)i;
        assert_true(strlen(words_key(text)) > 2);
        for (int k = 0; k < 4; k++) {
            const char *word = words_shipped(text, words_find(SHIPPED[k]));
            assert_true(word && strlen(word) > 2);
            assert_true((strstr(word, "{seconds}") != NULL) == (text == TEXT_COUNTDOWN));
            for (int j = 0; j < k; j++) { /* no language is another's */
                assert_string_not_equal(word, words_shipped(text, words_find(SHIPPED[j])));
            }
        }
        for (int k = 0; k < WORDS_LANGUAGES; k++) {
            assert_non_null(words_of(NONE, text, k));
        }
    }
    assert_true(words_languages[words_find("ar")].from_right);
    assert_int_equal(words_find("xx"), -1);
}

static void every_row_is_whole(void **state)
{
    (void)state;
    int tables = 0;
    for (const struct inputs_table *table = exhibit_tables; table->name; table++, tables++) {
        assert_true(strlen(table->about) > 5 && table->about[strlen(table->about) - 1] == '.');
        for (const struct key *key = table->keys; key->name; key++) {
            bool section = strcmp(key->unit, "section") == 0;
            assert_true(strlen(key->meaning) > 5 && key->meaning[strlen(key->meaning) - 1] == '.');
            assert_ptr_equal(key_find(table->keys, key->name), key);
            if (key->type == KEY_NUMBER || key->type == KEY_INTEGER) {
                assert_true(key->min <= key->max && key->initial >= key->min && key->initial <= key->max);
            }
            assert_true(section || (key->type == KEY_CHOICE) == (key->choices != NULL));
        }
    }
    assert_int_equal(tables, 16);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(structures_become_ground),
        cmocka_unit_test(a_version_alone_is_an_exhibit),
        cmocka_unit_test(screen_sheet_and_times_are_read),
        cmocka_unit_test(scenes_have_inks_coefficients_and_a_ground),
        cmocka_unit_test(files_are_found_beside_it),
        cmocka_unit_test(of_too_many_pictures_the_first_are_listed),
        cmocka_unit_test(texts_are_those_of_the_file_then_the_shipped),
        cmocka_unit_test(palette_and_seats_are_read),
        cmocka_unit_test(hours_are_read),
        cmocka_unit_test(inputs_are_those_of_an_inputs_file),
        cmocka_unit_test(other_inputs_have_another_mark),
        cmocka_unit_test(a_text_tells_what_it_is),
        cmocka_unit_test(scenes_of_trees_grow_as_their_metaphor_does_and_as_is_given),
        cmocka_unit_test(scenes_of_lightning_and_chemistry_have_what_is_given),
        cmocka_unit_test(a_file_is_read_where_it_lies),
        cmocka_unit_test(every_word_is_shipped),
        cmocka_unit_test(every_row_is_whole),
    };
    return cmocka_run_group_tests(tests, exhibit_case_begin, exhibit_case_end);
}
