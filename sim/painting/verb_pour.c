/* Fresh ground over what has grown (figure 14). */
#include "painting_verb.h"
#include "verb_keys.h"

#define RING_WIDTH 2.0f /* cells around a poured disc whose carved pattern comes alive again */
#define RING_SEED  0.3f

static const struct key POUR[] = {
    AT(true, "Middle of the disc."),
    RADIUS(30, "Radius of the disc."),
    END,
};

static void free_cell(struct ground *ground, const struct region *region, int x, int y)
{
    if (region_distance(region, x, y, NULL) <= region->radius) {
        ground_obstacle(ground, y)[x] &= (uint8_t)~OBSTACLE_LINE;
    }
}

static struct rectangle pour(struct ground *ground, const struct action *action)
{
    return ground_each_cell(ground, action, free_cell);
}

static struct rectangle bounds(struct deposit *deposit)
{
    struct action wider = deposit->action;
    wider.radius += RING_WIDTH;
    return region_of(&deposit->region.canvas, &wider).cells;
}

static float cover(struct deposit *deposit, int x, int y, float *seed)
{
    float distance = region_distance(&deposit->region, x, y, NULL), radius = deposit->action.radius;
    *seed = distance > radius && distance <= radius + RING_WIDTH ? RING_SEED : 0.0f;
    return distance <= radius ? 1.0f : 0.0f;
}

const struct verb verb_pour = {
    .name = "pour",
    .meaning = "Fresh white ground over what has grown, which grows back inwards.",
    .keys = POUR,
    .scene = SCENE_PAINTING,
    .painting =
        &(const struct painting_verb){
            .ground = pour, .law = DEPOSIT_FRESH, .bounds = bounds, .cover = cover, .crosses = true},
};
