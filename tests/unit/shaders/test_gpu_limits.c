/* A GPU that keeps less than GLES 3.1 promises is told by name; textures are never filtered as it does not promise. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <GLES3/gl31.h>

#include "display.h"
#include "gpu_limits.h"
#include "texture.h"

struct device {
    const struct gpu_limit *broken; /* one too few, or NULL */
    bool unknown;                   /* and not even known */
};

static bool read_promised(void *context, const struct gpu_limit *limit, long long *value)
{
    const struct device *device = context;
    *value = limit->promised;
    if (limit == device->broken) {
        *value += limit->alignment ? 1 : -1;
        return !device->unknown;
    }
    return true;
}

static void each_limit_is_missed_by_name(void **state)
{
    (void)state;
    struct shader_error error = {""};
    struct device device = {NULL, false};
    assert_true(gpu_limits_check_with(read_promised, &device, &error));
    for (const struct gpu_limit *limit = gpu_limits; limit->name; limit++) {
        char said[200];
        const char *axes[] = {"", "[0]", "[1]", "[2]"};
        device = (struct device){limit, false};
        assert_false(gpu_limits_check_with(read_promised, &device, &error));
        snprintf(said, sizeof said, "this GPU offers less than GLES 3.1 promises: %s%s is %lld, promised %lld",
                 limit->name, axes[limit->index + 1], limit->promised + (limit->alignment ? 1 : -1), limit->promised);
        assert_string_equal(error.text, said);
        device.unknown = true;
        assert_false(gpu_limits_check_with(read_promised, &device, &error));
        assert_non_null(strstr(error.text, " is unknown, promised "));
    }
}

static bool read_nothing(void *context, const struct gpu_limit *limit, long long *value)
{
    (void)context;
    *value = limit->alignment ? 1 << 30 : 0;
    return true;
}

static void a_device_without_anything_is_told_within_bounds(void **state)
{
    (void)state;
    struct shader_error error;
    assert_false(gpu_limits_check_with(read_nothing, NULL, &error));
    assert_non_null(strstr(error.text, "MAX_COMPUTE_WORK_GROUP_SIZE[1] is 0, promised 128; "));
    assert_true(strlen(error.text) < sizeof error.text);
}

static void this_gpu_keeps_its_promises(void **state)
{
    (void)state;
    struct shader_error error = {""};
    bool kept = gpu_limits_check(&error);
    assert_string_equal(error.text, "");
    assert_true(kept);
}

static GLint filter_of(GLuint texture, GLenum target, GLenum name)
{
    GLint filter = 0;
    glBindTexture(target, texture);
    glGetTexParameteriv(target, name, &filter);
    return filter;
}

static void no_32_bit_texture_is_linear(void **state)
{
    (void)state;
    for (int format = 0; format < TEXTURE_FORMATS; format++) {
        for (int layers = 0; layers < 3; layers++) {
            GLenum target = layers ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
            struct texture_def def = {(enum texture_format)format, TEXTURE_LINEAR, 8, 4, layers, false};
            GLint size = 0, type = 0;
            GLuint linear = texture_create(&def);
            def.filter = TEXTURE_NEAREST;
            GLuint nearest = texture_create(&def);
            assert_int_not_equal(nearest, 0);
            assert_int_equal(filter_of(nearest, target, GL_TEXTURE_MIN_FILTER), GL_NEAREST);
            assert_int_equal(filter_of(nearest, target, GL_TEXTURE_MAG_FILTER), GL_NEAREST);
            glGetTexLevelParameteriv(target, 0, GL_TEXTURE_RED_SIZE, &size);
            glGetTexLevelParameteriv(target, 0, GL_TEXTURE_RED_TYPE, &type);
            bool filterable = size < 32 && type != GL_UNSIGNED_INT; /* integers never are */
            assert_int_equal(texture_filterable((enum texture_format)format), filterable);
            assert_int_equal(linear != 0, filterable);
            if (linear) {
                assert_int_equal(filter_of(linear, target, GL_TEXTURE_MIN_FILTER), GL_LINEAR);
                assert_int_equal(filter_of(linear, target, GL_TEXTURE_MAG_FILTER), GL_LINEAR);
            }
            texture_delete(&linear);
            texture_delete(&nearest);
            assert_int_equal(nearest, 0);
        }
    }
}

static void a_texture_begins_as_zeros_and_takes_texels(void **state)
{
    (void)state;
    enum { WIDTH = 700, HEIGHT = 190 }; /* more than is cleared at once */
    const struct texture_def def = {TEXTURE_RGBA8, TEXTURE_LINEAR, WIDTH, HEIGHT, 0, false};
    static const uint8_t texels[2][1][4] = {{{1, 2, 3, 4}}, {{5, 6, 7, 8}}};
    uint8_t *read = calloc(WIDTH * HEIGHT, 4);
    GLuint framebuffer = 0, texture = texture_create(&def);
    assert_non_null(read);
    assert_int_not_equal(texture, 0);
    texture_upload(texture, &def, 0, 699, 100, 1, 2, texels);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, read);
    for (int i = 0; i < WIDTH * HEIGHT * 4; i++) {
        int row = i / (WIDTH * 4), column = i % (WIDTH * 4);
        bool set = column >= 699 * 4 && (row == 100 || row == 101);
        assert_int_equal(read[i], set ? texels[row - 100][0][column % 4] : 0);
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
    glDeleteFramebuffers(1, &framebuffer);
    texture_delete(&texture);
    free(read);
}

static void a_size_beyond_the_gpu_is_refused(void **state)
{
    (void)state;
    static const struct texture_def defs[] = {
        {TEXTURE_RGBA8, TEXTURE_NEAREST, 0, 4, 0, false},       {TEXTURE_RGBA8, TEXTURE_NEAREST, 4, -1, 0, false},
        {TEXTURE_RGBA8, TEXTURE_NEAREST, 1 << 20, 4, 0, false}, {TEXTURE_RGBA8, TEXTURE_NEAREST, 4, 4, 1 << 20, false},
        {TEXTURE_RGBA8, TEXTURE_NEAREST, 4, 4, -1, false},
    };
    for (size_t i = 0; i < sizeof defs / sizeof defs[0]; i++) {
        assert_int_equal(texture_create(&defs[i]), 0);
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static int open_display(void **state)
{
    struct display_def def = display_default_def();
    struct device_error error = {""};
    def.kind = DISPLAY_HEADLESS;
    struct display *display = display_create(&def, &error);
    if (!display) {
        print_error("%s\n", error.text);
        return 1;
    }
    *state = display;
    return display_begin(display) ? 0 : 1;
}

static int close_display(void **state)
{
    display_destroy(*state);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_limit_is_missed_by_name),
        cmocka_unit_test(a_device_without_anything_is_told_within_bounds),
        cmocka_unit_test(this_gpu_keeps_its_promises),
        cmocka_unit_test(no_32_bit_texture_is_linear),
        cmocka_unit_test(a_texture_begins_as_zeros_and_takes_texels),
        cmocka_unit_test(a_size_beyond_the_gpu_is_refused),
    };
    return cmocka_run_group_tests(tests, open_display, close_display);
}
