#include "dendrite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "random.h"

struct dendrite *dendrite_create(const struct lattice *lattice)
{
    struct dendrite *dendrite = calloc(1, sizeof *dendrite);
    if (!dendrite) {
        return NULL;
    }
    size_t bytes = 0;
    dendrite->lattice = lattice;
    dendrite->at = memory_take((size_t)lattice->nodes, sizeof *dendrite->at, &bytes);
    if (!dendrite->at) {
        free(dendrite);
        return NULL;
    }
    memset(dendrite->at, 0xff, (size_t)lattice->nodes * sizeof *dendrite->at);
    return dendrite;
}

void dendrite_destroy(struct dendrite *dendrite)
{
    if (dendrite) {
        free(dendrite->nodes);
        free(dendrite->branches);
        free(dendrite->order);
        free(dendrite->at);
        free(dendrite->endpoints);
        free(dendrite);
    }
}

void dendrite_cut(struct dendrite *dendrite, int level)
{
    int32_t kept = 0; /* levels come one after another */
    while (kept < dendrite->node_count && dendrite->nodes[kept].level < level) {
        kept++;
    }
    for (int32_t i = kept; i < dendrite->node_count; i++) {
        dendrite->at[dendrite->nodes[i].vertex] = -1;
    }
    dendrite->node_count = kept;
    dendrite->branch_count = dendrite->endpoint_count = 0;
}

static bool reserve(void **memory, int32_t *room, int32_t wanted, size_t size)
{
    if (wanted <= *room) {
        return true;
    }
    int32_t more = wanted + wanted / 2 + 1024;
    void *grown = realloc(*memory, (size_t)more * size);
    if (grown) {
        *memory = grown;
        *room = more;
    }
    return grown;
}

/* The way of one endpoint; -1: memory is short. */
static int trace(struct dendrite *dendrite, const int32_t *toward, int32_t endpoint, int level, int32_t longest)
{
    int32_t length = 0, node = endpoint;
    while (node >= 0 && dendrite->at[node] < 0) {
        length++;
        node = toward[node];
    }
    if (node == ROUTES_NONE || (longest > 0 && length > longest)) {
        return 0;
    }
    if (!reserve((void **)&dendrite->nodes, &dendrite->node_room, dendrite->node_count + length,
                 sizeof *dendrite->nodes)) {
        return -1;
    }
    int32_t next = endpoint, last = dendrite->node_count + length - 1;
    for (int32_t i = last; i >= dendrite->node_count; i--) {
        dendrite->nodes[i] = (struct dendrite_node){.vertex = next, .parent = i - 1, .level = (uint8_t)level};
        dendrite->at[next] = i;
        next = toward[next];
    }
    if (length > 0) {
        dendrite->nodes[dendrite->node_count].parent = node >= 0 ? dendrite->at[node] : -1;
    }
    dendrite->node_count += length;
    return 1;
}

bool dendrite_extend(struct dendrite *dendrite, const struct routes *routes, const int32_t *endpoints, int32_t count,
                     int level, int32_t longest)
{
    const int32_t *toward = routes_toward(routes);
    if (!reserve((void **)&dendrite->endpoints, &dendrite->endpoint_room, dendrite->endpoint_count + count,
                 sizeof *dendrite->endpoints)) {
        return false;
    }
    for (int32_t i = 0; i < count; i++) {
        int reached = trace(dendrite, toward, endpoints[i], level, longest);
        if (reached < 0) {
            return false;
        }
        if (reached > 0) {
            dendrite->endpoints[dendrite->endpoint_count++] = endpoints[i];
        }
    }
    return true;
}

/* Of each node: how far the structure goes on beyond it, and through which child of its level */
static void find_heirs(struct dendrite *dendrite, float *beyond, int32_t *heir)
{
    struct dendrite_node *nodes = dendrite->nodes;
    for (int32_t i = 0; i < dendrite->node_count; i++) {
        beyond[i] = 0;
        heir[i] = -1;
        nodes[i].leaves = 0;
    }
    for (int32_t i = dendrite->node_count - 1; i >= 0; i--) {
        int32_t parent = nodes[i].parent;
        nodes[i].leaves += nodes[i].leaves == 0;
        if (parent < 0) {
            continue;
        }
        nodes[parent].leaves += nodes[i].leaves;
        float far = beyond[i] + nodes[i].reach - nodes[parent].reach;
        if (nodes[i].level == nodes[parent].level && (heir[parent] < 0 || far >= beyond[parent])) {
            heir[parent] = i;
        }
        beyond[parent] = far > beyond[parent] ? far : beyond[parent];
    }
}

static void place_nodes(struct dendrite *dendrite)
{
    for (int32_t i = 0; i < dendrite->node_count; i++) {
        struct dendrite_node *node = &dendrite->nodes[i];
        lattice_place(dendrite->lattice, node->vertex, &node->x, &node->y);
        if (node->parent < 0) {
            node->reach = 0;
        } else {
            const struct dendrite_node *parent = &dendrite->nodes[node->parent];
            float dx = node->x - parent->x, dy = node->y - parent->y;
            node->reach = parent->reach + sqrtf(dx * dx + dy * dy);
        }
        node->birth = node->reach;
    }
}

bool dendrite_arrange(struct dendrite *dendrite)
{
    size_t count = (size_t)dendrite->node_count + 1;
    float *beyond = calloc(count, sizeof *beyond);
    int32_t *heir = malloc(count * sizeof *heir);
    struct dendrite_branch *branches = realloc(dendrite->branches, count * sizeof *branches);
    dendrite->branches = branches ? branches : dendrite->branches;
    int32_t *order = realloc(dendrite->order, count * sizeof *order);
    dendrite->order = order ? order : dendrite->order;
    bool good = beyond && heir && branches && order;
    dendrite->branch_count = 0;
    if (good) {
        place_nodes(dendrite);
        find_heirs(dendrite, beyond, heir);
        int32_t placed = 0;
        for (int32_t i = 0; i < dendrite->node_count; i++) {
            int32_t parent = dendrite->nodes[i].parent;
            if (parent >= 0 && heir[parent] == i) {
                continue;
            }
            struct dendrite_branch branch = {.first = placed, .junction = parent, .level = dendrite->nodes[i].level};
            for (int32_t node = i; node >= 0; node = heir[node]) {
                dendrite->nodes[node].branch = dendrite->branch_count;
                order[placed++] = node;
            }
            branch.count = placed - branch.first;
            branches[dendrite->branch_count++] = branch;
        }
    }
    free(beyond);
    free(heir);
    return good;
}

/* One pass over the branches of levels up to `last`. */
static void smooth_once(struct dendrite *dendrite, int last)
{
    struct dendrite_node *nodes = dendrite->nodes;
    for (int32_t b = 0; b < dendrite->branch_count; b++) {
        const struct dendrite_branch *branch = &dendrite->branches[b];
        const int32_t *order = dendrite->order + branch->first;
        float x = 0, y = 0; /* of the node before, unmoved */
        bool moving = branch->junction >= 0;
        if (branch->level > last) {
            continue;
        }
        if (moving) {
            x = nodes[branch->junction].x;
            y = nodes[branch->junction].y;
        }
        for (int32_t i = 0; i + 1 < branch->count; i++) {
            struct dendrite_node *node = &nodes[order[i]];
            const struct dendrite_node *next = &nodes[order[i + 1]];
            float here_x = node->x, here_y = node->y;
            if (moving) {
                node->x = 0.25f * (x + next->x) + 0.5f * here_x;
                node->y = 0.25f * (y + next->y) + 0.5f * here_y;
            }
            x = here_x;
            y = here_y;
            moving = true;
        }
    }
}

void dendrite_smooth(struct dendrite *dendrite, int passes, float jitter, uint32_t seed, int trunk)
{
    struct dendrite_node *nodes = dendrite->nodes;
    for (int32_t i = 0; i < dendrite->node_count && jitter > 0; i++) {
        nodes[i].x += jitter * random_signed(nodes[i].vertex, 0, seed, RANDOM_PLACE);
        nodes[i].y += jitter * random_signed(nodes[i].vertex, 1, seed, RANDOM_PLACE);
    }
    for (int pass = 0; pass < trunk; pass++) {
        smooth_once(dendrite, 0);
    }
    for (int pass = 0; pass < passes; pass++) {
        smooth_once(dendrite, UINT8_MAX);
    }
}
