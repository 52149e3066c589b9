#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>

#include "kms_bench.h"

int kms_bench_set_up(void **state)
{
    struct bench *bench = calloc(1, sizeof *bench);
    assert_non_null(bench);
    fake_init(&bench->fake);
    bench->now_us = 1000000;
    bench->framebuffer = 100;
    *state = bench;
    return 0;
}

int kms_bench_tear_down(void **state)
{
    struct bench *bench = *state;
    if (bench->screen.card) {
        kms_screen_finish(&bench->screen);
    }
    assert_int_equal(bench->fake.blobs, 0);
    free(bench);
    return 0;
}

bool start(struct bench *bench, struct kms_wish wish)
{
    return kms_screen_start(&bench->screen, &bench->fake.card, &wish, bench->now_us, &bench->error);
}

void attend(struct bench *bench, uint64_t after_us, bool hot)
{
    bench->now_us += after_us;
    kms_screen_attend(&bench->screen, bench->now_us, hot);
    while (bench->screen.stage == KMS_CHOSEN && !bench->screen.lent) {
        kms_screen_fit(&bench->screen, bench->framebuffer, true, bench->now_us);
    }
}

bool frame(struct bench *bench)
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

void start_on_hdmi(struct bench *bench)
{
    fake_plug(&bench->fake, 1, 1920, 1080, 60);
    assert_true(start(bench, (struct kms_wish){0}));
    attend(bench, 0, false);
    assert_true(frame(bench));
}
