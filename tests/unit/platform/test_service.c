/* What the service manager hears, on a socket of the test's own. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cmocka.h>

#include "service.h"

static const uint64_t S = 1000000;

struct manager {
    int fd;
    char path[64];
    char heard[600]; /* the messages since the last look, each in brackets */
};

static void listen_to(struct manager *manager, const char *watchdog_us)
{
    struct sockaddr_un address = {.sun_family = AF_UNIX};
    char pid[32];
    snprintf(manager->path, sizeof manager->path, "/tmp/frond-test-service-%d", (int)getpid());
    snprintf(address.sun_path, sizeof address.sun_path, "%s", manager->path);
    unlink(manager->path);
    manager->fd = socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    assert_true(manager->fd >= 0);
    assert_int_equal(bind(manager->fd, (struct sockaddr *)&address, sizeof address), 0);
    snprintf(pid, sizeof pid, "%d", (int)getpid());
    setenv("NOTIFY_SOCKET", manager->path, 1);
    setenv("WATCHDOG_PID", pid, 1);
    if (watchdog_us) {
        setenv("WATCHDOG_USEC", watchdog_us, 1);
    } else {
        unsetenv("WATCHDOG_USEC");
    }
}

static void leave(struct manager *manager)
{
    close(manager->fd);
    unlink(manager->path);
    unsetenv("NOTIFY_SOCKET");
}

static const char *heard(struct manager *manager)
{
    char message[256];
    ssize_t length;
    size_t used = 0;
    manager->heard[0] = '\0';
    while ((length = recv(manager->fd, message, sizeof message - 1, 0)) >= 0) {
        message[length] = '\0';
        used += (size_t)snprintf(manager->heard + used, sizeof manager->heard - used, "[%s]", message);
    }
    return manager->heard;
}

static void turn(struct service *service, uint64_t frames, bool shown, const char *status, uint64_t now_us)
{
    service_turn(service, &(struct service_turn){.frames = frames, .rests = true, .shown = shown, .status = status},
                 now_us);
}

static void ready_is_the_first_frame(void **state)
{
    struct manager manager;
    (void)state;
    listen_to(&manager, "10000000");
    struct service *service = service_create();
    assert_non_null(service);
    turn(service, 0, true, NULL, 1 * S);
    turn(service, 0, true, NULL, 9 * S);
    service_reloaded(service, 9 * S);
    assert_string_equal(heard(&manager), "");
    turn(service, 1, true, NULL, 10 * S);
    assert_string_equal(heard(&manager), "[READY=1]");
    service_destroy(service);
    assert_string_equal(heard(&manager), "[STOPPING=1]");
    leave(&manager);
}

static void only_frames_feed_the_watchdog(void **state)
{
    struct manager manager;
    (void)state;
    listen_to(&manager, "10000000");
    struct service *service = service_create();
    turn(service, 1, true, NULL, 0);
    assert_string_equal(heard(&manager), "[READY=1]");
    turn(service, 90, true, NULL, 2 * S); /* a quarter of the time has not passed */
    assert_string_equal(heard(&manager), "");
    turn(service, 120, true, NULL, 3 * S);
    assert_string_equal(heard(&manager), "[WATCHDOG=1]");
    for (uint64_t s = 4; s < 60; s++) { /* the loop turns, and no frame completes */
        turn(service, 120, true, NULL, s * S);
    }
    assert_string_equal(heard(&manager), "");
    turn(service, 121, true, NULL, 60 * S);
    assert_string_equal(heard(&manager), "[WATCHDOG=1]");
    service_destroy(service);
    leave(&manager);
}

static void whoever_paints_is_to_turn_or_rest(void **state)
{
    struct manager manager;
    (void)state;
    listen_to(&manager, "10000000");
    struct service *service = service_create();
    struct service_turn turn = {.frames = 1, .turns = 1, .shown = true};
    service_turn(service, &turn, 0);
    assert_string_equal(heard(&manager), "[READY=1]");
    for (uint64_t s = 1; s < 60; s++) { /* frames go on, and nobody paints */
        turn.frames++;
        service_turn(service, &turn, s * S);
    }
    assert_string_equal(heard(&manager), "");
    turn.turns++;
    service_turn(service, &turn, 60 * S);
    assert_string_equal(heard(&manager), "[WATCHDOG=1]");
    turn.rests = true;
    turn.frames++;
    service_turn(service, &turn, 63 * S);
    assert_string_equal(heard(&manager), "[WATCHDOG=1]");
    service_destroy(service);
    leave(&manager);
}

static void without_a_screen_the_loop_does(void **state)
{
    struct manager manager;
    int pings = 0;
    (void)state;
    listen_to(&manager, "10000000");
    struct service *service = service_create();
    turn(service, 0, false, NULL, 0);
    assert_string_equal(heard(&manager), "[READY=1]");
    for (uint64_t tenths = 1; tenths <= 1000; tenths++) {
        turn(service, 0, false, NULL, tenths * S / 10);
        pings += strcmp(heard(&manager), "[WATCHDOG=1]") == 0;
    }
    assert_int_equal(pings, 40);
    turn(service, 0, true, NULL, 104 * S); /* it is plugged in: now a frame is owed */
    assert_string_equal(heard(&manager), "");
    turn(service, 1, true, NULL, 105 * S);
    assert_string_equal(heard(&manager), "[WATCHDOG=1]");
    service_destroy(service);
    leave(&manager);
}

static void without_a_watchdog_none_is_fed(void **state)
{
    struct manager manager;
    (void)state;
    listen_to(&manager, NULL);
    struct service *service = service_create();
    for (uint64_t s = 0; s < 100; s++) {
        turn(service, s + 1, true, NULL, s * S);
    }
    assert_string_equal(heard(&manager), "[READY=1]");
    service_destroy(service);
    heard(&manager);
    setenv("WATCHDOG_PID", "1", 1); /* of another process */
    setenv("WATCHDOG_USEC", "10000000", 1);
    service = service_create();
    for (uint64_t s = 0; s < 100; s++) {
        turn(service, s + 1, true, NULL, s * S);
    }
    assert_string_equal(heard(&manager), "[READY=1]");
    service_destroy(service);
    leave(&manager);
}

static void the_status_is_said_when_it_changes(void **state)
{
    struct manager manager;
    (void)state;
    listen_to(&manager, NULL);
    struct service *service = service_create();
    turn(service, 1, true, "attract, 0 visits", 1 * S);
    assert_string_equal(heard(&manager), "[READY=1][STATUS=attract, 0 visits]");
    turn(service, 2, true, "attract, 0 visits", 5 * S);
    assert_string_equal(heard(&manager), "");
    turn(service, 3, true, "painting, 1 visits", 6 * S);
    assert_string_equal(heard(&manager), "[STATUS=painting, 1 visits]");
    turn(service, 4, true, "attract, 1 visits", 6 * S + S / 2); /* no more than one a second */
    assert_string_equal(heard(&manager), "");
    turn(service, 5, true, "attract, 1 visits", 7 * S);
    assert_string_equal(heard(&manager), "[STATUS=attract, 1 visits]");
    service_reloaded(service, 8 * S);
    assert_string_equal(heard(&manager), "[RELOADING=1\nMONOTONIC_USEC=8000000][READY=1]");
    service_destroy(service);
    leave(&manager);
}

static void nobody_listens(void **state)
{
    (void)state;
    unsetenv("NOTIFY_SOCKET");
    unsetenv("WATCHDOG_USEC");
    struct service *service = service_create();
    assert_non_null(service);
    turn(service, 1, true, "attract", S);
    service_reloaded(service, 2 * S);
    service_destroy(service);
    service_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ready_is_the_first_frame),
        cmocka_unit_test(only_frames_feed_the_watchdog),
        cmocka_unit_test(whoever_paints_is_to_turn_or_rest),
        cmocka_unit_test(without_a_screen_the_loop_does),
        cmocka_unit_test(without_a_watchdog_none_is_fed),
        cmocka_unit_test(the_status_is_said_when_it_changes),
        cmocka_unit_test(nobody_listens),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
