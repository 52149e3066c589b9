#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "explain.h"
#include "grow.h"
#include "option.h"
#include "script_value.h"

static const char HELP[] =
    "usage: frond grow PICTURE -o FILE.png [OPTIONS]\n\n"
    "Grows a dendrite or a tree over a picture, so that the picture can be seen in it.\n\n"
    "  -o, --output FILE          .png; .svg: a path for each branch, with widths; .exr: planes for each\n"
    "                             layer. May be given again\n"
    "      --background PICTURE   stands in this picture, its colours matched to it\n"
    "      --stats FILE.json      endpoints, length, components, cycles, coverage of importance\n"
    "      --help                 this\n\n"
    "Defaults are those of a dendrite in ink; --metaphor and --tree bring others.\n\n";

enum { OPTIONS_MAX = 64, FIRST_KEY = 1000, BACKGROUND = 256, STATS, HELP_ASKED };

/* The two tables as one row of options. */
struct row {
    const struct key *key;
    size_t offset; /* of the struct that the table describes */
};

static int list_rows(struct row rows[OPTIONS_MAX])
{
    int count = 0;
    for (const struct key *key = growth_keys; key->name; key++) {
        rows[count++] = (struct row){key, offsetof(struct grow_def, growth)};
    }
    for (const struct key *key = grow_keys; key->name; key++) {
        rows[count++] = (struct row){key, 0};
    }
    return count;
}

static void print_help(void)
{
    struct row rows[OPTIONS_MAX];
    int count = list_rows(rows);
    fputs(HELP, stdout);
    for (int i = 0; i < count; i++) {
        char range[1400], name[40];
        bool flag = rows[i].key->type == KEY_FLAG;
        snprintf(name, sizeof name, "--%s%s", rows[i].key->name, flag ? "" : " VALUE");
        printf("      %-22s %s\n", name, rows[i].key->meaning);
        if (!flag) {
            printf("      %-22s %s\n", "", explain_range(rows[i].key, range, sizeof range));
        }
    }
}

static int wrong(const struct key *key, const char *found)
{
    char allowed[1200];
    fprintf(stderr, "frond grow: --%s: '%s' is not it; %s\n", key->name, found,
            value_allowed(key, allowed, sizeof allowed));
    return EXIT_STATUS_USAGE;
}

static bool take_number(const char **text, const struct key *key, double *number)
{
    char *end = NULL;
    errno = 0;
    *number = strtod(*text, &end);
    bool good = end != *text && !errno && *number >= key->min && *number <= key->max;
    *text = end;
    return good;
}

static bool take_point(const char *text, const struct key *key, struct point *point)
{
    double x, y;
    if (!take_number(&text, key, &x) || *text++ != ',' || !take_number(&text, key, &y) || *text) {
        return false;
    }
    *point = (struct point){(float)x, (float)y};
    return true;
}

static bool take_choice(const char *text, const struct key *key, int *choice)
{
    struct names names = names_of_choices(key->choices);
    int found = names_find(&names, text);
    if (found >= 0) {
        memcpy(choice, &found, sizeof found);
    }
    return found >= 0;
}

/* One value into its field. */
static bool take_value(struct grow_def *def, const struct row *row, const char *text)
{
    const struct key *key = row->key;
    void *field = (char *)def + row->offset + key->offset;
    struct growth_def *growth = &def->growth;
    double number;
    switch (key->type) {
    case KEY_FLAG:
        *(bool *)field = true;
        return true;
    case KEY_CHOICE:
        return take_choice(text, key, field);
    case KEY_POINT:
        return take_point(text, key, field);
    case KEY_PATH:
        if (growth->plants.count == GROWTH_PLANTS_MAX || !take_point(text, key, &growth->plant[growth->plants.count])) {
            return false;
        }
        growth->plants = (struct action_path){growth->plant, growth->plants.count + 1};
        return true;
    case KEY_INTEGER:
        return option_whole(text, (long)key->min, (long)key->max, field);
    default:
        if (!take_number(&text, key, &number) || *text) {
            return false;
        }
        *(float *)field = (float)number;
        return true;
    }
}

static int list_options(const struct row *rows, int count, struct option options[OPTIONS_MAX + 6])
{
    static const struct option OWN[] = {{"output", required_argument, NULL, 'o'},
                                        {"background", required_argument, NULL, BACKGROUND},
                                        {"stats", required_argument, NULL, STATS},
                                        {"help", no_argument, NULL, HELP_ASKED}};
    int listed = 0;
    for (size_t i = 0; i < sizeof OWN / sizeof *OWN; i++) {
        options[listed++] = OWN[i];
    }
    for (int i = 0; i < count; i++) {
        options[listed++] = (struct option){
            rows[i].key->name, rows[i].key->type == KEY_FLAG ? no_argument : required_argument, NULL, FIRST_KEY + i};
    }
    options[listed] = (struct option){NULL, 0, NULL, 0};
    return listed;
}

static int take_file(struct grow_def *def, int option)
{
    if (option == BACKGROUND) {
        def->background = optarg;
    } else if (option == STATS) {
        def->stats = optarg;
    } else if (def->output_count == GROW_OUTPUTS_MAX) {
        fprintf(stderr, "frond grow: no more than %d outputs\n", GROW_OUTPUTS_MAX);
        return EXIT_STATUS_USAGE;
    } else {
        def->outputs[def->output_count++] = optarg;
    }
    return -1;
}

/* One pass over the options: those that choose the defaults, or all others. -1: go on. */
static int take_options(struct grow_def *def, int argc, char *argv[], const struct row *rows,
                        const struct option *options, bool choosing)
{
    optind = 0;
    for (int option; (option = getopt_long(argc, argv, ":o:h", options, NULL)) != -1;) {
        if (option == '?' || option == ':') {
            return option_usage("grow", option, argv);
        }
        if (option == HELP_ASKED || option == 'h') {
            print_help();
            return EXIT_STATUS_GOOD;
        }
        if (option < FIRST_KEY) {
            int status = choosing ? -1 : take_file(def, option);
            if (status >= 0) {
                return status;
            }
            continue;
        }
        const struct row *row = &rows[option - FIRST_KEY];
        bool chooses = strcmp(row->key->name, "metaphor") == 0 || strcmp(row->key->name, "tree") == 0;
        if (chooses == choosing && !take_value(def, row, optarg)) {
            return wrong(row->key, optarg);
        }
    }
    return -1;
}

int command_grow(int argc, char *argv[])
{
    struct row rows[OPTIONS_MAX];
    struct option options[OPTIONS_MAX + 6];
    int count = list_rows(rows);
    (void)list_options(rows, count, options);
    struct grow_def def = grow_default_def();
    int status = take_options(&def, argc, argv, rows, options, true);
    if (status < 0) {
        def.growth = growth_preset((enum metaphor)def.growth.metaphor, def.growth.tree);
        status = take_options(&def, argc, argv, rows, options, false);
    }
    if (status >= 0) {
        return status;
    }
    if (optind + 1 != argc) {
        fprintf(stderr, "frond grow: %s; see frond grow --help\n",
                optind < argc ? "one picture at a time" : "no picture is given");
        return EXIT_STATUS_USAGE;
    }
    if (def.output_count == 0 && !def.stats) {
        fprintf(stderr, "frond grow: nothing is asked for: -o FILE.png; see frond grow --help\n");
        return EXIT_STATUS_USAGE;
    }
    def.picture = argv[optind];
    struct file_error error;
    if (!grow(&def, &error)) {
        fprintf(stderr, "frond grow: %s\n", error.text);
        return EXIT_STATUS_FAILED;
    }
    return EXIT_STATUS_GOOD;
}
