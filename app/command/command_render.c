#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "easel.h"
#include "exhibit.h"
#include "feeder.h"
#include "option.h"
#include "picture.h"
#include "pictures.h"
#include "plan.h"
#include "render.h"
#include "script_value.h"

static const char HELP[] = "usage: frond render SCRIPT -o FILE.png [OPTIONS]\n"
                           "       frond render EXHIBIT --scene ID -o FILE.png [OPTIONS]\n\n"
                           "Renders a session script without a display; or a scene of an exhibit, as it grows by\n"
                           "itself, with what other scenes give it.\n\n"
                           "  -o, --output FILE.png  the picture at the end of the session\n"
                           "      --size WxH         pixels of the picture; a pixel a cell if left out\n"
                           "      --frames DIR       pictures on the way: DIR/000010.png, numbered by tick\n"
                           "      --every N          ticks from one of those to the next; 10 if left out\n"
                           "      --fields FILE.exr  every field of the painting, as float channels\n"
                           "      --stats FILE.json  sums, extremes and the figures of the shape\n"
                           "      --journal FILE     the session as a journal, for frond replay\n"
                           "      --svg FILE.svg         the branches as strokes in millimetres, for plotters and\n"
                           "                             embroidery\n"
                           "      --paper MM             width of its sheet; 200 if left out\n"
                           "      --scene ID         the scene of the exhibit\n"
                           "      --seed N           instead of the script's\n"
                           "      --ticks N          instead of the script's\n"
                           "      --engine KIND      cpu (if left out), gpu, or auto: the faster on this machine.\n"
                           "                         Only the CPU's repeats a picture to the bit\n"
                           "      --shaders DIR      shader sources from a folder, for those who work on them\n"
                           "      --threads N        one for each processor if left out; the picture is the same\n"
                           "      --dense            nothing sleeps; the picture is the same\n"
                           "      --help             this\n";

struct order {
    struct render_def def;
    const char *script, *scene;
    int seed, ticks; /* -1: the script's */
};

#define ORDER(field) .offset = offsetof(struct order, field)

static const struct option_row OPTIONS[] = {
    {"output", OPTION_TEXT, ORDER(def.picture)},
    {"size", OPTION_SIZE, ORDER(def.width), .most = PICTURE_SIZE_MAX},
    {"frames", OPTION_TEXT, ORDER(def.frames)},
    {"every", OPTION_WHOLE, ORDER(def.every), 1, SCRIPT_TICKS_MAX, " ticks"},
    {"fields", OPTION_TEXT, ORDER(def.fields)},
    {"stats", OPTION_TEXT, ORDER(def.stats)},
    {"journal", OPTION_TEXT, ORDER(def.journal)},
    {"svg", OPTION_TEXT, ORDER(def.svg)},
    {"paper", OPTION_WHOLE, ORDER(def.paper_mm), PLAN_PAPER_LEAST, PLAN_PAPER_MOST, " mm"},
    {"scene", OPTION_TEXT, ORDER(scene)},
    {"seed", OPTION_WHOLE, ORDER(seed), 0, 2147483647, ""},
    {"ticks", OPTION_WHOLE, ORDER(ticks), 0, SCRIPT_TICKS_MAX, " ticks"},
    {"engine", OPTION_ENGINE, ORDER(def.engine)},
    {"shaders", OPTION_TEXT, ORDER(def.shaders)},
    {"threads", OPTION_WHOLE, ORDER(def.threads), 1, EASEL_THREADS_MOST, ""},
    {"dense", OPTION_FLAG, ORDER(def.dense)},
    {.name = NULL},
};

/* Reads the command line; -1 when it is right, else the exit status. */
static int read_order(int argc, char *argv[], struct order *order)
{
    int status = options_read("render", HELP, OPTIONS, argc, argv, order);
    if (status >= 0) {
        return status;
    }
    if (optind + 1 != argc) {
        fprintf(stderr, "frond render: %s; see frond render --help\n",
                optind < argc ? "one script at a time" : "no script is given");
        return EXIT_STATUS_USAGE;
    }
    if (!order->def.picture && !order->def.svg) {
        fprintf(stderr, "frond render: no picture is asked for: -o FILE.png; see frond render --help\n");
        return EXIT_STATUS_USAGE;
    }
    order->script = argv[optind];
    return -1;
}

static bool render_script(const struct order *order, struct script *script, struct file_error *error)
{
    char what[96];
    const char *slash = strrchr(order->script, '/');
    snprintf(what, sizeof what, "%.80s", slash ? slash + 1 : order->script);
    struct progress progress = progress_start(what, stderr);
    script->seed = order->seed >= 0 ? order->seed : script->seed;
    script->ticks = order->ticks >= 0 ? order->ticks : script->ticks;
    return render(script, &order->def, &progress, error);
}

/* The scene of that id; -1, and said on stderr, where there is none. */
static int find_scene(const struct exhibit *exhibit, const char *id)
{
    struct names names = {.count = 0};
    char allowed[800];
    for (int i = 0; i < exhibit->scene_count; i++) {
        names.names[names.count++] = exhibit->scenes[i].id;
    }
    int found = names_find(&names, id);
    if (found < 0) {
        fprintf(stderr, "frond render: --scene: no scene is called '%s'; %s\n", id,
                names_allowed(&names, id, allowed, sizeof allowed));
    }
    return found;
}

static int render_exhibit(const struct order *order, const struct script_def *def, struct report *report)
{
    struct exhibit *exhibit = exhibit_read(order->script, def, report);
    int scene = exhibit ? find_scene(exhibit, order->scene) : -1;
    struct feeder *feeder = feeder_create(&(struct feeder_def){exhibit, *def, order->def.threads, NULL});
    struct feeder_session *session = calloc(1, sizeof *session);
    struct file_error error;
    bool ready = feeder && session, good = scene >= 0 && ready;
    if (!ready) {
        file_fail(&error, order->script, "memory is short");
    } else if (good) {
        good = feeder_open(feeder, scene, exhibit->scenes[scene].script->ticks, session, &error) &&
               render_script(order, &session->script, &error);
    }
    if (scene >= 0 && !good) {
        fprintf(stderr, "frond render: %s\n", error.text);
    } else if (!exhibit) {
        report_print(report, stderr);
    }
    if (session) {
        feeder_close(session);
    }
    free(session);
    feeder_destroy(feeder);
    exhibit_destroy(exhibit);
    return good ? EXIT_STATUS_GOOD : exhibit && scene < 0 ? EXIT_STATUS_USAGE : EXIT_STATUS_FAILED;
}

int command_render(int argc, char *argv[])
{
    struct order order = {.def = render_default_def(), .seed = -1, .ticks = -1};
    int status = read_order(argc, argv, &order);
    if (status >= 0) {
        return status;
    }
    struct script_def def = script_default_def();
    def.load = pictures_load;
    struct report report;
    report_init(&report, order.script);
    if (order.scene) {
        status = render_exhibit(&order, &def, &report);
        report_finish(&report);
        return status;
    }
    struct script *script = script_read(order.script, &def, &report);
    struct file_error error;
    status = EXIT_STATUS_FAILED;
    if (!script) {
        report_print(&report, stderr);
    } else if (render_script(&order, script, &error)) {
        status = EXIT_STATUS_GOOD;
    } else {
        fprintf(stderr, "frond render: %s\n", error.text);
    }
    script_destroy(script);
    report_finish(&report);
    return status;
}
