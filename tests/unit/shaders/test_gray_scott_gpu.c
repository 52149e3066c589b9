/* Gray-Scott on the GPU beside the CPU: the same equations in the same order, but a GPU may fuse a product and a sum.
 * Over 60 steps that grows to some 1e-6; allowed: 2e-5. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>

#include <GLES3/gl31.h>

#include "gpu_case.h"
#include "gray_scott_classes.h"
#include "gray_scott_gpu.h"
#include "gray_scott_picture.h"
#include "texture.h"

enum { WIDTH = 150, HEIGHT = 101, CELLS = WIDTH * HEIGHT };
#define WITHIN 2e-5f

struct pair {
    struct gray_scott *cpu;
    struct gray_scott_gpu *gpu;
    float u[CELLS], v[CELLS], other_u[CELLS], other_v[CELLS];
};

static struct pair *pair_create(const struct gray_scott_def *def)
{
    struct pair *pair = calloc(1, sizeof *pair);
    assert_non_null(pair);
    struct shader_error error = {""};
    pair->cpu = gray_scott_create(WIDTH, HEIGHT, def, 1, VECTORS_BEST);
    pair->gpu = gray_scott_gpu_create(WIDTH, HEIGHT, def, NULL, &error);
    if (!pair->cpu || !pair->gpu) {
        fail_msg("no engine: %s", error.text);
    }
    gray_scott_seed_noise(pair->cpu, 0.2f, 5);
    gray_scott_save(pair->cpu, pair->u, pair->v);
    assert_true(gray_scott_gpu_load(pair->gpu, pair->u, pair->v));
    return pair;
}

static void pair_destroy(struct pair *pair)
{
    gray_scott_destroy(pair->cpu);
    gray_scott_gpu_destroy(pair->gpu);
    free(pair);
}

static void assert_near(struct pair *pair)
{
    double sum = 0;
    float apart = 0;
    gray_scott_save(pair->cpu, pair->u, pair->v);
    assert_true(gray_scott_gpu_save(pair->gpu, pair->other_u, pair->other_v));
    for (int i = 0; i < CELLS; i++) {
        apart = fmaxf(apart, fmaxf(fabsf(pair->u[i] - pair->other_u[i]), fabsf(pair->v[i] - pair->other_v[i])));
        sum += (double)pair->v[i];
    }
    assert_true(sum > 50);
    if (!(apart <= WITHIN)) {
        fail_msg("the engines are apart by %g", (double)apart);
    }
}

/* Plain, with noise, turned, displaced; periodic and not; single steps and patches. */
static void same_as_cpu(void **state)
{
    (void)state;
    struct display *display = gpu_display();
    for (int kind = 0; kind < 16; kind++) {
        struct gray_scott_def def = gray_scott_default_def();
        def.noise_kill = kind & 1 ? 0.006f : 0;
        def.noise_feed = kind & 1 ? 0.004f : 0;
        def.noise_speed = kind & 1 ? 20 : 0;
        def.noise_size = 30;
        def.anisotropy_u = kind & 2 ? 0.4f : 0;
        def.orientation = 25;
        def.displacement = kind & 4 ? 0.4f : 0;
        def.boundary = kind & 8 ? BOUNDARY_NO_FLUX : BOUNDARY_PERIODIC;
        for (int patches = 0; patches < (kind & 6 ? 1 : 2); patches++) {
            struct pair *pair = pair_create(&def);
            gray_scott_gpu_set_patches(pair->gpu, patches);
            gray_scott_step(pair->cpu, 43);
            gray_scott_gpu_step(pair->gpu, 21);
            gray_scott_gpu_step(pair->gpu, 22);
            assert_int_equal(gray_scott_gpu_steps(pair->gpu), gray_scott_steps(pair->cpu));
            assert_near(pair);
            pair_destroy(pair);
        }
    }
    display_destroy(display);
}

static void maps_and_brushes(void **state)
{
    (void)state;
    static const float HALVES[] = {0, 1}, FIELD[] = {1, 0, 1, 1};
    static const struct point LINE[] = {{0.2f, 0.3f}, {0.9f, 0.6f}, {0.5f, 1.1f}}, FAR[] = {{-2, -2}};
    struct display *display = gpu_display();
    struct gray_scott_def def = gray_scott_default_def();
    def.style_kill = 0.02f;
    def.style_rate = 0.5f;
    def.anisotropy_v = 0.3f;
    struct pair *pair = pair_create(&def);
    const struct action_raster style = {HALVES, 2, 1, 1}, field = {FIELD, 2, 1, 2};
    assert_true(gray_scott_style(pair->cpu, &style) && gray_scott_gpu_style(pair->gpu, &style));
    assert_true(gray_scott_orient(pair->cpu, &field) && gray_scott_gpu_orient(pair->gpu, &field));
    gray_scott_step(pair->cpu, 20);
    gray_scott_gpu_step(pair->gpu, 20);
    const struct action_path line = {LINE, 3}, far = {FAR, 1}, none = {LINE, 0};
    gray_scott_stroke(pair->cpu, &line, 6, CHEMISTRY_PAINT, 0.8f);
    assert_true(gray_scott_gpu_stroke(pair->gpu, &line, 6, CHEMISTRY_PAINT, 0.8f));
    gray_scott_stroke(pair->cpu, &line, 2, CHEMISTRY_ERASE, 1);
    assert_true(gray_scott_gpu_stroke(pair->gpu, &line, 2, CHEMISTRY_ERASE, 1));
    assert_true(gray_scott_gpu_stroke(pair->gpu, &far, 2, CHEMISTRY_ERASE, 1));
    assert_true(gray_scott_gpu_stroke(pair->gpu, &none, 2, CHEMISTRY_ERASE, 1));
    assert_near(pair);
    def.style_rate = 0;
    def.anisotropy_v = 0;
    assert_true(gray_scott_set(pair->cpu, &def) && gray_scott_gpu_set(pair->gpu, &def));
    gray_scott_step(pair->cpu, 20);
    gray_scott_gpu_step(pair->gpu, 20);
    assert_near(pair);
    pair_destroy(pair);
    display_destroy(display);
}

static void published(void **state)
{
    (void)state;
    struct display *display = gpu_display();
    struct gray_scott_def def = gray_scott_default_def();
    struct pair *pair = pair_create(&def);
    const struct texture_def texture_def = {.format = TEXTURE_RGBA32F, .width = WIDTH, .height = HEIGHT};
    unsigned texture = texture_create(&texture_def), framebuffer;
    static float texels[4 * CELLS];
    gray_scott_gpu_publish(pair->gpu, texture);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, texels);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    for (int i = 0; i < CELLS; i++) {
        assert_true(texels[4 * i] == pair->u[i] && texels[4 * i + 1] == pair->v[i]);
    }
    glDeleteFramebuffers(1, &framebuffer);
    texture_delete(&texture);
    pair_destroy(pair);
    display_destroy(display);
}

enum { PIXELS = 256 };

struct seen {
    uint8_t rgb[3 * PIXELS * PIXELS], rgba[4 * PIXELS * PIXELS];
};

/* The mean difference of the two pictures, and the share of bytes that are farther apart than 4. */
static void compare(struct seen *seen, unsigned texture, double *mean, double *apart)
{
    unsigned framebuffer;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glReadPixels(0, 0, PIXELS, PIXELS, GL_RGBA, GL_UNSIGNED_BYTE, seen->rgba);
    glDeleteFramebuffers(1, &framebuffer);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    *mean = *apart = 0;
    for (int i = 0; i < 3 * PIXELS * PIXELS; i++) {
        int difference = abs(seen->rgb[i] - seen->rgba[i / 3 * 4 + i % 3]);
        *mean += difference / (3.0 * PIXELS * PIXELS);
        *apart += (difference > 4) / (3.0 * PIXELS * PIXELS);
    }
}

static void shaded(void **state)
{
    (void)state;
    static const float GROUND[] = {0.5f, 0.1f, 0, 0, 0.2f, 0.6f};
    struct display *display = gpu_display();
    struct gray_scott_def def = gray_scott_default_def();
    struct shader_error error = {""};
    struct seen *seen = calloc(1, sizeof *seen);
    struct pair *pair = pair_create(&def);
    gray_scott_step(pair->cpu, 1500);
    gray_scott_save(pair->cpu, pair->u, pair->v);
    assert_true(gray_scott_gpu_load(pair->gpu, pair->u, pair->v));
    const struct texture_def texture_def = {.format = TEXTURE_RGBA32F, .width = WIDTH, .height = HEIGHT};
    unsigned texture = texture_create(&texture_def);
    gray_scott_gpu_publish(pair->gpu, texture);
    assert_null(gray_scott_picture_create(PIXELS, 0, NULL, &error));
    struct gray_scott_picture *picture = gray_scott_picture_create(PIXELS, PIXELS, NULL, &error);
    if (!picture) {
        fail_msg("no picture: %s", error.text);
    }
    const struct pattern_plane plane = {pair->v, WIDTH, HEIGHT};
    double mean, apart;
    for (const struct gradient_named *named = gradients; named->name; named++) {
        struct gray_scott_shade_def way = gray_scott_shade_default_def();
        way.gradient = named->gradient;
        way.relief = named == gradients ? 0 : 12;
        way.texture = GROUND;
        way.texture_width = 2;
        way.texture_height = 1;
        assert_true(gray_scott_picture_set(picture, &way));
        gray_scott_picture_shade(picture, texture, WIDTH, HEIGHT);
        gray_scott_shade(&plane, &way, PIXELS, PIXELS, seen->rgb);
        compare(seen, gray_scott_picture_texture(picture), &mean, &apart);
        assert_true(mean < 1 && apart < 0.001);
    }
    struct torus_def torus = torus_default_def();
    torus.turn = 0.3f;
    struct gray_scott_shade_def way = gray_scott_shade_default_def();
    assert_true(gray_scott_picture_set(picture, &way));
    gray_scott_picture_torus(picture, texture, &torus);
    assert_true(gray_scott_torus(&plane, &way, &torus, PIXELS, PIXELS, seen->rgb));
    compare(seen, gray_scott_picture_texture(picture), &mean, &apart);
    if (!(mean < 2)) { /* the CPU's has smooth edges and a finer mesh */
        fail_msg("the tori are apart by %.1f of 255 in the mean", mean);
    }
    gray_scott_picture_destroy(picture);
    gray_scott_picture_destroy(NULL);
    texture_delete(&texture);
    pair_destroy(pair);
    free(seen);
    display_destroy(display);
}

static void refused(void **state)
{
    (void)state;
    struct display *display = gpu_display();
    struct gray_scott_def def = gray_scott_default_def();
    struct shader_error error = {""};
    assert_null(gray_scott_gpu_create(0, 10, &def, NULL, &error));
    assert_true(error.text[0] != 0);
    gray_scott_gpu_destroy(NULL);
    display_destroy(display);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_as_cpu), cmocka_unit_test(maps_and_brushes), cmocka_unit_test(published),
        cmocka_unit_test(shaded),      cmocka_unit_test(refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
