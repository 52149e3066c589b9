/* What is taken out of texts that go to others, and what stays. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "scrub.h"

static void assert_clean(const struct scrub *scrub, const char *text, const char *wanted)
{
    char *clean = scrub_text(scrub, text);
    assert_non_null(clean);
    assert_string_equal(clean, wanted);
    free(clean);
}

static void words_go_where_they_are_words(void **state)
{
    (void)state;
    struct scrub *scrub = scrub_create();
    assert_non_null(scrub);
    assert_true(scrub_learn(scrub, "pi", "[user]"));
    assert_true(scrub_learn(scrub, " kiosk-7\n", "[host]"));
    assert_true(scrub_learn(scrub, "kiosk-7.museum", "[host]"));
    assert_true(scrub_learn(scrub, "x", "[user]"));       /* would be everywhere */
    assert_true(scrub_learn(scrub, "0000000", "[none]")); /* of a device that has none */
    assert_true(scrub_learn(scrub, "", "[none]"));
    assert_clean(scrub, "/home/pi/pixels, pi", "/home/[user]/pixels, [user]");
    assert_clean(scrub, "PI: Kiosk-7.Museum and KIOSK-7, kiosk-77", "[user]: [host] and [host], kiosk-77");
    assert_clean(scrub, "x 0000000", "x 0000000");
    assert_clean(scrub, "", "");
    scrub_destroy(scrub);
    scrub_destroy(NULL);
}

static void addresses_and_numbers_go(void **state)
{
    (void)state;
    struct scrub *scrub = scrub_create();
    assert_clean(scrub, "eth0 02:42:ac:11:00:02 up", "eth0 [hardware address] up");
    assert_clean(scrub, "at 10.0.0.12:8883.", "at [address]:8883.");
    assert_clean(scrub, "from fe80::1c2d:3eff:fe4f:5061, 2001:db8:1:2:3:4:5:6", "from [address], [address]");
    assert_clean(scrub, "id 123e4567-e89b-12d3-a456-426614174000", "id [unique number]");
    assert_clean(scrub, "id 0123456789abcdef0123456789abcdef;", "id [unique number];");
    assert_clean(scrub, "ask a.b@c-d.example.org, or not", "ask [e-mail address], or not");
    scrub_destroy(scrub);
}

static void what_helps_stays(void **state)
{
    static const char *const texts[] = {
        "exhibit.yaml:2:1: visti: unknown key; did you mean visit?",
        "usb-0000:01:00.0-1.3 046d:c52b /dev/hidraw0",
        "frond 0.1.0, Linux 6.1.0-37-arm64 #1 SMP Debian 6.1.140-1 (2025-05-22)",
        "open: \"10:00\", close: \"18:00\"; 12:30:45.123 zone: [0, 0, 0.5, 1]",
        "frond_frame_seconds_bucket{le=\"0.0175\"} 5000000000",
    };
    (void)state;
    struct scrub *scrub = scrub_create();
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        assert_clean(scrub, texts[i], texts[i]);
    }
    scrub_destroy(scrub);
}

static void the_machine_is_known(void **state)
{
    char host[256] = "";
    (void)state;
    struct scrub *scrub = scrub_create();
    setenv("SUDO_USER", "valentina", 1);
    assert_true(scrub_learn_machine(scrub));
    unsetenv("SUDO_USER");
    assert_clean(scrub, "by Valentina", "by [user]");
    assert_int_equal(gethostname(host, sizeof host - 1), 0);
    char *clean = scrub_text(scrub, host);
    if (strlen(host) > 1 && strcmp(host, "localhost") != 0) {
        assert_string_equal(clean, "[host]");
    }
    free(clean);
    scrub_destroy(scrub);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(words_go_where_they_are_words),
        cmocka_unit_test(addresses_and_numbers_go),
        cmocka_unit_test(what_helps_stays),
        cmocka_unit_test(the_machine_is_known),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
