#include "kms_buffers.h"

#include <errno.h>
#include <string.h>

#include <GLES3/gl31.h>

#include <GLES2/gl2ext.h>

#include <drm_fourcc.h>

#include "display_source.h"

static bool add_framebuffer(const struct kms_buffers *buffers, struct kms_buffer *buffer, bool modified,
                            struct device_error *error)
{
    uint32_t handles[4] = {0}, pitches[4] = {0}, offsets[4] = {0};
    uint64_t modifiers[4] = {0};
    int planes = gbm_bo_get_plane_count(buffer->bo);
    for (int i = 0; i < planes && i < 4; i++) {
        handles[i] = gbm_bo_get_handle_for_plane(buffer->bo, i).u32;
        pitches[i] = gbm_bo_get_stride_for_plane(buffer->bo, i);
        offsets[i] = gbm_bo_get_offset(buffer->bo, i);
        modifiers[i] = gbm_bo_get_modifier(buffer->bo);
    }
    int fd = buffers->card->fd;
    uint32_t width = gbm_bo_get_width(buffer->bo), height = gbm_bo_get_height(buffer->bo);
    int result = modified && modifiers[0] != DRM_FORMAT_MOD_INVALID
                     ? drmModeAddFB2WithModifiers(fd, width, height, DRM_FORMAT_XRGB8888, handles, pitches, offsets,
                                                  modifiers, &buffer->id, DRM_MODE_FB_MODIFIERS)
                     : drmModeAddFB2(fd, width, height, DRM_FORMAT_XRGB8888, handles, pitches, offsets, &buffer->id, 0);
    if (result != 0) {
        buffer->id = 0;
        return device_fail(error, "a framebuffer of %ux%u XRGB8888, modifier 0x%llx, is refused: %s", width, height,
                           (unsigned long long)modifiers[0], strerror(errno));
    }
    return true;
}

static bool make_one(struct kms_buffers *buffers, struct kms_buffer *buffer, int width, int height,
                     const uint64_t *modifiers, int modifier_count, struct device_error *error)
{
    const uint32_t use = GBM_BO_USE_SCANOUT | GBM_BO_USE_RENDERING;
    errno = 0;
    buffer->bo = modifier_count > 0
                     ? gbm_bo_create_with_modifiers2(buffers->gbm, (uint32_t)width, (uint32_t)height,
                                                     GBM_FORMAT_XRGB8888, modifiers, (unsigned)modifier_count, use)
                     : gbm_bo_create(buffers->gbm, (uint32_t)width, (uint32_t)height, GBM_FORMAT_XRGB8888, use);
    if (!buffer->bo) {
        return device_fail(error, "no buffer of %dx%d XRGB8888 to draw into and show: %s", width, height,
                           errno ? strerror(errno) : "the driver gives none");
    }
    buffers->modifier = gbm_bo_get_modifier(buffer->bo);
    return add_framebuffer(buffers, buffer, modifier_count > 0, error);
}

static bool bind_one(struct kms_buffer *buffer, const struct display_egl *egl, struct device_error *error)
{
    PFNEGLCREATEIMAGEKHRPROC create_image = (PFNEGLCREATEIMAGEKHRPROC)eglGetProcAddress("eglCreateImageKHR");
    PFNGLEGLIMAGETARGETRENDERBUFFERSTORAGEOESPROC storage =
        (PFNGLEGLIMAGETARGETRENDERBUFFERSTORAGEOESPROC)eglGetProcAddress("glEGLImageTargetRenderbufferStorageOES");
    if (!create_image || !storage) {
        return device_fail(error, "the driver draws into no EGL images");
    }
    buffer->image =
        create_image(egl->display, EGL_NO_CONTEXT, EGL_NATIVE_PIXMAP_KHR, (EGLClientBuffer)buffer->bo, NULL);
    if (buffer->image == EGL_NO_IMAGE_KHR) {
        return device_fail(error, "no EGL image of a buffer: %s", display_egl_reason());
    }
    glGenRenderbuffers(1, &buffer->renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer->renderbuffer);
    storage(GL_RENDERBUFFER, buffer->image);
    glGenFramebuffers(1, &buffer->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, buffer->framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer->renderbuffer);
    GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        return device_fail(error, "GL does not draw into the screen's buffers: 0x%x", status);
    }
    return true;
}

bool kms_buffers_bind(struct kms_buffers *buffers, const struct display_egl *egl, struct device_error *error)
{
    for (int i = 0; i < KMS_BUFFERS; i++) {
        if (!bind_one(&buffers->each[i], egl, error)) {
            kms_buffers_unbind(buffers, egl);
            return false;
        }
    }
    return true;
}

void kms_buffers_unbind(struct kms_buffers *buffers, const struct display_egl *egl)
{
    bool current = egl->context != EGL_NO_CONTEXT && display_egl_enter(egl);
    PFNEGLDESTROYIMAGEKHRPROC destroy_image = (PFNEGLDESTROYIMAGEKHRPROC)eglGetProcAddress("eglDestroyImageKHR");
    for (int i = 0; i < KMS_BUFFERS; i++) {
        struct kms_buffer *buffer = &buffers->each[i];
        if (current) {
            glDeleteFramebuffers(1, &buffer->framebuffer);
            glDeleteRenderbuffers(1, &buffer->renderbuffer);
        }
        if (buffer->image != EGL_NO_IMAGE_KHR && destroy_image) {
            destroy_image(egl->display, buffer->image);
        }
        buffer->image = EGL_NO_IMAGE_KHR;
        buffer->framebuffer = buffer->renderbuffer = 0;
    }
}

bool kms_buffers_make(struct kms_buffers *buffers, const struct display_egl *egl, int width, int height,
                      const uint64_t *modifiers, int modifier_count, struct device_error *error)
{
    for (int i = 0; i < KMS_BUFFERS; i++) {
        if (!make_one(buffers, &buffers->each[i], width, height, modifiers, modifier_count, error)) {
            kms_buffers_drop(buffers, egl);
            return false;
        }
    }
    if (!kms_buffers_bind(buffers, egl, error)) {
        kms_buffers_drop(buffers, egl);
        return false;
    }
    return true;
}

void kms_buffers_drop(struct kms_buffers *buffers, const struct display_egl *egl)
{
    kms_buffers_unbind(buffers, egl);
    for (int i = 0; i < KMS_BUFFERS; i++) {
        struct kms_buffer *buffer = &buffers->each[i];
        if (buffer->id != 0) {
            drmModeRmFB(buffers->card->fd, buffer->id);
        }
        if (buffer->bo) {
            gbm_bo_destroy(buffer->bo);
        }
        *buffer = (struct kms_buffer){.bo = NULL};
    }
}

bool kms_buffers_made(const struct kms_buffers *buffers)
{
    return buffers->each[0].bo != NULL;
}
