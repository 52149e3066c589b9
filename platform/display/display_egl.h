/* EGL for every source of display: a GLES 3.1 context, and more that share with it. Private to platform/display*.c. */
#ifndef FROND_DISPLAY_EGL_H
#define FROND_DISPLAY_EGL_H

#include <stdbool.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "display.h"

struct display_egl {
    EGLDisplay display; /* EGL_NO_DISPLAY: none */
    EGLConfig config;   /* EGL_NO_CONFIG_KHR where no surface is wanted */
    EGLContext context;
    EGLSurface surface; /* EGL_NO_SURFACE: surfaceless */
    bool robust;        /* tells of resets */
};

/* A context on an initialised display and chosen config; takes robustness where wanted and offered. */
bool display_egl_context(struct display_egl *egl, bool robust, struct device_error *error);
/* Makes the context current with its surface. */
bool display_egl_enter(const struct display_egl *egl);
/* Whether the current context draws with the processor. */
bool display_egl_software(void);
/* Destroys surface and context, not the display. */
void display_egl_finish(struct display_egl *egl);
/* "0x3003 (EGL_BAD_ALLOC)" of the last failure. */
const char *display_egl_reason(void);

#endif
