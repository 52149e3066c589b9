/* The figures of a painting as JSON: sums, extremes, and the shape's (shape.h). */
#ifndef FROND_STATS_H
#define FROND_STATS_H

#include <stdbool.h>

#include "engine.h"
#include "file.h"
#include "plot.h"
#include "script.h"

/* Writes an object with: frond (version), engine ("cpu", "gpu"), seed, ticks, hash (16 hex digits; null for an engine
 * that does not repeat itself to the bit), canvas {width, height, margin}, totals
 * (struct painting_totals), fields {name: {min, max, sum}} over the visible sheet, shape (struct shape_figures; its
 * centre is the only drop's, else the shape's own); and, with a plot, scenes {KIND: {hash, and figures of the scene}}.
 * False, with the reason in `error`, when memory is short or the file cannot be written; nothing is left behind then.
 */
bool stats_write(const char *path, const struct script *script, struct engine *engine, struct plot *plot,
                 struct file_error *error);

#endif
