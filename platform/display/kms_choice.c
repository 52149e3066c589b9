#include "kms_choice.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int kms_mode_refresh_mhz(const drmModeModeInfo *mode)
{
    uint64_t pixels = (uint64_t)mode->htotal * mode->vtotal;
    if (pixels == 0) {
        return (int)mode->vrefresh * 1000;
    }
    uint64_t mhz_of_clock = (uint64_t)mode->clock * 1000000; /* the clock is in kHz */
    if (mode->flags & DRM_MODE_FLAG_INTERLACE) {
        mhz_of_clock *= 2;
    }
    if (mode->flags & DRM_MODE_FLAG_DBLSCAN) {
        pixels *= 2;
    }
    if (mode->vscan > 1) {
        pixels *= mode->vscan;
    }
    return (int)((mhz_of_clock + pixels / 2) / pixels);
}

bool kms_mode_same(const drmModeModeInfo *a, const drmModeModeInfo *b)
{
    return a->clock == b->clock && a->hdisplay == b->hdisplay && a->hsync_start == b->hsync_start &&
           a->hsync_end == b->hsync_end && a->htotal == b->htotal && a->vdisplay == b->vdisplay &&
           a->vsync_start == b->vsync_start && a->vsync_end == b->vsync_end && a->vtotal == b->vtotal &&
           a->vscan == b->vscan && a->flags == b->flags;
}

void kms_mode_text(const drmModeModeInfo *mode, char text[KMS_MODE_TEXT])
{
    int hundredths = (kms_mode_refresh_mhz(mode) + 5) / 10;
    const char *fields = mode->flags & DRM_MODE_FLAG_INTERLACE ? "i" : "";
    int used = snprintf(text, KMS_MODE_TEXT, "%ux%u%s@%d", mode->hdisplay, mode->vdisplay, fields, hundredths / 100);
    if (hundredths % 100 != 0) {
        snprintf(text + used, KMS_MODE_TEXT - (size_t)used, ".%02d", hundredths % 100);
    }
}

static bool wished_for(const drmModeModeInfo *mode, const struct kms_wish *wish)
{
    return (wish->width == 0 || wish->width == mode->hdisplay) &&
           (wish->height == 0 || wish->height == mode->vdisplay) &&
           (wish->refresh_mhz == 0 || abs(kms_mode_refresh_mhz(mode) - wish->refresh_mhz) <= KMS_NEAR_MHZ);
}

/* Larger is better; compared field by field from the first. */
struct merit {
    long of[5];
};

static struct merit merit_of(const drmModeModeInfo *mode, const drmModeModeInfo *preferred, const struct kms_wish *wish)
{
    bool sized = preferred && mode->hdisplay == preferred->hdisplay && mode->vdisplay == preferred->vdisplay;
    int refresh_mhz = wish->refresh_mhz ? wish->refresh_mhz : 60000;
    return (struct merit){{
        !(mode->flags & DRM_MODE_FLAG_INTERLACE),
        sized,
        (long)mode->hdisplay * mode->vdisplay,
        wish->refresh_mhz == 0 && (mode->type & DRM_MODE_TYPE_PREFERRED),
        -labs((long)kms_mode_refresh_mhz(mode) - refresh_mhz),
    }};
}

static bool better(struct merit a, struct merit b)
{
    for (size_t i = 0; i < sizeof a.of / sizeof a.of[0]; i++) {
        if (a.of[i] != b.of[i]) {
            return a.of[i] > b.of[i];
        }
    }
    return false;
}

int kms_choose_mode(const struct kms_connector *connector, const struct kms_wish *wish, const bool *refused)
{
    const drmModeModeInfo *preferred = NULL;
    for (int i = 0; i < connector->mode_count && !preferred; i++) {
        if (connector->modes[i].type & DRM_MODE_TYPE_PREFERRED) {
            preferred = &connector->modes[i];
        }
    }
    int best = -1;
    struct merit merit = {{0}};
    for (int i = 0; i < connector->mode_count; i++) {
        if ((refused && refused[i]) || !wished_for(&connector->modes[i], wish)) {
            continue;
        }
        struct merit other = merit_of(&connector->modes[i], preferred, wish);
        if (best < 0 || better(other, merit)) {
            best = i;
            merit = other;
        }
    }
    return best;
}

enum { RANKS = 9 };

/* 1.., larger is taken first. */
static int rank(uint32_t type)
{
    switch (type) {
    case DRM_MODE_CONNECTOR_HDMIA:
    case DRM_MODE_CONNECTOR_HDMIB:
        return RANKS;
    case DRM_MODE_CONNECTOR_DisplayPort:
        return 8;
    case DRM_MODE_CONNECTOR_DVII:
    case DRM_MODE_CONNECTOR_DVID:
    case DRM_MODE_CONNECTOR_DVIA:
        return 7;
    case DRM_MODE_CONNECTOR_VGA:
        return 6;
    case DRM_MODE_CONNECTOR_DSI:
        return 5;
    case DRM_MODE_CONNECTOR_LVDS:
        return 4;
    case DRM_MODE_CONNECTOR_eDP:
        return 3;
    case DRM_MODE_CONNECTOR_DPI:
        return 2;
    default:
        return 1;
    }
}

static bool named(const struct kms_connector *connector, const struct kms_wish *wish)
{
    return !wish->connector || strcmp(wish->connector, connector->name) == 0;
}

int kms_choose_connector(const struct kms_scan *scan, const struct kms_wish *wish, uint32_t present)
{
    int best = -1;
    for (int i = 0; i < scan->connector_count; i++) {
        const struct kms_connector *connector = &scan->connectors[i];
        if (!connector->connected || connector->mode_count == 0 || !named(connector, wish) ||
            !(connector->admitted || wish->connector)) {
            continue;
        }
        if (connector->id == present) {
            return i;
        }
        if (best < 0 || rank(connector->type) > rank(scan->connectors[best].type)) {
            best = i;
        }
    }
    return best;
}

int kms_card_score(const struct kms_scan *scan, const struct kms_wish *wish)
{
    int best = 0;
    for (int i = 0; i < scan->connector_count; i++) {
        const struct kms_connector *connector = &scan->connectors[i];
        if (!named(connector, wish) || !(connector->admitted || wish->connector)) {
            continue;
        }
        int score = rank(connector->type) + (connector->connected && connector->mode_count > 0 ? RANKS : 0);
        best = score > best ? score : best;
    }
    return best;
}

void kms_connector_names(const struct kms_scan *scan, char *names, size_t size)
{
    size_t used = 0;
    names[0] = '\0';
    for (int i = 0; i < scan->connector_count && used < size; i++) {
        int wrote = snprintf(names + used, size - used, "%s%s", i ? ", " : "", scan->connectors[i].name);
        used += wrote > 0 ? (size_t)wrote : 0;
    }
}

int kms_crtc_index(const struct kms_scan *scan, uint32_t crtc)
{
    for (int i = 0; i < scan->crtc_count; i++) {
        if (scan->crtcs[i] == crtc) {
            return i;
        }
    }
    return -1;
}

uint32_t kms_choose_crtc(const struct kms_scan *scan, const struct kms_connector *connector)
{
    if (connector->crtc && kms_crtc_index(scan, connector->crtc) >= 0) {
        return connector->crtc;
    }
    for (int busy = 0; busy < 2; busy++) { /* one that feeds no other screen, else any */
        for (int i = 0; i < scan->crtc_count; i++) {
            bool feeds = false;
            for (int other = 0; other < scan->connector_count; other++) {
                feeds = feeds || scan->connectors[other].crtc == scan->crtcs[i];
            }
            if ((connector->crtc_mask >> i & 1) && (busy || !feeds)) {
                return scan->crtcs[i];
            }
        }
    }
    return 0;
}
