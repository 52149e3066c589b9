#include "display_egl.h"

#include <stdlib.h>
#include <string.h>

#include <GLES3/gl31.h>

#include "display_source.h"

const char *display_egl_reason(void)
{
    static const struct {
        EGLint code;
        const char *text;
    } REASONS[] = {
        {EGL_SUCCESS, "no reason given"},
        {EGL_NOT_INITIALIZED, "0x3001 (EGL_NOT_INITIALIZED)"},
        {EGL_BAD_ACCESS, "0x3002 (EGL_BAD_ACCESS)"},
        {EGL_BAD_ALLOC, "0x3003 (EGL_BAD_ALLOC)"},
        {EGL_BAD_ATTRIBUTE, "0x3004 (EGL_BAD_ATTRIBUTE)"},
        {EGL_BAD_CONFIG, "0x3005 (EGL_BAD_CONFIG)"},
        {EGL_BAD_CONTEXT, "0x3006 (EGL_BAD_CONTEXT)"},
        {EGL_BAD_DISPLAY, "0x3008 (EGL_BAD_DISPLAY)"},
        {EGL_BAD_MATCH, "0x3009 (EGL_BAD_MATCH)"},
        {EGL_BAD_NATIVE_WINDOW, "0x300b (EGL_BAD_NATIVE_WINDOW)"},
        {EGL_BAD_SURFACE, "0x300d (EGL_BAD_SURFACE)"},
        {EGL_CONTEXT_LOST, "0x300e (EGL_CONTEXT_LOST)"},
    };
    EGLint code = eglGetError();
    for (size_t i = 0; i < sizeof REASONS / sizeof REASONS[0]; i++) {
        if (REASONS[i].code == code) {
            return REASONS[i].text;
        }
    }
    return "an unknown EGL error";
}

static bool has_extension(EGLDisplay display, const char *name)
{
    const char *all = eglQueryString(display, EGL_EXTENSIONS);
    size_t length = strlen(name);
    for (const char *at = all; at && (at = strstr(at, name)); at += length) {
        if ((at == all || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0')) {
            return true;
        }
    }
    return false;
}

static EGLContext create(const struct display_egl *egl, bool robust, EGLContext share)
{
    const EGLint plain[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 1, EGL_NONE};
    const EGLint telling[] = {EGL_CONTEXT_MAJOR_VERSION,
                              3,
                              EGL_CONTEXT_MINOR_VERSION,
                              1,
                              EGL_CONTEXT_OPENGL_ROBUST_ACCESS_EXT,
                              EGL_TRUE,
                              EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT,
                              EGL_LOSE_CONTEXT_ON_RESET_EXT,
                              EGL_NONE};
    return eglCreateContext(egl->display, egl->config, share, robust ? telling : plain);
}

bool display_egl_context(struct display_egl *egl, bool robust, struct device_error *error)
{
    eglBindAPI(EGL_OPENGL_ES_API);
    egl->robust = robust && has_extension(egl->display, "EGL_EXT_create_context_robustness");
    egl->context = create(egl, egl->robust, EGL_NO_CONTEXT);
    if (egl->context == EGL_NO_CONTEXT && egl->robust) { /* offered, and then not given */
        egl->robust = false;
        egl->context = create(egl, false, EGL_NO_CONTEXT);
    }
    if (egl->context == EGL_NO_CONTEXT) {
        return device_fail(error, "no context of GLES 3.1 on %s: %s", eglQueryString(egl->display, EGL_VENDOR),
                           display_egl_reason());
    }
    return true;
}

bool display_egl_enter(const struct display_egl *egl)
{
    eglBindAPI(EGL_OPENGL_ES_API);
    if (eglGetCurrentContext() == egl->context && eglGetCurrentSurface(EGL_DRAW) == egl->surface) {
        return true; /* making it so again would flush */
    }
    return eglMakeCurrent(egl->display, egl->surface, egl->surface, egl->context);
}

bool display_egl_software(void)
{
    const char *renderer = (const char *)glGetString(GL_RENDERER);
    return renderer && (strstr(renderer, "llvmpipe") || strstr(renderer, "softpipe"));
}

void display_egl_finish(struct display_egl *egl)
{
    if (egl->display == EGL_NO_DISPLAY) {
        return;
    }
    eglMakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (egl->surface != EGL_NO_SURFACE) {
        eglDestroySurface(egl->display, egl->surface);
    }
    if (egl->context != EGL_NO_CONTEXT) {
        eglDestroyContext(egl->display, egl->context);
    }
    egl->surface = EGL_NO_SURFACE;
    egl->context = EGL_NO_CONTEXT;
}

/* Contexts for other threads (display.h). */
struct display_context {
    struct display_egl egl;
};

struct display_context *display_share(struct display *display)
{
    struct display_context *context = calloc(1, sizeof *context);
    if (!context) {
        return NULL;
    }
    eglBindAPI(EGL_OPENGL_ES_API);
    context->egl = display->egl;
    context->egl.surface = EGL_NO_SURFACE;
    context->egl.context = create(&display->egl, display->egl.robust, display->egl.context);
    if (context->egl.context == EGL_NO_CONTEXT) {
        free(context);
        return NULL;
    }
    return context;
}

bool display_context_enter(struct display_context *context)
{
    return display_egl_enter(&context->egl);
}

void display_context_leave(struct display_context *context)
{
    eglMakeCurrent(context->egl.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

void display_context_destroy(struct display_context *context)
{
    if (context) {
        eglDestroyContext(context->egl.display, context->egl.context);
        free(context);
    }
}
