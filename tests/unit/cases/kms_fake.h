/* A card that exists in memory: a kernel's mode setting as far as Frond uses it, with wires to pull and faults to make.
 */
#ifndef FROND_KMS_FAKE_H
#define FROND_KMS_FAKE_H

#include "kms_calls.h"

enum { FAKE_CRTC = 40, FAKE_CRTC_OTHER = 41, FAKE_PLANE = 50, FAKE_PLANE_OTHER = 51, FAKE_OVERLAY = 52 };
enum { FAKE_HDMI_1 = 30, FAKE_HDMI_2 = 31, FAKE_DSI = 32 };
enum {
    FAKE_CONNECTOR_CRTC = 100,
    FAKE_LINK_STATUS,
    FAKE_DPMS,
    FAKE_MODE_ID,
    FAKE_ACTIVE,
    FAKE_PLANE_PROPERTIES /* FB_ID, CRTC_ID, SRC_X ... in the order of kms_fake.c */
};

struct fake {
    struct kms_card card;
    struct kms_scan wires; /* what is plugged in; the kernel learns of modes by probing */
    struct kms_scan known;
    bool master, other_master;
    bool outsider; /* may not become master again */
    bool pending;  /* a flip is on its way */
    uint64_t token;
    struct kms_flip done[KMS_FLIPS];
    int done_count;
    uint32_t sequence;
    bool counts; /* vertical blanks */
    bool overlay_shown;

    /* What the hardware does. */
    bool active;
    uint32_t connector, framebuffer, width, height, dpms;
    int blobs;

    /* Faults. */
    uint32_t refused_property; /* 0: none */
    uint32_t refused_width;    /* modes of this width are refused */
    int fail_flips;            /* errno value of the next plain flip, once */
    bool broken;               /* every call fails with ENODEV */
    bool lacks;                /* the plane has no property SRC_W */

    int tests, modesets, flips, probes, restored, denied, link_trained;
};

void fake_init(struct fake *fake);
/* Index of the connector in wires. One mode, or two: the first is preferred. */
void fake_plug(struct fake *fake, int index, int width, int height, int hertz);
void fake_add_mode(struct fake *fake, int index, int width, int height, int hertz, uint32_t flags, uint32_t type);
void fake_unplug(struct fake *fake, int index);
/* The vertical blank at which a pending flip is done. */
void fake_blank(struct fake *fake, uint64_t time_us);
drmModeModeInfo fake_mode(int width, int height, int hertz, uint32_t flags, uint32_t type);

#endif
