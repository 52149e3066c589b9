/* A figure: contact sheets of what the painting does, and checks of what is seen on them.
 * A group of figures is one function; checks go on after one fails, so that one run tells everything that is wrong. */
#ifndef FROND_FIGURE_H
#define FROND_FIGURE_H

#include <stdbool.h>

struct figure {
    const char *name;     /* of the group */
    const char *out;      /* folder for the sheets */
    bool keep;            /* what is drawn now is what later runs are compared with */
    int checks, failures; /* so far */
    bool skipped;         /* what it wants is not there */
};

struct figure_group {
    const char *name;    /* as the command line and CTest write it */
    const char *meaning; /* one sentence */
    void (*draw)(struct figure *figure);
};

void figure_accept(struct figure *figure);    /* figure_pattern.c */
void figure_exponent(struct figure *figure);  /* figure 4 */
void figure_diffusion(struct figure *figure); /* figure 5 */
void figure_reaction(struct figure *figure);  /* figure 6 */
void figure_noise(struct figure *figure);     /* figure 7 */
void figure_stencil(struct figure *figure);   /* figure 8 and all that is no dendrite */
void figure_round(struct figure *figure);     /* figure_round.c */
void figure_ink(struct figure *figure);       /* figure_ink.c: figure 9 */
void figure_seam(struct figure *figure);      /* section 7 */
void figure_second(struct figure *figure);    /* figure 13 */
void figure_session(struct figure *figure);   /* figure_session.c: figures 1 and 13 */
void figure_drawing(struct figure *figure);   /* figure_actions.c: figure 10 */
void figure_guidance(struct figure *figure);  /* figure 11 */
void figure_mask(struct figure *figure);      /* figure_shapes.c: figure 12 */
void figure_pour(struct figure *figure);      /* figure 14 */
void figure_edge(struct figure *figure);      /* figure_drop.c: section 6.3.3 */
void figure_wet(struct figure *figure);       /* section 5.3 */
void figure_extent(struct figure *figure);    /* figure_fluid.c */
void figure_mass(struct figure *figure);
void figure_random(struct figure *figure);     /* figure_random.c */
void figure_brushes(struct figure *figure);    /* figure_brushes.c */
void figure_margin(struct figure *figure);     /* figure_margin.c */
void figure_rest(struct figure *figure);       /* figure_rest.c */
void figure_wash(struct figure *figure);       /* figure_wash.c */
void figure_transition(struct figure *figure); /* figure_transition.c */
void figure_vision(struct figure *figure);     /* figure_vision.c */
void figure_attract(struct figure *figure);    /* figure_attract.c */
void figure_history(struct figure *figure);    /* figure_history.c */
void figure_gpu(struct figure *figure);        /* figure_gpu.c */
void figure_visit(struct figure *figure);      /* figure_visit.c */
void figure_dendrites(struct figure *figure);  /* figure_trees.c */
void figure_metaphors(struct figure *figure);
void figure_trees(struct figure *figure);
void figure_composites(struct figure *figure);
void figure_garden(struct figure *figure);      /* figure_garden.c */
void figure_photographs(struct figure *figure); /* figure_photographs.c */
void figure_hidden(struct figure *figure);
void figure_portrait(struct figure *figure);  /* figure_portrait.c */
void figure_laplacian(struct figure *figure); /* figure_laplacian.c */
void figure_bolts(struct figure *figure);     /* figure_bolts.c */
void figure_lsystem(struct figure *figure);   /* figure_lsystem.c */
void figure_storm(struct figure *figure);     /* figure_storm.c */
void figure_light(struct figure *figure);     /* figure_light.c */
void figure_chemistry(struct figure *figure); /* figure_chemistry.c */
void figure_classes(struct figure *figure);
void figure_dish(struct figure *figure);        /* figure_dish.c */
void figure_composition(struct figure *figure); /* figure_composition.c */

/* Prints "ok" or "FAIL", the name of the group and the text; counts. Returns `holds`. */
bool figure_check(struct figure *figure, bool holds, const char *text, ...) __attribute__((format(printf, 3, 4)));
/* Prints a line that is no check: what was measured. */
void figure_note(const struct figure *figure, const char *text, ...) __attribute__((format(printf, 2, 3)));
/* Says what is missing and ends the program with status 2: for what is no finding about the painting. */
_Noreturn void figure_stop(const char *what, const char *why);

#endif
