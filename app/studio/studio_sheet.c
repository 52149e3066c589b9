#include "studio_sheet.h"

#include <math.h>
#include <string.h>

#include "painting_gpu.h"
#include "script_sheet.h"
#include "studio_tell.h"

static int scaled(int cells, float scale, int least)
{
    int count = (int)lroundf((float)cells * scale);
    return count > least ? count : least;
}

/* The painting of the script on a grid of this share of its cells. */
static struct painting_def painting_at(const struct studio *studio, float scale)
{
    struct painting_def def = script_painting(studio->script);
    def.width = scaled(def.width, scale, CANVAS_SIZE_MIN);
    def.height = scaled(def.height, scale, CANVAS_SIZE_MIN);
    def.margin = scaled(def.margin, scale, 0);
    def.seed += (uint32_t)(studio->report.sessions > 0 ? studio->report.sessions - 1 : 0);
    def.threads = studio->def.threads;
    return def;
}

struct engine *studio_make_engine(struct studio *studio, const struct painting_def *def)
{
    struct shader_error error;
    struct engine *engine;
    if (studio->def.engine == ENGINE_CPU) {
        engine = engine_cpu_create(def);
        snprintf(error.text, sizeof error.text, "memory is short for a sheet of %dx%d cells", def->width, def->height);
    } else {
        engine = engine_gpu_create(def, studio->def.folder, &error);
    }
    if (!engine) {
        snprintf(studio->error.text, sizeof studio->error.text, "engine %s: %s", engine_kind_name(studio->def.engine),
                 error.text);
    }
    return engine;
}

void studio_set_trouble(struct studio *studio, const char *text)
{
    pthread_mutex_lock(&studio->lock);
    snprintf(studio->report.trouble, sizeof studio->report.trouble, "%.190s", text);
    pthread_mutex_unlock(&studio->lock);
}

/* Nothing is taken back from another sheet. Without memory for a history there is no undo, and all else goes on. */
static void fit_history(struct studio *studio, const struct painting_def *def)
{
    if (studio->history && history_fits(studio->history, def)) {
        history_forget(studio->history);
        return;
    }
    history_destroy(studio->history);
    studio->history = history_create(&studio->def.history, def);
}

/* Room for checkpoints of the engine's sheet, and for its history; forgets the old. */
static bool fit(struct studio *studio, const struct painting_def *def)
{
    checkpoint_finish(&studio->whole);
    checkpoint_finish(&studio->partial);
    studio->has_whole = studio->taking = false;
    studio->journal_count = studio->journal_kept = 0;
    fit_history(studio, def);
    return studio->def.engine != ENGINE_GPU ||
           (checkpoint_init(&studio->whole, def) && checkpoint_init(&studio->partial, def));
}

bool studio_begin_session(struct studio *studio)
{
    pthread_mutex_lock(&studio->lock);
    studio->report.sessions++;
    studio->report.ticks = 0; /* of the new one, for whoever asks meanwhile */
    pthread_mutex_unlock(&studio->lock);
    struct painting_def def = painting_at(studio, studio->report.scale);
    struct engine *next = studio_make_engine(studio, &def);
    if (!next || !fit(studio, &def)) {
        engine_destroy(next);
        return false;
    }
    engine_destroy(studio->engine);
    studio->engine = next;
    studio->next_action = 0;
    studio->rest_ticks = 0;
    studio->session_start = 0;
    studio->changed_since = true;
    studio_tell(studio, STUDIO_SHEET);
    return true;
}

/* Actions of the script from now on: those before this tick have happened. */
static void find_next_action(struct studio *studio, int64_t tick)
{
    const struct script *script = studio->script;
    studio->next_action = 0;
    while (studio->next_action < script->action_count && script->actions[studio->next_action].tick < tick) {
        studio->next_action++;
    }
}

bool studio_take_up(struct studio *studio)
{
    const struct checkpoint *from = studio->def.from;
    struct painting_def def = from->def;
    def.threads = studio->def.threads;
    studio->engine = studio_make_engine(studio, &def);
    if (!studio->engine || !fit(studio, &def) || !studio->engine->ops->load(studio->engine, from)) {
        snprintf(studio->error.text, sizeof studio->error.text, "the painting cannot be taken up again");
        return false;
    }
    pthread_mutex_lock(&studio->lock);
    studio->report.sessions++;
    studio->report.scale = studio->scale = (float)def.width / (float)studio->script->width;
    pthread_mutex_unlock(&studio->lock);
    studio->ticked = studio->def.from_ticked;
    studio->changed_since = true;
    find_next_action(studio, from->tick);
    studio_tell(studio, STUDIO_RESTORED);
    return true;
}

/* The painting as it is, on the sheet of this definition, whose seed it takes. */
static bool carry_over(struct studio *studio, const struct painting_def *def)
{
    struct painting_def now = studio->engine->ops->get_def(studio->engine);
    struct checkpoint from = {0}, to = {0};
    struct engine *next = NULL;
    bool same = now.width == def->width && now.height == def->height && now.margin == def->margin;
    if (same && now.seed == def->seed) {
        fit_history(studio, def); /* what was under the old script is not to come back, here as elsewhere */
        return true;
    }
    bool good = checkpoint_init(&from, &now) && studio->engine->ops->save(studio->engine, &from);
    struct checkpoint *taken = same ? &from : &to;
    if (good && !same) {
        good = checkpoint_init(&to, def) && checkpoint_resample(&from, &to);
        next = good ? studio_make_engine(studio, &to.def) : NULL;
    }
    taken->def.seed = def->seed;
    if (good) {
        taken->ground->def.seed = def->seed;
        good = (same || next) && fit(studio, def);
        struct engine *engine = same ? studio->engine : next;
        good = good && engine->ops->load(engine, taken);
    }
    if (good && !same) {
        engine_destroy(studio->engine);
        studio->engine = next;
    } else {
        engine_destroy(next);
    }
    studio->changed_since = true;
    checkpoint_finish(&from);
    checkpoint_finish(&to);
    return good;
}

void studio_change_scale(struct studio *studio, float scale)
{
    struct painting_def def = painting_at(studio, scale);
    def.seed = studio->engine->ops->get_def(studio->engine).seed;
    bool good = carry_over(studio, &def);
    if (good) {
        studio_tell(studio, STUDIO_GRID);
    } else {
        studio_set_trouble(studio, "the grid cannot be changed: memory is short");
    }
    pthread_mutex_lock(&studio->lock);
    studio->report.scale = good ? scale : studio->report.scale;
    studio->scale = studio->report.scale;
    pthread_mutex_unlock(&studio->lock);
}

static float number_of(const struct coefficients *coefficients, const struct key *key)
{
    const char *at = (const char *)coefficients + key->offset;
    float number;
    int whole;
    if (key->type == KEY_NUMBER) {
        memcpy(&number, at, sizeof number);
        return number;
    }
    memcpy(&whole, at, sizeof whole);
    return (float)whole;
}

/* A coefficient that has not changed is left alone: brushes may have stamped others. */
static void set_coefficients(struct studio *studio, const struct coefficients *before, const struct coefficients *now)
{
    for (int i = 0; coefficient_keys[i].name; i++) {
        float value = number_of(now, &coefficient_keys[i]), old = number_of(before, &coefficient_keys[i]);
        if (value < old || value > old) {
            struct action set = action_default(ACTION_SET);
            set.coefficient = i;
            set.value = value;
            set.visitor = HISTORY_SCRIPT;
            studio_tell_action(studio, &set);
            studio->engine->ops->act(studio->engine, &set);
        }
    }
}

void studio_take_script(struct studio *studio, const struct script *script)
{
    /* A copy: as soon as the new script is seen here, the old one may be destroyed. */
    const struct coefficients before = studio->script->coefficients;
    int64_t tick = studio->engine->ops->ticks(studio->engine) - studio->session_start;
    pthread_mutex_lock(&studio->lock);
    studio->script = script;
    pthread_mutex_unlock(&studio->lock);
    struct painting_def def = painting_at(studio, studio->report.scale);
    if (carry_over(studio, &def)) {
        studio_tell(studio, STUDIO_SCENE);
    } else {
        studio_set_trouble(studio, "the canvas cannot be changed: memory is short");
    }
    set_coefficients(studio, &before, &script->coefficients);
    find_next_action(studio, tick);
}
