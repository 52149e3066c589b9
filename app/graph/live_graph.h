/* What scenes of an exhibit take from one another, live: a thread grows what each gives by itself, one after the other
 * in the order in which they feed each other; what has just been made on the sheet comes before that.
 *
 *     live_graph_set(graph, exhibit);                              another exhibit; the thread begins anew
 *     live_graph_hand(graph, scene, rgb, width, height);           the scene ends, and this is to be seen of it
 *     live_graph_take(graph, scene, &outcome);                     this is what it has come to: better than that
 *     live_graph_actions(graph, scene, actions, &count)            on a fresh sheet of another; never waits */
#ifndef FROND_LIVE_GRAPH_H
#define FROND_LIVE_GRAPH_H

#include <stdbool.h>
#include <stdint.h>

#include "exhibit.h"
#include "outcome.h"

enum { LIVE_GRAPH_KEPT = 6 }; /* times that actions were given out, whose rasters stay good */

struct live_graph;

/* `def` loads pictures, as for scripts, in that thread. NULL when memory is short. */
struct live_graph *live_graph_create(const struct script_def *def);
/* Stops what is being grown, and waits for that. Takes NULL. */
void live_graph_destroy(struct live_graph *graph);
/* The exhibit stays until another is set. What was given out stays good. Waits for a tick of what is being grown. */
void live_graph_set(struct live_graph *graph, const struct exhibit *exhibit);
/* A picture of the sheet as the scene ends, width * height * 3 bytes of sRGB; where nothing stands out, nothing is. */
void live_graph_hand(struct live_graph *graph, int scene, const uint8_t *rgb, int width, int height);
/* The same of a scene that gives its fields; `outcome` is taken over. Where nothing has grown, nothing is taken. */
void live_graph_take(struct live_graph *graph, int scene, struct outcome *outcome);
/* The inputs of a scene as actions, EXHIBIT_FEEDS at most; their rasters are good until LIVE_GRAPH_KEPT more were
 * given. False: some are not ready yet, and there are none. `actions` NULL: only asks. */
bool live_graph_actions(struct live_graph *graph, int scene, struct action *actions, int *count);
/* The next line for the log: a scene that cannot be grown. */
bool live_graph_log(struct live_graph *graph, char *line, int size);

#endif
