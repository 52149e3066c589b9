#include "compose.h"

#include <math.h>
#include <stdlib.h>

#include "brush.h"
#include "harmony.h"

static const float PI = 3.14159265f;
static const float DROP_RADIUS = 9; /* cells; what a ragged drop of it has grown to at once is FIRST_RADIUS */
static const float FIRST_RADIUS = 11;

static const float SPLASH_ROOM = 14, SPLASH_REACH = 36; /* cells around a bead */
static const float LONGEST_STRETCH = 0.95f;             /* of the time that a bloom takes, until the next begins */

enum { SEGMENTS = 4, REST_S = 4 };

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

/* What there is no room for in the performance is left out: NULL. */
static struct performance_step *post(struct composer *composer, struct action *action, int64_t tick, int press)
{
    action->tick = tick < 0 ? 0 : tick;
    return performance_add(composer->performance, action, press);
}

static void spare(struct performance_step *step)
{
    if (step) {
        step->spare = true;
    }
}

static float drop_radius(const struct bloom *bloom)
{
    return fmaxf(DROP_RADIUS, 0.04f * bloom->r);
}

/* Areas of the bloom and the drop, beside each other. */
static float share_of_size(const struct bloom *bloom)
{
    float share = bloom->r / drop_radius(bloom);
    return share * share;
}

/* Arms along a sweep come on faster than others, and go farther. */
static bool is_swept(const struct composer *composer)
{
    enum arrangement_kind kind = composer->def->kind;
    return kind == ARRANGED_GARLAND || kind == ARRANGED_WINDOW || kind == ARRANGED_REEF || kind == ARRANGED_MOON;
}

static void post_drop(struct composer *composer, const struct bloom *bloom, int ink, int64_t tick)
{
    struct action drop = action_default(ACTION_DROP);
    drop.at = place(composer, bloom->x, bloom->y);
    drop.has_at = true;
    drop.ink = ink;
    drop.radius = drop_radius(bloom) * dice_between(composer->dice, 0.9f, 1.1f);
    drop.solvent = 2 + 0.15f * share_of_size(bloom); /* it starves at about that size, slowly */
    drop.amount = 15 + (is_swept(composer) ? 0.8f : 0.62f) * share_of_size(bloom);
    drop.edge = EDGE_RAGGED;
    drop.brush = bloom->brush;
    drop.reach = fminf(2.2f * bloom->r + 30, 1024); /* what is swept goes farther than it would */
    post(composer, &drop, tick, (int)seconds(composer, 0.12f));
}

static struct performance_step *post_ink(struct composer *composer, const struct bloom *bloom, int ink, float share,
                                         int64_t tick)
{
    struct point at = place(composer, bloom->x, bloom->y);
    struct action stroke = action_default(ACTION_BRUSH_INK);
    stroke.path = (struct action_path){&at, 1};
    stroke.ink = ink;
    stroke.radius = fmaxf(fminf(fmaxf(0.1f * bloom->r, 6), 13), 0.05f * bloom->r);
    float discs = bloom->r / stroke.radius * (bloom->r / stroke.radius);
    stroke.amount = 0.62f * share * discs;
    return post(composer, &stroke, tick, (int)seconds(composer, 0.25f));
}

/* A stroke in pieces, as a hand makes it. */
static void post_stroke(struct composer *composer, struct action *stroke, const struct point *points, int count,
                        int64_t tick, int64_t takes)
{
    int gesture = composer->performance->count;
    for (int i = 0; i + 1 < count; i++) {
        stroke->path = (struct action_path){&points[i], 2};
        int64_t piece = takes / (count - 1);
        struct performance_step *step = post(composer, stroke, tick + piece * i, (int)piece);
        spare(step);
        if (step) {
            step->gesture = gesture;
        }
    }
}

/* Solvent before the front: arms reach along it. */
static void post_pull(struct composer *composer, const struct bloom *bloom, int64_t tick)
{
    struct point points[SEGMENTS + 1];
    float angle = 0, bend = dice_between(composer->dice, -0.8f, 0.8f), most = 0;
    for (int i = 0; i < 8; i++) { /* where there is room */
        float other = dice_between(composer->dice, 0, 2 * PI), away = 1.2f * bloom->r;
        float x = bloom->x + away * cosf(other + bend), y = bloom->y + away * sinf(other + bend);
        float room = arrangement_room(&composer->arrangement, x, y, bloom);
        angle = room > most ? other : angle;
        most = fmaxf(room, most);
    }
    if (most < 0.12f * bloom->r) {
        return;
    }
    for (int i = 0; i <= SEGMENTS; i++) {
        float share = (float)i / SEGMENTS, away = bloom->r * (0.35f + 0.85f * share);
        points[i] = place(composer, bloom->x + away * cosf(angle + bend * share * share),
                          bloom->y + away * sinf(angle + bend * share * share));
    }
    struct action stroke = action_default(ACTION_BRUSH_SOLVENT);
    stroke.radius = fminf(fmaxf(0.09f * bloom->r, 5), 14);
    stroke.amount = 2.5f;
    post_stroke(composer, &stroke, points, SEGMENTS + 1, tick, seconds(composer, 1.4f));
}

/* When blooms begin: each before the one before it is done, so that something always grows, and as far apart as there
 * is time for. What is left of the time then is left out. */
static void plan(struct composer *composer)
{
    struct arrangement *a = &composer->arrangement;
    int64_t begin = seconds(composer, 0.4f), least = seconds(composer, 1.5f), start = begin, last = begin;
    float sum = 0, takes[ARRANGED_BLOOMS];
    for (int i = 0; i < a->count; i++) {
        takes[i] = fmaxf(a->blooms[i].r - FIRST_RADIUS, 4) / speed_of(a->blooms[i].brush);
        sum += i + 1 < a->count ? takes[i] : 0;
    }
    float stretch = sum > 0 ? ((float)(composer->end - begin) - takes[a->count - 1]) / sum : 0;
    stretch = fminf(fmaxf(stretch, 0.0f), LONGEST_STRETCH);
    for (int i = 0; i < a->count; i++) {
        struct bloom *bloom = &a->blooms[i];
        float left = (float)(composer->end - start);
        if (takes[i] > left) { /* as large as there is time for */
            takes[i] = fmaxf(left, 0);
            bloom->r = FIRST_RADIUS + speed_of(bloom->brush) * takes[i];
        }
        composer->starts[i] = start;
        composer->grown[i] = start + (int64_t)takes[i];
        last = composer->grown[i] > last ? composer->grown[i] : last;
        int64_t step = (int64_t)(stretch * takes[i] * dice_between(composer->dice, 0.85f, 1.0f));
        start += step > least ? step : least;
    }
    composer->end = last;
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
        spare(post_ink(composer, bloom, inks.third, 0.5f * share, start + (int64_t)(0.72f * (float)takes)));
    }
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
    guide.radius = fminf(sweep->radius, 512);
    guide.strength = sweep->strength;
    post(composer, &guide, first + seconds(composer, dice_between(composer->dice, 2.4f, 3.4f)),
         (int)seconds(composer, 1.4f));
}

/* Beads beside what has grown, late: one, and smaller ones near it. */
static void post_splash(struct composer *composer, float x, float y, int64_t tick)
{
    struct dice *dice = composer->dice;
    int ink = harmony_any(&composer->harmony, dice), brush = brush_find(dice_chance(dice, 0.5f) ? "lichen" : "coral");
    float radius = dice_between(dice, 1.3f, 2.2f);
    for (int i = 0, count = 1 + dice_of(dice, 3); i < count; i++) {
        struct action drop = action_default(ACTION_DROP);
        drop.at = place(composer, x, y);
        drop.has_at = true;
        drop.ink = ink;
        drop.brush = brush;
        drop.reach = SPLASH_REACH;
        drop.radius = radius;
        drop.solvent = 7;
        drop.amount = 40;
        if (arrangement_room(&composer->arrangement, x, y, NULL) > SPLASH_ROOM) {
            spare(post(composer, &drop, tick, (int)seconds(composer, 0.1f)));
        }
        tick += seconds(composer, dice_between(dice, 0.6f, 1.1f));
        radius *= 0.75f;
        float angle = dice_between(dice, 0, 2 * PI), away = dice_between(dice, 26, 40);
        x += away * cosf(angle);
        y += away * sinf(angle);
    }
}

static void post_splashes(struct composer *composer)
{
    const struct arrangement *a = &composer->arrangement;
    struct dice *dice = composer->dice;
    float side = fminf(a->width, a->height);
    int groups = side < 200 ? 1 : 2 + dice_of(dice, 3);
    for (int i = 0, tries = 0; i < groups && tries < 200; tries++) {
        float x = dice_between(dice, 0.04f, 0.96f) * a->width, y = dice_between(dice, 0.04f, 0.96f) * a->height;
        float room = arrangement_room(a, x, y, NULL);
        if (room > 0.02f * side + SPLASH_ROOM && room < 0.12f * side + SPLASH_ROOM) {
            float share = ((float)i + dice_between(dice, 0.2f, 0.8f)) / (float)groups;
            int64_t early = (int64_t)((float)composer->end * 0.3f * (1 - share));
            post_splash(composer, x, y, composer->end - early + seconds(composer, share));
            i++;
        }
    }
}

void compose(struct performance *performance, const struct compose_def *def, struct dice *dice)
{
    struct composer composer = {.performance = performance, .def = def, .dice = dice};
    performance_clear(performance, def->ticks);
    int64_t rest = REST_S * (int64_t)def->rate;
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
    performance->ticks = composer.end + rest < def->ticks ? composer.end + rest : def->ticks;
    performance_space(performance, (int)seconds(&composer, 0.7f));
    performance_sort(performance);
}
