#include "gpio_mock.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/gpio.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <umockdev.h>

enum { SPARES = 3 };

/* What a request hands out is the descriptor of a second node, so that what is asked of it comes here as well. It is
 * opened beforehand: umockdev cannot open a node of its own while it answers. */
struct line {
    struct mock_line seen;
    char name[32], consumer[32];
    int spares[SPARES], spare_count;
    int fd;         /* as handed out */
    int generation; /* of the kernel's interface that it was requested by */
};

struct gpio_mock {
    UMockdevTestbed *bed;
    UMockdevIoctlBase *handler;
    pthread_mutex_t mutex; /* umockdev answers in a thread of its own */
    struct line lines[MOCK_LINES];
    int number; /* of the chip */
    bool gone;
};

static void line_node(int line, char *node)
{
    sprintf(node, "/dev/gpioline%d", line);
}

/* ---- the first generation */

static int v1_line_info(struct gpio_mock *mock, struct gpioline_info *info)
{
    if (info->line_offset >= MOCK_LINES) {
        return EINVAL;
    }
    const struct line *line = &mock->lines[info->line_offset];
    memcpy(info->name, line->name, sizeof info->name);
    memcpy(info->consumer, line->consumer, sizeof info->consumer);
    info->flags = line->consumer[0] ? GPIOLINE_FLAG_KERNEL : 0;
    return 0;
}

static int request_line(struct line *line, const char *consumer, int generation, int *fd)
{
    if (line->consumer[0]) {
        return EBUSY;
    }
    if (line->spare_count == 0) {
        return EMFILE;
    }
    *fd = line->fd = line->spares[--line->spare_count];
    snprintf(line->consumer, sizeof line->consumer, "%.31s", consumer);
    line->generation = generation;
    line->seen.requested = true;
    return 0;
}

static enum mock_bias v1_bias(uint32_t flags)
{
    return flags & GPIOHANDLE_REQUEST_BIAS_PULL_UP     ? MOCK_PULL_UP
           : flags & GPIOHANDLE_REQUEST_BIAS_PULL_DOWN ? MOCK_PULL_DOWN
           : flags & GPIOHANDLE_REQUEST_BIAS_DISABLE   ? MOCK_NONE
                                                       : MOCK_AS_IS;
}

static int v1_handle(struct gpio_mock *mock, struct gpiohandle_request *request)
{
    if (request->lines != 1 || request->lineoffsets[0] >= MOCK_LINES) {
        return EINVAL;
    }
    struct line *line = &mock->lines[request->lineoffsets[0]];
    int code = request_line(line, request->consumer_label, 1, &request->fd);
    if (code == 0) {
        line->seen.output = request->flags & GPIOHANDLE_REQUEST_OUTPUT;
        line->seen.active_low = request->flags & GPIOHANDLE_REQUEST_ACTIVE_LOW;
        line->seen.bias = v1_bias(request->flags);
        line->seen.level = line->seen.output ? request->default_values[0] : line->seen.level;
    }
    return code;
}

static int v1_event(struct gpio_mock *mock, struct gpioevent_request *request)
{
    if (request->lineoffset >= MOCK_LINES || request->eventflags != GPIOEVENT_REQUEST_BOTH_EDGES) {
        return EINVAL;
    }
    struct line *line = &mock->lines[request->lineoffset];
    int code = request_line(line, request->consumer_label, 1, &request->fd);
    if (code == 0) {
        line->seen.output = false;
        line->seen.active_low = request->handleflags & GPIOHANDLE_REQUEST_ACTIVE_LOW;
        line->seen.bias = v1_bias(request->handleflags);
    }
    return code;
}

/* ---- the second */

static int v2_line_info(struct gpio_mock *mock, struct gpio_v2_line_info *info)
{
    if (info->offset >= MOCK_LINES) {
        return EINVAL;
    }
    const struct line *line = &mock->lines[info->offset];
    memcpy(info->name, line->name, sizeof info->name);
    memcpy(info->consumer, line->consumer, sizeof info->consumer);
    info->flags = (line->consumer[0] ? GPIO_V2_LINE_FLAG_USED : 0) |
                  (line->seen.output ? GPIO_V2_LINE_FLAG_OUTPUT : GPIO_V2_LINE_FLAG_INPUT);
    info->num_attrs = line->seen.debounce_us > 0;
    info->attrs[0].id = GPIO_V2_LINE_ATTR_ID_DEBOUNCE;
    info->attrs[0].debounce_period_us = line->seen.debounce_us;
    return 0;
}

static void v2_configure(struct line *line, const struct gpio_v2_line_config *config)
{
    uint64_t flags = config->flags;
    line->seen.debounce_us = 0;
    for (uint32_t i = 0; i < config->num_attrs; i++) {
        const struct gpio_v2_line_attribute *attribute = &config->attrs[i].attr;
        if (attribute->id == GPIO_V2_LINE_ATTR_ID_FLAGS) {
            flags = attribute->flags;
        } else if (attribute->id == GPIO_V2_LINE_ATTR_ID_DEBOUNCE) {
            line->seen.debounce_us = attribute->debounce_period_us;
        } else if (attribute->id == GPIO_V2_LINE_ATTR_ID_OUTPUT_VALUES) {
            line->seen.level = attribute->values & 1;
        }
    }
    line->seen.output = flags & GPIO_V2_LINE_FLAG_OUTPUT;
    line->seen.active_low = flags & GPIO_V2_LINE_FLAG_ACTIVE_LOW;
    line->seen.bias = flags & GPIO_V2_LINE_FLAG_BIAS_PULL_UP     ? MOCK_PULL_UP
                      : flags & GPIO_V2_LINE_FLAG_BIAS_PULL_DOWN ? MOCK_PULL_DOWN
                      : flags & GPIO_V2_LINE_FLAG_BIAS_DISABLED  ? MOCK_NONE
                                                                 : MOCK_AS_IS;
}

static int v2_request(struct gpio_mock *mock, struct gpio_v2_line_request *request)
{
    if (request->num_lines != 1 || request->offsets[0] >= MOCK_LINES) {
        return EINVAL;
    }
    struct line *line = &mock->lines[request->offsets[0]];
    int code = request_line(line, request->consumer, 2, &request->fd);
    if (code == 0) {
        v2_configure(line, &request->config);
    }
    return code;
}

/* ---- both */

static int chip_info(const struct gpio_mock *mock, struct gpiochip_info *info)
{
    memset(info, 0, sizeof *info);
    snprintf(info->name, sizeof info->name, "gpiochip%d", mock->number);
    snprintf(info->label, sizeof info->label, "mock-gpio");
    info->lines = MOCK_LINES;
    return 0;
}

static void set_level(struct line *line, bool level)
{
    line->seen.level = level;
    line->seen.number_of_sets++;
}

/* 0 or an errno; -1: not one of these. */
static int answer_chip(struct gpio_mock *mock, unsigned long request, void *argument)
{
    switch (request) {
    case GPIO_GET_CHIPINFO_IOCTL:
        return chip_info(mock, argument);
    case GPIO_GET_LINEINFO_IOCTL:
        return v1_line_info(mock, argument);
    case GPIO_GET_LINEHANDLE_IOCTL:
        return v1_handle(mock, argument);
    case GPIO_GET_LINEEVENT_IOCTL:
        return v1_event(mock, argument);
    case GPIO_V2_GET_LINEINFO_IOCTL:
        return v2_line_info(mock, argument);
    case GPIO_V2_GET_LINE_IOCTL:
        return v2_request(mock, argument);
    default:
        return -1;
    }
}

static int answer_line(struct line *line, unsigned long request, void *argument)
{
    switch (request) {
    case GPIOHANDLE_GET_LINE_VALUES_IOCTL:
        ((struct gpiohandle_data *)argument)->values[0] = line->seen.level;
        return 0;
    case GPIOHANDLE_SET_LINE_VALUES_IOCTL:
        set_level(line, ((struct gpiohandle_data *)argument)->values[0]);
        return 0;
    case GPIO_V2_LINE_GET_VALUES_IOCTL:
        ((struct gpio_v2_line_values *)argument)->bits = line->seen.level;
        return 0;
    case GPIO_V2_LINE_SET_VALUES_IOCTL:
        set_level(line, ((struct gpio_v2_line_values *)argument)->bits & 1);
        return 0;
    default:
        return -1;
    }
}

static gboolean answer(UMockdevIoctlBase *handler, UMockdevIoctlClient *client, struct gpio_mock *mock)
{
    (void)handler;
    unsigned long request = umockdev_ioctl_client_get_request(client);
    int number = -1;
    (void)sscanf(umockdev_ioctl_client_get_devnode(client), "/dev/gpioline%d", &number);
    if (_IOC_TYPE(request) != 0xB4) {
        return FALSE;
    }
    UMockdevIoctlData *data =
        umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, _IOC_SIZE(request), NULL);
    if (!data) {
        return FALSE;
    }
    pthread_mutex_lock(&mock->mutex);
    int code = mock->gone    ? ENODEV
               : number >= 0 ? answer_line(&mock->lines[number], request, data->data)
                             : answer_chip(mock, request, data->data);
    pthread_mutex_unlock(&mock->mutex);
    umockdev_ioctl_client_complete(client, code == 0 ? 0 : -1, code < 0 ? ENOTTY : code);
    g_object_unref(data);
    return TRUE;
}

/* Only a description makes a node; libgpiod compares its `dev` with it, and wants a line of it. */
static void add_node(struct gpio_mock *mock, const char *subsystem, const char *name, int minor)
{
    char text[300];
    GError *error = NULL;
    snprintf(text, sizeof text, "P: /devices/mock/%s\nN: %s\nE: DEVNAME=/dev/%s\nE: SUBSYSTEM=%s\nA: dev=254:%d\\n\n",
             name, name, name, subsystem, minor);
    if (!umockdev_testbed_add_from_string(mock->bed, text, &error)) {
        fprintf(stderr, "%s: %s\n", name, error->message);
        abort();
    }
}

static void attach(struct gpio_mock *mock, const char *node)
{
    GError *error = NULL;
    if (!umockdev_testbed_attach_ioctl(mock->bed, node, mock->handler, &error)) {
        fprintf(stderr, "%s: %s\n", node, error->message);
        abort();
    }
}

void gpio_mock_plug(struct gpio_mock *mock)
{
    pthread_mutex_lock(&mock->mutex);
    mock->gone = false;
    pthread_mutex_unlock(&mock->mutex);
    char name[32], node[40];
    snprintf(name, sizeof name, "gpiochip%d", mock->number);
    snprintf(node, sizeof node, "/dev/%s", name);
    add_node(mock, "gpio", name, mock->number);
    attach(mock, node);
}

void gpio_mock_unplug(struct gpio_mock *mock)
{
    pthread_mutex_lock(&mock->mutex);
    mock->gone = true;
    for (int i = 0; i + 1 < MOCK_LINES; i++) {
        mock->lines[i].consumer[0] = '\0';
        mock->lines[i].seen.requested = false;
    }
    pthread_mutex_unlock(&mock->mutex);
    char node[32], path[48];
    snprintf(node, sizeof node, "/dev/gpiochip%d", mock->number);
    snprintf(path, sizeof path, "/sys/devices/mock/gpiochip%d", mock->number);
    umockdev_testbed_detach_ioctl(mock->bed, node, NULL);
    umockdev_testbed_remove_device(mock->bed, path);
    mock->number++; /* umockdev cannot make a node twice */
}

void gpio_mock_refill(struct gpio_mock *mock)
{
    for (int i = 0; i < MOCK_LINES; i++) {
        struct line *line = &mock->lines[i];
        char node[32];
        line_node(i, node);
        while (line->spare_count < SPARES) {
            int fd = open(node, O_RDWR | O_CLOEXEC);
            if (fd < 0) {
                perror(node);
                abort();
            }
            line->spares[line->spare_count++] = fd;
        }
    }
}

struct gpio_mock *gpio_mock_create(void)
{
    struct gpio_mock *mock = calloc(1, sizeof *mock);
    mock->bed = umockdev_testbed_new();
    if (!umockdev_in_mock_environment()) { /* it cannot tell before there is a testbed */
        g_object_unref(mock->bed);
        free(mock);
        return NULL;
    }
    pthread_mutex_init(&mock->mutex, NULL);
    mock->handler = umockdev_ioctl_base_new();
    g_signal_connect(mock->handler, "handle-ioctl", G_CALLBACK(answer), mock);
    for (int i = 0; i < MOCK_LINES; i++) {
        char name[32], node[32];
        snprintf(name, sizeof name, "gpioline%d", i);
        line_node(i, node);
        add_node(mock, "mock", name, 10 + i);
        attach(mock, node);
        if (i + 1 < MOCK_LINES) {
            snprintf(mock->lines[i].name, sizeof mock->lines[i].name, "LINE%d", i);
        } else {
            snprintf(mock->lines[i].consumer, sizeof mock->lines[i].consumer, "somebody");
        }
    }
    mock->number = 3;
    gpio_mock_plug(mock);
    gpio_mock_refill(mock);
    return mock;
}

void gpio_mock_destroy(struct gpio_mock *mock)
{
    for (int i = 0; i < MOCK_LINES; i++) {
        for (int s = 0; s < mock->lines[i].spare_count; s++) {
            close(mock->lines[i].spares[s]);
        }
    }
    g_object_unref(mock->bed);
    g_object_unref(mock->handler);
    pthread_mutex_destroy(&mock->mutex);
    free(mock);
}

struct mock_line gpio_mock_line(struct gpio_mock *mock, int line)
{
    pthread_mutex_lock(&mock->mutex);
    struct mock_line seen = mock->lines[line].seen;
    /* umockdev does not tell when a descriptor is closed, which is how a line is released. */
    seen.requested = seen.requested && fcntl(mock->lines[line].fd, F_GETFD) >= 0;
    pthread_mutex_unlock(&mock->mutex);
    return seen;
}

void gpio_mock_level(struct gpio_mock *mock, int number, bool level, uint64_t time_us)
{
    char node[32];
    line_node(number, node);
    pthread_mutex_lock(&mock->mutex);
    struct line *line = &mock->lines[number];
    line->seen.level = level;
    int generation = line->seen.requested ? line->generation : 0;
    uint32_t debounce_us = line->seen.debounce_us;
    pthread_mutex_unlock(&mock->mutex);
    struct gpioevent_data first = {.timestamp = time_us * 1000,
                                   .id = level ? GPIOEVENT_EVENT_RISING_EDGE : GPIOEVENT_EVENT_FALLING_EDGE};
    /* What the kernel debounces it reports when it has settled, with that time. */
    struct gpio_v2_line_event second = {.timestamp_ns = (time_us + debounce_us) * 1000,
                                        .id = level ? GPIO_V2_LINE_EVENT_RISING_EDGE : GPIO_V2_LINE_EVENT_FALLING_EDGE,
                                        .offset = (uint32_t)number};
    const void *data = generation == 1 ? (const void *)&first : &second;
    size_t size = generation == 1 ? sizeof first : sizeof second;
    if (generation != 0 && write(umockdev_testbed_get_dev_fd(mock->bed, node), data, size) != (ssize_t)size) {
        perror(node);
        abort();
    }
}
