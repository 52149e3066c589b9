#include "checkpoint.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"

float *checkpoint_plane(const struct checkpoint *checkpoint, int plane)
{
    return checkpoint->planes + (size_t)plane * (size_t)checkpoint->width * (size_t)checkpoint->height;
}

bool checkpoint_init(struct checkpoint *checkpoint, const struct painting_def *def)
{
    size_t bytes = 0;
    *checkpoint = (struct checkpoint){
        .def = *def, .width = def->width + 2 * def->margin, .height = def->height + 2 * def->margin};
    size_t cells = (size_t)checkpoint->width * (size_t)checkpoint->height;
    checkpoint->planes = memory_take(cells * CHECKPOINT_PLANES, sizeof(float), &bytes);
    checkpoint->ground = ground_create(def);
    if (!checkpoint->planes || !checkpoint->ground) {
        checkpoint_finish(checkpoint);
        return false;
    }
    float *catalyst = checkpoint_plane(checkpoint, CHECKPOINT_CATALYST);
    for (size_t i = 0; i < cells; i++) {
        catalyst[i] = 1.0f;
    }
    return true;
}

void checkpoint_finish(struct checkpoint *checkpoint)
{
    free(checkpoint->planes);
    ground_destroy(checkpoint->ground);
    *checkpoint = (struct checkpoint){0};
}

bool checkpoint_fits(const struct checkpoint *checkpoint, const struct painting_def *def)
{
    return checkpoint->planes && canvas_is_like(painting_canvas(&checkpoint->def), painting_canvas(def));
}
