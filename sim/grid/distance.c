#include "distance.h"

#include <math.h>
#include <stdlib.h>

/* Distance to the nearest ground in the same column, downwards and back up. */
static void columns(const uint8_t *mask, int width, int height, int32_t *column)
{
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            size_t i = (size_t)y * (size_t)width + (size_t)x;
            int32_t above = y > 0 ? column[i - (size_t)width] : 0;
            column[i] = mask[i] ? above + 1 : 0;
        }
    }
    for (int y = height - 1; y >= 0; y--) {
        for (int x = 0; x < width; x++) {
            size_t i = (size_t)y * (size_t)width + (size_t)x;
            int32_t below = y < height - 1 ? column[i + (size_t)width] : 0;
            if (column[i] > below + 1) {
                column[i] = below + 1;
            }
        }
    }
}

struct parabola {
    int32_t centre; /* column of its lowest point */
    int32_t from;   /* first column at which it is the lowest of all */
};

/* The squared distance from column x to the ground that column `centre` found `height` cells away. */
static int64_t reach(int32_t x, int32_t centre, int32_t height)
{
    int64_t across = x - centre;
    return across * across + (int64_t)height * height;
}

/* The last column at which the parabola of `left` is no higher than that of `right`, right of it. */
static int32_t separation(int32_t left, int32_t left_height, int32_t right, int32_t right_height)
{
    int64_t difference = (int64_t)right * right - (int64_t)left * left + (int64_t)right_height * right_height -
                         (int64_t)left_height * left_height;
    int64_t twice = 2 * ((int64_t)right - left);
    int64_t quotient = difference / twice;
    return (int32_t)(quotient - (difference % twice < 0));
}

/* The lower envelope of the parabolas of one row. Column -1 and column `width` lie beyond the sheet and are ground. */
static void row(const int32_t *column, int width, struct parabola *stack, float *distance)
{
    int top = 0;
    stack[0] = (struct parabola){-1, -1};
    for (int32_t x = 0; x <= width; x++) {
        int32_t height = x < width ? column[x] : 0;
        int32_t below = stack[top].centre < 0 ? 0 : column[stack[top].centre];
        while (top >= 0 && reach(stack[top].from, stack[top].centre, below) > reach(stack[top].from, x, height)) {
            top--;
            below = top < 0 || stack[top].centre < 0 ? 0 : column[stack[top].centre];
        }
        if (top < 0) {
            top = 0;
            stack[0] = (struct parabola){x, -1};
            continue;
        }
        int32_t from = separation(stack[top].centre, below, x, height) + 1;
        if (from <= width) {
            stack[++top] = (struct parabola){x, from};
        }
    }
    for (int32_t x = width - 1; x >= 0; x--) {
        while (stack[top].from > x) {
            top--;
        }
        int32_t centre = stack[top].centre;
        int32_t height = centre < 0 || centre == width ? 0 : column[centre];
        distance[x] = sqrtf((float)reach(x, centre, height));
    }
}

bool distance_transform(const uint8_t *mask, int width, int height, float *distance)
{
    size_t cells = (size_t)width * (size_t)height;
    int32_t *column = calloc(cells, sizeof *column);
    struct parabola *stack = malloc(((size_t)width + 2) * sizeof *stack);
    bool done = column && stack;
    if (done) {
        columns(mask, width, height, column);
        for (int y = 0; y < height; y++) {
            row(column + (size_t)y * (size_t)width, width, stack, distance + (size_t)y * (size_t)width);
        }
    }
    free(stack);
    free(column);
    return done;
}
