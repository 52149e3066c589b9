#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "option.h"
#include "picture.h"
#include "plan.h"
#include "replay.h"
#include "script.h"

static const char HELP[] =
    "usage: frond replay JOURNAL [-o FILE.png] [OPTIONS]\n\n"
    "Paints again what a journal holds, from its first tick to its last.\n\n"
    "  -o, --output FILE.png  the picture at its end\n"
    "      --scale N          a print: pixels a cell of that picture, 1 to 16\n"
    "      --size WxH         pixels of the pictures and the film; a pixel a cell if left out\n"
    "      --frames DIR       pictures on the way: DIR/000010.png, numbered by tick\n"
    "      --video FILE       the same as a film of 30 pictures a second, FILE.mp4 or FILE.webm, by ffmpeg\n"
    "      --every N          ticks from one picture on the way to the next; 10 if left out: five times as\n"
    "                         fast as it was painted\n"
    "      --svg FILE.svg     the branches at the end as strokes in millimetres, for plotters and embroidery\n"
    "      --paper MM         width of its sheet; 200 if left out\n"
    "      --stats FILE.json  sums, extremes, the figures of the shape and the hash of the end\n"
    "      --engine KIND      cpu (if left out), gpu, or auto: the faster on this machine. Only the CPU's\n"
    "                         repeats a painting to the bit\n"
    "      --shaders DIR      shader sources from a folder, for those who work on them\n"
    "      --threads N        one for each processor if left out; the painting is the same\n"
    "      --help             this\n\n"
    "A print is the painting itself with --scale 4 or so: the same cells, drawn with more pixels each. Ink,\n"
    "edges, light and the grain of the paper are shaded at the size of the print, so it is sharp at any scale.\n"
    "On a finer grid the same hand would paint another picture: what grows, grows by cells.\n";

enum {
    FRAMES = 256,
    VIDEO,
    EVERY,
    STATS,
    SVG,
    PAPER,
    SCALE,
    SIZE,
    THREADS,
    ENGINE,
    SHADERS,
    HELP_ASKED,
    THREADS_MAX = 64
};

static int wrong(const char *option, const char *found, const char *allowed)
{
    fprintf(stderr, "frond replay: --%s: '%s' is not it; %s\n", option, found, allowed);
    return EXIT_STATUS_USAGE;
}

/* One that is a number or one of some words; -1 when it is right. */
static int take_value(struct replay_def *def, int option)
{
    int paper;
    switch (option) {
    case PAPER:
        if (!option_whole(optarg, PLAN_PAPER_LEAST, PLAN_PAPER_MOST, &paper)) {
            return wrong("paper", optarg, "10 to 5000 mm");
        }
        def->paper_mm = paper;
        return -1;
    case ENGINE:
        def->easel.engine = engine_kind_find(optarg);
        return def->easel.engine == ENGINE_KINDS ? wrong("engine", optarg, "one of auto, cpu, gpu") : -1;
    case EVERY:
        return option_whole(optarg, 1, SCRIPT_TICKS_MAX, &def->every) ? -1
                                                                      : wrong("every", optarg, "1 to 10000000 ticks");
    case SCALE:
        return option_whole(optarg, 1, REPLAY_SCALE_MOST, &def->scale) ? -1 : wrong("scale", optarg, "1 to 16");
    case SIZE:
        return option_size(optarg, PICTURE_SIZE_MAX, &def->width, &def->height)
                   ? -1
                   : wrong("size", optarg, "WxH, each 1 to 16384 pixels");
    case THREADS:
        return option_whole(optarg, 1, THREADS_MAX, &def->easel.threads) ? -1 : wrong("threads", optarg, "1 to 64");
    default:
        return -1;
    }
}

static int take_option(struct replay_def *def, int option)
{
    switch (option) {
    case 'o':
        def->picture = optarg;
        return -1;
    case FRAMES:
        def->frames = optarg;
        return -1;
    case VIDEO:
        def->video = optarg;
        return -1;
    case STATS:
        def->stats = optarg;
        return -1;
    case SVG:
        def->svg = optarg;
        return -1;
    case SHADERS:
        def->easel.shaders = optarg;
        return -1;
    default:
        return take_value(def, option);
    }
}

/* Reads the command line. False when that was all, with the exit status. */
static bool read_order(int argc, char *argv[], struct replay_def *def, int *status)
{
    static const struct option options[] = {
        {"output", required_argument, NULL, 'o'},    {"frames", required_argument, NULL, FRAMES},
        {"video", required_argument, NULL, VIDEO},   {"every", required_argument, NULL, EVERY},
        {"stats", required_argument, NULL, STATS},   {"scale", required_argument, NULL, SCALE},
        {"size", required_argument, NULL, SIZE},     {"threads", required_argument, NULL, THREADS},
        {"engine", required_argument, NULL, ENGINE}, {"shaders", required_argument, NULL, SHADERS},
        {"svg", required_argument, NULL, SVG},       {"paper", required_argument, NULL, PAPER},
        {"help", no_argument, NULL, HELP_ASKED},     {NULL, 0, NULL, 0}};
    int option;
    optind = 0;
    while ((option = getopt_long(argc, argv, ":o:h", options, NULL)) != -1) {
        if (option == HELP_ASKED || option == 'h') {
            fputs(HELP, stdout);
            *status = EXIT_STATUS_GOOD;
            return false;
        }
        *status = option == '?' || option == ':' ? option_usage("replay", option, argv) : take_option(def, option);
        if (*status >= 0) {
            return false;
        }
    }
    *status = EXIT_STATUS_USAGE;
    if (optind + 1 != argc) {
        fprintf(stderr, "frond replay: %s; see frond replay --help\n",
                optind < argc ? "one journal at a time" : "no journal is given");
        return false;
    }
    if (!def->picture && !def->frames && !def->video && !def->stats && !def->svg) {
        fprintf(stderr, "frond replay: nothing is asked for: -o FILE.png, or another; see frond replay --help\n");
        return false;
    }
    def->journal = argv[optind];
    return true;
}

int command_replay(int argc, char *argv[])
{
    struct replay_def def = replay_default_def();
    struct replay_result result;
    struct file_error error;
    char what[96];
    int status;
    if (!read_order(argc, argv, &def, &status)) {
        return status;
    }
    const char *slash = strrchr(def.journal, '/');
    snprintf(what, sizeof what, "%.80s", slash ? slash + 1 : def.journal);
    struct progress progress = progress_start(what, stderr);
    bool good = replay(&def, &progress, &result, &error);
    if (!good) {
        fprintf(stderr, "frond replay: %s\n", error.text);
    } else if (result.remark[0]) {
        fprintf(stderr, "frond replay: %s: %s\n", what, result.remark);
    }
    return good ? EXIT_STATUS_GOOD : EXIT_STATUS_FAILED;
}
