/* A garden beside the engine, and what of it lies over a picture of the painting: for sessions and journals that grow
 * something over a picture. What `frond render` and `frond replay` share.
 *
 *     plot_act(plot, ticked, &action);                    every action, also those for the engine
 *     plot_tick(plot);                                    once they are done, before each tick
 *     plot_lay(plot, ticked, width, height, rgb);         over a picture
 */
#ifndef FROND_PLOT_H
#define FROND_PLOT_H

#include <stdbool.h>
#include <stdint.h>

#include "garden.h"

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
/* Grows what the actions of a tick have asked for: always after each, so that a journal repeats it to the bit. False
 * when memory is short. */
bool plot_tick(struct plot *plot);
/* Lays what has appeared over width * height * 3 bytes of sRGB. False when memory is short. */
bool plot_lay(struct plot *plot, int64_t ticked, int width, int height, uint8_t *rgb);
/* The garden itself, the plot's. */
struct garden *plot_garden(struct plot *plot);

#endif
