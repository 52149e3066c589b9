#include "feed.h"

#include <errno.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

struct feed {
    pid_t child;
    int end; /* a socket: unlike a pipe it can be written to without a signal when nobody reads */
};

/* The child's input is `input`, with a clean set of signals. */
static int spawn(pid_t *child, char *const arguments[], int input)
{
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    sigset_t none;
    sigemptyset(&none);
    int code = posix_spawn_file_actions_init(&actions);
    if (code != 0) {
        return code;
    }
    code = posix_spawnattr_init(&attributes);
    if (code == 0) {
        posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
        posix_spawnattr_setsigmask(&attributes, &none);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
        code = posix_spawnp(child, arguments[0], &actions, &attributes, arguments, environ);
        posix_spawnattr_destroy(&attributes);
    }
    posix_spawn_file_actions_destroy(&actions);
    return code;
}

struct feed *feed_open(char *const arguments[], struct file_error *error)
{
    struct feed *feed = calloc(1, sizeof *feed);
    int ends[2];
    if (!feed || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
        free(feed);
        file_fail_code(error, arguments[0], errno);
        return NULL;
    }
    shutdown(ends[1], SHUT_WR);
    int code = spawn(&feed->child, arguments, ends[1]);
    close(ends[1]);
    feed->end = ends[0];
    if (code != 0) {
        if (code == ENOENT) {
            file_fail(error, arguments[0], "is not installed");
        } else {
            file_fail_code(error, arguments[0], code);
        }
        close(feed->end);
        free(feed);
        return NULL;
    }
    return feed;
}

bool feed_put(struct feed *feed, const void *data, size_t size)
{
    const char *at = data;
    while (size > 0) {
        ssize_t sent = send(feed->end, at, size, MSG_NOSIGNAL);
        if (sent < 0 && errno != EINTR) {
            return false;
        }
        at += sent > 0 ? sent : 0;
        size -= sent > 0 ? (size_t)sent : 0;
    }
    return true;
}

bool feed_close(struct feed *feed)
{
    int status = 0;
    pid_t ended;
    if (!feed) {
        return false;
    }
    close(feed->end);
    while ((ended = waitpid(feed->child, &status, 0)) < 0 && errno == EINTR) {
    }
    free(feed);
    return ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}
