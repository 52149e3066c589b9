#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>

#include "command.h"
#include "exhibit.h"
#include "inputs.h"
#include "option.h"
#include "pictures.h"
#include "script.h"

static const char HELP[] =
    "usage: frond check FILE...\n\n"
    "Reads exhibits, session scripts and inputs files, with the formulas, pictures and recorded sessions that they\n"
    "name, and prints every problem as file:line:column: key: what was found; what is allowed. Prints nothing when\n"
    "all is well. A line with 'warning:' is no problem: the file can be used, but is hardly meant so.\n\n"
    "Exit status: 0 all are valid, 1 one is not, 2 the command line is wrong.\n";

/* A session script, or by its key `exhibit` an exhibit, or by its key `inputs` an inputs file; an exhibit has both. */
static void check(const char *path, const struct script_def *def, struct report *report, struct report *warnings)
{
    size_t size = 0;
    char *text = script_load(path, &size, report);
    char *folder = script_folder(path);
    if (text && folder && exhibit_is(text, size)) {
        struct exhibit *exhibit = exhibit_parse(text, size, folder, def, report);
        if (exhibit) {
            exhibit_warn(exhibit, warnings);
        }
        exhibit_destroy(exhibit);
    } else if (text && folder && inputs_is(text, size)) {
        inputs_destroy(inputs_parse(text, size, folder, NULL, def, report));
    } else if (text && folder) {
        script_destroy(script_parse(text, size, folder, def, report));
    } else if (text) {
        report_add(report, 0, 0, "", "memory is short");
    }
    free(folder);
    free(text);
}

int command_check(int argc, char *argv[])
{
    static const struct option_row NONE[] = {{.name = NULL}};
    int status = options_read("check", HELP, NONE, argc, argv, NULL);
    if (status >= 0) {
        return status;
    }
    if (optind == argc) {
        fprintf(stderr, "frond check: no script is given; see frond check --help\n");
        return EXIT_STATUS_USAGE;
    }
    struct script_def def = script_default_def();
    def.load = pictures_load;
    def.every_picture = true;
    status = EXIT_STATUS_GOOD;
    for (int i = optind; i < argc; i++) {
        struct report report, warnings;
        report_init(&report, argv[i]);
        report_init(&warnings, argv[i]);
        check(argv[i], &def, &report, &warnings);
        report_print(&report, stderr);
        report_print(&warnings, stderr);
        report_finish(&warnings);
        status = report_empty(&report) ? status : EXIT_STATUS_FAILED;
        report_finish(&report);
    }
    return status;
}
