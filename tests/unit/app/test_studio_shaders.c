/* The thread that paints takes shaders from a folder anew when they change (app/studio/studio.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "display.h"
#include "folder_case.h"
#include "patience.h"
#include "program.h"
#include "studio.h"

static const char SCRIPT[] = "frond: 1\n"
                             "canvas: {width: 96, height: 96}\n"
                             "ticks: 1000000\n"
                             "actions:\n"
                             "  - {tick: 0, drop: {at: [0.5, 0.5]}}\n";

static void nap(void)
{
    struct timespec time = {0, 5000000};
    nanosleep(&time, NULL);
}

static void put_source(const char *folder, const char *name, const char *text)
{
    char path[FOLDER_CASE_PATH + 80];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    assert_true(folder_case_put(path, text));
}

/* Who works on a shader sees it at once, and one that does not compile stops nothing. */
static void shaders_are_looked_at_again(void **state)
{
    (void)state;
    struct display_def seen = display_default_def();
    struct script_def script_def = script_default_def();
    struct studio_def def = studio_default_def();
    struct device_error trouble;
    struct studio_error error;
    struct report problems;
    report_init(&problems, "shaders");
    struct script *script = script_parse(SCRIPT, strlen(SCRIPT), ".", &script_def, &problems);
    report_finish(&problems);
    seen.kind = DISPLAY_HEADLESS;
    seen.width = seen.height = 16;
    struct display *display = display_create(&seen, &trouble);
    assert_true(script && display);
    char folder[FOLDER_CASE_PATH];
    assert_true(folder_case_make(folder));
    for (const struct shader_source *source = shader_sources; source->name; source++) {
        put_source(folder, source->name, source->text);
    }
    const struct shader_folder from = {folder};
    def.script = script;
    def.engine = ENGINE_GPU;
    def.folder = &from;
    struct studio *studio = studio_create(&def, display, &error);
    assert_non_null(studio);
    for (int waited = 0; studio_report(studio).ticks < 1 && waited < PATIENCE_MS; waited += 5) {
        nap();
    }
    put_source(folder, "publish.comp", "void main() { this is no shader }\n");
    struct studio_report report = {.trouble = ""};
    for (int waited = 0; !report.trouble[0] && waited < PATIENCE_MS; waited += 5) {
        nap();
        report = studio_report(studio);
    }
    assert_non_null(strstr(report.trouble, "publish.comp"));
    int64_t then = report.ticks;
    for (int waited = 0; report.ticks <= then + 5 && waited < PATIENCE_MS; waited += 5) {
        nap();
        report = studio_report(studio);
    }
    assert_true(report.ticks > then + 5);
    studio_destroy(studio);
    script_destroy(script);
    display_destroy(display);
    assert_true(folder_case_remove(folder));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(shaders_are_looked_at_again)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
