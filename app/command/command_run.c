#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "option.h"
#include "run_show.h"

static const char HELP[] =
    "usage: frond run [EXHIBIT|SESSION] [OPTIONS]\n\n"
    "Shows the touch table, or another EXHIBIT, on what is there: a window where a desktop runs, else\n"
    "the screen of the board. Touch it. An edit to its file, its pictures or its sessions is taken up\n"
    "at once; one that has an error is not, and the staff is told (frond check). A SESSION, a script of\n"
    "actions, is painted live in the same way. Where there is neither a desktop nor a screen, a session,\n"
    "the demonstration if none is given, is rendered to out/ in the current folder: the picture, two\n"
    "pixels a cell, and a folder of how it grew.\n\n"
    "What the command line says of display, engine and rate comes before what the exhibit says.\n\n"
    "      --display KIND    auto, kms (the screen itself), window, headless (memory), or none: the\n"
    "                        session is rendered to out/ whatever there is\n"
    "      --card PATH       kms: the graphics card, /dev/dri/card1\n"
    "      --connector NAME  kms: where the screen is plugged in, HDMI-A-1\n"
    "      --mode WxH[@HZ]   pixels of the screen or the window; what it prefers if left out\n"
    "      --rotate DEGREES  0, 90, 180 or 270, clockwise; touch turns along\n"
    "      --state DIR       where the gallery is kept; $STATE_DIRECTORY or ~/.local/state/frond if left out\n"
    "      --open            whatever the exhibit's schedule says\n"
    "      --inputs FILE     sessions: what visitors do, and with which devices (frond explain inputs); else fingers\n"
    "                        paint, gamepads have a point on the sheet, dials turn coefficients\n"
    "      --hold            on a screen: no key reaches the system, neither Ctrl-C nor a change of console\n"
    "      --console PATH    with --hold: a console, /dev/tty1, that takes no keys either; the unit of the service\n"
    "                        must own it\n"
    "      --standby         an EXHIBIT that is wrong, or not there, is waited for; until then a plain one stands\n"
    "                        in for it, and the staff is told\n"
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

enum {
    DISPLAY = 256,
    CARD,
    CONNECTOR,
    MODE,
    ROTATE,
    INPUTS,
    HOLD,
    CONSOLE,
    STANDBY,
    ENGINE,
    RATE,
    TICKS,
    ONCE,
    FRAMES,
    SHOT,
    XRAY,
    FULL,
    SHADERS,
    STATE,
    OPEN,
    HELP_ASKED,
    RATE_MOST = 1000,
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

static bool take_display(const char *name, struct run_order *order)
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
static int take_display_option(struct run_order *order, int option)
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
        order->rotated = true;
        return -1;
    default:
        return -1;
    }
}

/* All other options; -1 when it is right, or none of these. */
static int take_live_option(struct run_order *order, int option)
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
        order->live.ticks_per_second = order->rate = whole;
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
    case CONSOLE:
        order->live.console = optarg;
        return -1;
    case STANDBY:
        order->standby = true;
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
    case OPEN:
        order->live.open = true;
        return -1;
    case STATE:
        order->live.state = optarg;
        return -1;
    default:
        return -1;
    }
}

/* Reads the command line; -1 when it is right, else the exit status. */
static int read_order(int argc, char *argv[], struct run_order *order)
{
    static const struct option options[] = {{"display", required_argument, NULL, DISPLAY},
                                            {"card", required_argument, NULL, CARD},
                                            {"connector", required_argument, NULL, CONNECTOR},
                                            {"mode", required_argument, NULL, MODE},
                                            {"rotate", required_argument, NULL, ROTATE},
                                            {"inputs", required_argument, NULL, INPUTS},
                                            {"hold", no_argument, NULL, HOLD},
                                            {"console", required_argument, NULL, CONSOLE},
                                            {"standby", no_argument, NULL, STANDBY},
                                            {"engine", required_argument, NULL, ENGINE},
                                            {"rate", required_argument, NULL, RATE},
                                            {"ticks", required_argument, NULL, TICKS},
                                            {"once", no_argument, NULL, ONCE},
                                            {"frames", required_argument, NULL, FRAMES},
                                            {"shot", required_argument, NULL, SHOT},
                                            {"xray", no_argument, NULL, XRAY},
                                            {"full", no_argument, NULL, FULL},
                                            {"shaders", required_argument, NULL, SHADERS},
                                            {"state", required_argument, NULL, STATE},
                                            {"open", no_argument, NULL, OPEN},
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
        fprintf(stderr, "frond run: one exhibit or session at a time; see frond run --help\n");
        return EXIT_STATUS_USAGE;
    }
    return status;
}

int command_run(int argc, char *argv[])
{
    struct run_order order = {.display = display_default_def(), .live = live_default_def(), .ticks = -1};
    int status = read_order(argc, argv, &order);
    if (status >= 0) {
        return status;
    }
    return run_show(optind < argc ? argv[optind] : NULL, &order);
}
