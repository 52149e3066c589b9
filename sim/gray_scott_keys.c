#include "gray_scott.h"

const char *const gray_scott_stencil_names[LAPLACIANS + 1] = {"nine", "article", "five", NULL};
const char *const gray_scott_boundary_names[BOUNDARIES + 1] = {"periodic", "no_flux", NULL};

#define NUMBER(field, from, to, start, what, text)                                                                     \
    {                                                                                                                  \
        .name = #field, .type = KEY_NUMBER, .unit = what, .min = from, .max = to, .initial = start,                    \
        .offset = offsetof(struct gray_scott_def, field), .meaning = text                                              \
    }
#define CHOICE(field, names, start, text)                                                                              \
    {                                                                                                                  \
        .name = #field, .type = KEY_CHOICE, .unit = "", .initial = start, .choices = names,                            \
        .offset = offsetof(struct gray_scott_def, field), .meaning = text                                              \
    }

const struct key gray_scott_keys[] = {
    NUMBER(feed, 0, 0.15, 0.037, "per unit of time", "How fast fresh u comes, and everything is thinned."),
    NUMBER(kill, 0, 0.1, 0.06, "per unit of time", "How fast v is taken out beside that."),
    NUMBER(diffusion_u, 0, 2, 0.2097, "cells^2 per unit of time", "How fast u spreads; by the stencil's measure."),
    NUMBER(diffusion_v, 0, 2, 0.105, "cells^2 per unit of time", "How fast v spreads."),
    NUMBER(time_step, 0.01, 2, 1, "units of time", "Time of a step; less where diffusion would not be stable."),
    NUMBER(size, 0.5, 4, 1, "", "Size of the pattern: diffusion is multiplied by its square."),
    CHOICE(stencil, gray_scott_stencil_names, LAPLACIAN_NINE, "Neighbours that count, and their measure."),
    CHOICE(boundary, gray_scott_boundary_names, BOUNDARY_PERIODIC, "What lies beyond the border."),
    NUMBER(anisotropy_u, -0.6, 0.6, 0, "", "How much faster u spreads along the orientation than across."),
    NUMBER(anisotropy_v, -0.6, 0.6, 0, "", "How much faster v spreads along the orientation than across."),
    NUMBER(orientation, -360, 360, 0, "degrees", "Direction of anisotropy, from right towards down."),
    NUMBER(noise_feed, -0.1, 0.1, 0, "per unit of time", "Simplex noise on the feed rate, -1..1 times this."),
    NUMBER(noise_kill, -0.1, 0.1, 0, "per unit of time", "Simplex noise on the kill rate; 0.006 in the article."),
    NUMBER(noise_size, 8, 4096, 160, "cells", "Size of the noise's features."),
    NUMBER(noise_speed, 0, 100, 0, "per 1000 units of time", "How fast the noise changes, in features."),
    NUMBER(noise_offset, -1000, 1000, 7.3, "features", "How far apart the noises of feed and kill are."),
    NUMBER(displacement, 0, 0.9, 0, "cells a step", "How far noise moves the cells before each step, at most."),
    NUMBER(style_feed, -0.1, 0.1, 0, "per unit of time",
           "What the light places of the style map add to the feed rate."),
    NUMBER(style_kill, -0.1, 0.1, 0, "per unit of time",
           "What the light places of the style map add to the kill rate."),
    NUMBER(style_rate, 0, 1, 0, "", "How much less diffusion there is where the style map is dark."),
    {.name = "seed",
     .type = KEY_INTEGER,
     .unit = "",
     .min = 0,
     .max = 2147483647,
     .initial = 1,
     .offset = offsetof(struct gray_scott_def, seed),
     .meaning = "Another number, another noise."},
    {.name = NULL},
};

struct gray_scott_def gray_scott_default_def(void)
{
    struct gray_scott_def def = {0};
    key_defaults(gray_scott_keys, &def);
    return def;
}

struct gray_scott_def gray_scott_legal(const struct gray_scott_def *def)
{
    struct gray_scott_def legal = *def;
    for (const struct key *key = gray_scott_keys; key->name; key++) {
        char *place = (char *)&legal + key->offset;
        if (key->type == KEY_NUMBER) {
            float *value = (float *)(void *)place, least = (float)key->min, most = (float)key->max;
            *value = *value > least ? *value : least; /* what is no number becomes the least */
            *value = *value < most ? *value : most;
        } else if (key->type == KEY_INTEGER) {
            int *value = (int *)(void *)place;
            *value = *value < (int)key->min ? (int)key->min : *value;
        } else {
            int *value = (int *)(void *)place, choices = 0;
            while (key->choices[choices]) {
                choices++;
            }
            *value = *value < 0 || *value >= choices ? (int)key->initial : *value;
        }
    }
    return legal;
}
