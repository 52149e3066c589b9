/* Two framebuffers of a card that GL draws into: one is shown while the other is drawn. */
#ifndef FROND_KMS_BUFFERS_H
#define FROND_KMS_BUFFERS_H

#include <gbm.h>

#include "display_egl.h"
#include "kms_calls.h"

enum { KMS_BUFFERS = 2 };

struct kms_buffer {
    struct gbm_bo *bo;
    uint32_t id;                        /* of KMS */
    EGLImageKHR image;                  /* of the bo */
    unsigned renderbuffer, framebuffer; /* of GL; its lowest row is the screen's uppermost */
};

struct kms_buffers {
    struct gbm_device *gbm;
    const struct kms_card *card;
    struct kms_buffer each[KMS_BUFFERS];
    uint64_t modifier; /* DRM_FORMAT_MOD_* of their layout */
};

/* XRGB8888, width x height pixels. With modifiers: in a layout of those, chosen by the driver; else in what it thinks
 * best. The context is current. False with the reason, and nothing is left behind. */
bool kms_buffers_make(struct kms_buffers *buffers, const struct display_egl *egl, int width, int height,
                      const uint64_t *modifiers, int modifier_count, struct device_error *error);
/* Takes those that were never made. */
void kms_buffers_drop(struct kms_buffers *buffers, const struct display_egl *egl);
bool kms_buffers_made(const struct kms_buffers *buffers);

/* GL's side alone, for another context. */
bool kms_buffers_bind(struct kms_buffers *buffers, const struct display_egl *egl, struct device_error *error);
void kms_buffers_unbind(struct kms_buffers *buffers, const struct display_egl *egl);

#endif
