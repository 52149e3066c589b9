#define _GNU_SOURCE
#include "touch_mock.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/input.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include "bed_case.h"
#include "disk_case.h"

enum { MAJOR = 13, FIRST_MINOR = 64, FINGERS = 10 };

struct node {
    enum touch_mock_kind kind;
    bool present;
    char name[64];
    int bus;
    char syspath[200];
    int fd;      /* the other end of the pipe that stands in for it */
    ino_t inode; /* of that pipe */
    int grabs;
};

struct touch_mock {
    UMockdevTestbed *bed;
    UMockdevIoctlBase *handler;
    pthread_mutex_t mutex; /* umockdev answers in a thread of its own */
    struct node nodes[TOUCH_MOCK_NODES];
    int count;
};

/* Which pipe is which node; the shim below has nothing else to go by. */
static struct {
    ino_t inodes[TOUCH_MOCK_NODES];
    int count;
} pipes;

/* libinput looks by fstat at the number of what it has opened, of which umockdev knows nothing before 0.19.2. */
/* NOLINTNEXTLINE(readability-inconsistent-declaration-parameter-name) */
int fstat64(int fd, struct stat64 *status)
{
    struct stat plain;
    int code = fstat(fd, &plain);
    if (code != 0) {
        return code;
    }
    memcpy(status, &plain, sizeof plain); /* the same on 64 bits */
    for (int i = 0; i < pipes.count; i++) {
        if (S_ISFIFO(plain.st_mode) && plain.st_ino == pipes.inodes[i]) {
            status->st_mode = S_IFCHR | (plain.st_mode & 07777);
            status->st_rdev = makedev(MAJOR, (unsigned)(FIRST_MINOR + i));
        }
    }
    return 0;
}

bool touch_mock_isolate(void)
{
    return disk_case_isolate() && mount("run", "/run", "tmpfs", 0, NULL) == 0 && mkdir("/run/udev", 0755) == 0 &&
           mkdir("/run/udev/data", 0755) == 0;
}

/* ---- What the kernel would answer ---- */

static void set(unsigned char *bits, int code)
{
    bits[code / 8] = (unsigned char)(bits[code / 8] | 1u << code % 8);
}

#define SET(bits, ...) set_all(bits, (const int[]){__VA_ARGS__}, (int)(sizeof(int[]){__VA_ARGS__} / sizeof(int)))
static void set_all(unsigned char *bits, const int *codes, int count)
{
    for (int i = 0; i < count; i++) {
        set(bits, codes[i]);
    }
}

static void fill_keys(unsigned char *bits, enum touch_mock_kind kind)
{
    if (kind == MOCK_KEYBOARD) {
        for (int code = KEY_ESC; code <= KEY_F12; code++) {
            set(bits, code);
        }
    } else if (kind == MOCK_MOUSE) {
        SET(bits, BTN_LEFT, BTN_RIGHT);
    } else {
        SET(bits, BTN_TOUCH);
    }
    if (kind == MOCK_PAD) {
        SET(bits, BTN_LEFT, BTN_TOOL_FINGER, BTN_TOOL_DOUBLETAP);
    }
}

static void fill_bits(unsigned char *bits, enum touch_mock_kind kind, unsigned type)
{
    bool surface = kind != MOCK_MOUSE && kind != MOCK_KEYBOARD;
    if (type == 0) {
        SET(bits, EV_SYN, EV_KEY);
        set(bits, surface ? EV_ABS : kind == MOCK_MOUSE ? EV_REL : EV_KEY);
    } else if (type == EV_KEY) {
        fill_keys(bits, kind);
    } else if (type == EV_ABS && surface) {
        SET(bits, ABS_X, ABS_Y, ABS_MT_SLOT, ABS_MT_TRACKING_ID, ABS_MT_TOOL_TYPE, ABS_MT_POSITION_X,
            ABS_MT_POSITION_Y);
    } else if (type == EV_REL && kind == MOCK_MOUSE) {
        SET(bits, REL_X, REL_Y);
    }
}

static void fill_axis(struct input_absinfo *info, unsigned code)
{
    info->maximum = code == ABS_MT_SLOT          ? FINGERS - 1
                    : code == ABS_MT_TRACKING_ID ? 65535
                    : code == ABS_MT_TOOL_TYPE   ? MT_TOOL_PALM
                                                 : TOUCH_MOCK_SIZE - 1;
    info->resolution = info->maximum == TOUCH_MOCK_SIZE - 1 ? 10 : 0;
}

/* False: no such request. `bytes` is what is written back. */
static bool fill(const struct node *node, unsigned number, unsigned char *bytes, size_t size)
{
    const int version = EV_VERSION;
    const struct input_id id = {.bustype = (unsigned short)node->bus, .vendor = 0x1209, .product = 0x0010};
    if (number == _IOC_NR(EVIOCGVERSION)) {
        memcpy(bytes, &version, sizeof version);
    } else if (number == _IOC_NR(EVIOCGID)) {
        memcpy(bytes, &id, sizeof id);
    } else if (number == _IOC_NR(EVIOCGNAME(0))) {
        snprintf((char *)bytes, size, "%s", node->name);
    } else if (number == _IOC_NR(EVIOCGPROP(0))) {
        if (node->kind != MOCK_MOUSE && node->kind != MOCK_KEYBOARD) {
            set(bytes, node->kind == MOCK_SCREEN ? INPUT_PROP_DIRECT : INPUT_PROP_POINTER);
        }
    } else if (number >= _IOC_NR(EVIOCGBIT(0, 0)) && number < _IOC_NR(EVIOCGBIT(EV_MAX, 0))) {
        fill_bits(bytes, node->kind, number - _IOC_NR(EVIOCGBIT(0, 0)));
    } else if (number >= _IOC_NR(EVIOCGABS(0)) && number <= _IOC_NR(EVIOCGABS(ABS_MAX))) {
        struct input_absinfo info = {0};
        fill_axis(&info, number - (unsigned)_IOC_NR(EVIOCGABS(0)));
        memcpy(bytes, &info, sizeof info);
    } else if (number == _IOC_NR(EVIOCGMTSLOTS(0))) { /* the code, and then a value for each slot */
        memset(bytes + sizeof(int), ((const int *)bytes)[0] == ABS_MT_TRACKING_ID ? 0xff : 0, size - sizeof(int));
    } else {
        return number == _IOC_NR(EVIOCGKEY(0)) || number == _IOC_NR(EVIOCGLED(0)) || number == _IOC_NR(EVIOCGSW(0));
    }
    return true;
}

static struct node *node_of(struct touch_mock *mock, UMockdevIoctlClient *client)
{
    int number = -1;
    /* NOLINTNEXTLINE(cert-err34-c): a name of our own making */
    (void)sscanf(umockdev_ioctl_client_get_devnode(client), "/dev/input/event%d", &number);
    return number >= 0 && number < TOUCH_MOCK_NODES ? &mock->nodes[number] : NULL;
}

static gboolean answer(UMockdevIoctlBase *handler, UMockdevIoctlClient *client, struct touch_mock *mock)
{
    (void)handler;
    unsigned long request = umockdev_ioctl_client_get_request(client);
    struct node *node = node_of(mock, client);
    if (!node || _IOC_TYPE(request) != 'E') {
        return FALSE;
    }
    if (request == EVIOCGRAB || request == EVIOCSCLOCKID) {
        pthread_mutex_lock(&mock->mutex);
        node->grabs += request == EVIOCGRAB;
        pthread_mutex_unlock(&mock->mutex);
        umockdev_ioctl_client_complete(client, 0, 0);
        return TRUE;
    }
    unsigned char bytes[1 << _IOC_SIZEBITS] = {0};
    size_t size = _IOC_SIZE(request);
    UMockdevIoctlData *data = umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, size, NULL);
    if (!data) {
        return FALSE;
    }
    if (_IOC_NR(request) == _IOC_NR(EVIOCGMTSLOTS(0))) {
        memcpy(bytes, data->data, size);
    }
    bool good = fill(node, _IOC_NR(request), bytes, size);
    if (good) {
        umockdev_ioctl_data_update(data, 0, bytes, (gint)size);
    }
    umockdev_ioctl_client_complete(client, good ? (glong)size : -1, good ? 0 : ENOENT);
    g_object_unref(data);
    return TRUE;
}

/* ---- Plugging ---- */

static void add(struct touch_mock *mock, const char *text)
{
    GError *error = NULL;
    if (!umockdev_testbed_add_from_string(mock->bed, text, &error)) {
        fprintf(stderr, "%s\n%s\n", text, error->message);
        abort();
    }
}

static void real_path(struct touch_mock *mock, int number, char *path, size_t size)
{
    char *root = umockdev_testbed_get_root_dir(mock->bed);
    snprintf(path, size, "%s/dev/input/event%d", root, number);
    g_free(root);
}

static void make_pipe(struct touch_mock *mock, int number)
{
    struct node *node = &mock->nodes[number];
    struct stat status;
    char path[300];
    real_path(mock, number, path, sizeof path);
    unlink(path);
    if (mkfifo(path, 0666) != 0 || (node->fd = open(path, O_RDWR | O_CLOEXEC | O_NONBLOCK)) < 0 ||
        fstat(node->fd, &status) != 0) {
        perror(path);
        abort();
    }
    pipes.inodes[number] = status.st_ino;
    pipes.count = number + 1;
}

/* Where umockdev, from 0.19 at the latest, finds udev's records instead of in /run. */
static void make_record_folder(struct touch_mock *mock)
{
    char *root = umockdev_testbed_get_root_dir(mock->bed);
    char *folder = g_build_filename(root, "run/udev/data", NULL);
    if (g_mkdir_with_parents(folder, 0755) != 0) {
        perror(folder);
        abort();
    }
    g_free(folder);
    g_free(root);
}

/* udev's record of a device that it has seen. */
static void make_record(int number)
{
    char path[64];
    snprintf(path, sizeof path, "/run/udev/data/c%d:%d", MAJOR, FIRST_MINOR + number);
    FILE *record = fopen(path, "w");
    if (!record || fputs("I:1\n", record) < 0 || fclose(record) != 0) {
        perror(path);
        abort();
    }
}

int touch_mock_plug(struct touch_mock *mock, enum touch_mock_kind kind, const char *name, const char *matrix, int bus)
{
    static const char *const tags[] = {"ID_INPUT_TOUCHSCREEN", "ID_INPUT_TOUCHPAD", "ID_INPUT_MOUSE",
                                       "ID_INPUT_KEYBOARD", "ID_INPUT_TOUCHSCREEN"};
    char text[1000], calibration[100] = "", path[32];
    if (mock->count == TOUCH_MOCK_NODES) {
        abort();
    }
    int number = mock->count;
    struct node *node = &mock->nodes[number];
    pthread_mutex_lock(&mock->mutex);
    mock->count++;
    *node = (struct node){.kind = kind, .present = true, .bus = bus};
    snprintf(node->name, sizeof node->name, "%s", name);
    pthread_mutex_unlock(&mock->mutex);
    snprintf(text, sizeof text,
             "P: /devices/mock/input%d\nE: SUBSYSTEM=input\nE: PRODUCT=3/1209/10/0\nE: NAME=\"%s\"\nA: name=%s\\n\n"
             "A: id/bustype=%04x\\n\nA: id/vendor=1209\\n\nA: id/product=0010\\n\nA: properties=%d\\n\n"
             "A: phys=mock-%s/input0\\n\n\n",
             number, name, name, (unsigned)bus,
             kind == MOCK_SCREEN                      ? 2
             : kind == MOCK_PAD || kind == MOCK_DECOY ? 1
                                                      : 0,
             name);
    add(mock, text);
    if (matrix) {
        snprintf(calibration, sizeof calibration, "E: LIBINPUT_CALIBRATION_MATRIX=%s\n", matrix);
    }
    snprintf(node->syspath, sizeof node->syspath, "/sys/devices/mock/input%d/event%d", number, number);
    snprintf(text, sizeof text,
             "P: %s\nN: input/event%d\nE: SUBSYSTEM=input\nE: DEVNAME=/dev/input/event%d\nE: MAJOR=%d\nE: MINOR=%d\n"
             "E: ID_INPUT=1\nE: %s=1\n%sA: dev=%d:%d\\n\n\n",
             node->syspath + strlen("/sys"), number, number, MAJOR, FIRST_MINOR + number, tags[kind], calibration,
             MAJOR, FIRST_MINOR + number);
    add(mock, text);
    make_record(number);
    snprintf(path, sizeof path, "/dev/input/event%d", number);
    GError *error = NULL;
    if (!umockdev_testbed_attach_ioctl(mock->bed, path, mock->handler, &error)) {
        fprintf(stderr, "%s: %s\n", path, error->message);
        abort();
    }
    make_pipe(mock, number);
    return number;
}

void touch_mock_announce(struct touch_mock *mock, int number)
{
    umockdev_testbed_uevent(mock->bed, mock->nodes[number].syspath, "add");
}

void touch_mock_unplug(struct touch_mock *mock, int number)
{
    struct node *node = &mock->nodes[number];
    char path[64];
    umockdev_testbed_uevent(mock->bed, node->syspath, "remove");
    snprintf(path, sizeof path, "/dev/input/event%d", number);
    umockdev_testbed_detach_ioctl(mock->bed, path, NULL);
    umockdev_testbed_remove_device(mock->bed, node->syspath);
    snprintf(path, sizeof path, "/sys/devices/mock/input%d", number);
    umockdev_testbed_remove_device(mock->bed, path);
    close(node->fd);
    node->present = false;
}

void touch_mock_forbid(struct touch_mock *mock, int number, unsigned mode)
{
    bed_case_permit(mock->bed, "input/event", number, mode);
}

void touch_mock_open_to_all(struct touch_mock *mock)
{
    bed_case_open_to_all(mock->bed, "input/event", mock->count);
}

void touch_mock_report(struct touch_mock *mock, int number, unsigned long time_us,
                       const struct touch_mock_value *values, int count)
{
    struct input_event events[64] = {0};
    for (int i = 0; i <= count; i++) {
        events[i].input_event_sec = (long)(time_us / 1000000);
        events[i].input_event_usec = (long)(time_us % 1000000);
        if (i < count) {
            events[i].type = (unsigned short)values[i].type;
            events[i].code = (unsigned short)values[i].code;
            events[i].value = values[i].value;
        }
    }
    size_t size = ((size_t)count + 1) * sizeof *events;
    if (write(mock->nodes[number].fd, events, size) != (ssize_t)size) {
        perror("report");
        abort();
    }
}

int touch_mock_grabs(struct touch_mock *mock, int number)
{
    pthread_mutex_lock(&mock->mutex);
    int grabs = mock->nodes[number].grabs;
    pthread_mutex_unlock(&mock->mutex);
    return grabs;
}

struct touch_mock *touch_mock_create(void)
{
    struct touch_mock *mock = calloc(1, sizeof *mock);
    if (!mock) {
        return NULL;
    }
    mock->bed = umockdev_testbed_new();
    if (!umockdev_in_mock_environment()) { /* it cannot tell before there is a testbed */
        g_object_unref(mock->bed);
        free(mock);
        return NULL;
    }
    pipes.count = 0;
    pthread_mutex_init(&mock->mutex, NULL);
    make_record_folder(mock);
    mock->handler = umockdev_ioctl_base_new();
    g_signal_connect(mock->handler, "handle-ioctl", G_CALLBACK(answer), mock);
    return mock;
}

void touch_mock_destroy(struct touch_mock *mock)
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
