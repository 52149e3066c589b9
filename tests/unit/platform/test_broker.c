/* A broker that nothing is heard of: what is published waits, and the end does not. tests/cli/mqtt.sh has a real one.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include "broker.h"
#include "source_queue.h"

enum { PATIENCE_US = 5000000 };

struct bench {
    int listening, waiting; /* a port where a connection waits that nobody takes: the kernel drops those after it */
    int port;
};

static int start(void **state)
{
    static struct bench bench;
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
    socklen_t size = sizeof address;
    struct sockaddr *generic = (struct sockaddr *)&address;
    bench.listening = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    bench.waiting = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    *state = &bench;
    if (bind(bench.listening, generic, size) != 0 || listen(bench.listening, 0) != 0 ||
        getsockname(bench.listening, generic, &size) != 0 || connect(bench.waiting, generic, size) != 0) {
        return -1;
    }
    bench.port = ntohs(address.sin_port);
    return 0;
}

static int finish(void **state)
{
    struct bench *bench = *state;
    close(bench->waiting);
    close(bench->listening);
    return 0;
}

/* Whether somebody knocks at the port and has no answer: "sl local remote state", in hexadecimal, 02 is SYN_SENT. */
static bool is_knocked_at(int port)
{
    char line[256], wanted[16];
    bool found = false;
    FILE *file = fopen("/proc/net/tcp", "re");
    assert_non_null(file);
    snprintf(wanted, sizeof wanted, ":%04X 02", (unsigned)port);
    while (!found && fgets(line, sizeof line, file)) {
        found = strstr(line, wanted) != NULL;
    }
    fclose(file);
    return found;
}

static void does_not_wait_for_a_network_that_hangs(void **state)
{
    struct bench *bench = *state;
    struct device_error error;
    const struct broker_def def = {.host = "127.0.0.1", .port = bench->port, .alive = "frond/alive"};
    struct broker *broker = broker_create(&def, &error);
    if (!broker && strstr(error.text, "built without")) {
        skip();
    }
    assert_non_null(broker);
    assert_true(broker_publish(broker, "a", "1"));
    assert_true(broker_publish(broker, "b", "1"));
    assert_true(broker_publish(broker, "c", "1"));
    assert_true(broker_publish(broker, "d", "1"));
    assert_false(broker_publish(broker, "e", "1"));
    assert_true(broker_publish(broker, "b", "2")); /* in place of the older */
    uint64_t begun_us = source_now_us();
    while (!is_knocked_at(bench->port) && source_now_us() - begun_us < PATIENCE_US) {
        nanosleep(&(struct timespec){.tv_nsec = 10000000}, NULL);
    }
    assert_true(is_knocked_at(bench->port));
    begun_us = source_now_us();
    broker_destroy(broker);
    uint64_t took_us = source_now_us() - begun_us;
    assert_in_range(took_us, 1000000u * BROKER_GOODBYE_S - 100000u, 1000000u * BROKER_GOODBYE_S + PATIENCE_US);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(does_not_wait_for_a_network_that_hangs, start, finish),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
