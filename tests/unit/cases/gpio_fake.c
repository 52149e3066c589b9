#include "gpio_fake.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/eventfd.h>
#include <unistd.h>

struct gpio_chip {
    struct gpio_fake *fake;
    int number, generation;
};

struct gpio_line {
    struct gpio_fake *fake;
    int number, generation, offset;
    int fd; /* readable while there are edges */
    struct gpio_edge edges[GPIO_EDGES];
    int count;
};

struct fake_chip *fake_plug(struct gpio_fake *fake, int number, const char *label, int lines)
{
    struct fake_chip *chip = &fake->chips[number];
    *chip = (struct fake_chip){.there = true, .generation = chip->generation + 1, .lines = lines};
    snprintf(chip->label, sizeof chip->label, "%s", label);
    return chip;
}

void fake_unplug(struct gpio_fake *fake, int number)
{
    struct fake_chip *chip = &fake->chips[number];
    for (int i = 0; i < chip->lines; i++) {
        if (chip->line[i].held) { /* wakes whoever waits, as the kernel does */
            eventfd_write(chip->line[i].held->fd, 1);
            chip->line[i].held = NULL;
        }
    }
    chip->there = false;
    chip->generation++;
}

void fake_level_unheard(struct gpio_fake *fake, int number, int offset, bool level)
{
    fake->chips[number].line[offset].level = level;
}

void fake_level(struct gpio_fake *fake, int number, int offset, bool level)
{
    struct fake_line *line = &fake->chips[number].line[offset];
    struct gpio_line *held = line->held;
    if (line->level == level) {
        return;
    }
    line->level = level;
    if (held && !line->request.output && held->count < GPIO_EDGES) {
        held->edges[held->count++] = (struct gpio_edge){fake->now_us, level};
        eventfd_write(held->fd, 1);
    }
}

static int fake_scan(void *context, char (*paths)[GPIO_PATH], int most)
{
    struct gpio_fake *fake = context;
    int count = 0;
    fake->calls++;
    for (int i = 0; i < FAKE_CHIPS && count < most; i++) {
        if (fake->chips[i].there) {
            snprintf(paths[count++], GPIO_PATH, "/dev/gpiochip%d", i);
        }
    }
    return count;
}

static struct gpio_chip *fake_open(void *context, const char *path, int *code)
{
    struct gpio_fake *fake = context;
    int number = atoi(path + strlen("/dev/gpiochip"));
    fake->calls++;
    *code = fake->chips[number].there ? fake->chips[number].denied : ENOENT;
    struct gpio_chip *chip = *code == 0 ? malloc(sizeof *chip) : NULL;
    if (chip) {
        *chip = (struct gpio_chip){fake, number, fake->chips[number].generation};
        fake->open_chips++;
        fake->opened++;
    }
    return chip;
}

static void fake_close(struct gpio_chip *chip)
{
    chip->fake->open_chips--;
    free(chip);
}

/* 0 or an errno. */
static int state_of(struct gpio_fake *fake, int number, int generation)
{
    fake->calls++;
    return fake->chips[number].generation == generation ? fake->chips[number].broken : ENODEV;
}

static void fake_info(struct gpio_chip *chip, struct gpio_chip_info *info)
{
    snprintf(info->name, sizeof info->name, "gpiochip%d", chip->number);
    snprintf(info->label, sizeof info->label, "%s", chip->fake->chips[chip->number].label);
    info->lines = chip->fake->chips[chip->number].lines;
}

static int fake_line_info(struct gpio_chip *chip, int offset, struct gpio_line_info *info)
{
    int code = state_of(chip->fake, chip->number, chip->generation);
    if (code == 0) {
        const struct fake_line *line = &chip->fake->chips[chip->number].line[offset];
        snprintf(info->name, sizeof info->name, "%s", line->name);
        snprintf(info->consumer, sizeof info->consumer, "%s", line->held ? "frond" : line->consumer);
        info->used = line->held || line->consumer[0];
    }
    return code;
}

static struct gpio_line *fake_request(struct gpio_chip *chip, int offset, const struct gpio_line_request *request,
                                      int *code)
{
    struct fake_line *line = &chip->fake->chips[chip->number].line[offset];
    *code = state_of(chip->fake, chip->number, chip->generation);
    if (*code == 0 && (line->held || line->consumer[0])) {
        *code = EBUSY;
    }
    struct gpio_line *held = *code == 0 ? calloc(1, sizeof *held) : NULL;
    if (held) {
        *held = (struct gpio_line){.fake = chip->fake,
                                   .number = chip->number,
                                   .generation = chip->generation,
                                   .offset = offset,
                                   .fd = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)};
        line->held = held;
        line->request = *request;
        line->level = request->output ? request->value : line->level;
        chip->fake->held_lines++;
    }
    return held;
}

static struct fake_line *line_of(const struct gpio_line *line)
{
    return &line->fake->chips[line->number].line[line->offset];
}

static void fake_release(struct gpio_line *line)
{
    if (line_of(line)->held == line) {
        line_of(line)->held = NULL;
    }
    line->fake->held_lines--;
    close(line->fd);
    free(line);
}

static int fake_fd(const struct gpio_line *line)
{
    return line->fd;
}

static bool fake_debounced(const struct gpio_line *line)
{
    return line->fake->debounces && line_of(line)->request.debounce_us > 0;
}

static int fake_read(struct gpio_line *line, struct gpio_edge *edges)
{
    int code = state_of(line->fake, line->number, line->generation), count = line->count;
    eventfd_t ignored;
    if (code != 0) {
        return -code;
    }
    memcpy(edges, line->edges, sizeof line->edges);
    line->count = 0;
    eventfd_read(line->fd, &ignored);
    return count;
}

static int fake_get(struct gpio_line *line)
{
    int code = state_of(line->fake, line->number, line->generation);
    if (line_of(line)->request.output && line->fake->chips[line->number].mute) {
        return -EIO;
    }
    return code ? -code : line_of(line)->level;
}

static int fake_set(struct gpio_line *line, bool active)
{
    int code = state_of(line->fake, line->number, line->generation);
    if (code == 0) {
        line_of(line)->level = active;
        line_of(line)->switched++;
    }
    return -code;
}

static uint64_t fake_now(void *context)
{
    return ((struct gpio_fake *)context)->now_us;
}

const struct gpio_lines_ops gpio_fake_ops = {
    .scan = fake_scan,
    .open = fake_open,
    .close = fake_close,
    .info = fake_info,
    .line_info = fake_line_info,
    .request = fake_request,
    .release = fake_release,
    .fd = fake_fd,
    .debounced = fake_debounced,
    .read = fake_read,
    .get = fake_get,
    .set = fake_set,
    .now_us = fake_now,
};
