#include "lamps.h"

#include <math.h>

static const float STEP = 0.02f; /* what an eye sees at most */
static const float TURN = 6.2831853f;

static struct lamps_device *find(struct lamps *lamps, uint32_t device)
{
    struct lamps_device *room = NULL;
    for (int i = 0; i < LAMPS_DEVICES; i++) {
        if (lamps->devices[i].controllers && lamps->devices[i].device == device) {
            return &lamps->devices[i];
        }
        room = lamps->devices[i].controllers || room ? room : &lamps->devices[i];
    }
    return room;
}

void lamps_introduce(struct lamps *lamps, enum event_source source, const struct device *device)
{
    const struct inputs *inputs = lamps->inputs;
    struct lamps_device *found = source == SOURCE_HID ? find(lamps, device->id) : NULL;
    if (!found) {
        return;
    }
    *found = (struct lamps_device){.device = device->id};
    for (int i = 0; i < inputs->light_count; i++) {
        const struct inputs_device *of = &inputs->controllers[inputs->lights[i].controller];
        if (inputs_match(of, device->vendor, device->product, device->name)) {
            found->controllers |= 1u << inputs->lights[i].controller;
            lamps->said[inputs->lamp_count + i] = 0; /* it has just been switched on */
        }
    }
}

static void feel_controller(struct lamps *lamps, const struct event *event)
{
    const struct inputs *inputs = lamps->inputs;
    struct lamps_device *device = find(lamps, event->device);
    if (!device || !device->controllers) {
        return;
    }
    for (int i = 0; i < inputs->light_count; i++) {
        const struct inputs_light *light = &inputs->lights[i];
        bool button = light->button && light->button == event->control && !event->relative;
        if (device->controllers & 1u << light->controller && (button || event->kind == EVENT_LEFT)) {
            lamps->lit[i] = event->kind == EVENT_CONTROL && !event->null && event->value > 0.5f;
        }
    }
    device->controllers = event->kind == EVENT_LEFT ? 0 : device->controllers;
}

void lamps_feel(struct lamps *lamps, const struct event *event)
{
    bool touched = event->kind == EVENT_DOWN || event->kind == EVENT_MOVE || event->kind == EVENT_CONTROL;
    if (touched && event->time_us > lamps->last_us) {
        lamps->last_us = event->time_us;
    }
    if (event->source == SOURCE_HID && (event->kind == EVENT_CONTROL || event->kind == EVENT_LEFT)) {
        feel_controller(lamps, event);
    }
    if (event->source == SOURCE_GPIO && event->kind == EVENT_CONTROL &&
        event->control < (uint32_t)lamps->inputs->button_count) {
        lamps->pressed[event->control] = event->value > 0;
    }
}

static bool is_lit(const struct lamps *lamps, int lamp)
{
    if (lamp >= lamps->inputs->lamp_count) {
        return lamps->lit[lamp - lamps->inputs->lamp_count];
    }
    int button = lamps->inputs->lamps[lamp].button;
    return button >= 0 && lamps->pressed[button];
}

/* 0..1 at this time. */
static float level_at(const struct lamps *lamps, int lamp, uint64_t now_us)
{
    if (is_lit(lamps, lamp)) {
        return 1;
    }
    if (now_us < lamps->last_us + 1000000 * (uint64_t)LAMPS_IDLE_S) {
        return 0;
    }
    float phase = (float)(now_us / 1000 % LAMPS_BREATH_MS) / LAMPS_BREATH_MS;
    return 0.5f - 0.5f * cosf(TURN * phase);
}

bool lamps_next(struct lamps *lamps, uint64_t now_us, int *lamp, float *level)
{
    for (int i = 0; i < lamps->inputs->lamp_count + lamps->inputs->light_count; i++) {
        float wanted = level_at(lamps, i, now_us);
        bool end = (wanted <= 0 || wanted >= 1) && fabsf(wanted - lamps->said[i]) > 0;
        if (end || fabsf(wanted - lamps->said[i]) >= STEP) {
            lamps->said[i] = wanted;
            *lamp = i;
            *level = wanted;
            return true;
        }
    }
    return false;
}
