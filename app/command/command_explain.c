#include <getopt.h>
#include <stdio.h>

#include "command.h"
#include "exhibit.h"
#include "explain.h"
#include "inputs.h"
#include "option.h"
#include "script_value.h"

static const char HELP[] =
    "usage: frond explain [KEY]\n\n"
    "Every key of exhibits, session scripts and inputs files: type, range, unit, default and meaning. KEY is\n"
    "a key (radius), a key with its place (drop.radius), a verb (drop), a section (canvas; exhibit, inputs:\n"
    "all of such a file), or the name of a coefficient, a brush, an ink or a palette.\n";

static struct names names_of_tables(const struct inputs_table *tables)
{
    struct names names = {.count = 0};
    for (const struct inputs_table *table = tables; table->name; table++) {
        names.names[names.count++] = table->name;
    }
    return names;
}

static void suggest(const char *asked)
{
    struct names names = names_of_keys(script_keys);
    struct names more[] = {names_of_verbs(), names_of_keys(coefficient_keys), names_of_keys(canvas_keys),
                           names_of_tables(exhibit_tables), names_of_tables(inputs_tables)};
    for (size_t i = 0; i < sizeof more / sizeof *more; i++) {
        for (int k = 0; k < more[i].count && names.count < NAMES_MAX; k++) {
            names.names[names.count++] = more[i].names[k];
        }
    }
    char allowed[2400];
    fprintf(stderr, "frond explain: nothing is called '%s'; %s, and their keys\n", asked,
            names_allowed(&names, asked, allowed, sizeof allowed));
}

int command_explain(int argc, char *argv[])
{
    static const struct option options[] = {{"help", no_argument, NULL, 'h'}, {NULL, 0, NULL, 0}};
    int option;
    optind = 0;
    while ((option = getopt_long(argc, argv, ":h", options, NULL)) != -1) {
        if (option != 'h') {
            return option_usage("explain", option, argv);
        }
        fputs(HELP, stdout);
        return EXIT_STATUS_GOOD;
    }
    if (argc - optind > 1) {
        fprintf(stderr, "frond explain: one key at a time; see frond explain --help\n");
        return EXIT_STATUS_USAGE;
    }
    const char *asked = optind < argc ? argv[optind] : NULL;
    if (!explain(asked, stdout)) {
        suggest(asked);
        return EXIT_STATUS_USAGE;
    }
    return EXIT_STATUS_GOOD;
}
