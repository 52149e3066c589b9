#define _GNU_SOURCE /* pipe2, environ */
#include <errno.h>
#include <fcntl.h>
#include <getopt.h>
#include <math.h>
#include <spawn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bundle.h"
#include "command.h"
#include "devices_text.h"
#include "exhibit.h"
#include "option.h"
#include "pictures.h"
#include "scrub.h"
#include "status_writer.h"
#include "thermal.h"

static const char HELP[] =
    "usage: frond report [EXHIBIT] [-o FILE.tar.gz]\n\n"
    "Puts together what somebody who helps from afar needs to know, and nothing that is about people:\n\n"
    "  version.txt   of Frond, of the system (/etc/os-release), of the kernel\n"
    "  exhibit.yaml  EXHIBIT, /etc/frond/exhibit.yaml if left out\n"
    "  check.txt     what frond check says of it\n"
    "  status.json   of the Frond that runs as a service, and frond.prom, the same for Prometheus\n"
    "  devices.txt   what frond devices says\n"
    "  board.txt     temperature, throttling, supply\n"
    "  journal.txt   the last 2000 lines of the service since the machine was started, if you may read them\n\n"
    "No pictures, nothing that was painted, no credentials. Host name, users, serial numbers, network and e-mail\n"
    "addresses are replaced, wherever they stand in these texts. Look into it before you send it: tar -xzf.\n\n"
    "  -o, --output FILE  frond-report.tar.gz in the current folder if left out\n"
    "      --status DIR   where the service has its status, /run/frond/status if left out\n"
    "      --help         this\n";

enum { LINE = 1200, SOME = 65536 };

static const size_t FILE_MOST = 2u << 20;

struct work {
    struct bundle *bundle;
    struct scrub *scrub;
    const char *exhibit, *status, *output;
};

/* Scrubbed, under this name. */
static bool add(struct work *work, const char *name, const char *text)
{
    char path[LINE];
    char *clean = scrub_text(work->scrub, text);
    snprintf(path, sizeof path, "frond-report/%.60s", name);
    bool good = clean && bundle_add(work->bundle, path, clean, strlen(clean));
    free(clean);
    return good;
}

static void copy(FILE *from, FILE *to)
{
    char some[SOME];
    size_t length, all = 0;
    while (all < FILE_MOST && (length = fread(some, 1, sizeof some, from)) > 0) {
        fwrite(some, 1, length, to);
        all += length;
    }
}

static void put_file(const char *path, FILE *out)
{
    FILE *file = fopen(path, "re");
    if (!file) {
        fprintf(out, "%s: %s\n", path, strerror(errno));
        return;
    }
    copy(file, out);
    fclose(file);
}

static void put_version(const struct work *work, FILE *out)
{
    struct utsname system;
    (void)work;
    fprintf(out, "frond %s\n", FROND_VERSION);
    if (uname(&system) == 0) { /* without its nodename */
        fprintf(out, "%s %s %s %s\n\n", system.sysname, system.release, system.version, system.machine);
    }
    put_file("/etc/os-release", out);
}

static void put_exhibit(const struct work *work, FILE *out)
{
    put_file(work->exhibit, out);
}

static void put_check(const struct work *work, FILE *out)
{
    struct script_def def = script_default_def();
    struct report report;
    def.load = pictures_load;
    def.every_picture = true;
    report_init(&report, work->exhibit);
    struct exhibit *exhibit = exhibit_read(work->exhibit, &def, &report);
    report_print(&report, out);
    if (exhibit) {
        fprintf(out, "all is well\n");
    }
    exhibit_destroy(exhibit);
    report_finish(&report);
}

static void put_status(const struct work *work, FILE *out)
{
    char path[LINE];
    snprintf(path, sizeof path, "%s/%s", work->status, STATUS_JSON);
    put_file(path, out);
}

static void put_metrics(const struct work *work, FILE *out)
{
    char path[LINE];
    snprintf(path, sizeof path, "%s/%s", work->status, STATUS_METRICS);
    put_file(path, out);
}

static void put_devices(const struct work *work, FILE *out)
{
    (void)work;
    struct inputs *inputs = inputs_default(NULL);
    struct sources *sources =
        inputs ? sources_create(&(struct sources_def){inputs, .touch = true, .look = true}) : NULL;
    if (sources) {
        sources_dispatch(sources);
        devices_print(sources, out);
    }
    sources_destroy(sources);
    inputs_destroy(inputs);
}

static void put_board(const struct work *work, FILE *out)
{
    (void)work;
    struct thermal *thermal = thermal_create(NULL);
    if (thermal) {
        struct thermal_reading heat = thermal_read(thermal, 1);
        fprintf(out, "%s\n", thermal_describe(thermal));
        if (!isnan(heat.celsius)) {
            fprintf(out, "%s %.1f °C\n", heat.zone, (double)heat.celsius);
        }
        fprintf(out, "throttled: %s\nunder-voltage: %s\n", heat.throttled ? "yes" : "no",
                heat.under_voltage ? "yes" : "no");
    }
    thermal_destroy(thermal);
}

/* What the program prints, by a pipe of its own. */
static FILE *start(const char *const *arguments, pid_t *pid)
{
    int ends[2];
    posix_spawn_file_actions_t actions;
    if (pipe2(ends, O_CLOEXEC) != 0) {
        return NULL;
    }
    int code = posix_spawn_file_actions_init(&actions);
    if (code == 0) {
        code = posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        code = code ? code : posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
        code = code ? code : posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
        code =
            code ? code : posix_spawnp(pid, arguments[0], &actions, NULL, (char *const *)(uintptr_t)arguments, environ);
        posix_spawn_file_actions_destroy(&actions);
    }
    close(ends[1]);
    FILE *out = code == 0 ? fdopen(ends[0], "r") : NULL;
    if (!out) {
        close(ends[0]);
    }
    return out;
}

static void put_journal(const struct work *work, FILE *out)
{
    static const char *const arguments[] = {"timeout",
                                            "20",
                                            "journalctl",
                                            "--unit=frond",
                                            "--boot",
                                            "--lines=2000",
                                            "--no-hostname",
                                            "--output=short-monotonic",
                                            "--quiet",
                                            "--no-pager",
                                            NULL};
    pid_t pid = 0;
    (void)work;
    FILE *journal = start(arguments, &pid);
    if (!journal) {
        fprintf(out, "journalctl does not start\n");
        return;
    }
    copy(journal, out);
    fclose(journal);
    waitpid(pid, NULL, 0);
}

static const struct {
    const char *name;
    void (*put)(const struct work *work, FILE *out);
} parts[] = {
    {"version.txt", put_version}, {"exhibit.yaml", put_exhibit}, {"check.txt", put_check},
    {STATUS_JSON, put_status},    {STATUS_METRICS, put_metrics}, {"devices.txt", put_devices},
    {"board.txt", put_board},     {"journal.txt", put_journal},
};

static bool add_part(struct work *work, size_t part)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out) {
        return false;
    }
    parts[part].put(work, out);
    bool good = fclose(out) == 0 && add(work, parts[part].name, text);
    free(text);
    return good;
}

static int put_together(struct work *work)
{
    struct file_error error = {"memory is short"};
    bool good = work->bundle && work->scrub && scrub_learn_machine(work->scrub);
    for (size_t i = 0; good && i < sizeof parts / sizeof parts[0]; i++) {
        good = add_part(work, i);
    }
    if (!good || !bundle_write(work->bundle, work->output, &error)) {
        fprintf(stderr, "frond report: %s\n", error.text);
        return EXIT_STATUS_FAILED;
    }
    printf("%s\n", work->output);
    return EXIT_STATUS_GOOD;
}

int command_report(int argc, char *argv[])
{
    static const struct option_row OPTIONS[] = {
        {"output", OPTION_TEXT, .offset = offsetof(struct work, output)},
        {"status", OPTION_TEXT, .offset = offsetof(struct work, status)},
        {.name = NULL},
    };
    struct work work = {
        .exhibit = "/etc/frond/exhibit.yaml", .status = "/run/frond/status", .output = "frond-report.tar.gz"};
    int status = options_read("report", HELP, OPTIONS, argc, argv, &work);
    if (status >= 0) {
        return status;
    }
    if (argc - optind > 1) {
        fprintf(stderr, "frond report: one exhibit at a time; see frond report --help\n");
        return EXIT_STATUS_USAGE;
    }
    work.exhibit = optind < argc ? argv[optind] : work.exhibit;
    work.bundle = bundle_create();
    work.scrub = scrub_create();
    status = put_together(&work);
    scrub_destroy(work.scrub);
    bundle_destroy(work.bundle);
    return status;
}
