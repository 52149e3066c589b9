#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "distance.h"
#include "first_passage.h"
#include "random.h"
#include "transition_grid.h"

enum {
    TIPS = 12000,  /* at most */
    ORDERS = 3,    /* stem, branch, branch of a branch */
    STEPS = 700,   /* at most */
    BORDER = 26,   /* nuclei along the borders */
    LATE = 110,    /* steps, within which those begin */
    NUCLEUS = 9,   /* steps from one nucleus within the sheet to the next */
    ROOM = 17,     /* cells around that, which must be bare */
    SPOTS = 4,     /* warm */
    OWN_STEPS = 4, /* in which a branch is free of its stem */
    NUCLEI_UNTIL = 420,
};

#define HALF   0.5f /* cosine and sine of 60 degrees */
#define ROOT_3 0.8660254f

/* Cells a step; steps from one pair of branches to the next; cells at most; how much it curls, 1 / cells. */
static const struct order {
    float speed;
    int apart, most;
    float curl, wander;
} orders[ORDERS] = {
    {1.0f, 7, 4000, 0.012f, 0.02f},
    {0.64f, 6, 60, 0.006f, 0.02f},
    {0.42f, 1000, 9, 0.0f, 0.03f},
};

struct tip {
    float x, y, c, s; /* cells, direction */
    float curl;
    int order, own, stem; /* numbers of its branch and of the one it comes from, 1.. */
    int steps;
    bool stands;
};

struct frost {
    struct transition_grid *grid;
    int *owner; /* of each cell, 0: bare */
    struct tip *tips;
    int count, step;
};

static float chance(const struct frost *frost, int what, int which)
{
    return random_unit(what, which, frost->grid->seed, RANDOM_FROST);
}

static int owner_at(const struct frost *frost, float x, float y)
{
    const struct transition_grid *grid = frost->grid;
    bool in = x >= 0 && y >= 0 && x < (float)grid->width && y < (float)grid->height;
    return in ? frost->owner[(int)y * grid->width + (int)x] : -1;
}

/* Leaves ice where it is bare. */
static void leave_ice(struct frost *frost, const struct tip *tip)
{
    if (owner_at(frost, tip->x, tip->y) == 0) {
        int cell = (int)tip->y * frost->grid->width + (int)tip->x;
        frost->owner[cell] = tip->own;
        frost->grid->come[cell] = (float)frost->step;
    }
}

static void sprout(struct frost *frost, struct tip tip)
{
    float length = sqrtf(tip.c * tip.c + tip.s * tip.s);
    if (frost->count < TIPS && length > 0) {
        tip.c /= length;
        tip.s /= length;
        tip.own = frost->count + 1;
        tip.curl = orders[tip.order].curl * (2.0f * chance(frost, 100 + tip.own, 0) - 1.0f);
        frost->tips[frost->count++] = tip;
        leave_ice(frost, &tip);
    }
}

/* A pair of branches, at 60 degrees to either side. */
static void branch(struct frost *frost, const struct tip *tip)
{
    for (int side = -1; side <= 1; side += 2) {
        float s = ROOT_3 * (float)side;
        sprout(frost, (struct tip){.x = tip->x,
                                   .y = tip->y,
                                   .c = HALF * tip->c - s * tip->s,
                                   .s = s * tip->c + HALF * tip->s,
                                   .order = tip->order + 1,
                                   .stem = tip->own});
    }
}

/* A step of a tip: it turns a little, goes on, and leaves ice, until something is in its way. */
static void grow(struct frost *frost, struct tip *tip)
{
    const struct order *order = &orders[tip->order];
    float turn = tip->curl + order->wander * (2.0f * chance(frost, tip->own, 1 + tip->steps) - 1.0f);
    float c = tip->c - turn * order->speed * tip->s, s = tip->s + turn * order->speed * tip->c;
    float length = sqrtf(c * c + s * s);
    tip->c = c / length;
    tip->s = s / length;
    tip->x += order->speed * tip->c;
    tip->y += order->speed * tip->s;
    tip->steps++;
    int here = owner_at(frost, tip->x, tip->y), ahead = owner_at(frost, tip->x + 1.7f * tip->c, tip->y + 1.7f * tip->s);
    bool young = (float)tip->steps * order->speed < OWN_STEPS;
    bool met = here > 0 && here != tip->own && !(young && here == tip->stem);
    met = met || (ahead > 0 && ahead != tip->own && !(young && ahead == tip->stem));
    tip->stands = here < 0 || met || (float)tip->steps * order->speed > (float)order->most;
    leave_ice(frost, tip);
}

static bool is_bare(const struct frost *frost, int x, int y)
{
    for (int k = 0; k < 4 * ROOM * ROOM; k++) {
        int at_x = x - ROOM + k % (2 * ROOM), at_y = y - ROOM + k / (2 * ROOM);
        if (owner_at(frost, (float)at_x, (float)at_y) > 0) {
            return false;
        }
    }
    return true;
}

/* A nucleus within the sheet: a star of six arms. */
static void nucleate(struct frost *frost)
{
    int x = (int)(chance(frost, 1, frost->step) * (float)frost->grid->width);
    int y = (int)(chance(frost, 2, frost->step) * (float)frost->grid->height);
    float c = chance(frost, 3, frost->step) - 0.5f, s = chance(frost, 4, frost->step) - 0.5f;
    if (!is_bare(frost, x, y)) {
        return;
    }
    int stem = frost->count + 1;
    for (int i = 0; i < 6; i++) {
        float turned = HALF * c - ROOT_3 * s;
        s = ROOT_3 * c + HALF * s;
        c = turned;
        sprout(frost, (struct tip){.x = (float)x + 0.5f, .y = (float)y + 0.5f, .c = c, .s = s, .stem = stem});
    }
}

/* Nuclei along the borders, each in its time, into the sheet. */
static void nucleate_border(struct frost *frost)
{
    float width = (float)frost->grid->width, height = (float)frost->grid->height;
    for (int i = 0; i < BORDER; i++) {
        if ((int)(LATE * chance(frost, 5, i)) != frost->step) {
            continue;
        }
        float along = ((float)i + 0.8f * chance(frost, 6, i)) * 2 * (width + height) / BORDER;
        float aside = 1.6f * chance(frost, 7, i) - 0.8f;
        struct tip tip = {.order = 0};
        if (along < width) {
            tip = (struct tip){.x = along, .y = 0.5f, .c = aside, .s = 1};
        } else if (along < 2 * width) {
            tip = (struct tip){.x = along - width, .y = height - 0.5f, .c = aside, .s = -1};
        } else if (along < 2 * width + height) {
            tip = (struct tip){.x = 0.5f, .y = along - 2 * width, .c = 1, .s = aside};
        } else {
            tip = (struct tip){.x = width - 0.5f, .y = along - 2 * width - height, .c = -1, .s = aside};
        }
        sprout(frost, tip);
    }
}

static void grow_all(struct frost *frost)
{
    bool any = true;
    for (frost->step = 0; frost->step < STEPS && (any || frost->step < NUCLEI_UNTIL); frost->step++) {
        int count = frost->count;
        any = false;
        nucleate_border(frost);
        if (frost->step % NUCLEUS == NUCLEUS - 1 && frost->step < NUCLEI_UNTIL) {
            nucleate(frost);
        }
        for (int i = 0; i < count; i++) {
            struct tip *tip = &frost->tips[i];
            if (tip->stands) {
                continue;
            }
            any = true;
            grow(frost, tip);
            if (!tip->stands && tip->order + 1 < ORDERS && tip->steps % orders[tip->order].apart == 0) {
                branch(frost, tip);
            }
        }
    }
}

/* How near a branch is, and of which order. */
static bool shade(struct frost *frost)
{
    struct transition_grid *grid = frost->grid;
    size_t cells = (size_t)grid->width * (size_t)grid->height;
    uint8_t *bare = malloc(cells);
    bool good = bare;
    for (size_t i = 0; i < cells && good; i++) {
        bare[i] = frost->owner[i] == 0;
    }
    good = good && distance_transform(bare, grid->width, grid->height, grid->relief);
    for (size_t i = 0; i < cells && good; i++) {
        float grain = random_unit((int)i, 8, grid->seed, RANDOM_FROST);
        float own = frost->owner[i] > 0 ? 1.0f - 0.16f * (float)frost->tips[frost->owner[i] - 1].order : 0.8f;
        float near = 1.0f / (1.0f + 0.55f * grid->relief[i] * grid->relief[i]);
        grid->relief[i] = fminf(own * near + 0.12f * (grain - 0.5f) + 0.04f, 1);
        grid->relief[i] = fmaxf(grid->relief[i], 0);
    }
    free(bare);
    return good;
}

/* Rime fills what is between the branches, slowly; then warm spots take it all, what is thick last. */
static bool fill_and_melt(struct frost *frost)
{
    struct transition_grid *grid = frost->grid;
    int cells = grid->width * grid->height;
    for (int i = 0; i < cells; i++) {
        grid->slow[i] = 3.0f + 5.0f * random_unit(i, 9, grid->seed, RANDOM_FROST);
        grid->leave[i] = FLT_MAX;
    }
    if (!first_passage(grid->width, grid->height, grid->slow, grid->come) || !shade(frost)) {
        return false;
    }
    for (int i = 0; i < SPOTS; i++) {
        int x = (int)((0.2f + 0.6f * chance(frost, 10, i)) * (float)grid->width);
        int y = (int)((0.2f + 0.6f * chance(frost, 11, i)) * (float)grid->height);
        grid->leave[y * grid->width + x] = 30.0f * chance(frost, 12, i);
    }
    for (int i = 0; i < cells; i++) {
        float broad = transition_noise(grid, i % grid->width, i / grid->width, 24, 3);
        grid->slow[i] = 0.3f + 1.5f * broad + 2.5f * grid->relief[i] * grid->relief[i];
    }
    return first_passage(grid->width, grid->height, grid->slow, grid->leave);
}

bool transition_freeze(struct transition_grid *grid)
{
    size_t cells = (size_t)grid->width * (size_t)grid->height;
    struct frost frost = {.grid = grid};
    frost.owner = calloc(cells, sizeof *frost.owner);
    frost.tips = malloc(TIPS * sizeof *frost.tips);
    bool good = frost.owner && frost.tips;
    for (size_t i = 0; i < cells; i++) {
        grid->come[i] = FLT_MAX;
    }
    if (good) {
        grow_all(&frost);
        good = fill_and_melt(&frost);
    }
    free(frost.tips);
    free(frost.owner);
    return good;
}
