/* A painting as texels for the picture: one row of them at a time, shared among the team. */
#include "painting_state.h"

struct publishing {
    const struct painting *painting;
    const struct painting_texels *texels;
};

enum { ROWS = 16 }; /* of a piece of work */

static void publish_ground(const struct painting *painting, int y, float *restrict texel)
{
    int margin = painting->def.margin, stride = painting->stride;
    const float *restrict pattern = pattern_row(painting, y) + margin;
    const float *restrict solvent = solvent_row(painting, y) + margin;
    const uint8_t *restrict obstacle = ground_obstacle(painting->ground, y) + margin;
    for (int x = 0; x < painting->def.width; x++) {
        texel[4 * x] = pattern[PATTERN_ACTIVE * stride + x] + pattern[PATTERN_CARVED * stride + x];
        texel[4 * x + 1] = solvent[x];
        texel[4 * x + 2] = obstacle[x] ? 1.0f : 0.0f;
        texel[4 * x + 3] = pattern[PATTERN_CATALYST * stride + x];
    }
}

static void publish_ink(const struct painting *painting, int y, float *restrict texel)
{
    int margin = painting->def.margin, stride = painting->stride;
    const float *restrict wet = fluid_row(painting, y) + FLUID_WET * stride + margin;
    const float *restrict dry = dry_row(painting, y) + margin;
    for (int x = 0; x < painting->def.width; x++) {
        texel[4 * x] = wet[x] + dry[x];
        texel[4 * x + 1] = wet[stride + x] + dry[stride + x];
        texel[4 * x + 2] = wet[2 * stride + x] + dry[2 * stride + x];
        texel[4 * x + 3] = wet[3 * stride + x] + dry[3 * stride + x];
    }
}

static void publish_pattern(const struct painting *painting, int y, float *restrict texel)
{
    int margin = painting->def.margin, stride = painting->stride;
    const float *restrict pattern = pattern_row(painting, y) + margin;
    const float *restrict ink = fluid_row(painting, y) + FLUID_INK * stride + margin;
    for (int x = 0; x < painting->def.width; x++) {
        float density = 0.0f;
        for (int i = 0; i < 9; i++) {
            density += ink[i * stride + x];
        }
        texel[4 * x] = pattern[PATTERN_ACTIVE * stride + x];
        texel[4 * x + 1] = pattern[PATTERN_CARVED * stride + x];
        texel[4 * x + 2] = density;
        texel[4 * x + 3] = 0.0f;
    }
}

static void publish_vectors(const struct painting *painting, int y, float *restrict texel)
{
    int margin = painting->def.margin, stride = painting->stride;
    const float *restrict f = fluid_row(painting, y) + FLUID_SOLVENT * stride + margin;
    const int16_t *restrict guide_x = ground_guide(painting->ground, 0, y) + margin;
    const int16_t *restrict guide_y = ground_guide(painting->ground, 1, y) + margin;
    for (int x = 0; x < painting->def.width; x++, f++) {
        texel[4 * x] = f[stride] - f[3 * stride] + f[5 * stride] - f[6 * stride] - f[7 * stride] + f[8 * stride];
        texel[4 * x + 1] =
            f[2 * stride] - f[4 * stride] + f[5 * stride] + f[6 * stride] - f[7 * stride] - f[8 * stride];
        texel[4 * x + 2] = (float)guide_x[x] * UNIT_GUIDE;
        texel[4 * x + 3] = (float)guide_y[x] * UNIT_GUIDE;
    }
}

static void publish_rows(void *context, int piece, int member)
{
    const struct publishing *publishing = context;
    const struct painting *painting = publishing->painting;
    const struct painting_texels *texels = publishing->texels;
    const struct {
        float *to;
        void (*publish)(const struct painting *, int y, float *restrict texel);
    } parts[] = {{texels->ground, publish_ground},
                 {texels->ink, publish_ink},
                 {texels->pattern, publish_pattern},
                 {texels->vectors, publish_vectors}};
    (void)member;
    for (int row = piece * ROWS; row < (piece + 1) * ROWS && row < painting->def.height; row++) {
        size_t at = 4 * (size_t)row * (size_t)painting->def.width;
        for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
            if (parts[i].to) {
                parts[i].publish(painting, row + painting->def.margin, parts[i].to + at);
            }
        }
    }
}

void painting_publish(struct painting *painting, const struct painting_texels *texels)
{
    struct publishing publishing = {painting, texels};
    team_run(painting->team, publish_rows, &publishing, (painting->def.height + ROWS - 1) / ROWS);
}
