/* A path for each branch: its outline, filled, and its widths beside it for those who draw with a pen. */
#include <math.h>
#include <stdlib.h>

#include "bolt_order.h"
#include "ink.h"
#include "svg.h"

static struct svg_fill fill_of(const float *linear)
{
    const float rgb[3] = {ink_encode(linear[0]), ink_encode(linear[1]), ink_encode(linear[2])};
    return svg_fill(rgb);
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

static void put_branch(struct file_text *text, const struct bolt_result *result, int32_t first,
                       struct svg_place *places)
{
    const struct bolt_node *nodes = result->shape.nodes, *parent = &nodes[nodes[first].parent];
    int32_t count = 0;
    float colour[3];
    places[count++] = (struct svg_place){parent->at[0], parent->at[1], bolt_shape_root(&result->shape, first)};
    for (int32_t i = first; i >= 0; i = nodes[i].heaviest) {
        places[count++] = (struct svg_place){nodes[i].at[0], nodes[i].at[1], nodes[i].radius};
    }
    colour_of(result, &nodes[first], colour);
    file_text_put(text, "<path class=\"branch\" fill=\"%s\" data-tips=\"%d\" data-width=\"%.2f %.2f\" d=\"",
                  fill_of(colour).text, nodes[first].tips, (double)(2 * places[0].radius),
                  (double)(2 * places[count - 1].radius));
    svg_outline(text, places, count);
    file_text_put(text, "\"/>\n");
}

static void put_leaf(struct file_text *text, const struct bolt_result *result, int32_t node, float size)
{
    const struct bolt_node *here = &result->shape.nodes[node], *parent = &result->shape.nodes[here->parent];
    float dx = here->at[0] - parent->at[0], dy = here->at[1] - parent->at[1], length = sqrtf(dx * dx + dy * dy);
    dx *= size / (length > 1e-6f ? length : 1);
    dy *= size / (length > 1e-6f ? length : 1);
    file_text_put(text,
                  "<path class=\"leaf\" fill=\"%s\" d=\"M%.2f %.2fq%.2f %.2f %.2f %.2fq%.2f %.2f %.2f %.2fZ\"/>\n",
                  fill_of(result->order->bolt.look.core).text, (double)here->at[0], (double)here->at[1],
                  (double)(dx - dy), (double)(dy + dx), (double)(2 * dx), (double)(2 * dy), (double)(-dx + dy),
                  (double)(-dy - dx), (double)(-2 * dx), (double)(-2 * dy));
}

static void put_all(struct file_text *text, const struct bolt_result *result, struct branch *branches,
                    struct svg_place *places)
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
    struct svg_place *places = malloc(room * sizeof *places);
    struct file_text text = {.failed = !branches || !places};
    bool glows = order->bolt.look.style == BOLT_GLOW;
    file_text_put(&text,
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">\n",
                  order->width, order->height, order->width, order->height);
    if (glows) {
        file_text_put(&text,
                      "<defs><filter id=\"glow\" x=\"-20%%\" y=\"-20%%\" width=\"140%%\" height=\"140%%\">"
                      "<feGaussianBlur stdDeviation=\"%.2f\"/></filter></defs>\n",
                      (double)(2 * order->bolt.look.trunk));
    }
    file_text_put(&text, "<rect width=\"100%%\" height=\"100%%\" fill=\"%s\"/>\n",
                  fill_of(order->bolt.look.ground).text);
    for (int layer = glows ? 0 : 1; layer < 2; layer++) {
        file_text_put(&text, layer == 0 ? "<g id=\"glow-layer\" filter=\"url(#glow)\">\n" : "<g id=\"branches\">\n");
        if (branches && places) {
            put_all(&text, result, branches, places);
        }
        file_text_put(&text, "</g>\n");
    }
    file_text_put(&text, "</svg>\n");
    free(branches);
    free(places);
    return file_text_write(&text, path, error);
}
