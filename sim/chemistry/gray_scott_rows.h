/* The rows of gray_scott_keys, once for each table that has them: over struct gray_scott_def, over one within a struct.
 * Who includes it defines GRAY_SCOTT_AT(field), the offset of a field of struct gray_scott_def in the table's struct.
 */
#ifndef FROND_GRAY_SCOTT_ROWS_H
#define FROND_GRAY_SCOTT_ROWS_H

#define GRAY_SCOTT_NUMBER(field, from, to, start, what, text)                                                          \
    {.name = #field,                                                                                                   \
     .type = KEY_NUMBER,                                                                                               \
     .unit = what,                                                                                                     \
     .min = from,                                                                                                      \
     .max = to,                                                                                                        \
     .initial = start,                                                                                                 \
     .offset = GRAY_SCOTT_AT(field),                                                                                   \
     .meaning = text},
#define GRAY_SCOTT_CHOICE(field, names, start, text)                                                                   \
    {.name = #field,                                                                                                   \
     .type = KEY_CHOICE,                                                                                               \
     .unit = "",                                                                                                       \
     .initial = start,                                                                                                 \
     .choices = names,                                                                                                 \
     .offset = GRAY_SCOTT_AT(field),                                                                                   \
     .meaning = text},

#define GRAY_SCOTT_ROWS                                                                                                \
    GRAY_SCOTT_NUMBER(feed, 0, 0.15, 0.037, "per unit of time", "How fast fresh u comes, and everything is thinned.")  \
    GRAY_SCOTT_NUMBER(kill, 0, 0.1, 0.06, "per unit of time", "How fast v is taken out beside that.")                  \
    GRAY_SCOTT_NUMBER(diffusion_u, 0, 2, 0.2097, "cells^2 per unit of time",                                           \
                      "How fast u spreads; by the stencil's measure.")                                                 \
    GRAY_SCOTT_NUMBER(diffusion_v, 0, 2, 0.105, "cells^2 per unit of time", "How fast v spreads.")                     \
    GRAY_SCOTT_NUMBER(time_step, 0.01, 2, 1, "units of time",                                                          \
                      "Time of a step; less where diffusion would not be stable.")                                     \
    GRAY_SCOTT_NUMBER(size, 0.5, 4, 1, "", "Size of the pattern: diffusion is multiplied by its square.")              \
    GRAY_SCOTT_CHOICE(stencil, gray_scott_stencil_names, LAPLACIAN_NINE, "Neighbours that count, and their measure.")  \
    GRAY_SCOTT_CHOICE(boundary, gray_scott_boundary_names, BOUNDARY_PERIODIC, "What lies beyond the border.")          \
    GRAY_SCOTT_NUMBER(anisotropy_u, -0.6, 0.6, 0, "", "How much faster u spreads along the orientation than across.")  \
    GRAY_SCOTT_NUMBER(anisotropy_v, -0.6, 0.6, 0, "", "How much faster v spreads along the orientation than across.")  \
    GRAY_SCOTT_NUMBER(orientation, -360, 360, 0, "degrees", "Direction of anisotropy, from right towards down.")       \
    GRAY_SCOTT_NUMBER(noise_feed, -0.1, 0.1, 0, "per unit of time",                                                    \
                      "Simplex noise on the feed rate, -1..1 times this.")                                             \
    GRAY_SCOTT_NUMBER(noise_kill, -0.1, 0.1, 0, "per unit of time",                                                    \
                      "Simplex noise on the kill rate; 0.006 in the article.")                                         \
    GRAY_SCOTT_NUMBER(noise_size, 8, 4096, 160, "cells", "Size of the noise's features.")                              \
    GRAY_SCOTT_NUMBER(noise_speed, 0, 100, 0, "per 1000 units of time", "How fast the noise changes, in features.")    \
    GRAY_SCOTT_NUMBER(noise_offset, -1000, 1000, 7.3, "features", "How far apart the noises of feed and kill are.")    \
    GRAY_SCOTT_NUMBER(displacement, 0, 0.9, 0, "cells a step",                                                         \
                      "How far noise moves the cells before each step, at most.")                                      \
    GRAY_SCOTT_NUMBER(style_feed, -0.1, 0.1, 0, "per unit of time",                                                    \
                      "What the light places of the style map add to the feed rate.")                                  \
    GRAY_SCOTT_NUMBER(style_kill, -0.1, 0.1, 0, "per unit of time",                                                    \
                      "What the light places of the style map add to the kill rate.")                                  \
    GRAY_SCOTT_NUMBER(style_rate, 0, 1, 0, "", "How much less diffusion there is where the style map is dark."){       \
        .name = "seed",                                                                                                \
        .type = KEY_INTEGER,                                                                                           \
        .unit = "",                                                                                                    \
        .min = 0,                                                                                                      \
        .max = 2147483647,                                                                                             \
        .initial = 1,                                                                                                  \
        .offset = GRAY_SCOTT_AT(seed),                                                                                 \
        .meaning = "Another number, another noise."},

#endif
