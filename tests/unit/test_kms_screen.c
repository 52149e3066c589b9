/* A screen through everything that befalls it, on a card that exists in memory. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "kms_fake.h"
#include "kms_screen.h"

enum { FRAME_US = 16667 };

struct bench {
    struct fake fake;
    struct kms_screen screen;
    struct display_error error;
    uint64_t now_us;
    uint32_t framebuffer;
};

static int set_up(void **state)
{
    struct bench *bench = calloc(1, sizeof *bench);
    assert_non_null(bench);
    fake_init(&bench->fake);
    bench->now_us = 1000000;
    bench->framebuffer = 100;
    *state = bench;
    return 0;
}

/* Whatever has happened to it: a screen leaves nothing behind. */
static int tear_down(void **state)
{
    struct bench *bench = *state;
    if (bench->screen.card) {
        kms_screen_finish(&bench->screen);
    }
    assert_int_equal(bench->fake.blobs, 0);
    free(bench);
    return 0;
}

static bool start(struct bench *bench, struct kms_wish wish)
{
    return kms_screen_start(&bench->screen, &bench->fake.card, &wish, bench->now_us, &bench->error);
}

static void attend(struct bench *bench, uint64_t after_us, bool hot)
{
    bench->now_us += after_us;
    kms_screen_attend(&bench->screen, bench->now_us, hot);
    while (bench->screen.stage == KMS_CHOSEN && !bench->screen.lent) {
        kms_screen_fit(&bench->screen, bench->framebuffer, true, bench->now_us);
    }
}

static bool frame(struct bench *bench)
{
    if (!kms_screen_free(&bench->screen)) {
        return false;
    }
    bench->framebuffer ^= 1;
    kms_screen_present(&bench->screen, bench->framebuffer, bench->now_us);
    fake_blank(&bench->fake, bench->now_us + FRAME_US);
    attend(bench, FRAME_US, false);
    return true;
}

static void start_on_hdmi(struct bench *bench)
{
    fake_plug(&bench->fake, 1, 1920, 1080, 60);
    assert_true(start(bench, (struct kms_wish){0}));
    attend(bench, 0, false);
    assert_true(frame(bench));
}

#define EXPECT_STATE(bench, state) assert_int_equal(kms_screen_state(&(bench)->screen), state)

static void frames_are_flipped_and_counted(void **state)
{
    struct bench *bench = *state;
    fake_plug(&bench->fake, 1, 1920, 1080, 60);
    assert_true(start(bench, (struct kms_wish){0}));
    assert_int_equal(bench->screen.stage, KMS_CHOSEN);
    attend(bench, 0, false);
    assert_true(bench->fake.tests > 0);
    EXPECT_STATE(bench, DISPLAY_SHOWN);
    assert_false(bench->fake.active); /* nothing is set before there is a picture */
    kms_screen_present(&bench->screen, 100, bench->now_us);
    assert_true(bench->fake.active && bench->fake.framebuffer == 100 && bench->fake.connector == FAKE_HDMI_1);
    assert_true(bench->fake.width == 1920 && bench->fake.height == 1080);
    assert_false(kms_screen_free(&bench->screen));
    kms_screen_present(&bench->screen, 101, bench->now_us); /* too early: nothing happens */
    assert_int_equal(bench->fake.framebuffer, 100);
    fake_blank(&bench->fake, 1010000);
    attend(bench, 10000, false);
    for (int i = 0; i < 10; i++) {
        assert_true(frame(bench));
    }
    assert_int_equal(bench->screen.frames.presented, 11);
    assert_int_equal(bench->screen.frames.missed, 0);
    assert_int_equal(bench->screen.frames.last_us, 1010000 + 10 * FRAME_US);
    assert_int_equal(bench->screen.frames.refresh_mhz, 60000);
    fake_blank(&bench->fake, 0); /* nobody drew */
    fake_blank(&bench->fake, 0);
    assert_true(frame(bench));
    assert_int_equal(bench->screen.frames.missed, 2);
    assert_int_equal(bench->fake.modesets, 1);
    assert_int_equal(bench->fake.flips, 11);
}

static void a_driver_that_does_not_count_is_counted_by_the_clock(void **state)
{
    struct bench *bench = *state;
    bench->fake.counts = false;
    start_on_hdmi(bench);
    assert_true(frame(bench));
    assert_int_equal(bench->screen.frames.missed, 0);
    attend(bench, 2 * FRAME_US, false);
    assert_true(frame(bench));
    assert_int_equal(bench->screen.frames.missed, 2);
}

static void nothing_is_plugged_in_at_first(void **state)
{
    struct bench *bench = *state;
    assert_true(start(bench, (struct kms_wish){0}));
    EXPECT_STATE(bench, DISPLAY_ABSENT);
    assert_string_equal(bench->screen.reason.text, "nothing is plugged in");
    assert_false(frame(bench));
    fake_plug(&bench->fake, 2, 1280, 720, 50);
    attend(bench, 1000, true);
    EXPECT_STATE(bench, DISPLAY_SHOWN);
    assert_true(frame(bench));
    assert_int_equal(bench->fake.connector, FAKE_HDMI_2);
    assert_int_equal(bench->screen.frames.refresh_mhz, 50000);
}

static void wires_that_say_nothing_are_looked_at(void **state)
{
    struct bench *bench = *state;
    assert_true(start(bench, (struct kms_wish){0}));
    int probes = bench->fake.probes;
    fake_plug(&bench->fake, 1, 1280, 720, 60);
    assert_true(kms_screen_due_us(&bench->screen) <= bench->now_us + KMS_SCAN_US);
    attend(bench, KMS_SCAN_US - 1, false);
    EXPECT_STATE(bench, DISPLAY_ABSENT);
    attend(bench, 1, false);
    EXPECT_STATE(bench, DISPLAY_SHOWN);
    assert_int_equal(bench->fake.probes, probes + 1);
    for (int i = 0; i < 10; i++) { /* and probed only when something has changed: that may take long */
        attend(bench, KMS_SCAN_US, false);
    }
    assert_int_equal(bench->fake.probes, probes + 1);
}

static void unplugged_with_a_flip_on_its_way(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    kms_screen_present(&bench->screen, 100, bench->now_us);
    fake_unplug(&bench->fake, 1);
    attend(bench, 100, true);
    EXPECT_STATE(bench, DISPLAY_ABSENT);
    assert_true(kms_screen_reads(&bench->screen)); /* the kernel is busy: the framebuffers have to stay */
    assert_true(bench->fake.active);
    assert_true(kms_screen_due_us(&bench->screen) <= bench->now_us + KMS_BUSY_US);
    fake_blank(&bench->fake, bench->now_us);
    attend(bench, KMS_BUSY_US, false);
    assert_false(bench->fake.active);
    assert_int_equal(bench->fake.connector, 0);
    assert_false(kms_screen_reads(&bench->screen));
    assert_int_equal(bench->screen.frames.presented, 1); /* the last flip belongs to a screen that was gone */
}

static void switching_off_is_given_up_in_the_end(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    kms_screen_present(&bench->screen, 100, bench->now_us);
    fake_unplug(&bench->fake, 1);
    attend(bench, 100, true);
    attend(bench, KMS_FLIP_US, false); /* that flip never comes */
    assert_false(kms_screen_reads(&bench->screen));
}

static void plugged_in_elsewhere_in_another_size(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    fake_unplug(&bench->fake, 1);
    fake_plug(&bench->fake, 2, 1280, 1024, 75);
    attend(bench, 1000, true);
    EXPECT_STATE(bench, DISPLAY_SHOWN);
    assert_true(frame(bench));
    assert_true(bench->fake.connector == FAKE_HDMI_2 && bench->fake.width == 1280);
    fake_plug(&bench->fake, 1, 1920, 1080, 60); /* does not draw the picture away */
    attend(bench, 1000, true);
    assert_true(frame(bench));
    assert_int_equal(bench->fake.connector, FAKE_HDMI_2);
    fake_plug(&bench->fake, 2, 1024, 768, 60); /* another monitor on the same wire */
    attend(bench, 1000, true);
    assert_true(frame(bench));
    assert_true(bench->fake.connector == FAKE_HDMI_2 && bench->fake.width == 1024);
    assert_int_equal(bench->screen.frames.refresh_mhz, 60000);
}

static void a_thousand_times_in_and_out(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    for (int i = 0; i < 1000; i++) {
        fake_unplug(&bench->fake, 1);
        attend(bench, 1000, true);
        EXPECT_STATE(bench, DISPLAY_ABSENT);
        assert_int_equal(bench->fake.blobs, 0);
        fake_plug(&bench->fake, 1, i % 2 ? 1920 : 1280, 1080, 60);
        attend(bench, 1000, i % 3 != 0);
        attend(bench, KMS_SCAN_US, false);
        assert_true(frame(bench) && frame(bench));
    }
    assert_int_equal(bench->fake.blobs, 1);
    assert_int_equal(bench->screen.frames.presented, 2001);
    assert_int_equal(bench->screen.frames.missed, 0);
}

static void dark_and_light(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    kms_screen_power(&bench->screen, false, bench->now_us);
    EXPECT_STATE(bench, DISPLAY_DARK);
    assert_false(bench->fake.active);
    assert_false(frame(bench));
    fake_blank(&bench->fake, bench->now_us);
    fake_blank(&bench->fake, bench->now_us);
    kms_screen_power(&bench->screen, true, bench->now_us);
    EXPECT_STATE(bench, DISPLAY_SHOWN);
    assert_true(frame(bench));
    assert_true(bench->fake.active);
    kms_screen_present(&bench->screen, 100, bench->now_us); /* and with a flip on its way */
    kms_screen_power(&bench->screen, false, bench->now_us);
    assert_true(bench->fake.active);
    fake_blank(&bench->fake, bench->now_us);
    attend(bench, KMS_BUSY_US, false);
    assert_false(bench->fake.active);
    assert_int_equal(bench->screen.frames.missed, 0);
}

static void a_monitor_unplugs_itself_in_its_sleep(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    kms_screen_power(&bench->screen, false, bench->now_us);
    fake_unplug(&bench->fake, 1);
    attend(bench, 1000, true);
    EXPECT_STATE(bench, DISPLAY_DARK);
    fake_plug(&bench->fake, 1, 1920, 1080, 60);
    attend(bench, 1000, true);
    EXPECT_STATE(bench, DISPLAY_DARK);
    assert_false(bench->fake.active); /* nothing lights it again by night */
    kms_screen_power(&bench->screen, true, bench->now_us);
    assert_true(frame(bench));
    assert_true(bench->fake.active);
}

static void another_master_comes_and_goes(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    bench->fake.master = false;
    bench->fake.other_master = true;
    assert_true(frame(bench));
    EXPECT_STATE(bench, DISPLAY_LENT);
    assert_false(frame(bench));
    for (int i = 0; i < 5; i++) {
        attend(bench, KMS_MASTER_US, false);
        EXPECT_STATE(bench, DISPLAY_LENT);
    }
    bench->fake.other_master = false;
    bench->fake.active = false;
    attend(bench, KMS_MASTER_US - 1, false);
    EXPECT_STATE(bench, DISPLAY_LENT);
    assert_true(kms_screen_due_us(&bench->screen) == bench->now_us + 1);
    attend(bench, 1, false);
    EXPECT_STATE(bench, DISPLAY_SHOWN);
    int modesets = bench->fake.modesets;
    assert_true(frame(bench));
    assert_int_equal(bench->fake.modesets, modesets + 1);
    assert_true(bench->fake.active);
}

static void another_is_master_from_the_start(void **state)
{
    struct bench *bench = *state;
    bench->fake.other_master = true;
    fake_plug(&bench->fake, 1, 1920, 1080, 60);
    assert_true(start(bench, (struct kms_wish){0}));
    attend(bench, 0, false);
    EXPECT_STATE(bench, DISPLAY_LENT);
    bench->fake.other_master = false;
    attend(bench, KMS_MASTER_US, false);
    EXPECT_STATE(bench, DISPLAY_SHOWN);
    assert_true(frame(bench));
}

static void who_may_not_be_master_again_opens_anew(void **state)
{
    struct bench *bench = *state;
    bench->fake.other_master = bench->fake.outsider = true;
    fake_plug(&bench->fake, 1, 1920, 1080, 60);
    assert_true(start(bench, (struct kms_wish){0}));
    attend(bench, KMS_MASTER_US, false);
    assert_false(bench->screen.stale);
    bench->fake.other_master = false;
    attend(bench, KMS_MASTER_US, false);
    EXPECT_STATE(bench, DISPLAY_LENT);
    assert_true(bench->screen.stale);
}

static void unplugged_while_lent(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    bench->fake.master = false;
    bench->fake.other_master = true;
    assert_true(frame(bench));
    fake_unplug(&bench->fake, 1);
    attend(bench, 1000, true);
    EXPECT_STATE(bench, DISPLAY_LENT);
    assert_false(kms_screen_reads(&bench->screen));
    bench->fake.other_master = false;
    attend(bench, KMS_MASTER_US, false);
    EXPECT_STATE(bench, DISPLAY_ABSENT);
    fake_plug(&bench->fake, 1, 800, 600, 60);
    attend(bench, KMS_SCAN_US, false);
    assert_true(frame(bench));
    assert_int_equal(bench->fake.width, 800);
}

static void another_monitor_came_while_lent(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    bench->fake.master = false;
    bench->fake.other_master = true;
    assert_true(frame(bench));
    fake_plug(&bench->fake, 1, 1280, 720, 60);
    attend(bench, 1000, true); /* its modes are not told to those who are not master */
    bench->fake.other_master = false;
    attend(bench, KMS_MASTER_US, false);
    assert_true(frame(bench));
    assert_int_equal(bench->fake.width, 1280);
}

static void the_master_is_lost_while_switching_off(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    bench->fake.master = false;
    bench->fake.other_master = true;
    fake_unplug(&bench->fake, 1);
    attend(bench, 1000, true);
    EXPECT_STATE(bench, DISPLAY_LENT);
    assert_false(kms_screen_reads(&bench->screen));
    assert_int_equal(bench->fake.blobs, 0);
}

static void a_refusal_names_connector_mode_and_property(void **state)
{
    struct bench *bench = *state;
    fake_plug(&bench->fake, 1, 1920, 1080, 60);
    bench->fake.refused_property = FAKE_PLANE_PROPERTIES + 8;
    assert_true(start(bench, (struct kms_wish){0}));
    assert_false(kms_screen_fit(&bench->screen, 100, false, bench->now_us));
    assert_string_equal(bench->screen.reason.text,
                        "HDMI-A-1 1920x1080@60: property CRTC_W = 1920 is refused: Invalid argument");
    assert_int_equal(bench->screen.stage, KMS_CHOSEN); /* another kind of framebuffer may be tried */
    bench->fake.refused_property = 0;
    assert_true(kms_screen_fit(&bench->screen, 102, false, bench->now_us));
    EXPECT_STATE(bench, DISPLAY_SHOWN);
}

static void a_refused_mode_makes_way_for_the_next(void **state)
{
    struct bench *bench = *state;
    fake_plug(&bench->fake, 1, 3840, 2160, 60);
    fake_add_mode(&bench->fake, 1, 1920, 1080, 60, 0, 0);
    bench->fake.refused_width = 3840;
    assert_true(start(bench, (struct kms_wish){0}));
    attend(bench, 0, false);
    assert_true(frame(bench));
    assert_int_equal(bench->fake.width, 1920);
    assert_string_equal(bench->screen.reason.text,
                        "HDMI-A-1 3840x2160@60: property MODE_ID: the mode is refused: Invalid argument");
    attend(bench, KMS_SCAN_US, true); /* and it is not tried again with every look */
    assert_true(frame(bench));
    assert_int_equal(bench->fake.width, 1920);
}

static void when_every_mode_is_refused_the_screen_is_absent(void **state)
{
    struct bench *bench = *state;
    fake_plug(&bench->fake, 1, 3840, 2160, 60);
    bench->fake.refused_width = 3840;
    assert_true(start(bench, (struct kms_wish){0}));
    attend(bench, 0, false);
    EXPECT_STATE(bench, DISPLAY_ABSENT);
    assert_non_null(strstr(bench->screen.reason.text, "3840x2160@60"));
    int tests = bench->fake.tests;
    attend(bench, KMS_SCAN_US, false);
    assert_int_equal(bench->fake.tests, tests);
    assert_non_null(strstr(bench->screen.reason.text, "3840x2160@60"));
    bench->fake.refused_width = 0;
    attend(bench, KMS_REFUSED_US, false); /* tried again */
    EXPECT_STATE(bench, DISPLAY_SHOWN);
    assert_true(frame(bench));
}

static void a_mode_that_fails_when_it_is_set(void **state)
{
    struct bench *bench = *state;
    fake_plug(&bench->fake, 1, 1920, 1080, 60);
    fake_add_mode(&bench->fake, 1, 1280, 720, 60, 0, 0);
    assert_true(start(bench, (struct kms_wish){0}));
    attend(bench, 0, false);
    bench->fake.refused_width = 1920; /* between the test and the commit */
    assert_true(frame(bench));
    attend(bench, 0, false);
    assert_true(frame(bench));
    assert_int_equal(bench->fake.width, 1280);
}

static void a_wish_that_cannot_come_true(void **state)
{
    struct bench *bench = *state;
    fake_plug(&bench->fake, 1, 1920, 1080, 60);
    assert_false(start(bench, (struct kms_wish){.connector = "VGA-1"}));
    assert_string_equal(bench->error.text, "fake has no connector VGA-1, but DSI-1, HDMI-A-1, HDMI-A-2");
    kms_screen_finish(&bench->screen);
    assert_false(start(bench, (struct kms_wish){.width = 800, .height = 600, .refresh_mhz = 72000}));
    assert_string_equal(bench->error.text, "HDMI-A-1 has no mode 800x600 at 72 Hz; it has 1920x1080@60 and 0 more");
    kms_screen_finish(&bench->screen);
    assert_true(start(bench, (struct kms_wish){.connector = "HDMI-A-2"})); /* is there, and not plugged in */
    EXPECT_STATE(bench, DISPLAY_ABSENT);
}

static void a_plane_without_a_property_is_named(void **state)
{
    struct bench *bench = *state;
    fake_plug(&bench->fake, 1, 1920, 1080, 60);
    bench->fake.lacks = true;
    assert_true(start(bench, (struct kms_wish){0}));
    EXPECT_STATE(bench, DISPLAY_ABSENT);
    assert_string_equal(bench->screen.reason.text, "HDMI-A-1 1920x1080@60: the plane has no property SRC_W");
}

static void a_flip_that_never_comes(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    kms_screen_present(&bench->screen, 100, bench->now_us);
    bench->fake.pending = false; /* lost */
    attend(bench, KMS_FLIP_US - 1, false);
    assert_false(kms_screen_free(&bench->screen));
    attend(bench, 1, false);
    int modesets = bench->fake.modesets;
    kms_screen_present(&bench->screen, 101, bench->now_us);
    assert_int_equal(bench->fake.modesets, modesets + 1);
    uint64_t presented = bench->screen.frames.presented;
    bench->fake.token--; /* it does come, now that another is on its way */
    fake_blank(&bench->fake, bench->now_us);
    attend(bench, 1, false);
    assert_false(kms_screen_free(&bench->screen));
    assert_int_equal(bench->screen.frames.presented, presented);
}

static void a_busy_kernel_gets_the_frame_later(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    bench->fake.fail_flips = EBUSY;
    kms_screen_present(&bench->screen, 123, bench->now_us);
    assert_false(kms_screen_free(&bench->screen));
    assert_true(kms_screen_due_us(&bench->screen) <= bench->now_us + KMS_BUSY_US);
    attend(bench, KMS_BUSY_US, false);
    assert_int_equal(bench->fake.framebuffer, 123);
    fake_blank(&bench->fake, bench->now_us);
    attend(bench, 1, false);
    assert_true(kms_screen_free(&bench->screen));
}

static void a_refused_flip_sets_the_mode_again(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    bench->fake.fail_flips = EINVAL;
    assert_true(frame(bench));
    EXPECT_STATE(bench, DISPLAY_SHOWN);
    int modesets = bench->fake.modesets;
    assert_true(frame(bench));
    assert_int_equal(bench->fake.modesets, modesets + 1);
}

static void a_link_that_has_failed_is_trained_again(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    int trained = bench->fake.link_trained;
    bench->fake.wires.connectors[1].broken = true;
    attend(bench, 1000, true);
    bench->fake.wires.connectors[1].broken = false;
    assert_true(frame(bench));
    assert_int_equal(bench->fake.link_trained, trained + 1);
}

static void what_others_left_on_the_crtc_has_to_go(void **state)
{
    struct bench *bench = *state;
    bench->fake.overlay_shown = true;
    bench->fake.wires.connectors[2].crtc = FAKE_CRTC;
    bench->fake.connector = FAKE_HDMI_2;
    start_on_hdmi(bench);
    assert_false(bench->fake.overlay_shown);
    assert_int_equal(bench->fake.connector, FAKE_HDMI_1);
}

static void what_was_there_is_put_back(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    kms_screen_finish(&bench->screen);
    assert_int_equal(bench->fake.restored, 1);
    fake_init(&bench->fake); /* but not on another's screen */
    start_on_hdmi(bench);
    bench->fake.master = false;
    bench->fake.other_master = true;
    assert_true(frame(bench));
    kms_screen_finish(&bench->screen);
    assert_int_equal(bench->fake.restored + bench->fake.denied, 0);
    bench->screen.card = NULL;
}

static void a_card_that_is_pulled_out(void **state)
{
    struct bench *bench = *state;
    start_on_hdmi(bench);
    bench->fake.broken = true;
    attend(bench, KMS_SCAN_US, false);
    EXPECT_STATE(bench, DISPLAY_ABSENT);
    assert_non_null(strstr(bench->screen.reason.text, "No such device"));
}

static void cards_without_atomic_calls(void **state)
{
    struct bench *bench = *state;
    bench->fake.card.atomic = false;
    start_on_hdmi(bench);
    assert_int_equal(bench->screen.frames.presented, 1);
    assert_true(frame(bench) && frame(bench));
    assert_int_equal(bench->fake.modesets, 1);
    assert_int_equal(bench->fake.flips, 2);
    assert_int_equal(bench->screen.frames.presented, 3);
    kms_screen_power(&bench->screen, false, bench->now_us);
    assert_int_equal(bench->fake.dpms, DRM_MODE_DPMS_OFF);
    kms_screen_power(&bench->screen, true, bench->now_us);
    assert_true(frame(bench));
    assert_int_equal(bench->fake.dpms, DRM_MODE_DPMS_ON);
    fake_unplug(&bench->fake, 1);
    attend(bench, KMS_SCAN_US, false);
    EXPECT_STATE(bench, DISPLAY_ABSENT);
    assert_false(bench->fake.active);
    fake_plug(&bench->fake, 1, 1280, 720, 60);
    bench->fake.refused_width = 1280;
    attend(bench, KMS_SCAN_US, false);
    assert_true(frame(bench));
    EXPECT_STATE(bench, DISPLAY_ABSENT);
    assert_non_null(strstr(bench->screen.reason.text, "HDMI-A-1 1280x720@60"));
}

#define CASE(function) cmocka_unit_test_setup_teardown(function, set_up, tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        CASE(frames_are_flipped_and_counted),
        CASE(a_driver_that_does_not_count_is_counted_by_the_clock),
        CASE(nothing_is_plugged_in_at_first),
        CASE(wires_that_say_nothing_are_looked_at),
        CASE(unplugged_with_a_flip_on_its_way),
        CASE(switching_off_is_given_up_in_the_end),
        CASE(plugged_in_elsewhere_in_another_size),
        CASE(a_thousand_times_in_and_out),
        CASE(dark_and_light),
        CASE(a_monitor_unplugs_itself_in_its_sleep),
        CASE(another_master_comes_and_goes),
        CASE(another_is_master_from_the_start),
        CASE(who_may_not_be_master_again_opens_anew),
        CASE(unplugged_while_lent),
        CASE(another_monitor_came_while_lent),
        CASE(the_master_is_lost_while_switching_off),
        CASE(a_refusal_names_connector_mode_and_property),
        CASE(a_refused_mode_makes_way_for_the_next),
        CASE(when_every_mode_is_refused_the_screen_is_absent),
        CASE(a_mode_that_fails_when_it_is_set),
        CASE(a_wish_that_cannot_come_true),
        CASE(a_plane_without_a_property_is_named),
        CASE(a_flip_that_never_comes),
        CASE(a_busy_kernel_gets_the_frame_later),
        CASE(a_refused_flip_sets_the_mode_again),
        CASE(a_link_that_has_failed_is_trained_again),
        CASE(what_others_left_on_the_crtc_has_to_go),
        CASE(what_was_there_is_put_back),
        CASE(a_card_that_is_pulled_out),
        CASE(cards_without_atomic_calls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
