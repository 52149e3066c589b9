#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "command.h"
#include "live.h"
#include "option.h"
#include "pictures.h"
#include "render.h"
#include "script_sheet.h"
#include "session.h"

static const char HELP[] =
    "usage: frond run [SCRIPT] [OPTIONS]\n\n"
    "Paints the demonstration session, or SCRIPT, live on what is there: a window where a desktop\n"
    "runs, else the screen of the board, on a canvas of its shape. Touch it. Where there is neither,\n"
    "the session is rendered to out/ in the current folder: the picture, two pixels a cell, and a\n"
    "folder of how it grew.\n\n"
    "      --display KIND    auto, kms (the screen itself), window, headless (memory), or none: the\n"
    "                        session is rendered to out/ whatever there is\n"
    "      --card PATH       kms: the graphics card, /dev/dri/card1\n"
    "      --connector NAME  kms: where the screen is plugged in, HDMI-A-1\n"
    "      --mode WxH[@HZ]   pixels of the screen or the window; what it prefers if left out\n"
    "      --rotate DEGREES  0, 90, 180 or 270, clockwise; touch turns along\n"
    "      --inputs FILE     what visitors do, and with which devices (frond explain inputs); else fingers\n"
    "                        paint, gamepads have a point on the sheet, dials turn coefficients\n"
    "      --hold            on a screen: no key reaches the system, neither Ctrl-C nor a change of console\n"
    "      --engine KIND     auto (the faster, by timing both once on this machine), cpu, gpu\n"
    "      --rate N          ticks a second, 1 to 1000; 60 if left out\n"
    "      --ticks N         instead of the script's\n"
    "      --once            paint the session once and leave it there; else it begins again and again\n"
    "      --frames N        end after so many frames\n"
    "      --shot FILE.png   the last frame, written at the end\n"
    "      --full            compute everything, however slow or hot the machine\n"
    "      --xray            the layers of the painting instead of its picture\n"
    "      --shaders DIR     shader sources from a folder, looked at again when they change\n"
    "      --help            this\n";

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
    if (mkdir(OUT, 0777) != 0 && errno != EEXIST) {
        fprintf(stderr, "frond run: %s: the folder cannot be made: %s\n", OUT, strerror(errno));
        return EXIT_STATUS_FAILED;
    }
    struct progress progress = progress_start(picture, stderr);
    if (!render(script, &def, &progress, &error)) {
        fprintf(stderr, "frond run: %s\n", error.text);
        return EXIT_STATUS_FAILED;
    }
    printf("%s\n%s/\n", picture, frames);
    return EXIT_STATUS_GOOD;
}

enum {
    DISPLAY = 256,
    CARD,
    CONNECTOR,
    MODE,
    ROTATE,
    INPUTS,
    HOLD,
    ENGINE,
    RATE,
    TICKS,
    ONCE,
    FRAMES,
    SHOT,
    XRAY,
    FULL,
    SHADERS,
    HELP_ASKED,
    RATE_MOST = 1000,
};

struct order {
    struct display_def display;
    struct live_def live;
    bool none;          /* no display at all: render */
    int ticks;          /* -1: the script's */
    const char *inputs; /* path; NULL: the default ones */
};

static int wrong(const char *option, const char *found, const char *allowed)
{
    fprintf(stderr, "frond run: --%s: '%s' is not it; %s\n", option, found, allowed);
    return EXIT_STATUS_USAGE;
}

/* "1920x1080" or "1920x1080@59.94". */
static bool take_mode(const char *text, struct display_def *def)
{
    char size[32];
    const char *at = strchr(text, '@');
    size_t length = at ? (size_t)(at - text) : strlen(text);
    if (length >= sizeof size) {
        return false;
    }
    memcpy(size, text, length);
    size[length] = '\0';
    if (at) {
        char *end;
        double hertz = strspn(at + 1, "0123456789.") > 0 ? strtod(at + 1, &end) : 0;
        if (!(hertz >= 1 && hertz <= 1000) || *end) {
            return false;
        }
        def->refresh_mhz = (int)(hertz * 1000 + 0.5);
    }
    return option_size(size, DISPLAY_SIZE_MAX, &def->width, &def->height);
}

static bool take_display(const char *name, struct order *order)
{
    order->none = strcmp(name, "none") == 0;
    for (int i = 0; i < DISPLAY_KINDS; i++) {
        if (strcmp(display_kind_name((enum display_kind)i), name) == 0) {
            order->display.kind = (enum display_kind)i;
            return true;
        }
    }
    return order->none;
}

/* Options of the screen; -1 when it is right, or none of these. */
static int take_display_option(struct order *order, int option)
{
    struct display_def *def = &order->display;
    switch (option) {
    case DISPLAY:
        return take_display(optarg, order) ? -1 : wrong("display", optarg, "one of auto, kms, window, headless, none");
    case CARD:
        def->card = optarg;
        return -1;
    case CONNECTOR:
        def->connector = optarg;
        return -1;
    case MODE:
        return take_mode(optarg, def) ? -1 : wrong("mode", optarg, "WxH or WxH@HZ, each side 1 to 8192 pixels");
    case ROTATE:
        if (!option_whole(optarg, 0, 270, &def->rotation) || def->rotation % 90 != 0) {
            return wrong("rotate", optarg, "0, 90, 180 or 270 degrees");
        }
        return -1;
    default:
        return -1;
    }
}

/* All other options; -1 when it is right, or none of these. */
static int take_live_option(struct order *order, int option)
{
    int whole;
    switch (option) {
    case ENGINE:
        order->live.engine = engine_kind_find(optarg);
        return order->live.engine < ENGINE_KINDS ? -1 : wrong("engine", optarg, "one of auto, cpu, gpu");
    case RATE:
        if (!option_whole(optarg, 1, RATE_MOST, &whole)) {
            return wrong("rate", optarg, "1 to 1000 ticks a second");
        }
        order->live.ticks_per_second = whole;
        return -1;
    case TICKS:
        return option_whole(optarg, 0, SCRIPT_TICKS_MAX, &order->ticks) ? -1
                                                                        : wrong("ticks", optarg, "0 to 10000000 ticks");
    case FRAMES:
        if (!option_whole(optarg, 1, SCRIPT_TICKS_MAX, &whole)) {
            return wrong("frames", optarg, "1 to 10000000 frames");
        }
        order->live.frames = whole;
        return -1;
    case INPUTS:
        order->inputs = optarg;
        return -1;
    case HOLD:
        order->live.hold = true;
        return -1;
    case ONCE:
        order->live.once = true;
        return -1;
    case SHOT:
        order->live.shot = optarg;
        return -1;
    case FULL:
        order->live.governed = false;
        return -1;
    case XRAY:
        order->live.xray = true;
        return -1;
    case SHADERS:
        order->live.shaders = optarg;
        return -1;
    default:
        return -1;
    }
}

static int show(struct script *script, const char *path, const struct order *order, const struct inputs *inputs)
{
    struct display_error error;
    if (order->none) {
        return render_session(path, script);
    }
    struct display *display = display_create(&order->display, &error);
    if (!display && order->display.kind != DISPLAY_AUTO) {
        fprintf(stderr, "frond run: %s\n", error.text);
        return EXIT_STATUS_FAILED;
    }
    if (!display || (order->display.kind == DISPLAY_AUTO && display_kind(display) == DISPLAY_HEADLESS)) {
        display_destroy(display);
        fprintf(stderr, "frond run: neither a desktop nor a screen: rendering to %s/\n", OUT);
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
static int show_with_inputs(struct script *script, const char *path, const struct order *order)
{
    struct script_def def = script_default_def();
    struct report report;
    if (!order->inputs) {
        return show(script, path, order, NULL);
    }
    def.load = pictures_load;
    report_init(&report, order->inputs);
    struct inputs *inputs = inputs_read(order->inputs, script, &def, &report);
    report_print(&report, stderr);
    report_finish(&report);
    int status = inputs ? show(script, path, order, inputs) : EXIT_STATUS_FAILED;
    inputs_destroy(inputs);
    return status;
}

static int run_script(const char *path, const struct order *order)
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

/* Reads the command line; -1 when it is right, else the exit status. */
static int read_order(int argc, char *argv[], struct order *order)
{
    static const struct option options[] = {{"display", required_argument, NULL, DISPLAY},
                                            {"card", required_argument, NULL, CARD},
                                            {"connector", required_argument, NULL, CONNECTOR},
                                            {"mode", required_argument, NULL, MODE},
                                            {"rotate", required_argument, NULL, ROTATE},
                                            {"inputs", required_argument, NULL, INPUTS},
                                            {"hold", no_argument, NULL, HOLD},
                                            {"engine", required_argument, NULL, ENGINE},
                                            {"rate", required_argument, NULL, RATE},
                                            {"ticks", required_argument, NULL, TICKS},
                                            {"once", no_argument, NULL, ONCE},
                                            {"frames", required_argument, NULL, FRAMES},
                                            {"shot", required_argument, NULL, SHOT},
                                            {"xray", no_argument, NULL, XRAY},
                                            {"full", no_argument, NULL, FULL},
                                            {"shaders", required_argument, NULL, SHADERS},
                                            {"help", no_argument, NULL, HELP_ASKED},
                                            {NULL, 0, NULL, 0}};
    int option, status = -1;
    optind = 0;
    while (status < 0 && (option = getopt_long(argc, argv, ":h", options, NULL)) != -1) {
        if (option == HELP_ASKED || option == 'h') {
            fputs(HELP, stdout);
            return EXIT_STATUS_GOOD;
        }
        if (option == '?' || option == ':') {
            return option_usage("run", option, argv);
        }
        status = take_display_option(order, option);
        status = status < 0 ? take_live_option(order, option) : status;
    }
    if (status < 0 && argc - optind > 1) {
        fprintf(stderr, "frond run: one script at a time; see frond run --help\n");
        return EXIT_STATUS_USAGE;
    }
    return status;
}

int command_run(int argc, char *argv[])
{
    struct order order = {.display = display_default_def(), .live = live_default_def(), .ticks = -1};
    char demonstration[1300];
    int status = read_order(argc, argv, &order);
    if (status >= 0) {
        return status;
    }
    const char *path = optind < argc ? argv[optind] : demonstration;
    if (path == demonstration && !session_find("demonstration", demonstration, sizeof demonstration)) {
        fprintf(stderr, "frond run: the demonstration, sessions/demonstration.yaml, is not installed\n");
        return EXIT_STATUS_FAILED;
    }
    return run_script(path, &order);
}
