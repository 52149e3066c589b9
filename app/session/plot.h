/* The scenes beside the engine (scene.h), and what of them lies over a picture of the painting: for sessions and
 * journals in which something else grows, too. What `frond render` and `frond replay` share.
 *
 *     plot_act(plot, ticked, &action);                    every action, also those for the engine
 *     plot_tick(plot, ticked);                            once they are done, before each tick
 *     plot_lay(plot, ticked, width, height, rgb);         over a picture
 *
 * A scene of a kind is there from the first action on that is for its kind alone. */
#ifndef FROND_PLOT_H
#define FROND_PLOT_H

#include <stdbool.h>
#include <stdint.h>

#include "scene.h"

struct script;
struct plot;

/* Whether a session needs one. */
bool plot_wanted(const struct script *script);
/* For a sheet of so many cells. NULL when memory is short. */
struct plot *plot_create(int width, int height);
void plot_destroy(struct plot *plot); /* takes NULL */
void plot_act(struct plot *plot, int64_t ticked, const struct action *action);
/* A fresh sheet, on which nothing is and no picture lies; or the same on another grid. False when memory is short. */
bool plot_sheet(struct plot *plot, int width, int height, bool fresh);
/* The tick, after its actions: always, so that a journal repeats it to the bit. False when memory is short, now or in
 * plot_act. */
bool plot_tick(struct plot *plot, int64_t ticked);
/* Lays what has appeared over width * height * 3 bytes of sRGB. False when memory is short. */
bool plot_lay(struct plot *plot, int64_t ticked, int width, int height, uint8_t *rgb);
/* Channels for files: of every scene its fields and the planes of its model, named by its kind: "chemistry.u". How many
 * there are, the name of one, and filling width * height values with it: false when memory is short. */
enum { PLOT_CHANNEL_NAME = 32 };
int plot_channels(const struct plot *plot);
void plot_channel_name(const struct plot *plot, int channel, char name[PLOT_CHANNEL_NAME]);
bool plot_channel(struct plot *plot, int channel, int width, int height, float *values);
/* The scene of a kind, the plot's; NULL: there is none. */
void *plot_scene(const struct plot *plot, enum scene_kind kind);

#endif
