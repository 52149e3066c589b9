/* Strokes as samples. */
#include "bolt_light_work.h"

#include <math.h>

/* At a sample: how far from the stroke's axis, radius there, how far along it. */
struct place {
    float x, y;   /* from the axis */
    float square; /* of the distance */
    float radius, along;
};

static struct place place_of(const struct bolt_stroke *stroke, float x, float y)
{
    struct place place;
    x -= stroke->at[0];
    y -= stroke->at[1];
    float t = (x * stroke->along[0] + y * stroke->along[1]) * stroke->shrink;
    t = t > 0 ? t < 1 ? t : 1 : 0;
    place.x = x - t * stroke->along[0];
    place.y = y - t * stroke->along[1];
    place.square = place.x * place.x + place.y * place.y;
    place.radius = stroke->radius[0] + t * (stroke->radius[1] - stroke->radius[0]);
    if (stroke->leaf) { /* broadest at two fifths */
        float bend = t * (1.4f - 0.4f * t);
        place.radius *= 4 * bend * (1 - bend);
    }
    place.along = t;
    return place;
}

static float clamped(float value)
{
    return value > 0 ? value < 1 ? value : 1 : 0;
}

static uint8_t byte(float value)
{
    return (uint8_t)(255 * clamped(value) + 0.5f);
}

static void most(uint8_t *into, uint8_t value)
{
    *into = value > *into ? value : *into;
}

/* Of a line of so wide a radius, at a distance from its axis: what is thinner than a sample covers less of it. */
static float cover(float distance, float radius)
{
    float wide = radius > 0.5f ? radius : 0.5f;
    return clamped(wide + 0.5f - distance) * clamped(2 * radius);
}

/* Brightest on the axis. */
static void draw_light(const struct bolt_stroke *stroke, struct bolt_sample *sample, const struct place *place)
{
    float distance = sqrtf(place->square), wide = place->radius > 1 ? place->radius : 1;
    float share = distance / wide,
          light = stroke->strength * cover(distance, place->radius) * (1 - 0.6f * share * share);
    if (light > 0) {
        most(&sample->part[0], byte(sqrtf(light)));
        most(&sample->part[1], byte(light));
    }
}

static void draw_line(const struct bolt_stroke *stroke, struct bolt_sample *sample, const struct place *place)
{
    float distance = sqrtf(place->square), own = stroke->strength * cover(distance, place->radius);
    if (own > 0) {
        float wide = clamped((place->radius - 1) / 3),
              share = wide > 0 ? clamped(1.7f - 1.9f * distance / place->radius) : 0;
        most(&sample->part[0], byte(own));
        most(&sample->part[1], byte(stroke->leaf ? own : own * wide * share));
    }
}

static void draw_body(const struct bolt_samples *samples, const struct bolt_stroke *stroke, size_t index,
                      const struct place *place)
{
    float depth = stroke->depth[0] + place->along * (stroke->depth[1] - stroke->depth[0]), normal[2];
    if (stroke->leaf) {
        float bent = sqrtf(place->square) / place->radius * 0.3f; /* it is a little hollow */
        float face = stroke->normal[2] < -0.2f ? stroke->normal[2] : -0.2f;
        depth -= (stroke->normal[0] * place->x + stroke->normal[1] * place->y) / face * stroke->thick;
        normal[0] = stroke->normal[0] * (1 - bent);
        normal[1] = stroke->normal[1] * (1 - bent);
    } else {
        depth -= sqrtf(place->radius * place->radius - place->square) * stroke->thick;
        normal[0] = place->x / place->radius;
        normal[1] = place->y / place->radius;
    }
    uint16_t deep = (uint16_t)(65534 * clamped(depth) + 0.5f);
    if (deep >= samples->depth[index]) {
        return;
    }
    float light = stroke->strength * 126;
    samples->depth[index] = deep;
    samples->samples[index].part[0] = byte((normal[0] + 1) * 127 / 255);
    samples->samples[index].part[1] = byte((normal[1] + 1) * 127 / 255);
    samples->samples[index].part[2] = byte(stroke->tone);
    samples->samples[index].part[3] = (uint8_t)((stroke->leaf ? 128 : 1) + (int)(light + 0.5f));
}

static void draw_span(const struct bolt_samples *samples, const struct bolt_stroke *stroke, int y, const int columns[2])
{
    float soft = samples->style == BOLT_BODY ? 0 : 0.5f;
    for (int x = columns[0]; x < columns[1]; x++) {
        struct place place = place_of(stroke, (float)x + 0.5f, (float)y + 0.5f);
        float reach = (samples->style == BOLT_BODY || place.radius > 0.5f ? place.radius : 0.5f) + soft;
        size_t index = (size_t)y * (size_t)samples->width + (size_t)x;
        if (!(place.square < reach * reach)) {
            continue;
        }
        if (samples->style == BOLT_BODY) {
            draw_body(samples, stroke, index, &place);
        } else if (samples->style == BOLT_LINE) {
            draw_line(stroke, &samples->samples[index], &place);
        } else {
            draw_light(stroke, &samples->samples[index], &place);
        }
    }
}

/* Whole samples from `low` to `high`, of those that there are. */
static void within(float low, float high, int count, int range[2])
{
    range[0] = low > 0 ? low < (float)count ? (int)low : count : 0;
    range[1] = high < (float)count ? high > 0 ? (int)high + 1 : 0 : count;
    range[1] = range[1] > count ? count : range[1];
}

void bolt_draw(const struct bolt_samples *samples, const struct bolt_stroke *stroke)
{
    float reach = fmaxf(fmaxf(stroke->radius[0], stroke->radius[1]), 0.5f) + 1;
    float left = fminf(0, stroke->along[0]) + stroke->at[0], right = fmaxf(0, stroke->along[0]) + stroke->at[0];
    float top = fminf(0, stroke->along[1]) + stroke->at[1], bottom = fmaxf(0, stroke->along[1]) + stroke->at[1];
    float length = sqrtf(stroke->along[0] * stroke->along[0] + stroke->along[1] * stroke->along[1]);
    bool slanted = length > 8 && fabsf(stroke->along[1]) > 0.1f * length;
    float lean = slanted ? stroke->along[0] / stroke->along[1] : 0;
    float half = slanted ? reach * length / fabsf(stroke->along[1]) : 0;
    int rows[2], columns[2];
    within(top - reach, bottom + reach, samples->height, rows);
    for (int y = rows[0]; y < rows[1]; y++) {
        float low = left - reach, high = right + reach, middle = (float)y + 0.5f;
        if (slanted) {
            float axis = stroke->at[0] + lean * (middle - stroke->at[1]);
            low = fmaxf(low, axis - half);
            high = fminf(high, axis + half);
        }
        within(low, high, samples->width, columns);
        draw_span(samples, stroke, y, columns);
    }
}
