/* `inputs` of scenes: what one takes from another, as a graph (graph.h) whose types are checked. */
#include <string.h>

#include "exhibit_read.h"
#include "file_rows.h"
#include "script_session.h"

enum { ID_BYTES = 40, TICKS = 20000, TICKS_INITIAL = 600 };

#define FEED struct exhibit_feed
const struct key scene_feed_keys[] = {
    TEXT("from", FEED, id, "the id of a scene", ID_BYTES, true,
         "The scene that it comes from: what has just been made in it on this sheet, else what it grows by itself."),
    FIELD_KEY(offsetof(FEED, of)),
    CHOICE("as", FEED, as, graph_port_names, PORT_GUIDE, true,
           "What it becomes: of a painting guide (a vector), mask, coefficient, ink, relief or background, of trees "
           "picture, of lightning outline, of chemistry style, seeds or orientation (a vector)."),
    CHOICE("reading", FEED, reading, graph_reading_names, GRAPH_AS_IT_IS, false, "How a scalar becomes a vector."),
    {.name = "coefficient",
     .type = KEY_COEFFICIENT,
     .unit = "",
     .offset = offsetof(FEED, coefficient),
     .meaning = "Which one varies by it."},
    NUMBER("value", FEED, value, "as the coefficient", -1000000, 1000000, 0, false,
           "The coefficient where the other scene has grown."),
    NUMBER("to", FEED, to, "as the coefficient", -1000000, 1000000, 0, false, "The coefficient where it has not."),
    {.name = "ink",
     .type = KEY_INK,
     .unit = "",
     .initial = -1,
     .offset = offsetof(FEED, ink),
     .meaning = "The ink of a drawing or a background; the first of a drawing, the last of a background if left out."},
    NUMBER("strength", FEED, strength, "share", 0, 1, 0.7, false,
           "Length of a field, darkness of a drawing, how much sparser growth is elsewhere, contrast of a picture; "
           "nothing of a mask."),
    WHOLE("tick", FEED, tick, "ticks", 1, TICKS, TICKS_INITIAL, false,
          "How long the other scene grows by itself, where nobody has just made it on this sheet."),
    FLAG("invert", FEED, invert, 0, "Whether dark and light change places; of a vector, forward and back."),
    END,
};

/* `value` and `to` in the range of what they set. */
static void check_coefficient(struct reader *reader, const struct yaml_node *item, const struct exhibit_feed *feed)
{
    static const char *const NAMES[] = {"coefficient", "value", "to"};
    char allowed[400];
    const struct key *key = &coefficient_keys[feed->coefficient > 0 ? feed->coefficient : 0];
    for (int i = 0; i < 3; i++) {
        const struct yaml_node *given = yaml_get(item, NAMES[i]);
        bool wanted = feed->as == PORT_COEFFICIENT;
        float number = i == 1 ? feed->value : feed->to;
        if (wanted && !given) {
            exhibit_problem(reader, NAMES[i], item, "missing; %s",
                            i == 0                          ? "the name of a coefficient"
                            : yaml_get(item, "coefficient") ? value_allowed(key, allowed, sizeof allowed)
                                                            : "a number, as of the coefficient");
        } else if (!wanted && given) {
            exhibit_problem(reader, NAMES[i], given, "of '%s'; as: coefficient, or no %s", graph_port_names[feed->as],
                            NAMES[i]);
        } else if (wanted && i > 0 && yaml_get(item, "coefficient") &&
                   !((double)number >= key->min && (double)number <= key->max)) {
            exhibit_problem(reader, NAMES[i], given, "%g is out of range; %s", (double)number,
                            value_allowed(key, allowed, sizeof allowed));
        }
    }
}

static void read_feed(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct exhibit_scene *scene = context;
    struct exhibit_feed *feed = &scene->feeds[index];
    int before = reader->report->count + reader->report->dropped;
    if (!exhibit_item(reader, item, scene_feed_keys, feed, "{from: SCENE, of: dark, as: mask}")) {
        return;
    }
    const struct yaml_node *ink = yaml_get(item, "ink");
    if (reader->report->count + reader->report->dropped == before) {
        check_coefficient(reader, item, feed);
    }
    if (ink && feed->as != PORT_INK && feed->as != PORT_BACKGROUND) {
        exhibit_problem(reader, "ink", ink, "of '%s'; as: ink, as: background, or no ink", graph_port_names[feed->as]);
    }
    feed->line = item->line;
    feed->column = item->column;
    scene->feed_count = index + 1;
}

void exhibit_read_feeds(struct reader *reader, const struct yaml_node *item, struct exhibit_scene *scene)
{
    inputs_list(reader, item, "inputs", EXHIBIT_FEEDS, "a list of {from: SCENE, of: dark, as: mask}", read_feed, scene);
}

bool exhibit_is_fed(const struct yaml_node *item, enum graph_port port)
{
    const struct yaml_node *list = yaml_get(item, "inputs");
    bool fed = false;
    for (const struct yaml_node *one = list && list->kind == YAML_LIST ? list->first : NULL; one; one = one->next) {
        const struct yaml_node *as = one->kind == YAML_MAPPING ? yaml_get(one, "as") : NULL;
        fed = fed || (as && as->kind == YAML_SCALAR && strcmp(as->text, graph_port_names[port]) == 0);
    }
    return fed;
}

struct graph exhibit_graph(const struct exhibit *exhibit)
{
    struct graph graph = {.node_count = 0};
    for (int i = 0; i < exhibit->scene_count; i++) {
        graph_add(&graph, exhibit->scenes[i].id, (enum scene_kind)exhibit->scenes[i].kind);
    }
    for (int i = 0; i < exhibit->scene_count; i++) {
        for (int k = 0; k < exhibit->scenes[i].feed_count; k++) {
            const struct exhibit_feed *feed = &exhibit->scenes[i].feeds[k];
            graph_connect(&graph, &(struct graph_edge){feed->from, i, feed->of, feed->as, feed->reading});
        }
    }
    return graph;
}

/* The scenes that there are, while they are looked up. */
struct checking {
    struct exhibit *exhibit;
    struct graph graph;
    int scene;
};

/* The input that closes a circle is the one that is wrong. */
static void connect(struct reader *reader, const struct yaml_node *from, const struct graph_edge *edge,
                    struct graph *graph)
{
    int order[GRAPH_NODES], count;
    char text[GRAPH_TEXT];
    graph_connect(graph, edge);
    if (!graph_order(graph, order, &count, text, sizeof text)) {
        graph->edge_count--;
        exhibit_problem(reader, "from", from, "closes a circle, %s; a scene that is not fed by this one", text);
    }
}

static void check_feed(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct checking *checking = context;
    struct exhibit_feed *feed = &checking->exhibit->scenes[checking->scene].feeds[index];
    const struct yaml_node *from = yaml_get(item, "from");
    struct names ids = {.count = 0};
    struct graph_wrong wrong;
    for (int i = 0; i < checking->exhibit->scene_count; i++) {
        const char *id = checking->exhibit->scenes[i].id;
        ids.names[ids.count++] = id ? id : "";
    }
    size_t length = reader_enter(reader, "from");
    bool known = value_choice(reader, &ids, "scene", from, &feed->from);
    reader_leave(reader, length);
    if (!known) {
        return;
    }
    struct graph_edge edge = {feed->from, checking->scene, feed->of, feed->as, feed->reading};
    if (graph_check(&checking->graph, &edge, &wrong)) {
        connect(reader, from, &edge, &checking->graph);
    } else {
        const struct yaml_node *at = yaml_get(item, wrong.key);
        exhibit_problem(reader, wrong.key, at ? at : item, "%s", wrong.text);
    }
}

void exhibit_check_feeds(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit)
{
    const struct yaml_node *list = yaml_get(root, "scenes");
    struct checking checking = {.exhibit = exhibit};
    int fed = 0, index = 0;
    for (int i = 0; i < exhibit->scene_count; i++) {
        graph_add(&checking.graph, exhibit->scenes[i].id, (enum scene_kind)exhibit->scenes[i].kind);
        fed += exhibit->scenes[i].feed_count;
    }
    if (fed == 0 || !report_empty(reader->report) || !list) {
        return; /* what is wrong with the scenes comes first */
    }
    size_t length = reader_enter(reader, "scenes");
    for (const struct yaml_node *item = list->first; item; item = item->next, index++) {
        size_t outer = reader_enter_index(reader, index);
        checking.scene = index;
        inputs_list(reader, item, "inputs", EXHIBIT_FEEDS, "", check_feed, &checking);
        reader_leave(reader, outer);
    }
    reader_leave(reader, length);
}

/* Whether something grows in a scene that nobody comes to: by its opening, a preset's start, or what it is given. */
static bool grows_alone(const struct exhibit_scene *scene)
{
    bool starts = scene->kind == SCENE_CHEMISTRY && scene->options.chemistry.start != DISH_START_NOTHING;
    bool grows = starts || scene->ground_count > scene->opening;
    for (int i = 0; i < scene->feed_count; i++) {
        int as = scene->feeds[i].as;
        grows = grows || as == PORT_INK || as == PORT_BACKGROUND || as == PORT_OUTLINE || as == PORT_SEEDS;
    }
    return grows;
}

void exhibit_warn(const struct exhibit *exhibit, struct report *report)
{
    char key[60];
    for (int i = 0; i < exhibit->scene_count; i++) {
        for (int k = 0; k < exhibit->scenes[i].feed_count; k++) {
            const struct exhibit_feed *feed = &exhibit->scenes[i].feeds[k];
            if (!grows_alone(&exhibit->scenes[feed->from])) {
                snprintf(key, sizeof key, "scenes[%d].inputs[%d].from", i, k);
                report_add(report, feed->line, feed->column, key,
                           "warning: nothing grows by itself in '%s', and nothing is taken from it until somebody has "
                           "made something there; an opening for it",
                           exhibit->scenes[feed->from].id);
            }
        }
    }
}
