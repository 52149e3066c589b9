#include "press.h"

static uint64_t microseconds(uint32_t ms)
{
    return 1000 * (uint64_t)ms;
}

static uint64_t since(uint64_t then_us, uint64_t now_us)
{
    return now_us > then_us ? now_us - then_us : 0; /* times of two devices may cross */
}

static bool goes_down(struct press *press, const struct press_def *def, uint64_t time_us)
{
    bool again = press->clicked &&
                 since(press->up_us, time_us) <= microseconds(def->when == PRESS_DOUBLE ? def->ms : def->wait_ms);
    press->down = true;
    press->down_us = time_us;
    press->length_us = 0;
    press->clicked = false;
    press->done = again;
    return def->when == PRESS_DOWN || (def->when == PRESS_DOUBLE && again);
}

static bool comes_up(struct press *press, const struct press_def *def, uint64_t time_us)
{
    press->down = false;
    press->up_us = time_us;
    press->length_us = since(press->down_us, time_us);
    bool brief = press->length_us < microseconds(def->ms);
    switch (def->when) {
    case PRESS_UP:
        return true;
    case PRESS_SHORT:
        press->clicked = brief && !press->done && def->wait_ms > 0;
        return brief && !press->done && def->wait_ms == 0;
    case PRESS_LONG:
        return !brief;
    case PRESS_DOUBLE:
        press->clicked = brief && !press->done;
        return false;
    case PRESS_HOLD: /* its last moment may come with the release */
        return !brief && !press->done;
    default:
        return false;
    }
}

bool press_feel(struct press *press, const struct press_def *def, bool down, uint64_t time_us)
{
    if (down == press->down) {
        return false;
    }
    return down ? goes_down(press, def, time_us) : comes_up(press, def, time_us);
}

uint64_t press_due_us(const struct press *press, const struct press_def *def)
{
    if (press->down && def->when == PRESS_HOLD && !press->done) {
        return press->down_us + microseconds(def->ms);
    }
    if (press->clicked) {
        return press->up_us + microseconds(def->when == PRESS_DOUBLE ? def->ms : def->wait_ms);
    }
    return PRESS_NEVER;
}

bool press_run(struct press *press, const struct press_def *def, uint64_t now_us)
{
    if (now_us < press_due_us(press, def)) {
        return false;
    }
    if (press->down) {
        press->done = true;
        press->length_us = since(press->down_us, now_us);
        return true;
    }
    press->clicked = false;
    return def->when == PRESS_SHORT;
}

bool press_is_idle(const struct press *press)
{
    return !press->down && !press->clicked;
}
