/* Undo, redo and the time brush: lines of tiles are taken out of the engine, blended with what they were, and put
 * back. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "history_state.h"

enum { PASS_TICKS = 12 }; /* the time brush takes a cell back once in so many ticks */

#define SPEED       0.2f /* cells a tick that growth goes on by, about */
#define GROWTH      0.5f /* cells a tick that it never exceeds */
#define GROWTH_ROOM 8.0f
#define FLOW        0.25f /* cells a tick, and at most, that liquid comes along a pattern */
#define FLOW_ROOM   10.0f
#define FLOW_MOST   90.0f
#define CARVED      0.1f /* as DEPOSIT_CARVED */

/* What is done to each tile of a line; `plan` first says where. */
struct restoring {
    struct history *history;
    struct engine *engine;
    struct group *group;
    uint32_t now;
    const struct territory *territory; /* of undo */
    const struct mark *marks;          /* of rewind */
    int mark_count;
    float depth; /* moments that the middle of the time brush goes back */
    bool keeps;  /* what is there before */
    void (*plan)(struct restoring *restoring, int tile, struct plan *plan);
    void (*apply)(struct restoring *restoring, int tile, struct plan *plan);
};

static int x_of(const struct history *history, int tile)
{
    return tile % history->columns * TILE;
}

static int y_of(const struct history *history, int tile)
{
    return tile / history->columns * TILE;
}

static struct lost *lost_of(const struct history *history, int tile, int cell)
{
    int x = x_of(history, tile) + cell % TILE, y = y_of(history, tile) + cell / TILE;
    bool outside = x >= history->width || y >= history->height;
    return outside ? NULL : &history->lost[(size_t)y * (size_t)history->width + (size_t)x];
}

/* Under an obstacle that stays nothing changes: liquid would be caught there. */
static void spare_obstacles(const struct history *history, int tile, struct plan *plan)
{
    const struct patch *patch = &history->patch;
    int columns = patch->cells.x1 - patch->cells.x0, rows = patch->cells.y1 - patch->cells.y0;
    int left = x_of(history, tile) - patch->cells.x0;
    const uint16_t *rest = patch_ground(patch, PATCH_REST);
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        int x = left + cell % TILE, y = cell / TILE;
        if (x < columns && y < rows && rest[y * columns + x] >> 8 && !plan->ground[cell]) {
            plan->share[cell] = 0.0f;
        }
    }
}

static void restore_line(struct restoring *restoring, int line, int left, int right)
{
    struct history *history = restoring->history;
    int first = right + 1, last = left - 1;
    for (int column = left; column <= right; column++) {
        struct plan *plan = &history->plans[column];
        plan->any = false;
        restoring->plan(restoring, line * history->columns + column, plan);
        if (plan->any) {
            first = first < column ? first : column;
            last = column;
        }
    }
    if (first > last || !history_save_line(history, restoring->engine, line, first, last)) {
        return;
    }
    for (int column = first; column <= last; column++) {
        int tile = line * history->columns + column;
        struct plan *plan = &history->plans[column];
        if (plan->any) {
            if (restoring->keeps) {
                struct tile_code code;
                tile_code_take(&code, &history->patch, column * TILE, line * TILE);
                past_keep(history->past, tile, &code, restoring->now, 0);
            }
            spare_obstacles(history, tile, plan);
            restoring->apply(restoring, tile, plan);
        }
    }
    restoring->engine->ops->load_patch(restoring->engine, &history->patch);
}

static void restore(struct restoring *restoring, struct rectangle cells)
{
    if (rectangle_is_empty(cells)) {
        return;
    }
    for (int line = cells.y0 / TILE; line * TILE < cells.y1; line++) {
        restore_line(restoring, line, cells.x0 / TILE, (cells.x1 - 1) / TILE);
    }
}

/* Brings the tile in the patch to what a code says, as far as the plan wants. */
static void give(struct restoring *restoring, int tile, const struct plan *plan, const struct tile_code *code)
{
    struct history *history = restoring->history;
    struct tile_values values;
    tile_code_values(code, &values);
    tile_values_blend(&values, plan->share, &history->patch, x_of(history, tile), y_of(history, tile));
    tile_code_give_ground(code, plan->ground, &history->patch, x_of(history, tile), y_of(history, tile));
}

static void lose(const struct restoring *restoring, int tile, const struct plan *plan, uint32_t from)
{
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        struct lost *lost = lost_of(restoring->history, tile, cell);
        if (lost && plan->share[cell] >= 0.5f) {
            lost->from = from;
            lost->until = restoring->now;
        }
    }
}

/* ---- undo */

/* The version of a tile that was before a group. */
static uint32_t before(const struct history *history, const struct group *group, int tile)
{
    uint32_t own = past_find_of(history->past, tile, group->id);
    return own != PAST_NONE ? own : past_find(history->past, tile, group->begin);
}

static void copy_cell(struct tile_code *to, const struct tile_code *from, int cell)
{
    for (int plane = 0; plane < CODE_PLANES; plane++) {
        to->planes[plane][cell] = from->planes[plane][cell];
    }
}

/* A version as it would be without what was taken back meanwhile: cells that have lost the time it shows are as they
 * were when that began. */
static void read_mended(const struct history *history, int tile, uint32_t version, struct tile_code *code)
{
    uint32_t moment = past_moment(history->past, version), held = PAST_NONE;
    struct tile_code older;
    past_read(history->past, version, code);
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        const struct lost *lost = lost_of(history, tile, cell);
        if (!lost || moment <= lost->from || moment > lost->until) {
            continue;
        }
        uint32_t wanted = past_find(history->past, tile, lost->from);
        if (wanted == PAST_NONE) {
            continue;
        }
        if (wanted != held) {
            past_read(history->past, wanted, &older);
            held = wanted;
        }
        copy_cell(code, &older, cell);
    }
}

static void plan_undo(struct restoring *restoring, int tile, struct plan *plan)
{
    struct history *history = restoring->history;
    plan->version = before(history, restoring->group, tile);
    plan->any = plan->version != PAST_NONE &&
                territory_shares(restoring->territory, x_of(history, tile), y_of(history, tile),
                                 past_moment(history->past, plan->version), plan->share, plan->ground);
}

/* Keeps what undo takes, for redo. */
static void take(struct restoring *restoring, int tile, const struct plan *plan)
{
    struct group *group = restoring->group;
    struct past *past = restoring->history->past;
    uint16_t shares[TILE_CELLS];
    if (group->taken_count == group->taken_room) {
        int room = group->taken_room > 0 ? 2 * group->taken_room : 64;
        struct taken *taken = realloc(group->taken, (size_t)room * sizeof *taken);
        if (!taken) {
            return;
        }
        group->taken = taken;
        group->taken_room = room;
    }
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        shares[cell] = (uint16_t)((unsigned)(plan->share[cell] * 255.0f + 0.5f) | (plan->ground[cell] ? 256u : 0u));
    }
    uint32_t newest = past_newest(past, tile);
    uint32_t copy = newest == PAST_NONE ? PAST_NONE : past_copy(past, newest, shares);
    if (copy != PAST_NONE) {
        group->taken[group->taken_count++] = (struct taken){tile, copy};
    }
}

static void apply_undo(struct restoring *restoring, int tile, struct plan *plan)
{
    struct history *history = restoring->history;
    struct tile_code code;
    uint32_t version = before(history, restoring->group, tile); /* it may have gone while room was made */
    if (version == PAST_NONE) {
        return;
    }
    uint32_t moment = past_moment(history->past, version);
    if (restoring->group->rewinds) {
        past_read(history->past, version, &code);
    } else {
        read_mended(history, tile, version, &code);
    }
    take(restoring, tile, plan);
    give(restoring, tile, plan, &code);
    lose(restoring, tile, plan, moment < restoring->group->begin ? restoring->group->begin : moment);
}

/* The tiles of the box as they were: where they were carved. */
static bool find_carved(const struct history *history, const struct group *group, struct territory *territory)
{
    struct rectangle box = territory->box;
    size_t width = (size_t)(box.x1 - box.x0);
    territory->carved = calloc(width * (size_t)(box.y1 - box.y0), 1);
    for (int y = box.y0; territory->carved && y < box.y1; y += TILE) {
        for (int x = box.x0; x < box.x1; x += TILE) {
            uint16_t active[TILE_CELLS], carved[TILE_CELLS];
            uint32_t version = before(history, group, y / TILE * history->columns + x / TILE);
            if (version == PAST_NONE) {
                continue;
            }
            past_read_plane(history->past, version, CODE_ACTIVE, active);
            past_read_plane(history->past, version, CODE_CARVED, carved);
            for (int cell = 0; cell < TILE_CELLS; cell++) {
                int column = x + cell % TILE, row = y + cell / TILE;
                if (column < box.x1 && row < box.y1) {
                    territory->carved[(size_t)(row - box.y0) * width + (size_t)(column - box.x0)] =
                        tile_code_number(active[cell]) + tile_code_number(carved[cell]) > CARVED;
                }
            }
        }
    }
    return territory->carved && territory_measure(territory);
}

static bool was_carved(const struct history *history, const struct group *group, float x, float y)
{
    int column = (int)x < history->width ? (int)x : history->width - 1;
    int row = (int)y < history->height ? (int)y : history->height - 1;
    uint16_t active[TILE_CELLS], carved[TILE_CELLS];
    uint32_t version = before(history, group, row / TILE * history->columns + column / TILE);
    if (version == PAST_NONE) {
        return false;
    }
    int cell = row % TILE * TILE + column % TILE;
    past_read_plane(history->past, version, CODE_ACTIVE, active);
    past_read_plane(history->past, version, CODE_CARVED, carved);
    return tile_code_number(active[cell]) + tile_code_number(carved[cell]) > CARVED;
}

/* The marks of a group, for the caller to free; sees where each fell. */
static struct mark *own_marks(const struct history *history, const struct group *group, int *count)
{
    struct mark *own = malloc((size_t)history->mark_count * sizeof *own + 1);
    *count = 0;
    for (int i = 0; own && i < history->mark_count; i++) {
        if (history->marks[i].group == group->id) {
            own[*count] = history->marks[i];
            own[*count].on_pattern =
                own[*count].kind == MARK_GROWS && was_carved(history, group, own[*count].x0, own[*count].y0);
            ++*count;
        }
    }
    return own;
}

static struct rectangle whole_tiles(const struct history *history, struct rectangle cells)
{
    struct rectangle whole = {cells.x0 / TILE * TILE, (cells.x1 + TILE - 1) / TILE * TILE, cells.y0 / TILE * TILE,
                              (cells.y1 + TILE - 1) / TILE * TILE};
    return rectangle_clip(whole, history->width, history->height);
}

static float reach_of(const struct territory *territory)
{
    float most = 4.0f;
    for (int i = 0; i < territory->own_count; i++) {
        const struct mark *mark = &territory->own[i];
        float reach = mark->kind == MARK_GROWS ? mark->on_pattern ? territory->flow : territory->growth : 4.0f;
        reach = reach > mark->stamp - mark->radius ? reach : mark->stamp - mark->radius;
        most = most > reach ? most : reach;
    }
    return most;
}

void history_undo(struct history *history, struct engine *engine, struct group *group)
{
    uint32_t now = history_moment(history);
    float ticks = (float)(now / MOMENTS - group->begin / MOMENTS), flow = FLOW_ROOM + FLOW * ticks;
    struct territory territory = {.others = history->marks,
                                  .other_count = history->mark_count,
                                  .group = group->id,
                                  .begin = group->begin,
                                  .moments_a_cell = (float)MOMENTS / SPEED,
                                  .growth = GROWTH_ROOM + GROWTH * ticks,
                                  .flow = flow < FLOW_MOST ? flow : FLOW_MOST};
    struct mark *own = own_marks(history, group, &territory.own_count);
    territory.own = own;
    territory.box = whole_tiles(history, history_around(history, own, territory.own_count, reach_of(&territory)));
    if (own && !rectangle_is_empty(territory.box) && find_carved(history, group, &territory)) {
        struct restoring restoring = {.history = history,
                                      .engine = engine,
                                      .group = group,
                                      .now = now,
                                      .territory = &territory,
                                      .keeps = true,
                                      .plan = plan_undo,
                                      .apply = apply_undo};
        group->taken_count = 0;
        restore(&restoring, territory.box);
    }
    group->state = GROUP_UNDONE;
    group->undone = now;
    history_count_marks(history, group->id, false);
    free(own);
    free(territory.carved);
    free(territory.from_carved);
}

/* ---- redo */

static void plan_redo(struct restoring *restoring, int tile, struct plan *plan)
{
    const struct group *group = restoring->group;
    for (int i = 0; i < group->taken_count; i++) {
        if (group->taken[i].tile != tile) {
            continue;
        }
        uint16_t shares[TILE_CELLS];
        plan->any = true;
        plan->version = group->taken[i].version;
        past_read_extra(restoring->history->past, plan->version, shares);
        for (int cell = 0; cell < TILE_CELLS; cell++) {
            plan->share[cell] = (float)(shares[cell] & 255u) * (1.0f / 255);
            plan->ground[cell] = (shares[cell] & 256u) != 0;
        }
        return;
    }
}

static void apply_redo(struct restoring *restoring, int tile, struct plan *plan)
{
    struct tile_code code;
    past_read(restoring->history->past, plan->version, &code);
    give(restoring, tile, plan, &code);
    lose(restoring, tile, plan, restoring->group->undone);
}

void history_redo(struct history *history, struct engine *engine, struct group *group)
{
    struct rectangle cells = {history->width, 0, history->height, 0};
    struct restoring restoring = {.history = history,
                                  .engine = engine,
                                  .group = group,
                                  .now = history_moment(history),
                                  .keeps = true,
                                  .plan = plan_redo,
                                  .apply = apply_redo};
    for (int i = 0; i < group->taken_count; i++) {
        int x = x_of(history, group->taken[i].tile), y = y_of(history, group->taken[i].tile);
        cells.x0 = x < cells.x0 ? x : cells.x0;
        cells.x1 = x + TILE > cells.x1 ? x + TILE : cells.x1;
        cells.y0 = y < cells.y0 ? y : cells.y0;
        cells.y1 = y + TILE > cells.y1 ? y + TILE : cells.y1;
    }
    restore(&restoring, rectangle_clip(cells, history->width, history->height));
    history_drop_group(history, group);
    group->state = GROUP_DONE;
    group->last = restoring.now;
    history_count_marks(history, group->id, true);
}

/* ---- the time brush */

static float cover_of(const struct restoring *restoring, float x, float y)
{
    float best = 0.0f;
    for (int i = 0; i < restoring->mark_count; i++) {
        const struct mark *mark = &restoring->marks[i];
        float t = -mark_distance(mark, x, y) / (0.5f * mark->radius);
        t = t < 0.0f ? 0.0f : t > 1.0f ? 1.0f : t;
        t = t * t * (3.0f - 2.0f * t);
        best = t > best ? t : best;
    }
    return best;
}

/* How much further back a cell goes now, 0..1 of the brush's depth: once a pass, by the most that covers it. */
static float pass_over(struct lost *lost, uint16_t tick, float cover)
{
    bool same = lost->cover > 0 && (uint16_t)(tick - lost->pass) < PASS_TICKS;
    float had = same ? (float)lost->cover * (1.0f / 255) : 0.0f;
    if (cover <= had) {
        return 0.0f;
    }
    lost->pass = same ? lost->pass : tick;
    lost->cover = (uint8_t)(cover * 255.0f);
    return cover - had;
}

/* The moment whose version a cell is to be like, and how much of it. `wanted` counts back from now; the time that a
 * cell has lost does not count, and what was kept in that time is not looked at. */
static void aim(const struct restoring *restoring, int tile, const struct lost *lost, uint32_t wanted, uint32_t *target,
                float *share)
{
    const struct past *past = restoring->history->past;
    uint32_t now = restoring->now, gap = wanted < lost->until ? lost->until - lost->from : 0;
    *target = wanted > gap ? wanted - gap : 0;
    *share = 1.0f;
    if (gap > 0) {
        return;
    }
    uint32_t version = past_find(past, tile, wanted), moment = version == PAST_NONE ? 0 : past_moment(past, version);
    bool idle = version != PAST_NONE && past_next(past, version) == PAST_NONE;
    if (moment > lost->from && moment <= lost->until) {
        *target = lost->from;
        *share = (float)(now - wanted) / (float)(now - lost->until);
    } else if (idle && wanted > moment) { /* between the newest version and now */
        *share = (float)(now - wanted) / (float)(now - moment);
    }
}

static void plan_rewind(struct restoring *restoring, int tile, struct plan *plan)
{
    struct history *history = restoring->history;
    uint16_t tick = (uint16_t)(restoring->now / MOMENTS);
    plan->any = false;
    if (past_newest(history->past, tile) == PAST_NONE) {
        return;
    }
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        struct lost *lost = lost_of(history, tile, cell);
        plan->share[cell] = 0.0f;
        plan->ground[cell] = 0;
        if (!lost) {
            continue;
        }
        float cover = cover_of(restoring, (float)(x_of(history, tile) + cell % TILE) + 0.5f,
                               (float)(y_of(history, tile) + cell / TILE) + 0.5f);
        uint32_t depth = (uint32_t)(pass_over(lost, tick, cover) * restoring->depth);
        if (depth >= MOMENTS) {
            uint32_t target = restoring->now > depth ? restoring->now - depth : 0;
            aim(restoring, tile, lost, target, &plan->target[cell], &plan->share[cell]);
            plan->ground[cell] = 1;
            plan->any = true;
        }
    }
}

/* How far a cell has gone from a version to the next at the moment that it wants. What changes between the two did so
 * in the last round, as far as is known. */
static float between(const struct history *history, const struct lost *lost, uint32_t version, uint32_t next,
                     uint32_t target)
{
    uint32_t from = past_moment(history->past, version), to = past_moment(history->past, next);
    uint32_t most = 2 * (uint32_t)history->def.interval * MOMENTS;
    from = to - from > most ? to - most : from;
    if (target <= from || (to > lost->from && to <= lost->until)) {
        return 0.0f;
    }
    return (float)(target - from) / (float)(to - from);
}

static void add_version(const struct history *history, uint32_t version, const float weight[TILE_CELLS],
                        struct tile_values *sum)
{
    struct tile_code code;
    struct tile_values values;
    past_read(history->past, version, &code);
    tile_code_values(&code, &values);
    for (int plane = 0; plane < CODE_STATE; plane++) {
        for (int cell = 0; cell < TILE_CELLS; cell++) {
            sum->planes[plane][cell] += weight[cell] * values.planes[plane][cell];
        }
    }
}

static void apply_rewind(struct restoring *restoring, int tile, struct plan *plan)
{
    struct history *history = restoring->history;
    struct tile_values sum = {0};
    struct tile_code ground;
    float weight[TILE_CELLS], carry[TILE_CELLS] = {0};
    uint8_t chosen[TILE_CELLS];
    uint32_t least = restoring->now;
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        least = plan->share[cell] > 0.0f && plan->target[cell] < least ? plan->target[cell] : least;
    }
    uint32_t version = past_find(history->past, tile, least), first = version;
    if (version == PAST_NONE) {
        return;
    }
    for (uint32_t next; version != PAST_NONE; version = next) {
        bool any = false;
        next = past_next(history->past, version);
        past_read(history->past, version, &ground);
        for (int cell = 0; cell < TILE_CELLS; cell++) {
            uint32_t target = plan->target[cell];
            bool here = plan->share[cell] > 0.0f &&
                        (version == first || target >= past_moment(history->past, version)) &&
                        (next == PAST_NONE || target < past_moment(history->past, next));
            float goes_on = here && next != PAST_NONE
                                ? between(history, lost_of(history, tile, cell), version, next, target)
                                : 0.0f;
            weight[cell] = carry[cell] + (here ? 1.0f - goes_on : 0.0f);
            carry[cell] = goes_on;
            chosen[cell] = here;
            any = any || weight[cell] > 0.0f;
        }
        if (any) {
            add_version(history, version, weight, &sum);
            tile_code_give_ground(&ground, chosen, &history->patch, x_of(history, tile), y_of(history, tile));
        }
    }
    tile_values_blend(&sum, plan->share, &history->patch, x_of(history, tile), y_of(history, tile));
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        struct lost *lost = lost_of(history, tile, cell);
        if (lost && plan->share[cell] > 0.0f) {
            lost->from = plan->target[cell];
            lost->until = restoring->now;
        }
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
    restore(&restoring, history_around(history, marks, count, 0.0f));
}
