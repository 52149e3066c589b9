/* `frond bolt`: what is asked for, and the doing of it: grows one aggregate and writes it in whatever ways are wanted.
 */
#ifndef FROND_BOLT_ORDER_H
#define FROND_BOLT_ORDER_H

#include <stdbool.h>

#include "bolt_shape.h"
#include "file.h"
#include "fit.h"
#include "lsystem_plant.h"

enum { BOLT_OUTPUTS = 8, BOLT_SIDE_MOST = 8192, BOLT_PATH_PLACES = 1024 };

enum bolt_picture { BOLT_MASK, BOLT_ETA_MAP, BOLT_OUTLINE, BOLT_ENVIRONMENT, BOLT_PICTURES };
extern const char *const bolt_picture_names[BOLT_PICTURES]; /* "mask", ...: as of laplacian_keys */

/* The tables laplacian_keys, bolt_look_keys and bolt_order_keys say units and ranges. Texts belong to whoever made it.
 */
struct bolt_order {
    struct bolt bolt; /* the preset of the kind, and what was asked for instead */
    int kind;
    int lsystem;                /* 0, or 1 + enum lsystem_kind: a plant in the place of an aggregate */
    struct lsystem_plant plant; /* its values; its charges and seeds are those of `bolt` */
    int width, height;          /* pixels: the room */
    float turn;                 /* turns about the upright axis */
    int sides;                  /* of the tubes of a mesh */
    int film;                   /* pictures of a film */
    bool lines;                 /* a mesh of lines with radii, no tubes */
    bool bare;                  /* without the charges and seeds of the kind */
    int axes[3];                /* what is seen of more than three dimensions */
    const char *pictures[BOLT_PICTURES];
    const char *outputs[BOLT_OUTPUTS]; /* .png, .svg, .obj or .ply */
    int output_count;
    const char *potential, *height_field, *stats, *frames; /* paths, or NULL */
    float *paths[BOLT_CHARGES];                            /* of painted strokes; owned */
    int path_count;
};

extern const struct key bolt_order_keys[]; /* of struct bolt_order; ends with a key whose name is NULL */

struct bolt_order bolt_order_default(void);
/* The kind's own values, in this room; its charges and seeds unless `bare`. The order stays where it is. */
void bolt_order_preset(struct bolt_order *order);
/* Another span, in cells. An aggregate keeps its particles, which are a cell each (bolt_respan); a plant is as large in
 * the picture as before, its lengths too. What was asked for instead of them, but for dimensions, is lost. */
void bolt_order_respan(struct bolt_order *order, float span);
void bolt_order_finish(struct bolt_order *order); /* takes zeroed */

/* Grows it and writes all. False with the error; what was written before stays. */
bool bolt_order_run(struct bolt_order *order, struct file_error *error);

/* What has grown, for those who write it. */
struct bolt_result {
    const struct bolt_order *order;
    struct laplacian *laplacian; /* of a plant: the charges along it, where they are asked for */
    struct lsystem *plant;       /* or NULL */
    struct bolt_shape shape;
    double seconds; /* that it took to grow */
};

bool bolt_write_png(const struct bolt_result *result, const char *path, struct file_error *error);
/* `film` pictures of how it came, 000000.png, 000001.png, ... */
bool bolt_write_frames(const struct bolt_result *result, const char *folder, struct file_error *error);
/* One path a branch, its outline, with its widths beside it; leaves as paths of their own. */
bool bolt_write_svg(const struct bolt_result *result, const char *path, struct file_error *error);
bool bolt_write_stats(const struct bolt_result *result, const char *path, struct file_error *error);
/* Eq. 10 at every pixel, in bands of colour as figure 5b has it. */
bool bolt_write_potential(const struct bolt_result *result, const char *path, struct file_error *error);
/* That of the particles alone, without attractors and repulsors, as heights of 16 bits: the growth is ridges up to
 * 65535 (section IV.C). Of rivers and fracture, which cut into the land, it is valleys down to 0. */
bool bolt_write_height(const struct bolt_result *result, const char *path, struct file_error *error);

#endif
