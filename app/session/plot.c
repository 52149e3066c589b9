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

static struct garden *make_garden(int width, int height)
{
    struct garden_def def = garden_default_def();
    def.width = width;
    def.height = height;
    return garden_create(&def);
}

struct plot *plot_create(int width, int height)
{
    struct plot *plot = calloc(1, sizeof *plot);
    if (plot) {
        plot->garden = make_garden(width, height);
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

bool plot_sheet(struct plot *plot, int width, int height, bool fresh)
{
    struct garden *garden = fresh ? make_garden(width, height) : plot->garden;
    if (!garden) {
        return false;
    }
    if (fresh) {
        garden_destroy(plot->garden);
        plot->garden = garden;
        plot->painted = false;
    }
    garden_resize(garden, width, height);
    return true;
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
