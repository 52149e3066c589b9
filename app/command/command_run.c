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
    "      --rotate DEGREES  {rotate}, clockwise; touch turns along\n"
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
    "      --rate N          {rate}; 60 if left out\n"
    "      --ticks N         instead of the script's\n"
    "      --once            paint the session once and leave it there; else it begins again and again\n"
    "      --frames N        end after so many frames\n"
    "      --shot FILE.png   the last frame, written at the end\n"
    "      --full            compute everything, however slow or hot the machine\n"
    "      --xray            the layers of the painting instead of its picture\n"
    "      --shaders DIR     shader sources from a folder, looked at again when they change\n"
    "      --help            this\n";

enum { RATE_MOST = 1000 };

/* "1920x1080" or "1920x1080@59.94". */
static bool take_mode(const char *text, void *object)
{
    struct display_def *def = &((struct run_order *)object)->display;
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

static bool take_display(const char *name, void *object)
{
    struct run_order *order = object;
    order->none = strcmp(name, "none") == 0;
    for (int i = 0; i < DISPLAY_KINDS; i++) {
        if (strcmp(display_kind_name((enum display_kind)i), name) == 0) {
            order->display.kind = (enum display_kind)i;
            return true;
        }
    }
    return order->none;
}

static bool take_rotation(const char *text, void *object)
{
    struct run_order *order = object;
    order->rotated = true;
    return option_whole(text, 0, 270, &order->display.rotation) && order->display.rotation % 90 == 0;
}

#define ORDER(field)        .offset = offsetof(struct run_order, field)
#define OWN(taken, allowed) .unit = (allowed), .take = (taken)

static const struct option_row OPTIONS[] = {
    {"display", OPTION_OWN, OWN(take_display, "one of auto, kms, window, headless, none")},
    {"card", OPTION_TEXT, ORDER(display.card)},
    {"connector", OPTION_TEXT, ORDER(display.connector)},
    {"mode", OPTION_OWN, OWN(take_mode, "WxH or WxH@HZ, each side 1 to 8192 pixels")},
    {"rotate", OPTION_OWN, OWN(take_rotation, "0, 90, 180 or 270 degrees")},
    {"state", OPTION_TEXT, ORDER(live.state)},
    {"open", OPTION_FLAG, ORDER(live.open)},
    {"inputs", OPTION_TEXT, ORDER(inputs)},
    {"hold", OPTION_FLAG, ORDER(live.hold)},
    {"console", OPTION_TEXT, ORDER(live.console)},
    {"standby", OPTION_FLAG, ORDER(standby)},
    {"engine", OPTION_ENGINE, ORDER(live.engine)},
    {"rate", OPTION_WHOLE, ORDER(rate), 1, RATE_MOST, " ticks a second"},
    {"ticks", OPTION_WHOLE, ORDER(ticks), 0, SCRIPT_TICKS_MAX, " ticks"},
    {"once", OPTION_FLAG, ORDER(live.once)},
    {"frames", OPTION_WHOLE, ORDER(live.frames), 1, SCRIPT_TICKS_MAX, " frames"},
    {"shot", OPTION_TEXT, ORDER(live.shot)},
    {"full", OPTION_UNFLAG, ORDER(live.governed)},
    {"xray", OPTION_FLAG, ORDER(live.xray)},
    {"shaders", OPTION_TEXT, ORDER(live.shaders)},
    {.name = NULL},
};

int command_run(int argc, char *argv[])
{
    struct run_order order = {.display = display_default_def(), .live = live_default_def(), .ticks = -1};
    int status = options_read("run", HELP, OPTIONS, argc, argv, &order);
    if (status >= 0) {
        return status;
    }
    if (argc - optind > 1) {
        fprintf(stderr, "frond run: one exhibit or session at a time; see frond run --help\n");
        return EXIT_STATUS_USAGE;
    }
    order.live.ticks_per_second = order.rate > 0 ? order.rate : order.live.ticks_per_second;
    return run_show(optind < argc ? argv[optind] : NULL, &order);
}
