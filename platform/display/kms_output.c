#include "kms_output.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "display_source.h"
#include "kms_choice.h"

enum { TESTED = DRM_MODE_ATOMIC_TEST_ONLY | DRM_MODE_ATOMIC_ALLOW_MODESET };

struct request {
    int count;
    struct kms_value values[KMS_VALUES];
};

static void put(struct request *request, uint32_t object, uint32_t property, const char *name, uint64_t value)
{
    if (property != 0 && request->count < KMS_VALUES) {
        request->values[request->count++] = (struct kms_value){object, property, value, name};
    }
}

/* Where the id of a property with a name goes. */
struct slot {
    const char *name;
    uint32_t *id;
    bool needed;
};

static bool look_up(struct kms_card *card, uint32_t object, uint32_t type, const char *what, const struct slot *slots,
                    int slot_count, struct device_error *error)
{
    struct kms_property properties[KMS_PROPERTIES];
    int count = 0;
    int code = card->calls->properties(card, object, type, properties, &count);
    if (code != 0) {
        return device_fail(error, "the properties of the %s cannot be read: %s", what, strerror(code));
    }
    for (int i = 0; i < slot_count; i++) {
        *slots[i].id = 0;
        for (int j = 0; j < count; j++) {
            if (strcmp(slots[i].name, properties[j].name) == 0) {
                *slots[i].id = properties[j].id;
            }
        }
        if (slots[i].needed && *slots[i].id == 0) {
            return device_fail(error, "the %s has no property %s", what, slots[i].name);
        }
    }
    return true;
}

#define LOOK_UP(card, object, type, what, slots, error)                                                                \
    look_up(card, object, type, what, slots, (int)(sizeof(slots) / sizeof((slots)[0])), error)

static bool look_up_all(struct kms_output *output, struct kms_card *card, struct device_error *error)
{
    struct kms_plane_properties *on = &output->on;
    const struct slot connector[] = {{"CRTC_ID", &output->crtc_id, card->atomic},
                                     {"link-status", &output->link_status, false},
                                     {"DPMS", &output->dpms, false}};
    const struct slot crtc[] = {{"MODE_ID", &output->mode_id, true}, {"ACTIVE", &output->active, true}};
    const struct slot plane[] = {
        {"FB_ID", &on->framebuffer, true}, {"CRTC_ID", &on->crtc, true},      {"SRC_X", &on->src_x, true},
        {"SRC_Y", &on->src_y, true},       {"SRC_W", &on->src_w, true},       {"SRC_H", &on->src_h, true},
        {"CRTC_X", &on->crtc_x, true},     {"CRTC_Y", &on->crtc_y, true},     {"CRTC_W", &on->crtc_w, true},
        {"CRTC_H", &on->crtc_h, true},     {"rotation", &on->rotation, false}};
    if (!LOOK_UP(card, output->connector, DRM_MODE_OBJECT_CONNECTOR, "connector", connector, error)) {
        return false;
    }
    return !card->atomic || (LOOK_UP(card, output->crtc, DRM_MODE_OBJECT_CRTC, "CRTC", crtc, error) &&
                             LOOK_UP(card, output->plane, DRM_MODE_OBJECT_PLANE, "plane", plane, error));
}

static void add_stray(struct kms_output *output, uint32_t object, uint32_t property, const char *name)
{
    if (property != 0 && output->stray_count < (int)(sizeof output->strays / sizeof output->strays[0])) {
        output->strays[output->stray_count++] = (struct kms_value){object, property, 0, name};
    }
}

/* Of the primary planes that the CRTC can have: the one it has, then a free one, then any. */
static bool choose_plane(struct kms_output *output, struct kms_card *card, const struct kms_scan *scan,
                         struct device_error *error)
{
    struct kms_plane planes[KMS_PLANES];
    int count = 0, best = 0, code = card->calls->planes(card, planes, &count);
    if (code != 0) {
        return !card->atomic || device_fail(error, "the planes cannot be read: %s", strerror(code));
    }
    int index = kms_crtc_index(scan, output->crtc);
    for (int i = 0; i < count; i++) {
        bool fits = planes[i].primary && index >= 0 && (planes[i].crtc_mask >> index & 1);
        int merit = !fits ? 0 : planes[i].crtc == output->crtc ? 3 : planes[i].crtc == 0 ? 2 : 1;
        if (merit > best) {
            best = merit;
            output->plane = planes[i].id;
            output->shape = planes[i];
        }
    }
    if (output->plane == 0 && card->atomic) {
        return device_fail(error, "the CRTC has no primary plane");
    }
    return true;
}

/* Planes left on the CRTC by who had the screen before. */
static void find_stray_planes(struct kms_output *output, struct kms_card *card)
{
    struct kms_plane planes[KMS_PLANES];
    int count = 0;
    if (card->calls->planes(card, planes, &count) != 0) {
        return;
    }
    for (int i = 0; i < count; i++) {
        if (planes[i].crtc == output->crtc && planes[i].id != output->plane) {
            add_stray(output, planes[i].id, output->on.framebuffer, "FB_ID");
            add_stray(output, planes[i].id, output->on.crtc, "CRTC_ID");
        }
    }
}

static void find_stray_connectors(struct kms_output *output, const struct kms_scan *scan)
{
    for (int i = 0; i < scan->connector_count; i++) {
        const struct kms_connector *connector = &scan->connectors[i];
        if (connector->crtc == output->crtc && connector->id != output->connector) {
            add_stray(output, connector->id, output->crtc_id, "CRTC_ID");
        }
    }
}

bool kms_output_open(struct kms_output *output, struct kms_card *card, const struct kms_scan *scan,
                     const struct kms_connector *connector, uint32_t crtc, const drmModeModeInfo *mode,
                     struct device_error *error)
{
    struct device_error why = {""};
    char text[KMS_MODE_TEXT];
    *output = (struct kms_output){.connector = connector->id, .crtc = crtc, .mode = *mode};
    memcpy(output->name, connector->name, sizeof output->name);
    kms_mode_text(mode, text);
    if (!choose_plane(output, card, scan, &why) || !look_up_all(output, card, &why)) {
        return device_fail(error, "%s %s: %s", output->name, text, why.text);
    }
    if (card->atomic) {
        find_stray_planes(output, card);
        find_stray_connectors(output, scan);
        int code = card->calls->blob(card, mode, sizeof *mode, &output->mode_blob);
        if (code != 0) {
            return device_fail(error, "%s %s: the kernel does not take the mode: %s", output->name, text,
                               strerror(code));
        }
    }
    return true;
}

void kms_output_close(struct kms_output *output, struct kms_card *card)
{
    if (output->mode_blob != 0) {
        card->calls->drop_blob(card, output->mode_blob);
    }
    *output = (struct kms_output){.connector = 0};
}

/* The parts of a request that an error may be traced to stand first. */
static void put_plane(struct request *request, const struct kms_output *output, uint32_t framebuffer)
{
    const struct kms_plane_properties *on = &output->on;
    uint64_t width = output->mode.hdisplay, height = output->mode.vdisplay;
    put(request, output->plane, on->framebuffer, "FB_ID", framebuffer);
    put(request, output->plane, on->crtc, "CRTC_ID", output->crtc);
    put(request, output->plane, on->src_x, "SRC_X", 0);
    put(request, output->plane, on->src_y, "SRC_Y", 0);
    put(request, output->plane, on->src_w, "SRC_W", width << 16);
    put(request, output->plane, on->src_h, "SRC_H", height << 16);
    put(request, output->plane, on->crtc_x, "CRTC_X", 0);
    put(request, output->plane, on->crtc_y, "CRTC_Y", 0);
    put(request, output->plane, on->crtc_w, "CRTC_W", width);
    put(request, output->plane, on->crtc_h, "CRTC_H", height);
    put(request, output->plane, on->rotation, "rotation", DRM_MODE_ROTATE_0);
}

static void put_mode(struct request *request, const struct kms_output *output)
{
    put(request, output->connector, output->link_status, "link-status", DRM_MODE_LINK_STATUS_GOOD);
    put(request, output->crtc, output->mode_id, "MODE_ID", output->mode_blob);
    put(request, output->crtc, output->active, "ACTIVE", 1);
    put(request, output->connector, output->crtc_id, "CRTC_ID", output->crtc);
    for (int i = 0; i < output->stray_count && request->count < KMS_VALUES; i++) {
        request->values[request->count++] = output->strays[i];
    }
}

static int commit(struct kms_card *card, const struct request *request, uint32_t flags, uint64_t token)
{
    return card->calls->commit(card, request->values, request->count, flags, token);
}

int kms_output_test(const struct kms_output *output, struct kms_card *card, uint32_t framebuffer)
{
    if (!card->atomic) {
        return 0;
    }
    struct request request = {0};
    put_plane(&request, output, framebuffer);
    put_mode(&request, output);
    return commit(card, &request, TESTED, 0);
}

int kms_output_set(const struct kms_output *output, struct kms_card *card, uint32_t framebuffer, uint64_t token,
                   bool *flips)
{
    *flips = card->atomic;
    if (!card->atomic) {
        if (output->dpms) {
            card->calls->set_property(card, output->connector, output->dpms, DRM_MODE_DPMS_ON);
        }
        return card->calls->set_crtc(card, output->crtc, framebuffer, 0, 0, output->connector, &output->mode);
    }
    struct request request = {0};
    put_plane(&request, output, framebuffer);
    put_mode(&request, output);
    return commit(card, &request, DRM_MODE_ATOMIC_ALLOW_MODESET | DRM_MODE_ATOMIC_NONBLOCK | DRM_MODE_PAGE_FLIP_EVENT,
                  token);
}

int kms_output_flip(const struct kms_output *output, struct kms_card *card, uint32_t framebuffer, uint64_t token)
{
    if (!card->atomic) {
        return card->calls->flip(card, output->crtc, framebuffer, token);
    }
    struct request request = {0};
    put(&request, output->plane, output->on.framebuffer, "FB_ID", framebuffer);
    return commit(card, &request, DRM_MODE_ATOMIC_NONBLOCK | DRM_MODE_PAGE_FLIP_EVENT, token);
}

int kms_output_dark(const struct kms_output *output, struct kms_card *card)
{
    if (!card->atomic) {
        return output->dpms ? card->calls->set_property(card, output->connector, output->dpms, DRM_MODE_DPMS_OFF)
                            : card->calls->set_crtc(card, output->crtc, 0, 0, 0, output->connector, NULL);
    }
    struct request request = {0};
    put(&request, output->crtc, output->active, "ACTIVE", 0);
    return commit(card, &request, DRM_MODE_ATOMIC_ALLOW_MODESET | DRM_MODE_ATOMIC_NONBLOCK, 0);
}

int kms_output_off(const struct kms_output *output, struct kms_card *card, bool wait)
{
    if (!card->atomic) {
        return card->calls->set_crtc(card, output->crtc, 0, 0, 0, output->connector, NULL);
    }
    struct request request = {0};
    put(&request, output->plane, output->on.framebuffer, "FB_ID", 0);
    put(&request, output->plane, output->on.crtc, "CRTC_ID", 0);
    put(&request, output->connector, output->crtc_id, "CRTC_ID", 0);
    put(&request, output->crtc, output->active, "ACTIVE", 0);
    put(&request, output->crtc, output->mode_id, "MODE_ID", 0);
    return commit(card, &request, DRM_MODE_ATOMIC_ALLOW_MODESET | (wait ? 0 : DRM_MODE_ATOMIC_NONBLOCK), 0);
}

/* MODE_ID and ACTIVE are never left out: without them a CRTC is not looked at, and everything passes. */
static const struct kms_value *find_culprit(struct kms_card *card, const struct kms_output *output,
                                            const struct request *request)
{
    for (int i = 0; i < request->count; i++) {
        struct request less = *request;
        memmove(&less.values[i], &less.values[i + 1], (size_t)(request->count - i - 1) * sizeof less.values[0]);
        less.count--;
        bool leaves = request->values[i].property == output->active || request->values[i].property == output->mode_id;
        if (!leaves && commit(card, &less, TESTED, 0) == 0) {
            return &request->values[i];
        }
    }
    return NULL;
}

void kms_output_explain(const struct kms_output *output, struct kms_card *card, uint32_t framebuffer, int code,
                        struct device_error *error)
{
    char text[KMS_MODE_TEXT];
    kms_mode_text(&output->mode, text);
    struct request request = {0}, bare = {0};
    put_plane(&request, output, framebuffer);
    put_mode(&request, output);
    put_mode(&bare, output);
    const struct kms_value *culprit = card->atomic ? find_culprit(card, output, &request) : NULL;
    if (culprit) {
        device_fail(error, "%s %s: property %s = %" PRIu64 " is refused: %s", output->name, text, culprit->name,
                    culprit->value, strerror(code));
    } else if (card->atomic && commit(card, &bare, TESTED, 0) == 0) {
        device_fail(error, "%s %s: property FB_ID: the plane refuses this kind of framebuffer: %s", output->name, text,
                    strerror(code));
    } else {
        device_fail(error, "%s %s: property MODE_ID: the mode is refused: %s", output->name, text, strerror(code));
    }
}
