/* A screen through everything that befalls it, on a card that exists in memory. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>
#include <string.h>

#include "kms_bench.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        KMS_CASE(frames_are_flipped_and_counted),
        KMS_CASE(a_driver_that_does_not_count_is_counted_by_the_clock),
        KMS_CASE(nothing_is_plugged_in_at_first),
        KMS_CASE(wires_that_say_nothing_are_looked_at),
        KMS_CASE(unplugged_with_a_flip_on_its_way),
        KMS_CASE(switching_off_is_given_up_in_the_end),
        KMS_CASE(plugged_in_elsewhere_in_another_size),
        KMS_CASE(a_thousand_times_in_and_out),
        KMS_CASE(dark_and_light),
        KMS_CASE(a_monitor_unplugs_itself_in_its_sleep),
        KMS_CASE(another_master_comes_and_goes),
        KMS_CASE(another_is_master_from_the_start),
        KMS_CASE(who_may_not_be_master_again_opens_anew),
        KMS_CASE(unplugged_while_lent),
        KMS_CASE(another_monitor_came_while_lent),
        KMS_CASE(the_master_is_lost_while_switching_off),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
