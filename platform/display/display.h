/* A place where pictures are shown: a screen of the board itself (KMS), a window on a desktop, or memory (headless).
 *
 *     struct display *display = display_create(&def, &error);
 *     while (running) {
 *         display_wait(display, 100);
 *         while (display_event(display, &event)) { ... }
 *         if (display_begin(display)) {
 *             draw into display_framebuffer(display), display_panel(display) pixels, turned by display_turn(display)
 *             display_end(display);
 *         }
 *     }
 *     display_destroy(display);
 *
 * No screen, a dark screen and a screen lent to another program are states, not errors: the display keeps its GL
 * context through all of them and comes back by itself.
 * A display belongs to the thread that made it; display_share gives other threads a GL context of their own. */
#ifndef FROND_DISPLAY_H
#define FROND_DISPLAY_H

#include <stdbool.h>
#include <stdint.h>

#include "device_error.h"
#include "event.h"

enum display_kind { DISPLAY_AUTO, DISPLAY_KMS, DISPLAY_WINDOW, DISPLAY_HEADLESS, DISPLAY_KINDS };

enum display_state {
    DISPLAY_SHOWN,  /* frames reach the eye, or memory */
    DISPLAY_DARK,   /* switched off by display_power */
    DISPLAY_ABSENT, /* nothing is plugged in, or nothing that the definition admits */
    DISPLAY_LENT,   /* another program is master of the screen, or the window is hidden */
};

enum {
    DISPLAY_SIZE_MAX = 8192,
    DISPLAY_REFRESH_MAX_MHZ = 1000000,
    DISPLAY_WAKES = 16,
    DISPLAY_HEADLESS_WIDTH = 1280,
    DISPLAY_HEADLESS_HEIGHT = 720,
};

struct display_def {
    enum display_kind kind;
    const char *card;      /* KMS: "/dev/dri/card1"; NULL: the first with the best connector, as below */
    const char *connector; /* KMS: "HDMI-A-1"; NULL: the first that is connected of HDMI, DisplayPort, DVI, VGA, then
                              DSI, LVDS, eDP, DPI, then others */
    int width, height;     /* pixels of the panel, 0..DISPLAY_SIZE_MAX; 0: what it prefers */
    int refresh_mhz;       /* 0..DISPLAY_REFRESH_MAX_MHZ, KMS: within 500; 0: what it prefers, or the nearest to 60 Hz;
                              headless: 0 is as fast as frames come */
    int rotation;          /* 0, 90, 180 or 270 degrees clockwise that the picture is turned on the panel */
    bool robust;           /* ask for a context that tells of resets; taken where there is one */
    bool legacy;           /* KMS: the calls of before atomic mode setting, even where there is that */
};

struct display_def display_default_def(void); /* auto, whatever it prefers, not turned, robust */
/* "auto", "kms", "window", "headless", as the command line writes them. */
const char *display_kind_name(enum display_kind kind);

struct display;

/* NULL with the reason in `error`: no such source in this build or on this machine, no GLES 3.1, a connector or a mode
 * that the definition asks for and that exists nowhere. Nothing plugged in is no reason. */
struct display *display_create(const struct display_def *def, struct device_error *error);
void display_destroy(struct display *display); /* takes NULL */

enum display_kind display_kind(const struct display *display);
enum display_state display_state(const struct display *display);
/* One line for the log: source, connector, mode, driver, rotation, and why this source. */
const char *display_describe(const struct display *display);

struct display_size {
    int width, height; /* pixels */
};
struct display_size display_panel(const struct display *display); /* of the framebuffer; 0x0 while absent */
struct display_size display_sheet(const struct display *display); /* as it is looked at: turned back */
/* Column-major 2x2 matrix from the sheet's clip coordinates to those of display_framebuffer. It turns, and it mirrors
 * where the framebuffer has its first row on top, as screens do (KMS): never draw without it. */
void display_turn(const struct display *display, float turn[4]);
/* A position in 0..1 of the panel (x right, y down, as touch hardware reports it) as 0..1 of the sheet. */
void display_untouch(const struct display *display, float *x, float *y);

/* Waits until a frame may be drawn, something has happened, or `timeout_ms` have passed (-1: for ever, 0: not at all),
 * and attends to hot-plug, master and page flips: to be called at least every second, even when nothing is drawn. */
void display_wait(struct display *display, int timeout_ms);
/* Descriptors that end display_wait when they are readable (sources of input), at most DISPLAY_WAKES; they are copied,
 * and take the place of those before. A window looks at them every few milliseconds. */
void display_wake_on(struct display *display, const int *fds, int count);
/* The next thing that fingers did (window: the mouse). False when there is none. */
bool display_event(struct display *display, struct event *event);
/* The window was closed. */
bool display_closed(const struct display *display);

/* Whether a frame may be drawn now: the screen is there, and the last frame has been taken. Makes the context current
 * and binds the framebuffer. Never waits. Without display_end nothing has happened: the last picture stays. */
bool display_begin(struct display *display);
/* Makes the context current between frames, for whoever reads back what was drawn into textures of its own. False when
 * it is lost. */
bool display_enter(struct display *display);
/* Presents what was drawn since display_begin, at the next vertical blank. A window may wait here for the desktop to
 * take the frame; a screen never does. */
void display_end(struct display *display);
/* GL name; another one each frame, known from display_begin on. */
unsigned display_framebuffer(const struct display *display);

/* Switches the panel off (DPMS) and on again. */
void display_power(struct display *display, bool on);

struct display_frames {
    uint64_t presented; /* frames that have reached the screen since display_create */
    uint64_t last_us;   /* CLOCK_MONOTONIC of the last of them */
    uint64_t missed;    /* vertical blanks at which the last picture was shown again */
    int refresh_mhz;    /* of the mode now */
};
struct display_frames display_frames(const struct display *display);

/* The last frame drawn (display_end), as it is looked at, display_sheet pixels of red green blue from the top left. It
 * is read from the framebuffer that it was drawn into, which every source keeps until the next frame: it costs nothing
 * when nobody asks. False before the first frame on this panel, and while the context is lost. Waits for the GPU; not
 * between display_begin and display_end. */
bool display_capture(struct display *display, uint8_t *rgb);

/* A GL context for another thread, sharing textures, buffers and programs. NULL when there is none to be had. */
struct display_context;
struct display_context *display_share(struct display *display);
/* Makes it current in the calling thread; false when it is lost. */
bool display_context_enter(struct display_context *context);
void display_context_leave(struct display_context *context);
void display_context_destroy(struct display_context *context); /* takes NULL */

/* A reset of the GPU takes every context with it; so does opening the card anew, where another program held it at the
 * start and has gone. Checks without waiting; true from the first time until display_renew. `display_inject_reset`
 * makes believe there was one (tests, and a staff key). */
bool display_lost(struct display *display);
void display_inject_reset(struct display *display);
/* Makes a new context in place of a lost one; everything in GL is to be made again. Shared contexts must have been
 * destroyed. False when there is none to be had yet: try again later. */
bool display_renew(struct display *display, struct device_error *error);

#endif
