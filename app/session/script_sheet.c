#include "script_sheet.h"

#include <math.h>

struct painting_def script_painting(const struct script *script)
{
    struct painting_def def = painting_default_def();
    def.width = script->width;
    def.height = script->height;
    def.margin = script->margin;
    def.seed = (uint32_t)script->seed;
    def.coefficients = script->coefficients;
    return def;
}

struct picture_def script_picture(const struct script *script, int width, int height)
{
    struct picture_def def = picture_default_def();
    def.width = width;
    def.height = height;
    def.cells_x = script->width;
    def.cells_y = script->height;
    def.mixing = (enum ink_mixing)script->mode;
    def.seed = (uint32_t)script->seed;
    for (int i = 0; i < INK_PALETTE; i++) {
        def.ink[i] = script->inks[i < script->ink_count ? i : 0];
    }
    return def;
}

static int within(double cells)
{
    return cells < CANVAS_SIZE_MIN ? CANVAS_SIZE_MIN : cells > CANVAS_SIZE_MAX ? CANVAS_SIZE_MAX : (int)cells;
}

void script_fit(struct script *script, int width, int height)
{
    double shape = (double)width / height, cells = (double)script->width * script->height;
    script->width = within(sqrt(cells * shape) + 0.5);
    script->height = within(sqrt(cells / shape) + 0.5);
}
