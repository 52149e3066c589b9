/* Displays without a screen: frames to memory. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <GLES3/gl31.h>

#include "display.h"
#include "display_canvas.h"
#include "display_egl.h"
#include "display_source.h"
#include "patience.h"
#include "pattern.h"

enum { WIDTH = 64, HEIGHT = 40 };

static struct display *open_display(int rotation, int refresh_mhz)
{
    struct display_def def = display_default_def();
    struct device_error error = {""};
    def.kind = DISPLAY_HEADLESS;
    def.width = WIDTH;
    def.height = HEIGHT;
    def.rotation = rotation;
    def.refresh_mhz = refresh_mhz;
    struct display *display = display_create(&def, &error);
    if (!display) {
        fail_msg("%s", error.text);
    }
    return display;
}

static void draw(struct display *display, const struct pattern *pattern)
{
    for (int i = 0; i < 1000 && !display_begin(display); i++) {
        display_wait(display, 100);
    }
    pattern_draw(pattern, display);
    display_end(display);
}

static void assert_captured(struct display *display)
{
    struct display_size sheet = display_sheet(display);
    uint8_t rgb[WIDTH * HEIGHT * 3];
    memset(rgb, 77, sizeof rgb);
    assert_true(display_capture(display, rgb));
    assert_int_equal(pattern_wrong(sheet, rgb), 0);
}

static void frames_are_captured_as_they_are_looked_at(void **state)
{
    (void)state;
    for (int rotation = 0; rotation < 360; rotation += 90) {
        struct display *display = open_display(rotation, 0);
        struct pattern pattern;
        uint8_t none[WIDTH * HEIGHT * 3];
        assert_true(pattern_make(&pattern));
        assert_false(display_capture(display, none));
        draw(display, &pattern);
        assert_int_equal(display_sheet(display).width, rotation % 180 ? HEIGHT : WIDTH);
        assert_int_equal(display_panel(display).width, WIDTH);
        assert_captured(display);
        pattern_drop(&pattern);
        display_destroy(display);
    }
}

static void frames_come_at_the_pace_asked_for(void **state)
{
    (void)state;
    struct display *display = open_display(0, 100000);
    struct pattern pattern;
    assert_true(pattern_make(&pattern));
    draw(display, &pattern); /* compiles */
    uint64_t start = display_frames(display).last_us, presented = display_frames(display).presented;
    for (int i = 0; i < 20; i++) {
        draw(display, &pattern);
    }
    struct display_frames frames = display_frames(display);
    assert_true(frames.last_us - start >= 190000);
    assert_int_equal(frames.presented - presented, 20);
    uint64_t missed = frames.missed;
    while (source_now_us() < frames.last_us + 100000) { /* nobody draws */
        display_wait(display, 10);
    }
    draw(display, &pattern);
    assert_in_range(display_frames(display).missed - missed, 7, 1000);
    assert_int_equal(display_frames(display).refresh_mhz, 100000);
    display_destroy(display);
}

static void no_frames_in_the_dark(void **state)
{
    (void)state;
    struct display *display = open_display(0, 0);
    struct pattern pattern;
    assert_true(pattern_make(&pattern));
    draw(display, &pattern);
    display_power(display, false);
    assert_int_equal(display_state(display), DISPLAY_DARK);
    assert_false(display_begin(display));
    uint64_t start = source_now_us();
    display_wait(display, 30);
    assert_true(source_now_us() - start >= 29000);
    assert_captured(display);
    display_power(display, true);
    assert_int_equal(display_state(display), DISPLAY_SHOWN);
    draw(display, &pattern);
    assert_int_equal(display_frames(display).presented, 2);
    display_destroy(display);
}

static void a_lost_context_is_made_anew(void **state)
{
    (void)state;
    struct display *display = open_display(90, 0);
    struct device_error error = {""};
    struct pattern pattern;
    uint8_t rgb[WIDTH * HEIGHT * 3];
    for (int i = 0; i < 3; i++) {
        assert_true(pattern_make(&pattern));
        draw(display, &pattern);
        assert_false(display_lost(display));
        display_inject_reset(display);
        assert_true(display_lost(display));
        assert_false(display_begin(display));
        assert_false(display_capture(display, rgb));
        assert_true(display_renew(display, &error));
        assert_false(display_lost(display));
        assert_false(display_capture(display, rgb)); /* the frame went with the context */
        assert_false(glIsProgram(pattern.program));
    }
    assert_true(pattern_make(&pattern));
    draw(display, &pattern);
    assert_captured(display);
    display_destroy(display);
}

struct visitor {
    struct display_context *context;
    GLuint buffer;
    uint32_t read;
    bool entered;
};

static void *visit(void *argument)
{
    struct visitor *visitor = argument;
    visitor->entered = display_context_enter(visitor->context);
    glBindBuffer(GL_COPY_READ_BUFFER, visitor->buffer);
    const uint32_t *mapped = glMapBufferRange(GL_COPY_READ_BUFFER, 0, sizeof *mapped, GL_MAP_READ_BIT);
    visitor->read = mapped ? *mapped : 0;
    glUnmapBuffer(GL_COPY_READ_BUFFER);
    display_context_leave(visitor->context);
    return NULL;
}

static void another_thread_shares_buffers(void **state)
{
    (void)state;
    struct display *display = open_display(0, 0);
    struct visitor visitor = {.context = display_share(display)};
    const uint32_t secret = 0x5ca1ab1e;
    assert_non_null(visitor.context);
    glGenBuffers(1, &visitor.buffer);
    glBindBuffer(GL_COPY_WRITE_BUFFER, visitor.buffer);
    glBufferData(GL_COPY_WRITE_BUFFER, sizeof secret, &secret, GL_STATIC_DRAW);
    glFinish();
    pthread_t thread;
    assert_int_equal(pthread_create(&thread, NULL, visit, &visitor), 0);
    pthread_join(thread, NULL);
    assert_true(visitor.entered);
    assert_int_equal(visitor.read, secret);
    display_context_destroy(visitor.context);
    display_destroy(display);
}

static void events_wait_until_they_are_asked_for(void **state)
{
    (void)state;
    struct display *display = open_display(0, 0);
    struct event event;
    assert_false(display_event(display, &event));
    display_post(display, (struct event){.kind = EVENT_DOWN, .slot = 3});
    display_post(display, (struct event){.kind = EVENT_UP, .slot = 3});
    uint64_t start = source_now_us();
    display_wait(display, PATIENCE_MS); /* something has happened: no waiting */
    assert_true(source_now_us() - start < 500u * PATIENCE_MS);
    assert_true(display_event(display, &event));
    assert_true(event.kind == EVENT_DOWN && event.slot == 3 && event.source == SOURCE_WINDOW);
    assert_true(display_event(display, &event));
    assert_int_equal(event.kind, EVENT_UP);
    assert_false(display_event(display, &event));
    display_destroy(display);
}

static void other_devices_end_the_waiting(void **state)
{
    (void)state;
    struct display *display = open_display(0, 0);
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    display_power(display, false);
    display_wake_on(display, ends, 1);
    uint64_t start = source_now_us();
    display_wait(display, 30);
    assert_true(source_now_us() - start >= 29000);
    assert_int_equal(write(ends[1], "x", 1), 1);
    start = source_now_us();
    display_wait(display, PATIENCE_MS);
    assert_true(source_now_us() - start < 500u * PATIENCE_MS);
    close(ends[0]);
    close(ends[1]);
    display_destroy(display);
}

static void what_cannot_be_had_leaves_a_reason_and_nothing_else(void **state)
{
    (void)state;
    struct display_def def = display_default_def();
    struct device_error error;
    struct display_canvas canvas;
    def.kind = DISPLAY_HEADLESS;
    struct display *display = display_create(&def, &error);
    assert_true(display && display_enter(display));
    EGLint value;
    assert_string_equal(display_egl_reason(), "no reason given");
    assert_false(eglQueryContext(eglGetCurrentDisplay(), eglGetCurrentContext(), EGL_NONE, &value));
    assert_string_equal(display_egl_reason(), "0x3004 (EGL_BAD_ATTRIBUTE)");
    assert_false(display_canvas_make(&canvas, 0, 0));
    assert_int_equal(canvas.framebuffer + canvas.colour, 0);
    assert_true(display_canvas_make(&canvas, 1, 1));
    assert_true(canvas.framebuffer && canvas.colour);
    display_canvas_drop(&canvas);
    display_destroy(display);
}

static void definitions_are_checked(void **state)
{
    (void)state;
    struct display_def def = display_default_def();
    struct device_error error = {""};
    def.kind = DISPLAY_HEADLESS;
    def.rotation = 45;
    assert_null(display_create(&def, &error));
    assert_string_equal(error.text, "a display turned by 45 degrees: 0, 90, 180 or 270 are allowed");
    def.rotation = 0;
    def.width = 9000;
    assert_null(display_create(&def, &error));
    assert_string_equal(error.text, "a display of 9000x0: 0..8192 pixels a side are allowed");
    def.width = 0;
    def.refresh_mhz = -1;
    assert_null(display_create(&def, &error));
    def.refresh_mhz = 0;
    def.kind = DISPLAY_KMS;
    def.card = "/dev/dri/card77";
    assert_null(display_create(&def, &error));
    assert_string_equal(error.text, "kms: /dev/dri/card77: No such file or directory");
    def.card = "/dev/dri/by-path/platform-fd500000.pcie-pci-0000:01:00.0-usb-0:1.2:1.0-card";
    assert_null(display_create(&def, &error));
    assert_non_null(strstr(error.text, "-usb-0:1.2:1.0-card: No such file or directory"));
}

static void without_a_screen_it_says_why(void **state)
{
    (void)state;
    struct display_def def = display_default_def();
    struct device_error error = {""};
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    def.card = "/dev/dri/card77";
    struct display *display = display_create(&def, &error);
    assert_non_null(display);
    assert_int_equal(display_kind(display), DISPLAY_HEADLESS);
    assert_string_equal(display_describe(display),
                        "headless, 1280x720; kms: /dev/dri/card77: No such file or directory");
    display_destroy(display);
}

static void a_display_says_what_it_is(void **state)
{
    (void)state;
    struct display *display = open_display(270, 0);
    assert_int_equal(display_kind(display), DISPLAY_HEADLESS);
    assert_string_equal(display_describe(display), "headless, 64x40, turned by 270 degrees; asked for");
    assert_false(display_closed(display));
    display_destroy(display);
    display_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_are_captured_as_they_are_looked_at),
        cmocka_unit_test(frames_come_at_the_pace_asked_for),
        cmocka_unit_test(no_frames_in_the_dark),
        cmocka_unit_test(a_lost_context_is_made_anew),
        cmocka_unit_test(another_thread_shares_buffers),
        cmocka_unit_test(events_wait_until_they_are_asked_for),
        cmocka_unit_test(other_devices_end_the_waiting),
        cmocka_unit_test(what_cannot_be_had_leaves_a_reason_and_nothing_else),
        cmocka_unit_test(definitions_are_checked),
        cmocka_unit_test(without_a_screen_it_says_why),
        cmocka_unit_test(a_display_says_what_it_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
