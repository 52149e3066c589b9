#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include <json.h>

#include "bench.h"
#include "command.h"
#include "json_number.h"
#include "option.h"
#include "script_value.h"

static const char HELP[] =
    "usage: frond bench [NAME] [--json]\n\n"
    "Measures Frond on this machine; every bench there is if no NAME is given. Takes a minute\n"
    "or two; leave the machine alone meanwhile.\n\n"
    "      --json  {\"bench\": NAME, \"figures\": [{\"name\", \"value\", \"unit\"}]}, one a line\n"
    "      --help  this\n\n"
    "Benches: ";

static const struct {
    const char *name;
    bool (*run)(struct bench *bench);
} BENCHES[] = {{"painting", bench_painting}, {"gpu", bench_graphics},        {"trees", bench_trees},
               {"growth", bench_growth},     {"chemistry", bench_chemistry}, {"scenes", bench_scenes}};
enum { BENCH_COUNT = sizeof BENCHES / sizeof BENCHES[0] };

static void print_json(const struct bench *bench)
{
    struct json_object *object = json_object_new_object(), *figures = json_object_new_array();
    for (int i = 0; i < bench->count; i++) {
        struct json_object *figure = json_object_new_object();
        json_object_object_add(figure, "name", json_object_new_string(bench->figures[i].name));
        json_object_object_add(figure, "value", json_number(bench->figures[i].value, 6));
        json_object_object_add(figure, "unit", json_object_new_string(bench->figures[i].unit));
        json_object_array_add(figures, figure);
    }
    json_object_object_add(object, "bench", json_object_new_string(bench->name));
    json_object_object_add(object, "figures", figures);
    puts(json_object_to_json_string_ext(object, JSON_C_TO_STRING_PLAIN | JSON_C_TO_STRING_NOSLASHESCAPE));
    json_object_put(object);
}

static void print_table(const struct bench *bench)
{
    printf("%s: %s\n", bench->name, bench->meaning);
    for (int i = 0; i < bench->count; i++) {
        const struct bench_figure *figure = &bench->figures[i];
        printf("  %-34s %9.4g %-12s", figure->name, figure->value, figure->unit);
        if (figure->of_triad > 0) {
            printf(" %5.2f passes over the state at triad speed", figure->of_triad);
        }
        putchar('\n');
    }
}

static int run_bench(const char *name, bool json)
{
    struct names names = {.count = 0};
    bool found = false;
    for (int i = 0; i < BENCH_COUNT; i++) {
        names.names[names.count++] = BENCHES[i].name;
        if (name && strcmp(name, BENCHES[i].name) != 0) {
            continue;
        }
        struct bench bench = {.count = 0};
        found = true;
        if (!BENCHES[i].run(&bench)) {
            fprintf(stderr, "frond bench %s: %s\n", BENCHES[i].name,
                    bench.meaning_text[0] ? bench.meaning_text : "memory is short");
            return EXIT_STATUS_FAILED;
        }
        if (json) {
            print_json(&bench);
        } else {
            print_table(&bench);
        }
    }
    if (!found) {
        char allowed[256];
        names_allowed(&names, name, allowed, sizeof allowed);
        fprintf(stderr, "frond bench: no bench '%s'; %s\n", name, allowed);
        return EXIT_STATUS_USAGE;
    }
    return EXIT_STATUS_GOOD;
}

int command_bench(int argc, char *argv[])
{
    struct asked {
        bool json;
    } asked = {false};
    static const struct option_row OPTIONS[] = {{"json", OPTION_FLAG, .offset = offsetof(struct asked, json)},
                                                {.name = NULL}};
    char help[800] = "";
    snprintf(help, sizeof help, "%s", HELP);
    for (int i = 0; i < BENCH_COUNT; i++) {
        size_t length = strlen(help);
        snprintf(help + length, sizeof help - length, "%s%s", BENCHES[i].name, i + 1 < BENCH_COUNT ? ", " : "\n");
    }
    int status = options_read("bench", help, OPTIONS, argc, argv, &asked);
    if (status >= 0) {
        return status;
    }
    if (argc - optind > 1) {
        fprintf(stderr, "frond bench: one NAME at the most; see frond bench --help\n");
        return EXIT_STATUS_USAGE;
    }
    return run_bench(optind < argc ? argv[optind] : NULL, asked.json);
}
