/* A transition on a display: what is seen is what the plates say (transition_reveal), also after the GPU was lost, and
 * nothing when it is over. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <time.h>

#include <GLES3/gl31.h>

#include "bench.h"
#include "live_leave.h"
#include "patience.h"

enum { WIDTH = 320, HEIGHT = 200, BYTES = WIDTH * HEIGHT * 3, SEED = 3 };

static const uint8_t BELOW[3] = {30, 90, 160};

struct place {
    struct display *display;
    struct live_leave leave;
    uint8_t shown[BYTES], wanted[BYTES];
};

static struct place *open_place(void)
{
    struct place *place = calloc(1, sizeof *place);
    struct display_def def = display_default_def();
    struct device_error error;
    assert_non_null(place);
    def.kind = DISPLAY_HEADLESS;
    def.width = WIDTH;
    def.height = HEIGHT;
    def.refresh_mhz = 60000;
    place->display = display_create(&def, &error);
    assert_non_null(place->display);
    live_leave_init(&place->leave, NULL);
    return place;
}

static void close_place(struct place *place)
{
    live_leave_finish(&place->leave);
    display_destroy(place->display);
    free(place);
}

static void until_made(struct place *place, enum transition_kind kind, uint32_t seed)
{
    double end_s = bench_wall_s() + PATIENCE_S;
    while (!live_leave_cover(&place->leave, (int)kind, seed, 0, WIDTH, HEIGHT)) {
        assert_true(bench_wall_s() < end_s);
        nanosleep(&(struct timespec){0, 1000000}, NULL);
    }
}

/* A frame of BELOW and what lies over it. */
static void show(struct place *place, enum transition_kind kind, double share)
{
    struct shader_error error;
    while (!display_begin(place->display)) {
        nanosleep(&(struct timespec){0, 1000000}, NULL);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, display_framebuffer(place->display));
    glDisable(GL_SCISSOR_TEST);
    glClearColor((float)BELOW[0] / 255, (float)BELOW[1] / 255, (float)BELOW[2] / 255, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    live_leave_cover(&place->leave, (int)kind, SEED, share, WIDTH, HEIGHT);
    assert_true(live_leave_draw(&place->leave, place->display, &error));
    display_end(place->display);
    assert_true(display_capture(place->display, place->shown));
}

static double mean_apart(struct place *place, const struct transition *transition, double share)
{
    double sum = 0;
    for (int i = 0; i < BYTES; i++) {
        place->wanted[i] = BELOW[i % 3];
    }
    if (transition) {
        assert_true(transition_reveal(transition, share, place->wanted));
    }
    for (int i = 0; i < BYTES; i++) {
        sum += abs(place->shown[i] - place->wanted[i]);
    }
    return sum / BYTES;
}

static void what_is_seen_is_what_was_made(void **state)
{
    /* Whole ticks: the GPU shows those between as well. */
    static const double SHARES[] = {0, 0.2, 0.4, 0.7, 0.8, 0.9, 1, 1.25, 1.5, 1.75, 2};
    (void)state;
    struct place *place = open_place();
    for (enum transition_kind kind = TRANSITION_DRY; kind <= TRANSITION_FREEZE; kind++) {
        struct transition transition;
        assert_true(transition_init(&transition, kind, SEED, WIDTH, HEIGHT));
        until_made(place, kind, SEED);
        for (size_t i = 0; i < sizeof SHARES / sizeof *SHARES; i++) {
            show(place, kind, SHARES[i]);
            assert_true(mean_apart(place, &transition, SHARES[i]) < 0.7);
            assert_true(mean_apart(place, NULL, 0) > 20 || SHARES[i] < 0.3 || SHARES[i] > 1.7);
            if (i == 5) {
                live_leave_lost(&place->leave);
            }
        }
        transition_finish(&transition);
    }
    show(place, TRANSITION_WASH, 0);
    assert_true(mean_apart(place, NULL, 0) <= 0);
    assert_null(place->leave.gpu);
    assert_null(place->leave.transition.over.rgba);
    close_place(place);
}

/* Nobody waits for the thread but whoever closes it. */
static void what_is_not_made_yet_is_not_seen(void **state)
{
    (void)state;
    struct place *place = open_place();
    show(place, TRANSITION_FREEZE, 0.9);
    if (!atomic_load(&place->leave.made)) {
        assert_true(mean_apart(place, NULL, 0) <= 0);
    }
    close_place(place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_seen_is_what_was_made),
        cmocka_unit_test(what_is_not_made_yet_is_not_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
