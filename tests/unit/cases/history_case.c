#include "history_case.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

struct painting_def sheet_def(void)
{
    struct painting_def def = painting_default_def();
    def.width = WIDTH;
    def.height = HEIGHT;
    def.margin = MARGIN;
    def.threads = 1;
    return def;
}

struct sheet sheet_make_of(const struct painting_def *def, const struct history_def *history)
{
    struct sheet sheet = {.engine = engine_cpu_create(def), .history = history_create(history, def)};
    assert_non_null(sheet.engine);
    assert_non_null(sheet.history);
    assert_true(checkpoint_init(&sheet.before, def) && checkpoint_init(&sheet.after, def));
    return sheet;
}

struct sheet sheet_make(void)
{
    struct painting_def def = sheet_def();
    struct history_def history = history_default_def();
    history.bytes = 8 << 20;
    return sheet_make_of(&def, &history);
}

void sheet_drop(struct sheet *sheet)
{
    checkpoint_finish(&sheet->before);
    checkpoint_finish(&sheet->after);
    history_destroy(sheet->history);
    engine_destroy(sheet->engine);
}

void run(struct sheet *sheet, int ticks)
{
    for (int tick = 0; tick < ticks; tick++) {
        history_tick(sheet->history, sheet->engine);
        sheet->engine->ops->tick(sheet->engine);
    }
}

void act(struct sheet *sheet, const struct action *action)
{
    history_act(sheet->history, sheet->engine, action);
}

void drop(struct sheet *sheet, int visitor, float x, float y)
{
    struct action action = action_default(ACTION_DROP);
    action.visitor = visitor;
    action.at = (struct point){x, y};
    action.ink = visitor & 3;
    action.radius = 6;
    action.solvent = 60;
    act(sheet, &action);
}

void stroke(struct sheet *sheet, enum action_verb verb, int visitor, struct point from, struct point to)
{
    struct point points[2] = {from, to};
    struct action action = action_default(verb);
    action.visitor = visitor;
    action.path = (struct action_path){points, 2};
    act(sheet, &action);
}

void order(struct sheet *sheet, enum action_verb verb, int visitor)
{
    struct action action = action_default(verb);
    action.visitor = visitor;
    act(sheet, &action);
}

void look(struct sheet *sheet, struct checkpoint *checkpoint)
{
    assert_true(sheet->engine->ops->save(sheet->engine, checkpoint));
}

uint64_t hash_of(const struct sheet *sheet)
{
    return painting_hash(engine_cpu_painting(sheet->engine));
}
