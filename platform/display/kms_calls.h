/* What Frond asks of the kernel's mode setting (KMS), as a table of calls: a card of libdrm (kms_card.c) or a test's
 * own. Source: the kernel's "Kernel Mode Setting" chapter and drm_mode.h. Every call gives 0 or an errno value, never
 * blocks longer than the ioctl behind it does, and allocates nothing that outlives it. */
#ifndef FROND_KMS_CALLS_H
#define FROND_KMS_CALLS_H

#include <stdbool.h>
#include <stdint.h>

#include <xf86drm.h>
#include <xf86drmMode.h>

enum {
    KMS_NAME = 32, /* bytes of a connector's or property's name, with its end */
    KMS_CONNECTORS = 16,
    KMS_CRTCS = 32, /* masks of CRTCs have 32 bits */
    KMS_MODES = 128,
    KMS_PLANES = 64,
    KMS_PROPERTIES = 64,
    KMS_MODIFIERS = 64,
    KMS_VALUES = 80, /* of one commit */
    KMS_FLIPS = 16,
};

struct kms_connector {
    uint32_t id;
    uint32_t type; /* DRM_MODE_CONNECTOR_* */
    char name[KMS_NAME];
    bool connected;
    bool admitted;      /* a screen for people: no head-mounted display, no writeback */
    bool broken;        /* its link fell below what the mode needs, and wants the mode set again */
    uint32_t crtc;      /* that feeds it now, 0: none */
    uint32_t crtc_mask; /* bits are indices into kms_scan.crtcs */
    int mode_count;
    drmModeModeInfo modes[KMS_MODES];
};

struct kms_scan {
    int connector_count, crtc_count;
    struct kms_connector connectors[KMS_CONNECTORS];
    uint32_t crtcs[KMS_CRTCS];
};

struct kms_plane {
    uint32_t id;
    uint32_t crtc; /* that it is on now, 0: none */
    uint32_t crtc_mask;
    bool primary;
    int modifier_count; /* for XRGB8888 */
    uint64_t modifiers[KMS_MODIFIERS];
};

struct kms_property {
    uint32_t id;
    char name[KMS_NAME];
    uint64_t value;
};

/* One property of an atomic request. */
struct kms_value {
    uint32_t object, property;
    uint64_t value;
    const char *name; /* for messages */
};

struct kms_flip {
    uint64_t token;    /* given with the commit */
    uint32_t sequence; /* of the vertical blank; a driver without a counter says 0 */
    uint64_t time_us;  /* CLOCK_MONOTONIC */
};

/* What a CRTC showed before Frond came. */
struct kms_past {
    uint32_t framebuffer, x, y;
    bool mode_valid;
    drmModeModeInfo mode;
};

struct kms_card;

struct kms_calls {
    /* `probe` looks at the wires anew, which may take tens of milliseconds; else what the kernel knows already. */
    int (*scan)(struct kms_card *card, bool probe, struct kms_scan *scan);
    int (*planes)(struct kms_card *card, struct kms_plane planes[KMS_PLANES], int *count);
    int (*properties)(struct kms_card *card, uint32_t object, uint32_t type,
                      struct kms_property properties[KMS_PROPERTIES], int *count);
    int (*blob)(struct kms_card *card, const void *data, size_t size, uint32_t *id);
    void (*drop_blob)(struct kms_card *card, uint32_t id);
    /* `flags` are DRM_MODE_ATOMIC_* and DRM_MODE_PAGE_FLIP_EVENT. */
    int (*commit)(struct kms_card *card, const struct kms_value *values, int count, uint32_t flags, uint64_t token);
    /* The calls of before atomic mode setting. `mode` NULL: off. */
    int (*set_crtc)(struct kms_card *card, uint32_t crtc, uint32_t framebuffer, uint32_t x, uint32_t y,
                    uint32_t connector, const drmModeModeInfo *mode);
    int (*flip)(struct kms_card *card, uint32_t crtc, uint32_t framebuffer, uint64_t token);
    int (*set_property)(struct kms_card *card, uint32_t connector, uint32_t property, uint64_t value);
    int (*read_crtc)(struct kms_card *card, uint32_t crtc, struct kms_past *past);
    /* ESTALE: not through this opening of the card, but a new one would have it. */
    int (*take_master)(struct kms_card *card);
    /* Flips that have completed since the last call, oldest first. */
    int (*flips)(struct kms_card *card, struct kms_flip flips[KMS_FLIPS], int *count);
};

struct kms_card {
    const struct kms_calls *calls;
    int fd; /* readable when flips() has something; -1: a test's */
    bool atomic;
    bool modifiers;        /* framebuffers may name the modifier of their layout */
    char path[64];         /* "/dev/dri/card1" */
    char driver[KMS_NAME]; /* "vc4" */
};

#endif
