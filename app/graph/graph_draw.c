/* The graph as text: boxes and arrows, DOT, JSON. */
#include <string.h>

#include "graph.h"

enum { COLUMN_MOST = 60 };

/* Columns of a UTF-8 text, as far as a terminal of plain letters goes. */
static int columns(const char *text)
{
    int count = 0;
    for (; *text; text++) {
        count += ((unsigned char)*text & 0xc0) != 0x80;
    }
    return count;
}

static void repeat(FILE *out, const char *what, int count)
{
    for (int i = 0; i < count; i++) {
        fputs(what, out);
    }
}

static void draw_box(const struct graph_node *node, FILE *out)
{
    const char *kind = scene_kind_names[node->kind], *name = node->name ? node->name : "";
    int width = columns(name) + (int)strlen(kind) + 4;
    width = width < COLUMN_MOST ? width : COLUMN_MOST;
    fputs("┌", out);
    repeat(out, "─", width);
    fprintf(out, "┐\n│ %s  %s │\n└", name, kind);
    repeat(out, "─", width);
    fputs("┘\n", out);
}

static const char *reading_of(const struct graph_edge *edge)
{
    return edge->reading == GRAPH_AS_IT_IS ? "" : graph_reading_names[edge->reading];
}

static void draw_arrows(const struct graph *graph, int node, FILE *out)
{
    int count = 0, left;
    for (int i = 0; i < graph->edge_count; i++) {
        count += graph->edges[i].from == node;
    }
    left = count;
    for (int i = 0; i < graph->edge_count; i++) {
        const struct graph_edge *edge = &graph->edges[i];
        if (edge->from == node) {
            const char *reading = reading_of(edge), *name = graph->nodes[edge->to].name;
            fprintf(out, "  %s─ %s%s%s ──▶ %s of %s: %s\n", --left > 0 ? "├" : "└", scene_field_names[edge->of],
                    reading[0] ? ", " : "", reading, graph_port_names[edge->as], name ? name : "",
                    graph_ports[edge->as].meaning);
        }
    }
}

void graph_draw(const struct graph *graph, FILE *out)
{
    int order[GRAPH_NODES], count = 0;
    char text[GRAPH_TEXT];
    if (!graph_order(graph, order, &count, text, sizeof text)) {
        fprintf(out, "a cycle: %s\n", text);
        return;
    }
    for (int i = 0; i < count; i++) {
        draw_box(&graph->nodes[order[i]], out);
        draw_arrows(graph, order[i], out);
        if (i + 1 < count) {
            fputs("\n", out);
        }
    }
}

/* In quotes, as DOT and JSON have them both. */
static void quote(FILE *out, const char *text)
{
    fputc('"', out);
    for (; text && *text; text++) {
        if (*text == '"' || *text == '\\') {
            fputc('\\', out);
        }
        if ((unsigned char)*text >= ' ') {
            fputc(*text, out);
        }
    }
    fputc('"', out);
}

void graph_draw_dot(const struct graph *graph, FILE *out)
{
    fputs("digraph exhibit {\n  rankdir = LR;\n  node [shape = box];\n", out);
    for (int i = 0; i < graph->node_count; i++) {
        fputs("  ", out);
        quote(out, graph->nodes[i].name);
        fprintf(out, " [tooltip = \"%s\"];\n", scene_kind_names[graph->nodes[i].kind]);
    }
    for (int i = 0; i < graph->edge_count; i++) {
        const struct graph_edge *edge = &graph->edges[i];
        fputs("  ", out);
        quote(out, graph->nodes[edge->from].name);
        fputs(" -> ", out);
        quote(out, graph->nodes[edge->to].name);
        fprintf(out, " [taillabel = \"%s\", headlabel = \"%s\"", scene_field_names[edge->of],
                graph_port_names[edge->as]);
        if (reading_of(edge)[0]) {
            fprintf(out, ", label = \"%s\"", reading_of(edge));
        }
        fputs("];\n", out);
    }
    fputs("}\n", out);
}

void graph_draw_json(const struct graph *graph, FILE *out)
{
    fputs("{\"scenes\": [", out);
    for (int i = 0; i < graph->node_count; i++) {
        fprintf(out, "%s{\"id\": ", i ? ", " : "");
        quote(out, graph->nodes[i].name);
        fprintf(out, ", \"kind\": \"%s\"}", scene_kind_names[graph->nodes[i].kind]);
    }
    fputs("], \"inputs\": [", out);
    for (int i = 0; i < graph->edge_count; i++) {
        const struct graph_edge *edge = &graph->edges[i];
        fprintf(out, "%s{\"from\": ", i ? ", " : "");
        quote(out, graph->nodes[edge->from].name);
        fputs(", \"to\": ", out);
        quote(out, graph->nodes[edge->to].name);
        fprintf(out, ", \"of\": \"%s\", \"as\": \"%s\", \"reading\": \"%s\"}", scene_field_names[edge->of],
                graph_port_names[edge->as], graph_reading_names[edge->reading]);
    }
    fputs("]}\n", out);
}
