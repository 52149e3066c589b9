/* What `frond` can be told to do. */
#ifndef FROND_COMMAND_H
#define FROND_COMMAND_H

enum exit_status {
    EXIT_STATUS_GOOD = 0,
    EXIT_STATUS_FAILED = 1, /* a file is wrong, or cannot be read or written */
    EXIT_STATUS_USAGE = 2,  /* the command line is wrong */
};

struct command {
    const char *name, *arguments, *meaning;
    /* Takes the command's own arguments, argv[0] being its name. Returns an enum exit_status. */
    int (*run)(int argc, char *argv[]);
};

/* Ends with a command whose name is NULL. */
extern const struct command commands[];

int command_render(int argc, char *argv[]);
int command_replay(int argc, char *argv[]);
int command_check(int argc, char *argv[]);
int command_explain(int argc, char *argv[]);
int command_bench(int argc, char *argv[]);
int command_devices(int argc, char *argv[]);
int command_report(int argc, char *argv[]);
int command_run(int argc, char *argv[]);
int command_bolt(int argc, char *argv[]);
int command_grow(int argc, char *argv[]);

/* Finds the command in argv[1] and runs it; --help and --version are its own. */
int command_line(int argc, char *argv[]);

#endif
