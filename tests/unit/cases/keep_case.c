#include "keep_case.h"

#include <stdlib.h>
#include <string.h>

#include "painting.h"
#include "script.h"
#include "script_sheet.h"

static const char SCRIPT[] = "frond: 1\n"
                             "canvas: {width: 160, height: 100}\n"
                             "seed: 11\n"
                             "inks: [turquoise, ochre, magenta]\n";

static void tell(struct keep_case *one, struct studio_event event)
{
    event.ticked = one->ticked;
    event.script = one->script;
    event.engine = one->engine;
    event.def = one->engine->ops->get_def(one->engine);
    event.history = history_default_def();
    if (one->keep) {
        keep_tell(one->keep, &event);
    }
}

static bool open_engine(struct keep_case *one, const struct painting_def *from)
{
    struct painting_def def = from ? *from : script_painting(one->script);
    def.threads = 1;
    engine_destroy(one->engine);
    one->engine = engine_cpu_create(&def);
    return one->engine;
}

bool keep_case_open(struct keep_case *one, struct keep *keep, const struct keep_found *found)
{
    struct script_def def = script_default_def();
    struct report report;
    *one = (struct keep_case){.keep = keep};
    report_init(&report, "keep");
    one->script = script_parse(SCRIPT, strlen(SCRIPT), ".", &def, &report);
    report_finish(&report);
    if (!one->script || !open_engine(one, found ? &found->checkpoint.def : NULL)) {
        return false;
    }
    if (found) {
        one->ticked = found->ticked;
        bool loaded = one->engine->ops->load(one->engine, &found->checkpoint);
        tell(one, (struct studio_event){.kind = STUDIO_RESTORED});
        return loaded;
    }
    tell(one, (struct studio_event){.kind = STUDIO_SHEET});
    return true;
}

void keep_case_close(struct keep_case *one)
{
    engine_destroy(one->engine);
    script_destroy(one->script);
    *one = (struct keep_case){.keep = NULL};
}

static void act(struct keep_case *one, const struct action *action)
{
    tell(one, (struct studio_event){.kind = STUDIO_ACTION, .action = action});
    one->engine->ops->act(one->engine, action);
}

/* A drop now and then, a stroke between them. Nothing ever comes to rest. */
static void happen(struct keep_case *one, int64_t tick)
{
    uint32_t dice = (uint32_t)tick * 2654435761u;
    struct point path[] = {{(float)(dice >> 8 & 255) / 255, (float)(dice >> 16 & 255) / 255}, {0.5f, 0.5f}};
    if (tick % 24 == 3) {
        struct action drop = action_default(ACTION_DROP);
        drop.at = path[0];
        drop.has_at = true;
        drop.ink = (int)(dice >> 24) % 3;
        drop.brush = (int)(tick / 24) % 4 - 1;
        act(one, &drop);
    } else if (tick % 24 == 15) {
        struct action stroke = action_default(tick % 48 == 15 ? ACTION_BRUSH_SOLVENT : ACTION_POUR);
        stroke.path = (struct action_path){path, stroke.verb == ACTION_POUR ? 0 : 2};
        stroke.at = path[0];
        stroke.has_at = true;
        stroke.radius = 9;
        act(one, &stroke);
    }
}

void keep_case_tick(struct keep_case *one)
{
    if (!one->acted) {
        happen(one, one->engine->ops->ticks(one->engine));
    }
    one->acted = false;
    one->engine->ops->tick(one->engine);
    one->ticked++;
    tell(one, (struct studio_event){.kind = STUDIO_TICKED, .busy_s = 1e-3});
}

void keep_case_fresh(struct keep_case *one)
{
    open_engine(one, NULL);
    tell(one, (struct studio_event){.kind = STUDIO_SHEET});
}

uint64_t keep_case_hash(const struct keep_case *one)
{
    return painting_hash(engine_cpu_painting(one->engine));
}

bool keep_case_paint(struct keep_case_table *table)
{
    struct keep_case one;
    if (table->painted) {
        return true;
    }
    if (!keep_case_open(&one, NULL, NULL)) {
        return false;
    }
    for (int tick = 0; tick < KEEP_CASE_TICKS; tick++) {
        table->before[tick] = keep_case_hash(&one);
        happen(&one, tick);
        one.acted = true;
        table->after[tick] = keep_case_hash(&one);
        keep_case_tick(&one);
    }
    keep_case_close(&one);
    table->painted = true;
    return true;
}

bool keep_case_is_right(struct keep_case *one, const struct keep_case_table *table)
{
    int64_t tick = one->engine->ops->ticks(one->engine);
    uint64_t hash = keep_case_hash(one);
    if (tick >= KEEP_CASE_TICKS) {
        return false;
    }
    one->acted = hash != table->before[tick];
    return !one->acted || hash == table->after[tick];
}
