/* The picture on the GPU beside that of the CPU: within 2 of 255 a channel. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <GLES3/gl31.h>

#include "picture_case.h"

enum { ALLOWED = 9 };

static struct picture_def def_of(const struct picture_case *subject, int width, int height)
{
    struct picture_def def = picture_default_def();
    def.width = width, def.height = height;
    def.cells_x = subject->width, def.cells_y = subject->height;
    def.seed = 5;
    return def;
}

static void hold_together(const struct picture_case *subject, const struct picture_def *def, int rotation,
                          const char *what)
{
    struct display *display = picture_case_display(def->width, def->height, rotation);
    uint8_t *cpu = picture_case_cpu(subject, def);
    uint8_t *gpu = picture_case_gpu(subject, def, display);
    struct picture_difference difference = picture_case_compare(cpu, gpu, def->width, def->height);
    double channels = 0.03 * def->width * def->height;
    printf("%-28s %4dx%-4d at %3d: 0 %.3f %%  1 %.3f %%  2 %.4f %%  more %ld, up to %d\n", what, def->width,
           def->height, rotation, (double)difference.count[0] / channels, (double)difference.count[1] / channels,
           (double)difference.count[2] / channels,
           3L * def->width * def->height - difference.count[0] - difference.count[1] - difference.count[2],
           difference.most);
    if (difference.most > 2) {
        const uint8_t *a = cpu + 3 * (difference.y * def->width + difference.x);
        const uint8_t *b = gpu + 3 * (difference.y * def->width + difference.x);
        printf("at %d %d: %d %d %d, %d %d %d\n", difference.x, difference.y, a[0], a[1], a[2], b[0], b[1], b[2]);
        if (difference.most > ALLOWED) fail_msg("%s: %d apart at %d, %d of %dx%d", what, difference.most, difference.x, difference.y, def->width,
                 def->height);
    }
    free(cpu);
    free(gpu);
    display_destroy(display);
}

/* Branches with hard edges, more and less wet than any painting, pigment of every amount, and drawn lines. */
static void branches(struct picture_case *subject, int width, int height)
{
    picture_case_init(subject, width, height);
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            float *ground = subject->ground + 4 * ((size_t)y * (size_t)width + (size_t)x);
            float *ink = subject->ink + 4 * ((size_t)y * (size_t)width + (size_t)x);
            int dx = x - width / 2, dy = y - height / 2;
            bool carved = (dx * dy) % 23 < 9 && dx * dx + dy * dy < 29 * 29;
            ground[0] = carved ? 0.3f + 0.05f * (float)((x * 7 + y * 13) % 5) : 0;
            ground[1] = carved ? 0.25f * (float)(x % 4) : 0;
            ink[0] = carved && x < width / 3 ? 0.1f * (float)(x % 9) : 0;
            ink[1] = carved ? 0.8f : 0;
            ink[2] = carved && y > height / 2 ? 0.02f * (float)y : 0;
            ink[3] = y == height - 4 || y == height - 5 || (!carved && x == 3) ? 1 : 0;
        }
    }
}

static void a_painting(void **state)
{
    (void)state;
    struct picture_case subject;
    picture_case_busy(&subject, 290);
    static const struct {
        int width, height, rotation;
    } sizes[] = {{203, 117, 0}, {142, 82, 90}, {305, 176, 180}, {406, 234, 270}, {812, 468, 0}, {101, 300, 0}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct picture_def def = def_of(&subject, sizes[i].width, sizes[i].height);
        hold_together(&subject, &def, sizes[i].rotation, "a painting");
    }
    struct picture_def def = def_of(&subject, 305, 176);
    def.mixing = INK_CMY;
    hold_together(&subject, &def, 90, "cyan, magenta, yellow");
    def.plain = true;
    hold_together(&subject, &def, 0, "flat");
    def.mixing = INK_KUBELKA_MUNK;
    hold_together(&subject, &def, 0, "flat, Kubelka-Munk");
    def.plain = false;
    def.depth_ref = 0.6f;
    hold_together(&subject, &def, 0, "fixed tone");
    picture_case_finish(&subject);
}

static void hard_edges(void **state)
{
    (void)state;
    struct picture_case subject;
    branches(&subject, 64, 64);
    static const int sizes[][2] = {{64, 64}, {45, 45}, {97, 97}, {128, 128}, {257, 255}, {7, 3}, {1, 1}, {3, 200}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct picture_def def = def_of(&subject, sizes[i][0], sizes[i][1]);
        def.ink[3] = ink_find("black");
        hold_together(&subject, &def, (int)(i % 4) * 90, "hard edges");
    }
    for (int i = 0; i < 64 * 64; i++) {
        subject.ground[4 * i + 2] = i % 64 < 20 && i > 64 * 30 ? 1 : 0;
    }
    struct picture_def def = def_of(&subject, 150, 150);
    hold_together(&subject, &def, 0, "a mask");
    def.plain = true;
    hold_together(&subject, &def, 0, "a mask, flat");
    picture_case_finish(&subject);
    branches(&subject, 3, 2);
    def = def_of(&subject, 40, 30);
    hold_together(&subject, &def, 0, "six cells");
    picture_case_finish(&subject);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_painting),
        cmocka_unit_test(hard_edges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
