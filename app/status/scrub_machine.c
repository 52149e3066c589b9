/* What this machine, its users and its devices are called. */
#include <glob.h>
#include <pwd.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "scrub.h"

enum { LINE = 300, PEOPLE = 1000, NOBODY = 60000 };

static const char SERIAL[] = "[serial number]", USER[] = "[user]", HOST[] = "[host]";

static const char *const serial_files[] = {
    "/proc/device-tree/serial-number",  "/sys/class/dmi/id/*_serial",
    "/sys/class/dmi/id/product_uuid",   "/sys/bus/usb/devices/*/serial",
    "/sys/class/block/*/device/serial", "/sys/class/block/*/device/wwid",
    "/sys/class/net/*/address",         "/etc/machine-id",
    "/sys/bus/hid/devices/*/*/*/uniq",  "/sys/class/input/*/uniq",
    "/sys/class/mmc_host/*/*/serial",   "/proc/sys/kernel/random/boot_id",
};

static bool learn_file(struct scrub *scrub, const char *path)
{
    char line[LINE];
    FILE *file = fopen(path, "re");
    bool good = true;
    if (file && fgets(line, sizeof line, file)) {
        good = scrub_learn(scrub, line, SERIAL);
    }
    if (file) {
        fclose(file);
    }
    return good;
}

static bool learn_serials(struct scrub *scrub)
{
    bool good = true;
    for (size_t i = 0; i < sizeof serial_files / sizeof serial_files[0]; i++) {
        glob_t found = {.gl_pathc = 0};
        if (glob(serial_files[i], 0, NULL, &found) == 0) {
            for (size_t j = 0; j < found.gl_pathc; j++) {
                good = learn_file(scrub, found.gl_pathv[j]) && good;
            }
        }
        globfree(&found);
    }
    FILE *file = fopen("/proc/cpuinfo", "re"); /* "Serial\t\t: 10000000abcdef01", of a Raspberry Pi */
    char line[LINE];
    while (file && fgets(line, sizeof line, file)) {
        const char *colon = strncmp(line, "Serial", 6) == 0 ? strchr(line, ':') : NULL;
        good = (!colon || scrub_learn(scrub, colon + 1, SERIAL)) && good;
    }
    if (file) {
        fclose(file);
    }
    return good;
}

/* Those who are people, not services. */
static bool learn_users(struct scrub *scrub)
{
    static const char *const variables[] = {"USER", "LOGNAME", "SUDO_USER"};
    const struct passwd *user;
    bool good = true;
    setpwent();
    while ((user = getpwent())) {
        if (user->pw_uid >= PEOPLE && user->pw_uid < NOBODY) {
            char name[LINE];
            snprintf(name, sizeof name, "%.*s", (int)strcspn(user->pw_gecos ? user->pw_gecos : "", ","),
                     user->pw_gecos ? user->pw_gecos : "");
            good = scrub_learn(scrub, user->pw_name, USER) && scrub_learn(scrub, name, USER) && good;
        }
    }
    endpwent();
    for (size_t i = 0; i < sizeof variables / sizeof variables[0]; i++) {
        const char *name = getenv(variables[i]);
        if (name && strcmp(name, "root") != 0 && strcmp(name, "frond") != 0) {
            good = scrub_learn(scrub, name, USER) && good;
        }
    }
    return good;
}

bool scrub_learn_machine(struct scrub *scrub)
{
    char host[LINE] = "";
    bool good = true;
    if (gethostname(host, sizeof host - 1) == 0 && strcmp(host, "localhost") != 0) {
        good = scrub_learn(scrub, host, HOST); /* with its domain, and without */
        host[strcspn(host, ".")] = '\0';
        good = scrub_learn(scrub, host, HOST) && good;
    }
    return learn_users(scrub) && learn_serials(scrub) && good;
}
