/* What has become of a dish, in figures. */
#include <stdlib.h>

#include "dish_state.h"
#include "gray_scott_classes.h"

enum { LATER = 300 }; /* units of time in which change is measured */

/* The dish some time later, if nothing is done. NULL when memory is short. */
static struct gray_scott *later(const struct dish *dish)
{
    int width = gray_scott_width(dish->chemistry), height = gray_scott_height(dish->chemistry);
    const struct action_raster field = {dish->along, width, height, 2};
    struct gray_scott *chemistry = gray_scott_resampled(dish->chemistry, width, height);
    bool good = chemistry && gray_scott_style(chemistry, dish->map.values ? &dish->map : NULL) &&
                gray_scott_orient(chemistry, dish->along ? &field : NULL);
    if (!good) {
        gray_scott_destroy(chemistry);
        return NULL;
    }
    float time = gray_scott_time_step(gray_scott_get(chemistry));
    gray_scott_step(chemistry, (int64_t)(LATER / time + 0.5f));
    return chemistry;
}

static bool measure(const struct dish *dish, struct gray_scott_figures *figures)
{
    size_t cells = dish_cells(dish);
    float *planes = malloc(3 * cells * sizeof *planes);
    struct gray_scott *chemistry = later(dish);
    bool good = planes && chemistry;
    if (good) {
        gray_scott_save(dish->chemistry, planes, planes + cells);
        gray_scott_save(chemistry, planes, planes + 2 * cells);
        good = gray_scott_measure(gray_scott_width(chemistry), gray_scott_height(chemistry), planes + 2 * cells,
                                  planes + cells, figures);
    }
    gray_scott_destroy(chemistry);
    free(planes);
    return good;
}

int dish_figures(const void *scene, struct scene_figure *figures)
{
    const struct dish *dish = scene;
    struct gray_scott_figures of;
    if (!measure(dish, &of)) {
        return 0;
    }
    const struct gray_scott_def *def = gray_scott_get(dish->chemistry);
    const struct scene_figure all[] = {
        {"class", gray_scott_class_names[gray_scott_classify(&of)], 0},
        {"preset", gray_scott_presets[dish->def.preset].name, 0},
        {"feed", NULL, (double)def->feed},
        {"kill", NULL, (double)def->kill},
        {"steps", NULL, (double)gray_scott_steps(dish->chemistry)},
        {"width", NULL, gray_scott_width(dish->chemistry)},
        {"height", NULL, gray_scott_height(dish->chemistry)},
        {"mean", NULL, of.mean},
        {"deviation", NULL, of.deviation},
        {"change", NULL, of.change},
        {"covered", NULL, of.covered},
        {"islands", NULL, of.islands},
        {"roundness", NULL, of.roundness},
    };
    int count = (int)(sizeof all / sizeof *all);
    for (int i = 0; i < count; i++) {
        figures[i] = all[i];
    }
    return count;
}
