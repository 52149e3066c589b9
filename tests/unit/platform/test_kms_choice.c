/* Which connector, mode and CRTC, from lists. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

#include "display_pace.h"
#include "kms_choice.h"
#include "kms_fake.h"

static const struct kms_wish ANY = {0};

static const drmModeModeInfo HD = {.clock = 148500,
                                   .hdisplay = 1920,
                                   .hsync_start = 2008,
                                   .hsync_end = 2052,
                                   .htotal = 2200,
                                   .vdisplay = 1080,
                                   .vsync_start = 1084,
                                   .vsync_end = 1089,
                                   .vtotal = 1125,
                                   .vrefresh = 60};

static void a_mode_is_named_by_its_clock(void **state)
{
    (void)state;
    char text[KMS_MODE_TEXT];
    drmModeModeInfo mode = HD;
    assert_int_equal(kms_mode_refresh_mhz(&mode), 60000);
    kms_mode_text(&mode, text);
    assert_string_equal(text, "1920x1080@60");
    mode.clock = 148352;
    assert_int_equal(kms_mode_refresh_mhz(&mode), 59940);
    kms_mode_text(&mode, text);
    assert_string_equal(text, "1920x1080@59.94");
    mode.clock = 74250;
    mode.flags = DRM_MODE_FLAG_INTERLACE;
    kms_mode_text(&mode, text);
    assert_string_equal(text, "1920x1080i@60");
    mode.flags = DRM_MODE_FLAG_DBLSCAN;
    assert_int_equal(kms_mode_refresh_mhz(&mode), 15000);
    mode.htotal = 0; /* a driver that fills in nothing else */
    assert_int_equal(kms_mode_refresh_mhz(&mode), 60000);
}

static void modes_differ_by_their_timing(void **state)
{
    (void)state;
    drmModeModeInfo other = HD;
    other.type = DRM_MODE_TYPE_PREFERRED;
    strcpy(other.name, "another");
    assert_true(kms_mode_same(&HD, &other));
    other.flags = DRM_MODE_FLAG_PHSYNC;
    assert_false(kms_mode_same(&HD, &other));
    other = HD;
    other.vsync_start++;
    assert_false(kms_mode_same(&HD, &other));
}

static void fill_modes(struct fake *fake)
{
    fake_init(fake);
    fake->wires.connectors[1].connected = true;
    fake_add_mode(fake, 1, 3840, 2160, 30, 0, 0);
    fake_add_mode(fake, 1, 1920, 1080, 60, DRM_MODE_FLAG_INTERLACE, 0);
    fake_add_mode(fake, 1, 1920, 1080, 50, 0, 0);
    fake_add_mode(fake, 1, 1920, 1080, 60, 0, DRM_MODE_TYPE_PREFERRED);
    fake_add_mode(fake, 1, 1920, 1080, 120, 0, 0);
    fake_add_mode(fake, 1, 1280, 720, 75, 0, 0);
    fake_add_mode(fake, 1, 1280, 720, 59, 0, 0);
}

static void the_preferred_mode_is_taken_or_the_one_asked_for(void **state)
{
    (void)state;
    static struct fake fake;
    fill_modes(&fake);
    struct kms_connector *connector = &fake.wires.connectors[1];
    assert_int_equal(kms_choose_mode(connector, &ANY, NULL), 3);
    assert_int_equal(kms_choose_mode(connector, &(struct kms_wish){.refresh_mhz = 50000}, NULL), 2);
    assert_int_equal(kms_choose_mode(connector, &(struct kms_wish){.refresh_mhz = 30000}, NULL), 0);
    assert_int_equal(kms_choose_mode(connector, &(struct kms_wish){.width = 1280, .height = 720}, NULL), 6);
    assert_int_equal(kms_choose_mode(connector, &(struct kms_wish){.width = 1280}, NULL), 6);
    assert_int_equal(
        kms_choose_mode(connector, &(struct kms_wish){.width = 1280, .height = 720, .refresh_mhz = 75400}, NULL), 5);
    assert_int_equal(
        kms_choose_mode(connector, &(struct kms_wish){.width = 1280, .height = 720, .refresh_mhz = 76000}, NULL), -1);
    assert_int_equal(kms_choose_mode(connector, &(struct kms_wish){.width = 800}, NULL), -1);
    connector->modes[3].type = 0; /* nothing is preferred: the largest */
    assert_int_equal(kms_choose_mode(connector, &ANY, NULL), 0);
    connector->mode_count = 0;
    assert_int_equal(kms_choose_mode(connector, &ANY, NULL), -1);
}

static void what_was_refused_is_passed_over(void **state)
{
    (void)state;
    static struct fake fake;
    fill_modes(&fake);
    const struct kms_connector *connector = &fake.wires.connectors[1];
    bool refused[KMS_MODES] = {false};
    const int order[] = {3, 2, 4, 0, 6, 5, 1}; /* fields last */
    for (int i = 0; i < 7; i++) {
        assert_int_equal(kms_choose_mode(connector, &ANY, refused), order[i]);
        refused[order[i]] = true;
    }
    assert_int_equal(kms_choose_mode(connector, &ANY, refused), -1);
}

static void connectors_have_an_order(void **state)
{
    (void)state;
    static struct fake fake;
    const struct kms_wish second = {.connector = "HDMI-A-2"}, none = {.connector = "VGA-1"};
    fake_init(&fake);
    assert_int_equal(kms_choose_connector(&fake.wires, &ANY, 0), -1);
    fake_plug(&fake, 0, 800, 480, 60);
    assert_int_equal(kms_choose_connector(&fake.wires, &ANY, 0), 0);
    fake_plug(&fake, 2, 1920, 1080, 60);
    assert_int_equal(kms_choose_connector(&fake.wires, &ANY, 0), 2);
    fake_plug(&fake, 1, 1920, 1080, 60);
    assert_int_equal(kms_choose_connector(&fake.wires, &ANY, 0), 1);
    assert_int_equal(kms_choose_connector(&fake.wires, &ANY, FAKE_DSI), 0); /* stays where it is */
    assert_int_equal(kms_choose_connector(&fake.wires, &second, FAKE_DSI), 2);
    assert_int_equal(kms_choose_connector(&fake.wires, &none, 0), -1);
    fake.wires.connectors[1].admitted = false; /* on somebody's head */
    assert_int_equal(kms_choose_connector(&fake.wires, &ANY, 0), 2);
    fake.wires.connectors[2].mode_count = 0;
    assert_int_equal(kms_choose_connector(&fake.wires, &ANY, 0), 0);
}

static void a_card_is_as_good_as_its_best_connector(void **state)
{
    (void)state;
    static struct fake fake, panel, nothing;
    fake_init(&fake);
    fake_init(&panel);
    panel.wires.connector_count = 1;
    assert_int_equal(kms_card_score(&nothing.wires, &ANY), 0);
    assert_true(kms_card_score(&fake.wires, &ANY) > kms_card_score(&panel.wires, &ANY));
    fake_plug(&panel, 0, 800, 480, 60);
    assert_true(kms_card_score(&panel.wires, &ANY) > kms_card_score(&fake.wires, &ANY));
    assert_int_equal(kms_card_score(&panel.wires, &(struct kms_wish){.connector = "HDMI-A-1"}), 0);
    assert_true(kms_card_score(&fake.wires, &(struct kms_wish){.connector = "HDMI-A-1"}) > 0);
}

static void a_crtc_that_feeds_it_or_nothing_else(void **state)
{
    (void)state;
    static struct fake fake;
    fake_init(&fake);
    struct kms_connector *connector = &fake.wires.connectors[1];
    connector->crtc_mask = 3;
    assert_int_equal(kms_choose_crtc(&fake.wires, connector), FAKE_CRTC);
    fake.wires.connectors[0].crtc = FAKE_CRTC;
    assert_int_equal(kms_choose_crtc(&fake.wires, connector), FAKE_CRTC_OTHER);
    connector->crtc_mask = 1;
    assert_int_equal(kms_choose_crtc(&fake.wires, connector), FAKE_CRTC);
    connector->crtc = FAKE_CRTC_OTHER;
    assert_int_equal(kms_choose_crtc(&fake.wires, connector), FAKE_CRTC_OTHER);
    connector->crtc = connector->crtc_mask = 0;
    assert_int_equal(kms_choose_crtc(&fake.wires, connector), 0);
}

static uint64_t missed(struct display_pace *pace, uint32_t sequence, uint64_t time_us)
{
    return display_pace_missed(pace, sequence, time_us, 60000);
}

static void missed_frames_are_counted_by_the_kernel_or_the_clock(void **state)
{
    (void)state;
    struct display_pace pace = {0};
    assert_int_equal(missed(&pace, 1000, 1000000), 0); /* the first */
    assert_int_equal(missed(&pace, 1001, 1016667), 0);
    assert_int_equal(missed(&pace, 1004, 1066667), 2);
    /* A counter that was set anew: by the clock. */
    assert_int_equal(missed(&pace, UINT32_MAX, 1100000), 1);
    assert_int_equal(missed(&pace, 2, 1150000), 2); /* wraps */
    display_pace_stop(&pace);
    assert_int_equal(missed(&pace, 500, 9000000), 0);
    assert_int_equal(missed(&pace, 0, 9016667), 0); /* a driver that does not count */
    assert_int_equal(missed(&pace, 0, 9033333), 0);
    assert_int_equal(missed(&pace, 0, 9083333), 2);
    assert_int_equal(missed(&pace, 0, 9083333), 0);
    assert_int_equal(display_pace_missed(&pace, 0, 9999999, 0), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mode_is_named_by_its_clock),
        cmocka_unit_test(modes_differ_by_their_timing),
        cmocka_unit_test(the_preferred_mode_is_taken_or_the_one_asked_for),
        cmocka_unit_test(what_was_refused_is_passed_over),
        cmocka_unit_test(connectors_have_an_order),
        cmocka_unit_test(a_card_is_as_good_as_its_best_connector),
        cmocka_unit_test(a_crtc_that_feeds_it_or_nothing_else),
        cmocka_unit_test(missed_frames_are_counted_by_the_kernel_or_the_clock),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
