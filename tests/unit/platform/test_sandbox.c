/* What the sandbox of the picture helper lets through, tried from inside by sandbox_probe. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

/* Runs the probe with /dev/zero to read and a fresh file to write; returns what waitpid says. */
static int probe(const char *thing)
{
    FILE *output = tmpfile();
    assert_non_null(output);
    pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0) {
        dup2(open("/dev/zero", O_RDONLY), 0);
        dup2(fileno(output), 1);
        execl(SANDBOX_PROBE, "sandbox_probe", thing, (char *)NULL);
        _exit(99);
    }
    int status = 0;
    assert_int_equal(waitpid(pid, &status, 0), pid);
    fclose(output);
    return status;
}

static void assert_exits(const char *thing)
{
    int status = probe(thing);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        fail_msg("%s: wanted to end well, got status %#x", thing, (unsigned)status);
    }
}

static void assert_killed(const char *thing, int signal)
{
    int status = probe(thing);
    if (!WIFSIGNALED(status) || WTERMSIG(status) != signal) {
        fail_msg("%s: wanted to be killed by signal %d, got status %#x", thing, signal, (unsigned)status);
    }
}

static void lets_it_read_and_write(void **state)
{
    (void)state;
    assert_exits("read");
}

static void kills_what_reaches_out(void **state)
{
    (void)state;
    static const char *const things[] = {"open", "create", "socket", "fork", "exec", "thread", "code", "kill"};
    for (size_t i = 0; i < sizeof things / sizeof things[0]; i++) {
        assert_killed(things[i], SIGSYS);
    }
}

static void lets_it_abort(void **state)
{
    (void)state;
    assert_killed("abort", SIGABRT);
}

static void limits_memory(void **state)
{
    (void)state;
#ifdef SANITIZED
    skip(); /* the sandbox leaves memory alone there */
#endif
    assert_exits("memory");
}

static void limits_time(void **state)
{
    (void)state;
    assert_killed("time", SIGXCPU);
}

static void limits_the_file(void **state)
{
    (void)state;
    assert_killed("growing", SIGXFSZ);
}

static void closes_other_descriptors(void **state)
{
    (void)state;
    assert_exits("descriptor");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lets_it_read_and_write),
        cmocka_unit_test(kills_what_reaches_out),
        cmocka_unit_test(lets_it_abort),
        cmocka_unit_test(limits_memory),
        cmocka_unit_test(limits_time),
        cmocka_unit_test(limits_the_file),
        cmocka_unit_test(closes_other_descriptors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
