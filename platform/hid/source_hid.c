#include "source_hid.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <hidapi.h>
#include <libudev.h>

#include "hid_definition.h"
#include "hid_known.h"
#include "source_queue.h"

enum {
    RESCAN_MS = 5000, /* without a word of udev: containers have none */
    RETRY_MS = 1000,  /* of a device that could not be opened, or stopped answering */
    CLOSING_MAX = 32,
};

struct source_hid {
    struct source source;
    struct source_queue queue;
    struct hid_definition *definition;
    struct udev *udev;
    struct udev_monitor *monitor; /* NULL: there is none to be had; the slow look must do */
    int epoll_fd, wake_fd;
    struct hid_known known[SOURCE_HID_DEVICES];
    int known_count;
    struct hid_link *closing[CLOSING_MAX];
    int closing_count;
    uint64_t signature, look_us; /* of what was plugged in; when to look again */
    bool look, trouble;          /* at once; something wants another try */
    uint32_t next_id;
    const struct hid_known *speaking; /* the device whose report is decoded, and its time */
    uint64_t time_us;
};

static struct source_hid *hid_of(struct source *source)
{
    return (struct source_hid *)source;
}

static const struct source_hid *const_hid_of(const struct source *source)
{
    return (const struct source_hid *)source;
}

/* ---- What devices say ---- */

static void emit_value(void *user, const struct hid_value *value)
{
    struct source_hid *hid = user;
    const struct event event = {.kind = EVENT_CONTROL,
                                .source = SOURCE_HID,
                                .time_us = hid->time_us,
                                .device = hid->speaking->id,
                                .control = value->usage,
                                .index = value->index,
                                .relative = value->kind == HID_STEPS,
                                .centred = value->centred,
                                .null = value->null,
                                .value = value->value};
    source_post(&hid->queue, &event);
}

static void post_presence(struct source_hid *hid, const struct hid_known *known, enum event_kind kind)
{
    const struct event event = {.kind = kind, .source = SOURCE_HID, .time_us = source_now_us(), .device = known->id};
    source_post(&hid->queue, &event);
}

static void set_trouble(struct source_hid *hid, struct hid_known *known, const char *text)
{
    if (strcmp(known->trouble, text) != 0) {
        snprintf(known->trouble, sizeof known->trouble, "%s", text);
        if (text[0]) {
            source_note(&hid->queue, "controller '%.60s' (%s): %.110s", known->node.name, known->node.path, text);
        }
    }
}

/* ---- Opening and closing ---- */

static bool has_lamps(const struct source_hid *hid, const struct hid_node *node)
{
    const struct source_hid_def *def = hid_definition_get(hid->definition);
    for (int i = 0; i < def->lamp_count; i++) {
        if (hid_matches(&def->lamps[i].match, node)) {
            return true;
        }
    }
    return false;
}

static void close_device(struct source_hid *hid, struct hid_known *known)
{
    struct hid_link *link = hid_known_close(known);
    if (link && hid->closing_count == CLOSING_MAX) { /* all of them stalled: the oldest must be waited for */
        hid_link_destroy(hid->closing[0]);
        hid->closing[0] = hid->closing[--hid->closing_count];
    }
    if (link) {
        hid->closing[hid->closing_count++] = link;
    }
}

static bool open_device(struct source_hid *hid, struct hid_known *known)
{
    const struct hid_opening opening = {.vendor = hid_definition_get(hid->definition)->vendor,
                                        .lamps = has_lamps(hid, &known->node),
                                        .wake_fd = hid->wake_fd};
    char text[sizeof known->trouble];
    bool open = hid_known_open(known, &opening, text, sizeof text);
    set_trouble(hid, known, open ? "" : text);
    hid->trouble = hid->trouble || !open;
    return open;
}

static void arrive(struct source_hid *hid, struct hid_known *known)
{
    if (open_device(hid, known) && !known->arrived) {
        known->arrived = true;
        post_presence(hid, known, EVENT_ARRIVED);
        source_note(&hid->queue, "controller '%.60s' (%04x:%04x) has arrived on %s", known->node.name,
                    known->node.vendor, known->node.product, known->node.path);
    }
}

/* Takes back all that the device holds. `reason` is for the log; NULL: say nothing. */
static void release(struct source_hid *hid, struct hid_known *known, const char *reason)
{
    if (known->decoder) {
        hid->speaking = known;
        hid->time_us = source_now_us();
        hid_decoder_release(known->decoder, emit_value, hid);
    }
    close_device(hid, known);
    if (known->arrived) {
        known->arrived = false;
        post_presence(hid, known, EVENT_LEFT);
        if (reason) {
            source_note(&hid->queue, "controller '%.60s' (%s) %s", known->node.name, known->node.path, reason);
        }
    }
}

static void leave(struct source_hid *hid, struct hid_known *known)
{
    release(hid, known, "has left");
    known->present = false;
    known->trouble[0] = '\0';
}

/* ---- What is plugged in ---- */

/* The place for a device that has come: its own of before, if it has been here. NULL: too many are. */
static struct hid_known *find_place(struct source_hid *hid, const struct hid_node *node)
{
    struct hid_known *own = NULL, *oldest = NULL;
    int best = 0;
    for (int i = 0; i < hid->known_count; i++) {
        struct hid_known *known = &hid->known[i];
        int likeness = known->present ? 0 : hid_node_likeness(&known->node, node);
        if (likeness > best) {
            own = known;
            best = likeness;
        }
        if (!known->present && (!oldest || known->id < oldest->id)) {
            oldest = known;
        }
    }
    if (own) {
        return own;
    }
    struct hid_known *place = hid->known_count < SOURCE_HID_DEVICES ? &hid->known[hid->known_count++] : oldest;
    if (place) {
        place->id = ++hid->next_id;
    }
    return place;
}

/* The media keys of a keyboard that nobody admitted. A gamepad that has a keyboard in it besides is one all the same.
 */
static bool is_of_keyboard(const struct source_hid *hid, const struct hid_node *node)
{
    bool keys = node->parent[0] && hid_is_consumer_control(node->descriptor);
    for (int i = 0; keys && i < hid->known_count; i++) {
        const struct hid_known *other = &hid->known[i];
        if (other->present && other->node.class == HID_CLASS_KEYBOARD &&
            strcmp(other->node.parent, node->parent) == 0) {
            return true;
        }
    }
    return false;
}

static bool is_admitted(struct source_hid *hid, struct hid_known *known)
{
    const struct hid_device_def *def = hid_definition_find(hid->definition, &known->node);
    known->def = def;
    if (!known->node.descriptor || (def && def->refuse)) {
        return false;
    }
    return def || (hid_definition_get(hid->definition)->controllers && known->node.class == HID_CLASS_CONTROLLER &&
                   !is_of_keyboard(hid, &known->node));
}

static void drop_absent(struct source_hid *hid, const struct hid_node *nodes, int count)
{
    for (int i = 0; i < hid->known_count; i++) {
        bool there = false;
        for (int n = 0; n < count && !there; n++) {
            there = hid_node_is(&hid->known[i].node, &nodes[n]);
        }
        if (hid->known[i].present && !there) {
            leave(hid, &hid->known[i]);
        }
    }
}

/* Takes over what a node owns when the node is new. */
static void take_node(struct source_hid *hid, struct hid_node *node)
{
    for (int i = 0; i < hid->known_count; i++) {
        if (hid->known[i].present && hid_node_is(&hid->known[i].node, node)) {
            hid_node_finish(node);
            return;
        }
    }
    struct hid_known *known = find_place(hid, node);
    if (!known) {
        hid_node_finish(node);
        return;
    }
    hid_node_finish(&known->node);
    known->node = *node;
    known->present = true;
    known->admitted = false;
    known->trouble[0] = '\0';
    if (!is_admitted(hid, known)) { /* another may still stand beside it, but that it is there is said once */
        static const char *const kinds[] = {"device", "controller", "pointer", "touchscreen", "keyboard"};
        source_note(&hid->queue, "%s '%.60s' (%04x:%04x, %s) is not admitted: it is ignored", kinds[node->class],
                    node->name, node->vendor, node->product, node->path);
    }
    set_trouble(hid, known, node->trouble);
}

static void look(struct source_hid *hid)
{
    struct hid_node *nodes = calloc(SOURCE_HID_DEVICES, sizeof *nodes);
    hid->signature = hid_nodes_signature();
    hid->look = hid->trouble = false;
    int count = nodes ? hid_nodes_list(hid->udev, nodes, SOURCE_HID_DEVICES) : 0;
    if (nodes) {
        drop_absent(hid, nodes, count);
    }
    for (int i = 0; i < count; i++) {
        take_node(hid, &nodes[i]);
    }
    free(nodes);
    for (int i = 0; i < hid->known_count; i++) {
        struct hid_known *known = &hid->known[i];
        known->admitted = known->present && is_admitted(hid, known);
        if (known->admitted && !known->link) {
            arrive(hid, known);
        } else if (!known->admitted && known->link) { /* a keyboard has come up beside it */
            release(hid, known, "is a part of a keyboard: it is ignored");
        }
    }
    hid->look_us = source_now_us() + 1000u * (hid->trouble ? RETRY_MS : RESCAN_MS);
}

static void look_if_due(struct source_hid *hid)
{
    uint64_t now = source_now_us();
    if (!hid->look && now < hid->look_us) {
        return;
    }
    if (hid->look || hid->trouble || hid_nodes_signature() != hid->signature) {
        look(hid);
    } else {
        hid->look_us = now + 1000u * RESCAN_MS;
    }
}

static void hear_udev(struct source_hid *hid)
{
    struct udev_device *device;
    while (hid->monitor && (device = udev_monitor_receive_device(hid->monitor))) {
        const char *action = udev_device_get_action(device), *node = udev_device_get_devnode(device);
        for (int i = 0; action && node && strcmp(action, "remove") == 0 && i < hid->known_count; i++) {
            if (hid->known[i].present && strcmp(hid->known[i].node.path, node) == 0) {
                leave(hid, &hid->known[i]); /* another may already be on its node */
            }
        }
        hid->look = true;
        udev_device_unref(device);
    }
}

/* ---- The source ---- */

static void hear_device(struct source_hid *hid, struct hid_known *known)
{
    uint8_t bytes[HID_REPORT_BYTES];
    size_t size;
    hid->speaking = known;
    /* Not more than fit at once: one that never stops must not hold up the others. */
    for (int i = 0; i < HID_LINK_REPORTS && (size = hid_link_take(known->link, bytes, sizeof bytes, &hid->time_us)) > 0;
         i++) {
        hid_decoder_decode(known->decoder, bytes, size, emit_value, hid);
    }
    uint64_t lost = hid_link_lost(known->link);
    if (lost != known->lost) {
        source_note(&hid->queue, "controller '%.60s': %llu reports came too fast and were passed over",
                    known->node.name, (unsigned long long)(lost - known->lost));
        known->lost = lost;
    }
    bool refuses = hid_link_refuses(known->link);
    if (refuses != known->refuses) {
        known->refuses = refuses;
        source_note(&hid->queue, "controller '%.60s' %s", known->node.name,
                    refuses ? "does not take what its lamps shall show" : "takes what its lamps shall show again");
    }
    if (hid_link_failed(known->link)) {
        release(hid, known, "has stopped answering");
        hid->trouble = true;
        uint64_t retry = source_now_us() + 1000u * RETRY_MS;
        hid->look_us = retry < hid->look_us ? retry : hid->look_us;
    }
}

static void reap(struct source_hid *hid)
{
    for (int i = hid->closing_count - 1; i >= 0; i--) {
        if (hid_link_ended(hid->closing[i])) {
            hid_link_destroy(hid->closing[i]);
            hid->closing[i] = hid->closing[--hid->closing_count];
        }
    }
}

static void dispatch(struct source *source)
{
    struct source_hid *hid = hid_of(source);
    uint64_t drained;
    (void)!read(hid->wake_fd, &drained, sizeof drained);
    for (int i = 0; i < hid->known_count; i++) {
        if (hid->known[i].link) {
            hear_device(hid, &hid->known[i]);
        }
    }
    reap(hid);
    hear_udev(hid);
    look_if_due(hid);
}

static int get_fd(const struct source *source)
{
    return const_hid_of(source)->epoll_fd;
}

static int get_timeout(const struct source *source)
{
    const struct source_hid *hid = const_hid_of(source);
    uint64_t now = source_now_us();
    if (hid->queue.count > 0 || hid->look || now >= hid->look_us) {
        return 0;
    }
    return (int)((hid->look_us - now + 999) / 1000);
}

static bool get_event(struct source *source, struct event *event)
{
    return source_take(&hid_of(source)->queue, event);
}

static bool get_line(struct source *source, char *line, int size)
{
    return source_take_line(&hid_of(source)->queue, line, size);
}

static int get_devices(const struct source *source, struct device *devices, int most)
{
    const struct source_hid *hid = const_hid_of(source);
    int count = 0;
    for (int i = 0; i < hid->known_count; i++) {
        if (hid->known[i].present) {
            if (count < most) {
                hid_known_describe(&hid->known[i], &devices[count]);
            }
            count++;
        }
    }
    return count;
}

static bool set_lamp(struct source *source, int lamp, float level)
{
    struct source_hid *hid = hid_of(source);
    const struct source_hid_def *def = hid_definition_get(hid->definition);
    bool set = false;
    for (int i = 0; i < def->lamp_count; i++) {
        for (int k = 0; def->lamps[i].lamp == lamp && k < hid->known_count; k++) {
            struct hid_known *known = &hid->known[k];
            if (known->link && known->outputs && hid_matches(&def->lamps[i].match, &known->node)) {
                set = hid_known_light(known, &def->lamps[i], level) || set;
            }
        }
    }
    return set;
}

static void destroy(struct source *source)
{
    struct source_hid *hid = hid_of(source);
    for (int i = 0; i < hid->known_count; i++) {
        close_device(hid, &hid->known[i]);
        hid_node_finish(&hid->known[i].node);
    }
    for (int i = 0; i < hid->closing_count; i++) {
        hid_link_destroy(hid->closing[i]);
    }
    if (hid->monitor) {
        udev_monitor_unref(hid->monitor);
    }
    if (hid->udev) {
        udev_unref(hid->udev);
    }
    if (hid->epoll_fd >= 0) {
        close(hid->epoll_fd);
    }
    if (hid->wake_fd >= 0) {
        close(hid->wake_fd);
    }
    hid_definition_destroy(hid->definition);
    free(hid);
    hid_exit();
}

static const struct source_ops ops = {.name = "hid",
                                      .destroy = destroy,
                                      .fd = get_fd,
                                      .timeout_ms = get_timeout,
                                      .dispatch = dispatch,
                                      .event = get_event,
                                      .devices = get_devices,
                                      .lamp = set_lamp,
                                      .log = get_line};

static bool add_to_epoll(int epoll_fd, int fd)
{
    struct epoll_event event = {.events = EPOLLIN, .data.fd = fd};
    return epoll_ctl(epoll_fd, EPOLL_CTL_ADD, fd, &event) == 0;
}

static void start_monitor(struct source_hid *hid)
{
    hid->monitor = udev_monitor_new_from_netlink(hid->udev, "udev");
    if (hid->monitor && (udev_monitor_filter_add_match_subsystem_devtype(hid->monitor, "hidraw", NULL) < 0 ||
                         udev_monitor_enable_receiving(hid->monitor) < 0 ||
                         !add_to_epoll(hid->epoll_fd, udev_monitor_get_fd(hid->monitor)))) {
        udev_monitor_unref(hid->monitor);
        hid->monitor = NULL;
    }
    if (!hid->monitor) {
        source_note(&hid->queue, "udev does not tell of controllers that come and go: every %d s a look",
                    RESCAN_MS / 1000);
    }
}

struct source *source_hid_create(const struct source_hid_def *def, struct device_error *error)
{
    struct source_hid *hid = calloc(1, sizeof *hid);
    if (!hid) {
        device_fail(error, "hid: memory is short");
        return NULL;
    }
    hid->source.ops = &ops;
    hid->epoll_fd = epoll_create1(EPOLL_CLOEXEC);
    hid->wake_fd = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    hid->definition = hid_definition_create(def, error);
    hid->udev = hid->definition ? udev_new() : NULL;
    if (!hid->definition) {
        destroy(&hid->source);
        return NULL;
    }
    if (!hid->udev || hid->epoll_fd < 0 || hid->wake_fd < 0 || !add_to_epoll(hid->epoll_fd, hid->wake_fd) ||
        hid_init() != 0) {
        device_fail(error, "hid: udev or hidapi cannot be reached: %s", strerror(errno));
        destroy(&hid->source);
        return NULL;
    }
    start_monitor(hid); /* before the first look: nothing falls between */
    look(hid);
    return &hid->source;
}

const struct hid_descriptor *source_hid_descriptor(const struct source *source, uint32_t device)
{
    const struct source_hid *hid = const_hid_of(source);
    for (int i = 0; i < hid->known_count; i++) {
        if (hid->known[i].present && hid->known[i].id == device) {
            return hid->known[i].node.descriptor;
        }
    }
    return NULL;
}
