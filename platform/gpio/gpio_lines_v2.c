/* GPIO lines through libgpiod 2, which speaks the second generation of the kernel's interface: the kernel debounces,
 * and a buffer holds as many edges as we ask for. Every line is a request of its own, so that lines come and go one by
 * one. */
#include "gpio_lines.h"

#include <errno.h>
#include <fcntl.h>
#include <gpiod.h>
#include <stdlib.h>

#include "source_device.h"

enum { KERNEL_EDGES = 256 }; /* kept for a line: two visitors' fast spins between two frames */

/* A chip needs nothing beside libgpiod's own. */
static struct gpiod_chip *chip_of(struct gpio_chip *chip)
{
    return (struct gpiod_chip *)chip;
}

struct gpio_line {
    struct gpiod_line_request *request;
    struct gpiod_edge_event_buffer *events; /* NULL: an output */
    unsigned offset;
    uint32_t debounce_us; /* by the kernel */
};

static int failure(void)
{
    return errno ? errno : ENODEV;
}

static struct gpio_chip *v2_open(void *context, const char *path, int *code)
{
    (void)context;
    errno = 0;
    struct gpiod_chip *chip = gpiod_chip_open(path);
    *code = chip ? 0 : failure();
    return (struct gpio_chip *)chip;
}

static void v2_close(struct gpio_chip *chip)
{
    gpiod_chip_close(chip_of(chip));
}

static void v2_info(struct gpio_chip *chip, struct gpio_chip_info *info)
{
    struct gpiod_chip_info *found = gpiod_chip_get_info(chip_of(chip));
    *info = (struct gpio_chip_info){.lines = 0};
    if (found) {
        device_copy_text(info->name, sizeof info->name, gpiod_chip_info_get_name(found));
        device_copy_text(info->label, sizeof info->label, gpiod_chip_info_get_label(found));
        info->lines = (int)gpiod_chip_info_get_num_lines(found);
        gpiod_chip_info_free(found);
    }
}

static int v2_line_info(struct gpio_chip *chip, int offset, struct gpio_line_info *info)
{
    errno = 0;
    struct gpiod_line_info *found = gpiod_chip_get_line_info(chip_of(chip), (unsigned)offset);
    if (!found) {
        return failure();
    }
    const char *name = gpiod_line_info_get_name(found), *consumer = gpiod_line_info_get_consumer(found);
    device_copy_text(info->name, sizeof info->name, name);
    device_copy_text(info->consumer, sizeof info->consumer, consumer);
    info->used = gpiod_line_info_is_used(found);
    gpiod_line_info_free(found);
    return 0;
}

static bool fill_settings(struct gpiod_line_settings *settings, const struct gpio_line_request *request)
{
    static const enum gpiod_line_bias biases[] = {
        [GPIO_BIAS_AS_IS] = GPIOD_LINE_BIAS_AS_IS,
        [GPIO_BIAS_NONE] = GPIOD_LINE_BIAS_DISABLED,
        [GPIO_BIAS_PULL_UP] = GPIOD_LINE_BIAS_PULL_UP,
        [GPIO_BIAS_PULL_DOWN] = GPIOD_LINE_BIAS_PULL_DOWN,
    };
    gpiod_line_settings_set_active_low(settings, request->active_low);
    if (gpiod_line_settings_set_bias(settings, biases[request->bias]) != 0) {
        return false;
    }
    if (request->output) {
        return gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_OUTPUT) == 0 &&
               gpiod_line_settings_set_output_value(settings, request->value ? GPIOD_LINE_VALUE_ACTIVE
                                                                             : GPIOD_LINE_VALUE_INACTIVE) == 0;
    }
    gpiod_line_settings_set_debounce_period_us(settings, request->debounce_us);
    return gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_INPUT) == 0 &&
           gpiod_line_settings_set_event_clock(settings, GPIOD_LINE_CLOCK_MONOTONIC) == 0 &&
           gpiod_line_settings_set_edge_detection(settings, GPIOD_LINE_EDGE_BOTH) == 0;
}

/* NULL: see errno. */
static struct gpiod_line_request *request_line(struct gpiod_chip *chip, unsigned offset,
                                               const struct gpio_line_request *request)
{
    struct gpiod_line_request *made = NULL;
    struct gpiod_line_settings *settings = gpiod_line_settings_new();
    struct gpiod_line_config *lines = gpiod_line_config_new();
    struct gpiod_request_config *config = gpiod_request_config_new();
    if (settings && lines && config && fill_settings(settings, request) &&
        gpiod_line_config_add_line_settings(lines, &offset, 1, settings) == 0) {
        gpiod_request_config_set_consumer(config, "frond");
        gpiod_request_config_set_event_buffer_size(config, KERNEL_EDGES);
        made = gpiod_chip_request_lines(chip, config, lines);
    }
    int code = errno;
    gpiod_request_config_free(config);
    gpiod_line_config_free(lines);
    gpiod_line_settings_free(settings);
    errno = code;
    return made;
}

/* The kernel's debouncing may be another than was asked for, or none at all before Linux 5.10. */
static uint32_t debounce_in_force(struct gpiod_chip *chip, unsigned offset)
{
    struct gpiod_line_info *info = gpiod_chip_get_line_info(chip, offset);
    uint32_t period = 0;
    if (info && gpiod_line_info_is_debounced(info)) {
        period = (uint32_t)gpiod_line_info_get_debounce_period_us(info);
    }
    gpiod_line_info_free(info);
    return period;
}

static void v2_release(struct gpio_line *line)
{
    if (line->request) {
        gpiod_line_request_release(line->request);
    }
    gpiod_edge_event_buffer_free(line->events);
    free(line);
}

/* Else reading would wait for an edge. */
static bool unblock(struct gpio_line *line)
{
    int fd = gpiod_line_request_get_fd(line->request), flags = fcntl(fd, F_GETFL);
    return flags >= 0 && fcntl(fd, F_SETFL, flags | O_NONBLOCK) == 0;
}

static struct gpio_line *v2_request(struct gpio_chip *chip, int offset, const struct gpio_line_request *request,
                                    int *code)
{
    errno = 0;
    struct gpio_line *line = calloc(1, sizeof *line);
    if (!line) {
        *code = ENOMEM;
        return NULL;
    }
    line->offset = (unsigned)offset;
    line->request = request_line(chip_of(chip), line->offset, request);
    line->events = line->request && !request->output ? gpiod_edge_event_buffer_new(GPIO_EDGES) : NULL;
    if (!line->request || (!request->output && (!line->events || !unblock(line)))) {
        *code = failure();
        v2_release(line);
        return NULL;
    }
    if (!request->output && request->debounce_us > 0) {
        line->debounce_us = debounce_in_force(chip_of(chip), line->offset);
    }
    *code = 0;
    return line;
}

static int v2_fd(const struct gpio_line *line)
{
    return gpiod_line_request_get_fd(line->request);
}

static bool v2_debounced(const struct gpio_line *line)
{
    return line->debounce_us > 0;
}

static int v2_read(struct gpio_line *line, struct gpio_edge *edges)
{
    errno = 0;
    int count = gpiod_line_request_read_edge_events(line->request, line->events, GPIO_EDGES);
    if (count < 0) {
        return errno == EAGAIN || errno == EINTR ? 0 : -failure();
    }
    for (int i = 0; i < count; i++) {
        struct gpiod_edge_event *event = gpiod_edge_event_buffer_get_event(line->events, (unsigned long)i);
        uint64_t time_us = gpiod_edge_event_get_timestamp_ns(event) / 1000u;
        /* The kernel's times are those at which the line had settled. */
        edges[i].time_us = time_us > line->debounce_us ? time_us - line->debounce_us : 0;
        edges[i].active = gpiod_edge_event_get_event_type(event) == GPIOD_EDGE_EVENT_RISING_EDGE;
    }
    return count;
}

static int v2_get(struct gpio_line *line)
{
    errno = 0;
    enum gpiod_line_value value = gpiod_line_request_get_value(line->request, line->offset);
    return value == GPIOD_LINE_VALUE_ERROR ? -failure() : value == GPIOD_LINE_VALUE_ACTIVE;
}

static int v2_set(struct gpio_line *line, bool active)
{
    errno = 0;
    enum gpiod_line_value value = active ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
    return gpiod_line_request_set_value(line->request, line->offset, value) == 0 ? 0 : -failure();
}

const struct gpio_lines_ops gpio_lines_system = {
    .scan = gpio_lines_scan,
    .open = v2_open,
    .close = v2_close,
    .info = v2_info,
    .line_info = v2_line_info,
    .request = v2_request,
    .release = v2_release,
    .fd = v2_fd,
    .debounced = v2_debounced,
    .read = v2_read,
    .get = v2_get,
    .set = v2_set,
    .now_us = gpio_lines_now_us,
};
