#include "source_fake.h"

#include <stdlib.h>
#include <string.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "source_queue.h"

enum { HELD_MAX = 64 };

struct held { /* the last word of a finger or a control that is not at rest */
    int device;
    struct event event;
};

struct source_fake {
    struct source source;
    struct source_queue queue;
    struct source_fake_def def;
    struct device devices[SOURCE_FAKE_DEVICES];
    bool present[SOURCE_FAKE_DEVICES];
    struct source_fake_step *steps;
    int next;
    uint64_t begun_us; /* of this round of the table */
    struct held held[HELD_MAX];
    int held_count;
    float lamps[SOURCE_FAKE_LAMPS];
    int lamp_orders;
    int fd;
};

static struct source_fake *fake_of(struct source *source)
{
    return (struct source_fake *)source;
}

static const struct source_fake *const_fake_of(const struct source *source)
{
    return (const struct source_fake *)source;
}

static uint64_t now_us(const struct source_fake *fake)
{
    return fake->def.clock ? fake->def.clock(fake->def.user) : source_now_us();
}

static void wake(struct source_fake *fake)
{
    const uint64_t one = 1;
    (void)!write(fake->fd, &one, sizeof one);
}

static bool is_finger(const struct event *event)
{
    return event->kind == EVENT_DOWN || event->kind == EVENT_MOVE || event->kind == EVENT_UP ||
           event->kind == EVENT_CANCEL;
}

static bool at_rest(const struct event *event)
{
    if (event->kind == EVENT_CONTROL) {
        return event->relative || event->null || event->value == 0;
    }
    return event->kind != EVENT_DOWN && event->kind != EVENT_MOVE;
}

static bool same(const struct event *a, const struct event *b)
{
    if (is_finger(a) || is_finger(b)) {
        return is_finger(a) && is_finger(b) && a->slot == b->slot;
    }
    return a->control == b->control && a->index == b->index;
}

static void remember(struct source_fake *fake, int device, const struct event *event)
{
    if (!is_finger(event) && event->kind != EVENT_CONTROL) {
        return;
    }
    for (int i = 0; i < fake->held_count; i++) {
        if (fake->held[i].device == device && same(&fake->held[i].event, event)) {
            fake->held[i] = fake->held[--fake->held_count];
            break;
        }
    }
    if (!at_rest(event) && fake->held_count < HELD_MAX) {
        fake->held[fake->held_count++] = (struct held){device, *event};
    }
}

static void post(struct source_fake *fake, int device, const struct event *event)
{
    struct event said = *event;
    said.source = fake->def.source;
    said.device = fake->devices[device].id;
    said.time_us = said.time_us ? said.time_us : now_us(fake);
    remember(fake, device, &said);
    source_post(&fake->queue, &said);
    wake(fake);
}

static bool exists(const struct source_fake *fake, int device)
{
    return device >= 0 && device < fake->def.device_count;
}

static void arrive(struct source_fake *fake, int device, uint64_t time_us)
{
    if (exists(fake, device) && !fake->present[device]) {
        fake->present[device] = true;
        post(fake, device, &(struct event){.kind = EVENT_ARRIVED, .time_us = time_us});
        source_note(&fake->queue, "'%s' has arrived", fake->devices[device].name);
    }
}

static void leave(struct source_fake *fake, int device, uint64_t time_us)
{
    if (!exists(fake, device) || !fake->present[device]) {
        return;
    }
    for (int i = fake->held_count - 1; i >= 0; i--) {
        struct event event = fake->held[i].event;
        if (fake->held[i].device != device) {
            continue;
        }
        event.kind = is_finger(&event) ? EVENT_UP : EVENT_CONTROL;
        event.time_us = time_us;
        event.value = 0;
        post(fake, device, &event); /* takes it off the list */
    }
    post(fake, device, &(struct event){.kind = EVENT_LEFT, .time_us = time_us});
    source_note(&fake->queue, "'%s' has left", fake->devices[device].name);
    fake->present[device] = false;
}

static void destroy(struct source *source)
{
    struct source_fake *fake = fake_of(source);
    if (fake->fd >= 0) {
        close(fake->fd);
    }
    free(fake->steps);
    free(fake);
}

static int get_fd(const struct source *source)
{
    return const_fake_of(source)->fd;
}

static int get_timeout(const struct source *source)
{
    const struct source_fake *fake = const_fake_of(source);
    if (fake->queue.count > 0) {
        return 0;
    }
    if (fake->next >= fake->def.step_count && fake->def.period_us == 0) {
        return -1;
    }
    uint64_t due =
        fake->begun_us + (fake->next < fake->def.step_count ? fake->steps[fake->next].at_us : fake->def.period_us);
    uint64_t now = now_us(fake), left = due > now ? (due - now + 999) / 1000 : 0;
    return left > 60000 ? 60000 : (int)left;
}

static void play(struct source_fake *fake, const struct source_fake_step *step)
{
    uint64_t time_us = fake->begun_us + step->at_us;
    if (step->action == FAKE_ARRIVE) {
        arrive(fake, step->device, time_us);
    } else if (step->action == FAKE_LEAVE) {
        leave(fake, step->device, time_us);
    } else if (fake->present[step->device]) {
        struct event event = step->event;
        event.time_us = time_us;
        post(fake, step->device, &event);
    }
}

static void dispatch(struct source *source)
{
    struct source_fake *fake = fake_of(source);
    uint64_t now = now_us(fake), drained;
    (void)!read(fake->fd, &drained, sizeof drained);
    for (;;) {
        while (fake->next < fake->def.step_count && fake->begun_us + fake->steps[fake->next].at_us <= now) {
            play(fake, &fake->steps[fake->next++]);
        }
        if (fake->def.period_us == 0 || fake->next < fake->def.step_count ||
            fake->begun_us + fake->def.period_us > now) {
            return;
        }
        fake->begun_us += fake->def.period_us;
        fake->next = 0;
    }
}

static bool get_event(struct source *source, struct event *event)
{
    return source_take(&fake_of(source)->queue, event);
}

static int get_devices(const struct source *source, struct device *devices, int most)
{
    const struct source_fake *fake = const_fake_of(source);
    int count = 0;
    for (int i = 0; i < fake->def.device_count; i++) {
        if (fake->present[i]) {
            if (count < most) {
                devices[count] = fake->devices[i];
            }
            count++;
        }
    }
    return count;
}

static bool set_lamp(struct source *source, int lamp, float level)
{
    struct source_fake *fake = fake_of(source);
    if (lamp < 0 || lamp >= fake->def.lamps) {
        return false;
    }
    fake->lamps[lamp] = level;
    fake->lamp_orders++;
    return true;
}

static bool get_line(struct source *source, char *line, int size)
{
    return source_take_line(&fake_of(source)->queue, line, size);
}

static bool check(const struct source_fake_def *def, struct device_error *error)
{
    int devices = def->device_count > 0 ? def->device_count : 1;
    if (devices > SOURCE_FAKE_DEVICES || def->lamps < 0 || def->lamps > SOURCE_FAKE_LAMPS) {
        return device_fail(error, "fake: %d devices and %d lamps; at most %d and %d", devices, def->lamps,
                           SOURCE_FAKE_DEVICES, SOURCE_FAKE_LAMPS);
    }
    for (int i = 0; i < def->step_count; i++) {
        const struct source_fake_step *step = &def->steps[i];
        if (step->device < 0 || step->device >= devices) {
            return device_fail(error, "fake: step %d is of device %d; there are %d", i, step->device, devices);
        }
        if ((i > 0 && step->at_us < def->steps[i - 1].at_us) || (def->period_us && step->at_us > def->period_us)) {
            return device_fail(error, "fake: step %d is out of the order of time", i);
        }
    }
    return true;
}

static const struct source_ops ops = {.name = "fake",
                                      .destroy = destroy,
                                      .fd = get_fd,
                                      .timeout_ms = get_timeout,
                                      .dispatch = dispatch,
                                      .event = get_event,
                                      .devices = get_devices,
                                      .lamp = set_lamp,
                                      .log = get_line};

struct source *source_fake_create(const struct source_fake_def *def, struct device_error *error)
{
    if (!check(def, error)) {
        return NULL;
    }
    struct source_fake *fake = calloc(1, sizeof *fake);
    struct source_fake_step *steps = calloc((size_t)def->step_count + 1, sizeof *steps);
    int fd = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    if (!fake || !steps || fd < 0) {
        free(fake);
        free(steps);
        if (fd >= 0) {
            close(fd);
        }
        device_fail(error, "fake: memory or descriptors are short");
        return NULL;
    }
    fake->source.ops = &ops;
    fake->def = *def;
    fake->def.device_count = def->device_count > 0 ? def->device_count : 1;
    fake->fd = fd;
    fake->steps = steps;
    if (def->step_count > 0) {
        memcpy(steps, def->steps, (size_t)def->step_count * sizeof *steps);
    }
    for (int i = 0; i < fake->def.device_count; i++) {
        fake->devices[i] = def->device_count > 0 ? def->devices[i] : (struct device){.name = "fake", .admitted = true};
        fake->devices[i].id = (uint32_t)i + 1;
        fake->devices[i].class = fake->devices[i].class ? fake->devices[i].class : "device";
    }
    fake->begun_us = now_us(fake);
    for (int i = 0; i < fake->def.device_count && !def->absent; i++) {
        arrive(fake, i, fake->begun_us);
    }
    return &fake->source;
}

void source_fake_arrive(struct source *source, int device)
{
    arrive(fake_of(source), device, 0);
}

void source_fake_leave(struct source *source, int device)
{
    leave(fake_of(source), device, 0);
}

void source_fake_post(struct source *source, int device, const struct event *event)
{
    struct source_fake *fake = fake_of(source);
    if (exists(fake, device) && fake->present[device]) {
        post(fake, device, event);
    }
}

float source_fake_lamp(const struct source *source, int lamp)
{
    const struct source_fake *fake = const_fake_of(source);
    return lamp >= 0 && lamp < fake->def.lamps ? fake->lamps[lamp] : 0;
}

int source_fake_lamp_orders(const struct source *source)
{
    return const_fake_of(source)->lamp_orders;
}
