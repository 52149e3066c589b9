/* Undo: the territory of a group as it was before; redo: what undo took. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "history_restore.h"

#define SPEED       0.15f /* cells a tick that growth goes on by, about */
#define GROWTH      0.3f  /* cells a tick that it never exceeds */
#define GROWTH_ROOM 8.0f
#define FLOW        0.5f /* cells a tick, and at most, that liquid comes along a pattern */
#define FLOW_ROOM   12.0f
#define FLOW_MOST   160.0f
#define NEVER       0xffffffffu

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
    restoring_give(restoring, tile, plan, &code);
    restoring_lose(restoring, tile, plan, moment < restoring->group->begin ? restoring->group->begin : moment);
}

/* Where a tile was carved before a group. */
static void carved_then(const struct history *history, const struct group *group, int tile, uint8_t carved[TILE_CELLS])
{
    uint32_t version = before(history, group, tile);
    memset(carved, 0, TILE_CELLS);
    if (version != PAST_NONE) {
        struct tile_code code;
        read_mended(history, tile, version, &code);
        for (int cell = 0; cell < TILE_CELLS; cell++) {
            float depth =
                tile_code_number(code.planes[CODE_ACTIVE][cell]) + tile_code_number(code.planes[CODE_CARVED][cell]);
            carved[cell] = depth > CARVED_DEPTH;
        }
    }
}

/* When each cell of a tile was carved, as far as versions since a group tell. `cells`: of the tile in rows of the box,
 * and where those end. */
static void find_since(const struct history *history, const struct group *group, int tile, struct rectangle cells,
                       uint32_t *since)
{
    uint32_t version = before(history, group, tile);
    for (version = version == PAST_NONE ? PAST_NONE : past_next(history->past, version); version != PAST_NONE;
         version = past_next(history->past, version)) {
        uint16_t active[TILE_CELLS], carved[TILE_CELLS];
        past_read_plane(history->past, version, CODE_ACTIVE, active);
        past_read_plane(history->past, version, CODE_CARVED, carved);
        for (int cell = 0; cell < TILE_CELLS; cell++) {
            int x = cells.x0 + cell % TILE, y = cell / TILE;
            float depth = tile_code_number(active[cell]) + tile_code_number(carved[cell]);
            if (x < cells.x1 && y < cells.y1 && depth > CARVED_DEPTH && since[y * cells.x1 + x] == NEVER) {
                since[y * cells.x1 + x] = past_moment(history->past, version);
            }
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
        to[i] = active[i] + carved[i] > CARVED_DEPTH ? TERRITORY_IS : 0;
    }
    uint32_t *since = territory->since + (size_t)(line * TILE - box.y0) * (size_t)width;
    for (int x = box.x0; x < box.x1; x += TILE) {
        uint8_t was[TILE_CELLS];
        int tile = line * history->columns + x / TILE;
        carved_then(history, group, tile, was);
        find_since(history, group, tile, (struct rectangle){x - box.x0, width, 0, rows}, since);
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
    size_t cells = (size_t)(box.x1 - box.x0) * (size_t)(box.y1 - box.y0);
    territory->carved = calloc(cells, 1);
    territory->since = malloc(cells * sizeof *territory->since);
    bool good = territory->carved && territory->since;
    for (size_t i = 0; good && i < cells; i++) {
        territory->since[i] = NEVER;
    }
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
    carved_then(history, group, tile, carved);
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

/* Where others have painted over what is taken back, it is not there to be taken; but should they take theirs back, it
 * is not to come to light. */
static void lose_claimed(struct history *history, const struct territory *territory)
{
    const struct rectangle *box = &territory->box;
    const uint32_t *claimed = territory->claimed;
    for (int y = box->y0; y < box->y1; y++) {
        for (int x = box->x0; x < box->x1; x++, claimed++) {
            if (*claimed > 0) {
                history->lost[(size_t)y * (size_t)history->width + (size_t)x] =
                    (struct lost){.from = territory->begin, .until = *claimed};
            }
        }
    }
}

static struct territory territory_of(const struct group *group, uint32_t now)
{
    uint32_t passed = now / MOMENTS - group->begin / MOMENTS;
    float ticks = (float)passed, flow = FLOW_ROOM + FLOW * ticks;
    return (struct territory){.begin = group->begin,
                              .moments_a_cell = (float)MOMENTS / SPEED,
                              .growth = GROWTH_ROOM + GROWTH * ticks,
                              .flow = flow < FLOW_MOST ? flow : FLOW_MOST};
}

void history_undo(struct history *history, struct engine *engine, struct group *group)
{
    uint32_t now = history_moment(history);
    struct territory territory = territory_of(group, now);
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
            restoring_run(&restoring, territory.box);
            lose_claimed(history, &territory);
        }
    }
    group->state = GROUP_UNDONE;
    group->undone = now;
    history_count_marks(history, group->id, false);
    free(sorted);
    territory_finish(&territory);
}

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
    restoring_give(restoring, tile, plan, &code);
    restoring_lose(restoring, tile, plan, restoring->group->undone);
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
    restoring_run(&restoring, rectangle_clip(cells, history->width, history->height));
    history_drop_group(history, group);
    group->state = GROUP_DONE;
    group->last = restoring.now;
    history_count_marks(history, group->id, true);
}
