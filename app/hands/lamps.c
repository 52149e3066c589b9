#include "lamps.h"

#include <math.h>

static const float STEP = 0.02f; /* what an eye sees at most */
static const float TURN = 6.2831853f;

void lamps_feel(struct lamps *lamps, const struct event *event)
{
    bool touched = event->kind == EVENT_DOWN || event->kind == EVENT_MOVE || event->kind == EVENT_CONTROL;
    if (touched && event->time_us > lamps->last_us) {
        lamps->last_us = event->time_us;
    }
    if (event->source == SOURCE_GPIO && event->kind == EVENT_CONTROL &&
        event->control < (uint32_t)lamps->inputs->button_count) {
        lamps->pressed[event->control] = event->value > 0;
    }
}

float lamps_level(const struct lamps *lamps, int lamp, uint64_t now_us)
{
    int button = lamps->inputs->lamps[lamp].button;
    if (button >= 0 && lamps->pressed[button]) {
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
    for (int i = 0; i < lamps->inputs->lamp_count; i++) {
        float wanted = lamps_level(lamps, i, now_us);
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
