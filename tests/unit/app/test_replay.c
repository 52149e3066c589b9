/* What a live studio has painted, with all that can befall it, is painted again from its journal: to the bit. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "display.h"
#include "easel.h"
#include "patience.h"
#include "player.h"
#include "recorder.h"
#include "studio.h"

enum { TICKS = 260 };

static const char SCRIPT[] = "frond: 1\n"
                             "canvas: {width: 120, height: 88, margin: 6}\n"
                             "seed: 5\n"
                             "ticks: 260\n"
                             "actions:\n"
                             "  - {tick: 0, drop: {at: [0.5, 0.5], solvent: 200, amount: 90, edge: ragged}}\n"
                             "  - {tick: 30, drop: {at: [0.2, 0.2], brush: fern}}\n"
                             "  - {tick: 35, mask: {formula: x + y > 1.6}}\n";
static const char OTHER[] = "frond: 1\n"
                            "canvas: {width: 130, height: 88, margin: 6}\n"
                            "seed: 9\n"
                            "ticks: 260\n"
                            "painting: {alpha_a: 0.31, fluid_steps: 3}\n"
                            "inks: [ochre, cobalt]\n";

/* The order of things, by tick: posted from inside the thread, so that each run of the test is the same run. */
struct place {
    struct display *display;
    struct script *script, *other;
    struct studio *_Atomic studio; /* NULL until studio_create has given it */
    struct journal_writer writer;
    uint64_t hash; /* of the painting after tick TICKS */
    _Atomic bool done;
};

static struct script *parse(const char *text)
{
    struct script_def def = script_default_def();
    struct report report;
    report_init(&report, "replay");
    struct script *script = script_parse(text, strlen(text), ".", &def, &report);
    report_finish(&report);
    return script;
}

static int set_up(void **state)
{
    struct place *place = calloc(1, sizeof *place);
    struct display_def def = display_default_def();
    struct device_error error;
    def.kind = DISPLAY_HEADLESS;
    def.width = def.height = 16;
    place->display = display_create(&def, &error);
    place->script = parse(SCRIPT);
    place->other = parse(OTHER);
    *state = place;
    return place->display && place->script && place->other ? 0 : -1;
}

static int tear_down(void **state)
{
    struct place *place = *state;
    studio_destroy(place->studio);
    journal_finish(&place->writer);
    script_destroy(place->script);
    script_destroy(place->other);
    display_destroy(place->display);
    free(place);
    return 0;
}

static void post(struct place *place, enum action_verb verb, int visitor, float x, float y)
{
    struct point path[] = {{x, y}, {x + 0.1f, y + 0.15f}};
    struct action action = action_default(verb);
    action.visitor = visitor;
    action.at = path[0];
    action.has_at = true;
    if (verb == ACTION_REWIND || verb == ACTION_BRUSH_INK) {
        action.path = (struct action_path){path, 2};
        action.radius = 12;
        action.ticks = 40;
    }
    assert_true(studio_post(place->studio, &action));
}

/* What visitors, staff and governor do, and when. */
static void happen(struct place *place, int64_t tick)
{
    switch (tick) {
    case 20:
        post(place, ACTION_DROP, 1, 0.8f, 0.3f);
        break;
    case 60:
        post(place, ACTION_BRUSH_INK, 2, 0.45f, 0.4f);
        break;
    case 90:
        post(place, ACTION_UNDO, 1, 0, 0);
        break;
    case 110:
        post(place, ACTION_REDO, 1, 0, 0);
        post(place, ACTION_REWIND, 2, 0.4f, 0.4f);
        break;
    case 130:
        studio_scale(place->studio, 0.75f);
        break;
    case 150:
        post(place, ACTION_UNDO, 2, 0, 0);
        post(place, ACTION_DROP, 3, 0.3f, 0.75f);
        break;
    case 170:
        assert_true(studio_change(place->studio, place->other));
        break;
    case 190:
        post(place, ACTION_UNDO, 3, 0, 0);
        post(place, ACTION_DROP, 3, 0.6f, 0.7f);
        break;
    case 210:
        post(place, ACTION_UNDO, 3, 0, 0);
        break;
    default:
        break;
    }
}

static void nap(void)
{
    struct timespec time = {0, 5000000};
    nanosleep(&time, NULL);
}

static void hear(void *data, const struct studio_event *event)
{
    struct place *place = data;
    if (place->done) { /* the session begins anew; the journal is being read */
        return;
    }
    recorder_write(&place->writer, event, 0, "");
    if (event->kind == STUDIO_TICKED) {
        while (!place->studio) {
            nap();
        }
        happen(place, event->ticked);
    }
    if (event->kind == STUDIO_TICKED && event->ticked == TICKS) {
        place->hash = painting_hash(engine_cpu_painting(event->engine));
        journal_end(&place->writer, event->ticked);
        place->done = true;
    }
}

static void wait_until_done(struct place *place)
{
    for (int waited = 0; !place->done && waited < PATIENCE_MS; waited += 5) {
        nap();
    }
    assert_true(place->done);
}

static void paint(struct place *place, const struct checkpoint *from)
{
    struct studio_def def = studio_default_def();
    struct studio_error error;
    struct journal_head head = {.version = FROND_VERSION, .engine = "cpu"};
    journal_begin(&place->writer, &head);
    def.script = place->script;
    def.ticks_per_second = 400;
    def.teller = (struct studio_teller){hear, place};
    def.from = from;
    place->studio = studio_create(&def, place->display, &error);
    if (!place->studio) {
        fail_msg("%s", error.text);
    }
    wait_until_done(place);
    assert_string_equal(studio_report(place->studio).trouble, "");
}

static uint64_t play(const struct place *place, int threads, bool dense, struct player *player)
{
    struct easel easel = {.def = {.engine = ENGINE_CPU, .threads = threads, .dense = dense}};
    struct player_maker maker = {.make = easel_make, .data = &easel};
    struct file_error error;
    if (!player_open(player, place->writer.out.data, place->writer.out.size, &maker, &error)) {
        fail_msg("%s", error.text);
    }
    while (player_tick(player, &error)) {
    }
    assert_string_equal(error.text, "");
    assert_int_equal(player->ticked, TICKS);
    assert_int_equal(player->reader.ending, JOURNAL_ENDS);
    uint64_t hash = painting_hash(engine_cpu_painting(player->engine));
    return hash;
}

static void a_live_session_is_repeated_to_the_bit(void **state)
{
    struct place *place = *state;
    struct player player;
    paint(place, NULL);
    uint64_t hash = place->hash;
    assert_true(play(place, 1, false, &player) == hash);
    assert_int_equal(player.sheets, 1);
    assert_true(player.actions >= 13); /* the script's, the posted ones, the coefficients of the other script */
    assert_int_equal(player.sheet.def.width, 98);
    assert_int_equal(player.sheet.ink_count, 2);
    player_close(&player);
    assert_true(play(place, 3, true, &player) == hash);
    player_close(&player);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_live_session_is_repeated_to_the_bit, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
