#include "source_gpio.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>

#include "debounce.h"
#include "encoder.h"
#include "gpio_bank.h"
#include "gpio_definition.h"
#include "source_queue.h"

enum {
    PENDING = 1024,        /* edges that are read and not told yet */
    PASSES = 8,            /* over lines that have edges, in a dispatch */
    STALE_US = 10000000,   /* no interrupt is reported so late: its clock is another (Linux before 5.7) */
    RESTLESS_US = 1000000, /* a contact that bounces for so long is said in the log */
    ENCODER_ERRORS = 50,   /* lost edges, and that a tenth of all, before it is said */
};

struct pending {
    struct gpio_edge edge;
    int line;
};

struct button {
    struct debounce debounce;
    bool down; /* as told */
    bool said; /* that it does not come to rest */
};

struct knob {
    struct encoder encoder;
    bool ready; /* both lines are held */
    bool reversed, said;
};

struct lamp {
    bool wanted, lit;
    uint64_t free_us; /* may be switched again */
};

struct source_gpio {
    struct source source;
    struct source_queue queue;
    struct gpio_bank bank;
    int button_count, knob_count, lamp_count;
    struct button buttons[GPIO_LINES];
    struct knob knobs[GPIO_LINES];
    struct lamp lamps[GPIO_LINES];
    struct pending pending[PENDING]; /* in the order of their times */
    int pending_count;
};

static uint64_t now_of(const struct source_gpio *gpio)
{
    return gpio->bank.ops->now_us(gpio->bank.context);
}

static int lamp_line(const struct source_gpio *gpio, int lamp)
{
    return gpio->button_count + 2 * gpio->knob_count + lamp;
}

/* ---- events */

static void post(struct source_gpio *gpio, enum event_kind kind, uint32_t device, uint64_t time_us)
{
    source_post(&gpio->queue,
                &(struct event){.kind = kind, .source = SOURCE_GPIO, .time_us = time_us, .device = device});
}

static uint32_t device_of(const struct source_gpio *gpio, int line)
{
    return gpio->bank.chips[gpio->bank.lines[line].place].device;
}

/* Of a button: its number is that of its line. */
static void post_line(struct source_gpio *gpio, enum event_kind kind, int line, uint64_t time_us, bool down)
{
    source_post(&gpio->queue, &(struct event){.kind = kind,
                                              .source = SOURCE_GPIO,
                                              .time_us = time_us,
                                              .device = device_of(gpio, line),
                                              .control = (uint32_t)line,
                                              .value = down});
}

static void post_steps(struct source_gpio *gpio, int control, int line, uint64_t time_us, int steps)
{
    source_post(&gpio->queue, &(struct event){.kind = EVENT_CONTROL,
                                              .source = SOURCE_GPIO,
                                              .time_us = time_us,
                                              .device = device_of(gpio, line),
                                              .control = (uint32_t)control,
                                              .relative = true,
                                              .value = (float)steps});
}

static void tell_button(struct source_gpio *gpio, int number, const struct transition *transition)
{
    struct button *button = &gpio->buttons[number];
    if (transition->level != button->down) {
        button->down = transition->level;
        post_line(gpio, EVENT_CONTROL, number, transition->time_us, transition->level);
    }
}

static void move_knob(struct source_gpio *gpio, int number, uint64_t time_us)
{
    struct knob *knob = &gpio->knobs[number];
    int a = gpio->button_count + 2 * number;
    if (!knob->ready) {
        return;
    }
    int detents = encoder_levels(&knob->encoder, time_us, gpio->bank.lines[a].level, gpio->bank.lines[a + 1].level);
    if (detents != 0) {
        post_steps(gpio, gpio->button_count + number, a, time_us, knob->reversed ? -detents : detents);
    }
    if (!knob->said && knob->encoder.errors >= ENCODER_ERRORS &&
        knob->encoder.errors * 10 >= knob->encoder.transitions) {
        knob->said = true;
        source_note(&gpio->queue, "%s misses steps: %llu of %llu; its lines bounce, or are not its own",
                    gpio->bank.lines[a].title, (unsigned long long)knob->encoder.errors,
                    (unsigned long long)knob->encoder.transitions);
    }
}

/* ---- edges */

static void apply(struct source_gpio *gpio, int line, uint64_t time_us, bool level)
{
    struct transition transition;
    gpio->bank.lines[line].level = level;
    if (line >= gpio->button_count) {
        move_knob(gpio, (line - gpio->button_count) / 2, time_us);
    } else if (debounce_edge(&gpio->buttons[line].debounce, time_us, level, &transition)) {
        tell_button(gpio, line, &transition);
    }
}

/* After the last with the same time or an earlier one; lines are read one after the other. */
static void insert(struct source_gpio *gpio, int line, struct gpio_edge edge)
{
    int place = gpio->pending_count++;
    for (; place > 0 && gpio->pending[place - 1].edge.time_us > edge.time_us; place--) {
        gpio->pending[place] = gpio->pending[place - 1];
    }
    gpio->pending[place] = (struct pending){edge, line};
}

/* How many edges were read. */
static int read_line(struct source_gpio *gpio, int number, bool broken)
{
    struct bank_line *line = &gpio->bank.lines[number];
    struct gpio_edge edges[GPIO_EDGES];
    int total = 0, count = GPIO_EDGES;
    while (line->line && count == GPIO_EDGES && gpio->pending_count + GPIO_EDGES <= PENDING) {
        count = gpio->bank.ops->read(line->line, edges);
        uint64_t now = now_of(gpio);
        for (int i = 0; i < count; i++) {
            if (edges[i].time_us > now || edges[i].time_us + STALE_US < now) {
                edges[i].time_us = now;
            }
            insert(gpio, number, edges[i]);
        }
        total += count > 0 ? count : 0;
    }
    if (line->line && (count < 0 || (broken && total == 0))) {
        bank_lose(&gpio->bank, number, count < 0 ? count : -ENODEV);
    }
    line->stirred |= total > 0;
    return total;
}

static int read_lines(struct source_gpio *gpio)
{
    struct epoll_event ready[GPIO_LINES];
    int count = epoll_wait(gpio->bank.epoll, ready, GPIO_LINES, 0), total = 0;
    for (int i = 0; i < count; i++) {
        total += read_line(gpio, (int)ready[i].data.u32, ready[i].events & (EPOLLHUP | EPOLLERR));
    }
    return total;
}

static void apply_until(struct source_gpio *gpio, uint64_t time_us)
{
    int told = 0;
    for (; told < gpio->pending_count && gpio->pending[told].edge.time_us <= time_us; told++) {
        const struct pending *pending = &gpio->pending[told];
        if (gpio->bank.lines[pending->line].line) {
            apply(gpio, pending->line, pending->edge.time_us, pending->edge.active);
        }
    }
    gpio->pending_count -= told;
    memmove(gpio->pending, gpio->pending + told, (size_t)gpio->pending_count * sizeof gpio->pending[0]);
}

/* An edge of B must not be told before one of A that came earlier and was not read yet. Those up to the start of a pass
 * have all been read by its end; later ones wait for the next. */
static void read_edges(struct source_gpio *gpio)
{
    for (int pass = 0; pass < PASSES; pass++) {
        uint64_t start = now_of(gpio);
        int read = read_lines(gpio);
        apply_until(gpio, start);
        if (read == 0 && gpio->pending_count == 0) {
            return;
        }
    }
}

/* The kernel drops edges when its buffer is full: what the level is now tells where they have led. */
static void read_levels(struct source_gpio *gpio)
{
    for (int i = 0; i < gpio->bank.count; i++) {
        struct bank_line *line = &gpio->bank.lines[i];
        if (!line->line || !line->stirred) {
            continue;
        }
        line->stirred = false;
        int level = gpio->bank.ops->get(line->line);
        if (level < 0) {
            bank_lose(&gpio->bank, i, level);
        } else if ((level > 0) != line->level) {
            apply(gpio, i, now_of(gpio), level > 0);
        }
    }
}

static void settle_buttons(struct source_gpio *gpio)
{
    uint64_t now = now_of(gpio);
    for (int i = 0; i < gpio->button_count; i++) {
        struct button *button = &gpio->buttons[i];
        struct transition transition;
        if (gpio->bank.lines[i].line && debounce_time(&button->debounce, now, &transition)) {
            tell_button(gpio, i, &transition);
        }
        if (!button->said && debounce_restless_us(&button->debounce, now) > RESTLESS_US) {
            button->said = true;
            source_note(&gpio->queue, "%s does not come to rest: a loose contact, or no pull on the line?",
                        gpio->bank.lines[i].title);
        }
    }
}

/* ---- chips and lines that come and go */

static void lose_line(struct source_gpio *gpio, int line)
{
    if (line < gpio->button_count) {
        struct button *button = &gpio->buttons[line];
        if (button->down) {
            post_line(gpio, EVENT_CONTROL, line, now_of(gpio), false);
        }
        *button = (struct button){.down = false};
    } else if (line < lamp_line(gpio, 0)) {
        gpio->knobs[(line - gpio->button_count) / 2].ready = false;
    }
}

static void start_line(struct source_gpio *gpio, int number)
{
    struct bank_line *line = &gpio->bank.lines[number];
    if (number < gpio->button_count) {
        struct button *button = &gpio->buttons[number];
        uint32_t settle_us = gpio->bank.ops->debounced(line->line) ? 0 : line->request.debounce_us;
        *button = (struct button){.down = line->level};
        debounce_init(&button->debounce, settle_us, line->level);
        if (line->level) {
            post_line(gpio, EVENT_STANDING, number, now_of(gpio), true);
        }
        return;
    }
    if (number >= lamp_line(gpio, 0)) {
        gpio->lamps[number - lamp_line(gpio, 0)].lit = line->request.value;
        return;
    }
    int knob = (number - gpio->button_count) / 2, a = gpio->button_count + 2 * knob;
    gpio->knobs[knob].ready = gpio->bank.lines[a].line && gpio->bank.lines[a + 1].line;
    if (gpio->knobs[knob].ready) {
        struct encoder *encoder = &gpio->knobs[knob].encoder;
        encoder_init(encoder, encoder->steps, gpio->bank.lines[a].level, gpio->bank.lines[a + 1].level);
    }
}

/* What the bank has found: releases before EVENT_LEFT, EVENT_ARRIVED before all else of a chip. */
static void follow_bank(struct source_gpio *gpio)
{
    struct gpio_bank *bank = &gpio->bank;
    for (int i = 0; i < bank->count; i++) {
        if (bank->lines[i].lost) {
            bank->lines[i].lost = false;
            lose_line(gpio, i);
        }
    }
    for (int i = 0; i < BANK_CHIPS; i++) {
        if (bank->chips[i].left) {
            post(gpio, EVENT_LEFT, bank->chips[i].device, now_of(gpio));
        }
    }
    bank_forget(bank);
    for (int i = 0; i < BANK_CHIPS; i++) {
        struct bank_chip *chip = &bank->chips[i];
        if (chip->chip && chip->fresh) {
            chip->fresh = false;
            source_note(&gpio->queue, "%s '%s' is there: %d of its lines are used", chip->info.name, chip->info.label,
                        chip->held);
            post(gpio, EVENT_ARRIVED, chip->device, now_of(gpio));
        }
    }
    for (int i = 0; i < bank->count; i++) {
        if (bank->lines[i].fresh) {
            bank->lines[i].fresh = false;
            start_line(gpio, i);
        }
    }
}

/* ---- lamps */

static void switch_lamp(struct source_gpio *gpio, int number)
{
    struct lamp *lamp = &gpio->lamps[number];
    struct bank_line *line = &gpio->bank.lines[lamp_line(gpio, number)];
    line->request.value = lamp->wanted; /* when it is taken again */
    if (!line->line || lamp->wanted == lamp->lit) {
        return;
    }
    uint64_t now = now_of(gpio);
    if (now < lamp->free_us) {
        return;
    }
    lamp->free_us = now + GPIO_LAMP_US;
    lamp->lit = lamp->wanted;
    int status = gpio->bank.ops->set(line->line, lamp->lit);
    if (status < 0) {
        bank_lose(&gpio->bank, lamp_line(gpio, number), status);
        follow_bank(gpio);
    }
}

static bool gpio_lamp(struct source *source, int lamp, float level)
{
    struct source_gpio *gpio = (struct source_gpio *)source;
    if (lamp < 0 || lamp >= gpio->lamp_count) {
        return false;
    }
    gpio->lamps[lamp].wanted = level >= .5f;
    switch_lamp(gpio, lamp);
    return true;
}

/* ---- the source */

static void gpio_dispatch(struct source *source)
{
    struct source_gpio *gpio = (struct source_gpio *)source;
    read_edges(gpio);
    if (gpio->bank.retry_us > 0 && now_of(gpio) >= gpio->bank.retry_us) {
        bank_check(&gpio->bank);
    }
    follow_bank(gpio);
    read_levels(gpio);
    follow_bank(gpio);
    settle_buttons(gpio);
    for (int i = 0; i < gpio->lamp_count; i++) {
        switch_lamp(gpio, i);
    }
}

static uint64_t sooner(uint64_t a, uint64_t b)
{
    return b != 0 && (a == 0 || b < a) ? b : a;
}

static int gpio_timeout(const struct source *source)
{
    const struct source_gpio *gpio = (const struct source_gpio *)source;
    uint64_t due = gpio->bank.retry_us, now = now_of(gpio);
    for (int i = 0; i < gpio->button_count; i++) {
        due = sooner(due, debounce_due_us(&gpio->buttons[i].debounce));
    }
    for (int i = 0; i < gpio->lamp_count; i++) {
        const struct lamp *lamp = &gpio->lamps[i];
        if (lamp->lit != lamp->wanted && gpio->bank.lines[lamp_line(gpio, i)].line) {
            due = sooner(due, lamp->free_us);
        }
    }
    if (gpio->pending_count > 0) {
        return 0;
    }
    if (due == 0) {
        return -1;
    }
    return due <= now ? 0 : (int)((due - now + 999) / 1000);
}

static int gpio_fd(const struct source *source)
{
    return ((const struct source_gpio *)source)->bank.epoll;
}

static bool gpio_event(struct source *source, struct event *event)
{
    return source_take(&((struct source_gpio *)source)->queue, event);
}

static bool gpio_log(struct source *source, char *line, int size)
{
    return source_take_line(&((struct source_gpio *)source)->queue, line, size);
}

static int gpio_devices(const struct source *source, struct device *devices, int most)
{
    return bank_devices(&((const struct source_gpio *)source)->bank, devices, most);
}

static void gpio_destroy(struct source *source)
{
    struct source_gpio *gpio = (struct source_gpio *)source;
    for (int i = 0; i < gpio->lamp_count; i++) {
        struct bank_line *line = &gpio->bank.lines[lamp_line(gpio, i)];
        if (line->line && gpio->lamps[i].lit) {
            (void)gpio->bank.ops->set(line->line, false);
        }
    }
    bank_stop(&gpio->bank);
    free(gpio);
}

static const struct source_ops gpio_ops = {
    .name = "gpio",
    .destroy = gpio_destroy,
    .fd = gpio_fd,
    .timeout_ms = gpio_timeout,
    .dispatch = gpio_dispatch,
    .event = gpio_event,
    .devices = gpio_devices,
    .lamp = gpio_lamp,
    .log = gpio_log,
};

struct source *source_gpio_create_on(const struct source_gpio_def *def, const struct gpio_lines_ops *ops, void *context,
                                     struct device_error *error)
{
    if (!gpio_definition_check(def, error)) {
        return NULL;
    }
    struct source_gpio *gpio = calloc(1, sizeof *gpio);
    if (!gpio) {
        device_fail(error, "GPIO: not enough memory");
        return NULL;
    }
    gpio->source.ops = &gpio_ops;
    gpio->bank.ops = ops;
    gpio->bank.context = context;
    gpio->bank.queue = &gpio->queue;
    gpio->button_count = def->button_count;
    gpio->knob_count = def->encoder_count;
    gpio->lamp_count = def->lamp_count;
    for (int i = 0; i < def->encoder_count; i++) {
        gpio->knobs[i].encoder.steps = def->encoders[i].steps;
        gpio->knobs[i].reversed = def->encoders[i].reversed;
    }
    gpio_definition_lines(def, &gpio->bank);
    if (!bank_start(&gpio->bank)) {
        device_fail(error, "GPIO: %s", strerror(errno));
        gpio_destroy(&gpio->source);
        return NULL;
    }
    bank_check(&gpio->bank);
    follow_bank(gpio);
    return &gpio->source;
}

struct source *source_gpio_create(const struct source_gpio_def *def, struct device_error *error)
{
    return source_gpio_create_on(def, &gpio_lines_system, NULL, error);
}

int source_gpio_lines(const struct source *source, uint32_t device, struct gpio_line_info *lines, int most)
{
    return bank_line_infos(&((const struct source_gpio *)source)->bank, device, lines, most);
}
