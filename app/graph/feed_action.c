#include "feed_action.h"

#include <stdlib.h>
#include <string.h>

#include "raster.h"
#include "rounded.h"

static const float PALE = 0.4f; /* of a drawing's darkness: a background's */

static void turn(float *values, size_t count, bool vectors)
{
    for (size_t i = 0; i < count; i++) {
        values[i] = vectors ? -values[i] : 1 - values[i];
    }
}

/* A scalar as a field of vectors, in place of it. */
static bool read_vectors(const struct outcome *from, int reading, float *values)
{
    size_t cells = (size_t)from->width * (size_t)from->height;
    struct script_picture picture = {from->width, from->height, 1, malloc(cells * sizeof(float))};
    bool good = picture.values;
    if (good) {
        memcpy(picture.values, values, cells * sizeof *values);
        good = raster_from_picture(&picture, reading == GRAPH_ALONG_EDGES ? RASTER_ALONG_EDGES : RASTER_TOWARDS_DARK,
                                   from->width, from->height, values);
    }
    free(picture.values);
    return good;
}

static float *make_values(const struct exhibit_feed *feed, const struct outcome *from, int channels)
{
    size_t cells = (size_t)from->width * (size_t)from->height;
    size_t given = cells * (size_t)scene_field_channels((enum scene_field)feed->of);
    float *values = malloc(cells * (size_t)channels * sizeof *values);
    if (!values) {
        return NULL;
    }
    memcpy(values, from->fields[feed->of], given * sizeof *values);
    if (feed->invert && feed->as != PORT_MASK) { /* a mask has a flag for it */
        turn(values, given, feed->of == FIELD_ALONG);
    }
    if (feed->reading != GRAPH_AS_IT_IS && !read_vectors(from, feed->reading, values)) {
        free(values);
        values = NULL;
    }
    return values;
}

static void fade(float *values, size_t count, float strength)
{
    for (size_t i = 0; i < count; i++) {
        values[i] = rounded(1 - strength * (1 - values[i]));
    }
}

/* Everything but the raster. */
static struct action action_of(const struct exhibit_feed *feed, const struct script *script)
{
    struct action action = action_default(graph_ports[feed->as].verb);
    switch ((enum graph_port)feed->as) {
    case PORT_GUIDE:
    case PORT_SEEDS:
    case PORT_ORIENTATION:
        action.strength = feed->strength;
        break;
    case PORT_MASK:
        action.invert = !feed->invert;
        break;
    case PORT_COEFFICIENT:
        action.coefficient = feed->coefficient;
        action.value = feed->value;
        action.to = feed->to;
        break;
    case PORT_INK:
    case PORT_BACKGROUND:
        action.ink = feed->ink >= 0 ? feed->ink : feed->as == PORT_INK ? 0 : script->ink_count - 1;
        action.amount = feed->as == PORT_INK ? feed->strength : PALE * feed->strength;
        action.over = OVER_RUN;
        break;
    case PORT_RELIEF:
        action.coefficient = (int)(key_find(coefficient_keys, "s_max") - coefficient_keys);
        action.value = script->coefficients.s_max; /* where the raster is dark */
        action.to = script->coefficients.s_max * (1 - feed->strength);
        break;
    default:
        break;
    }
    return action;
}

bool feed_action(const struct exhibit_feed *feed, const struct exhibit_scene *to, const struct outcome *from,
                 struct action *action, float **values)
{
    int channels = graph_ports[feed->as].channels;
    *values = make_values(feed, from, channels);
    if (!*values) {
        return false;
    }
    if (feed->as == PORT_PICTURE || feed->as == PORT_STYLE) {
        fade(*values, (size_t)from->width * (size_t)from->height, feed->strength);
    }
    *action = action_of(feed, to->script);
    action->picture = (struct action_raster){*values, from->width, from->height, channels};
    return true;
}
