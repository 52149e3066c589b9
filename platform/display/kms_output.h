/* One connector, the CRTC that feeds it and the primary plane of that: set to a mode, flipped, switched off. Atomic
 * where the card is, else by the calls of before. Calls give 0 or an errno value. */
#ifndef FROND_KMS_OUTPUT_H
#define FROND_KMS_OUTPUT_H

#include "display.h"
#include "kms_calls.h"

struct kms_plane_properties {
    uint32_t framebuffer, crtc, src_x, src_y, src_w, src_h, crtc_x, crtc_y, crtc_w, crtc_h, rotation;
};

struct kms_output {
    char name[KMS_NAME]; /* of the connector */
    drmModeModeInfo mode;
    uint32_t connector, crtc, plane;
    uint32_t mode_blob;                       /* 0: none */
    uint32_t crtc_id, link_status, dpms;      /* properties of the connector, 0: has none */
    uint32_t mode_id, active;                 /* properties of the CRTC */
    struct kms_plane_properties on;           /* properties of the plane */
    struct kms_plane shape;                   /* the plane's formats */
    int stray_count;                          /* what else is on this CRTC, and has to leave it */
    struct kms_value strays[KMS_VALUES - 20]; /* request that takes it away */
};

/* Looks up everything by name, once. False with the reason: no plane, or a property that must be there is missing. */
bool kms_output_open(struct kms_output *output, struct kms_card *card, const struct kms_scan *scan,
                     const struct kms_connector *connector, uint32_t crtc, const drmModeModeInfo *mode,
                     struct device_error *error);
void kms_output_close(struct kms_output *output, struct kms_card *card);

/* Whether the mode could be set with this framebuffer; 0 where there is no way to ask. */
int kms_output_test(const struct kms_output *output, struct kms_card *card, uint32_t framebuffer);
/* Sets the mode and shows the framebuffer. `*flips`: a flip with the token will follow. */
int kms_output_set(const struct kms_output *output, struct kms_card *card, uint32_t framebuffer, uint64_t token,
                   bool *flips);
int kms_output_flip(const struct kms_output *output, struct kms_card *card, uint32_t framebuffer, uint64_t token);
/* Takes the signal away; the monitor goes to sleep. */
int kms_output_dark(const struct kms_output *output, struct kms_card *card);
/* Takes CRTC, plane and connector apart. Without `wait` it is EBUSY while a flip is under way. */
int kms_output_off(const struct kms_output *output, struct kms_card *card, bool wait);

/* Why setting the mode ended with `code`: finds the property that is refused by leaving each out of the request in
 * turn. "HDMI-A-1 1920x1080@60: property CRTC_W = 1920 is refused: Invalid argument" */
void kms_output_explain(const struct kms_output *output, struct kms_card *card, uint32_t framebuffer, int code,
                        struct device_error *error);

#endif
