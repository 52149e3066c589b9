/* Kinds of patterns of Gray-Scott: presets by Pearson's classes, and what a pattern is, told by its figures.
 * Letters and places of the classes: Pearson 1993, figure 3, extended by Munafo, "Stable localized moving patterns in
 * the 2-D Gray-Scott model", 2014, for diffusion rates two to one. */
#ifndef FROND_GRAY_SCOTT_CLASSES_H
#define FROND_GRAY_SCOTT_CLASSES_H

#include "gray_scott.h"

enum gray_scott_class {
    CLASS_UNIFORM, /* one state everywhere */
    CLASS_SPOTS,   /* islands of v, each about round */
    CLASS_WORMS,   /* stripes, loose or joined to a maze */
    CLASS_HOLES,   /* v everywhere but in islands */
    CLASS_WAVES,   /* never at rest: waves, spirals, chaos */
    CLASSES,
};
extern const char *const gray_scott_class_names[CLASSES + 1]; /* ends with NULL */

enum gray_scott_start {
    START_SPOTS, /* some spots on a fresh sheet */
    START_NOISE, /* grains of v all over */
    START_BLUE,  /* the other uniform state, with some holes */
};

struct gray_scott_preset {
    const char *name;
    const char *letter; /* Pearson's class as UTF-8 */
    float feed, kill;
    enum gray_scott_start start;
    float radius;             /* cells, of the spots or holes it starts from */
    enum gray_scott_class is; /* what it looks like for hours */
    const char *meaning;      /* one sentence for a curator */
};
extern const struct gray_scott_preset gray_scott_presets[]; /* ends with one whose name is NULL */
extern const char *const gray_scott_preset_names[];         /* of them, in their order; ends with NULL */
/* The preset of that name, or NULL. */
const struct gray_scott_preset *gray_scott_preset_find(const char *name);
/* The preset whose feed and kill are nearest, measured as shares of the whole map (figure of the map). */
const struct gray_scott_preset *gray_scott_preset_near(float feed, float kill);
/* The default parameters with a preset's rates. */
struct gray_scott_def gray_scott_preset_def(const struct gray_scott_preset *preset);
/* A sheet as the preset starts from. */
void gray_scott_preset_start(struct gray_scott *chemistry, const struct gray_scott_preset *preset, uint32_t seed);

struct gray_scott_figures {
    double mean, deviation; /* of v */
    double change;          /* root mean square of v - earlier, over deviation */
    double covered;         /* share of cells above the middle between least and most of v */
    int islands;            /* objects of the smaller part: of v, or of holes in it */
    double roundness;       /* 4 pi area / perimeter^2 of the islands, weighed by area: 1 a disc, less a worm */
};
/* From two planes of v, width * height, `earlier` some hundred units of time before; `earlier` NULL: change is 0. False
 * when memory is short. */
bool gray_scott_measure(int width, int height, const float *v, const float *earlier,
                        struct gray_scott_figures *figures);
enum gray_scott_class gray_scott_classify(const struct gray_scott_figures *figures);

#endif
