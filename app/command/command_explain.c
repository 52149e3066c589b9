#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "exhibit.h"
#include "explain.h"
#include "growth.h"
#include "inputs.h"
#include "option.h"
#include "pictures.h"
#include "script_value.h"

static const char HELP[] =
    "usage: frond explain [KEY]\n"
    "       frond explain graph EXHIBIT [--json | --dot]\n\n"
    "Every key of exhibits, session scripts and inputs files: type, range, unit, default and meaning. KEY is\n"
    "a key (radius), a key with its place (drop.radius), a verb (drop), a section (canvas; exhibit, inputs:\n"
    "all of such a file), or the name of a coefficient, a brush, an ink or a palette.\n\n"
    "graph draws which scenes of an exhibit feed which: as boxes and arrows, as JSON, or for Graphviz.\n";

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
    struct inputs_tables inputs;
    struct names names = names_of_keys(script_keys);
    struct names more[] = {names_of_verbs(),
                           names_of_keys(coefficient_keys),
                           names_of_keys(canvas_keys),
                           names_of_tables(exhibit_tables),
                           names_of_tables(inputs_tables_of(&inputs)),
                           names_of_keys(growth_keys)};
    for (size_t i = 0; i < sizeof more / sizeof *more; i++) {
        for (int k = 0; k < more[i].count && names.count < NAMES_MAX; k++) {
            names.names[names.count++] = more[i].names[k];
        }
    }
    char allowed[2400];
    fprintf(stderr, "frond explain: nothing is called '%s'; %s, and their keys\n", asked,
            names_allowed(&names, asked, allowed, sizeof allowed));
}

typedef void drawing(const struct graph *graph, FILE *out);

static int explain_graph(const char *path, drawing *draw)
{
    struct script_def def = script_default_def();
    struct report report;
    def.load = pictures_load;
    report_init(&report, path);
    struct exhibit *exhibit = exhibit_read(path, &def, &report);
    if (exhibit) {
        struct graph graph = exhibit_graph(exhibit);
        draw(&graph, stdout);
    } else {
        report_print(&report, stderr);
    }
    exhibit_destroy(exhibit);
    report_finish(&report);
    return exhibit ? EXIT_STATUS_GOOD : EXIT_STATUS_FAILED;
}

/* KEY, or graph EXHIBIT. */
static int explain_words(int count, char *words[], drawing *draw)
{
    if (count > 0 && strcmp(words[0], "graph") == 0) {
        if (count == 2) {
            return explain_graph(words[1], draw ? draw : graph_draw);
        }
        fprintf(stderr, "frond explain graph: %s; see frond explain --help\n",
                count < 2 ? "no exhibit is given" : "one exhibit at a time");
        return EXIT_STATUS_USAGE;
    }
    if (count > 1 || draw) {
        fprintf(stderr, "frond explain: %s; see frond explain --help\n",
                count > 1 ? "one key at a time" : "--json and --dot are for graph EXHIBIT");
        return EXIT_STATUS_USAGE;
    }
    const char *asked = count > 0 ? words[0] : NULL;
    if (!explain(asked, stdout)) {
        suggest(asked);
        return EXIT_STATUS_USAGE;
    }
    return EXIT_STATUS_GOOD;
}

int command_explain(int argc, char *argv[])
{
    struct drawn {
        bool json, dot;
    } drawn = {false, false};
    static const struct option_row OPTIONS[] = {
        {"json", OPTION_FLAG, .offset = offsetof(struct drawn, json)},
        {"dot", OPTION_FLAG, .offset = offsetof(struct drawn, dot)},
        {.name = NULL},
    };
    int status = options_read("explain", HELP, OPTIONS, argc, argv, &drawn);
    drawing *draw = drawn.json ? graph_draw_json : drawn.dot ? graph_draw_dot : NULL;
    return status < 0 ? explain_words(argc - optind, argv + optind, draw) : status;
}
