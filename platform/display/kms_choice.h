/* Which card, connector and mode: decided from lists, without a device. */
#ifndef FROND_KMS_CHOICE_H
#define FROND_KMS_CHOICE_H

#include "kms_calls.h"

struct kms_wish {
    const char *connector; /* NULL: any */
    int width, height;     /* 0: any */
    int refresh_mhz;       /* 0: any; else within KMS_NEAR_MHZ */
};

enum { KMS_NEAR_MHZ = 500 }; /* so that 60 Hz also finds 59.94 */

enum { KMS_MODE_TEXT = 32 };

/* From the clock and the totals (VESA): thousandths of a hertz, of fields where interlaced. */
int kms_mode_refresh_mhz(const drmModeModeInfo *mode);
bool kms_mode_same(const drmModeModeInfo *a, const drmModeModeInfo *b);
/* "1920x1080@60", "1920x1080i@59.94" */
void kms_mode_text(const drmModeModeInfo *mode, char text[KMS_MODE_TEXT]);

/* Index of the mode to set, -1: none is as wished for. A whole frame before fields; the size that the screen prefers,
 * or its largest where it prefers none; of these the preferred mode, then the nearest to 60 Hz. `refused` has a flag
 * for every mode that has been tried in vain; NULL: none. */
int kms_choose_mode(const struct kms_connector *connector, const struct kms_wish *wish, const bool *refused);

/* Index of the connector to use, -1: none. A wish for a name takes only that. Else of those connected, with modes and
 * for people: the one whose id is `present`, so that a screen plugged in later does not draw the picture away; then
 * HDMI, DisplayPort, DVI, VGA, then panels that are built in (DSI, LVDS, eDP, DPI), then the others; the first of its
 * kind. */
int kms_choose_connector(const struct kms_scan *scan, const struct kms_wish *wish, uint32_t present);

/* How well a card serves: 0 has no connector that the wish admits. A connected one before one that is not, then in the
 * order of kms_choose_connector. */
int kms_card_score(const struct kms_scan *scan, const struct kms_wish *wish);

/* The CRTC that feeds the connector already, else one that can, of those first one that feeds no other; 0: none. */
uint32_t kms_choose_crtc(const struct kms_scan *scan, const struct kms_connector *connector);
/* "HDMI-A-1, HDMI-A-2" */
void kms_connector_names(const struct kms_scan *scan, char *names, size_t size);
int kms_crtc_index(const struct kms_scan *scan, uint32_t crtc); /* -1: no such */

#endif
