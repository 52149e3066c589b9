#include "visit.h"

#include <math.h>

static const uint64_t SECOND = 1000000, MS = 1000;
static const float LONGEST_S = 1e8f;

/* What is to be seen in a state; what differs from one to the next becomes an order. */
static const struct face {
    const char *name;
    bool attract, palette, power;
    bool paints; /* a visitor may */
} faces[VISIT_STATES] = {
    [VISIT_ATTRACT] = {"attract", true, false, true, false},
    [VISIT_PAINTING] = {"painting", false, true, true, true},
    [VISIT_COUNTDOWN] = {"countdown", false, true, true, true},
    [VISIT_THANKS] = {"thanks", false, false, true, false},
    [VISIT_WASHING] = {"washing", false, false, true, false},
    [VISIT_CLOSING] = {"closing", false, true, true, true},
    [VISIT_CLOSED] = {"closed", false, false, false, false},
};

enum {
    KEEP = 1 << ORDER_KEEP, /* where something is painted */
    SCENE = 1 << ORDER_SCENE,
    SHEET = 1 << ORDER_SHEET,
    WASH = 1 << ORDER_WASH, /* where something is painted */
    WELCOME = 1 << ORDER_WELCOME,
    BEGIN = 1 << ORDER_ATTRACT, /* attract, anew */
};

/* What follows: the next state and the orders on the way, beside those of the faces. Empty: nothing changes. */
static const struct rule {
    bool is;
    enum visit_state next;
    int orders;
} rules[VISIT_STATES][VISIT_EVENTS] = {
    [VISIT_ATTRACT] =
        {
            [VISIT_INPUT] = {true, VISIT_PAINTING, SHEET | WELCOME},
            [VISIT_PAINT] = {true, VISIT_PAINTING, SHEET | WELCOME},
            [VISIT_CLOSE] = {true, VISIT_CLOSED, 0},
            [VISIT_SCENE] = {true, VISIT_ATTRACT, SCENE | SHEET | BEGIN},
        },
    [VISIT_PAINTING] =
        {
            [VISIT_TIME] = {true, VISIT_COUNTDOWN, 0},
            [VISIT_FINISH] = {true, VISIT_THANKS, KEEP},
            [VISIT_CLOSE] = {true, VISIT_CLOSING, 0},
            [VISIT_SCENE] = {true, VISIT_PAINTING, KEEP | SCENE | SHEET},
        },
    [VISIT_COUNTDOWN] =
        {
            [VISIT_INPUT] = {true, VISIT_PAINTING, 0},
            [VISIT_PAINT] = {true, VISIT_PAINTING, 0},
            [VISIT_TIME] = {true, VISIT_WASHING, KEEP | WASH},
            [VISIT_FINISH] = {true, VISIT_THANKS, KEEP},
            [VISIT_CLOSE] = {true, VISIT_CLOSING, 0},
            [VISIT_SCENE] = {true, VISIT_PAINTING, KEEP | SCENE | SHEET},
        },
    [VISIT_THANKS] =
        {
            [VISIT_INPUT] = {true, VISIT_PAINTING, SHEET | WELCOME}, /* after VISIT_GRACE_MS */
            [VISIT_TIME] = {true, VISIT_WASHING, WASH},
            [VISIT_SCENE] = {true, VISIT_ATTRACT, SCENE | SHEET},
        },
    [VISIT_WASHING] =
        {
            [VISIT_INPUT] = {true, VISIT_PAINTING, SHEET | WELCOME},
            [VISIT_TIME] = {true, VISIT_ATTRACT, SHEET},
            [VISIT_WASHED] = {true, VISIT_ATTRACT, SHEET},
            [VISIT_SCENE] = {true, VISIT_ATTRACT, SCENE | SHEET},
        },
    [VISIT_CLOSING] =
        {
            [VISIT_TIME] = {true, VISIT_CLOSED, KEEP},
            [VISIT_OPEN] = {true, VISIT_PAINTING, 0},
        },
    [VISIT_CLOSED] =
        {
            [VISIT_INPUT] = {true, VISIT_ATTRACT, SHEET}, /* where the exhibit has wake */
            [VISIT_OPEN] = {true, VISIT_ATTRACT, SHEET},
            [VISIT_SCENE] = {true, VISIT_CLOSED, SCENE},
        },
};

static uint64_t microseconds(float seconds)
{
    return seconds > 0.0f ? (uint64_t)((double)fminf(seconds, LONGEST_S) * (double)SECOND) : 0;
}

static void order(struct visit *visit, enum visit_order_kind kind, bool on)
{
    int kept = 0;
    for (int i = 0; i < visit->count; i++) {
        if (visit->orders[i].kind != kind) {
            visit->orders[kept++] = visit->orders[i];
        }
    }
    visit->orders[kept] = (struct visit_order){kind, on};
    visit->count = kept + 1;
}

static void give(struct visit *visit, const struct rule *rule)
{
    const struct face *from = &faces[visit->state], *to = &faces[rule->next];
    if (rule->orders & KEEP && visit->painted) {
        order(visit, ORDER_KEEP, true);
    }
    if (rule->orders & SCENE) {
        order(visit, ORDER_SCENE, true);
    }
    if (rule->orders & SHEET) {
        order(visit, ORDER_SHEET, true);
        visit->painted = false;
    }
    if (rule->orders & WASH && visit->painted) {
        order(visit, ORDER_WASH, true);
    }
    if (rule->orders & WELCOME) {
        order(visit, ORDER_WELCOME, true);
        visit->visits++;
    }
    if (from->palette != to->palette) {
        order(visit, ORDER_PALETTE, to->palette);
    }
    if (from->attract != to->attract || rule->orders & BEGIN) {
        order(visit, ORDER_ATTRACT, to->attract);
    }
    if (from->power != to->power) {
        order(visit, ORDER_POWER, to->power);
    }
}

static void follow(struct visit *visit, enum visit_event event)
{
    const struct rule *rule = &rules[visit->state][event];
    if (!rule->is) {
        return;
    }
    give(visit, rule);
    if (rule->next != visit->state) {
        visit->state = rule->next;
        visit->since_us = visit->now_us;
        visit->alive_us = visit->now_us;
    }
}

/* A clock that goes back: what has been stays as long ago as it was. */
static void tell(struct visit *visit, uint64_t now_us)
{
    if (now_us < visit->now_us) {
        uint64_t back = visit->now_us - now_us;
        uint64_t *const stamps[] = {&visit->since_us, &visit->input_us,  &visit->alive_us,
                                    &visit->awake_us, &visit->status_us, &visit->status_touched_us};
        for (size_t i = 0; i < sizeof stamps / sizeof stamps[0]; i++) {
            *stamps[i] -= *stamps[i] < back ? *stamps[i] : back;
        }
    }
    visit->now_us = now_us;
}

static void toggle_status(struct visit *visit)
{
    visit->status = !visit->status;
    if (visit->status) {
        visit->status_us = visit->status_touched_us = visit->now_us;
    } else {
        uint64_t stood = visit->now_us - visit->status_us;
        visit->since_us += stood;
        visit->input_us += stood;
        visit->alive_us += stood;
        visit->awake_us += visit->awake_us ? stood : 0;
    }
    bool dark = !faces[visit->state].power;
    if (dark && visit->status) {
        order(visit, ORDER_POWER, true);
    }
    order(visit, ORDER_STATUS, visit->status);
    if (dark && !visit->status) {
        order(visit, ORDER_POWER, false);
    }
}

/* Hands that did something, or only rest. False: it is nothing to this state. */
static bool hands(struct visit *visit, enum visit_event event)
{
    if (event == VISIT_HOLD) {
        if (visit->now_us - visit->input_us <= VISIT_HOLD_S * SECOND) {
            visit->alive_us = visit->now_us;
        }
        return true;
    }
    if (visit->state == VISIT_THANKS && visit->now_us - visit->since_us < VISIT_GRACE_MS * MS) {
        return false;
    }
    if (visit->state == VISIT_CLOSED && !(visit->wake_s > 0.0f)) {
        return false;
    }
    visit->input_us = visit->alive_us = visit->now_us;
    visit->awake_us = visit->closed ? visit->now_us + microseconds(visit->wake_s) : 0;
    return true;
}

/* What is felt while the staff looks. */
static void feel_status(struct visit *visit, enum visit_event event)
{
    if (event == VISIT_INPUT || event == VISIT_PAINT) { /* a hand that rests there does not keep it */
        visit->status_touched_us = visit->now_us;
    } else if (event == VISIT_WASHED) {
        follow(visit, event);
    }
}

void visit_feel(struct visit *visit, enum visit_event event, uint64_t now_us)
{
    if ((int)event < 0 || event >= VISIT_EVENTS) {
        return;
    }
    tell(visit, now_us);
    if (event == VISIT_OPEN || event == VISIT_CLOSE) {
        visit->closed = event == VISIT_CLOSE;
    }
    if (event == VISIT_STAFF) {
        toggle_status(visit);
    } else if (visit->status) {
        feel_status(visit, event);
    } else if (event == VISIT_INPUT || event == VISIT_PAINT || event == VISIT_HOLD) {
        if (hands(visit, event)) {
            follow(visit, event);
            visit->painted |= event == VISIT_PAINT && faces[visit->state].paints;
        }
    } else if (event != VISIT_CLOSE || !(visit->wake_s > 0.0f) || now_us >= visit->awake_us) {
        follow(visit, event);
    }
}

/* What a state lasts; UINT64_MAX: time ends nothing. */
static uint64_t lasts_us(const struct visit *visit)
{
    switch (visit->state) {
    case VISIT_PAINTING:
        return microseconds(visit->times.idle);
    case VISIT_COUNTDOWN:
    case VISIT_CLOSING:
        return microseconds(visit->times.countdown);
    case VISIT_THANKS:
        return visit->painted ? microseconds(visit->times.thanks) : 0;
    case VISIT_WASHING:
        return visit->painted ? 2 * microseconds(visit->times.wash) + VISIT_WASH_S * SECOND : 0;
    default:
        return UINT64_MAX;
    }
}

static uint64_t left_us(const struct visit *visit, uint64_t now_us)
{
    uint64_t lasts = lasts_us(visit);
    uint64_t from = visit->state == VISIT_PAINTING ? visit->alive_us : visit->since_us;
    uint64_t now = visit->status ? visit->status_us : now_us;
    uint64_t gone = now > from ? now - from : 0;
    return lasts == UINT64_MAX ? lasts : gone < lasts ? lasts - gone : 0;
}

static uint64_t status_left_us(const struct visit *visit, uint64_t now_us)
{
    uint64_t end = visit->status_touched_us + VISIT_STATUS_S * SECOND;
    return end > now_us ? end - now_us : 0;
}

void visit_run(struct visit *visit, uint64_t now_us)
{
    tell(visit, now_us);
    if (visit->status && status_left_us(visit, now_us) == 0) {
        toggle_status(visit);
    }
    if (visit->status) {
        return;
    }
    for (int i = 0; i < VISIT_STATES && left_us(visit, now_us) == 0; i++) {
        visit_feel(visit, VISIT_TIME, now_us);
    }
    visit_feel(visit, visit->closed ? VISIT_CLOSE : VISIT_OPEN, now_us);
}

static void take_times(struct visit *visit, const struct exhibit *exhibit)
{
    visit->times = exhibit->visit;
    visit->wake_s = (float)exhibit->wake * 60.0f;
}

void visit_init(struct visit *visit, const struct exhibit *exhibit, uint64_t now_us)
{
    *visit = (struct visit){.state = VISIT_ATTRACT, .now_us = now_us, .since_us = now_us};
    take_times(visit, exhibit);
    order(visit, ORDER_SHEET, true);
    order(visit, ORDER_ATTRACT, true);
}

void visit_resume(struct visit *visit, const struct exhibit *exhibit, uint64_t now_us)
{
    *visit = (struct visit){.state = VISIT_PAINTING,
                            .now_us = now_us,
                            .since_us = now_us,
                            .input_us = now_us,
                            .alive_us = now_us,
                            .painted = true,
                            .visits = 1};
    take_times(visit, exhibit);
    order(visit, ORDER_PALETTE, true);
}

void visit_reload(struct visit *visit, const struct exhibit *exhibit, uint64_t now_us)
{
    take_times(visit, exhibit);
    visit_feel(visit, VISIT_RELOAD, now_us);
}

bool visit_order(struct visit *visit, struct visit_order *next)
{
    if (visit->count == 0) {
        return false;
    }
    *next = visit->orders[0];
    visit->count--;
    for (int i = 0; i < visit->count; i++) {
        visit->orders[i] = visit->orders[i + 1];
    }
    return true;
}

bool visit_paints(const struct visit *visit)
{
    return faces[visit->state].paints && !visit->status;
}

int visit_countdown(const struct visit *visit, uint64_t now_us)
{
    if (visit->state != VISIT_COUNTDOWN && visit->state != VISIT_CLOSING) {
        return 0;
    }
    uint64_t seconds = (left_us(visit, now_us) + SECOND - 1) / SECOND;
    return seconds < INT32_MAX ? (int)seconds : INT32_MAX;
}

float visit_left(const struct visit *visit, uint64_t now_us)
{
    uint64_t lasts = lasts_us(visit);
    if (lasts == UINT64_MAX) {
        return 1;
    }
    return lasts ? (float)((double)left_us(visit, now_us) / (double)lasts) : 0;
}

int visit_timeout_ms(const struct visit *visit, uint64_t now_us)
{
    uint64_t left = visit->status ? status_left_us(visit, now_us) : left_us(visit, now_us);
    bool open = visit->state == VISIT_ATTRACT || visit->state == VISIT_PAINTING || visit->state == VISIT_COUNTDOWN;
    if (!visit->status && visit->closed && open) { /* a touch has opened it for a while */
        uint64_t awake = visit->wake_s > 0.0f && visit->awake_us > now_us ? visit->awake_us - now_us : 0;
        left = awake < left ? awake : left;
    } else if (!visit->status && !visit->closed && (visit->state == VISIT_CLOSED || visit->state == VISIT_CLOSING)) {
        left = 0;
    }
    if (left == UINT64_MAX) {
        return -1;
    }
    uint64_t ms = (left + MS - 1) / MS;
    return ms < INT32_MAX ? (int)ms : INT32_MAX;
}

const char *visit_state_name(enum visit_state state)
{
    return faces[state].name;
}
