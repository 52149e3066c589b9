/* The time brush: the cells under a stroke as they were some rounds ago, each pass further back. */
#include "history_restore.h"
#include "noise.h"

enum { PASS_TICKS = 12 }; /* the time brush takes a cell back once in so many ticks */

#define SOFT_RIM 0.2f /* of its radius, that it fades over */
#define RIM_TORN 0.4f /* of its radius, that its edge wavers by: a straight cut would be seen for long */
#define RIM_SIZE 9.0f /* cells, of a wave */

static float cover_of(const struct restoring *restoring, float x, float y)
{
    float best = 0.0f, torn = 0.5f + 0.5f * noise_smooth(x, y, RIM_SIZE, 1, RANDOM_RIM);
    for (int i = 0; i < restoring->mark_count; i++) {
        const struct mark *mark = &restoring->marks[i];
        float inside = -mark_distance(mark, x, y) - torn * RIM_TORN * mark->radius;
        float t = inside / (SOFT_RIM * mark->radius);
        best = t > best ? t : best;
    }
    return best < 1.0f ? best : 1.0f;
}

/* The version that the last round before a moment has made of a tile: those that groups have asked for stand at moments
 * of their own, and would not fit to those of the tiles beside it. Versions of time that a cell has lost are passed
 * over. */
static uint32_t version_for(const struct history *history, int tile, const struct lost *lost, uint32_t target)
{
    uint32_t round = (uint32_t)history->def.interval * MOMENTS, begin = target / round * round;
    uint32_t version = past_find(history->past, tile, begin + round - 1);
    while (version != PAST_NONE) {
        uint32_t older = past_before(history->past, version), moment = past_moment(history->past, version);
        bool between =
            past_group(history->past, version) && older != PAST_NONE && past_moment(history->past, older) >= begin;
        bool gone = moment > lost->from && moment <= lost->until && older != PAST_NONE;
        if (!between && !gone) {
            break;
        }
        version = older;
    }
    return version;
}

/* Takes a cell back; in one pass once, and then by as much more as it is covered more. Returns the share. */
static float aim(const struct restoring *restoring, int tile, struct lost *lost, float cover, uint32_t *version)
{
    uint32_t now = restoring->now, depth = (uint32_t)restoring->depth;
    uint16_t tick = (uint16_t)(now / MOMENTS);
    bool same = lost->cover > 0 && (uint16_t)(tick - lost->pass) < PASS_TICKS;
    uint8_t level = (uint8_t)(cover * 255.0f);
    if (level == 0 || (same && level <= lost->cover)) {
        return 0.0f;
    }
    uint32_t target = now > depth ? now - depth : 0, gap = target < lost->until ? lost->until - lost->from : 0;
    target = target > gap ? target - gap : 0;
    if (same && lost->cover >= 128) {
        target = lost->from; /* it is there already, but for a share */
    }
    *version = version_for(restoring->history, tile, lost, target);
    if (*version == PAST_NONE) {
        return 0.0f;
    }
    if (level >= 128) {
        lost->from = target;
        lost->until = now;
    }
    lost->pass = same ? lost->pass : tick;
    lost->cover = level;
    return cover;
}

static void plan_rewind(struct restoring *restoring, int tile, struct plan *plan)
{
    const struct history *history = restoring->history;
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        struct lost *lost = lost_of(history, tile, cell);
        plan->share[cell] = 0.0f;
        plan->ground[cell] = 0;
        if (lost) {
            int x = x_of(history, tile) + cell % TILE, y = y_of(history, tile) + cell / TILE;
            float cover = cover_of(restoring, (float)x + 0.5f, (float)y + 0.5f);
            plan->share[cell] = aim(restoring, tile, lost, cover, &plan->versions[cell]);
            plan->ground[cell] = plan->share[cell] >= 0.5f;
            plan->any = plan->any || plan->share[cell] > 0.0f;
        }
    }
}

/* One version after the other, each for the cells that want it. */
static void apply_rewind(struct restoring *restoring, int tile, struct plan *plan)
{
    for (int first = 0; first < TILE_CELLS; first++) {
        if (plan->share[first] <= 0.0f) {
            continue;
        }
        struct plan part = {.any = true};
        struct tile_code code;
        for (int cell = first; cell < TILE_CELLS; cell++) {
            if (plan->share[cell] > 0.0f && plan->versions[cell] == plan->versions[first]) {
                part.share[cell] = plan->share[cell];
                part.ground[cell] = plan->ground[cell];
                plan->share[cell] = cell == first ? plan->share[cell] : 0.0f;
            }
        }
        past_read(restoring->history->past, plan->versions[first], &code);
        restoring_give(restoring, tile, &part, &code);
    }
}

void history_rewind(struct history *history, struct engine *engine, const struct mark *marks, int count, float ticks)
{
    struct restoring restoring = {.history = history,
                                  .engine = engine,
                                  .now = history_moment(history),
                                  .marks = marks,
                                  .mark_count = count,
                                  .depth = ticks * (float)MOMENTS,
                                  .plan = plan_rewind,
                                  .apply = apply_rewind};
    restoring_run(&restoring, history_around(history, marks, count, 0.0f));
}
