/* What the map of feed and kill is made of: patterns that are grown, and told. */
#ifndef FROND_DISH_MAP_GROW_H
#define FROND_DISH_MAP_GROW_H

#include "dish_map.h"
#include "dish_map_table.h"

/* What a pattern becomes at that column and row of the table. Stops the program when memory is short. */
enum gray_scott_class dish_map_tell(int column, int row);
/* One sheet over which feed and kill change as on the map: DISH_MAP_WIDE * DISH_MAP_HIGH of v. */
void dish_map_grow(float *v);

#endif
