#include "compose_garden.h"

#include <math.h>

enum { SEEDS_MOST = 3, STROKE = 5 };

static const float BEGIN_S = 2;   /* the picture is looked at, then the first seed falls */
static const float GROW_S = 8;    /* a seed grows, until another follows */
static const float TEND_S = 4.5f; /* a stroke takes, pause included, at least */
static const float REST_S = 12;   /* what has grown is looked at */
static const float SIDES[] = {0.12f, 0.5f, 0.88f};

struct gardener {
    struct performance *performance;
    const struct compose_garden_def *def;
    struct dice *dice;
};

static int64_t seconds(const struct gardener *gardener, float s)
{
    return (int64_t)(s * (float)gardener->def->rate);
}

static void post(const struct gardener *gardener, struct action *action, float at_s, float press_s)
{
    action->tick = seconds(gardener, at_s);
    performance_add(gardener->performance, action, (int)seconds(gardener, press_s));
}

static void post_seed(const struct gardener *gardener, struct point at, float at_s)
{
    struct action action = action_default(ACTION_PLANT);
    action.at = at;
    action.has_at = true;
    post(gardener, &action, at_s, 0.3f);
}

/* At the foot of the picture, where a tree would stand, or in other corners of it; each in a part of its own. */
static void choose_places(struct dice *dice, struct point places[SEEDS_MOST])
{
    bool above = dice_chance(dice, 0.25f);
    int first = dice_of(dice, SEEDS_MOST);
    for (int i = 0; i < SEEDS_MOST; i++) {
        float x = SIDES[(first + i) % SEEDS_MOST] + dice_between(dice, -0.08f, 0.08f);
        float y = dice_between(dice, 0.9f, 0.97f);
        bool up = i == 0 ? above : dice_chance(dice, 0.5f);
        places[i] = (struct point){x, up ? 1 - y : y};
    }
}

/* A stroke that bends a little, somewhere in the middle of the picture, where faces are. */
static void post_tending(const struct gardener *gardener, float at_s)
{
    struct dice *dice = gardener->dice;
    struct point points[STROKE];
    struct action action = action_default(ACTION_TEND);
    float angle = dice_between(dice, 0, 6.2831853f), bend = dice_between(dice, -0.9f, 0.9f);
    float shorter = fminf(gardener->def->width, gardener->def->height), step = 0.07f * shorter;
    float x = dice_between(dice, 0.35f, 0.65f) * gardener->def->width;
    float y = dice_between(dice, 0.3f, 0.6f) * gardener->def->height;
    for (int i = 0; i < STROKE; i++) {
        points[i] = (struct point){fminf(fmaxf(x / gardener->def->width, 0.02f), 0.98f),
                                   fminf(fmaxf(y / gardener->def->height, 0.02f), 0.98f)};
        x += step * cosf(angle);
        y += step * sinf(angle);
        angle += bend / STROKE;
    }
    action.path = (struct action_path){points, STROKE};
    action.radius = 0.06f * shorter;
    action.amount = dice_chance(dice, 0.7f) ? dice_between(dice, 0.4f, 0.8f) : -dice_between(dice, 0.4f, 0.8f);
    post(gardener, &action, at_s, dice_between(dice, 1.1f, 1.7f));
}

void compose_garden(struct performance *performance, const struct compose_garden_def *def, struct dice *dice)
{
    struct gardener gardener = {performance, def, dice};
    struct point places[SEEDS_MOST];
    float whole = (float)def->ticks / (float)def->rate, end = whole - fminf(REST_S, 0.4f * whole);
    int seeds = 1 + dice_of(dice, SEEDS_MOST), strokes = 0;
    performance_clear(performance, def->ticks);
    choose_places(dice, places);
    float at = BEGIN_S + dice_between(dice, 0, 1);
    for (int i = 0; i < seeds && (i == 0 || at < end); i++) {
        post_seed(&gardener, places[i], at);
        at += GROW_S * dice_between(dice, 0.7f, 1.3f);
    }
    while (at + TEND_S < end && strokes < COMPOSE_GARDEN_STEPS - SEEDS_MOST) {
        at += TEND_S * dice_between(dice, 1, 3);
        if (at < end) {
            post_tending(&gardener, at);
            strokes++;
        }
    }
    performance_space(performance, (int)seconds(&gardener, 0.7f));
    performance_sort(performance);
}
