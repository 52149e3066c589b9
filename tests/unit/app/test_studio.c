/* The thread that paints: it follows its script, takes what is posted, and keeps the painting through a lost GPU and
 * another grid (app/studio.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <GLES3/gl31.h>

#include "display.h"
#include "near.h"
#include "patience.h"
#include "studio.h"

enum { SIZE = 96 };

static const char SCRIPT[] = "frond: 1\n"
                             "canvas: {width: 96, height: 96}\n"
                             "ticks: 60\n"
                             "actions:\n"
                             "  - {tick: 0, drop: {at: [0.5, 0.5]}}\n"
                             "  - {tick: 30, drop: {at: [0.2, 0.2]}}\n";

struct place {
    struct display *display;
    struct script *script;
    struct studio *studio;
    atomic_bool shut, reached; /* a gate in the midst of a tick, which ends when the test lets it */
};

static int set_up(void **state)
{
    struct place *place = calloc(1, sizeof *place);
    struct display_def def = display_default_def();
    struct script_def script_def = script_default_def();
    struct device_error error;
    struct report report;
    def.kind = DISPLAY_HEADLESS;
    def.width = def.height = 16;
    place->display = display_create(&def, &error);
    report_init(&report, "studio");
    place->script = script_parse(SCRIPT, strlen(SCRIPT), ".", &script_def, &report);
    report_finish(&report);
    *state = place;
    return place->display && place->script ? 0 : -1;
}

static int tear_down(void **state)
{
    struct place *place = *state;
    atomic_store(&place->shut, false);
    studio_destroy(place->studio);
    script_destroy(place->script);
    display_destroy(place->display);
    free(place);
    return 0;
}

static void nap(void)
{
    struct timespec time = {0, 5000000};
    nanosleep(&time, NULL);
}

static void open_told_studio(struct place *place, enum engine_kind engine, struct studio_teller teller)
{
    struct studio_def def = studio_default_def();
    struct studio_error error;
    def.script = place->script;
    def.engine = engine;
    def.ticks_per_second = 0;
    def.once = true;
    def.teller = teller;
    place->studio = studio_create(&def, place->display, &error);
    if (!place->studio) {
        fail_msg("%s", error.text);
    }
}

static void open_studio(struct place *place, enum engine_kind engine)
{
    open_told_studio(place, engine, (struct studio_teller){.tell = NULL});
}

static void wait_end(struct place *place)
{
    int waited = 0;
    while (!studio_report(place->studio).ended && waited < PATIENCE_MS) {
        nap();
        waited += 5;
    }
    assert_int_equal(studio_report(place->studio).ticks, 60);
    assert_string_equal(studio_report(place->studio).trouble, "");
}

/* Depth of a cell in the newest fields. */
static float depth_at(struct place *place, float x, float y)
{
    bool fresh;
    float texel[4] = {-1};
    GLuint framebuffer;
    assert_true(display_begin(place->display));
    const struct fields *fields = studio_newest(place->studio, &fresh);
    if (!fields) {
        return -1;
    }
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, fields->texture[FIELDS_GROUND], 0);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    glReadPixels((int)(x * (float)fields->width), (int)(y * (float)fields->height), 1, 1, GL_RGBA, GL_FLOAT, texel);
    glDeleteFramebuffers(1, &framebuffer);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return texel[0];
}

/* The depth there becomes one between these, before patience ends. */
static void becomes(struct place *place, float x, float y, float least, float most)
{
    float depth = -1;
    for (int waited = 0; waited < PATIENCE_MS; waited += 5) {
        depth = depth_at(place, x, y);
        if (depth >= least && depth <= most) {
            return;
        }
        nap();
    }
    fail_msg("the depth at %.2f, %.2f stays %.3f", (double)x, (double)y, (double)depth);
}

static void paints(struct place *place, enum engine_kind engine)
{
    open_studio(place, engine);
    wait_end(place);
    becomes(place, 0.5f, 0.5f, 0.5f, 3);
    becomes(place, 0.2f, 0.2f, 0.5f, 3);
    becomes(place, 0.8f, 0.8f, 0, 0.01f);
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){0.8f, 0.8f};
    drop.has_at = true;
    assert_true(studio_post(place->studio, &drop)); /* a painting that has ended still takes ink */
    becomes(place, 0.8f, 0.8f, 0.5f, 3);
}

static void the_cpu_paints_the_script_and_what_is_posted(void **state)
{
    paints(*state, ENGINE_CPU);
}

static void the_gpu_paints_the_script_and_what_is_posted(void **state)
{
    paints(*state, ENGINE_GPU);
}

static void comes_back(struct place *place, enum engine_kind engine)
{
    struct device_error device_error;
    struct studio_error error;
    open_studio(place, engine);
    wait_end(place);
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){0.8f, 0.8f};
    drop.has_at = true;
    assert_true(studio_post(place->studio, &drop));
    becomes(place, 0.8f, 0.8f, 0.5f, 3);
    display_inject_reset(place->display);
    assert_true(display_lost(place->display));
    studio_suspend(place->studio);
    assert_true(display_renew(place->display, &device_error));
    assert_false(display_lost(place->display));
    assert_true(studio_resume(place->studio, place->display, &error));
    /* What was painted before the newest checkpoint, and what was posted after it. */
    becomes(place, 0.5f, 0.5f, 0.5f, 3);
    becomes(place, 0.8f, 0.8f, 0.5f, 3);
    assert_string_equal(studio_report(place->studio).trouble, "");
}

static void a_painting_of_the_cpu_survives_a_reset(void **state)
{
    comes_back(*state, ENGINE_CPU);
}

static void a_painting_of_the_gpu_survives_a_reset(void **state)
{
    comes_back(*state, ENGINE_GPU);
}

static void changes_grid(struct place *place, enum engine_kind engine)
{
    open_studio(place, engine);
    wait_end(place);
    becomes(place, 0.5f, 0.5f, 0.5f, 3);
    float before = depth_at(place, 0.5f, 0.5f);
    studio_scale(place->studio, 0.5f);
    for (int waited = 0; studio_report(place->studio).scale > 0.6f && waited < PATIENCE_MS; waited += 5) {
        nap();
    }
    assert_near(studio_report(place->studio).scale, 0.5, 1e-6);
    bool fresh;
    const struct fields *fields = studio_newest(place->studio, &fresh);
    for (int waited = 0; fields->width != SIZE / 2 && waited < PATIENCE_MS; waited += 5) {
        nap();
        fields = studio_newest(place->studio, &fresh);
    }
    assert_int_equal(fields->width, SIZE / 2);
    becomes(place, 0.5f, 0.5f, 0.7f * before, 1.3f * before);
    becomes(place, 0.8f, 0.8f, 0, 0.01f);
    assert_string_equal(studio_report(place->studio).trouble, "");
}

static void a_painting_of_the_cpu_goes_to_another_grid(void **state)
{
    changes_grid(*state, ENGINE_CPU);
}

static void a_painting_of_the_gpu_goes_to_another_grid(void **state)
{
    changes_grid(*state, ENGINE_GPU);
}

static void undo(struct place *place, enum action_verb verb, int visitor)
{
    struct action action = action_default(verb);
    action.visitor = visitor;
    assert_true(studio_post(place->studio, &action));
}

/* What was posted last goes, what was there before stays, and the session goes on. */
static void takes_back(struct place *place, enum engine_kind engine)
{
    open_studio(place, engine);
    wait_end(place);
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){0.8f, 0.8f};
    drop.has_at = true;
    assert_true(studio_post(place->studio, &drop));
    becomes(place, 0.8f, 0.8f, 0.5f, 3);
    undo(place, ACTION_UNDO, 0);
    becomes(place, 0.8f, 0.8f, 0, 0.01f);
    becomes(place, 0.5f, 0.5f, 0.5f, 3);
    undo(place, ACTION_UNDO, 0); /* once: there is nothing more to take back */
    assert_true(studio_post(place->studio, &drop));
    becomes(place, 0.8f, 0.8f, 0.5f, 3);
    becomes(place, 0.2f, 0.2f, 0.5f, 3);
    assert_int_equal(studio_report(place->studio).ticks, 60);
}

static void what_was_done_last_on_the_cpu_is_undone(void **state)
{
    takes_back(*state, ENGINE_CPU);
}

static void what_was_done_last_on_the_gpu_is_undone(void **state)
{
    takes_back(*state, ENGINE_GPU);
}

static void post_drop(struct place *place, int visitor, float x, float y)
{
    struct action drop = action_default(ACTION_DROP);
    drop.visitor = visitor;
    drop.at = (struct point){x, y};
    assert_true(studio_post(place->studio, &drop));
}

static void reports(struct place *place, uint64_t can_undo, uint64_t can_redo)
{
    struct studio_report report = studio_report(place->studio);
    for (int waited = 0; (report.can_undo != can_undo || report.can_redo != can_redo) && waited < PATIENCE_MS;
         waited += 5) {
        nap();
        report = studio_report(place->studio);
    }
    assert_int_equal(report.can_undo, can_undo);
    assert_int_equal(report.can_redo, can_redo);
}

/* Each visitor undoes and redoes their own; what the script did is nobody's. */
static void visitors_undo_their_own(struct place *place, enum engine_kind engine)
{
    open_studio(place, engine);
    wait_end(place);
    reports(place, 0, 0);
    post_drop(place, 1, 0.8f, 0.2f);
    post_drop(place, 2, 0.8f, 0.8f);
    becomes(place, 0.8f, 0.2f, 0.5f, 3);
    becomes(place, 0.8f, 0.8f, 0.5f, 3);
    reports(place, 7, 0);
    undo(place, ACTION_UNDO, 1);
    becomes(place, 0.8f, 0.2f, 0, 0.01f);
    reports(place, 5, 3);
    undo(place, ACTION_UNDO, 1); /* has done no more */
    undo(place, ACTION_REDO, 1);
    becomes(place, 0.8f, 0.2f, 0.5f, 3);
    becomes(place, 0.8f, 0.8f, 0.5f, 3);
    reports(place, 7, 0);
    undo(place, ACTION_UNDO, 0);
    undo(place, ACTION_UNDO, 0);
    undo(place, ACTION_UNDO, 0); /* the script's are not anybody's */
    becomes(place, 0.8f, 0.2f, 0, 0.01f);
    becomes(place, 0.8f, 0.8f, 0, 0.01f);
    becomes(place, 0.5f, 0.5f, 0.5f, 3);
    reports(place, 0, 7);
    assert_string_equal(studio_report(place->studio).trouble, "");
}

static void visitors_undo_their_own_on_the_cpu(void **state)
{
    visitors_undo_their_own(*state, ENGINE_CPU);
}

static void visitors_undo_their_own_on_the_gpu(void **state)
{
    visitors_undo_their_own(*state, ENGINE_GPU);
}

/* After what was posted before, a bare sheet, which nothing comes back to; the script begins again with another seed.
 */
static void a_fresh_sheet_is_bare(struct place *place, enum engine_kind engine)
{
    open_studio(place, engine);
    wait_end(place);
    post_drop(place, 1, 0.8f, 0.8f);
    becomes(place, 0.8f, 0.8f, 0.5f, 3);
    reports(place, 3, 0);
    post_drop(place, 2, 0.8f, 0.2f); /* goes with the old sheet */
    assert_true(studio_fresh(place->studio));
    becomes(place, 0.8f, 0.8f, 0, 0.01f);
    reports(place, 0, 0);
    assert_int_equal(studio_report(place->studio).sessions, 2);
    undo(place, ACTION_UNDO, 1);
    post_drop(place, 1, 0.8f, 0.5f);
    becomes(place, 0.8f, 0.5f, 0.5f, 3);
    wait_end(place);
    becomes(place, 0.2f, 0.2f, 0.5f, 3); /* of the script */
    becomes(place, 0.8f, 0.8f, 0, 0.01f);
    becomes(place, 0.8f, 0.2f, 0, 0.01f);
}

static void a_fresh_sheet_of_the_cpu_is_bare(void **state)
{
    a_fresh_sheet_is_bare(*state, ENGINE_CPU);
}

static void a_fresh_sheet_of_the_gpu_is_bare(void **state)
{
    a_fresh_sheet_is_bare(*state, ENGINE_GPU);
}

static struct script *script_of(const char *text)
{
    struct script_def def = script_default_def();
    struct report report;
    report_init(&report, "other");
    struct script *script = script_parse(text, strlen(text), ".", &def, &report);
    report_finish(&report);
    assert_non_null(script);
    return script;
}

/* The painting stays, on another canvas too; actions that are past do not happen. */
static void takes_another_script(struct place *place, enum engine_kind engine)
{
    struct script *still = script_of("frond: 1\ncanvas: {width: 96, height: 96}\nticks: 60\npainting: {alpha_a: 0.1}\n"
                                     "actions:\n  - {tick: 20, drop: {at: [0.8, 0.2]}}\n");
    struct script *larger = script_of("frond: 1\ncanvas: {width: 144, height: 144, margin: 8}\nticks: 100\n"
                                      "actions:\n  - {tick: 80, drop: {at: [0.8, 0.2]}}\n");
    open_studio(place, engine);
    wait_end(place);
    post_drop(place, 1, 0.8f, 0.8f);
    becomes(place, 0.8f, 0.8f, 0.5f, 3);
    assert_true(studio_script(place->studio) == place->script);
    assert_true(studio_change(place->studio, still));
    reports(place, 0, 0);
    assert_true(studio_script(place->studio) == still);
    becomes(place, 0.8f, 0.8f, 0.5f, 3);
    becomes(place, 0.5f, 0.5f, 0.5f, 3);
    becomes(place, 0.8f, 0.2f, 0, 0.01f);
    assert_true(studio_change(place->studio, larger));
    for (int waited = 0; studio_report(place->studio).ticks < 100 && waited < PATIENCE_MS; waited += 5) {
        nap();
    }
    bool fresh;
    assert_int_equal(studio_report(place->studio).ticks, 100);
    assert_int_equal(studio_newest(place->studio, &fresh)->width, 144);
    becomes(place, 0.8f, 0.2f, 0.5f, 3);
    becomes(place, 0.8f, 0.8f, 0.4f, 3);
    becomes(place, 0.5f, 0.5f, 0.4f, 3);
    assert_int_equal(studio_report(place->studio).sessions, 1);
    assert_string_equal(studio_report(place->studio).trouble, "");
    studio_destroy(place->studio);
    place->studio = NULL;
    script_destroy(still);
    script_destroy(larger);
}

static void another_script_keeps_the_painting_of_the_cpu(void **state)
{
    takes_another_script(*state, ENGINE_CPU);
}

static void another_script_keeps_the_painting_of_the_gpu(void **state)
{
    takes_another_script(*state, ENGINE_GPU);
}

/* What was undone before the GPU was lost stays undone. */
static void undo_survives_a_reset(void **state)
{
    struct place *place = *state;
    struct device_error device_error;
    struct studio_error error;
    open_studio(place, ENGINE_GPU);
    wait_end(place);
    post_drop(place, 1, 0.8f, 0.8f);
    becomes(place, 0.8f, 0.8f, 0.5f, 3);
    undo(place, ACTION_UNDO, 1);
    becomes(place, 0.8f, 0.8f, 0, 0.01f);
    display_inject_reset(place->display);
    assert_true(display_lost(place->display));
    studio_suspend(place->studio);
    assert_true(display_renew(place->display, &device_error));
    assert_true(studio_resume(place->studio, place->display, &error));
    becomes(place, 0.5f, 0.5f, 0.5f, 3);
    becomes(place, 0.8f, 0.8f, 0, 0.01f);
    undo(place, ACTION_REDO, 1); /* may be forgotten */
    post_drop(place, 2, 0.8f, 0.2f);
    becomes(place, 0.8f, 0.2f, 0.5f, 3);
    undo(place, ACTION_UNDO, 2);
    becomes(place, 0.8f, 0.2f, 0, 0.01f);
    assert_string_equal(studio_report(place->studio).trouble, "");
}

static void reaches(struct place *place, int64_t ticks)
{
    for (int waited = 0; studio_report(place->studio).ticks < ticks && waited < PATIENCE_MS; waited += 5) {
        nap();
    }
    assert_true(studio_report(place->studio).ticks >= ticks);
}

static void it_rests_while_nobody_looks(void **state)
{
    struct place *place = *state;
    place->script->ticks = 1000000;
    open_studio(place, ENGINE_CPU);
    reaches(place, 1);
    studio_rest(place->studio, true);
    for (int waited = 0; !studio_report(place->studio).rests && waited < PATIENCE_MS; waited += 5) {
        nap();
    }
    assert_true(studio_report(place->studio).rests);
    int64_t ticks = studio_report(place->studio).ticks;
    for (int i = 0; i < 20; i++) {
        nap();
    }
    assert_int_equal(studio_report(place->studio).ticks, ticks);
    studio_rest(place->studio, false);
    reaches(place, ticks + 1);
}

static uint64_t now_us(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000u + (uint64_t)now.tv_nsec / 1000u;
}

/* Whoever measures delays is told when what an event caused was taken, and which fields are the first to hold it. */
static void it_tells_which_fields_hold_what_was_posted(void **state)
{
    struct place *place = *state;
    struct studio_consumed consumed = {.number = 0};
    bool fresh;
    open_studio(place, ENGINE_CPU);
    wait_end(place);
    becomes(place, 0.5f, 0.5f, 0.5f, 3);
    uint64_t before = studio_newest(place->studio, &fresh)->number;
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){0.8f, 0.8f};
    drop.has_at = true;
    assert_false(studio_consumed(place->studio, &consumed));
    uint64_t event_us = now_us();
    assert_true(studio_post_event(place->studio, &drop, event_us));
    assert_true(studio_post(place->studio, &drop)); /* that no event has caused */
    for (int waited = 0; !studio_consumed(place->studio, &consumed) && waited < PATIENCE_MS; waited += 5) {
        nap();
    }
    assert_true(consumed.event_us == event_us && consumed.tick_us >= event_us - 1 && consumed.tick_us <= now_us());
    assert_true(consumed.number > before);
    const struct fields *fields = studio_newest(place->studio, &fresh);
    for (int waited = 0; fields->number < consumed.number && waited < PATIENCE_MS; waited += 5) {
        nap();
        fields = studio_newest(place->studio, &fresh);
    }
    assert_true(fields->number >= consumed.number);
    assert_true(depth_at(place, 0.8f, 0.8f) >= 0.5f);
    assert_false(studio_consumed(place->studio, &consumed));
}

static void stand(void *data, const struct studio_event *event)
{
    struct place *place = data;
    while (event->kind == STUDIO_ACTION && atomic_load(&place->shut)) {
        atomic_store(&place->reached, true);
        nap();
    }
}

/* While a tick does not end, whoever asks for the newest picture has an answer, and may post: waiting here would be for
 * ever. */
static void a_frame_never_waits_for_a_tick(void **state)
{
    struct place *place = *state;
    bool fresh;
    place->script->ticks = 1000000;
    open_told_studio(place, ENGINE_CPU, (struct studio_teller){stand, place});
    becomes(place, 0.5f, 0.5f, 0.5f, 3);
    atomic_store(&place->shut, true);
    post_drop(place, 1, 0.8f, 0.8f);
    for (int waited = 0; !atomic_load(&place->reached) && waited < PATIENCE_MS; waited += 5) {
        nap();
    }
    assert_true(atomic_load(&place->reached));
    int64_t ticks = studio_report(place->studio).ticks;
    assert_true(display_begin(place->display));
    for (int i = 0; i < 20; i++) {
        assert_non_null(studio_newest(place->studio, &fresh));
        assert_int_equal(studio_report(place->studio).ticks, ticks);
        post_drop(place, 1, 0.8f, 0.2f);
        studio_rest(place->studio, false);
        studio_scale(place->studio, 1);
    }
    atomic_store(&place->shut, false);
    becomes(place, 0.8f, 0.2f, 0.5f, 3);
    reaches(place, ticks + 1);
}

static void paths_are_copied_and_long_ones_refused(void **state)
{
    struct place *place = *state;
    struct point points[STUDIO_PATH + 1] = {{0.5f, 0.5f}, {0.6f, 0.5f}};
    struct action stroke = action_default(ACTION_BRUSH_SOLVENT);
    open_studio(place, ENGINE_CPU);
    stroke.path = (struct action_path){points, 2};
    assert_true(studio_post(place->studio, &stroke));
    memset(points, 0xff, sizeof points); /* NaN, should anybody look at them */
    stroke.path.count = STUDIO_PATH + 1;
    assert_false(studio_post(place->studio, &stroke));
    wait_end(place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(the_cpu_paints_the_script_and_what_is_posted, set_up, tear_down),
        cmocka_unit_test_setup_teardown(the_gpu_paints_the_script_and_what_is_posted, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_painting_of_the_cpu_survives_a_reset, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_painting_of_the_gpu_survives_a_reset, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_painting_of_the_cpu_goes_to_another_grid, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_painting_of_the_gpu_goes_to_another_grid, set_up, tear_down),
        cmocka_unit_test_setup_teardown(what_was_done_last_on_the_cpu_is_undone, set_up, tear_down),
        cmocka_unit_test_setup_teardown(what_was_done_last_on_the_gpu_is_undone, set_up, tear_down),
        cmocka_unit_test_setup_teardown(visitors_undo_their_own_on_the_cpu, set_up, tear_down),
        cmocka_unit_test_setup_teardown(visitors_undo_their_own_on_the_gpu, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_fresh_sheet_of_the_cpu_is_bare, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_fresh_sheet_of_the_gpu_is_bare, set_up, tear_down),
        cmocka_unit_test_setup_teardown(another_script_keeps_the_painting_of_the_cpu, set_up, tear_down),
        cmocka_unit_test_setup_teardown(another_script_keeps_the_painting_of_the_gpu, set_up, tear_down),
        cmocka_unit_test_setup_teardown(undo_survives_a_reset, set_up, tear_down),
        cmocka_unit_test_setup_teardown(it_rests_while_nobody_looks, set_up, tear_down),
        cmocka_unit_test_setup_teardown(it_tells_which_fields_hold_what_was_posted, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_frame_never_waits_for_a_tick, set_up, tear_down),
        cmocka_unit_test_setup_teardown(paths_are_copied_and_long_ones_refused, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
