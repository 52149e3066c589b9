/* The rows of gray_scott_keys (key_fields.h), once for each table that has them: over struct gray_scott_def, over one
 * within a struct. */
#ifndef FROND_GRAY_SCOTT_ROWS_H
#define FROND_GRAY_SCOTT_ROWS_H

#include "key_fields.h"

#define GRAY_SCOTT_ROWS                                                                                                \
    NUMBER(feed, "per unit of time", 0, 0.15, 0.037, "How fast fresh u comes, and everything is thinned."),            \
        NUMBER(kill, "per unit of time", 0, 0.1, 0.06, "How fast v is taken out beside that."),                        \
        NUMBER(diffusion_u, "cells^2 per unit of time", 0, 2, 0.2097,                                                  \
               "How fast u spreads; by the stencil's measure."),                                                       \
        NUMBER(diffusion_v, "cells^2 per unit of time", 0, 2, 0.105, "How fast v spreads."),                           \
        NUMBER(time_step, "units of time", 0.01, 2, 1, "Time of a step; less where diffusion would not be stable."),   \
        NUMBER(size, "", 0.5, 4, 1, "Size of the pattern: diffusion is multiplied by its square."),                    \
        CHOICE(stencil, gray_scott_stencil_names, LAPLACIAN_NINE, "Neighbours that count, and their measure."),        \
        CHOICE(boundary, gray_scott_boundary_names, BOUNDARY_PERIODIC, "What lies beyond the border."),                \
        NUMBER(anisotropy_u, "", -0.6, 0.6, 0, "How much faster u spreads along the orientation than across."),        \
        NUMBER(anisotropy_v, "", -0.6, 0.6, 0, "How much faster v spreads along the orientation than across."),        \
        NUMBER(orientation, "degrees", -360, 360, 0, "Direction of anisotropy, from right towards down."),             \
        NUMBER(noise_feed, "per unit of time", -0.1, 0.1, 0, "Simplex noise on the feed rate, -1..1 times this."),     \
        NUMBER(noise_kill, "per unit of time", -0.1, 0.1, 0, "Simplex noise on the kill rate; 0.006 in the article."), \
        NUMBER(noise_size, "cells", 8, 4096, 160, "Size of the noise's features."),                                    \
        NUMBER(noise_speed, "per 1000 units of time", 0, 100, 0, "How fast the noise changes, in features."),          \
        NUMBER(noise_offset, "features", -1000, 1000, 7.3, "How far apart the noises of feed and kill are."),          \
        NUMBER(displacement, "cells a step", 0, 0.9, 0, "How far noise moves the cells before each step, at most."),   \
        NUMBER(style_feed, "per unit of time", -0.1, 0.1, 0,                                                           \
               "What the light places of the style map add to the feed rate."),                                        \
        NUMBER(style_kill, "per unit of time", -0.1, 0.1, 0,                                                           \
               "What the light places of the style map add to the kill rate."),                                        \
        NUMBER(style_rate, "", 0, 1, 0, "How much less diffusion there is where the style map is dark."),              \
        WHOLE(seed, "", 0, 2147483647, 1, "Another number, another noise.")

#endif
