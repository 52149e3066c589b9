#include "compose_dish.h"

#include <math.h>

#include "gray_scott_classes.h"

/* Points of a stroke; of a way from one pattern to another; ways; doses at most, about. */
enum { STROKE = 6, STEPS = 10, LEGS = 3, DOSES = 60 };

static const float BEGIN_S = 1;
static const float DOSE_S = 7; /* from one dose to the next, about */
static const float REST_S = 6;
static const float LIVES_S = 9; /* a pattern stays, before it drifts on */

/* Patterns between which, in this order and back, the straight way leads through patterns all along: the crescent of
 * Pearson's figure 3, from its lower end to its upper. */
static const char *const WAY[] = {"crowd", "mitosis", "worms_and_spots", "fingerprint", "maze", "worms", NULL};

struct chemist {
    struct performance *performance;
    const struct compose_dish_def *def;
    struct dice *dice;
};

static int64_t ticks_of(const struct chemist *chemist, float s)
{
    return (int64_t)(s * (float)chemist->def->rate);
}

static void post(const struct chemist *chemist, struct action *action, float at_s, float press_s)
{
    action->tick = ticks_of(chemist, at_s);
    performance_add(chemist->performance, action, press_s < 0 ? -1 : (int)ticks_of(chemist, press_s));
}

/* A dot, or a stroke that bends. */
static void post_dose(const struct chemist *chemist, float at_s)
{
    struct dice *dice = chemist->dice;
    struct action action = action_default(ACTION_DOSE);
    struct point points[STROKE];
    float width = chemist->def->width, height = chemist->def->height, shorter = fminf(width, height);
    float x = dice_between(dice, 0.15f, 0.85f), y = dice_between(dice, 0.15f, 0.85f);
    action.radius = fmaxf(0.012f * shorter, 4);
    if (dice_chance(dice, 0.5f)) {
        action.at = (struct point){x, y};
        action.has_at = true;
        post(chemist, &action, at_s, 0.3f);
        return;
    }
    float angle = dice_between(dice, 0, 6.2831853f), bend = dice_between(dice, -1.4f, 1.4f), step = 0.08f * shorter;
    for (int i = 0; i < STROKE; i++) {
        points[i] = (struct point){fminf(fmaxf(x, 0.03f), 0.97f), fminf(fmaxf(y, 0.03f), 0.97f)};
        x += step * cosf(angle) / width;
        y += step * sinf(angle) / height;
        angle += bend / STROKE;
    }
    action.path = (struct action_path){points, STROKE};
    post(chemist, &action, at_s, dice_between(dice, 0.9f, 1.5f));
}

static void post_rate(const struct chemist *chemist, const char *name, float value, float at_s)
{
    const struct key *key = key_find(dish_keys, name);
    struct action action = action_default(ACTION_REACT);
    if (key) {
        action.option = (int)(key - dish_keys);
        action.value = value;
        post(chemist, &action, at_s, -1);
    }
}

/* The place on the way that is nearest to how the scene begins. */
static int begin_of(const struct chemist *chemist)
{
    const struct gray_scott_def *reaction = &chemist->def->options->chemistry.reaction;
    int nearest = 0;
    float least = INFINITY;
    for (int i = 0; WAY[i]; i++) {
        const struct gray_scott_preset *preset = gray_scott_preset_find(WAY[i]);
        float apart = hypotf((preset->feed - reaction->feed) / 0.11f, (preset->kill - reaction->kill) / 0.04f);
        nearest = apart < least ? i : nearest;
        least = fminf(apart, least);
    }
    return nearest;
}

/* From one place of the way to the next, slowly, then it stays. */
static void compose_drift(const struct chemist *chemist, float from_s, float to_s)
{
    int at = begin_of(chemist), count = 0;
    while (WAY[count]) {
        count++;
    }
    int way = at == 0 ? 1 : at == count - 1 ? -1 : dice_chance(chemist->dice, 0.5f) ? 1 : -1;
    const struct gray_scott_def *reaction = &chemist->def->options->chemistry.reaction;
    float feed = reaction->feed, kill = reaction->kill, leg = (to_s - from_s) / LEGS;
    for (int i = 0; i < LEGS && leg > 2; i++) {
        const struct gray_scott_preset *next = gray_scott_preset_find(WAY[at]);
        float begin = from_s + leg * (float)i + fminf(LIVES_S, 0.5f * leg),
              lasts = from_s + leg * (float)(i + 1) - begin;
        for (int k = 1; k <= STEPS; k++) {
            float share = (float)k / STEPS, when = begin + lasts * share;
            post_rate(chemist, "feed", feed + share * (next->feed - feed), when);
            post_rate(chemist, "kill", kill + share * (next->kill - kill), when);
        }
        feed = next->feed;
        kill = next->kill;
        way = at + way < 0 || at + way >= count ? -way : way;
        at += way;
    }
}

void compose_dish(struct performance *performance, const struct compose_dish_def *def, struct dice *dice)
{
    struct chemist chemist = {performance, def, dice};
    float whole = (float)def->ticks / (float)def->rate, end = whole - fminf(REST_S, 0.25f * whole);
    performance_clear(performance, def->ticks);
    post_dose(&chemist, BEGIN_S);
    post_dose(&chemist, BEGIN_S + 2);
    float every = fmaxf(DOSE_S, end / DOSES);
    float at = BEGIN_S + 5;
    while (at < end) {
        post_dose(&chemist, at);
        at += every * dice_between(dice, 0.6f, 1.6f);
    }
    compose_drift(&chemist, BEGIN_S + 4, end);
    performance_space(performance, (int)ticks_of(&chemist, 0.5f));
    performance_sort(performance);
}
