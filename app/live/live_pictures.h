/* Stock pictures of an exhibit's folder, one after the other: for scenes of trees to grow over, and as fields along
 * whose edges what paints itself grows. Each is read on a thread of its own, through the image helper, before it is
 * asked for; one that cannot be read is a line for the log, once, and the next one comes. */
#ifndef FROND_LIVE_PICTURES_H
#define FROND_LIVE_PICTURES_H

#include <stdbool.h>

#include "action.h"
#include "exhibit.h"

enum { LIVE_PICTURES_KEPT = 4 }; /* fields, and pictures, that stay good */

struct live_pictures;

/* `def` loads pictures, as for scripts, in that thread. NULL when memory is short. */
struct live_pictures *live_pictures_create(const struct exhibit *exhibit, const struct exhibit_scene *scene,
                                           const struct script_def *def);
/* Waits for what is being read. Takes NULL. */
void live_pictures_destroy(struct live_pictures *pictures);
/* Another exhibit, or the same folder with other pictures in it; what was given out stays good. */
void live_pictures_set(struct live_pictures *pictures, const struct exhibit *exhibit,
                       const struct exhibit_scene *scene);
/* Another scene of it: one of trees may have a picture of its own, that comes first. */
void live_pictures_scene(struct live_pictures *pictures, const struct exhibit_scene *scene);
/* The next one as ACTION_GUIDE; its field is good until LIVE_PICTURES_KEPT more have been given. False: none is ready,
 * or there are none. */
bool live_pictures_next(struct live_pictures *pictures, struct action *guide);
/* The one that is grown over, or the next one, as ACTION_STOCK: linear brightness, 1024 pixels at most on the longer
 * side; as long good. False: it is not read yet, or there is none. */
bool live_pictures_stock(struct live_pictures *pictures, bool next, struct action *stock);
bool live_pictures_log(struct live_pictures *pictures, char *line, int size);

#endif
