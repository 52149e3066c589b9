#include "compose_storm.h"

#include <math.h>

enum { HAND = 1, FLASHES = 30, SLOW = 16 }; /* a number that nobody else has then; how many there are at most, about */

static const float BEGIN_S = 1.2f;
static const float FLASH_S = 4; /* from one strike of lightning to the next, about */
static const float GROW_S = 14; /* from one slow thing to the next */
static const float REST_S = 8;  /* what has grown is looked at */
static const float STAYS_S = 5; /* a hand that attracts */

struct stormer {
    struct performance *performance;
    const struct compose_storm_def *def;
    struct dice *dice;
};

static int64_t ticks_of(const struct stormer *stormer, float s)
{
    return (int64_t)(s * (float)stormer->def->rate);
}

static void post(const struct stormer *stormer, struct action *action, float at_s, float press_s)
{
    action->tick = ticks_of(stormer, at_s);
    performance_add(stormer->performance, action, press_s < 0 ? -1 : (int)ticks_of(stormer, press_s));
}

static void post_strike(const struct stormer *stormer, struct point at, float at_s)
{
    struct action action = action_default(ACTION_STRIKE);
    action.at = at;
    action.has_at = true;
    post(stormer, &action, at_s, 0.25f);
}

/* Another kind is set; no hand does it. */
static void post_kind(const struct stormer *stormer, enum bolt_kind kind, float at_s)
{
    struct action action = action_default(ACTION_CONDUCT);
    action.option = (int)(key_find(storm_keys, "kind") - storm_keys);
    action.value = (float)kind;
    post(stormer, &action, at_s, -1);
}

/* A hand comes down and stays: what grows turns to it. */
static void post_hand(const struct stormer *stormer, struct point at, float at_s)
{
    struct action action = action_default(ACTION_ATTRACT);
    action.visitor = HAND;
    action.at = at;
    action.has_at = true;
    post(stormer, &action, at_s, 0.3f);
}

/* Each hand that has come is lifted after a while: when it is known when they come. */
static void lift_hands(const struct stormer *stormer)
{
    struct performance *performance = stormer->performance;
    int count = performance->count;
    for (int i = 0; i < count; i++) {
        const struct action *hand = &performance->steps[i].action;
        if (hand->verb == ACTION_ATTRACT) {
            struct action action = action_default(ACTION_ATTRACT);
            action.visitor = HAND;
            action.tick = hand->tick + ticks_of(stormer, STAYS_S);
            action.tick = action.tick < performance->ticks ? action.tick : performance->ticks - 1;
            performance_add(performance, &action, -1);
        }
    }
}

/* Strikes from clouds that drift: each comes down some way from the last. Now and then two at once. */
static void compose_flashes(const struct stormer *stormer, float from_s, float to_s)
{
    struct dice *dice = stormer->dice;
    float x = dice_between(dice, 0.15f, 0.85f), every = fmaxf(FLASH_S, (to_s - from_s) / FLASHES), at = from_s;
    while (at < to_s) {
        x += dice_between(dice, 0.2f, 0.5f);
        x = x > 0.9f ? x - 0.8f : x;
        post_strike(stormer, (struct point){x, dice_between(dice, 0.55f, 0.95f)}, at);
        if (dice_chance(dice, 0.25f)) {
            float other = x > 0.5f ? x - dice_between(dice, 0.2f, 0.4f) : x + dice_between(dice, 0.2f, 0.4f);
            post_strike(stormer, (struct point){other, dice_between(dice, 0.5f, 0.9f)}, at + 0.9f);
        }
        at += every * dice_between(dice, 0.5f, 1.8f);
    }
}

/* How far down the sheet a kind begins: on the ground, at the spring of a river, or in the middle of what it spreads
 * over. */
static float begin_of(enum bolt_kind kind, struct dice *dice)
{
    bool stands = kind == BOLT_TREE || kind == BOLT_CORAL;
    float y = stands ? 0.79f : kind == BOLT_RIVER ? 0.12f : kind == BOLT_FROST ? 0.9f : 0.5f;
    return y + dice_between(dice, -0.07f, 0.07f);
}

/* What grows slowly, from places apart; a hand draws it to itself. */
static void compose_slow(const struct stormer *stormer, enum bolt_kind kind, float from_s, float to_s)
{
    struct dice *dice = stormer->dice;
    float side = dice_chance(dice, 0.5f) ? 0.3f : 0.7f, every = fmaxf(GROW_S, (to_s - from_s) / SLOW), at = from_s;
    while (at < to_s) {
        float x = side + dice_between(dice, -0.12f, 0.12f);
        post_strike(stormer, (struct point){x, begin_of(kind, dice)}, at);
        if (at + 3 + STAYS_S < to_s && dice_chance(dice, 0.7f)) {
            bool down = kind == BOLT_RIVER;
            struct point hand = {x + dice_between(dice, -0.25f, 0.25f), dice_between(dice, 0.2f, 0.5f)};
            hand.y = down ? 1 - hand.y : hand.y;
            hand.x = fminf(fmaxf(hand.x, 0.08f), 0.92f);
            post_hand(stormer, hand, at + 3);
        }
        at += every * dice_between(dice, 0.8f, 1.3f);
        side = 1 - side;
    }
}

void compose_storm(struct performance *performance, const struct compose_storm_def *def, struct dice *dice)
{
    struct stormer stormer = {performance, def, dice};
    float whole = (float)def->ticks / (float)def->rate, end = whole - fminf(REST_S, 0.25f * whole);
    bool flashes = def->options->lightning.kind == BOLT_LIGHTNING;
    performance_clear(performance, def->ticks);
    float from = BEGIN_S + dice_between(dice, 0, 0.6f), turn = flashes ? 0.66f * end : end;
    if (flashes && whole > 40) { /* a storm, and after it a slow coral */
        compose_flashes(&stormer, from, turn);
        post_kind(&stormer, BOLT_CORAL, turn + 1);
        compose_slow(&stormer, BOLT_CORAL, turn + 2, end);
    } else if (flashes) {
        compose_flashes(&stormer, from, end);
    } else {
        compose_slow(&stormer, (enum bolt_kind)def->options->lightning.kind, from, end);
    }
    performance_space(performance, (int)ticks_of(&stormer, 0.4f));
    lift_hands(&stormer);
    performance_sort(performance);
}
