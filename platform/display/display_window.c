/* A window on a desktop, through SDL: for a curator's laptop. The mouse is a finger. */
#define SDL_MAIN_HANDLED
#include <SDL.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <GLES3/gl31.h>

#include "desktop_link.h"
#include "display_canvas.h"
#include "display_pace.h"
#include "display_source.h"
#include "display_window_input.h"

enum {
    WINDOW_WIDTH = 1280, /* points of the desktop, where the definition leaves it open */
    WINDOW_HEIGHT = 720,
    SLICE_MS = 4,        /* between looks at what else may wake us, where SDL waits for itself alone */
    REFRESH_MHZ = 60000, /* where the desktop does not say */
};

struct window {
    SDL_Window *window;
    SDL_GLContext context;
    struct display_canvas canvas; /* the window's own buffers are undefined after a frame, and of its size only later */
    struct window_input input;
    struct display_pace pace;
    uint64_t next_us; /* before which no frame is drawn, where the desktop does not pace them */
    int link;         /* to the desktop (desktop_link.h) */
    bool subsystem;   /* SDL's video was started */
    bool cut;         /* the desktop has gone */
    bool software;    /* GL draws with the CPU */
};

static void set_hints(void)
{
    const char *const hints[][2] = {
        {SDL_HINT_NO_SIGNAL_HANDLERS, "1"},
        {SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1"},
        {SDL_HINT_TOUCH_MOUSE_EVENTS, "0"},
        {SDL_HINT_MOUSE_TOUCH_EVENTS, "0"},
        {SDL_HINT_VIDEO_X11_FORCE_EGL, "1"},
        {SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0"},
        {SDL_HINT_VIDEO_MINIMIZE_ON_FOCUS_LOSS, "0"},
        {SDL_HINT_VIDEODRIVER, getenv("WAYLAND_DISPLAY") ? "wayland,x11" : "x11"},
        {SDL_HINT_APP_NAME, "Frond"},
    };
    for (size_t i = 0; i < sizeof hints / sizeof hints[0]; i++) {
        SDL_SetHint(hints[i][0], hints[i][1]);
    }
}

static void set_attributes(bool robust)
{
    SDL_GL_ResetAttributes();
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 1);
    SDL_GL_SetAttribute(SDL_GL_RED_SIZE, 8);
    SDL_GL_SetAttribute(SDL_GL_GREEN_SIZE, 8);
    SDL_GL_SetAttribute(SDL_GL_BLUE_SIZE, 8);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    if (robust) {
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_FLAGS, SDL_GL_CONTEXT_ROBUST_ACCESS_FLAG);
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_RESET_NOTIFICATION, SDL_GL_CONTEXT_RESET_LOSE_CONTEXT);
    }
}

static void drop_canvas(struct display *display)
{
    struct window *window = display->own;
    if (display_egl_enter(&display->egl)) {
        display_canvas_drop(&window->canvas);
    }
    window->canvas = (struct display_canvas){0};
    display->framebuffer = 0;
    display->drawn = false;
}

/* Makes the canvas as large as the window is now, in pixels. */
static bool follow_size(struct display *display)
{
    struct window *window = display->own;
    int width = 0, height = 0;
    SDL_GL_GetDrawableSize(window->window, &width, &height);
    if (width <= 0 || height <= 0 || width > DISPLAY_SIZE_MAX || height > DISPLAY_SIZE_MAX) {
        return window->canvas.framebuffer != 0;
    }
    if (window->canvas.framebuffer && width == display->panel.width && height == display->panel.height) {
        return true;
    }
    drop_canvas(display);
    display->panel = (struct display_size){width, height};
    if (!display_egl_enter(&display->egl) || !display_canvas_make(&window->canvas, width, height)) {
        return false;
    }
    display->framebuffer = window->canvas.framebuffer;
    return true;
}

static void read_refresh(struct display *display)
{
    struct window *window = display->own;
    SDL_DisplayMode mode;
    int screen = SDL_GetWindowDisplayIndex(window->window);
    bool known = screen >= 0 && SDL_GetCurrentDisplayMode(screen, &mode) == 0 && mode.refresh_rate > 0;
    display->frames.refresh_mhz = display->def.refresh_mhz ? display->def.refresh_mhz
                                  : known                  ? mode.refresh_rate * 1000
                                                           : REFRESH_MHZ;
}

/* SDL's own context, taken over as it is: SDL presents only what it made current itself. */
static bool take_over(struct display *display, struct device_error *error)
{
    struct display_egl *egl = &display->egl;
    egl->display = eglGetCurrentDisplay();
    egl->context = eglGetCurrentContext();
    egl->surface = eglGetCurrentSurface(EGL_DRAW);
    if (egl->display == EGL_NO_DISPLAY || egl->context == EGL_NO_CONTEXT) {
        return device_fail(error, "window: SDL's %s driver gives a context that is not of EGL",
                           SDL_GetCurrentVideoDriver());
    }
    EGLint id = 0, count = 0;
    eglQueryContext(egl->display, egl->context, EGL_CONFIG_ID, &id);
    const EGLint wanted[] = {EGL_CONFIG_ID, id, EGL_NONE};
    if (!eglChooseConfig(egl->display, wanted, &egl->config, 1, &count) || count != 1) {
        egl->config = EGL_NO_CONFIG_KHR;
    }
    return true;
}

static bool open_context(struct display *display, struct device_error *error)
{
    struct window *window = display->own;
    set_attributes(display->def.robust);
    window->context = SDL_GL_CreateContext(window->window);
    display->egl.robust = window->context && display->def.robust;
    if (!window->context && display->def.robust) {
        set_attributes(false);
        window->context = SDL_GL_CreateContext(window->window);
    }
    if (!window->context) {
        return device_fail(error, "window: no context of GLES 3.1: %s", SDL_GetError());
    }
    if (!take_over(display, error)) {
        return false;
    }
    window->software = display_egl_software();
    SDL_GL_SetSwapInterval(1);
    return follow_size(display) || device_fail(error, "window: no framebuffer of its size");
}

static bool open_window(struct display *display, struct device_error *error)
{
    struct window *window = display->own;
    set_hints();
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) {
        return device_fail(error, "window: no desktop: %s", SDL_GetError());
    }
    window->subsystem = true;
    const char *driver = SDL_GetCurrentVideoDriver();
    if (driver && strcasecmp(driver, "KMSDRM") == 0) {
        return device_fail(error, "window: no desktop, a bare screen (--display kms)");
    }
    set_attributes(display->def.robust);
    window->window = SDL_CreateWindow("Frond", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED,
                                      display->def.width ? display->def.width : WINDOW_WIDTH,
                                      display->def.height ? display->def.height : WINDOW_HEIGHT,
                                      SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
    if (!window->window) {
        return device_fail(error, "window: %s", SDL_GetError());
    }
    window->link = desktop_link(window->window);
    return true;
}

/* Nothing is shown any more, nor anything asked of SDL. */
static bool is_cut(struct display *display)
{
    struct window *window = display->own;
    if (!window->cut && desktop_link_is_cut(window->link)) {
        window->cut = display->closed = true;
        snprintf(display->note, sizeof display->note, "the desktop has gone");
    }
    return window->cut;
}

static bool window_create(struct display *display, struct device_error *error)
{
    struct window *window = calloc(1, sizeof *window);
    display->own = window;
    if (!window) {
        return device_fail(error, "window: memory is short");
    }
    window->link = -1;
    if (!open_window(display, error) || !open_context(display, error)) {
        return false;
    }
    read_refresh(display);
    snprintf(display->note, sizeof display->note, "%s, %s", SDL_GetCurrentVideoDriver(),
             (const char *)glGetString(GL_RENDERER));
    return true;
}

static void close_context(struct display *display)
{
    struct window *window = display->own;
    drop_canvas(display);
    SDL_GL_MakeCurrent(window->window, NULL);
    SDL_GL_DeleteContext(window->context);
    window->context = NULL;
    display->egl.context = EGL_NO_CONTEXT;
}

static void window_destroy(struct display *display)
{
    struct window *window = display->own;
    if (!window) {
        return;
    }
    bool cut = is_cut(display); /* what SDL and EGL have then ends with the process */
    if (window->context && !cut) {
        close_context(display);
    }
    if (window->window && !cut) {
        SDL_DestroyWindow(window->window);
    }
    if (window->subsystem && !cut) {
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
    }
    free(window);
}

static void toggle_fullscreen(struct window *window)
{
    bool full = SDL_GetWindowFlags(window->window) & SDL_WINDOW_FULLSCREEN_DESKTOP;
    SDL_SetWindowFullscreen(window->window, full ? 0 : SDL_WINDOW_FULLSCREEN_DESKTOP);
}

static void take_window_event(struct display *display, const SDL_WindowEvent *event)
{
    switch (event->event) {
    case SDL_WINDOWEVENT_CLOSE:
        display->closed = true;
        break;
    case SDL_WINDOWEVENT_SIZE_CHANGED:
        follow_size(display);
        break;
    case SDL_WINDOWEVENT_DISPLAY_CHANGED:
        read_refresh(display);
        break;
    default:
        break;
    }
}

static void take_event(struct display *display, const SDL_Event *event)
{
    struct window *window = display->own;
    if (event->type == SDL_QUIT) {
        display->closed = true;
    } else if (event->type == SDL_WINDOWEVENT) {
        take_window_event(display, &event->window);
    } else if (event->type == SDL_KEYDOWN && !event->key.repeat) {
        SDL_Keycode key = event->key.keysym.sym;
        if (key == SDLK_F11 || (key == SDLK_RETURN && (event->key.keysym.mod & KMOD_ALT))) {
            toggle_fullscreen(window);
        }
    } else {
        int width = 1, height = 1;
        struct event finger;
        SDL_GetWindowSize(window->window, &width, &height); /* of the mouse's points, not pixels */
        if (window_input_take(&window->input, event, width, height, &finger)) {
            display_untouch(display, &finger.x, &finger.y);
            finger.time_us = source_now_us();
            display_post(display, finger);
        }
    }
}

static void take_events(struct display *display)
{
    struct window *window = display->own;
    SDL_Event event;
    if (is_cut(display)) {
        return;
    }
    while (SDL_PollEvent(&event)) {
        take_event(display, &event);
    }
    Uint32 flags = SDL_GetWindowFlags(window->window);
    display->state = flags & (SDL_WINDOW_HIDDEN | SDL_WINDOW_MINIMIZED) ? DISPLAY_LENT : DISPLAY_SHOWN;
    if (display->state != DISPLAY_SHOWN) {
        display_pace_stop(&window->pace);
    }
}

static void window_wait(struct display *display, int timeout_ms)
{
    const struct window *window = display->own;
    take_events(display);
    if (display->queue.count > 0 || display->closed) {
        return;
    }
    uint64_t now_us = source_now_us();
    int until_ms = timeout_ms < 0 ? INT32_MAX : timeout_ms;
    if (display->state == DISPLAY_SHOWN) {
        uint64_t left_us = window->next_us > now_us ? window->next_us - now_us : 0;
        until_ms = (int)(left_us / 1000) < until_ms ? (int)((left_us + 999) / 1000) : until_ms;
    }
    if (window->link >= 0) {
        display_poll(display, (const int[2]){window->link, -1}, until_ms);
        take_events(display);
        return;
    }
    static const int NONE[2] = {-1, -1};
    uint64_t end_us = now_us + (uint64_t)until_ms * 1000;
    while (until_ms > 0 && !display_poll(display, NONE, 0)) {
        int slice_ms = display->wake_count > 0 && until_ms > SLICE_MS ? SLICE_MS : until_ms;
        if (SDL_WaitEventTimeout(NULL, slice_ms)) {
            take_events(display);
            return;
        }
        now_us = source_now_us();
        until_ms = now_us < end_us ? (int)((end_us - now_us + 999) / 1000) : 0;
    }
}

static bool window_begin(struct display *display)
{
    const struct window *window = display->own;
    if (window->cut || source_now_us() < window->next_us || !window->canvas.framebuffer) {
        return false;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, display->framebuffer);
    return true;
}

static void show_canvas(struct display *display)
{
    const struct window *window = display->own;
    int width = display->panel.width, height = display->panel.height;
    bool scissor = glIsEnabled(GL_SCISSOR_TEST);
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, window->canvas.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    if (window->software) {
        glFinish(); /* all that is left is to copy: the desktop has little time to go meanwhile */
    }
    if (!is_cut(display)) {
        SDL_GL_SwapWindow(window->window);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, window->canvas.framebuffer);
    if (scissor) {
        glEnable(GL_SCISSOR_TEST);
    }
}

static void window_end(struct display *display)
{
    struct window *window = display->own;
    show_canvas(display);
    uint64_t now_us = source_now_us();
    display->frames.missed += display_pace_missed(&window->pace, 0, now_us, display->frames.refresh_mhz);
    display->frames.presented++;
    display->frames.last_us = now_us;
    uint64_t period_us = UINT64_C(1000000000) / (uint64_t)display->frames.refresh_mhz;
    window->next_us = now_us + period_us * 3 / 4; /* the rest is the desktop's, which may pace by itself */
}

static bool window_renew(struct display *display, struct device_error *error)
{
    struct window *window = display->own;
    if (is_cut(display)) {
        return device_fail(error, "window: the desktop has gone");
    }
    if (window->context) {
        close_context(display);
    }
    return open_context(display, error);
}

const struct display_source display_window = {
    .kind = DISPLAY_WINDOW,
    .create = window_create,
    .destroy = window_destroy,
    .wait = window_wait,
    .begin = window_begin,
    .end = window_end,
    .renew = window_renew,
};
