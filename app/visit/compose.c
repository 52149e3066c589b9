#include "compose.h"

#include <math.h>
#include <stdlib.h>

#include "brush.h"
#include "harmony.h"

static const float PI = 3.14159265f;
static const float DROP_RADIUS = 9; /* cells; what a ragged drop of it has grown to at once is FIRST_RADIUS */
static const float FIRST_RADIUS = 11;

enum { SEGMENTS = 4 };

struct composer {
    struct performance *performance;
    const struct compose_def *def;
    struct dice *dice;
    struct arrangement arrangement;
    struct harmony harmony;
    int64_t starts[ARRANGED_BLOOMS], grown[ARRANGED_BLOOMS]; /* ticks at which blooms begin, and have their size */
    int64_t end;                                             /* by then everything has */
};

/* Cells a tick that the front of a bloom comes on, where solvent is plenty: measured over the first 1200 ticks. */
static float speed_of(int brush)
{
    static const struct {
        const char *name;
        float speed;
    } speeds[] = {{"moss", 0.13f},   {"fern", 0.096f},  {"coral", 0.112f},
                  {"frost", 0.088f}, {"mocha", 0.068f}, {"lichen", 0.097f}};
    for (size_t i = 0; i < sizeof speeds / sizeof speeds[0]; i++) {
        if (brush_find(speeds[i].name) == brush) {
            return speeds[i].speed;
        }
    }
    return 0.1f;
}

static int64_t seconds(const struct composer *composer, float s)
{
    return (int64_t)(s * (float)composer->def->rate);
}

static struct point place(const struct composer *composer, float x, float y)
{
    float w = composer->def->width, h = composer->def->height;
    return (struct point){fminf(fmaxf(x / w, 0.0f), 1.0f), fminf(fmaxf(y / h, 0.0f), 1.0f)};
}

static void post(struct composer *composer, struct action *action, int64_t tick, int press)
{
    action->tick = tick < 0 ? 0 : tick;
    performance_add(composer->performance, action, press);
}

static float share_of_size(const struct bloom *bloom)
{
    return bloom->r / DROP_RADIUS * (bloom->r / DROP_RADIUS);
}

static void post_drop(struct composer *composer, const struct bloom *bloom, int ink, int64_t tick)
{
    struct action drop = action_default(ACTION_DROP);
    drop.at = place(composer, bloom->x, bloom->y);
    drop.has_at = true;
    drop.ink = ink;
    drop.radius = DROP_RADIUS * dice_between(composer->dice, 0.9f, 1.1f);
    drop.solvent = 12 + 0.6f * share_of_size(bloom);
    drop.amount = 15 + 0.62f * share_of_size(bloom);
    drop.edge = EDGE_RAGGED;
    drop.brush = bloom->brush;
    drop.reach = 1.5f * bloom->r + 30;
    post(composer, &drop, tick, (int)seconds(composer, 0.12f));
}

/* Its growth ends, and ink settles into the tips. */
static void post_end(struct composer *composer, const struct bloom *bloom, int64_t tick)
{
    struct action set = action_default(ACTION_SET);
    while (&coefficient_keys[set.coefficient] != key_find(coefficient_keys, "s_max")) {
        set.coefficient++;
    }
    set.at = place(composer, bloom->x, bloom->y);
    set.has_at = true;
    set.value = 0;
    set.radius = 2.0f * bloom->r;
    post(composer, &set, tick, -1);
}

static void post_ink(struct composer *composer, const struct bloom *bloom, int ink, float share, int64_t tick)
{
    struct point at = place(composer, bloom->x, bloom->y);
    struct action stroke = action_default(ACTION_BRUSH_INK);
    stroke.path = (struct action_path){&at, 1};
    stroke.ink = ink;
    stroke.radius = fminf(fmaxf(0.1f * bloom->r, 6), 13);
    float discs = bloom->r / stroke.radius * (bloom->r / stroke.radius);
    stroke.amount = 0.62f * share * discs;
    post(composer, &stroke, tick, (int)seconds(composer, 0.25f));
}

/* A stroke in pieces, as a hand makes it. */
static void post_stroke(struct composer *composer, struct action *stroke, const struct point *points, int count,
                        int64_t tick, int64_t takes)
{
    for (int i = 0; i + 1 < count; i++) {
        stroke->path = (struct action_path){&points[i], 2};
        int64_t piece = takes / (count - 1);
        post(composer, stroke, tick + piece * i, (int)piece);
    }
}

/* Solvent before the front: arms reach along it. */
static void post_pull(struct composer *composer, const struct bloom *bloom, int64_t tick)
{
    struct point points[SEGMENTS + 1];
    float angle = 0, bend = dice_between(composer->dice, -0.8f, 0.8f), most = 0;
    for (int i = 0; i < 8; i++) { /* where there is room */
        float other = dice_between(composer->dice, 0, 2 * PI), away = 1.3f * bloom->r;
        float x = bloom->x + away * cosf(other + bend), y = bloom->y + away * sinf(other + bend);
        float room = arrangement_room(&composer->arrangement, x, y, bloom);
        angle = room > most ? other : angle;
        most = fmaxf(room, most);
    }
    if (most < 0.12f * bloom->r) {
        return;
    }
    for (int i = 0; i <= SEGMENTS; i++) {
        float share = (float)i / SEGMENTS, away = bloom->r * (0.35f + 0.95f * share);
        points[i] = place(composer, bloom->x + away * cosf(angle + bend * share * share),
                          bloom->y + away * sinf(angle + bend * share * share));
    }
    struct action stroke = action_default(ACTION_BRUSH_SOLVENT);
    stroke.radius = fminf(fmaxf(0.09f * bloom->r, 5), 14);
    stroke.amount = 3;
    post_stroke(composer, &stroke, points, SEGMENTS + 1, tick, seconds(composer, 1.4f));
}

static void plan(struct composer *composer)
{
    struct arrangement *a = &composer->arrangement;
    int64_t begin = seconds(composer, 0.4f), least = seconds(composer, 1.6f), longest = 0;
    for (int i = 1; i < a->count; i++) {
        int64_t takes = (int64_t)((a->blooms[i].r - FIRST_RADIUS) / speed_of(a->blooms[i].brush));
        longest = takes > longest ? takes : longest;
    }
    int64_t span = composer->end - begin - longest / 2;
    int64_t step = a->count > 1 ? span / a->count : 0;
    for (int i = 0; i < a->count; i++) {
        struct bloom *bloom = &a->blooms[i];
        float speed = speed_of(bloom->brush);
        int64_t start = begin + step * i + (i > 0 ? (int64_t)dice_between(composer->dice, -0.25f, 0.25f) * step : 0);
        int64_t takes = (int64_t)(fmaxf(bloom->r - FIRST_RADIUS, 1) / speed);
        int64_t earliest = i > 0 ? composer->starts[i - 1] + least : begin;
        start = start + takes > composer->end ? composer->end - takes : start;
        start = start < earliest ? earliest : start;
        if (start + takes > composer->end) { /* as large as there is time for */
            takes = composer->end > start ? composer->end - start : 0;
            bloom->r = FIRST_RADIUS + speed * (float)takes;
        }
        composer->starts[i] = start;
        composer->grown[i] = start + takes;
    }
}

static void post_bloom(struct composer *composer, int i)
{
    const struct bloom *bloom = &composer->arrangement.blooms[i];
    int64_t start = composer->starts[i], takes = composer->grown[i] - start;
    struct harmony_pair inks = harmony_choose(&composer->harmony, bloom->weight, i, composer->dice);
    post_drop(composer, bloom, inks.first, start);
    float share = inks.share * dice_between(composer->dice, 0.7f, 1.3f);
    post_ink(composer, bloom, inks.second, share, start + (int64_t)(0.3f * (float)takes));
    if (bloom->weight > 0.6f) {
        post_pull(composer, bloom, start + (int64_t)(0.5f * (float)takes));
        post_ink(composer, bloom, inks.third, 0.5f * share, start + (int64_t)(0.72f * (float)takes));
    }
    post_end(composer, bloom, composer->grown[i]);
}

static void post_sweep(struct composer *composer, const struct sweep *sweep)
{
    const struct arrangement *a = &composer->arrangement;
    struct point points[ARRANGED_SWEEP_POINTS];
    int64_t first = composer->end;
    for (int i = 0; i < sweep->count; i++) {
        points[i] = place(composer, sweep->points[i].x, sweep->points[i].y);
        for (int j = 0; j < a->count; j++) { /* before the first bloom that it reaches has grown much */
            const struct bloom *bloom = &a->blooms[j];
            float away = hypotf(bloom->x - sweep->points[i].x, bloom->y - sweep->points[i].y);
            first = away < bloom->r && composer->starts[j] < first ? composer->starts[j] : first;
        }
    }
    struct action guide = action_default(ACTION_GUIDE);
    guide.path = (struct action_path){points, sweep->count};
    guide.radius = sweep->radius;
    guide.strength = sweep->strength;
    post(composer, &guide, first + seconds(composer, dice_between(composer->dice, 2.4f, 3.4f)),
         (int)seconds(composer, 1.4f));
}

/* Small ones, late, in twos and threes. */
static void post_splashes(struct composer *composer)
{
    const struct arrangement *a = &composer->arrangement;
    struct dice *dice = composer->dice;
    int groups = 2 + dice_of(dice, 3);
    for (int i = 0, tries = 0; i < groups && tries < 200; tries++) {
        float x = dice_between(dice, 0.04f, 0.96f) * a->width, y = dice_between(dice, 0.04f, 0.96f) * a->height;
        float room = arrangement_room(a, x, y, NULL), side = fminf(a->width, a->height);
        if (room < 0.03f * side + 8 || room > 0.14f * side) {
            continue;
        }
        float share = ((float)i + dice_between(dice, 0.2f, 0.8f)) / (float)groups;
        int64_t tick = composer->end - (int64_t)((float)composer->end * 0.3f * (1 - share));
        int ink = harmony_any(&composer->harmony, dice);
        for (int j = 0, count = 1 + dice_of(dice, 3); j < count; j++) {
            struct action drop = action_default(ACTION_DROP);
            drop.at = place(composer, x, y);
            drop.has_at = true;
            drop.ink = ink;
            drop.radius = dice_between(dice, 1.5f, 2.6f) / (1 + 0.4f * (float)j);
            drop.solvent = 14;
            drop.amount = 40;
            post(composer, &drop, tick, (int)seconds(composer, 0.1f));
            tick += seconds(composer, dice_between(dice, 0.6f, 1.1f));
            float angle = dice_between(dice, 0, 2 * PI), away = dice_between(dice, 18, 28);
            x += away * cosf(angle);
            y += away * sinf(angle);
        }
        i++;
    }
}

void compose(struct performance *performance, const struct compose_def *def, struct dice *dice)
{
    struct composer composer = {.performance = performance, .def = def, .dice = dice};
    performance_clear(performance, def->ticks);
    int64_t rest = def->ticks / 16 > 3 * (int64_t)def->rate ? def->ticks / 16 : 3 * (int64_t)def->rate;
    composer.end = def->ticks > 2 * rest ? def->ticks - rest : def->ticks / 2;
    harmony_init(&composer.harmony, def->inks, def->ink_count, dice);
    float longest = FIRST_RADIUS + 0.095f * (float)composer.end;
    arrange(&composer.arrangement, def->kind, def->width, def->height, longest, dice);
    plan(&composer);
    for (int i = 0; i < composer.arrangement.count; i++) {
        post_bloom(&composer, i);
    }
    for (int i = 0; i < composer.arrangement.sweep_count; i++) {
        post_sweep(&composer, &composer.arrangement.sweeps[i]);
    }
    post_splashes(&composer);
    performance_sort(performance);
}
