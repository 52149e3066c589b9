/* A window, on an X server that nobody sees: `test_window` needs DISPLAY, xdotool and no window manager. */
#define SDL_MAIN_HANDLED
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <SDL.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <cmocka.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <GLES3/gl31.h>

#include "display.h"
#include "display_source.h"
#include "display_window_input.h"
#include "patience.h"
#include "pattern.h"

enum { WIDTH = 320, HEIGHT = 200, WIDER = 400, HIGHER = 260 };

struct scene {
    struct display *display;
    struct pattern pattern;
};

static void open_scene(struct scene *scene, enum display_kind kind, int rotation)
{
    struct display_def def = display_default_def();
    struct device_error error = {""};
    def.kind = kind;
    def.width = WIDTH;
    def.height = HEIGHT;
    def.rotation = rotation;
    scene->display = display_create(&def, &error);
    if (!scene->display) {
        fail_msg("%s", error.text);
    }
    assert_true(pattern_make(&scene->pattern));
}

static void turn_loop(struct scene *scene)
{
    display_wait(scene->display, 10);
    if (display_begin(scene->display)) {
        pattern_draw(&scene->pattern, scene->display);
        display_end(scene->display);
    }
}

static void draw_frames(struct scene *scene, int count)
{
    uint64_t until = display_frames(scene->display).presented + (uint64_t)count,
             end = source_now_us() + 1000u * (uint64_t)PATIENCE_MS;
    while (display_frames(scene->display).presented < until) {
        assert_true(source_now_us() < end);
        turn_loop(scene);
    }
}

static bool await_state(struct scene *scene, enum display_state state)
{
    uint64_t end = source_now_us() + 1000u * (uint64_t)PATIENCE_MS;
    while (display_state(scene->display) != state && source_now_us() < end) {
        turn_loop(scene);
    }
    return display_state(scene->display) == state;
}

static void assert_captured(const struct scene *scene)
{
    struct display_size sheet = display_sheet(scene->display);
    uint8_t *rgb = malloc((size_t)sheet.width * (size_t)sheet.height * 3);
    assert_non_null(rgb);
    assert_true(display_capture(scene->display, rgb));
    assert_int_equal(pattern_wrong(sheet, rgb), 0);
    free(rgb);
}

/* Does it as a hand would, through the X server. */
static void use(const char *command)
{
    char line[200];
    snprintf(line, sizeof line, "xdotool search --name '^Frond$' %s", command);
    if (system(line) != 0) {
        fail_msg("%s", line);
    }
}

static bool await_event(struct scene *scene, enum event_kind kind, struct event *event)
{
    for (uint64_t end = source_now_us() + 1000u * (uint64_t)PATIENCE_MS; source_now_us() < end;) {
        while (display_event(scene->display, event)) {
            if (event->kind == kind) {
                return true;
            }
        }
        turn_loop(scene);
    }
    return false;
}

static void assert_finger(struct scene *scene, enum event_kind kind, float x, float y)
{
    struct event event;
    assert_true(await_event(scene, kind, &event));
    assert_int_equal(event.slot, 0);
    assert_true(event.x > x - .01f && event.x < x + .01f);
    assert_true(event.y > y - .01f && event.y < y + .01f);
    assert_true(event.time_us > 0 && event.time_us <= source_now_us());
}

static void a_window_shows_what_is_drawn(void **state)
{
    (void)state;
    struct scene scene;
    open_scene(&scene, DISPLAY_AUTO, 0);
    assert_int_equal(display_kind(scene.display), DISPLAY_WINDOW);
    assert_non_null(strstr(display_describe(scene.display), "a desktop is running"));
    assert_int_equal(display_state(scene.display), DISPLAY_SHOWN);
    draw_frames(&scene, 5);
    assert_captured(&scene);
    struct sigaction action;
    assert_int_equal(sigaction(SIGINT, NULL, &action), 0);
    assert_true(action.sa_handler == SIG_DFL);
    assert_false(SDL_GetWindowGrab(SDL_GetWindowFromID(1)));
    display_destroy(scene.display);
}

/* What the X server has on its screen, at a point of the window. */
static void assert_on_screen(int x, int y, unsigned long colour)
{
    Display *server = XOpenDisplay(NULL);
    int left = 0, top = 0;
    assert_non_null(server);
    SDL_GetWindowPosition(SDL_GetWindowFromID(1), &left, &top);
    XImage *image = XGetImage(server, DefaultRootWindow(server), left + x, top + y, 1, 1, AllPlanes, ZPixmap);
    assert_non_null(image);
    unsigned long seen = XGetPixel(image, 0, 0) & 0xffffff;
    XDestroyImage(image);
    XCloseDisplay(server);
    assert_int_equal(seen, colour);
}

static void the_server_shows_it_too(void **state)
{
    (void)state;
    struct scene scene;
    open_scene(&scene, DISPLAY_WINDOW, 90);
    draw_frames(&scene, 5);
    use("windowmove --sync %@ 40 30");
    draw_frames(&scene, 5);
    assert_on_screen(WIDTH - 10, 10, 0xffffff); /* the mark, turned to the right */
    assert_on_screen(WIDTH / 2 + 10, HEIGHT / 2 - 10, 0xff0000);
    assert_on_screen(WIDTH - 10, HEIGHT - 10, 0x00ff00);
    assert_on_screen(10, 10, 0x0000ff);
    assert_captured(&scene);
    display_destroy(scene.display);
}

static void it_follows_its_size(void **state)
{
    (void)state;
    struct scene scene;
    char command[100];
    open_scene(&scene, DISPLAY_WINDOW, 90);
    draw_frames(&scene, 2);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    assert_captured(&scene);
    snprintf(command, sizeof command, "windowsize --sync %d %d", WIDER, HIGHER);
    use(command);
    for (uint64_t end = source_now_us() + 1000u * (uint64_t)PATIENCE_MS;
         display_panel(scene.display).width != WIDER && source_now_us() < end;) {
        turn_loop(&scene);
    }
    assert_int_equal(display_panel(scene.display).width, WIDER);
    assert_int_equal(display_panel(scene.display).height, HIGHER);
    assert_int_equal(display_sheet(scene.display).width, HIGHER);
    draw_frames(&scene, 2);
    assert_captured(&scene);
    display_destroy(scene.display);
}

static void the_mouse_is_a_finger(void **state)
{
    (void)state;
    struct scene scene;
    open_scene(&scene, DISPLAY_WINDOW, 90);
    draw_frames(&scene, 2);
    use("mousemove --window %1 20 20 mousemove --window %1 80 50 mousedown 1"); /* a quarter, a quarter */
    assert_finger(&scene, EVENT_DOWN, .25f, .75f);
    use("mousemove --window %1 160 150");
    assert_finger(&scene, EVENT_MOVE, .75f, .5f);
    use("mouseup 1");
    assert_finger(&scene, EVENT_UP, .75f, .5f);
    struct event event;
    use("mousemove --window %1 30 30 mousedown 3 mouseup 3 mousemove --window %1 40 40");
    for (int i = 0; i < 20; i++) {
        turn_loop(&scene);
    }
    assert_false(display_event(scene.display, &event)); /* hovering, and other buttons */
    display_destroy(scene.display);
}

static void a_mouse_that_leaves_stops_at_the_edge(void **state)
{
    (void)state;
    struct window_input input = {.pressed = false};
    struct event finger;
    SDL_Event event = {.button = {.type = SDL_MOUSEBUTTONDOWN, .button = SDL_BUTTON_LEFT, .x = 9, .y = 19}};
    assert_true(window_input_take(&input, &event, 100, 100, &finger));
    assert_true(finger.x == .095f && finger.y == .195f);
    event = (SDL_Event){.motion = {.type = SDL_MOUSEMOTION, .x = -40, .y = 130}};
    assert_true(window_input_take(&input, &event, 100, 100, &finger));
    assert_true(finger.x == 0 && finger.y == 1);
}

static void push_window(Uint8 what)
{
    SDL_Event event = {.window = {.type = SDL_WINDOWEVENT, .windowID = 1, .event = what}};
    assert_int_equal(SDL_PushEvent(&event), 1);
}

static void other_devices_end_the_waiting(void **state)
{
    (void)state;
    struct scene scene;
    int ends[2];
    open_scene(&scene, DISPLAY_WINDOW, 0);
    draw_frames(&scene, 2);
    SDL_HideWindow(SDL_GetWindowFromID(1));
    assert_true(await_state(&scene, DISPLAY_LENT));
    assert_int_equal(pipe(ends), 0);
    display_wake_on(scene.display, ends, 1);
    uint64_t start = source_now_us();
    while (source_now_us() < start + 50000) {
        display_wait(scene.display, 10);
    }
    assert_int_equal(write(ends[1], "x", 1), 1);
    start = source_now_us();
    display_wait(scene.display, PATIENCE_MS);
    assert_true(source_now_us() - start < 500u * PATIENCE_MS);
    close(ends[0]);
    close(ends[1]);
    display_destroy(scene.display);
}

static void push(Uint32 type, SDL_FingerID finger, float x, float y)
{
    SDL_Event event = {.tfinger = {.type = type, .touchId = 1, .fingerId = finger, .x = x, .y = y}};
    assert_int_equal(SDL_PushEvent(&event), 1);
}

static void fingers_have_slots(void **state)
{
    (void)state;
    struct scene scene;
    struct event event;
    open_scene(&scene, DISPLAY_WINDOW, 0);
    push(SDL_FINGERMOTION, 99, .5f, .5f); /* never came down */
    push(SDL_FINGERDOWN, 42, .1f, .2f);
    push(SDL_FINGERDOWN, 17, .3f, .4f);
    push(SDL_FINGERUP, 42, .1f, .2f);
    push(SDL_FINGERMOTION, 17, .5f, .6f);
    push(SDL_FINGERDOWN, 43, .7f, .8f);
    const struct event expected[] = {{.kind = EVENT_DOWN, .slot = 1, .x = .1f, .y = .2f},
                                     {.kind = EVENT_DOWN, .slot = 2, .x = .3f, .y = .4f},
                                     {.kind = EVENT_UP, .slot = 1, .x = .1f, .y = .2f},
                                     {.kind = EVENT_MOVE, .slot = 2, .x = .5f, .y = .6f},
                                     {.kind = EVENT_DOWN, .slot = 1, .x = .7f, .y = .8f}};
    display_wait(scene.display, 0);
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        assert_true(display_event(scene.display, &event));
        assert_int_equal(event.kind, expected[i].kind);
        assert_int_equal(event.slot, expected[i].slot);
        assert_true(event.x == expected[i].x && event.y == expected[i].y);
    }
    assert_false(display_event(scene.display, &event));
    display_destroy(scene.display);
}

static void push_key(SDL_Keycode key, Uint16 modifiers)
{
    SDL_Event event = {.key = {.type = SDL_KEYDOWN, .keysym = {.sym = key, .mod = modifiers}}};
    assert_int_equal(SDL_PushEvent(&event), 1);
}

static bool is_fullscreen(void)
{
    return SDL_GetWindowFlags(SDL_GetWindowFromID(1)) & SDL_WINDOW_FULLSCREEN_DESKTOP;
}

static void it_hides_fills_the_screen_and_closes(void **state)
{
    (void)state;
    struct scene scene;
    open_scene(&scene, DISPLAY_WINDOW, 0);
    draw_frames(&scene, 2);
    SDL_HideWindow(SDL_GetWindowFromID(1));
    assert_true(await_state(&scene, DISPLAY_LENT));
    assert_false(display_begin(scene.display));
    uint64_t missed = display_frames(scene.display).missed;
    SDL_Delay(200);
    SDL_ShowWindow(SDL_GetWindowFromID(1));
    assert_true(await_state(&scene, DISPLAY_SHOWN));
    turn_loop(&scene);
    assert_true(display_frames(scene.display).missed - missed < 10); /* nobody could have seen them */
    glScissor(0, 0, 1, 1);
    glEnable(GL_SCISSOR_TEST); /* a caller's own affair */
    draw_frames(&scene, 2);
    assert_true(glIsEnabled(GL_SCISSOR_TEST));
    glDisable(GL_SCISSOR_TEST);
    draw_frames(&scene, 2);
    push_key(SDLK_RETURN, 0);
    display_wait(scene.display, 0);
    assert_false(is_fullscreen());
    push_key(SDLK_RETURN, KMOD_LALT);
    display_wait(scene.display, 0);
    assert_true(is_fullscreen());
    push_key(SDLK_F11, 0);
    display_wait(scene.display, 0);
    assert_false(is_fullscreen());
    assert_false(display_closed(scene.display));
    push_window(SDL_WINDOWEVENT_CLOSE);
    display_wait(scene.display, 0);
    assert_true(display_closed(scene.display));
    display_destroy(scene.display);
}

static void a_lost_context_is_made_anew(void **state)
{
    (void)state;
    struct scene scene;
    struct device_error error = {""};
    open_scene(&scene, DISPLAY_WINDOW, 180);
    for (int i = 0; i < 3; i++) {
        draw_frames(&scene, 2);
        display_inject_reset(scene.display);
        assert_false(display_begin(scene.display));
        assert_true(display_renew(scene.display, &error));
        assert_true(pattern_make(&scene.pattern));
    }
    draw_frames(&scene, 2);
    assert_captured(&scene);
    display_destroy(scene.display);
}

static int visit(void *argument)
{
    struct display_context *context = argument;
    bool entered = display_context_enter(context);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 8, 8);
    glFinish();
    bool worked = entered && glGetError() == GL_NO_ERROR;
    display_context_leave(context);
    return worked ? (int)texture : 0;
}

static void another_thread_shares_textures(void **state)
{
    (void)state;
    struct scene scene;
    open_scene(&scene, DISPLAY_WINDOW, 0);
    draw_frames(&scene, 2);
    struct display_context *context = display_share(scene.display);
    assert_non_null(context);
    int texture = 0;
    SDL_Thread *thread = SDL_CreateThread(visit, "visit", context);
    draw_frames(&scene, 5); /* at the same time */
    SDL_WaitThread(thread, &texture);
    assert_true(texture > 0 && glIsTexture((GLuint)texture));
    display_context_destroy(context);
    draw_frames(&scene, 2);
    display_destroy(scene.display);
}

/* A server of its own; its name goes to `name`, ":1". */
static pid_t start_server(char name[16])
{
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    pid_t server = fork();
    if (server == 0) {
        char descriptor[16];
        snprintf(descriptor, sizeof descriptor, "%d", ends[1]);
        assert_non_null(freopen("/dev/null", "w", stderr)); /* of displays that others have */
        execlp("Xvfb", "Xvfb", "-displayfd", descriptor, "-screen", "0", "640x480x24", (char *)NULL);
        _exit(127);
    }
    close(ends[1]);
    FILE *said = fdopen(ends[0], "r");
    assert_true(server > 0 && said && fgets(name + 1, 15, said));
    name[0] = ':';
    name[strcspn(name, "\n")] = '\0';
    fclose(said);
    return server;
}

enum { IN_ORDER = 42 };

/* In a process of its own: Xlib would end it. */
static void outlive(pid_t server, const char *name)
{
    struct scene scene;
    uint64_t end = source_now_us() + 10000000;
    setenv("DISPLAY", name, 1);
    alarm(30); /* it hangs */
    open_scene(&scene, DISPLAY_WINDOW, 0);
    draw_frames(&scene, 2);
    kill(server, SIGKILL);
    while (!display_closed(scene.display) && source_now_us() < end) {
        turn_loop(&scene);
    }
    bool told = strstr(display_describe(scene.display), "the desktop has gone");
    bool closed = display_closed(scene.display) && !display_begin(scene.display);
    display_destroy(scene.display);
    _exit(closed && told ? IN_ORDER : 1);
}

static void it_outlives_its_desktop(void **state) /* the first: nothing of SDL is in this process yet */
{
    (void)state;
    char name[16];
    int status = 0;
    pid_t server = start_server(name), child = fork();
    if (child == 0) {
        outlive(server, name);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    kill(server, SIGKILL);
    waitpid(server, NULL, 0);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == IN_ORDER);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_outlives_its_desktop),
        cmocka_unit_test(a_window_shows_what_is_drawn),
        cmocka_unit_test(the_server_shows_it_too),
        cmocka_unit_test(it_follows_its_size),
        cmocka_unit_test(the_mouse_is_a_finger),
        cmocka_unit_test(a_mouse_that_leaves_stops_at_the_edge),
        cmocka_unit_test(fingers_have_slots),
        cmocka_unit_test(other_devices_end_the_waiting),
        cmocka_unit_test(it_hides_fills_the_screen_and_closes),
        cmocka_unit_test(a_lost_context_is_made_anew),
        cmocka_unit_test(another_thread_shares_textures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
