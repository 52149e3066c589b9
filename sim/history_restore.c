/* Undo, redo and the time brush: lines of tiles are taken out of the engine, blended with what they were, and put
 * back. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "history_state.h"

#define SOFT_RIM 0.3f /* of its radius, that the time brush fades over */

enum { PASS_TICKS = 12 }; /* the time brush takes a cell back once in so many ticks */

#define SPEED       0.15f /* cells a tick that growth goes on by, about */
#define GROWTH      0.3f  /* cells a tick that it never exceeds */
#define GROWTH_ROOM 8.0f
#define FLOW        0.5f /* cells a tick, and at most, that liquid comes along a pattern */
#define FLOW_ROOM   12.0f
#define FLOW_MOST   160.0f
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
    plan->any = plan->version != PAST_NONE && territory_shares(restoring->territory, x_of(history, tile),
                                                               y_of(history, tile), plan->share, plan->ground);
}

/* Whether undo makes a difference to a cell: where it makes none, redo leaves alone what others have done since. */
static bool differs(const struct tile_code *is, const struct tile_code *was, int cell)
{
    static const int PLANES[] = {CODE_SOLVENT, CODE_INK,     CODE_ACTIVE,  CODE_CATALYST, CODE_CARVED,
                                 CODE_WET,     CODE_WET + 1, CODE_WET + 2, CODE_WET + 3,  CODE_DRY,
                                 CODE_DRY + 1, CODE_DRY + 2, CODE_DRY + 3};
    for (size_t i = 0; i < sizeof PLANES / sizeof PLANES[0]; i++) {
        float a = tile_code_number(is->planes[PLANES[i]][cell]), b = tile_code_number(was->planes[PLANES[i]][cell]);
        if (fabsf(a - b) > 0.01f) {
            return true;
        }
    }
    return false;
}

/* Keeps what undo takes, for redo; `was`: what it puts there. */
static void take(struct restoring *restoring, int tile, const struct plan *plan, const struct tile_code *was)
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
    uint32_t newest = past_newest(past, tile);
    if (newest == PAST_NONE) {
        return;
    }
    struct tile_code is;
    past_read(past, newest, &is);
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        unsigned share = differs(&is, was, cell) ? (unsigned)(plan->share[cell] * 255.0f + 0.5f) : 0;
        shares[cell] = (uint16_t)(share | (plan->ground[cell] ? 256u : 0u));
    }
    uint32_t copy = past_copy(past, newest, shares);
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
    take(restoring, tile, plan, &code);
    give(restoring, tile, plan, &code);
    lose(restoring, tile, plan, moment < restoring->group->begin ? restoring->group->begin : moment);
}

/* Where a version was carved. */
static void carved_then(const struct history *history, uint32_t version, uint8_t carved[TILE_CELLS])
{
    uint16_t active[TILE_CELLS], depth[TILE_CELLS];
    memset(carved, 0, TILE_CELLS);
    if (version != PAST_NONE) {
        past_read_plane(history->past, version, CODE_ACTIVE, active);
        past_read_plane(history->past, version, CODE_CARVED, depth);
        for (int cell = 0; cell < TILE_CELLS; cell++) {
            carved[cell] = tile_code_number(active[cell]) + tile_code_number(depth[cell]) > CARVED;
        }
    }
}

/* A line of tiles of the box: where it was carved, where it is. */
static bool find_carved_line(struct history *history, struct engine *engine, const struct group *group,
                             struct territory *territory, int line)
{
    struct rectangle box = territory->box;
    int width = box.x1 - box.x0;
    if (!history_save_line(history, engine, line, box.x0 / TILE, (box.x1 - 1) / TILE)) {
        return false;
    }
    const float *active = patch_plane(&history->patch, CHECKPOINT_ACTIVE);
    const float *carved = patch_plane(&history->patch, CHECKPOINT_CARVED);
    uint8_t *to = territory->carved + (size_t)(line * TILE - box.y0) * (size_t)width;
    int rows = box.y1 - line * TILE < TILE ? box.y1 - line * TILE : TILE;
    for (int i = 0; i < width * rows; i++) {
        to[i] = active[i] + carved[i] > CARVED ? TERRITORY_IS : 0;
    }
    for (int x = box.x0; x < box.x1; x += TILE) {
        uint8_t was[TILE_CELLS];
        carved_then(history, before(history, group, line * history->columns + x / TILE), was);
        for (int cell = 0; cell < TILE_CELLS; cell++) {
            int column = x - box.x0 + cell % TILE, row = cell / TILE;
            if (was[cell] && column < width && row < rows) {
                to[row * width + column] |= TERRITORY_WAS;
            }
        }
    }
    return true;
}

static bool find_carved(struct history *history, struct engine *engine, const struct group *group,
                        struct territory *territory)
{
    struct rectangle box = territory->box;
    territory->carved = calloc((size_t)(box.x1 - box.x0) * (size_t)(box.y1 - box.y0), 1);
    bool good = territory->carved;
    for (int line = box.y0 / TILE; good && line * TILE < box.y1; line++) {
        good = find_carved_line(history, engine, group, territory, line);
    }
    return good;
}

static int tile_at(const struct history *history, float x, float y)
{
    int column = (int)x < history->width ? (int)x : history->width - 1;
    int row = (int)y < history->height ? (int)y : history->height - 1;
    return row / TILE * history->columns + column / TILE;
}

static bool was_carved(const struct history *history, const struct group *group, const struct mark *mark)
{
    uint8_t carved[TILE_CELLS];
    int tile = tile_at(history, mark->x0, mark->y0);
    int x = (int)mark->x0 - x_of(history, tile), y = (int)mark->y0 - y_of(history, tile);
    carved_then(history, before(history, group, tile), carved);
    return carved[(y < TILE ? y : TILE - 1) * TILE + (x < TILE ? x : TILE - 1)];
}

/* The marks of a group, and those that count against it: what is to be put back does not hold them. For the caller to
 * free. */
static struct mark *sort_marks(const struct history *history, const struct group *group, struct territory *territory)
{
    struct mark *sorted = malloc((size_t)history->mark_count * sizeof *sorted + 1);
    int own = 0, others = history->mark_count;
    for (int i = history->mark_count - 1; sorted && i >= 0; i--) {
        struct mark mark = history->marks[i];
        if (mark.group == group->id) {
            mark.on_pattern = mark.kind == MARK_GROWS && was_carved(history, group, &mark);
            sorted[own++] = mark;
            continue;
        }
        uint32_t version = before(history, group, tile_at(history, mark.x0, mark.y0));
        if (mark.counts && (version == PAST_NONE || mark.moment >= past_moment(history->past, version))) {
            sorted[--others] = mark;
        }
    }
    territory->own = sorted;
    territory->own_count = own;
    territory->others = sorted + others;
    territory->other_count = history->mark_count - others;
    return sorted;
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

static struct territory territory_of(const struct history *history, const struct group *group, uint32_t now)
{
    float ticks = (float)(now / MOMENTS - group->begin / MOMENTS), flow = FLOW_ROOM + FLOW * ticks;
    (void)history;
    return (struct territory){.begin = group->begin,
                              .moments_a_cell = (float)MOMENTS / SPEED,
                              .growth = GROWTH_ROOM + GROWTH * ticks,
                              .flow = flow < FLOW_MOST ? flow : FLOW_MOST};
}

void history_undo(struct history *history, struct engine *engine, struct group *group)
{
    uint32_t now = history_moment(history);
    struct territory territory = territory_of(history, group, now);
    struct mark *sorted = sort_marks(history, group, &territory);
    struct restoring restoring = {.history = history,
                                  .engine = engine,
                                  .group = group,
                                  .now = now,
                                  .territory = &territory,
                                  .keeps = true,
                                  .plan = plan_undo,
                                  .apply = apply_undo};
    if (sorted) {
        territory.box =
            whole_tiles(history, history_around(history, territory.own, territory.own_count, reach_of(&territory)));
        group->taken_count = 0;
        if (!rectangle_is_empty(territory.box) && find_carved(history, engine, group, &territory) &&
            territory_measure(&territory)) {
            restore(&restoring, territory.box);
        }
    }
    group->state = GROUP_UNDONE;
    group->undone = now;
    history_count_marks(history, group->id, false);
    free(sorted);
    territory_finish(&territory);
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
        float t = -mark_distance(mark, x, y) / (SOFT_RIM * mark->radius);
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
            float x = (float)(x_of(history, tile) + cell % TILE), y = (float)(y_of(history, tile) + cell / TILE);
            float cover = cover_of(restoring, x + 0.5f, y + 0.5f);
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
        give(restoring, tile, &part, &code);
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
