#include "player.h"

#include "checkpoint.h"

static const char NAME[] = "the journal";

/* The first pass: how long it is, and whether there is anything in it. */
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
    }
    player->last = reader.ticked;
    journal_close(&reader);
    return sheet || file_fail(error, NAME, "there is no sheet in it");
}

struct engine *player_carry(struct easel *easel, struct engine *engine, const struct painting_def *def,
                            bool coefficients, struct file_error *error)
{
    struct painting_def now = engine->ops->get_def(engine), then = *def;
    struct checkpoint from = {.planes = NULL}, to = {.planes = NULL};
    struct engine *next = NULL;
    if (!coefficients) {
        then.seed = now.seed;
        then.coefficients = now.coefficients;
    }
    bool good = checkpoint_init(&from, &now) && checkpoint_init(&to, &then) && engine->ops->save(engine, &from) &&
                checkpoint_resample(&from, &to);
    if (good) {
        next = easel_engine(easel, &then, error);
        good = next && next->ops->load(next, &to);
    } else {
        file_fail(error, NAME, "memory is short for another grid");
    }
    if (!good) {
        engine_destroy(next);
        next = NULL;
    } else {
        engine_destroy(engine);
    }
    checkpoint_finish(&from);
    checkpoint_finish(&to);
    return next;
}

static bool take_sheet(struct player *player, const struct journal_sheet *sheet, struct file_error *error)
{
    struct engine *next = easel_engine(player->easel, &sheet->def, error);
    if (!next) {
        return false;
    }
    engine_destroy(player->engine);
    player->engine = next;
    player->sheet = *sheet;
    player->sheets++;
    return true;
}

/* The painting as it is on another sheet. */
static bool carry(struct player *player, const struct painting_def *def, bool coefficients, struct file_error *error)
{
    struct engine *next = player_carry(player->easel, player->engine, def, coefficients, error);
    if (next) {
        player->engine = next;
        player->sheet.def = next->ops->get_def(next);
    }
    return next;
}

static bool take_scene(struct player *player, const struct journal_sheet *scene, struct file_error *error)
{
    player->sheet = *scene;
    return carry(player, &scene->def, true, error);
}

static bool take_grid(struct player *player, const struct journal_record *record, struct file_error *error)
{
    struct painting_def def = player->sheet.def;
    def.width = record->grid.width;
    def.height = record->grid.height;
    def.margin = record->grid.margin;
    return carry(player, &def, false, error);
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
        player->engine->ops->act(player->engine, &record->action);
        player->actions++;
        return true;
    default:
        return true;
    }
}

bool player_open(struct player *player, const void *data, size_t size, struct easel *easel, struct file_error *error)
{
    struct journal_error reason;
    *player = (struct player){.easel = easel};
    if (!measure(player, data, size, error)) {
        return false;
    }
    if (!journal_open(&player->reader, data, size, &reason)) {
        return file_fail(error, NAME, "%s", reason.text);
    }
    player->has_next = journal_next(&player->reader, &player->next);
    return true;
}

bool player_tick(struct player *player, struct file_error *error)
{
    error->text[0] = '\0';
    while (player->has_next && player->next.ticked <= player->ticked) {
        if (!take(player, &player->next, error)) {
            return false;
        }
        player->has_next = journal_next(&player->reader, &player->next);
    }
    if (player->ticked >= player->last || !player->engine) {
        return false;
    }
    player->engine->ops->tick(player->engine);
    player->ticked++;
    return true;
}

void player_close(struct player *player)
{
    journal_close(&player->reader);
    engine_destroy(player->engine);
    player->engine = NULL;
}
