/* GPIO lines through libgpiod 1.6, which speaks the first generation of the kernel's interface: no debouncing there, a
 * buffer of 16 edges for each line, times in CLOCK_MONOTONIC since Linux 5.7. Every input is a request of its own, so
 * that lines come and go one by one. */
#include "gpio_lines.h"

#include <errno.h>
#include <fcntl.h>
#include <gpiod.h>
#include <stdlib.h>

#include "source_device.h"

/* libgpiod keeps requested lines inside their chip, so that both are its own structures. */
static struct gpiod_chip *chip_of(struct gpio_chip *chip)
{
    return (struct gpiod_chip *)chip;
}

struct gpio_line {
    struct gpiod_line *line;
    int fd; /* libgpiod's; -1: an output */
};

static struct gpio_chip *v1_open(void *context, const char *path, int *code)
{
    (void)context;
    errno = 0;
    struct gpiod_chip *chip = gpiod_chip_open(path);
    *code = chip ? 0 : errno ? errno : ENODEV;
    return (struct gpio_chip *)chip;
}

static void v1_close(struct gpio_chip *chip)
{
    gpiod_chip_close(chip_of(chip));
}

static void v1_info(struct gpio_chip *chip, struct gpio_chip_info *info)
{
    device_copy_text(info->name, sizeof info->name, gpiod_chip_name(chip_of(chip)));
    device_copy_text(info->label, sizeof info->label, gpiod_chip_label(chip_of(chip)));
    info->lines = (int)gpiod_chip_num_lines(chip_of(chip));
}

static int v1_line_info(struct gpio_chip *chip, int offset, struct gpio_line_info *info)
{
    errno = 0;
    struct gpiod_line *line = gpiod_chip_get_line(chip_of(chip), (unsigned)offset); /* asks the kernel each time */
    if (!line) {
        return errno ? errno : ENODEV;
    }
    const char *name = gpiod_line_name(line), *consumer = gpiod_line_consumer(line);
    device_copy_text(info->name, sizeof info->name, name);
    device_copy_text(info->consumer, sizeof info->consumer, consumer);
    info->used = gpiod_line_is_used(line);
    return 0;
}

static int flags_of(const struct gpio_line_request *request)
{
    static const int biases[] = {
        [GPIO_BIAS_AS_IS] = 0,
        [GPIO_BIAS_NONE] = GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE,
        [GPIO_BIAS_PULL_UP] = GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP,
        [GPIO_BIAS_PULL_DOWN] = GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN,
    };
    return biases[request->bias] | (request->active_low ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0);
}

/* Else reading would wait for an edge. */
static int unblocked_fd(struct gpiod_line *line)
{
    int fd = gpiod_line_event_get_fd(line);
    int flags = fd < 0 ? -1 : fcntl(fd, F_GETFL);
    return flags < 0 || fcntl(fd, F_SETFL, flags | O_NONBLOCK) < 0 ? -1 : fd;
}

static struct gpio_line *v1_request(struct gpio_chip *chip, int offset, const struct gpio_line_request *request,
                                    int *code)
{
    struct gpiod_line_request_config config = {
        .consumer = "frond",
        .request_type = request->output ? GPIOD_LINE_REQUEST_DIRECTION_OUTPUT : GPIOD_LINE_REQUEST_EVENT_BOTH_EDGES,
        .flags = flags_of(request),
    };
    errno = 0;
    struct gpio_line *line = malloc(sizeof *line);
    struct gpiod_line *found = line ? gpiod_chip_get_line(chip_of(chip), (unsigned)offset) : NULL;
    if (!found || gpiod_line_request(found, &config, request->value) != 0) {
        *code = errno ? errno : ENODEV;
        free(line);
        return NULL;
    }
    *line = (struct gpio_line){found, request->output ? -1 : unblocked_fd(found)};
    if (!request->output && line->fd < 0) {
        *code = errno;
        gpiod_line_release(found);
        free(line);
        return NULL;
    }
    *code = 0;
    return line;
}

static void v1_release(struct gpio_line *line)
{
    gpiod_line_release(line->line);
    free(line);
}

static int v1_fd(const struct gpio_line *line)
{
    return line->fd;
}

static bool v1_debounced(const struct gpio_line *line)
{
    (void)line;
    return false;
}

static int v1_read(struct gpio_line *line, struct gpio_edge *edges)
{
    struct gpiod_line_event events[GPIO_EDGES];
    errno = 0;
    int count = gpiod_line_event_read_fd_multiple(line->fd, events, GPIO_EDGES);
    if (count < 0) {
        return errno == EAGAIN || errno == EINTR ? 0 : errno ? -errno : -ENODEV;
    }
    for (int i = 0; i < count; i++) {
        edges[i].time_us = (uint64_t)events[i].ts.tv_sec * 1000000u + (uint64_t)events[i].ts.tv_nsec / 1000u;
        edges[i].active = events[i].event_type == GPIOD_LINE_EVENT_RISING_EDGE;
    }
    return count;
}

static int v1_get(struct gpio_line *line)
{
    errno = 0;
    int value = gpiod_line_get_value(line->line);
    return value >= 0 ? value : errno ? -errno : -ENODEV;
}

static int v1_set(struct gpio_line *line, bool active)
{
    errno = 0;
    if (gpiod_line_set_value(line->line, active) == 0) {
        return 0;
    }
    return errno ? -errno : -ENODEV;
}

const struct gpio_lines_ops gpio_lines_system = {
    .scan = gpio_lines_scan,
    .open = v1_open,
    .close = v1_close,
    .info = v1_info,
    .line_info = v1_line_info,
    .request = v1_request,
    .release = v1_release,
    .fd = v1_fd,
    .debounced = v1_debounced,
    .read = v1_read,
    .get = v1_get,
    .set = v1_set,
    .now_us = gpio_lines_now_us,
};
