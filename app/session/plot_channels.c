/* What scenes beside the engine are made of, as channels of a file. */
#include <stdio.h>
#include <stdlib.h>

#include "plot.h"

/* dark, along.x, along.y, around; then planes. */
enum { ALONG_X = 1, ALONG_Y, AROUND, FIELDS };

static int planes_of(enum scene_kind kind)
{
    int count = 0;
    while (scene_types[kind]->planes && scene_types[kind]->planes[count]) {
        count++;
    }
    return count;
}

/* The kind that a channel is of, and which of its own it is; SCENE_KINDS: there are no more. */
static int find(const struct plot *plot, int channel, int *own)
{
    int kind = SCENE_PAINTING + 1;
    for (; kind < SCENE_KINDS; kind++) {
        int count = plot_scene(plot, (enum scene_kind)kind) ? FIELDS + planes_of((enum scene_kind)kind) : 0;
        if (channel < count) {
            break;
        }
        channel -= count;
    }
    *own = channel;
    return kind;
}

int plot_channels(const struct plot *plot)
{
    int count = 0, own;
    while (find(plot, count, &own) < SCENE_KINDS) {
        count++;
    }
    return count;
}

void plot_channel_name(const struct plot *plot, int channel, char name[PLOT_CHANNEL_NAME])
{
    int own, kind = find(plot, channel, &own);
    const char *part = own == ALONG_X ? ".x" : own == ALONG_Y ? ".y" : "";
    const char *what = own >= FIELDS   ? scene_types[kind]->planes[own - FIELDS]
                       : own == 0      ? scene_field_names[FIELD_DARK]
                       : own == AROUND ? scene_field_names[FIELD_AROUND]
                                       : scene_field_names[FIELD_ALONG];
    snprintf(name, PLOT_CHANNEL_NAME, "%s.%s%s", scene_kind_names[kind], what, part);
}

bool plot_channel(struct plot *plot, int channel, int width, int height, float *values)
{
    int own, kind = find(plot, channel, &own);
    const struct scene_type *type = scene_types[kind];
    void *scene = plot_scene(plot, (enum scene_kind)kind);
    size_t count = (size_t)width * (size_t)height;
    if (own >= FIELDS) {
        return type->plane(scene, own - FIELDS, width, height, values);
    }
    if (own != ALONG_X && own != ALONG_Y) {
        return type->field(scene, own == AROUND ? FIELD_AROUND : FIELD_DARK, width, height, values);
    }
    float *both = malloc(2 * count * sizeof *both);
    bool good = both && type->field(scene, FIELD_ALONG, width, height, both);
    for (size_t i = 0; i < count && good; i++) {
        values[i] = both[own == ALONG_Y ? count + i : i];
    }
    free(both);
    return good;
}
