#include "option.h"

#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "engine_choice.h"

static bool take_whole(const char **text, long least, long most, int *value)
{
    if (strspn(*text, "0123456789") == 0) { /* strtol would take blanks and signs */
        return false;
    }
    char *end = NULL;
    errno = 0;
    long number = strtol(*text, &end, 10);
    if (errno || number < least || number > most) {
        return false;
    }
    *text = end;
    *value = (int)number;
    return true;
}

bool option_whole(const char *text, long least, long most, int *value)
{
    return take_whole(&text, least, most, value) && *text == '\0';
}

bool option_size(const char *text, long most, int *width, int *height)
{
    return take_whole(&text, 1, most, width) && *text++ == 'x' && take_whole(&text, 1, most, height) && *text == '\0';
}

int option_usage(const char *name, int result, char *const argv[])
{
    char letter[3] = {'-', (char)optopt, '\0'};
    bool is_long = optopt == 0 || strncmp(argv[optind - 1], "--", 2) == 0;
    fprintf(stderr, "frond %s: %s: %s; see frond %s --help\n", name, is_long ? argv[optind - 1] : letter,
            result == ':' ? "a value is missing" : "unknown option", name);
    return EXIT_STATUS_USAGE;
}

int option_wrong(const char *command, const char *option, const char *found, const char *allowed)
{
    fprintf(stderr, "frond %s: --%s: '%s' is not it; %s\n", command, option, found, allowed);
    return EXIT_STATUS_USAGE;
}

/* One value into its field. */
static bool take(const struct option_row *row, const char *text, void *object)
{
    char *field = (char *)object + row->offset;
    switch (row->kind) {
    case OPTION_TEXT:
        *(const char **)(void *)field = text;
        return true;
    case OPTION_FLAG:
    case OPTION_UNFLAG:
        *(bool *)field = row->kind == OPTION_FLAG;
        return true;
    case OPTION_WHOLE:
        return option_whole(text, row->least, row->most, (int *)(void *)field);
    case OPTION_SIZE:
        return option_size(text, row->most, (int *)(void *)field, (int *)(void *)field + 1);
    case OPTION_ENGINE: {
        enum engine_kind engine = engine_kind_find(text);
        memcpy(field, &engine, sizeof engine);
        return engine != ENGINE_KINDS;
    }
    case OPTION_OWN:
        return row->take(text, object);
    }
    return false;
}

/* What a row allows, as people read it. */
static const char *allowed_of(const struct option_row *row, char *buffer, size_t size)
{
    switch (row->kind) {
    case OPTION_WHOLE:
        snprintf(buffer, size, "%ld to %ld%s", row->least, row->most, row->unit);
        return buffer;
    case OPTION_SIZE:
        snprintf(buffer, size, "WxH, each 1 to %ld pixels", row->most);
        return buffer;
    case OPTION_ENGINE:
        return "one of auto, cpu, gpu";
    default:
        return row->unit;
    }
}

static void print_help(const char *help, const struct option_row *rows)
{
    char allowed[80];
    for (size_t plain; *help; help += plain) {
        plain = strcspn(help + 1, "{") + 1;
        size_t name = strcspn(help, "}") - 1;
        const struct option_row *row = rows;
        while (row->name && (*help != '{' || strlen(row->name) != name || strncmp(row->name, help + 1, name) != 0)) {
            row++;
        }
        if (row->name) {
            fputs(allowed_of(row, allowed, sizeof allowed), stdout);
            plain = name + 2;
        } else {
            fwrite(help, 1, plain, stdout);
        }
    }
}

enum { ROWS_MOST = 32, FIRST_ROW = 256 };

static void list_options(const struct option_row *rows, struct option listed[ROWS_MOST + 2], char letters[8])
{
    int count = 0;
    snprintf(letters, 8, ":h");
    for (; rows[count].name && count < ROWS_MOST; count++) {
        bool flag = rows[count].kind == OPTION_FLAG || rows[count].kind == OPTION_UNFLAG;
        bool output = strcmp(rows[count].name, "output") == 0;
        listed[count] = (struct option){rows[count].name, flag ? no_argument : required_argument, NULL,
                                        output ? 'o' : FIRST_ROW + count};
        if (output) {
            snprintf(letters, 8, ":o:h");
        }
    }
    listed[count] = (struct option){"help", no_argument, NULL, 'h'};
    listed[count + 1] = (struct option){NULL, 0, NULL, 0};
}

int options_read(const char *command, const char *help, const struct option_row *rows, int argc, char *argv[],
                 void *object)
{
    struct option listed[ROWS_MOST + 2];
    char letters[8], allowed[80];
    int option, index;
    list_options(rows, listed, letters);
    optind = 0;
    while ((option = getopt_long(argc, argv, letters, listed, NULL)) != -1) {
        if (option == 'h') {
            print_help(help, rows);
            return EXIT_STATUS_GOOD;
        }
        if (option == '?' || option == ':') {
            return option_usage(command, option, argv);
        }
        for (index = 0; listed[index].val != option; index++) {
        }
        if (!take(&rows[index], optarg, object)) {
            return option_wrong(command, rows[index].name, optarg, allowed_of(&rows[index], allowed, sizeof allowed));
        }
    }
    return -1;
}
