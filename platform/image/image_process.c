#define _GNU_SOURCE /* posix_spawn_file_actions_addclosefrom_np */
#include "image_process.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum {
    ARGUMENTS_MAX = 80,
};

/* FROND_LIBEXEC is where CMake installs the helper. */
static const char *const beside[] = {"frond-image", "../libexec/frond/frond-image"};

/* Fills `found`; false when there is none. */
static bool find_helper(const char *helper, char *found, size_t size)
{
    if (helper) {
        return (size_t)snprintf(found, size, "%s", helper) < size && access(found, X_OK) == 0;
    }
    char self[PATH_MAX];
    ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    self[length < 0 ? 0 : length] = '\0';
    char *slash = strrchr(self, '/');
    for (size_t i = 0; slash && i < sizeof beside / sizeof beside[0]; i++) {
        int folder = (int)(slash - self);
        if ((size_t)snprintf(found, size, "%.*s/%s", folder, self, beside[i]) < size && access(found, X_OK) == 0) {
            return true;
        }
    }
    snprintf(found, size, "%s", FROND_LIBEXEC "/frond-image");
    return access(found, X_OK) == 0;
}

static int start(const struct image_job *job, const char *helper, int input, int output, pid_t *pid)
{
    const char *arguments[ARGUMENTS_MAX] = {"frond-image"};
    for (int i = 0; job->request[i]; i++) {
        if (i + 2 >= ARGUMENTS_MAX) {
            return E2BIG;
        }
        arguments[i + 1] = job->request[i];
    }
    /* Some libraries behind OpenImageIO start a thread for every processor unless told otherwise. */
    char locale[] = "LC_ALL=C", one_thread[] = "OPENBLAS_NUM_THREADS=1";
    char *environment[] = {locale, one_thread, NULL};
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    int code = posix_spawn_file_actions_init(&actions);
    if (code != 0) {
        return code;
    }
    code = posix_spawnattr_init(&attributes);
    if (code != 0) {
        posix_spawn_file_actions_destroy(&actions);
        return code;
    }
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    if ((code = posix_spawn_file_actions_adddup2(&actions, input, 0)) == 0 &&
        (code = posix_spawn_file_actions_adddup2(&actions, output, 1)) == 0 &&
        (code = posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0)) == 0 &&
        (code = posix_spawn_file_actions_addclosefrom_np(&actions, 3)) == 0 &&
        (code = posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF)) == 0 &&
        (code = posix_spawnattr_setsigmask(&attributes, &none)) == 0 &&
        (code = posix_spawnattr_setsigdefault(&attributes, &all)) == 0) {
        /* posix_spawn takes char *const[] for reasons of history and writes nothing. */
        code = posix_spawn(pid, helper, &actions, &attributes, (char *const *)(uintptr_t)arguments, environment);
    }
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return code;
}

static long long now_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (long long)now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

/* Waits until the helper ends. 0: by itself. Else it was killed: ETIMEDOUT, its time was over; others, nobody can tell
 * when it ends. */
static int wait_or_kill(pid_t pid, int seconds, siginfo_t *end)
{
    long long deadline = now_ms() + seconds * 1000LL;
    int watch = (int)syscall(SYS_pidfd_open, pid, 0);
    int code = watch < 0 ? errno : ETIMEDOUT;
    if (watch >= 0) {
        struct pollfd ready = {.fd = watch, .events = POLLIN};
        for (long long left; code != 0 && (left = deadline - now_ms()) > 0;) {
            code = poll(&ready, 1, (int)left) == 1 ? 0 : ETIMEDOUT;
        }
        close(watch);
    }
    if (code != 0) {
        kill(pid, SIGKILL);
    }
    memset(end, 0, sizeof *end);
    while (waitid(P_PID, (id_t)pid, end, WEXITED) != 0 && errno == EINTR) {
    }
    return code;
}

static enum image_outcome judge(const struct image_job *job, const siginfo_t *end, struct file_error *error)
{
    if (end->si_code == CLD_EXITED) {
        if (end->si_status == IMAGE_EXIT_DONE) {
            return IMAGE_OUTCOME_DONE;
        }
        if (end->si_status == IMAGE_EXIT_REFUSED) {
            return IMAGE_OUTCOME_REFUSED;
        }
        file_fail(error, job->path, "the picture helper frond-image does not work here (status %d)", end->si_status);
    } else if (end->si_status == SIGXCPU) {
        file_fail(error, job->path, "took longer than %d s", job->told_seconds);
    } else if (end->si_status == SIGSYS) {
        file_fail(error, job->path, "is damaged: its decoder tried what it may not do, and was stopped");
    } else if (end->si_status == SIGKILL || end->si_status == SIGTERM) {
        file_fail(error, job->path, "its decoder was stopped from outside (signal %d)", end->si_status);
    } else {
        file_fail(error, job->path, "is damaged: its decoder crashed (signal %d)", end->si_status);
    }
    return IMAGE_OUTCOME_FAILED;
}

enum image_outcome image_process_run(const struct image_job *job, struct file_error *error)
{
    char helper[PATH_MAX + 64];
    if (!find_helper(job->helper, helper, sizeof helper)) {
        file_fail(error, job->path, "the picture helper is missing: %s", helper);
        return IMAGE_OUTCOME_FAILED;
    }
    enum image_outcome outcome = IMAGE_OUTCOME_FAILED;
    /* Above 2, so that neither is overwritten while they move to 0 and 1 of the helper. */
    int input = fcntl(job->input, F_DUPFD_CLOEXEC, 3);
    int output = fcntl(job->output, F_DUPFD_CLOEXEC, 3);
    pid_t pid = -1;
    int code = input < 0 || output < 0 ? errno : start(job, helper, input, output, &pid);
    siginfo_t end;
    code = code == 0 ? wait_or_kill(pid, job->seconds, &end) : code;
    if (code == 0) {
        outcome = judge(job, &end, error);
    } else if (code == ETIMEDOUT) {
        file_fail(error, job->path, "took longer than %d s", job->told_seconds);
    } else {
        file_fail(error, job->path, "the picture helper %s does not start: %s", helper, strerror(code));
    }
    if (input >= 0) {
        close(input);
    }
    if (output >= 0) {
        close(output);
    }
    return outcome;
}
