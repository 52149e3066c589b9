#define _GNU_SOURCE
#include "hid_mock.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/hidraw.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "bed_case.h"

struct node {
    bool present, broken, stalled;
    char syspath[200], hid_path[200];
    const uint8_t *descriptor;
    size_t size;
    int fd; /* the other end of the pipe that stands in for it */
    uint8_t written[256];
    size_t written_size;
    int writes;
    UMockdevIoctlClient *unanswered; /* a write that does not come back */
};

struct hid_mock {
    UMockdevTestbed *bed;
    UMockdevIoctlBase *handler;
    pthread_mutex_t mutex; /* umockdev answers in a thread of its own */
    struct node nodes[HID_MOCK_NODES];
    int count;
};

static struct node *node_of(struct hid_mock *mock, UMockdevIoctlClient *client)
{
    int number = -1;
    /* NOLINTNEXTLINE(cert-err34-c): a name of our own making */
    (void)sscanf(umockdev_ioctl_client_get_devnode(client), "/dev/hidraw%d", &number);
    pthread_mutex_lock(&mock->mutex);
    bool there = number >= 0 && number < mock->count;
    pthread_mutex_unlock(&mock->mutex);
    return there ? &mock->nodes[number] : NULL;
}

static gboolean answer(UMockdevIoctlBase *handler, UMockdevIoctlClient *client, struct hid_mock *mock)
{
    (void)handler;
    unsigned long request = umockdev_ioctl_client_get_request(client);
    const struct node *node = node_of(mock, client);
    if (!node || (request != HIDIOCGRDESCSIZE && request != HIDIOCGRDESC)) {
        return FALSE;
    }
    UMockdevIoctlData *data =
        umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, _IOC_SIZE(request), NULL);
    if (!data) {
        return FALSE;
    }
    if (request == HIDIOCGRDESCSIZE) {
        int size = (int)node->size;
        umockdev_ioctl_data_update(data, 0, (guint8 *)&size, sizeof size);
    } else {
        umockdev_ioctl_data_update(data, sizeof(uint32_t), (guint8 *)node->descriptor, (gint)node->size);
    }
    umockdev_ioctl_client_complete(client, 0, 0);
    g_object_unref(data);
    return TRUE;
}

static gboolean answer_read(UMockdevIoctlBase *handler, UMockdevIoctlClient *client, struct hid_mock *mock)
{
    (void)handler;
    struct node *node = node_of(mock, client);
    pthread_mutex_lock(&mock->mutex);
    bool broken = node && node->broken;
    pthread_mutex_unlock(&mock->mutex);
    if (broken) {
        umockdev_ioctl_client_complete(client, -1, EIO);
    }
    return broken;
}

static gboolean answer_write(UMockdevIoctlBase *handler, UMockdevIoctlClient *client, struct hid_mock *mock)
{
    (void)handler;
    struct node *node = node_of(mock, client);
    const UMockdevIoctlData *data = umockdev_ioctl_client_get_arg(client); /* what is written */
    if (!node) {
        return FALSE;
    }
    pthread_mutex_lock(&mock->mutex);
    node->written_size = (size_t)data->data_len < sizeof node->written ? (size_t)data->data_len : sizeof node->written;
    memcpy(node->written, data->data, node->written_size);
    node->writes++;
    bool kept = node->stalled;
    if (kept) {
        node->unanswered = g_object_ref(client);
    }
    pthread_mutex_unlock(&mock->mutex);
    if (!kept) {
        umockdev_ioctl_client_complete(client, data->data_len, 0);
    }
    return TRUE;
}

static void add(struct hid_mock *mock, const char *text)
{
    GError *error = NULL;
    if (!umockdev_testbed_add_from_string(mock->bed, text, &error)) {
        fprintf(stderr, "%s\n%s\n", text, error->message);
        abort();
    }
}

/* What a device is plugged into may have been there before. */
static void add_once(struct hid_mock *mock, const char *device, const char *text)
{
    char path[300];
    char *root = umockdev_testbed_get_root_dir(mock->bed);
    snprintf(path, sizeof path, "%s/sys/devices/mock/%s", root, device);
    g_free(root);
    if (access(path, F_OK) != 0) {
        add(mock, text);
    }
}

static void hex(char *text, const uint8_t *bytes, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        sprintf(text + 2 * i, "%02X", bytes[i]);
    }
}

/* A pipe of packets takes the place of umockdev's terminal, which would run reports together. */
static void make_pipe(struct hid_mock *mock, int number)
{
    char path[300];
    char *root = umockdev_testbed_get_root_dir(mock->bed);
    snprintf(path, sizeof path, "%s/dev/hidraw%d", root, number);
    g_free(root);
    unlink(path);
    if (mkfifo(path, 0666) != 0 || (mock->nodes[number].fd = open(path, O_RDWR | O_CLOEXEC | O_NONBLOCK)) < 0 ||
        fcntl(mock->nodes[number].fd, F_SETFL, O_DIRECT | O_NONBLOCK) != 0) {
        perror(path);
        abort();
    }
}

int hid_mock_plug(struct hid_mock *mock, const struct hid_mock_def *def)
{
    char text[12000], descriptor[2 * 4096 + 1] = "", name[64], hid_path[160];
    if (mock->count == HID_MOCK_NODES) {
        abort();
    }
    pthread_mutex_lock(&mock->mutex);
    int number = mock->count++;
    struct node *node = &mock->nodes[number];
    hex(descriptor, def->descriptor, def->size);
    node->descriptor = def->descriptor;
    node->size = def->size;
    node->present = true;
    pthread_mutex_unlock(&mock->mutex);
    snprintf(hid_path, sizeof hid_path, "/devices/mock/%s/%s:1.%d/0003:%04X:%04X.%04X", def->usb, def->usb,
             def->interface, def->vendor, def->product, number + 1);
    snprintf(node->syspath, sizeof node->syspath, "%s/hidraw/hidraw%d", hid_path, number);
    memcpy(node->hid_path, hid_path, sizeof hid_path);
    snprintf(text, sizeof text,
             "P: /devices/mock/%s\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: product=%s\\n\nA: manufacturer=Mock\\n\n"
             "A: bcdDevice=0100\\n\n\n",
             def->usb, def->name);
    add_once(mock, def->usb, text);
    snprintf(name, sizeof name, "%s/%s:1.%d", def->usb, def->usb, def->interface);
    snprintf(text, sizeof text,
             "P: /devices/mock/%s\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nA: bInterfaceNumber=%02d\\n\n\n", name,
             def->interface);
    add_once(mock, name, text);
    snprintf(text, sizeof text,
             "P: %s\nE: SUBSYSTEM=hid\nE: HID_ID=0003:%08X:%08X\nE: HID_NAME=%s\nE: HID_PHYS=usb-mock-%s/input%d\n"
             "E: HID_UNIQ=%s\nH: report_descriptor=%s\n\n",
             node->hid_path, def->vendor, def->product, def->name, def->usb, def->interface,
             def->serial ? def->serial : "", descriptor);
    add(mock, text);
    snprintf(text, sizeof text, "P: %s\nN: hidraw%d\nE: SUBSYSTEM=hidraw\nE: DEVNAME=/dev/hidraw%d\nA: dev=240:%d\\n\n",
             node->syspath, number, number, number);
    add(mock, text);
    snprintf(name, sizeof name, "/dev/hidraw%d", number);
    GError *error = NULL;
    if (!umockdev_testbed_attach_ioctl(mock->bed, name, mock->handler, &error)) {
        fprintf(stderr, "%s: %s\n", name, error->message);
        abort();
    }
    make_pipe(mock, number);
    return number;
}

void hid_mock_announce(struct hid_mock *mock, int node, const char *action)
{
    char path[300];
    snprintf(path, sizeof path, "/sys%s", mock->nodes[node].syspath);
    umockdev_testbed_uevent(mock->bed, path, action);
}

void hid_mock_unplug(struct hid_mock *mock, int number)
{
    struct node *node = &mock->nodes[number];
    char path[300], name[32];
    hid_mock_announce(mock, number, "remove");
    snprintf(name, sizeof name, "/dev/hidraw%d", number);
    umockdev_testbed_detach_ioctl(mock->bed, name, NULL);
    snprintf(path, sizeof path, "/sys%s", node->syspath);
    umockdev_testbed_remove_device(mock->bed, path);
    snprintf(path, sizeof path, "/sys%s", node->hid_path);
    umockdev_testbed_remove_device(mock->bed, path);
    close(node->fd);
    node->fd = -1;
    node->present = false;
}

void hid_mock_report(struct hid_mock *mock, int node, const uint8_t *bytes, size_t size)
{
    while (write(mock->nodes[node].fd, bytes, size) != (ssize_t)size) {
        if (errno != EAGAIN) {
            perror("report");
            abort();
        }
        usleep(1000);
    }
}

void hid_mock_break(struct hid_mock *mock, int node, bool broken)
{
    pthread_mutex_lock(&mock->mutex);
    mock->nodes[node].broken = broken;
    pthread_mutex_unlock(&mock->mutex);
    uint8_t bytes[64]; /* what came meanwhile is lost */
    while (!broken && read(mock->nodes[node].fd, bytes, sizeof bytes) > 0) {
    }
}

void hid_mock_stall(struct hid_mock *mock, int node, bool stalled)
{
    pthread_mutex_lock(&mock->mutex);
    UMockdevIoctlClient *client = stalled ? NULL : mock->nodes[node].unanswered;
    mock->nodes[node].stalled = stalled;
    mock->nodes[node].unanswered = NULL;
    pthread_mutex_unlock(&mock->mutex);
    if (client) {
        umockdev_ioctl_client_complete(client, -1, EPIPE);
        g_object_unref(client);
    }
}

void hid_mock_forbid(struct hid_mock *mock, int number, bool forbidden)
{
    bed_case_permit(mock->bed, "hidraw", number, forbidden ? 0 : 0666);
}

void hid_mock_open_to_all(struct hid_mock *mock)
{
    bed_case_open_to_all(mock->bed, "hidraw", mock->count);
}

size_t hid_mock_written(struct hid_mock *mock, int number, uint8_t *bytes, size_t most, int *count)
{
    const struct node *node = &mock->nodes[number];
    pthread_mutex_lock(&mock->mutex);
    size_t size = node->written_size < most ? node->written_size : most;
    memcpy(bytes, node->written, size);
    *count = node->writes;
    pthread_mutex_unlock(&mock->mutex);
    return size;
}

struct hid_mock *hid_mock_create(void)
{
    struct hid_mock *mock = calloc(1, sizeof *mock);
    if (!mock) {
        return NULL;
    }
    mock->bed = umockdev_testbed_new();
    if (!umockdev_in_mock_environment()) { /* it cannot tell before there is a testbed */
        g_object_unref(mock->bed);
        free(mock);
        return NULL;
    }
    pthread_mutex_init(&mock->mutex, NULL);
    mock->handler = umockdev_ioctl_base_new();
    g_signal_connect(mock->handler, "handle-ioctl", G_CALLBACK(answer), mock);
    g_signal_connect(mock->handler, "handle-read", G_CALLBACK(answer_read), mock);
    g_signal_connect(mock->handler, "handle-write", G_CALLBACK(answer_write), mock);
    return mock;
}

void hid_mock_destroy(struct hid_mock *mock)
{
    for (int i = 0; i < mock->count; i++) {
        if (mock->nodes[i].present) {
            close(mock->nodes[i].fd);
        }
    }
    g_object_unref(mock->bed);
    g_object_unref(mock->handler);
    pthread_mutex_destroy(&mock->mutex);
    free(mock);
}
