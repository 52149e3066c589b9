#include "debounce.h"

void debounce_init(struct debounce *debounce, uint32_t settle_us, bool level)
{
    *debounce = (struct debounce){.settle_us = settle_us, .stable = level, .level = level};
}

/* The train has ended. */
static bool settle(struct debounce *debounce, struct transition *transition)
{
    debounce->moving = false;
    if (debounce->level == debounce->stable) {
        return false;
    }
    debounce->stable = debounce->level;
    *transition = (struct transition){debounce->first_us, debounce->level};
    return true;
}

bool debounce_time(struct debounce *debounce, uint64_t now_us, struct transition *transition)
{
    if (!debounce->moving || now_us < debounce_due_us(debounce)) {
        return false;
    }
    return settle(debounce, transition);
}

bool debounce_edge(struct debounce *debounce, uint64_t time_us, bool level, struct transition *transition)
{
    if (time_us < debounce->last_us) {
        time_us = debounce->last_us;
    }
    bool reported = debounce_time(debounce, time_us, transition);
    if (!debounce->moving) {
        debounce->moving = true;
        debounce->first_us = time_us;
    }
    debounce->last_us = time_us;
    debounce->level = level;
    /* Without settling no train outlives its edge, so that at most one transition is left here. */
    return debounce->settle_us == 0 ? settle(debounce, transition) : reported;
}

uint64_t debounce_due_us(const struct debounce *debounce)
{
    return debounce->moving ? debounce->last_us + debounce->settle_us : 0;
}

uint64_t debounce_restless_us(const struct debounce *debounce, uint64_t now_us)
{
    return debounce->moving && now_us > debounce->first_us ? now_us - debounce->first_us : 0;
}
