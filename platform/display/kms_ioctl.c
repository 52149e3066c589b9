#include "kms_ioctl.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <drm_fourcc.h>

/* Of the calls of libdrm that say -errno. */
static int reason(int result)
{
    return result < 0 ? -result : 0;
}

static uint64_t property_of(int fd, const uint32_t *ids, const uint64_t *values, int count, const char *name,
                            uint64_t otherwise)
{
    uint64_t value = otherwise;
    for (int i = 0; i < count; i++) {
        drmModePropertyRes *property = drmModeGetProperty(fd, ids[i]);
        if (property && strcmp(property->name, name) == 0) {
            value = values[i];
        }
        drmModeFreeProperty(property);
    }
    return value;
}

static void read_connector(int fd, const drmModeConnector *from, struct kms_connector *to)
{
    *to = (struct kms_connector){.id = from->connector_id, .type = from->connector_type};
    const char *type = drmModeGetConnectorTypeName(from->connector_type);
    snprintf(to->name, sizeof to->name, "%s-%u", type ? type : "Unknown", from->connector_type_id);
    to->connected = from->connection == DRM_MODE_CONNECTED;
    to->admitted = from->connector_type != DRM_MODE_CONNECTOR_WRITEBACK &&
                   property_of(fd, from->props, from->prop_values, from->count_props, "non-desktop", 0) == 0;
    to->broken = property_of(fd, from->props, from->prop_values, from->count_props, "link-status",
                             DRM_MODE_LINK_STATUS_GOOD) == DRM_MODE_LINK_STATUS_BAD;
    for (int i = 0; i < from->count_encoders; i++) {
        drmModeEncoder *encoder = drmModeGetEncoder(fd, from->encoders[i]);
        if (encoder) {
            to->crtc_mask |= encoder->possible_crtcs;
            to->crtc = encoder->encoder_id == from->encoder_id ? encoder->crtc_id : to->crtc;
        }
        drmModeFreeEncoder(encoder);
    }
    to->mode_count = from->count_modes < KMS_MODES ? from->count_modes : KMS_MODES;
    for (int i = 0; i < to->mode_count; i++) {
        to->modes[i] = from->modes[i];
    }
}

/* Of what the last probe found, which connectors are connected now, by sysfs: the ioctl would wait for the kernel's own
 * look at the wires, which takes as long as a probe. False: there is no sysfs. */
static bool look_at_sysfs(struct kms_card *card, struct kms_scan *scan)
{
    struct kms_ioctl_card *device = (struct kms_ioctl_card *)card;
    const char *name = strrchr(card->path, '/');
    for (int i = 0; i < device->last.connector_count; i++) {
        struct kms_connector *connector = &device->last.connectors[i];
        char path[128], status[16] = "";
        snprintf(path, sizeof path, "/sys/class/drm/%s-%s/status", name ? name + 1 : "", connector->name);
        int fd = open(path, O_RDONLY | O_CLOEXEC);
        bool known = fd >= 0 && read(fd, status, sizeof status - 1) > 0;
        if (fd >= 0) {
            close(fd);
        }
        if (!known) {
            return false;
        }
        connector->connected = strcmp(status, "connected\n") == 0;
    }
    *scan = device->last;
    return device->last.connector_count > 0;
}

static int scan_by_ioctl(struct kms_card *card, bool probe, struct kms_scan *scan)
{
    errno = 0;
    drmModeRes *resources = drmModeGetResources(card->fd);
    if (!resources) {
        return errno ? errno : ENODEV;
    }
    scan->connector_count = 0;
    scan->crtc_count = resources->count_crtcs < KMS_CRTCS ? resources->count_crtcs : KMS_CRTCS;
    for (int i = 0; i < scan->crtc_count; i++) {
        scan->crtcs[i] = resources->crtcs[i];
    }
    for (int i = 0; i < resources->count_connectors && scan->connector_count < KMS_CONNECTORS; i++) {
        uint32_t id = resources->connectors[i];
        drmModeConnector *connector =
            probe ? drmModeGetConnector(card->fd, id) : drmModeGetConnectorCurrent(card->fd, id);
        if (connector) {
            read_connector(card->fd, connector, &scan->connectors[scan->connector_count++]);
        }
        drmModeFreeConnector(connector);
    }
    drmModeFreeResources(resources);
    return 0;
}

static int card_scan(struct kms_card *card, bool probe, struct kms_scan *scan)
{
    struct kms_ioctl_card *device = (struct kms_ioctl_card *)card;
    if (!probe && device->probed && look_at_sysfs(card, scan)) {
        return 0;
    }
    int code = scan_by_ioctl(card, probe, scan);
    device->probed = code == 0;
    device->last = *scan;
    return code;
}

static int card_properties(struct kms_card *card, uint32_t object, uint32_t type,
                           struct kms_property properties[KMS_PROPERTIES], int *count)
{
    drmModeObjectProperties *all = drmModeObjectGetProperties(card->fd, object, type);
    if (!all) {
        return errno;
    }
    *count = 0;
    for (uint32_t i = 0; i < all->count_props && *count < KMS_PROPERTIES; i++) {
        drmModePropertyRes *property = drmModeGetProperty(card->fd, all->props[i]);
        if (property) {
            struct kms_property *to = &properties[(*count)++];
            *to = (struct kms_property){.id = property->prop_id, .value = all->prop_values[i]};
            snprintf(to->name, sizeof to->name, "%s", property->name);
        }
        drmModeFreeProperty(property);
    }
    drmModeFreeObjectProperties(all);
    return 0;
}

static void read_modifiers(int fd, uint32_t blob_id, struct kms_plane *plane)
{
    drmModePropertyBlobRes *blob = blob_id ? drmModeGetPropertyBlob(fd, blob_id) : NULL;
    drmModeFormatModifierIterator iterator = {0};
    while (blob && drmModeFormatModifierBlobIterNext(blob, &iterator) && plane->modifier_count < KMS_MODIFIERS) {
        if (iterator.fmt == DRM_FORMAT_XRGB8888 && iterator.mod != DRM_FORMAT_MOD_INVALID) {
            plane->modifiers[plane->modifier_count++] = iterator.mod;
        }
    }
    drmModeFreePropertyBlob(blob);
}

static void read_plane(struct kms_card *card, const drmModePlane *from, struct kms_plane *to)
{
    struct kms_property properties[KMS_PROPERTIES];
    int count = 0;
    *to = (struct kms_plane){.id = from->plane_id, .crtc = from->crtc_id, .crtc_mask = from->possible_crtcs};
    card_properties(card, from->plane_id, DRM_MODE_OBJECT_PLANE, properties, &count);
    for (int i = 0; i < count; i++) {
        if (strcmp(properties[i].name, "type") == 0) {
            to->primary = properties[i].value == DRM_PLANE_TYPE_PRIMARY;
        } else if (strcmp(properties[i].name, "IN_FORMATS") == 0) {
            read_modifiers(card->fd, (uint32_t)properties[i].value, to);
        }
    }
}

static int card_planes(struct kms_card *card, struct kms_plane planes[KMS_PLANES], int *count)
{
    drmModePlaneRes *all = drmModeGetPlaneResources(card->fd);
    if (!all) {
        return errno;
    }
    *count = 0;
    for (uint32_t i = 0; i < all->count_planes && *count < KMS_PLANES; i++) {
        drmModePlane *plane = drmModeGetPlane(card->fd, all->planes[i]);
        if (plane) {
            read_plane(card, plane, &planes[(*count)++]);
        }
        drmModeFreePlane(plane);
    }
    drmModeFreePlaneResources(all);
    return 0;
}

static int card_blob(struct kms_card *card, const void *data, size_t size, uint32_t *id)
{
    return reason(drmModeCreatePropertyBlob(card->fd, data, size, id));
}

static void card_drop_blob(struct kms_card *card, uint32_t id)
{
    drmModeDestroyPropertyBlob(card->fd, id);
}

/* Tokens are counters; on 32 bits they wrap, and are compared as they come back. */
static void *pointer_of(uint64_t token)
{
    return (void *)(uintptr_t)token;
}

static int card_commit(struct kms_card *card, const struct kms_value *values, int count, uint32_t flags, uint64_t token)
{
    drmModeAtomicReq *request = drmModeAtomicAlloc();
    if (!request) {
        return ENOMEM;
    }
    int result = 0;
    for (int i = 0; i < count && result >= 0; i++) {
        result = drmModeAtomicAddProperty(request, values[i].object, values[i].property, values[i].value);
    }
    if (result >= 0) {
        result = drmModeAtomicCommit(card->fd, request, flags, pointer_of(token));
    }
    int code = reason(result);
    drmModeAtomicFree(request);
    return code;
}

static int card_set_crtc(struct kms_card *card, uint32_t crtc, uint32_t framebuffer, uint32_t x, uint32_t y,
                         uint32_t connector, const drmModeModeInfo *mode)
{
    drmModeModeInfo copy = {0};
    if (mode) {
        copy = *mode;
    }
    return reason(drmModeSetCrtc(card->fd, crtc, mode ? framebuffer : 0, x, y, mode ? &connector : NULL, mode ? 1 : 0,
                                 mode ? &copy : NULL));
}

static int card_flip(struct kms_card *card, uint32_t crtc, uint32_t framebuffer, uint64_t token)
{
    return reason(drmModePageFlip(card->fd, crtc, framebuffer, DRM_MODE_PAGE_FLIP_EVENT, pointer_of(token)));
}

static int card_set_property(struct kms_card *card, uint32_t connector, uint32_t property, uint64_t value)
{
    return reason(drmModeConnectorSetProperty(card->fd, connector, property, value));
}

static int card_read_crtc(struct kms_card *card, uint32_t crtc, struct kms_past *past)
{
    drmModeCrtc *now = drmModeGetCrtc(card->fd, crtc);
    if (!now) {
        return errno;
    }
    *past = (struct kms_past){
        .framebuffer = now->buffer_id, .x = now->x, .y = now->y, .mode_valid = now->mode_valid != 0, .mode = now->mode};
    drmModeFreeCrtc(now);
    return 0;
}

/* Without privileges only who opens a card while nobody is master becomes it, or who has been it before. */
static int card_take_master(struct kms_card *card)
{
    if (drmIsMaster(card->fd) || drmSetMaster(card->fd) == 0) {
        return 0;
    }
    if (errno != EACCES) {
        return errno;
    }
    int again = open(card->path, O_RDWR | O_CLOEXEC);
    bool free = again >= 0 && drmIsMaster(again);
    if (again >= 0) {
        close(again);
    }
    return free ? ESTALE : EACCES;
}

static int card_flips(struct kms_card *card, struct kms_flip flips[KMS_FLIPS], int *count)
{
    /* Read here and not by drmHandleEvent: its handlers are told microseconds and a pointer that say less. */
    char bytes[KMS_FLIPS * sizeof(struct drm_event_vblank)] __attribute__((aligned(8)));
    *count = 0;
    ssize_t size = read(card->fd, bytes, sizeof bytes);
    if (size < 0) {
        return errno == EAGAIN || errno == EINTR ? 0 : errno;
    }
    for (size_t at = 0; at + sizeof(struct drm_event) <= (size_t)size && *count < KMS_FLIPS;) {
        struct drm_event_vblank event = {0};
        memcpy(&event.base, bytes + at, sizeof event.base);
        if (event.base.length < sizeof event.base || at + event.base.length > (size_t)size) {
            break;
        }
        if (event.base.type == DRM_EVENT_FLIP_COMPLETE && event.base.length >= sizeof event) {
            memcpy(&event, bytes + at, sizeof event);
            flips[(*count)++] = (struct kms_flip){.token = event.user_data,
                                                  .sequence = event.sequence,
                                                  .time_us = (uint64_t)event.tv_sec * 1000000u + event.tv_usec};
        }
        at += event.base.length;
    }
    return 0;
}

const struct kms_calls kms_ioctl_calls = {
    .scan = card_scan,
    .planes = card_planes,
    .properties = card_properties,
    .blob = card_blob,
    .drop_blob = card_drop_blob,
    .commit = card_commit,
    .set_crtc = card_set_crtc,
    .flip = card_flip,
    .set_property = card_set_property,
    .read_crtc = card_read_crtc,
    .take_master = card_take_master,
    .flips = card_flips,
};
