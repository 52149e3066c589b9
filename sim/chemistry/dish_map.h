/* The map of feed and kill, for a picker: feed upwards, kill to the right, in the colours of what the pattern is there,
 * with the pattern itself in it. What is where was found by growing it (tests/tables/dish_map_table.c, which writes
 * sim/chemistry/dish_map_table.c); the lines are those of the equations without diffusion. */
#ifndef FROND_DISH_MAP_H
#define FROND_DISH_MAP_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"
#include "gray_scott_classes.h"

/* What the map shows, per unit of time. */
#define DISH_MAP_FEED_LEAST 0.006f
#define DISH_MAP_FEED_MOST  0.070f
#define DISH_MAP_KILL_LEAST 0.044f
#define DISH_MAP_KILL_MOST  0.072f

struct dish_place {
    float feed, kill;
};
/* The rates at a place of the map, 0..1 to the right and down, brought into it; and the place of rates, which may lie
 * beyond. */
struct dish_place dish_map_place(struct point at);
struct point dish_map_at(float feed, float kill);

/* What the pattern is there; of rates beyond the map that at its border. */
enum gray_scott_class dish_map_class(float feed, float kill);
/* sRGB 0..255 of a class on the map. */
extern const uint8_t dish_map_colours[CLASSES][3];

/* The kill rate beyond which a fresh dish is the only uniform state that lasts (saddle-node: f = 4 (f + k)^2). */
float dish_map_saddle_node(float feed);
/* The feed rate below which the other uniform state swings itself up (Hopf: v^2 = k there, f sqrt(k) = (f + k)^2).
 * False where there is none, k > 1/16. */
bool dish_map_hopf(float kill, float *feed);

/* Fills width * height * 3 bytes of sRGB: pattern and classes, both lines. Letters are gray_scott_presets' to write. */
void dish_map_fill(int width, int height, uint8_t *rgb);

#endif
