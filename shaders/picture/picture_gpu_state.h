/* What the parts of the picture on the GPU share. Private to picture_gpu*.c.
 *   picture_gpu.c         life, programs
 *   picture_gpu_tables.c  textures: what is made once from the definition, and what the passes leave for one another
 *   picture_gpu_draw.c    the passes
 *   picture_gpu_still.c   a finished picture: to the panel, held, read back */
#ifndef FROND_PICTURE_GPU_STATE_H
#define FROND_PICTURE_GPU_STATE_H

#include "picture_gpu.h"
#include "picture_work.h"
#include "texture.h"

/* In the order in which they run. */
enum picture_pass {
    PASS_TONE,   /* histogram of depth */
    PASS_DEPTH,  /* its percentile */
    PASS_ACROSS, /* relief, blurred across */
    PASS_DOWN,   /* blurred down, ink */
    PASS_TALL,   /* resampled down */
    PASS_SHADE,  /* resampled across, shaded */
    PASS_SHOW,   /* onto the panel */
    PASSES,
};

enum picture_texture {
    PICTURE_TONE,    /* one texel: depth_ref, whether anything is masked */
    PICTURE_BLURRED, /* cells: depth blurred across, relief blurred across twice, relief */
    PICTURE_MATTER,  /* cells: line, body, hollow, wet */
    PICTURE_INKS,    /* cells: optical thickness */
    PICTURE_SURFACE, /* cells: relief, film, mask */
    PICTURE_TALL_MATTER,
    PICTURE_TALL_INKS,
    PICTURE_TALL_SURFACE,
    PICTURE_TALL_MASK,
    PICTURE_WEIGHTS_DOWN,
    PICTURE_WEIGHTS_ACROSS,
    PICTURE_GRAIN,
    PICTURE_STREAKS,
    PICTURE_LATTICE, /* 0 where inks mix by CMY */
    PICTURE_SHEET,   /* the picture */
    PICTURE_HELD,    /* an older one; 0 until one is held */
    PICTURE_TEXTURES,
};

enum {
    WIDE_TAPS = 28, /* of four neighbours at once: twice the radius and four */
    NARROW_TAPS = 8,
    BROAD_TAPS = 34,
};

struct picture_gpu {
    struct picture_def def;
    struct shader_folder folder;
    unsigned program[PASSES];
    unsigned texture[PICTURE_TEXTURES];
    unsigned tone;        /* GL buffer: histogram, mask, the tone followed */
    unsigned framebuffer; /* with PICTURE_SHEET */
    int taps_down, taps_across;
    float streak;     /* pixels from one end of a streak to the other */
    float ground[3];  /* linear */
    float cmy[4 * 3]; /* of the inks */
    float wide[WIDE_TAPS * 4], narrow[NARROW_TAPS * 4], broad[BROAD_TAPS * 4];
    size_t bytes; /* of the textures */
};

bool picture_gpu_textures(struct picture_gpu *picture, struct shader_error *error);

#endif
