#include "plot.h"

#include <stdlib.h>

#include "script.h"

struct plot {
    struct garden *garden;
    struct plate plate; /* of the last picture's size */
    bool painted;       /* it is as the garden is now */
};

bool plot_wanted(const struct script *script)
{
    bool wanted = false;
    for (int i = 0; i < script->action_count; i++) {
        wanted = wanted || garden_takes(script->actions[i].verb);
    }
    return wanted;
}

struct plot *plot_create(int width, int height)
{
    struct plot *plot = calloc(1, sizeof *plot);
    struct garden_def def = garden_default_def();
    def.width = width;
    def.height = height;
    if (plot) {
        plot->garden = garden_create(&def);
    }
    if (plot && !plot->garden) {
        free(plot);
        plot = NULL;
    }
    return plot;
}

void plot_destroy(struct plot *plot)
{
    if (plot) {
        garden_destroy(plot->garden);
        plate_finish(&plot->plate);
        free(plot);
    }
}

void plot_act(struct plot *plot, int64_t ticked, const struct action *action)
{
    garden_act(plot->garden, ticked, action);
}

void plot_sheet(struct plot *plot, int64_t ticked, int width, int height, bool fresh)
{
    if (fresh) {
        struct action clear = action_default(ACTION_CLEAR);
        garden_act(plot->garden, ticked, &clear);
    }
    garden_resize(plot->garden, width, height);
}

bool plot_tick(struct plot *plot)
{
    if (!garden_due(plot->garden)) {
        return true;
    }
    plot->painted = false;
    return garden_grow(plot->garden);
}

bool plot_lay(struct plot *plot, int64_t ticked, int width, int height, uint8_t *rgb)
{
    struct plate *plate = &plot->plate;
    if (plate->width != width || plate->height != height) {
        plate_finish(plate);
        plot->painted = false;
        if (!plate_init(plate, width, height)) {
            return false;
        }
    }
    plot->painted = plot->painted || garden_paint(plot->garden, plate);
    if (plot->painted) {
        plate_reveal(plate, ticked, rgb);
    }
    return plot->painted;
}

struct garden *plot_garden(struct plot *plot)
{
    return plot->garden;
}
