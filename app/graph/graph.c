#include "graph.h"

#include <string.h>

const char *const graph_port_names[PORTS + 1] = {"guide",  "mask",       "coefficient", "ink",
                                                 "relief", "background", "picture",     "outline",
                                                 "style",  "seeds",      "orientation", NULL};
const char *const graph_reading_names[] = {"as it is", "towards dark", "along edges", NULL};

const struct graph_port_type graph_ports[PORTS] = {
    [PORT_GUIDE] = {SCENE_PAINTING, 2, ACTION_GUIDE, "growth follows it"},
    [PORT_MASK] = {SCENE_PAINTING, 1, ACTION_MASK, "growth keeps to it"},
    [PORT_COEFFICIENT] = {SCENE_PAINTING, 1, ACTION_SET, "a coefficient varies by it"},
    [PORT_INK] = {SCENE_PAINTING, 1, ACTION_DRAW, "it is drawn in dry ink"},
    [PORT_RELIEF] = {SCENE_PAINTING, 1, ACTION_SET, "growth is lush on it"},
    [PORT_BACKGROUND] = {SCENE_PAINTING, 1, ACTION_DRAW, "it lies under everything as a pale wash"},
    [PORT_PICTURE] = {SCENE_TREES, 1, ACTION_STOCK, "trees grow over it"},
    [PORT_OUTLINE] = {SCENE_LIGHTNING, 1, ACTION_STRIKE, "bolts grow from its edges"},
    [PORT_STYLE] = {SCENE_CHEMISTRY, 1, ACTION_STYLE, "chemicals react by its brightness"},
    [PORT_SEEDS] = {SCENE_CHEMISTRY, 1, ACTION_DOSE, "the reaction starts on it"},
    [PORT_ORIENTATION] = {SCENE_CHEMISTRY, 2, ACTION_GUIDE, "chemicals spread along it"},
};

int graph_add(struct graph *graph, const char *name, enum scene_kind kind)
{
    if (graph->node_count >= GRAPH_NODES) {
        return -1;
    }
    graph->nodes[graph->node_count] = (struct graph_node){name, kind};
    return graph->node_count++;
}

bool graph_connect(struct graph *graph, const struct graph_edge *edge)
{
    if (graph->edge_count >= GRAPH_EDGES) {
        return false;
    }
    graph->edges[graph->edge_count++] = *edge;
    return true;
}

static const char *type_name(int channels)
{
    return channels == 1 ? "a scalar" : "a vector";
}

static const char *name_of(const struct graph *graph, int node)
{
    return graph->nodes[node].name ? graph->nodes[node].name : "";
}

static bool refuse(struct graph_wrong *wrong, const char *key)
{
    wrong->key = key;
    return false;
}

/* "guide, mask": the ports of a kind of scene. */
static void list_ports(enum scene_kind kind, char *text, size_t size)
{
    size_t length = 0;
    text[0] = '\0';
    for (int i = 0; i < PORTS && length < size; i++) {
        if (graph_ports[i].kind == kind) {
            length +=
                (size_t)snprintf(text + length, size - length, "%s%s", length > 0 ? ", " : "", graph_port_names[i]);
        }
    }
}

bool graph_check(const struct graph *graph, const struct graph_edge *edge, struct graph_wrong *wrong)
{
    const struct graph_port_type *port = &graph_ports[edge->as];
    enum scene_kind kind = graph->nodes[edge->to].kind;
    const char *of = scene_field_names[edge->of], *as = graph_port_names[edge->as];
    int given = scene_field_channels((enum scene_field)edge->of);
    if (edge->from == edge->to) {
        snprintf(wrong->text, sizeof wrong->text, "'%s' is this scene itself; another scene", name_of(graph, edge->to));
        return refuse(wrong, "from");
    }
    if (port->kind != kind) {
        char ports[300];
        list_ports(kind, ports, sizeof ports);
        snprintf(wrong->text, sizeof wrong->text, "'%s' is for scenes of kind %s, and '%s' is of kind %s; one of %s",
                 as, scene_kind_names[port->kind], name_of(graph, edge->to), scene_kind_names[kind], ports);
        return refuse(wrong, "as");
    }
    bool turned = edge->reading != GRAPH_AS_IT_IS;
    if (turned && (given == 2 || port->channels == 1)) {
        snprintf(wrong->text, sizeof wrong->text, "'%s' makes a vector of a scalar, and '%s' %s %s; no reading",
                 graph_reading_names[edge->reading], given == 2 ? of : as, given == 2 ? "is already" : "takes",
                 type_name(given == 2 ? given : port->channels));
        return refuse(wrong, "reading");
    }
    if (given != port->channels && !turned) {
        snprintf(wrong->text, sizeof wrong->text, "'%s' is %s, and '%s' takes %s; %s", of, type_name(given), as,
                 type_name(port->channels),
                 given == 1 ? "of: along, or a reading: towards dark, or along edges" : "of: dark, or of: around");
        return refuse(wrong, "of");
    }
    return true;
}

/* Whether all that feeds a node is in the order already. */
static bool is_ready(const struct graph *graph, int node, const bool *done)
{
    for (int i = 0; i < graph->edge_count; i++) {
        if (graph->edges[i].to == node && !done[graph->edges[i].from]) {
            return false;
        }
    }
    return true;
}

/* What feeds a node and is not in the order: there is one for each that is not. */
static int feeder(const struct graph *graph, int node, const bool *done)
{
    for (int i = 0; i < graph->edge_count; i++) {
        if (graph->edges[i].to == node && !done[graph->edges[i].from]) {
            return graph->edges[i].from;
        }
    }
    return node;
}

/* Against the arrows from any node that is not in the order one comes round; then along them. */
static void tell_cycle(const struct graph *graph, const bool *done, char *text, size_t size)
{
    int node = 0, path[GRAPH_NODES + 1], count = 0;
    size_t length = 0;
    while (done[node]) {
        node++;
    }
    for (int i = 0; i < graph->node_count; i++) { /* into the cycle, wherever it began */
        node = feeder(graph, node, done);
    }
    int first = node;
    for (int at = feeder(graph, node, done); at != node; at = feeder(graph, at, done)) {
        first = at < first ? at : first;
    }
    path[count++] = first;
    for (int at = feeder(graph, first, done); at != first && count < GRAPH_NODES; at = feeder(graph, at, done)) {
        path[count++] = at;
    }
    path[count++] = first;
    for (int i = count - 1; i >= 0 && length < size; i--) {
        length += (size_t)snprintf(text + length, size - length, "%s%s", name_of(graph, path[i]), i > 0 ? " -> " : "");
    }
}

bool graph_order(const struct graph *graph, int order[GRAPH_NODES], int *count, char *text, size_t size)
{
    bool done[GRAPH_NODES] = {false}, found = true;
    *count = 0;
    while (found) {
        found = false;
        for (int i = 0; i < graph->node_count && !found; i++) {
            found = !done[i] && is_ready(graph, i, done);
            if (found) {
                done[i] = true;
                order[(*count)++] = i;
            }
        }
    }
    if (*count < graph->node_count) {
        tell_cycle(graph, done, text, size);
        return false;
    }
    return true;
}
