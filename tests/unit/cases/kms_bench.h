/* A screen on a card that exists in memory, with a clock of its own: what the tests of screens share. Included after
 * cmocka.h. */
#ifndef FROND_TESTS_KMS_BENCH_H
#define FROND_TESTS_KMS_BENCH_H

#include "kms_fake.h"
#include "kms_screen.h"

enum { FRAME_US = 16667 };

struct bench {
    struct fake fake;
    struct kms_screen screen;
    struct device_error error;
    uint64_t now_us;
    uint32_t framebuffer;
};

int kms_bench_set_up(void **state);
/* Whatever has happened to it: a screen leaves nothing behind. */
int kms_bench_tear_down(void **state);
bool start(struct bench *bench, struct kms_wish wish);
/* So much later; buffers are made where the screen wants some. */
void attend(struct bench *bench, uint64_t after_us, bool hot);
/* A frame presented and shown, if one may be drawn. */
bool frame(struct bench *bench);
void start_on_hdmi(struct bench *bench);

#define EXPECT_STATE(bench, state) assert_int_equal(kms_screen_state(&(bench)->screen), state)
#define KMS_CASE(function)         cmocka_unit_test_setup_teardown(function, kms_bench_set_up, kms_bench_tear_down)

#endif
