/* Which engine paints, and how that is remembered (app/engine_choice.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "display.h"
#include "engine_choice.h"
#include "folder_case.h"

static const char A_GPU[] = "a GPU"; /* whatever draws here is taken for one, and timed */

struct bench_place {
    struct display *display;
    char folder[FOLDER_CASE_PATH], path[128];
};

/* Of all threads: what others do on the machine does not count. */
static double processor_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int set_up(void **state)
{
    struct bench_place *place = calloc(1, sizeof *place);
    struct display_def def = display_default_def();
    struct device_error error;
    def.kind = DISPLAY_HEADLESS;
    def.width = def.height = 16;
    place->display = display_create(&def, &error);
    *state = place;
    if (!place->display || !folder_case_make(place->folder)) {
        return -1;
    }
    snprintf(place->path, sizeof place->path, "%s/engines.json", place->folder);
    return 0;
}

static int tear_down(void **state)
{
    struct bench_place *place = *state;
    bool good = folder_case_remove(place->folder);
    display_destroy(place->display);
    free(place);
    return good ? 0 : -1;
}

static struct painting_def small_sheet(void)
{
    struct painting_def def = painting_default_def();
    def.width = 200;
    def.height = 160;
    return def;
}

static void what_is_asked_for_is_taken(void **state)
{
    (void)state;
    struct painting_def def = small_sheet();
    struct engine_choice choice = engine_choose(ENGINE_GPU, &def, NULL, NULL, NULL);
    assert_int_equal(choice.kind, ENGINE_GPU);
    assert_string_equal(choice.why, "engine gpu: asked for");
    assert_int_equal(engine_choose(ENGINE_CPU, &def, NULL, NULL, NULL).kind, ENGINE_CPU);
}

static void without_a_gpu_it_is_the_cpu(void **state)
{
    (void)state;
    struct painting_def def = small_sheet();
    struct engine_choice choice = engine_choose(ENGINE_AUTO, &def, NULL, NULL, NULL);
    assert_int_equal(choice.kind, ENGINE_CPU);
    assert_string_equal(choice.why, "engine cpu: the GPU has none: no GLES 3.1");
}

static void a_gpu_that_is_the_cpu_is_not_timed(void **state)
{
    (void)state;
    struct painting_def def = small_sheet();
    struct engine_choice choice = engine_choose(ENGINE_AUTO, &def, "llvmpipe (LLVM 15.0.6, 256 bits)", NULL, NULL);
    assert_int_equal(choice.kind, ENGINE_CPU);
    assert_string_equal(choice.why, "engine cpu: llvmpipe (LLVM 15.0.6, 256 bits) draws with the processor, too");
}

static void both_are_timed_once_and_remembered(void **state)
{
    const struct bench_place *place = *state;
    struct painting_def def = small_sheet();
    engine_choose(ENGINE_AUTO, &def, A_GPU, NULL, NULL); /* the driver compiles the shaders, once */
    double start = processor_s();
    struct engine_choice first = engine_choose(ENGINE_AUTO, &def, A_GPU, NULL, place->path);
    double took = processor_s() - start;
    print_message("%.1f s of a processor\n", took);
    assert_true(first.cpu_ms > 0 && first.gpu_ms > 0);
    assert_false(first.remembered);
    assert_int_equal(first.kind, first.gpu_ms < first.cpu_ms ? ENGINE_GPU : ENGINE_CPU);
    if (took >= 4) { /* two seconds on a machine that nobody else uses */
        fail_msg("timing both engines took %.1f s", took);
    }
    struct engine_choice second = engine_choose(ENGINE_AUTO, &def, A_GPU, NULL, place->path);
    assert_true(second.remembered);
    assert_int_equal(second.kind, first.kind);
    assert_non_null(strstr(second.why, "(remembered)"));
    def.width = 208; /* another grid is another question */
    assert_false(engine_choose(ENGINE_AUTO, &def, A_GPU, NULL, place->path).remembered);
    assert_false(engine_choose(ENGINE_AUTO, &def, "another renderer", NULL, place->path).remembered);
}

static void a_spoilt_memory_is_made_anew(void **state)
{
    const struct bench_place *place = *state;
    static const char *const SPOILT[] = {"", "{", "[]", "{\"measured\": 3}", "{\"measured\": [1, null, {\"on\": 5}]}"};
    struct painting_def def = small_sheet();
    for (size_t i = 0; i < sizeof SPOILT / sizeof SPOILT[0]; i++) {
        FILE *file = fopen(place->path, "w");
        assert_non_null(file);
        fputs(SPOILT[i], file);
        fclose(file);
        def.width = def.height = 32; /* quick */
        assert_false(engine_choose(ENGINE_AUTO, &def, A_GPU, NULL, place->path).remembered);
        assert_true(engine_choose(ENGINE_AUTO, &def, A_GPU, NULL, place->path).remembered);
    }
}

static void the_state_folder_is_the_services_or_the_users(void **state)
{
    const struct bench_place *place = *state;
    char path[256], expected[256];
    setenv("STATE_DIRECTORY", place->folder, 1);
    assert_true(engine_choice_path(path, sizeof path));
    snprintf(expected, sizeof expected, "%s/engines.json", place->folder);
    assert_string_equal(path, expected);
    unsetenv("STATE_DIRECTORY");
    setenv("XDG_STATE_HOME", place->folder, 1);
    assert_true(engine_choice_path(path, sizeof path));
    snprintf(expected, sizeof expected, "%s/frond/engines.json", place->folder);
    assert_string_equal(path, expected);
    snprintf(expected, sizeof expected, "%s/frond", place->folder);
    assert_int_equal(rmdir(expected), 0); /* it was made */
    unsetenv("XDG_STATE_HOME");
    unsetenv("HOME");
    assert_false(engine_choice_path(path, sizeof path));
}

static void engines_have_names(void **state)
{
    (void)state;
    for (int i = 0; i < ENGINE_KINDS; i++) {
        assert_int_equal(engine_kind_find(engine_kind_name((enum engine_kind)i)), i);
    }
    assert_int_equal(engine_kind_find("abacus"), ENGINE_KINDS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_asked_for_is_taken),
        cmocka_unit_test(without_a_gpu_it_is_the_cpu),
        cmocka_unit_test(a_gpu_that_is_the_cpu_is_not_timed),
        cmocka_unit_test(both_are_timed_once_and_remembered),
        cmocka_unit_test(a_spoilt_memory_is_made_anew),
        cmocka_unit_test(the_state_folder_is_the_services_or_the_users),
        cmocka_unit_test(engines_have_names),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
