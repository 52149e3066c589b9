/* Cards that are no use, in a folder of devices that umockdev makes. Cards that are: tests/kernel/display_*. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <umockdev.h>

#include "kms_card.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_card_says_why_it_is_not_taken)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
