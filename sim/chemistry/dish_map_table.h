/* What tests/tables/dish_map_table.c has found; sim/chemistry/dish_map_table.c is written by it. */
#ifndef FROND_DISH_MAP_TABLE_H
#define FROND_DISH_MAP_TABLE_H

enum {
    DISH_MAP_COLUMNS = 64, /* places at which a pattern was told by its figures, */
    DISH_MAP_ROWS = 48,    /* each in the middle of its part of the map, from the top */
    DISH_MAP_WIDE = 216,   /* cells of one sheet over which feed and kill change, */
    DISH_MAP_HIGH = 162,   /* as on the map */
    DISH_MAP_SHADES = 16,
};
/* '0' + enum gray_scott_class. */
extern const char *const dish_map_classes[DISH_MAP_ROWS];
/* v of the sheet: 'a' none, 'p' 0.4 and more. */
extern const char *const dish_map_pattern[DISH_MAP_HIGH];

#endif
