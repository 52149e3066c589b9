#include "run_show.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "live_kiosk.h"
#include "pictures.h"
#include "render.h"
#include "script_sheet.h"
#include "session.h"
#include "state.h"

static const char OUT[] = "out";

enum {
    RUN_SCALE = 2,  /* pixels a cell: the edges of branches come out smooth */
    RUN_FRAMES = 6, /* pictures on the way; each took half a second of 38 s for the demonstration, on two cores */
};

/* "sessions/night.yaml" becomes "out/night" and what comes after it. */
static void name_output(const char *script, const char *ending, char *path, size_t size)
{
    const char *slash = strrchr(script, '/');
    const char *name = slash ? slash + 1 : script;
    const char *dot = strrchr(name, '.');
    int length = dot && dot > name ? (int)(dot - name) : (int)strlen(name);
    snprintf(path, size, "%s/%.*s%s", OUT, length, name, ending);
}

static int render_session(const char *path, const struct script *script)
{
    char picture[300], frames[300];
    struct file_error error;
    struct render_def def = render_default_def();
    name_output(path, ".png", picture, sizeof picture);
    name_output(path, "-growth", frames, sizeof frames);
    def.picture = picture;
    def.frames = frames;
    def.every = script->ticks > RUN_FRAMES ? script->ticks / RUN_FRAMES : 1;
    def.width = RUN_SCALE * script->width;
    def.height = RUN_SCALE * script->height;
    struct progress progress = progress_start(picture, stderr);
    if (!file_make_folder(OUT, &error) || !render(script, &def, &progress, &error)) {
        fprintf(stderr, "frond run: %s\n", error.text);
        return EXIT_STATUS_FAILED;
    }
    printf("%s\n%s/\n", picture, frames);
    return EXIT_STATUS_GOOD;
}

/* The display that was asked for. NULL: none is to be had, and `status` is the exit status, or EXIT_STATUS_GOOD where
 * there is neither a desktop nor a screen. */
static struct display *open_display(const struct display_def *def, int *status)
{
    struct device_error error;
    struct display *display = display_create(def, &error);
    *status = EXIT_STATUS_GOOD;
    if (!display && def->kind != DISPLAY_AUTO) {
        fprintf(stderr, "frond run: %s\n", error.text);
        *status = EXIT_STATUS_FAILED;
    } else if (display && def->kind == DISPLAY_AUTO && display_kind(display) == DISPLAY_HEADLESS) {
        display_destroy(display);
        display = NULL;
    }
    return display;
}

static int show_session(struct script *script, const char *path, const struct run_order *order,
                        const struct inputs *inputs)
{
    int status = EXIT_STATUS_GOOD;
    struct display *display = order->none ? NULL : open_display(&order->display, &status);
    if (!display && status != EXIT_STATUS_GOOD) {
        return status;
    }
    if (!display) {
        if (!order->none) {
            fprintf(stderr, "frond run: neither a desktop nor a screen: rendering to %s/\n", OUT);
        }
        return render_session(path, script);
    }
    struct display_size size = display_sheet(display);
    if (size.width > 0 && size.height > 0) {
        script_fit(script, size.width, size.height);
    }
    struct live_def def = order->live;
    def.rotation = order->display.rotation;
    def.inputs = inputs;
    bool good = live(script, display, &def);
    display_destroy(display);
    return good ? EXIT_STATUS_GOOD : EXIT_STATUS_FAILED;
}

/* With the inputs that were asked for, which are for this script's inks. */
static int show_with_inputs(struct script *script, const char *path, const struct run_order *order)
{
    struct script_def def = script_default_def();
    struct report report;
    if (!order->inputs) {
        return show_session(script, path, order, NULL);
    }
    def.load = pictures_load;
    report_init(&report, order->inputs);
    struct inputs *inputs = inputs_read(order->inputs, script, &def, &report);
    report_print(&report, stderr);
    report_finish(&report);
    int status = inputs ? show_session(script, path, order, inputs) : EXIT_STATUS_FAILED;
    inputs_destroy(inputs);
    return status;
}

static int run_session(const char *path, const struct run_order *order)
{
    struct script_def def = script_default_def();
    struct report report;
    int status = EXIT_STATUS_FAILED;
    def.load = pictures_load;
    report_init(&report, path);
    struct script *script = script_read(path, &def, &report);
    report_print(&report, stderr);
    if (script) {
        script->ticks = order->ticks >= 0 ? order->ticks : script->ticks;
        status = show_with_inputs(script, path, order);
    }
    script_destroy(script);
    report_finish(&report);
    return status;
}

static int run_demonstration(const struct run_order *order)
{
    char path[1300];
    if (!session_find("demonstration", path, sizeof path)) {
        fprintf(stderr, "frond run: the demonstration, sessions/demonstration.yaml, is not installed\n");
        return EXIT_STATUS_FAILED;
    }
    return run_session(path, order);
}

/* What the exhibit wants of its screen, but for what the command line says. */
static struct display_def exhibit_display(const struct exhibit *exhibit, const struct run_order *order)
{
    const struct exhibit_display *wanted = &exhibit->display;
    struct display_def def = order->display;
    def.connector = def.connector ? def.connector : wanted->connector;
    def.rotation = order->rotated ? def.rotation : wanted->rotation;
    if (def.width == 0 && wanted->mode_width > 0) {
        def.width = wanted->mode_width;
        def.height = wanted->mode_height;
        def.refresh_mhz = (int)lroundf(1000 * wanted->refresh);
    }
    return def;
}

static int show_exhibit(struct exhibit *exhibit, const char *trouble, struct display *display,
                        const struct display_def *def, const struct run_order *order)
{
    char state[1200];
    struct display_size size = display_sheet(display);
    struct live_def live_def = order->live;
    live_kiosk_fit(exhibit, size.width, size.height);
    live_def.exhibit = exhibit;
    live_def.trouble = trouble;
    live_def.rotation = def->rotation;
    live_def.ticks_per_second = order->rate > 0 ? order->rate : exhibit->sheet.rate;
    live_def.engine = live_def.engine == ENGINE_AUTO ? (enum engine_kind)exhibit->engine : live_def.engine;
    if (!live_def.state && state_path("", state, sizeof state)) {
        live_def.state = state;
    }
    return live(exhibit->scenes[0].script, display, &live_def) ? EXIT_STATUS_GOOD : EXIT_STATUS_FAILED;
}

/* `trouble`: as in struct live_def. */
static int run_exhibit(struct exhibit *exhibit, const char *trouble, const struct run_order *order, bool asked)
{
    int status = EXIT_STATUS_GOOD;
    struct display_def def = exhibit_display(exhibit, order);
    struct display *display = order->none ? NULL : open_display(&def, &status);
    if (display) {
        status = show_exhibit(exhibit, trouble, display, &def, order);
        display_destroy(display);
        return status;
    }
    if (status == EXIT_STATUS_GOOD && !asked) {
        exhibit_destroy(exhibit);
        return run_demonstration(order);
    }
    if (status == EXIT_STATUS_GOOD) {
        fprintf(stderr, "frond run: %s: neither a desktop nor a screen; --display headless shows it in memory\n",
                exhibit->path);
        status = EXIT_STATUS_FAILED;
    }
    exhibit_destroy(exhibit);
    return status;
}

static bool names_exhibit(const char *path)
{
    struct report report;
    size_t size = 0;
    report_init(&report, path);
    char *text = script_load(path, &size, &report);
    bool is = text && exhibit_is(text, size);
    free(text);
    report_finish(&report);
    return is;
}

/* An exhibit with nothing but defaults in the place of one that cannot be read. */
static struct exhibit *stand_in(const char *path, const struct script_def *def)
{
    static const char PLAIN[] = "exhibit: 1\n";
    struct report report;
    char *folder = script_folder(path);
    report_init(&report, path);
    struct exhibit *exhibit = folder ? exhibit_parse(PLAIN, sizeof PLAIN - 1, folder, def, &report) : NULL;
    report_finish(&report);
    free(folder);
    return exhibit;
}

static int read_and_run(const char *path, const struct run_order *order, bool asked)
{
    struct script_def def = script_default_def();
    struct report report;
    char *trouble = NULL;
    int status = EXIT_STATUS_FAILED;
    def.load = pictures_load;
    report_init(&report, path);
    struct exhibit *exhibit = exhibit_read(path, &def, &report);
    if (!exhibit && order->standby) {
        trouble = report_text(&report);
        exhibit = stand_in(path, &def);
    } else {
        report_print(&report, stderr);
    }
    report_finish(&report);
    if (exhibit) {
        status = run_exhibit(exhibit, trouble, order, asked);
    }
    free(trouble);
    return status;
}

int run_show(const char *path, const struct run_order *order)
{
    char shipped[1300];
    if (path && !order->standby && !names_exhibit(path)) {
        return run_session(path, order);
    }
    if (!path && (order->none || !exhibit_find("touch-table", shipped, sizeof shipped))) {
        return run_demonstration(order);
    }
    return read_and_run(path ? path : shipped, order, path);
}
