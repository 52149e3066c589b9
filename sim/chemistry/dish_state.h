/* What the files of dish.h share. */
#ifndef FROND_DISH_STATE_H
#define FROND_DISH_STATE_H

#include "dish.h"

enum {
    DISH_STOPS = 16,   /* of a clear gradient */
    DISH_LOOKED = 120, /* ticks after which it is looked whether anything is left */
    DISH_BARE = 300,   /* ticks for which a dish stays bare that has died out by itself */
};

struct dish {
    struct dish_def def;
    int width, height; /* cells of the sheet */
    struct gray_scott *chemistry;
    bool fresh;               /* u = 1, v = 0 everywhere */
    bool starts;              /* a preset was set, and it is fresh: at the tick it starts */
    bool failed;              /* memory was short */
    bool sown;                /* as its preset starts; nobody has taken anything away since */
    int sowings;              /* since it was clear */
    int64_t sows;             /* it has died out, and is sown anew at that tick; 0: not so */
    struct action_raster map; /* the style, as it came; values NULL: none */
    float *style;             /* its values; owned */
    float *along;             /* what was combed: 2 * cells of the chemistry, by channel; NULL: nothing */
    bool combed;              /* and the chemistry does not know it yet */
    float *dry;               /* of each cell of the chemistry, 0..1; NULL: nowhere */
    float all_dry;            /* of the whole sheet, 0..1 */
    float owed;               /* steps, less than one */
    float *seen;              /* v, row by row, as of the last tick */
    float *before;            /* u and v before the tick's steps, where something is dry; NULL until wanted */
    struct gradient_stop stops[DISH_STOPS]; /* of the gradient where it is clear */
    int stop_count;
};

static inline size_t dish_cells(const struct dish *dish)
{
    return (size_t)gray_scott_width(dish->chemistry) * (size_t)gray_scott_height(dish->chemistry);
}

/* dish.c. The values of the keys, with what the style and the comb bring by themselves, become the chemistry's. */
void dish_set(struct dish *dish);

/* dish_dose.c */
void dish_dose(struct dish *dish, const struct action *action);
/* How far a place is from a path, both in cells of the sheet; `along`: the direction of its nearest piece, if that has
 * one. */
float dish_apart(const struct dish *dish, const struct action_path *path, struct point at, struct point *along);
/* All cells of the chemistry. */
struct rectangle dish_whole(const struct dish *dish);

/* dish_act.c. Of `wide` cells over the sheet that in which the middle of a cell of `cells` lies. */
int dish_nearest(int at, int cells, int wide);
void dish_style(struct dish *dish, const struct action *action);
void dish_rinse(struct dish *dish, const struct action *action);
void dish_clear(struct dish *dish);
void dish_dry(struct dish *dish, const struct action *action, bool wet);

/* dish_comb.c: a guide. */
void dish_comb(struct dish *dish, const struct action *action);

/* dish_view.c. Here and below `scene` is a dish, and what is to be done is as of struct scene_type. */
void dish_make_stops(struct dish *dish);
bool dish_lay(void *scene, int64_t tick, int width, int height, uint8_t *rgb);
/* dish_field.c. Bilinear at the middles of other cells. */
void dish_sample(const float *plane, int columns, int rows, int width, int height, float *values);
bool dish_plane(void *scene, int plane, int width, int height, float *values);
bool dish_field(void *scene, enum scene_field field, int width, int height, float *values);
/* dish_figures.c */
int dish_figures(const void *scene, struct scene_figure *figures);

#endif
