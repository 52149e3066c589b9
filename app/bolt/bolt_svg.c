/* A path for each branch: its outline, filled, and its widths beside it for those who draw with a pen. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bolt_order.h"
#include "bolt_text.h"
#include "ink.h"

struct fill {
    char text[8];
};

static struct fill fill_of(const float *linear)
{
    struct fill fill;
    unsigned part[3];
    for (int c = 0; c < 3; c++) {
        float value = ink_encode(linear[c]);
        part[c] = value <= 0 ? 0 : value >= 1 ? 255 : (unsigned)(255 * value + 0.5f);
    }
    snprintf(fill.text, sizeof fill.text, "#%02x%02x%02x", part[0] & 255u, part[1] & 255u, part[2] & 255u);
    return fill;
}

struct place {
    float x, y, radius;
};

/* One side of a branch, its places moved across by their radii. */
static void put_side(struct bolt_text *text, const struct place *places, int32_t count, bool back)
{
    for (int32_t k = 0; k < count; k++) {
        int32_t i = back ? count - 1 - k : k;
        const struct place *a = &places[i > 0 ? i - 1 : 0], *b = &places[i + 1 < count ? i + 1 : i];
        float dx = b->x - a->x, dy = b->y - a->y, length = sqrtf(dx * dx + dy * dy);
        float side = (back ? -1.0f : 1.0f) * places[i].radius / (length > 1e-6f ? length : 1);
        bolt_text_put(text, "%c%.2f %.2f", k == 0 && !back ? 'M' : 'L', (double)(places[i].x - dy * side),
                      (double)(places[i].y + dx * side));
    }
}

struct branch {
    int32_t first;
    float depth;
};

static int farther_first(const void *a, const void *b)
{
    const struct branch *one = a, *other = b;
    if (one->depth != other->depth) {
        return one->depth > other->depth ? -1 : 1;
    }
    return one->first < other->first ? -1 : 1;
}

/* Far is towards the ground's colour, hot towards the core's. */
static void colour_of(const struct bolt_result *result, const struct bolt_node *node, float *rgb)
{
    const struct bolt_look *look = &result->order->bolt.look;
    float heat = look->style == BOLT_GLOW ? node->heat * node->heat : 0;
    float far = node->at[2] / (float)result->order->height;
    far = look->style == BOLT_BODY ? 0.3f + far : 0;
    far = far < 0 ? 0 : far > 0.7f ? 0.7f : far;
    for (int c = 0; c < 3; c++) {
        rgb[c] = look->colour[c] + heat * (look->core[c] - look->colour[c]);
        rgb[c] += far * 0.7f * (look->ground[c] - rgb[c]);
    }
}

static void put_branch(struct bolt_text *text, const struct bolt_result *result, int32_t first, struct place *places)
{
    const struct bolt_node *nodes = result->shape.nodes, *parent = &nodes[nodes[first].parent];
    int32_t count = 0;
    float colour[3];
    places[count++] = (struct place){parent->at[0], parent->at[1], bolt_shape_root(&result->shape, first)};
    for (int32_t i = first; i >= 0; i = nodes[i].heaviest) {
        places[count++] = (struct place){nodes[i].at[0], nodes[i].at[1], nodes[i].radius};
    }
    colour_of(result, &nodes[first], colour);
    bolt_text_put(text, "<path class=\"branch\" fill=\"%s\" data-tips=\"%d\" data-width=\"%.2f %.2f\" d=\"",
                  fill_of(colour).text, nodes[first].tips, (double)(2 * places[0].radius),
                  (double)(2 * places[count - 1].radius));
    put_side(text, places, count, false);
    put_side(text, places, count, true);
    bolt_text_put(text, "Z\"/>\n");
}

static void put_leaf(struct bolt_text *text, const struct bolt_result *result, int32_t node, float size)
{
    const struct bolt_node *here = &result->shape.nodes[node], *parent = &result->shape.nodes[here->parent];
    float dx = here->at[0] - parent->at[0], dy = here->at[1] - parent->at[1], length = sqrtf(dx * dx + dy * dy);
    dx *= size / (length > 1e-6f ? length : 1);
    dy *= size / (length > 1e-6f ? length : 1);
    bolt_text_put(text,
                  "<path class=\"leaf\" fill=\"%s\" d=\"M%.2f %.2fq%.2f %.2f %.2f %.2fq%.2f %.2f %.2f %.2fZ\"/>\n",
                  fill_of(result->order->bolt.look.core).text, (double)here->at[0], (double)here->at[1],
                  (double)(dx - dy), (double)(dy + dx), (double)(2 * dx), (double)(2 * dy), (double)(-dx + dy),
                  (double)(-dy - dx), (double)(-2 * dx), (double)(-2 * dy));
}

static void put_all(struct bolt_text *text, const struct bolt_result *result, struct branch *branches,
                    struct place *places)
{
    const struct bolt_shape *shape = &result->shape;
    int32_t count = 0;
    for (int32_t i = 0; i < shape->count; i++) {
        if (bolt_shape_begins(shape, i)) {
            branches[count++] = (struct branch){i, shape->nodes[i].at[2]};
        }
    }
    qsort(branches, (size_t)count, sizeof *branches, farther_first);
    for (int32_t i = 0; i < count; i++) {
        put_branch(text, result, branches[i].first, places);
    }
    for (int32_t i = 0; i < shape->count; i++) {
        float size = bolt_shape_leaf(shape, i, &result->order->bolt.look);
        if (size > 0) {
            put_leaf(text, result, i, size);
        }
    }
}

bool bolt_write_svg(const struct bolt_result *result, const char *path, struct file_error *error)
{
    const struct bolt_order *order = result->order;
    size_t room = (size_t)result->shape.count + 1;
    struct branch *branches = malloc(room * sizeof *branches);
    struct place *places = malloc(room * sizeof *places);
    struct bolt_text text = {.failed = !branches || !places};
    bool glows = order->bolt.look.style == BOLT_GLOW;
    bolt_text_put(&text,
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">\n",
                  order->width, order->height, order->width, order->height);
    if (glows) {
        bolt_text_put(&text,
                      "<defs><filter id=\"glow\" x=\"-20%%\" y=\"-20%%\" width=\"140%%\" height=\"140%%\">"
                      "<feGaussianBlur stdDeviation=\"%.2f\"/></filter></defs>\n",
                      (double)(2 * order->bolt.look.trunk));
    }
    bolt_text_put(&text, "<rect width=\"100%%\" height=\"100%%\" fill=\"%s\"/>\n",
                  fill_of(order->bolt.look.ground).text);
    for (int layer = glows ? 0 : 1; layer < 2; layer++) {
        bolt_text_put(&text, layer == 0 ? "<g id=\"glow-layer\" filter=\"url(#glow)\">\n" : "<g id=\"branches\">\n");
        if (!text.failed) {
            put_all(&text, result, branches, places);
        }
        bolt_text_put(&text, "</g>\n");
    }
    bolt_text_put(&text, "</svg>\n");
    free(branches);
    free(places);
    return bolt_text_write(&text, path, error);
}
