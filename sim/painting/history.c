#include "history.h"

#include <stdlib.h>
#include <string.h>

#include "history_state.h"

enum {
    AROUND = 48,          /* cells around an action that are kept before it */
    MOST_TICKS = 1 << 25, /* that moments can count */
};

struct history_def history_default_def(void)
{
    return (struct history_def){
        .bytes = 96u << 20, .interval = 60, .tiles_a_tick = 64, .age = 7200, .levels = 16, .pause = 60};
}

struct history *history_create(const struct history_def *def, const struct painting_def *painting)
{
    struct history *history = calloc(1, sizeof *history);
    if (!history) {
        return NULL;
    }
    history->def = *def;
    history->painting = *painting;
    history->width = painting->width + 2 * painting->margin;
    history->height = painting->height + 2 * painting->margin;
    history->columns = (history->width + TILE - 1) / TILE;
    history->rows = (history->height + TILE - 1) / TILE;
    int tiles = history->columns * history->rows;
    history->past = past_create(def->bytes, tiles);
    history->plans = calloc((size_t)history->columns, sizeof *history->plans);
    history->lost = calloc((size_t)history->width * (size_t)history->height, sizeof *history->lost);
    history->pending = calloc((size_t)tiles, 1);
    if (!history->past || !history->plans || !history->lost || !history->pending ||
        !patch_init(&history->patch, (size_t)history->width * TILE)) {
        history_destroy(history);
        return NULL;
    }
    history_forget(history);
    return history;
}

void history_destroy(struct history *history)
{
    if (!history) {
        return;
    }
    for (int i = 0; i < HISTORY_GROUPS; i++) {
        free(history->groups[i].taken);
    }
    past_destroy(history->past);
    patch_finish(&history->patch);
    free(history->plans);
    free(history->lost);
    free(history->pending);
    free(history);
}

bool history_fits(const struct history *history, const struct painting_def *painting)
{
    return canvas_is_like(painting_canvas(&history->painting), painting_canvas(painting));
}

void history_forget(struct history *history)
{
    for (int i = 0; i < HISTORY_GROUPS; i++) {
        free(history->groups[i].taken);
        history->groups[i] = (struct group){.state = GROUP_GONE};
    }
    past_clear(history->past);
    memset(history->lost, 0, (size_t)history->width * (size_t)history->height * sizeof *history->lost);
    history->mark_count = 0;
    history->next_group = 1;
    history->moment = 0;
    history->begun = false;
}

/* Everything is to be kept once; then what changes. */
static void follow(struct history *history, struct engine *engine)
{
    int64_t tick = engine->ops->ticks(engine);
    if (history->begun && (tick < history->tick || tick - history->start > MOST_TICKS)) {
        history_forget(history);
    }
    if (!history->begun) {
        int tiles = history->columns * history->rows;
        engine->ops->changed(engine, history->pending);
        memset(history->pending, 1, (size_t)tiles);
        history->cursor = 0;
        history->begun = true;
        history->start = tick;
        history->kept_tick = tick - 1;
        history->next_round = tick + history->def.interval;
    }
    history->tick = tick;
}

uint32_t history_moment(struct history *history)
{
    uint32_t now = (uint32_t)(history->tick - history->start) * MOMENTS + 1;
    history->moment = now > history->moment ? now : history->moment + 1;
    return history->moment;
}

bool history_save_line(struct history *history, struct engine *engine, int line, int first, int last)
{
    struct rectangle cells = {first * TILE, (last + 1) * TILE, line * TILE, (line + 1) * TILE};
    history->patch.cells = rectangle_clip(cells, history->width, history->height);
    return engine->ops->save_patch(engine, &history->patch);
}

static void keep_tile(struct history *history, int column, int line, uint32_t moment, uint32_t group)
{
    struct tile_code code;
    tile_code_take(&code, &history->patch, column * TILE, line * TILE);
    past_keep(history->past, line * history->columns + column, &code, moment, group);
}

/* Keeps the tiles that these cells touch, as far as the group has not kept them; 0: all of them, for nobody. */
static void keep_tiles(struct history *history, struct engine *engine, struct rectangle cells, uint32_t moment,
                       uint32_t group)
{
    int left = cells.x0 / TILE, right = (cells.x1 - 1) / TILE;
    for (int line = cells.y0 / TILE; !rectangle_is_empty(cells) && line * TILE < cells.y1; line++) {
        int first = right + 1, last = left - 1;
        for (int column = left; column <= right; column++) {
            if (!group || past_find_of(history->past, line * history->columns + column, group) == PAST_NONE) {
                first = first < column ? first : column;
                last = column;
            }
        }
        if (first > last || !history_save_line(history, engine, line, first, last)) {
            continue;
        }
        for (int column = first; column <= last; column++) {
            if (!group || past_find_of(history->past, line * history->columns + column, group) == PAST_NONE) {
                keep_tile(history, column, line, moment, group);
            }
        }
    }
}

/* A run of pending tiles in a line, from the cursor on; the number kept. */
static int keep_run(struct history *history, struct engine *engine, int most, uint32_t moment)
{
    int line = history->cursor / history->columns, first = history->cursor % history->columns, last = first;
    const uint8_t *pending = history->pending + (size_t)line * (size_t)history->columns;
    while (last + 1 < history->columns && last + 1 - first < most && pending[last + 1]) {
        last++;
    }
    bool good = history_save_line(history, engine, line, first, last);
    for (int column = first; column <= last; column++) {
        if (good) {
            keep_tile(history, column, line, moment, 0);
        }
        history->pending[line * history->columns + column] = 0;
    }
    return last + 1 - first;
}

void history_tick(struct history *history, struct engine *engine)
{
    follow(history, engine);
    if (history->kept_tick == history->tick) {
        return;
    }
    history->kept_tick = history->tick;
    int tiles = history->columns * history->rows, left = history->def.tiles_a_tick;
    if (history->cursor >= tiles && history->tick >= history->next_round) {
        engine->ops->changed(engine, history->pending);
        history->cursor = 0;
        history->next_round = history->tick + history->def.interval;
    }
    uint32_t moment = history_moment(history);
    for (; history->cursor < tiles && left > 0; history->cursor++) {
        if (history->pending[history->cursor]) {
            left -= keep_run(history, engine, left, moment);
        }
    }
    uint32_t age = (uint32_t)history->def.age * MOMENTS;
    past_age(history->past, moment > age ? moment - age : 0);
}

static void paint(struct history *history, struct engine *engine, const struct action *action)
{
    struct mark marks[STROKE_MARKS];
    int count = history_marks_of(history, action, marks);
    if (count == 0) {
        engine->ops->act(engine, action);
        return;
    }
    uint32_t moment = history_moment(history);
    struct group *group = history_group_for(history, action, marks, moment);
    bool rewinds = action->verb == ACTION_REWIND;
    keep_tiles(history, engine, history_around(history, marks, count, rewinds ? 1 : AROUND), moment, group->id);
    history_add_marks(history, group, marks, count);
    if (rewinds) {
        history_rewind(history, engine, marks, count, action->ticks);
    } else {
        engine->ops->act(engine, action);
    }
}

void history_act(struct history *history, struct engine *engine, const struct action *action)
{
    struct action legal = action_legal(action);
    struct group *group;
    follow(history, engine);
    switch (legal.verb) {
    case ACTION_CLEAR:
        history_forget(history);
        engine->ops->act(engine, &legal);
        break;
    case ACTION_UNDO:
        group = history_find(history, legal.visitor, GROUP_DONE);
        if (group) {
            history_undo(history, engine, group);
        }
        break;
    case ACTION_REDO:
        group = history_find(history, legal.visitor, GROUP_UNDONE);
        if (group) {
            history_redo(history, engine, group);
        }
        break;
    default:
        paint(history, engine, &legal);
        break;
    }
}

static uint64_t who_has(const struct history *history, enum group_state state)
{
    uint64_t bits = 0;
    for (int i = 0; i < HISTORY_GROUPS; i++) {
        const struct group *group = &history->groups[i];
        if (history_has(history, group, state) && group->visitor >= 0) {
            bits |= 1 | (group->visitor < 64 ? (uint64_t)1 << group->visitor : 0);
        }
    }
    return bits;
}

uint64_t history_can_undo(const struct history *history)
{
    return who_has(history, GROUP_DONE);
}

uint64_t history_can_redo(const struct history *history)
{
    return who_has(history, GROUP_UNDONE);
}

size_t history_used(const struct history *history)
{
    return past_used(history->past);
}
