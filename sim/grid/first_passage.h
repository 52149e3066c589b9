/* First passage: when a front that starts somewhere comes to each cell of a grid, where it takes its own time in each
 * (Eden growth, melting, drying; the eikonal equation on a graph of 8 neighbours).
 * Source: Dijkstra, "A note on two problems in connexion with graphs" (1959). Cost: n log n of the cells. */
#ifndef FROND_FIRST_PASSAGE_H
#define FROND_FIRST_PASSAGE_H

#include <stdbool.h>

/* `slowness`: width * height, row by row, times a cell, above 0; a step from one cell to the next costs the mean of
 * the two times its length. `arrival`: the sources' times, FLT_MAX elsewhere; filled with the time of every cell. The
 * same numbers on every machine. False when memory is short; then nothing has changed. */
bool first_passage(int width, int height, const float *slowness, float *arrival);

#endif
