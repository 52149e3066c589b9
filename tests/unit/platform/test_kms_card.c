/* Cards that are no use, and news of wires, as umockdev makes them. Cards that are of use: tests/kernel/display_*. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <umockdev.h>

#include "kms_card.h"
#include "kms_watch.h"

static void put_card(UMockdevTestbed *bed, const char *name)
{
    char text[200];
    snprintf(text, sizeof text, "P: /devices/%s\nN: dri/%s\nE: DEVNAME=/dev/dri/%s\nE: SUBSYSTEM=drm\n", name, name,
             name);
    assert_true(umockdev_testbed_add_from_string(bed, text, NULL));
}

static void every_card_says_why_it_is_not_taken(void **state)
{
    (void)state;
    struct device_error error;
    const struct kms_wish wish = {.connector = NULL};
    if (access("/dev/dri", F_OK) == 0) { /* what is really there would be found too */
        skip();
    }
    UMockdevTestbed *bed = umockdev_testbed_new();
    assert_null(kms_card_open(NULL, &wish, false, &error));
    assert_string_equal(error.text, "kms: no /dev/dri/card* on this machine");
    assert_null(kms_card_open("/dev/dri/card7", &wish, false, &error));
    assert_string_equal(error.text, "kms: /dev/dri/card7: No such file or directory");
    put_card(bed, "card0");
    put_card(bed, "card10");
    assert_null(kms_card_open(NULL, &wish, false, &error));
    assert_non_null(strstr(error.text, "kms: /dev/dri/card0 (unknown): "));
    assert_non_null(strstr(error.text, "; /dev/dri/card10 (unknown): "));
    g_object_unref(bed);
}

static void what_is_plugged_in_or_out_is_heard_of(void **state)
{
    (void)state;
    UMockdevTestbed *bed = umockdev_testbed_new();
    char *card = umockdev_testbed_add_device(bed, "drm", "card0", NULL, NULL, "DEVTYPE", "drm_minor", NULL);
    struct kms_watch *watch = kms_watch_create();
    assert_non_null(watch);
    assert_false(kms_watch_read(watch));
    umockdev_testbed_uevent(bed, card, "change");
    assert_int_equal(poll(&(struct pollfd){.fd = kms_watch_fd(watch), .events = POLLIN}, 1, 5000), 1);
    assert_true(kms_watch_read(watch));
    assert_false(kms_watch_read(watch));
    kms_watch_destroy(watch);
    assert_int_equal(kms_watch_fd(NULL), -1);
    assert_false(kms_watch_read(NULL));
    kms_watch_destroy(NULL);
    g_free(card);
    g_object_unref(bed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_card_says_why_it_is_not_taken),
        cmocka_unit_test(what_is_plugged_in_or_out_is_heard_of),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
