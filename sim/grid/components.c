#include "components.h"

#include <stdlib.h>

/* Labels all that hangs together with the cell `first`; `stack` has room for every cell. */
static void flood(const uint8_t *mask, int width, int height, int32_t *labels, int32_t label, size_t first,
                  size_t *stack)
{
    size_t depth = 0;
    labels[first] = label;
    stack[depth++] = first;
    while (depth > 0) {
        size_t cell = stack[--depth];
        int x = (int)(cell % (size_t)width);
        int y = (int)(cell / (size_t)width);
        for (int v = y > 0 ? y - 1 : 0; v <= y + 1 && v < height; v++) {
            for (int u = x > 0 ? x - 1 : 0; u <= x + 1 && u < width; u++) {
                size_t next = (size_t)v * (size_t)width + (size_t)u;
                if (mask[next] && labels[next] == 0) {
                    labels[next] = label;
                    stack[depth++] = next;
                }
            }
        }
    }
}

int components_label(const uint8_t *mask, int width, int height, int32_t *labels)
{
    size_t cells = (size_t)width * (size_t)height;
    size_t *stack = malloc(cells * sizeof *stack);
    if (!stack) {
        return -1;
    }
    int32_t count = 0;
    for (size_t i = 0; i < cells; i++) {
        labels[i] = 0;
    }
    for (size_t i = 0; i < cells; i++) {
        if (mask[i] && labels[i] == 0) {
            flood(mask, width, height, labels, ++count, i, stack);
        }
    }
    free(stack);
    return count;
}
