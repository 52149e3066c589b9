#include "reaction_map.h"

#include <math.h>

#include "gray_scott_classes.h"

static const float FEED_MOST = 0.08f, KILL_LEAST = 0.04f, KILL_MOST = 0.075f;

static float into(float share)
{
    return share > 0 ? share < 1 ? share : 1 : 0;
}

struct point reaction_map_place(float feed, float kill)
{
    return (struct point){(kill - KILL_LEAST) / (KILL_MOST - KILL_LEAST), 1 - feed / FEED_MOST};
}

void reaction_map_rates(struct point at, float *feed, float *kill)
{
    *feed = FEED_MOST * (1 - into(at.y));
    *kill = KILL_LEAST + (KILL_MOST - KILL_LEAST) * into(at.x);
}

/* A colour of each class, thinned to that of the state around it the farther its nearest presets are. */
static void shade(float feed, float kill, float colour[3])
{
    static const float CLASS_COLOURS[CLASSES][3] = {[CLASS_UNIFORM] = {0.90f, 0.88f, 0.84f},
                                                    [CLASS_SPOTS] = {0.93f, 0.72f, 0.36f},
                                                    [CLASS_WORMS] = {0.86f, 0.45f, 0.33f},
                                                    [CLASS_HOLES] = {0.36f, 0.60f, 0.68f},
                                                    [CLASS_WAVES] = {0.55f, 0.47f, 0.70f}};
    static const float BLUE[3] = {0.42f, 0.52f, 0.66f}, RED[3] = {0.95f, 0.93f, 0.89f};
    struct gray_scott_def def = gray_scott_default_def();
    struct point at = reaction_map_place(feed, kill);
    float u, v, whole = 0, sum[3] = {0}, nearest = 1;
    def.feed = feed;
    def.kill = kill;
    bool blue = gray_scott_blue_state(&def, &u, &v);
    for (const struct gray_scott_preset *preset = gray_scott_presets; preset->name; preset++) {
        struct point other = reaction_map_place(preset->feed, preset->kill);
        float apart = hypotf(at.x - other.x, at.y - other.y), weight = expf(-apart * apart / 0.003f) + 1e-12f;
        if (preset->is == CLASS_UNIFORM) {
            continue;
        }
        for (int i = 0; i < 3; i++) {
            sum[i] += weight * CLASS_COLOURS[preset->is][i];
        }
        whole += weight;
        nearest = fminf(nearest, apart);
    }
    float here = expf(-nearest * nearest / 0.012f);
    for (int i = 0; i < 3; i++) {
        float around = blue ? BLUE[i] : RED[i];
        colour[i] = around + here * (sum[i] / whole - around);
    }
}

void reaction_map_fill(int width, int height, uint8_t *rgb)
{
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            float colour[3], feed, kill;
            reaction_map_rates((struct point){((float)x + 0.5f) / (float)width, ((float)y + 0.5f) / (float)height},
                               &feed, &kill);
            shade(feed, kill, colour);
            for (int i = 0; i < 3; i++) {
                *rgb++ = (uint8_t)(255 * colour[i] + 0.5f);
            }
        }
    }
}
