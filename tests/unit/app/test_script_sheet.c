/* What a script says of its sheet (app/script_sheet.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "near.h"
#include "script_sheet.h"

static void a_canvas_takes_the_shape_of_its_screen(void **state)
{
    static const int SCREENS[][2] = {{1920, 1080}, {1080, 1920}, {800, 480}, {1024, 1024}, {5120, 1440}};
    (void)state;
    for (size_t i = 0; i < sizeof SCREENS / sizeof SCREENS[0]; i++) {
        struct script script = {.width = 960, .height = 600};
        script_fit(&script, SCREENS[i][0], SCREENS[i][1]);
        assert_near((double)script.width / script.height, (double)SCREENS[i][0] / SCREENS[i][1], 0.01);
        assert_near((double)script.width * script.height, 960 * 600, 0.01 * 960 * 600);
    }
}

static void a_canvas_stays_one_that_can_be_painted(void **state)
{
    (void)state;
    struct script narrow = {.width = 32, .height = 32}, large = {.width = 4000, .height = 4000};
    script_fit(&narrow, 8000, 10);
    assert_int_equal(narrow.height, CANVAS_SIZE_MIN);
    script_fit(&large, 8000, 1000);
    assert_int_equal(large.width, CANVAS_SIZE_MAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_canvas_takes_the_shape_of_its_screen),
        cmocka_unit_test(a_canvas_stays_one_that_can_be_painted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
