#include "command.h"

#include <stdio.h>
#include <string.h>

#include "script_value.h"

const struct command commands[] = {
    {"run", "[EXHIBIT]", "the kiosk: an exhibit, or a session, live on what is there", command_run},
    {"render", "SCRIPT -o FILE.png", "a session without a display", command_render},
    {"grow", "PICTURE -o FILE.png", "a dendrite or a tree in which a picture can be seen", command_grow},
    {"bolt", "-o FILE.png", "lightning, coral, rivers and the like: pictures, meshes, heights", command_bolt},
    {"replay", "JOURNAL -o FILE.png", "a painting again, from its journal: picture, print, film", command_replay},
    {"check", "FILE...", "prints every problem of exhibits, sessions and inputs files", command_check},
    {"explain", "[KEY]", "every key of exhibits and sessions: type, range, default, meaning", command_explain},
    {"devices", "[--watch]", "what is plugged in, what is missing, and how to mend it", command_devices},
    {"report", "[-o FILE.tar.gz]", "what somebody who helps needs to know, without personal data", command_report},
    {"bench", "[NAME] [--json]", "the measurements in the README", command_bench},
    {.name = NULL},
};

static void print_help(void)
{
    printf("Frond paints: a drop of ink on a wet white ground branches like frost.\n\n"
           "usage: frond COMMAND [ARGUMENTS]\n\n");
    for (const struct command *command = commands; command->name; command++) {
        char call[64];
        snprintf(call, sizeof call, "%s %s", command->name, command->arguments);
        printf("  frond %-26s %s\n", call, command->meaning);
    }
    printf("  frond --help                     this; every command has its own\n"
           "  frond --version                  the version\n\n"
           "Exit status: 0 good, 1 something is wrong with a file, 2 with the command line.\n");
}

int command_line(int argc, char *argv[])
{
    struct names names = {.count = 0};
    const char *name = argc > 1 ? argv[1] : "";
    if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0 || strcmp(name, "help") == 0) {
        print_help();
        return EXIT_STATUS_GOOD;
    }
    if (strcmp(name, "--version") == 0) {
        printf("frond %s\n", FROND_VERSION);
        return EXIT_STATUS_GOOD;
    }
    for (const struct command *command = commands; command->name; command++) {
        if (strcmp(command->name, name) == 0) {
            return command->run(argc - 1, argv + 1);
        }
        names.names[names.count++] = command->name;
    }
    char allowed[256];
    names_allowed(&names, name, allowed, sizeof allowed);
    if (argc > 1) {
        fprintf(stderr, "frond: unknown command '%s'; %s\n", name, allowed);
    } else {
        fprintf(stderr, "frond: no command; %s; see frond --help\n", allowed);
    }
    return EXIT_STATUS_USAGE;
}
