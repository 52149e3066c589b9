#include "running.h"

#include "history.h"
#include "script_sheet.h"

static bool goes_back(const struct script *script)
{
    bool back = false;
    for (int i = 0; i < script->action_count; i++) {
        back = back || action_goes_back(script->actions[i].verb);
    }
    return back;
}

static bool open_history(struct running *running)
{
    struct painting_def painting = running->engine->ops->get_def(running->engine);
    struct history_def def = history_default_def();
    bool wanted = goes_back(running->script);
    running->history = wanted ? history_create(&def, &painting) : NULL;
    return running->history || !wanted;
}

static bool open_plot(struct running *running)
{
    const struct script *script = running->script;
    bool wanted = plot_wanted(script);
    running->plot = wanted ? plot_create(script->width, script->height) : NULL;
    return running->plot || !wanted;
}

bool running_open(struct running *running, const struct script *script, const struct easel_def *def,
                  struct file_error *error)
{
    struct painting_def painting = script_painting(script);
    *running = (struct running){.script = script, .easel.def = *def};
    running->engine = easel_engine(&running->easel, &painting, error);
    return running->engine &&
           (open_history(running) || file_fail(error, "the painting", "memory is short for what is taken back")) &&
           (open_plot(running) || file_fail(error, "the painting", "memory is short for what grows over it"));
}

void running_close(struct running *running)
{
    history_destroy(running->history);
    plot_destroy(running->plot);
    engine_destroy(running->engine);
    easel_close(&running->easel);
    *running = (struct running){.script = NULL};
}

void running_act(struct running *running, int64_t tick,
                 void (*told)(void *data, int64_t tick, const struct action *action), void *data)
{
    const struct script *script = running->script;
    for (; running->next < script->action_count && script->actions[running->next].tick <= tick; running->next++) {
        const struct action *action = &script->actions[running->next];
        if (running->history) {
            history_act(running->history, running->engine, action);
        } else {
            running->engine->ops->act(running->engine, action);
        }
        if (running->plot) {
            plot_act(running->plot, tick, action);
        }
        if (told) {
            told(data, tick, action);
        }
    }
}

bool running_plot(struct running *running, int64_t tick, struct file_error *error)
{
    return !running->plot || plot_tick(running->plot, tick) ||
           file_fail(error, "the painting", "memory is short for what grows over it");
}

void running_tick(struct running *running)
{
    if (running->history) {
        history_tick(running->history, running->engine);
    }
    running->engine->ops->tick(running->engine);
}
