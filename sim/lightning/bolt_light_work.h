/* What the two pictures of bolt_light.h have in common, on the processor and on the GPU, and the parts of the one on
 * the processor. Private to them.
 *
 * Segments become strokes, seen from the eye, which leave samples: of light and lines the most of each channel, of
 * bodies what is nearest. Samples are halved again and again (bolt_chain), and the sum of those levels is the halo of
 * light (Jimenez, Next Generation Post Processing, 2014), and what lies behind its surroundings, and so is darker, of
 * bodies (Luft et al., Image Enhancement by Unsharp Masking the Depth Buffer, 2006). */
#ifndef FROND_BOLT_LIGHT_WORK_H
#define FROND_BOLT_LIGHT_WORK_H

#include "bolt_light.h"

/* Where all is seen from, and how a place becomes one of the picture. */
struct bolt_eye {
    float turn[2], tilt[2]; /* sine, cosine */
    float middle[2];        /* of the sheet, cells */
    float away;             /* cells, from the middle */
    float scale[3];         /* samples a cell: along x, along y, of radii */
    float depth;            /* of a cell: depth 0.5 is the sheet, 0 as near as is told apart, 1 as far */
};
struct bolt_eye bolt_eye(const struct bolt_view *view, int width, int height); /* samples of the picture */

/* Of a segment, what can be drawn; false when nothing of it can be. */
bool bolt_sound(const struct bolt_segment *segment, struct bolt_segment *sound);

/* With a style that there is, colours and flash 0..1, a trunk thicker than the tips: what all below wants. */
struct bolt_view bolt_view_sound(const struct bolt_view *view);

/* Ticks since view->tick as the pictures take them. */
float bolt_age(const struct bolt_view *view, double tick);
/* Ticks in which a segment comes up, and at the most those in which it fades, by look. */
float bolt_rise(const struct bolt_look *look);
float bolt_fade(const struct bolt_look *look);

/* A segment or leaf as it is seen. */
struct bolt_stroke {
    float at[2], along[2]; /* samples: where it begins, and from there to where it ends */
    float shrink;          /* 1 / the square of its length, or 0 */
    float radius[2];       /* samples, there; of a leaf the greater is half its breadth in the middle */
    float depth[2];        /* 0..1 */
    float thick;           /* depth of a sample's breadth */
    float strength;        /* 0..1: heat, come up, faded, dimmed by distance */
    float tone;            /* 0..1: of the core in the colour of a body */
    float normal[3];       /* of a leaf */
    bool leaf;
};
/* Up to two; returns how many. */
int bolt_strokes(const struct bolt_view *view, const struct bolt_eye *eye, float age,
                 const struct bolt_segment *segment, struct bolt_stroke strokes[2]);

/* A sample. Light: square root of it, it. Lines: cover, of it the core. Bodies: normal x and y (127 is 0), tone,
 * 0 nothing, 1..127 a branch, 128..255 a leaf by how light it is. */
struct bolt_sample {
    uint8_t part[4];
};
struct bolt_samples {
    int width, height, style;
    struct bolt_sample *samples;
    uint16_t *depth; /* of bodies: 0..65535, nothing 65535 */
};
void bolt_draw(const struct bolt_samples *samples, const struct bolt_stroke *stroke);

enum { BOLT_LEVELS = 10, BOLT_SUPER = 2 /* samples of bodies along a pixel */ };
/* Each level, from 1 on, has half of the samples of the one before it along each side, rounded up; the last has a
 * shorter side of 6 to 11. `value` and `weight` are 0..1: light and nothing, or depth times cover and cover. */
struct bolt_chain {
    int count, width[BOLT_LEVELS + 1], height[BOLT_LEVELS + 1];
    float *value[BOLT_LEVELS + 1], *weight[BOLT_LEVELS + 1];
};
int bolt_levels(int width, int height); /* of that many samples */
/* Share of a level in the sum; of all levels together 1 or less. */
float bolt_share(int style, int level, int width, int height);
bool bolt_chain_make(struct bolt_chain *chain, const struct bolt_samples *samples);
void bolt_chain_finish(struct bolt_chain *chain); /* takes zeroed */
/* Of the sum, at a place in samples, linearly between them. */
void bolt_chain_at(const struct bolt_chain *chain, float x, float y, float *value, float *weight);

/* One row of the picture, from its samples, over `rgb`. */
struct bolt_paint {
    const struct bolt_view *view;
    const struct bolt_samples *samples;
    const struct bolt_chain *chain;
    const uint8_t *encoded; /* sRGB of (i / BOLT_ENCODED)^2 */
    int width, height;      /* pixels */
};
enum { BOLT_ENCODED = 4095 };
void bolt_paint_light(const struct bolt_paint *paint, int y, uint8_t *rgb);
void bolt_paint_lines(const struct bolt_paint *paint, int y, uint8_t *rgb);
void bolt_paint_bodies(const struct bolt_paint *paint, int y, uint8_t *rgb);

#endif
