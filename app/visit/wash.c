#include "wash.h"

#include <math.h>

#include "random.h"
#include "rinse.h"

/* Of the height of the sheet. */
#define REACH  0.5f
#define RAGGED 0.6f  /* of the reach */
#define SLANT  0.14f /* from one side to the other, at the most */
#define WANDER 0.05f /* of a point of the front to and fro */
#define BESIDE (0.5f * SLANT + 2.0f * WANDER + RINSE_MOST * RAGGED * REACH)
#define FIRST  (-0.15f) /* the earliest of it is on the sheet at once */
#define LAST   (1.02f + REACH + BESIDE)
#define LEAP   (0.2f * REACH) /* that the front may make at a time and leave nothing out */
#define DOWN   0.86f          /* share of the time until the front is beyond the sheet; then the rest drains */

void wash_begin(struct wash *wash, int64_t tick, float seconds, int ticks_per_second, uint32_t seed)
{
    float ticks = seconds * (float)ticks_per_second;
    *wash = (struct wash){.start = tick, .seed = seed, .last = tick - 1, .running = true};
    wash->ticks = ticks > (float)WASH_TICKS_MIN ? (int)ticks : WASH_TICKS_MIN;
}

/* How far the front has come at a share of the time, steadily, then quicker. */
static float along_at(float share)
{
    float beyond = 1.0f + BESIDE;
    if (share < DOWN) {
        return FIRST + (beyond - FIRST) * share / DOWN;
    }
    float rest = (share - DOWN) / (1.0f - DOWN), slow = (beyond - FIRST) / DOWN * (1.0f - DOWN);
    return beyond + slow * rest + (LAST - beyond - slow) * rest * rest;
}

static void place_front(struct wash *wash, float share)
{
    float along = along_at(share);
    float slant = SLANT * random_signed(0, 1, wash->seed, RANDOM_WATER);
    for (int i = 0; i < WASH_POINTS; i++) {
        float x = (float)i / (WASH_POINTS - 1), phase = random_unit(i, 2, wash->seed, RANDOM_WATER);
        float early = random_signed(i, 3, wash->seed, RANDOM_WATER);
        float moves = sinf(6.2831853f * (1.2f * share + phase));
        wash->points[i] = (struct point){x, along + slant * (x - 0.5f) + WANDER * (early + moves)};
    }
}

/* Ticks from one action to the next at the most. */
static int leap_ticks(const struct wash *wash)
{
    float ticks = LEAP / (2.0f * (LAST - FIRST)) * (float)wash->ticks;
    return ticks > 1.0f ? (int)ticks : 1;
}

bool wash_action(struct wash *wash, int64_t tick, struct action *action)
{
    if (!wash->running || tick <= wash->last) {
        return false;
    }
    int64_t end = wash->start + wash->ticks, next = wash->last + leap_ticks(wash);
    next = wash->last < wash->start ? wash->start : next < tick ? next : tick;
    next = next >= end && wash->last < end - 1 ? end - 1 : next; /* the front goes all of its way */
    if (next >= end) {
        wash->last = end;
        wash->running = false;
        *action = action_default(ACTION_CLEAR);
        return true;
    }
    float strength = 25.0f * (float)(next - wash->last) / (float)wash->ticks;
    wash->last = next;
    place_front(wash, (float)(next - wash->start + 1) / (float)wash->ticks);
    *action = action_default(ACTION_RINSE);
    action->tick = next;
    action->path = (struct action_path){wash->points, WASH_POINTS};
    action->reach = REACH;
    action->vary = RAGGED;
    action->strength = strength < 1.0f ? strength : 1.0f;
    return true;
}

bool wash_over(const struct wash *wash, int64_t tick)
{
    return tick >= wash->start + wash->ticks;
}
