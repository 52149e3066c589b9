#define _GNU_SOURCE /* gettid */
#include "live_graph.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#include "feed_action.h"
#include "feeder.h"
#include "hand.h"

enum { NICE = 10 }; /* everything else comes first */

/* The inputs of a scene, as far as they were grown. */
struct grown {
    const struct outcome *from[EXHIBIT_FEEDS]; /* the feeder's */
    atomic_bool done;                          /* the thread leaves it alone from now on */
    bool good;
};

struct given {
    float *rasters[EXHIBIT_FEEDS];
};

struct live_graph {
    struct script_def def;
    const struct exhibit *exhibit;
    struct outcome made[EXHIBIT_SCENES]; /* on the sheet; width 0: nothing yet */
    struct given given[LIVE_GRAPH_KEPT];
    int gave;

    bool running; /* the thread was begun, and not joined */
    pthread_t thread;
    atomic_bool stop;
    struct feeder *feeder; /* the thread's, until a scene is done */
    struct grown grown[EXHIBIT_SCENES];
    char line[400]; /* with the scene that is not good */
    atomic_bool has_line;
};

static void grow_scene(struct live_graph *graph, int index)
{
    const struct exhibit_scene *scene = &graph->exhibit->scenes[index];
    struct grown *grown = &graph->grown[index];
    struct file_error error = {.text = ""};
    grown->good = true;
    for (int i = 0; i < scene->feed_count && grown->good; i++) {
        grown->from[i] = feeder_outcome(graph->feeder, scene->feeds[i].from, scene->feeds[i].tick, &error);
        grown->good = grown->from[i];
    }
    if (!grown->good && !atomic_load(&graph->stop) && !atomic_load(&graph->has_line)) {
        snprintf(graph->line, sizeof graph->line, "scene %.40s is shown without its inputs: %.300s", scene->id,
                 error.text);
        atomic_store(&graph->has_line, true);
    }
    atomic_store(&grown->done, true);
}

static void *grow_all(void *context)
{
    struct live_graph *graph = context;
    struct graph scenes = exhibit_graph(graph->exhibit);
    int order[GRAPH_NODES], count = 0;
    char text[GRAPH_TEXT];
    setpriority(PRIO_PROCESS, (id_t)gettid(), NICE);
    graph_order(&scenes, order, &count, text, sizeof text);
    for (int i = 0; i < count; i++) {
        if (graph->exhibit->scenes[order[i]].feed_count > 0) {
            grow_scene(graph, order[i]);
        }
    }
    return NULL;
}

/* Nothing of an exhibit is left but what was given out. */
static void let_go(struct live_graph *graph)
{
    atomic_store(&graph->stop, true);
    if (graph->running) {
        pthread_join(graph->thread, NULL);
        graph->running = false;
    }
    feeder_destroy(graph->feeder);
    graph->feeder = NULL;
    for (int i = 0; i < EXHIBIT_SCENES; i++) {
        outcome_finish(&graph->made[i]);
        graph->grown[i].good = false;
        atomic_store(&graph->grown[i].done, false);
    }
    graph->exhibit = NULL;
}

struct live_graph *live_graph_create(const struct script_def *def)
{
    struct live_graph *graph = calloc(1, sizeof *graph);
    if (graph) {
        graph->def = *def;
    }
    return graph;
}

void live_graph_destroy(struct live_graph *graph)
{
    if (!graph) {
        return;
    }
    let_go(graph);
    for (int i = 0; i < LIVE_GRAPH_KEPT; i++) {
        for (int k = 0; k < EXHIBIT_FEEDS; k++) {
            free(graph->given[i].rasters[k]);
        }
    }
    free(graph);
}

void live_graph_set(struct live_graph *graph, const struct exhibit *exhibit)
{
    int fed = 0;
    let_go(graph);
    graph->exhibit = exhibit;
    for (int i = 0; i < exhibit->scene_count; i++) {
        fed += exhibit->scenes[i].feed_count;
    }
    if (fed == 0) {
        return;
    }
    atomic_store(&graph->stop, false);
    graph->feeder = feeder_create(&(struct feeder_def){exhibit, graph->def, 1, &graph->stop});
    graph->running = graph->feeder && pthread_create(&graph->thread, NULL, grow_all, graph) == 0;
}

void live_graph_hand(struct live_graph *graph, int scene, const uint8_t *rgb, int width, int height)
{
    struct outcome outcome;
    if (hand_picture(&outcome, rgb, width, height)) {
        outcome_finish(&graph->made[scene]);
        graph->made[scene] = outcome;
    }
}

void live_graph_take(struct live_graph *graph, int scene, struct outcome *outcome)
{
    bool any = false;
    for (int i = 0; i < outcome->width * outcome->height && !any; i++) {
        any = outcome->fields[FIELD_DARK][i] < 0.5f;
    }
    if (any) {
        outcome_finish(&graph->made[scene]);
        graph->made[scene] = *outcome;
        *outcome = (struct outcome){.width = 0};
    }
    outcome_finish(outcome);
}

/* What a feed is made from: what was made on the sheet, else what has grown; NULL: not yet, or never. */
static const struct outcome *outcome_for(struct live_graph *graph, int scene, int feed)
{
    const struct outcome *made = &graph->made[graph->exhibit->scenes[scene].feeds[feed].from];
    struct grown *grown = &graph->grown[scene];
    if (made->width > 0) {
        return made;
    }
    return atomic_load(&grown->done) && grown->good ? grown->from[feed] : NULL;
}

static bool make_actions(struct live_graph *graph, const struct exhibit_scene *scene, int index, struct action *actions)
{
    struct given *given = &graph->given[graph->gave++ % LIVE_GRAPH_KEPT];
    bool good = true;
    for (int i = 0; i < EXHIBIT_FEEDS; i++) {
        free(given->rasters[i]);
        given->rasters[i] = NULL;
    }
    for (int i = 0; i < scene->feed_count && good; i++) {
        good = feed_action(&scene->feeds[i], scene, outcome_for(graph, index, i), &actions[i], &given->rasters[i]);
    }
    return good;
}

bool live_graph_actions(struct live_graph *graph, int scene, struct action *actions, int *count)
{
    const struct exhibit_scene *of = graph->exhibit ? &graph->exhibit->scenes[scene] : NULL;
    bool ready = of;
    for (int i = 0; ready && i < of->feed_count; i++) {
        ready = outcome_for(graph, scene, i);
    }
    /* One that can never be is not waited for. */
    bool never = of && !ready && (!graph->running || atomic_load(&graph->grown[scene].done));
    *count = 0;
    if (ready && actions) {
        ready = make_actions(graph, of, scene, actions);
        *count = ready ? of->feed_count : 0;
    }
    return ready || (never && !actions);
}

bool live_graph_log(struct live_graph *graph, char *line, int size)
{
    bool any = atomic_load(&graph->has_line);
    if (any) {
        snprintf(line, (size_t)size, "%s", graph->line);
        atomic_store(&graph->has_line, false);
    }
    return any;
}
