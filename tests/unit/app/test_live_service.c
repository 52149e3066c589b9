/* What feeds the watchdog of a live session: frames, and the thread that paints (app/live/live_service.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

#include "bench.h"
#include "folder_case.h"
#include "live_service.h"
#include "patience.h"

enum { WATCHDOG_US = 10000000 };

struct place {
    int manager;
    char path[64];
    struct display *display;
    struct studio *studio;
    struct script script;
    struct live_kiosk kiosk;
    struct live_service service;
    atomic_bool hangs, hung;
    uint64_t now_us; /* that the service is told */
};

static void nap(void)
{
    nanosleep(&(struct timespec){0, 2000000}, NULL);
}

/* In the studio's thread, as a tick that does not end. */
static void hang(void *data, const struct studio_event *event)
{
    struct place *place = data;
    while (event->kind == STUDIO_TICKED && atomic_load(&place->hangs)) {
        atomic_store(&place->hung, true);
        nap();
    }
}

static void listen_as_manager(struct place *place)
{
    struct sockaddr_un address = {.sun_family = AF_UNIX};
    char pid[32], watchdog[32];
    snprintf(place->path, sizeof place->path, "/tmp/frond-test-live-service-%d", (int)getpid());
    snprintf(address.sun_path, sizeof address.sun_path, "%s", place->path);
    unlink(place->path);
    place->manager = socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    assert_true(place->manager >= 0);
    assert_int_equal(bind(place->manager, (struct sockaddr *)&address, sizeof address), 0);
    snprintf(pid, sizeof pid, "%d", (int)getpid());
    snprintf(watchdog, sizeof watchdog, "%d", WATCHDOG_US);
    setenv("NOTIFY_SOCKET", place->path, 1);
    setenv("WATCHDOG_PID", pid, 1);
    setenv("WATCHDOG_USEC", watchdog, 1);
    unsetenv("RUNTIME_DIRECTORY");
}

static struct place *open_place(void)
{
    struct place *place = calloc(1, sizeof *place);
    struct display_def def = display_default_def();
    struct studio_def studio = studio_default_def();
    struct device_error display_error;
    struct studio_error error;
    assert_non_null(place);
    listen_as_manager(place);
    def.kind = DISPLAY_HEADLESS;
    def.width = 64;
    def.height = 40;
    place->display = display_create(&def, &display_error);
    assert_non_null(place->display);
    place->script = (struct script){.width = 64, .height = 40, .ticks = SCRIPT_TICKS_MAX, .ink_count = 1};
    place->script.coefficients = coefficients_default();
    studio.script = &place->script;
    studio.teller = (struct studio_teller){hang, place};
    place->studio = studio_create(&studio, place->display, &error);
    assert_non_null(place->studio);
    place->kiosk.status = (struct live_status_def){.display = place->display, .studio = place->studio};
    assert_true(live_service_open(&place->service, 0));
    return place;
}

static void close_place(struct place *place)
{
    atomic_store(&place->hangs, false);
    studio_rest(place->studio, false);
    live_service_close(&place->service);
    studio_destroy(place->studio);
    display_destroy(place->display);
    close(place->manager);
    unlink(place->path);
    unsetenv("NOTIFY_SOCKET");
    free(place);
}

static void present(struct place *place)
{
    uint64_t before = display_frames(place->display).presented;
    double end_s = bench_wall_s() + PATIENCE_S;
    while (display_frames(place->display).presented == before) {
        assert_true(bench_wall_s() < end_s);
        if (display_begin(place->display)) {
            display_end(place->display);
        }
        display_wait(place->display, 20);
    }
}

/* Another frame and a turn of the loop, a second later each, while the manager's time passes. How often it was fed. */
static int turn(struct place *place, int seconds)
{
    char message[256];
    int fed = 0;
    ssize_t length;
    for (int i = 0; i < seconds; i++) {
        present(place);
        place->now_us += 1000000;
        live_service_turn(&place->service, &place->kiosk, place->now_us);
    }
    while ((length = recv(place->manager, message, sizeof message - 1, 0)) >= 0) {
        message[length] = '\0';
        fed += strcmp(message, "WATCHDOG=1") == 0;
    }
    return fed;
}

static void wait_turns(struct place *place, uint64_t more)
{
    uint64_t until = studio_report(place->studio).turns + more;
    double end_s = bench_wall_s() + PATIENCE_S;
    while (studio_report(place->studio).turns < until) {
        assert_true(bench_wall_s() < end_s);
        nap();
    }
}

static void a_tick_that_hangs_starves_the_watchdog(void **state)
{
    (void)state;
    struct place *place = open_place();
    wait_turns(place, 2);
    turn(place, 1);
    wait_turns(place, 2);
    assert_int_equal(turn(place, 3), 1);
    atomic_store(&place->hangs, true);
    for (double end_s = bench_wall_s() + PATIENCE_S; !atomic_load(&place->hung);) {
        assert_true(bench_wall_s() < end_s);
        nap();
    }
    turn(place, 12);
    assert_int_equal(turn(place, 30), 0); /* frames go on, and nobody paints */
    atomic_store(&place->hangs, false);
    wait_turns(place, 2);
    assert_int_equal(turn(place, 1), 1);
    close_place(place);
}

static void a_studio_that_rests_does_not(void **state)
{
    (void)state;
    struct place *place = open_place();
    double end_s = bench_wall_s() + PATIENCE_S;
    studio_rest(place->studio, true);
    while (!studio_report(place->studio).rests) {
        assert_true(bench_wall_s() < end_s);
        nap();
    }
    turn(place, 1);
    assert_int_equal(turn(place, 30), 10);
    studio_rest(place->studio, false);
    wait_turns(place, 2);
    assert_false(studio_report(place->studio).rests);
    close_place(place);
}

static void any_environment_will_do(void **state)
{
    (void)state;
    struct place *place = open_place();
    static const char *const FOLDERS[] = {"", "run/frond"};
    for (int i = 0; i < 2; i++) {
        live_service_close(&place->service);
        setenv("RUNTIME_DIRECTORY", FOLDERS[i], 1);
        assert_true(live_service_open(&place->service, 0)); /* without a status */
        assert_null(place->service.writer);
    }
    close_place(place);
}

static void put_celsius(const char *root, int celsius)
{
    char path[160], text[16];
    snprintf(path, sizeof path, "%s/sys/class/thermal/thermal_zone0/type", root);
    assert_true(folder_case_put(path, "cpu-thermal\n"));
    snprintf(path, sizeof path, "%s/sys/class/thermal/thermal_zone0/temp", root);
    snprintf(text, sizeof text, "%d\n", 1000 * celsius);
    assert_true(folder_case_put(path, text));
}

static void it_tells_the_heat_of_now_while_the_screen_is_dark(void **state)
{
    (void)state;
    char root[FOLDER_CASE_PATH], path[160];
    struct place *place = open_place();
    struct inputs *inputs = inputs_default(&place->script);
    struct live_input input = {.sources = sources_create(&(struct sources_def){.inputs = inputs})};
    struct status status = {.unix_s = 0};
    assert_true(folder_case_make(root));
    snprintf(path, sizeof path, "%s/sys/class/thermal/thermal_zone0", root);
    assert_true(file_make_folder(path, NULL));
    put_celsius(root, 40); /* there is a sensor */
    struct live_care care = {.thermal = thermal_create(root)};
    place->kiosk.status.input = &input;
    place->kiosk.status.care = &care;
    place->kiosk.status.kind = "cpu";
    for (int i = 0; i < 2; i++) { /* and no frame meanwhile */
        put_celsius(root, 40 + i);
        live_service_status(&status, &place->kiosk, (uint64_t)(i + 1) * 5000000);
        assert_int_equal(lround(status.celsius), 40 + i);
    }
    thermal_destroy(care.thermal);
    sources_destroy(input.sources);
    inputs_destroy(inputs);
    assert_true(folder_case_remove(root));
    close_place(place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tick_that_hangs_starves_the_watchdog),
        cmocka_unit_test(a_studio_that_rests_does_not),
        cmocka_unit_test(any_environment_will_do),
        cmocka_unit_test(it_tells_the_heat_of_now_while_the_screen_is_dark),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
