#include "kms_fake.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static const char *const PLANE[] = {"FB_ID",  "CRTC_ID", "SRC_X",  "SRC_Y",  "SRC_W",   "SRC_H",
                                    "CRTC_X", "CRTC_Y",  "CRTC_W", "CRTC_H", "rotation"};
enum { PLANE_COUNT = sizeof PLANE / sizeof PLANE[0] };

static struct fake *fake_of(struct kms_card *card)
{
    return (struct fake *)card;
}

drmModeModeInfo fake_mode(int width, int height, int hertz, uint32_t flags, uint32_t type)
{
    drmModeModeInfo mode = {.hdisplay = (uint16_t)width,
                            .vdisplay = (uint16_t)height,
                            .htotal = (uint16_t)(width + 200),
                            .vtotal = (uint16_t)(height + 50),
                            .vrefresh = (uint32_t)hertz,
                            .flags = flags,
                            .type = type};
    mode.clock = (uint32_t)(((uint64_t)mode.htotal * mode.vtotal * (uint64_t)hertz + 500) / 1000);
    return mode;
}

static int fake_scan(struct kms_card *card, bool probe, struct kms_scan *scan)
{
    struct fake *fake = fake_of(card);
    if (fake->broken) {
        return ENODEV;
    }
    if (probe && fake->master) { /* others are told what is known */
        fake->known = fake->wires;
        fake->probes++;
    }
    for (int i = 0; i < fake->wires.connector_count; i++) {
        struct kms_connector *known = &fake->known.connectors[i];
        known->connected = fake->wires.connectors[i].connected;
        known->crtc = fake->active && fake->connector == known->id ? FAKE_CRTC : fake->wires.connectors[i].crtc;
    }
    *scan = fake->known;
    return 0;
}

static int fake_planes(struct kms_card *card, struct kms_plane planes[KMS_PLANES], int *count)
{
    planes[0] = (struct kms_plane){.id = FAKE_OVERLAY, .crtc_mask = 3};
    planes[0].crtc = fake_of(card)->overlay_shown ? FAKE_CRTC : 0;
    planes[1] = (struct kms_plane){.id = FAKE_PLANE_OTHER, .crtc_mask = 2, .primary = true};
    planes[2] = (struct kms_plane){.id = FAKE_PLANE, .crtc_mask = 1, .primary = true};
    *count = 3;
    return 0;
}

static void add(struct kms_property *properties, int *count, uint32_t id, const char *name)
{
    properties[*count] = (struct kms_property){.id = id};
    snprintf(properties[*count].name, KMS_NAME, "%s", name);
    ++*count;
}

static int fake_properties(struct kms_card *card, uint32_t object, uint32_t type,
                           struct kms_property properties[KMS_PROPERTIES], int *count)
{
    (void)object;
    *count = 0;
    if (type == DRM_MODE_OBJECT_CONNECTOR) {
        add(properties, count, FAKE_DPMS, "DPMS");
        add(properties, count, FAKE_LINK_STATUS, "link-status");
        if (card->atomic) {
            add(properties, count, FAKE_CONNECTOR_CRTC, "CRTC_ID");
        }
    } else if (type == DRM_MODE_OBJECT_CRTC) {
        add(properties, count, FAKE_ACTIVE, "ACTIVE");
        add(properties, count, FAKE_MODE_ID, "MODE_ID");
    } else {
        for (int i = 0; i < PLANE_COUNT; i++) {
            if (!(fake_of(card)->lacks && strcmp(PLANE[i], "SRC_W") == 0)) {
                add(properties, count, FAKE_PLANE_PROPERTIES + (uint32_t)i, PLANE[i]);
            }
        }
    }
    return 0;
}

/* The mode itself is its blob's id: width and height. */
static int fake_blob(struct kms_card *card, const void *data, size_t size, uint32_t *id)
{
    const drmModeModeInfo *mode = data;
    fake_of(card)->blobs++;
    *id = (uint32_t)mode->hdisplay << 16 | mode->vdisplay;
    return size == sizeof *mode ? 0 : EINVAL;
}

static void fake_drop_blob(struct kms_card *card, uint32_t id)
{
    (void)id;
    fake_of(card)->blobs--;
}

static const uint64_t *find(const struct kms_value *values, int count, uint32_t object, uint32_t property)
{
    for (int i = 0; i < count; i++) {
        if (values[i].object == object && values[i].property == property) {
            return &values[i].value;
        }
    }
    return NULL;
}

static uint64_t plane_value(const struct kms_value *values, int count, const char *name, uint64_t otherwise)
{
    for (uint32_t i = 0; i < PLANE_COUNT; i++) {
        const uint64_t *value = find(values, count, FAKE_PLANE, FAKE_PLANE_PROPERTIES + i);
        if (value && strcmp(PLANE[i], name) == 0) {
            return *value;
        }
    }
    return otherwise;
}

/* What a kernel refuses of a request that sets a mode. */
static int check(const struct fake *fake, const struct kms_value *values, int count)
{
    for (int i = 0; i < count; i++) {
        if (values[i].property == fake->refused_property) {
            return EINVAL;
        }
    }
    const uint64_t *mode = find(values, count, FAKE_CRTC, FAKE_MODE_ID);
    if (!mode || *mode == 0) {
        return 0;
    }
    uint64_t width = *mode >> 16, height = *mode & 0xffff;
    if (width == fake->refused_width) {
        return EINVAL;
    }
    if (plane_value(values, count, "FB_ID", 1) == 0 || plane_value(values, count, "CRTC_W", width) != width ||
        plane_value(values, count, "SRC_W", width << 16) != width << 16 ||
        plane_value(values, count, "CRTC_H", height) != height ||
        plane_value(values, count, "SRC_H", height << 16) != height << 16) {
        return EINVAL;
    }
    for (int i = 0; i < fake->wires.connector_count; i++) { /* none of them can be cloned */
        const struct kms_connector *other = &fake->wires.connectors[i];
        if (other->crtc == FAKE_CRTC && !find(values, count, other->id, FAKE_CONNECTOR_CRTC)) {
            return EINVAL;
        }
    }
    return fake->overlay_shown && !find(values, count, FAKE_OVERLAY, FAKE_PLANE_PROPERTIES) ? EINVAL : 0;
}

static void apply(struct fake *fake, const struct kms_value *values, int count)
{
    static const uint32_t CONNECTORS[] = {FAKE_HDMI_1, FAKE_HDMI_2, FAKE_DSI};
    const uint64_t *mode = find(values, count, FAKE_CRTC, FAKE_MODE_ID);
    const uint64_t *active = find(values, count, FAKE_CRTC, FAKE_ACTIVE);
    fake->framebuffer = (uint32_t)plane_value(values, count, "FB_ID", fake->framebuffer);
    for (size_t i = 0; i < 3; i++) {
        const uint64_t *crtc = find(values, count, CONNECTORS[i], FAKE_CONNECTOR_CRTC);
        fake->connector = !crtc                              ? fake->connector
                          : *crtc                            ? CONNECTORS[i]
                          : fake->connector == CONNECTORS[i] ? 0
                                                             : fake->connector;
        if (crtc) {
            fake->wires.connectors[i == 2 ? 0 : i + 1].crtc = 0;
        }
        fake->link_trained += find(values, count, CONNECTORS[i], FAKE_LINK_STATUS) != NULL;
    }
    if (find(values, count, FAKE_OVERLAY, FAKE_PLANE_PROPERTIES)) {
        fake->overlay_shown = false;
    }
    if (mode) {
        fake->width = (uint32_t)*mode >> 16;
        fake->height = (uint32_t)*mode & 0xffff;
    }
    fake->active = active ? *active != 0 : fake->active;
}

static int fake_commit(struct kms_card *card, const struct kms_value *values, int count, uint32_t flags, uint64_t token)
{
    struct fake *fake = fake_of(card);
    bool sets = find(values, count, FAKE_CRTC, FAKE_ACTIVE) != NULL, tests = flags & DRM_MODE_ATOMIC_TEST_ONLY;
    if (fake->broken) {
        return ENODEV;
    }
    if (!fake->master) {
        return EACCES;
    }
    fake->tests += tests;
    int code = check(fake, values, count);
    if (code != 0 || tests) {
        return code;
    }
    if (sets && !(flags & DRM_MODE_ATOMIC_ALLOW_MODESET)) {
        return EINVAL;
    }
    if (!sets && (!fake->active || fake->fail_flips)) {
        code = fake->fail_flips ? fake->fail_flips : EINVAL;
        fake->fail_flips = 0;
        return code;
    }
    if (fake->pending && (flags & DRM_MODE_ATOMIC_NONBLOCK)) {
        return EBUSY;
    }
    fake->pending = flags & DRM_MODE_PAGE_FLIP_EVENT;
    fake->token = token;
    fake->modesets += sets;
    fake->flips += !sets;
    apply(fake, values, count);
    return 0;
}

static int fake_set_crtc(struct kms_card *card, uint32_t crtc, uint32_t framebuffer, uint32_t x, uint32_t y,
                         uint32_t connector, const drmModeModeInfo *mode)
{
    struct fake *fake = fake_of(card);
    if (!fake->master || crtc != FAKE_CRTC) {
        fake->denied += !fake->master;
        return fake->master ? EINVAL : EACCES;
    }
    if (mode && mode->hdisplay == fake->refused_width) {
        return EINVAL;
    }
    fake->modesets++;
    fake->restored += mode && framebuffer == 7 && x == 3 && y == 4;
    fake->active = mode != NULL;
    fake->framebuffer = framebuffer;
    fake->connector = mode ? connector : 0;
    fake->width = mode ? mode->hdisplay : 0;
    return 0;
}

static int fake_flip(struct kms_card *card, uint32_t crtc, uint32_t framebuffer, uint64_t token)
{
    struct fake *fake = fake_of(card);
    if (!fake->master || fake->pending) {
        return fake->master ? EBUSY : EACCES;
    }
    fake->flips++;
    fake->framebuffer = framebuffer;
    fake->pending = crtc == FAKE_CRTC;
    fake->token = token;
    return 0;
}

static int fake_set_property(struct kms_card *card, uint32_t connector, uint32_t property, uint64_t value)
{
    (void)connector;
    if (property == FAKE_DPMS) {
        fake_of(card)->dpms = (uint32_t)value;
    }
    return fake_of(card)->master ? 0 : EACCES;
}

static int fake_read_crtc(struct kms_card *card, uint32_t crtc, struct kms_past *past)
{
    (void)card;
    *past = (struct kms_past){.framebuffer = 7, .x = 3, .y = 4, .mode_valid = crtc == FAKE_CRTC};
    past->mode = fake_mode(640, 480, 60, 0, 0);
    return 0;
}

static int fake_take_master(struct kms_card *card)
{
    struct fake *fake = fake_of(card);
    if (fake->outsider && !fake->master) {
        return fake->other_master ? EACCES : ESTALE;
    }
    fake->master = fake->master || !fake->other_master;
    return fake->master ? 0 : EBUSY;
}

static int fake_flips(struct kms_card *card, struct kms_flip flips[KMS_FLIPS], int *count)
{
    struct fake *fake = fake_of(card);
    memcpy(flips, fake->done, sizeof fake->done);
    *count = fake->done_count;
    fake->done_count = 0;
    return 0;
}

static const struct kms_calls CALLS = {
    .scan = fake_scan,
    .planes = fake_planes,
    .properties = fake_properties,
    .blob = fake_blob,
    .drop_blob = fake_drop_blob,
    .commit = fake_commit,
    .set_crtc = fake_set_crtc,
    .flip = fake_flip,
    .set_property = fake_set_property,
    .read_crtc = fake_read_crtc,
    .take_master = fake_take_master,
    .flips = fake_flips,
};

void fake_init(struct fake *fake)
{
    static const struct {
        uint32_t id, type;
        const char *name;
    } CONNECTORS[] = {{FAKE_DSI, DRM_MODE_CONNECTOR_DSI, "DSI-1"},
                      {FAKE_HDMI_1, DRM_MODE_CONNECTOR_HDMIA, "HDMI-A-1"},
                      {FAKE_HDMI_2, DRM_MODE_CONNECTOR_HDMIA, "HDMI-A-2"}};
    memset(fake, 0, sizeof *fake);
    fake->card = (struct kms_card){.calls = &CALLS, .fd = -1, .atomic = true, .path = "fake", .driver = "fake"};
    fake->wires.connector_count = 3;
    for (int i = 0; i < 3; i++) {
        struct kms_connector *connector = &fake->wires.connectors[i];
        *connector = (struct kms_connector){
            .id = CONNECTORS[i].id, .type = CONNECTORS[i].type, .admitted = true, .crtc_mask = 1};
        snprintf(connector->name, KMS_NAME, "%s", CONNECTORS[i].name);
    }
    fake->wires.crtc_count = 2;
    fake->wires.crtcs[0] = FAKE_CRTC;
    fake->wires.crtcs[1] = FAKE_CRTC_OTHER;
    fake->known = fake->wires;
    fake->counts = true;
}

void fake_add_mode(struct fake *fake, int index, int width, int height, int hertz, uint32_t flags, uint32_t type)
{
    struct kms_connector *connector = &fake->wires.connectors[index];
    connector->modes[connector->mode_count++] = fake_mode(width, height, hertz, flags, type);
}

void fake_plug(struct fake *fake, int index, int width, int height, int hertz)
{
    fake->wires.connectors[index].connected = true;
    fake->wires.connectors[index].mode_count = 0;
    fake_add_mode(fake, index, width, height, hertz, 0, DRM_MODE_TYPE_PREFERRED);
}

void fake_unplug(struct fake *fake, int index)
{
    fake->wires.connectors[index].connected = false;
    fake->wires.connectors[index].mode_count = 0;
}

void fake_blank(struct fake *fake, uint64_t time_us)
{
    fake->sequence++;
    if (fake->pending && fake->done_count < KMS_FLIPS) {
        fake->done[fake->done_count++] =
            (struct kms_flip){.token = fake->token, .sequence = fake->counts ? fake->sequence : 0, .time_us = time_us};
        fake->pending = false;
    }
}
