#include <getopt.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include "bench.h"
#include "command.h"
#include "devices_descriptor.h"
#include "devices_text.h"
#include "option.h"

static const char HELP[] =
    "usage: frond devices [OPTIONS]\n\n"
    "Lists what is plugged in: touchscreens, mice, keyboards, HID controllers with their usages, GPIO\n"
    "chips with their lines; whether each may act; what is missing for it, and how to mend that.\n\n"
    "      --inputs FILE      as this inputs file has it; else as without one\n"
    "      --watch            prints what they say as you touch and turn them, with the binding to paste\n"
    "                         into an inputs file, until Ctrl-C\n"
    "      --seconds N        with --watch: so long, {seconds}\n"
    "      --descriptor FILE  decodes a HID report descriptor captured elsewhere: bytes, or text in base\n"
    "                         16; - is standard input\n"
    "      --json             with --descriptor\n"
    "      --help             this\n";

enum { SECONDS_MOST = 86400, SETTLE_MS = 300 };

struct order {
    const char *inputs, *descriptor; /* paths; NULL: none */
    bool watch, json;
    int seconds; /* 0: until told to stop */
};

static int decode(const struct order *order)
{
    struct file_error error;
    if (!devices_descriptor(order->descriptor, order->json, stdout, &error)) {
        fprintf(stderr, "frond devices: %s\n", error.text);
        return EXIT_STATUS_FAILED;
    }
    return EXIT_STATUS_GOOD;
}

static struct inputs *read_inputs(const char *path)
{
    struct script_def def = script_default_def();
    struct report report;
    if (!path) {
        return inputs_default(NULL);
    }
    report_init(&report, path);
    struct inputs *inputs = inputs_read(path, NULL, &def, &report);
    report_print(&report, stderr);
    report_finish(&report);
    return inputs;
}

/* Waits until something is to be read, and lets every source do its work. */
static void attend(struct sources *sources, int signals, int most_ms)
{
    int fds[SOURCES_MAX], timeout = sources_timeout_ms(sources);
    struct pollfd polled[SOURCES_MAX + 1];
    int count = sources_fds(sources, fds);
    for (int i = 0; i < count; i++) {
        polled[i] = (struct pollfd){.fd = fds[i], .events = POLLIN};
    }
    polled[count] = (struct pollfd){.fd = signals, .events = POLLIN};
    timeout = timeout >= 0 && timeout < most_ms ? timeout : most_ms;
    poll(polled, (nfds_t)count + 1, timeout);
    sources_dispatch(sources);
}

static void tell_log(struct sources *sources)
{
    char line[DEVICES_LINE];
    while (sources_log(sources, line, sizeof line)) {
        fprintf(stderr, "frond devices: %s\n", line);
    }
}

static void tell_events(struct sources *sources, const struct inputs *inputs, struct devices_seen *seen)
{
    struct event event;
    char line[DEVICES_LINE];
    while (sources_event(sources, &event)) {
        struct device device = {.name = "a device"};
        sources_device(sources, &event, &device);
        if (devices_event(&event, &device, inputs, line, sizeof line)) {
            puts(line);
        }
        if (devices_binding(&event, &device, inputs, seen, line, sizeof line)) {
            printf("    %s\n", line);
        }
    }
    fflush(stdout);
}

static void watch(struct sources *sources, const struct inputs *inputs, int seconds)
{
    struct devices_seen seen = {.count = 0};
    struct signalfd_siginfo info;
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    sigprocmask(SIG_BLOCK, &set, NULL);
    int signals = signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
    double end = bench_wall_s() + seconds;
    while ((seconds == 0 || bench_wall_s() < end) && signals >= 0 &&
           read(signals, &info, sizeof info) != (ssize_t)sizeof info) {
        attend(sources, signals, 100);
        tell_log(sources);
        tell_events(sources, inputs, &seen);
    }
    if (signals >= 0) {
        close(signals);
    }
}

/* What is there at the start comes as events of a moment later. */
static void settle(struct sources *sources)
{
    double end = bench_wall_s() + SETTLE_MS / 1000.0;
    while (bench_wall_s() < end) {
        attend(sources, -1, 20);
    }
}

static int list(const struct order *order)
{
    struct inputs *inputs = read_inputs(order->inputs);
    if (!inputs) {
        return EXIT_STATUS_FAILED;
    }
    struct sources *sources = sources_create(&(struct sources_def){.inputs = inputs, .touch = true, .look = true});
    if (sources) {
        settle(sources);
        devices_print(sources, stdout);
        tell_log(sources);
        if (order->watch) {
            watch(sources, inputs, order->seconds);
        }
    }
    sources_destroy(sources);
    inputs_destroy(inputs);
    return sources ? EXIT_STATUS_GOOD : EXIT_STATUS_FAILED;
}

#define ORDER(field) .offset = offsetof(struct order, field)

static const struct option_row OPTIONS[] = {
    {"inputs", OPTION_TEXT, ORDER(inputs)},
    {"watch", OPTION_FLAG, ORDER(watch)},
    {"seconds", OPTION_WHOLE, ORDER(seconds), 1, SECONDS_MOST, " seconds"},
    {"descriptor", OPTION_TEXT, ORDER(descriptor)},
    {"json", OPTION_FLAG, ORDER(json)},
    {.name = NULL},
};

int command_devices(int argc, char *argv[])
{
    struct order order = {.seconds = 0};
    int status = options_read("devices", HELP, OPTIONS, argc, argv, &order);
    if (status >= 0) {
        return status;
    }
    if (optind < argc) {
        fprintf(stderr, "frond devices: '%s' is too much; see frond devices --help\n", argv[optind]);
        return EXIT_STATUS_USAGE;
    }
    if ((order.json && !order.descriptor) || (order.seconds && !order.watch)) {
        fprintf(stderr, "frond devices: --%s; see frond devices --help\n",
                order.json ? "json goes with --descriptor" : "seconds goes with --watch");
        return EXIT_STATUS_USAGE;
    }
    return order.descriptor ? decode(&order) : list(&order);
}
