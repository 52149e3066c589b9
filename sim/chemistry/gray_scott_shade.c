#include "gray_scott_shade.h"

#include <math.h>
#include <stddef.h>

#include "ink.h"

#define STOPS(name)                                                                                                    \
    {                                                                                                                  \
        name, (int)(sizeof name / sizeof *name)                                                                        \
    }

static const struct gradient_stop BONE[] = {{0, {0.004f, 0.004f, 0.006f, 1}}, {1, {0.9f, 0.88f, 0.82f, 1}}};
static const struct gradient_stop REEF[] = {{0, {0.002f, 0.008f, 0.025f, 1}},
                                            {0.25f, {0.01f, 0.09f, 0.16f, 1}},
                                            {0.5f, {0.05f, 0.42f, 0.38f, 1}},
                                            {0.75f, {0.95f, 0.55f, 0.3f, 1}},
                                            {1, {1, 0.9f, 0.75f, 1}}};
static const struct gradient_stop EMBER[] = {{0, {0.006f, 0.002f, 0.004f, 1}},
                                             {0.3f, {0.16f, 0.01f, 0.02f, 1}},
                                             {0.6f, {0.85f, 0.16f, 0.02f, 1}},
                                             {0.85f, {1, 0.65f, 0.12f, 1}},
                                             {1, {1, 0.95f, 0.7f, 1}}};
static const struct gradient_stop GLASS[] = {{0, {0, 0, 0, 0}},
                                             {0.2f, {0, 0.05f, 0.07f, 0.25f}},
                                             {0.55f, {0.02f, 0.3f, 0.32f, 0.8f}},
                                             {1, {0.7f, 0.95f, 0.9f, 1}}};
static const struct gradient_stop INDIGO[] = {{0, {0.8f, 0.74f, 0.62f, 1}},
                                              {0.35f, {0.62f, 0.55f, 0.5f, 1}},
                                              {0.6f, {0.06f, 0.09f, 0.3f, 1}},
                                              {1, {0.006f, 0.012f, 0.07f, 1}}};

#define GRADIENTS(ROW)    ROW("bone", BONE) ROW("reef", REEF) ROW("ember", EMBER) ROW("glass", GLASS) ROW("indigo", INDIGO)
#define ROW(name, stops)  {name, STOPS(stops)},
#define NAME(name, stops) name,
const struct gradient_named gradients[] = {GRADIENTS(ROW){NULL, {NULL, 0}}};
const char *const gradient_names[] = {GRADIENTS(NAME) NULL};

void gradient_colour(const struct gradient *gradient, float at, float rgba[4])
{
    int next = 0;
    while (next < gradient->count && gradient->stops[next].at < at) {
        next++;
    }
    for (int c = 0; c < 4; c++) {
        if (gradient->count == 0) {
            rgba[c] = 0;
        } else if (next == 0 || next == gradient->count) {
            rgba[c] = gradient->stops[next == 0 ? 0 : next - 1].rgba[c];
        } else {
            const struct gradient_stop *before = &gradient->stops[next - 1], *after = &gradient->stops[next];
            float share = (at - before->at) / (after->at - before->at);
            rgba[c] = before->rgba[c] + share * (after->rgba[c] - before->rgba[c]);
        }
    }
}

struct gray_scott_shade_def gray_scott_shade_default_def(void)
{
    return (struct gray_scott_shade_def){
        .gradient = gradients[0].gradient, .high = 0.4f, .light = {-0.5f, -0.7f, 0.6f}};
}

/* Bilinear at a place in cells, the pattern repeated beyond its borders. */
static float pattern_at(const struct pattern_plane *plane, float x, float y)
{
    float fx = floorf(x - 0.5f), fy = floorf(y - 0.5f), dx = x - 0.5f - fx, dy = y - 0.5f - fy;
    int x0 = ((int)fx % plane->width + plane->width) % plane->width, x1 = (x0 + 1) % plane->width;
    int y0 = ((int)fy % plane->height + plane->height) % plane->height, y1 = (y0 + 1) % plane->height;
    const float *above = plane->v + (size_t)y0 * (size_t)plane->width;
    const float *below = plane->v + (size_t)y1 * (size_t)plane->width;
    float top = above[x0] + dx * (above[x1] - above[x0]), bottom = below[x0] + dx * (below[x1] - below[x0]);
    return top + dy * (bottom - top);
}

void gray_scott_shade(const struct pattern_plane *plane, const struct gray_scott_shade_def *def, int width, int height,
                      uint8_t *rgb)
{
    const float *l = def->light;
    float length = sqrtf(l[0] * l[0] + l[1] * l[1] + l[2] * l[2]), flat = length > 0 ? l[2] / length : 1;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            float px = ((float)x + 0.5f) * (float)plane->width / (float)width;
            float py = ((float)y + 0.5f) * (float)plane->height / (float)height;
            float v = pattern_at(plane, px, py), rgba[4], lit = 1, gloss = 0;
            gradient_colour(&def->gradient, (v - def->low) / (def->high - def->low), rgba);
            if (def->relief > 0 && length > 0) {
                float nx = -0.5f * def->relief * (pattern_at(plane, px + 1, py) - pattern_at(plane, px - 1, py));
                float ny = -0.5f * def->relief * (pattern_at(plane, px, py + 1) - pattern_at(plane, px, py - 1));
                float size = sqrtf(nx * nx + ny * ny + 1);
                float across = (nx * l[0] + ny * l[1] + l[2]) / (size * length);
                lit = 0.25f + 0.75f * (across > 0 ? across : 0) / (flat > 0.2f ? flat : 0.2f);
                float half = 2 * across / size - l[2] / length; /* towards the eye, of the mirrored light */
                gloss = half > 0 ? 0.35f * powf(half, 24) : 0;
            }
            for (int c = 0; c < 3; c++) {
                float under = 0;
                if (def->texture) {
                    int at = y % def->texture_height * def->texture_width + x % def->texture_width;
                    under = def->texture[3 * at + c];
                }
                float value = 255 * ink_encode(lit * (rgba[3] * rgba[c] + (1 - rgba[3]) * under) + rgba[3] * gloss);
                rgb[3 * ((size_t)y * (size_t)width + (size_t)x) + (size_t)c] =
                    (uint8_t)(value < 0        ? 0
                              : value > 254.5f ? 255
                                               : value + 0.5f);
            }
        }
    }
}
