/* The guidance field (eq. 16). */
#include "painting_verb.h"

#include <math.h>

#include "verb_keys.h"

static const char *const READINGS[] = {"towards dark", "along edges", "vectors", NULL};

static const struct key GUIDE[] = {
    PATH(false),
    FORMULA("Two expressions in x and y: the field."),
    PICTURE("A picture to take the field from."),
    CHOICE(reading, READINGS, READ_TOWARDS_DARK, "How a picture becomes a field."),
    RADIUS(30, "Half the width of the stroke; it fades to nothing there."),
    NUMBER(strength, "", -3, 3, 1, "Length of the field; negative turns it round; 0 wipes it."),
    END,
};

static int16_t guide_unit(float value)
{
    value = value < -3.9f ? -3.9f : value > 3.9f ? 3.9f : value;
    return (int16_t)floorf(value / UNIT_GUIDE + 0.5f);
}

static void guide_cell(struct ground *ground, const struct region *region, int x, int y)
{
    float strength = region->action->strength, share = 1.0f;
    struct point v = {0.0f, 0.0f};
    if (region->kind == REGION_RASTER && region->raster->channels == 2) {
        v.x = region_sample(&region->canvas, region->raster, 0, x, y);
        v.y = region_sample(&region->canvas, region->raster, 1, x, y);
    } else if (region->kind == REGION_STROKE) {
        float distance = region_distance(region, x, y, &v) / region->radius;
        share = distance < 1.0f ? (1.0f - distance * distance) * (1.0f - distance * distance) : 0.0f;
    }
    int16_t *guide_x = ground_guide(ground, 0, y) + x, *guide_y = ground_guide(ground, 1, y) + x;
    float old_x = (float)*guide_x * UNIT_GUIDE, old_y = (float)*guide_y * UNIT_GUIDE;
    *guide_x = guide_unit(old_x + share * (strength * v.x - old_x));
    *guide_y = guide_unit(old_y + share * (strength * v.y - old_y));
}

static struct rectangle guide(struct ground *ground, const struct action *action)
{
    return ground_each_cell(ground, action, guide_cell);
}

const struct verb verb_guide = {
    .name = "guide",
    .meaning = "A field that growth follows.",
    .keys = GUIDE,
    .scene = SCENE_PAINTING,
    .needs_place = true,
    .painting = &(const struct painting_verb){.ground = guide, .mark = MARK_GROUND},
};
