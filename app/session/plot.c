#include "plot.h"

#include <stdlib.h>

#include "script.h"

struct plot {
    int width, height;
    bool failed; /* memory was short for a scene */
    void *scenes[SCENE_KINDS];
};

bool plot_wanted(const struct script *script)
{
    bool wanted = false;
    for (int i = 0; i < script->action_count; i++) {
        wanted = wanted || scene_kind_of(script->actions[i].verb) != SCENE_PAINTING;
    }
    return wanted;
}

struct plot *plot_create(int width, int height)
{
    struct plot *plot = calloc(1, sizeof *plot);
    if (plot) {
        plot->width = width;
        plot->height = height;
    }
    return plot;
}

static void take_away(struct plot *plot)
{
    for (int kind = 0; kind < SCENE_KINDS; kind++) {
        if (plot->scenes[kind]) {
            scene_types[kind]->destroy(plot->scenes[kind]);
            plot->scenes[kind] = NULL;
        }
    }
}

void plot_destroy(struct plot *plot)
{
    if (plot) {
        take_away(plot);
        free(plot);
    }
}

void plot_act(struct plot *plot, int64_t ticked, const struct action *action)
{
    enum scene_kind own = scene_kind_of(action->verb);
    if (own != SCENE_PAINTING && !plot->scenes[own]) {
        plot->scenes[own] = scene_types[own]->create(plot->width, plot->height);
        plot->failed = plot->failed || !plot->scenes[own];
    }
    for (int kind = 0; kind < SCENE_KINDS; kind++) {
        if (plot->scenes[kind]) {
            scene_types[kind]->act(plot->scenes[kind], ticked, action);
        }
    }
}

bool plot_sheet(struct plot *plot, int width, int height, bool fresh)
{
    plot->width = width;
    plot->height = height;
    if (fresh) {
        take_away(plot);
    }
    for (int kind = 0; kind < SCENE_KINDS; kind++) {
        if (plot->scenes[kind]) {
            scene_types[kind]->resize(plot->scenes[kind], width, height);
        }
    }
    return true;
}

bool plot_tick(struct plot *plot, int64_t ticked)
{
    bool good = !plot->failed;
    for (int kind = 0; kind < SCENE_KINDS && good; kind++) {
        good = !plot->scenes[kind] || scene_types[kind]->tick(plot->scenes[kind], ticked);
    }
    return good;
}

bool plot_lay(struct plot *plot, int64_t ticked, int width, int height, uint8_t *rgb)
{
    bool good = true;
    for (int kind = SCENE_KINDS - 1; kind >= 0 && good; kind--) { /* a dish covers most: it lies below */
        good = !plot->scenes[kind] || scene_types[kind]->lay(plot->scenes[kind], ticked, width, height, rgb);
    }
    return good;
}

void *plot_scene(const struct plot *plot, enum scene_kind kind)
{
    return plot->scenes[kind];
}
