/* Writes sim/chemistry/dish_map_table.c: see tests/tables/CMakeLists.txt. */
#include <stdio.h>
#include <stdlib.h>

#include "dish_map_grow.h"

int main(void)
{
    float *v = malloc(DISH_MAP_WIDE * DISH_MAP_HIGH * sizeof *v);
    if (!v) {
        return 1;
    }
    printf("/* Written by tests/tables/dish_map_table.c. */\n#include \"dish_map_table.h\"\n\n");
    printf("const char *const dish_map_classes[DISH_MAP_ROWS] = {\n");
    for (int row = 0; row < DISH_MAP_ROWS; row++) {
        printf("    \"");
        for (int column = 0; column < DISH_MAP_COLUMNS; column++) {
            putchar('0' + (int)dish_map_tell(column, row));
        }
        printf("\",\n");
        fprintf(stderr, "\r%d of %d rows", row + 1, DISH_MAP_ROWS);
    }
    fprintf(stderr, "\n");
    dish_map_grow(v);
    printf("};\n\n/* clang-format off */\nconst char *const dish_map_pattern[DISH_MAP_HIGH] = {\n");
    for (int y = 0; y < DISH_MAP_HIGH; y++) {
        printf("    \"");
        for (int x = 0; x < DISH_MAP_WIDE; x++) {
            int shade = (int)(v[y * DISH_MAP_WIDE + x] / 0.4f * (DISH_MAP_SHADES - 1) + 0.5f);
            putchar('a' + (shade < DISH_MAP_SHADES ? shade : DISH_MAP_SHADES - 1));
            if (x % 108 == 107 && x + 1 < DISH_MAP_WIDE) {
                printf("\"\n    \"");
            }
        }
        printf("\",\n");
    }
    printf("};\n/* clang-format on */\n");
    free(v);
    return 0;
}
