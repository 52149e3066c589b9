#include "performance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool performance_init(struct performance *performance, int room)
{
    *performance = (struct performance){.room = room};
    performance->steps = calloc((size_t)room, sizeof *performance->steps);
    return performance->steps != NULL;
}

void performance_finish(struct performance *performance)
{
    free(performance->steps);
    *performance = (struct performance){0};
}

void performance_clear(struct performance *performance, int64_t ticks)
{
    performance->count = 0;
    performance->ticks = ticks;
}

struct performance_step *performance_add(struct performance *performance, const struct action *action, int press_ticks)
{
    if (performance->count == performance->room) {
        return NULL;
    }
    struct performance_step *step = &performance->steps[performance->count];
    *step = (struct performance_step){.action = *action, .number = performance->count, .gesture = performance->count};
    performance->count++;
    step->press = press_ticks < 0 ? -1 : action->tick - press_ticks;
    int count = action->path.count;
    int kept = count < STUDIO_PATH ? count : STUDIO_PATH;
    for (int i = 0; i < kept; i++) {
        int from = kept > 1 ? (int)((int64_t)i * (count - 1) / (kept - 1)) : 0;
        step->points[i] = action->path.points[from];
    }
    step->action.path.count = kept;
    return step;
}

static bool by_hand(const struct performance_step *step)
{
    return step->press >= 0 && (step->action.has_at || step->action.path.count > 0);
}

static int by_press(const void *a, const void *b)
{
    const struct performance_step *one = a, *other = b;
    if (one->press != other->press) {
        return one->press < other->press ? -1 : 1;
    }
    return one->number - other->number;
}

/* Moves all steps of a gesture, or takes them out of what a hand does. Returns when it ends. */
static int64_t move_gesture(struct performance *performance, int gesture, int64_t ticks, bool out)
{
    int64_t end = 0;
    for (int i = 0; i < performance->count; i++) {
        struct performance_step *step = &performance->steps[i];
        if (step->gesture == gesture && by_hand(step)) {
            step->press += ticks;
            step->action.tick = out ? INT64_MAX : step->action.tick + ticks;
            end = step->action.tick > end ? step->action.tick : end;
        }
    }
    return end;
}

void performance_space(struct performance *performance, int pause)
{
    int64_t free_from = 0;
    qsort(performance->steps, (size_t)performance->count, sizeof performance->steps[0], by_press);
    for (int i = 0; i < performance->count; i++) {
        const struct performance_step *step = &performance->steps[i];
        bool goes_on = i > 0 && step->gesture != step->number;
        if (!by_hand(step) || step->action.tick == INT64_MAX || goes_on) {
            continue;
        }
        int64_t wait = free_from > step->press ? free_from - step->press : 0;
        bool out = step->spare && wait > pause;
        int64_t end = move_gesture(performance, step->gesture, wait, out);
        free_from = out ? free_from : end + pause;
    }
    int kept = 0;
    for (int i = 0; i < performance->count; i++) {
        if (performance->steps[i].action.tick < performance->ticks) {
            performance->steps[kept++] = performance->steps[i];
        }
    }
    performance->count = kept;
}

static int by_tick(const void *a, const void *b)
{
    const struct performance_step *one = a, *other = b;
    if (one->action.tick != other->action.tick) {
        return one->action.tick < other->action.tick ? -1 : 1;
    }
    return one->number - other->number;
}

void performance_sort(struct performance *performance)
{
    qsort(performance->steps, (size_t)performance->count, sizeof performance->steps[0], by_tick);
    for (int i = 0; i < performance->count; i++) {
        struct performance_step *step = &performance->steps[i];
        step->action.path.points = step->action.path.count > 0 ? step->points : NULL;
    }
}

static struct point first_of(const struct performance_step *step)
{
    return step->action.path.count > 0 ? step->points[0] : step->action.at;
}

static struct point last_of(const struct performance_step *step)
{
    return step->action.path.count > 0 ? step->points[step->action.path.count - 1] : step->action.at;
}

static struct point between(struct point from, struct point to, float share)
{
    return (struct point){from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
}

/* 0..1, slowly at both ends. */
static float eased(float share)
{
    share = fminf(fmaxf(share, 0.0f), 1.0f);
    return share * share * (3.0f - 2.0f * share);
}

bool performance_hand(const struct performance *performance, int next, int64_t tick, int glide, struct point *at,
                      float *pressed)
{
    const struct performance_step *before = NULL, *after = NULL;
    for (int i = next - 1; i >= 0 && !before; i--) {
        before = by_hand(&performance->steps[i]) ? &performance->steps[i] : NULL;
    }
    for (int i = next; i < performance->count && !after; i++) {
        after = by_hand(&performance->steps[i]) ? &performance->steps[i] : NULL;
    }
    *pressed = 0;
    if (after && tick >= after->press) { /* painting */
        float whole = (float)(after->action.tick - after->press);
        *at = between(first_of(after), last_of(after), whole > 0 ? (float)(tick - after->press) / whole : 1);
        *pressed = 1;
        return true;
    }
    int64_t left = before ? tick - before->action.tick : INT64_MAX; /* since it rose */
    int64_t comes = after ? after->press - tick : INT64_MAX;
    if (left >= glide && comes >= glide) {
        return false;
    }
    float third = (float)glide / 3; /* of the way, for coming down and rising */
    *pressed = fmaxf(1 - fminf((float)left, (float)comes) / third, 0);
    if (before && after && after->press - before->action.tick < 2 * (int64_t)glide) { /* from one to the next */
        float way = (float)left / (float)(left + comes);
        *at = between(last_of(before), first_of(after), eased(way));
    } else if (comes < glide) {
        struct point place = first_of(after);
        *at = between((struct point){place.x + 0.05f, place.y + 0.12f}, place, eased(1 - (float)comes / (float)glide));
    } else {
        struct point place = last_of(before);
        *at = between(place, (struct point){place.x + 0.05f, place.y + 0.12f}, eased((float)left / (float)glide));
    }
    return true;
}

static uint64_t hashed(uint64_t hash, uint64_t value)
{
    hash = (hash ^ value) * 0x9fb21c651e98df25u;
    return hash ^ hash >> 32;
}

static uint64_t hashed_number(uint64_t hash, float number)
{
    uint32_t bits;
    memcpy(&bits, &number, sizeof bits);
    return hashed(hash, bits);
}

uint64_t performance_fingerprint(const struct performance *performance)
{
    uint64_t hash = hashed(1, (uint64_t)performance->ticks);
    for (int i = 0; i < performance->count; i++) {
        const struct action *action = &performance->steps[i].action;
        hash = hashed(hash, (uint64_t)action->tick);
        hash = hashed(hash, (uint64_t)action->verb << 32 | (uint32_t)action->ink << 16 | (uint16_t)action->brush);
        hash = hashed_number(hashed_number(hash, action->at.x), action->at.y);
        hash = hashed_number(hashed_number(hash, action->radius), action->amount);
        for (int j = 0; j < action->path.count; j++) {
            const struct point *point = &performance->steps[i].points[j];
            hash = hashed_number(hashed_number(hash, point->x), point->y);
        }
    }
    return hash;
}
