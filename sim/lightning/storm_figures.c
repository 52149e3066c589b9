/* What there is of a storm, in figures. */
#include "storm_state.h"

int storm_figures(const void *scene, struct scene_figure *figures)
{
    const struct storm *storm = scene;
    int bolts = 0, growing = 0, struck = 0;
    for (int i = 0; i < STORM_SLOTS; i++) {
        const struct storm_bolt *bolt = &storm->bolts[i];
        bool counts = bolt->lives && bolt->undone == 0;
        bolts += counts;
        growing += counts && storm_bolt_grows(bolt);
        struck += counts && bolt->hit >= 0;
    }
    const struct scene_figure all[] = {
        {"kind", bolt_kind_names[storm->def.kind], 0},
        {"bolts", NULL, bolts},
        {"growing", NULL, growing},
        {"struck", NULL, struck},
        {"begun", NULL, (double)storm->bolts_begun},
        {"particles", NULL, (double)storm_particles(storm)},
        {"segments", NULL, storm->count},
    };
    int count = (int)(sizeof all / sizeof *all);
    for (int i = 0; i < count; i++) {
        figures[i] = all[i];
    }
    return count;
}
