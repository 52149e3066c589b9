/* What a source of display has to offer display.c; private to platform/display*.c. */
#ifndef FROND_DISPLAY_SOURCE_H
#define FROND_DISPLAY_SOURCE_H

#include "display.h"
#include "display_egl.h"
#include "source_queue.h"

struct display;

struct display_source {
    enum display_kind kind;
    /* Fills source_state, egl, panel, state, note. */
    bool (*create)(struct display *display, struct device_error *error);
    void (*destroy)(struct display *display);
    void (*wait)(struct display *display, int timeout_ms);
    bool (*begin)(struct display *display); /* the context is current; sets and binds framebuffer */
    void (*end)(struct display *display);
    void (*power)(struct display *display, bool on); /* NULL: no such thing */
    bool (*renew)(struct display *display, struct device_error *error);
};

struct display {
    struct display_def def;
    const struct display_source *source;
    void *own; /* the source's */
    struct display_egl egl;
    enum display_state state;
    struct display_size panel;
    struct display_frames frames;
    unsigned framebuffer; /* that is being drawn, or was drawn last */
    unsigned last;        /* framebuffer that was drawn last */
    bool drawn;           /* it holds a whole frame */
    bool flipped;         /* its lowest row is the panel's uppermost */
    bool closed, lost;
    char card[200], connector[32]; /* what def's pointers point to */
    char why[300];                 /* why this source was taken */
    char note[400];                /* what the source says of itself */
    char text[800];                /* display_describe */
    struct source_queue queue;
    int wakes[DISPLAY_WAKES], wake_count;
};

extern const struct display_source display_kms, display_window, display_headless;

/* Sets the source; the time is the caller's. */
void display_post(struct display *display, struct event event);
/* Waits for two descriptors of the source's own (-1: none) and those of display_wake_on. True when one of the latter is
 * readable, or a signal has come. */
bool display_poll(const struct display *display, const int own[2], int timeout_ms);

#endif
