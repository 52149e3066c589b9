/* The legend of the X-ray view: title, unit and scale of each panel, as a bitmap that is laid over the panels. */
#ifndef FROND_LEGEND_H
#define FROND_LEGEND_H

#include <stdbool.h>
#include <stdint.h>

#include "xray.h"

/* What a panel says. One table, so that a language is one more of them. */
struct legend_text {
    const char *title, *unit;
};
extern const struct legend_text legend_texts[XRAY_LAYERS];

/* Writes [height][width][4] bytes of sRGB red green blue alpha, multiplied by alpha, from the top left, for panels that
 * xray_layout has placed on a sheet of that size; clear where there is nothing to say. 64 pixels a side and more. False
 * when memory is short. */
bool legend_draw(const struct xray_panel panels[XRAY_LAYERS], int width, int height, uint8_t *rgba);

#endif
