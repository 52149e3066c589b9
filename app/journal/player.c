#include "player.h"

#include <string.h>

#include "checkpoint.h"

static const char NAME[] = "the journal";

static struct engine *make_cpu(void *data, const struct painting_def *def, struct file_error *error)
{
    const int *threads = data;
    struct painting_def own = *def;
    own.threads = *threads;
    struct engine *engine = engine_cpu_create(&own);
    if (!engine) {
        file_fail(error, NAME, "memory is short for %dx%d cells", def->width, def->height);
    }
    return engine;
}

struct player_maker player_cpu(const int *threads)
{
    return (struct player_maker){.make = make_cpu, .data = (void *)(uintptr_t)threads};
}

static struct engine *make(struct player *player, const struct painting_def *def, struct file_error *error)
{
    return player->maker.make(player->maker.data, def, error);
}

static void read_next(struct player *player)
{
    player->done = journal_place_of(&player->reader);
    player->has_next = journal_next(&player->reader, &player->next);
    if (!player->has_next) {
        player->done = journal_place_of(&player->reader);
    }
}

/* The first pass: how long it is, and what there is in it. */
static bool measure(struct player *player, const void *data, size_t size, struct file_error *error)
{
    struct journal_reader reader;
    struct journal_record record;
    struct journal_error reason;
    if (!journal_open(&reader, data, size, &reason)) {
        return file_fail(error, NAME, "%s", reason.text);
    }
    bool sheet = journal_next(&reader, &record) && record.kind == JOURNAL_SHEET;
    while (journal_next(&reader, &record)) {
        bool action = record.kind == JOURNAL_ACTION;
        player->goes_back = player->goes_back || (action && action_goes_back(record.action.verb));
        player->grows =
            player->grows || (action && player->maker.grows && scene_kind_of(record.action.verb) != SCENE_PAINTING);
    }
    player->last = reader.ticked;
    journal_close(&reader);
    return sheet || file_fail(error, NAME, "there is no sheet in it");
}

/* What undo goes back to begins anew; where nothing in the journal goes back, there is none. */
static bool fit_history(struct player *player, struct file_error *error)
{
    struct painting_def def = player->engine->ops->get_def(player->engine);
    history_destroy(player->history);
    player->history = NULL;
    if (!player->goes_back || player->resumed || player->sheet.history.bytes == 0) {
        return true;
    }
    player->history = history_create(&player->sheet.history, &def);
    return player->history || file_fail(error, NAME, "memory is short for what is taken back");
}

/* What grows over the painting lies on its sheet. */
static bool fit_plot(struct player *player, const struct painting_def *def, bool fresh, struct file_error *error)
{
    if (!player->grows) {
        return true;
    }
    bool good = true;
    if (player->plot) {
        good = plot_sheet(player->plot, def->width, def->height, fresh);
    } else {
        player->plot = plot_create(def->width, def->height);
    }
    return (player->plot && good) || file_fail(error, NAME, "memory is short for what grows over it");
}

static bool take_sheet(struct player *player, const struct journal_sheet *sheet, struct file_error *error)
{
    struct engine *next = make(player, &sheet->def, error);
    if (!next) {
        return false;
    }
    engine_destroy(player->engine);
    player->engine = next;
    player->sheet = *sheet;
    player->sheets++;
    return fit_history(player, error) && fit_plot(player, &sheet->def, true, error);
}

/* The painting on the sheet of this definition, whose seed it takes; its coefficients stay. As the studio does it. */
static struct engine *carry(struct player *player, const struct painting_def *def, struct file_error *error)
{
    struct engine *engine = player->engine, *next = NULL;
    struct painting_def now = engine->ops->get_def(engine);
    struct checkpoint from = {.planes = NULL}, to = {.planes = NULL};
    bool same = now.width == def->width && now.height == def->height && now.margin == def->margin;
    struct checkpoint *taken = same ? &from : &to;
    bool good = checkpoint_init(&from, &now) && engine->ops->save(engine, &from) &&
                (same || (checkpoint_init(&to, def) && checkpoint_resample(&from, &to)));
    if (good) {
        taken->def.seed = taken->ground->def.seed = def->seed;
        next = same ? engine : make(player, &to.def, error);
        good = next && next->ops->load(next, taken);
    } else {
        file_fail(error, NAME, "memory is short for another grid");
    }
    checkpoint_finish(&from);
    checkpoint_finish(&to);
    if (!good && next != engine) {
        engine_destroy(next);
    }
    return good ? next : NULL;
}

static bool take_canvas(struct player *player, const struct painting_def *def, bool fresh, struct file_error *error)
{
    struct engine *next = carry(player, def, error);
    if (!next) {
        return false;
    }
    if (next != player->engine) {
        engine_destroy(player->engine);
    }
    player->engine = next;
    player->sheet.def = next->ops->get_def(next);
    return fit_history(player, error) && fit_plot(player, &player->sheet.def, fresh, error);
}

static bool take_scene(struct player *player, const struct journal_sheet *scene, struct file_error *error)
{
    bool other = strcmp(player->sheet.scene, scene->scene) != 0; /* as live_scene.h: what grew in it is gone */
    player->sheet = *scene;
    return take_canvas(player, &scene->def, other, error);
}

static bool take_grid(struct player *player, const struct journal_record *record, struct file_error *error)
{
    struct painting_def def = player->sheet.def;
    def.width = record->grid.width;
    def.height = record->grid.height;
    def.margin = record->grid.margin;
    return take_canvas(player, &def, false, error);
}

static bool act(struct player *player, const struct action *action)
{
    if (player->history) {
        history_act(player->history, player->engine, action);
    } else if (!action_goes_back(action->verb)) {
        player->engine->ops->act(player->engine, action);
    }
    if (player->plot) {
        plot_act(player->plot, player->next.ticked, action);
    }
    player->actions++;
    return true;
}

static bool take(struct player *player, const struct journal_record *record, struct file_error *error)
{
    switch (record->kind) {
    case JOURNAL_SHEET:
        return take_sheet(player, &record->sheet, error);
    case JOURNAL_SCENE:
        return take_scene(player, &record->sheet, error);
    case JOURNAL_GRID:
        return take_grid(player, record, error);
    case JOURNAL_ACTION:
        return act(player, &record->action);
    case JOURNAL_RESTORED:
        if (player->history) {
            history_forget(player->history);
        }
        return true;
    default:
        return true;
    }
}

bool player_open(struct player *player, const void *data, size_t size, const struct player_maker *maker,
                 struct file_error *error)
{
    struct journal_error reason;
    *player = (struct player){.maker = *maker};
    if (!measure(player, data, size, error)) {
        return false;
    }
    if (!journal_open(&player->reader, data, size, &reason)) {
        return file_fail(error, NAME, "%s", reason.text);
    }
    read_next(player);
    return true;
}

static bool grow(struct player *player, struct file_error *error)
{
    return !player->plot || plot_tick(player->plot, player->ticked) ||
           file_fail(error, NAME, "memory is short for what grows over it");
}

bool player_resume(struct player *player, const void *data, size_t size, const struct player_place *place,
                   const struct player_maker *maker, struct file_error *error)
{
    if (!player_open(player, data, size, maker, error)) {
        return false;
    }
    while (player->has_next && player->reader.records <= place->records) {
        if (player->next.kind == JOURNAL_SHEET || player->next.kind == JOURNAL_SCENE) {
            player->sheet = player->next.sheet;
        }
        read_next(player);
    }
    player->ticked = place->ticked;
    player->resumed = true;
    player->grows = false;
    player->engine = make(player, &place->checkpoint->def, error);
    if (!player->engine) {
        return false;
    }
    player->sheet.def = player->engine->ops->get_def(player->engine);
    return player->engine->ops->load(player->engine, place->checkpoint) ||
           file_fail(error, NAME, "the checkpoint does not fit");
}

bool player_tick(struct player *player, struct file_error *error)
{
    error->text[0] = '\0';
    while (player->has_next && player->next.ticked <= player->ticked) {
        if (player->resumed && player->next.kind == JOURNAL_ACTION && action_goes_back(player->next.action.verb)) {
            return false;
        }
        if (!take(player, &player->next, error)) {
            return false;
        }
        read_next(player);
    }
    if (!grow(player, error) || player->ticked >= player->last || !player->engine) {
        return false;
    }
    if (player->history) {
        history_tick(player->history, player->engine);
    }
    player->engine->ops->tick(player->engine);
    player->ticked++;
    return true;
}

void player_close(struct player *player)
{
    journal_close(&player->reader);
    history_destroy(player->history);
    engine_destroy(player->engine);
    plot_destroy(player->plot);
    player->engine = NULL;
    player->history = NULL;
    player->plot = NULL;
}
