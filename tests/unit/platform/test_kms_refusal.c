/* What a card refuses, and what a screen makes of it, on a card that exists in memory. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "kms_bench.h"

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

static void a_mode_without_framebuffers_makes_way_for_the_next(void **state)
{
    struct bench *bench = *state;
    const struct device_error reason = {"no buffer of 1920x1080"};
    fake_plug(&bench->fake, 1, 1920, 1080, 60);
    fake_add_mode(&bench->fake, 1, 1280, 720, 60, 0, 0);
    assert_true(start(bench, (struct kms_wish){0}));
    kms_screen_unfit(&bench->screen, &reason, bench->now_us);
    assert_string_equal(bench->screen.reason.text, reason.text);
    assert_int_equal(bench->screen.stage, KMS_CHOSEN);
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        KMS_CASE(a_refusal_names_connector_mode_and_property),
        KMS_CASE(a_refused_mode_makes_way_for_the_next),
        KMS_CASE(when_every_mode_is_refused_the_screen_is_absent),
        KMS_CASE(a_mode_that_fails_when_it_is_set),
        KMS_CASE(a_mode_without_framebuffers_makes_way_for_the_next),
        KMS_CASE(a_wish_that_cannot_come_true),
        KMS_CASE(a_plane_without_a_property_is_named),
        KMS_CASE(a_flip_that_never_comes),
        KMS_CASE(a_busy_kernel_gets_the_frame_later),
        KMS_CASE(a_refused_flip_sets_the_mode_again),
        KMS_CASE(a_link_that_has_failed_is_trained_again),
        KMS_CASE(what_others_left_on_the_crtc_has_to_go),
        KMS_CASE(what_was_there_is_put_back),
        KMS_CASE(a_card_that_is_pulled_out),
        KMS_CASE(cards_without_atomic_calls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
