/* Enters the sandbox and tries one thing: sandbox_probe THING. Exits 0 when the thing is allowed and went well, 42 when
 * it was not allowed and yet went well. */
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include "image_sandbox.h"

enum { ESCAPED = 42, MEGABYTES = 64, FILE_BYTES = 4096 };

static int try_read(void)
{
    char byte;
    return read(0, &byte, 1) == 1 && write(1, &byte, 1) == 1 ? 0 : 1;
}

static int try_open(void)
{
    return open("/dev/null", O_RDONLY) >= 0 || errno ? ESCAPED : 1;
}

static int try_create(void)
{
    return open("escaped", O_WRONLY | O_CREAT, 0600) >= 0 || errno ? ESCAPED : 1;
}

static int try_socket(void)
{
    return socket(AF_INET, SOCK_STREAM, 0) >= 0 || errno ? ESCAPED : 1;
}

static int try_fork(void)
{
    return fork() >= 0 || errno ? ESCAPED : 1;
}

static int try_exec(void)
{
    char *const arguments[] = {NULL};
    return execve("/bin/true", arguments, arguments) == -1 ? ESCAPED : 1;
}

static void *idle(void *nothing)
{
    return nothing;
}

static int try_thread(void)
{
    pthread_t thread;
    return pthread_create(&thread, NULL, idle, NULL) == 0 || errno ? ESCAPED : 1;
}

static int try_code(void)
{
    return mmap(NULL, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) || errno ? ESCAPED : 1;
}

static int try_kill(void)
{
    return kill(getppid(), 0) == 0 || errno ? ESCAPED : 1;
}

static int try_memory(void)
{
    void *some = mmap(NULL, MEGABYTES / 2 << 20, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    void *more = mmap(NULL, (size_t)MEGABYTES << 20, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return some != MAP_FAILED && more == MAP_FAILED ? 0 : ESCAPED;
}

static int try_time(void)
{
    volatile int forever = 1;
    while (forever) {
    }
    return ESCAPED;
}

static int try_growing(void)
{
    static const char bytes[FILE_BYTES + 1];
    return write(1, bytes, FILE_BYTES) == FILE_BYTES && write(1, bytes, 1) == 1 ? ESCAPED : 1;
}

static int try_descriptor(void)
{
    return write(7, "", 1) == -1 && errno == EBADF ? 0 : ESCAPED;
}

static int try_abort(void)
{
    abort();
}

static const struct {
    const char *name;
    int (*attempt)(void);
} things[] = {
    {"read", try_read},     {"open", try_open},
    {"create", try_create}, {"socket", try_socket},
    {"fork", try_fork},     {"exec", try_exec},
    {"thread", try_thread}, {"code", try_code},
    {"kill", try_kill},     {"memory", try_memory},
    {"time", try_time},     {"growing", try_growing},
    {"abort", try_abort},   {"descriptor", try_descriptor},
};

int main(int argc, char **argv)
{
    struct image_sandbox_def def = image_sandbox_default_def();
    def.memory_megabytes = MEGABYTES;
    def.cpu_seconds = 1;
    def.file_bytes = FILE_BYTES;
    dup2(2, 7);
    const char *kept = image_sandbox_enter(&def);
    if (kept) {
        fprintf(stderr, "sandbox_probe: could not give up: %s\n", kept);
        return 3;
    }
    for (size_t i = 0; argc == 2 && i < sizeof things / sizeof things[0]; i++) {
        if (strcmp(argv[1], things[i].name) == 0) {
            _exit(things[i].attempt());
        }
    }
    _exit(2);
}
