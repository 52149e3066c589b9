#include <getopt.h>
#include <stdio.h>

#include "command.h"
#include "option.h"
#include "pictures.h"
#include "script.h"

static const char HELP[] =
    "usage: frond check SCRIPT...\n\n"
    "Reads session scripts, with their formulas and pictures, and prints every problem as\n"
    "file:line:column: key: what was found; what is allowed. Prints nothing when all is well.\n\n"
    "Exit status: 0 all are valid, 1 one is not, 2 the command line is wrong.\n";

int command_check(int argc, char *argv[])
{
    static const struct option options[] = {{"help", no_argument, NULL, 'h'}, {NULL, 0, NULL, 0}};
    int option;
    optind = 0;
    while ((option = getopt_long(argc, argv, ":h", options, NULL)) != -1) {
        if (option != 'h') {
            return option_usage("check", option, argv);
        }
        fputs(HELP, stdout);
        return EXIT_STATUS_GOOD;
    }
    if (optind == argc) {
        fprintf(stderr, "frond check: no script is given; see frond check --help\n");
        return EXIT_STATUS_USAGE;
    }
    struct script_def def = script_default_def();
    def.load = pictures_load;
    int status = EXIT_STATUS_GOOD;
    for (int i = optind; i < argc; i++) {
        struct report report;
        report_init(&report, argv[i]);
        struct script *script = script_read(argv[i], &def, &report);
        report_print(&report, stderr);
        status = script ? status : EXIT_STATUS_FAILED;
        script_destroy(script);
        report_finish(&report);
    }
    return status;
}
