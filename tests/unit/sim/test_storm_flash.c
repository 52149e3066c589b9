/* Nobody is harmed by lightning: however fast eight visitors strike, no more than three flashes are to be seen in any
 * second, as WCAG counts them (flash.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "flash.h"
#include "storm_case.h"

enum { WIDTH = 96, HEIGHT = 60, TICKS = 150, VISITORS = 8 };

struct hail {
    enum bolt_kind kind;
    int each;              /* ticks from one strike to the next, of all visitors */
    bool one_place;        /* all at one place */
    float thickness, life; /* 0: that of its kind */
    int ground;            /* 0..255: of the painting that shows; -1: none does */
};

static struct flash_worst strike_all(const struct hail *hail)
{
    struct storm *storm = storm_case_of(hail->kind);
    struct flash *flash = flash_begin(WIDTH, HEIGHT);
    uint8_t *rgb = malloc(3 * WIDTH * HEIGHT);
    assert_non_null(rgb);
    storm_case_set(storm, 0, "clear", hail->ground >= 0 ? 1.0f : 0.0f);
    if (hail->thickness > 0) {
        storm_case_set(storm, 0, "thickness", hail->thickness);
        storm_case_set(storm, 0, "life", hail->life);
    }
    for (int64_t tick = 0; tick < TICKS; tick++) {
        if (tick % hail->each == 0) {
            int number = (int)tick / hail->each;
            float x = hail->one_place ? 0.5f : (float)(number * 37 % 100) / 100;
            storm_case_strike(storm, tick, 1 + number % VISITORS, x, hail->one_place ? 0.8f : 0.5f + 0.4f * x);
        }
        storm_case_ticks(storm, tick, tick + 1);
        memset(rgb, hail->ground >= 0 ? hail->ground : 0, 3 * WIDTH * HEIGHT);
        assert_true(storm_type.lay(storm, tick, WIDTH, HEIGHT, rgb));
        flash_frame(flash, rgb, (uint64_t)tick * 1000000 / 60);
    }
    struct flash_worst worst = flash_worst(flash);
    print_message("%s each %d: %d flashes in a second at most, %d red; %.3f of light within one\n",
                  bolt_kind_names[hail->kind], hail->each, worst.general, worst.red, worst.mean_change);
    free(rgb);
    flash_end(flash);
    storm_destroy(storm);
    return worst;
}

static void three_flashes_are_the_most(void **state)
{
    (void)state;
    static const struct hail HAILS[] = {
        {BOLT_LIGHTNING, 1, false, 0, 0, 128},  {BOLT_LIGHTNING, 9, false, 0, 0, -1},
        {BOLT_LIGHTNING, 11, false, 4, 6, 110}, {BOLT_LIGHTNING, 9, true, 4, 3, 110},
        {BOLT_LIGHTNING, 12, true, 10, 50, -1},
    };
    bool good = true;
    for (size_t i = 0; i < sizeof HAILS / sizeof *HAILS; i++) {
        struct flash_worst worst = strike_all(&HAILS[i]);
        good = good && worst.general <= FLASH_MOST && worst.red <= FLASH_MOST;
    }
    assert_true(good);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(three_flashes_are_the_most)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
