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
    "      --scale N          a print: {scale} pixels a cell of that picture\n"
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

#define DEF(field) .offset = offsetof(struct replay_def, field)

static const struct option_row OPTIONS[] = {
    {"output", OPTION_TEXT, DEF(picture)},
    {"scale", OPTION_WHOLE, DEF(scale), 1, REPLAY_SCALE_MOST, ""},
    {"size", OPTION_SIZE, DEF(width), .most = PICTURE_SIZE_MAX},
    {"frames", OPTION_TEXT, DEF(frames)},
    {"video", OPTION_TEXT, DEF(video)},
    {"every", OPTION_WHOLE, DEF(every), 1, SCRIPT_TICKS_MAX, " ticks"},
    {"svg", OPTION_TEXT, DEF(svg)},
    {"paper", OPTION_WHOLE, DEF(paper_mm), PLAN_PAPER_LEAST, PLAN_PAPER_MOST, " mm"},
    {"stats", OPTION_TEXT, DEF(stats)},
    {"engine", OPTION_ENGINE, DEF(easel.engine)},
    {"shaders", OPTION_TEXT, DEF(easel.shaders)},
    {"threads", OPTION_WHOLE, DEF(easel.threads), 1, EASEL_THREADS_MOST, ""},
    {.name = NULL},
};

/* Reads the command line; -1 when it is right, else the exit status. */
static int read_order(int argc, char *argv[], struct replay_def *def)
{
    int status = options_read("replay", HELP, OPTIONS, argc, argv, def);
    if (status >= 0) {
        return status;
    }
    if (optind + 1 != argc) {
        fprintf(stderr, "frond replay: %s; see frond replay --help\n",
                optind < argc ? "one journal at a time" : "no journal is given");
        return EXIT_STATUS_USAGE;
    }
    if (!def->picture && !def->frames && !def->video && !def->stats && !def->svg) {
        fprintf(stderr, "frond replay: nothing is asked for: -o FILE.png, or another; see frond replay --help\n");
        return EXIT_STATUS_USAGE;
    }
    def->journal = argv[optind];
    return -1;
}

int command_replay(int argc, char *argv[])
{
    struct replay_def def = replay_default_def();
    struct replay_result result;
    struct file_error error;
    char what[96];
    int status = read_order(argc, argv, &def);
    if (status >= 0) {
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
