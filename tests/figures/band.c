#include "band.h"

#include <float.h>
#include <stdio.h>

int band_outside(const struct shape_figures *shape, char *text, size_t size)
{
    const struct {
        const char *name;
        double value, least, most;
    } bands[] = {
        {"components", shape->components, 1, 1},
        {"perimeter per cell", shape->perimeter_per_cell, 0.10, 0.22},
        {"junctions per 1000", shape->junctions_per_1000, 5, DBL_MAX},
        {"tips per 1000", shape->tips_per_1000, 1, 5},
        {"hull share", shape->hull_share, 0.75, 0.92},
        {"largest width", shape->largest_width, 0, 45},
        {"diagonals over axes", shape->diagonals_over_axes, 0.9, 1.2},
    };
    int outside = 0;
    size_t used = 0;
    snprintf(text, size, "none");
    for (size_t i = 0; i < sizeof bands / sizeof bands[0]; i++) {
        if (bands[i].value < bands[i].least || bands[i].value > bands[i].most) {
            int wrote =
                snprintf(text + used, size - used, "%s%s %.3g", outside ? ", " : "", bands[i].name, bands[i].value);
            used += (size_t)wrote < size - used ? (size_t)wrote : size - used - 1;
            outside++;
        }
    }
    return outside;
}
