#include "dish_map.h"

#include <math.h>

#include "dish_map_table.h"

/* Apart for colour-blind eyes, too: by lightness. */
const uint8_t dish_map_colours[CLASSES][3] = {
    {48, 52, 68},    /* uniform */
    {250, 206, 88},  /* spots */
    {226, 96, 72},   /* worms */
    {92, 178, 226},  /* holes */
    {126, 214, 150}, /* waves */
};

static float within(float value, float least, float most)
{
    return value >= least ? value <= most ? value : most : least; /* not a number: the least */
}

struct dish_place dish_map_place(struct point at)
{
    float right = within(at.x, 0, 1), up = 1 - within(at.y, 0, 1);
    return (struct dish_place){DISH_MAP_FEED_LEAST + up * (DISH_MAP_FEED_MOST - DISH_MAP_FEED_LEAST),
                               DISH_MAP_KILL_LEAST + right * (DISH_MAP_KILL_MOST - DISH_MAP_KILL_LEAST)};
}

struct point dish_map_at(float feed, float kill)
{
    return (struct point){(kill - DISH_MAP_KILL_LEAST) / (DISH_MAP_KILL_MOST - DISH_MAP_KILL_LEAST),
                          1 - (feed - DISH_MAP_FEED_LEAST) / (DISH_MAP_FEED_MOST - DISH_MAP_FEED_LEAST)};
}

static int class_of(int column, int row)
{
    column = column < 0 ? 0 : column >= DISH_MAP_COLUMNS ? DISH_MAP_COLUMNS - 1 : column;
    row = row < 0 ? 0 : row >= DISH_MAP_ROWS ? DISH_MAP_ROWS - 1 : row;
    return dish_map_classes[row][column] - '0';
}

enum gray_scott_class dish_map_class(float feed, float kill)
{
    struct point at = dish_map_at(feed, kill);
    return (enum gray_scott_class)class_of((int)(within(at.x, 0, 1) * DISH_MAP_COLUMNS),
                                           (int)(within(at.y, 0, 1) * DISH_MAP_ROWS));
}

float dish_map_saddle_node(float feed)
{
    return 0.5f * sqrtf(feed) - feed;
}

bool dish_map_hopf(float kill, float *feed)
{
    float root = sqrtf(kill), inside = kill * (1 - 4 * root);
    *feed = inside >= 0 ? 0.5f * (root - 2 * kill - sqrtf(inside)) : 0;
    return inside >= 0;
}

/* Classes are mixed as colours: quadratic splines, which show no squares. */
static void colour_at(struct point at, float colour[3])
{
    float x = at.x * DISH_MAP_COLUMNS, y = at.y * DISH_MAP_ROWS, fx = floorf(x), fy = floorf(y);
    float right = x - fx - 0.5f, down = y - fy - 0.5f; /* from the middle of the nearest */
    const float across[3] = {0.5f * (0.5f - right) * (0.5f - right), 0.75f - right * right,
                             0.5f * (0.5f + right) * (0.5f + right)};
    const float along[3] = {0.5f * (0.5f - down) * (0.5f - down), 0.75f - down * down,
                            0.5f * (0.5f + down) * (0.5f + down)};
    colour[0] = colour[1] = colour[2] = 0;
    for (int i = 0; i < 9; i++) {
        const uint8_t *own = dish_map_colours[class_of((int)fx + i % 3 - 1, (int)fy + i / 3 - 1)];
        for (int c = 0; c < 3; c++) {
            colour[c] += across[i % 3] * along[i / 3] * (float)own[c];
        }
    }
}

static float shade_of(int x, int y)
{
    x = x < 0 ? 0 : x >= DISH_MAP_WIDE ? DISH_MAP_WIDE - 1 : x;
    y = y < 0 ? 0 : y >= DISH_MAP_HIGH ? DISH_MAP_HIGH - 1 : y;
    return (float)(dish_map_pattern[y][x] - 'a') / (DISH_MAP_SHADES - 1);
}

static float pattern_at(struct point at)
{
    float x = at.x * DISH_MAP_WIDE - 0.5f, y = at.y * DISH_MAP_HIGH - 0.5f, fx = floorf(x), fy = floorf(y);
    int x0 = (int)fx, y0 = (int)fy;
    float top = shade_of(x0, y0) + (x - fx) * (shade_of(x0 + 1, y0) - shade_of(x0, y0));
    float low = shade_of(x0, y0 + 1) + (x - fx) * (shade_of(x0 + 1, y0 + 1) - shade_of(x0, y0 + 1));
    return top + (y - fy) * (low - top);
}

/* How far a place is from where a function of it is 0, in pixels: its value over its slope. */
static float cover(float here, float right, float down)
{
    float dx = right - here, dy = down - here, slope = sqrtf(dx * dx + dy * dy);
    float apart = slope > 0 ? fabsf(here) / slope : 1e9f;
    return within(1.3f - apart, 0, 1);
}

/* 0 on the saddle-node's line; on the Hopf's, which ends. */
static float beyond_saddle(struct dish_place place)
{
    return place.kill - dish_map_saddle_node(place.feed);
}

static float beyond_hopf(struct dish_place place)
{
    float feed;
    return dish_map_hopf(place.kill, &feed) ? place.feed - feed : NAN;
}

static float line_at(float (*beyond)(struct dish_place), struct point at, int width, int height)
{
    struct dish_place right = dish_map_place((struct point){at.x + 1 / (float)width, at.y});
    struct dish_place down = dish_map_place((struct point){at.x, at.y + 1 / (float)height});
    return cover(beyond(dish_map_place(at)), beyond(right), beyond(down));
}

void dish_map_fill(int width, int height, uint8_t *rgb)
{
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++, rgb += 3) {
            struct point at = {((float)x + 0.5f) / (float)width, ((float)y + 0.5f) / (float)height};
            float colour[3], light = 0.42f + 0.7f * pattern_at(at);
            float line = 0.75f * line_at(beyond_saddle, at, width, height);
            float other = 0.45f * line_at(beyond_hopf, at, width, height);
            line = line > other ? line : other;
            colour_at(at, colour);
            for (int c = 0; c < 3; c++) {
                float value = light * colour[c];
                value += line * (245 - value);
                rgb[c] = (uint8_t)within(value + 0.5f, 0, 255);
            }
        }
    }
}
