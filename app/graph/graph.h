/* What feeds what: scenes as nodes, each with ports of its kind, and edges that lead a field of one (scene.h) to a port
 * of another. Types are checked, cycles refused, an order found in which all can be grown. Pure: knows no file, no
 * scene that runs.
 *
 *     graph_add(&graph, "portrait", SCENE_TREES);                    for every scene
 *     graph_check(&graph, &edge, &wrong)                             then for every edge: its types
 *     graph_connect(&graph, &edge);
 *     graph_order(&graph, order, text, size)                         in the end */
#ifndef FROND_GRAPH_H
#define FROND_GRAPH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "action.h"
#include "scene.h"

enum { GRAPH_NODES = 16, GRAPH_EDGES = 128, GRAPH_TEXT = 1000 };

/* Where a field can go. */
enum graph_port {
    PORT_GUIDE,       /* of a painting: a field of vectors that growth follows */
    PORT_MASK,        /* the only place where it grows */
    PORT_COEFFICIENT, /* a coefficient that varies over the sheet */
    PORT_INK,         /* a dry drawing */
    PORT_RELIEF,      /* where it is lush (the coefficient s_max) */
    PORT_BACKGROUND,  /* a pale dry wash that everything runs over */
    PORT_PICTURE,     /* of trees: what they grow over */
    PORT_OUTLINE,     /* of lightning: from whose edges it grows */
    PORT_STYLE,       /* of chemistry: by whose brightness chemicals react */
    PORT_SEEDS,       /* where the reaction starts */
    PORT_ORIENTATION, /* a field of vectors along which chemicals spread */
    PORTS,
};
extern const char *const graph_port_names[PORTS + 1]; /* "guide", ...; ends with NULL */

struct graph_port_type {
    enum scene_kind kind;  /* of the scenes that have it */
    int channels;          /* 1: a scalar, 2: a vector */
    enum action_verb verb; /* what is done to a fresh sheet */
    const char *meaning;   /* for a curator: "growth follows it" */
};
extern const struct graph_port_type graph_ports[PORTS];

/* How a scalar becomes a vector; the first: it does not. */
enum graph_reading { GRAPH_AS_IT_IS, GRAPH_TOWARDS_DARK, GRAPH_ALONG_EDGES };
extern const char *const graph_reading_names[]; /* "as it is", "towards dark", "along edges"; ends with NULL */

struct graph_edge {
    int from, to; /* nodes */
    int of;       /* enum scene_field */
    int as;       /* enum graph_port */
    int reading;  /* enum graph_reading */
};

struct graph {
    struct graph_node {
        const char *name; /* the caller's */
        enum scene_kind kind;
    } nodes[GRAPH_NODES];
    int node_count;
    struct graph_edge edges[GRAPH_EDGES];
    int edge_count;
};

/* The number of the new node; -1: there are GRAPH_NODES. A zeroed graph is empty. */
int graph_add(struct graph *graph, const char *name, enum scene_kind kind);
/* False: there are GRAPH_EDGES. */
bool graph_connect(struct graph *graph, const struct graph_edge *edge);

struct graph_wrong {
    const char *key; /* of the edge that is wrong: "from", "of", "as", "reading" */
    char text[GRAPH_TEXT];
};
/* Whether an edge joins what fits. If not, what is wrong with it, and what is allowed. Nodes exist. */
bool graph_check(const struct graph *graph, const struct graph_edge *edge, struct graph_wrong *wrong);

/* Nodes so that whatever feeds another comes before it; among those that could come, as they were added. False when
 * there is a cycle, with one of them in `text`: "ink -> trees -> ink"; `order` is as far as it goes then. Returns
 * through `count` how many are ordered. */
bool graph_order(const struct graph *graph, int order[GRAPH_NODES], int *count, char *text, size_t size);

/* For people: a box for each node, with arrows to what it feeds. For programs: DOT (Graphviz), JSON. */
void graph_draw(const struct graph *graph, FILE *out);
void graph_draw_dot(const struct graph *graph, FILE *out);
void graph_draw_json(const struct graph *graph, FILE *out);

#endif
