#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "command.h"
#include "option.h"
#include "pictures.h"
#include "render.h"
#include "session.h"

static const char HELP[] = "usage: frond run [SCRIPT]\n\n"
                           "Shows Frond on what is there. Without a display that is the demonstration session, or\n"
                           "SCRIPT, rendered to out/ in the current folder: the picture, two pixels a cell, and a\n"
                           "folder of how it grew. The paths are printed.\n";

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

int command_run(int argc, char *argv[])
{
    static const struct option options[] = {{"help", no_argument, NULL, 'h'}, {NULL, 0, NULL, 0}};
    char demonstration[1300];
    int option;
    optind = 0;
    while ((option = getopt_long(argc, argv, ":h", options, NULL)) != -1) {
        if (option != 'h') {
            return option_usage("run", option, argv);
        }
        fputs(HELP, stdout);
        return EXIT_STATUS_GOOD;
    }
    if (argc - optind > 1) {
        fprintf(stderr, "frond run: one script at a time; see frond run --help\n");
        return EXIT_STATUS_USAGE;
    }
    const char *path = optind < argc ? argv[optind] : demonstration;
    if (path == demonstration && !session_find("demonstration", demonstration, sizeof demonstration)) {
        fprintf(stderr, "frond run: the demonstration, sessions/demonstration.yaml, is not installed\n");
        return EXIT_STATUS_FAILED;
    }
    struct script_def def = script_default_def();
    def.load = pictures_load;
    struct report report;
    report_init(&report, path);
    struct script *script = script_read(path, &def, &report);
    report_print(&report, stderr);
    int status = script ? render_session(path, script) : EXIT_STATUS_FAILED;
    script_destroy(script);
    report_finish(&report);
    return status;
}
