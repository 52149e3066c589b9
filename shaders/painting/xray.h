/* The X-ray view as a visitor sees it: which layers, where their panels lie on the sheet, and the colours and ranges in
 * which they are shown. Plain numbers, no GL: the legend is laid out from the same. */
#ifndef FROND_XRAY_H
#define FROND_XRAY_H

#include <stdbool.h>
#include <stdint.h>

enum xray_layer {
    XRAY_CATALYST,
    XRAY_ACTIVE,
    XRAY_CARVED,
    XRAY_SOLVENT,
    XRAY_VELOCITY, /* of the solvent, weighed by its density */
    XRAY_GUIDANCE,
    XRAY_LAYERS,
};

struct xray_scale {
    float low, high; /* shown from dark to light; beyond, as the end. A vector: its length, its direction as hue */
    bool vector;
};
/* catalyst 0..1, active 0..0.16, carved 0..1, solvent 0..6 (densities); velocity 0..0.1 density cells a step; guidance
 * 0..1. */
extern const struct xray_scale xray_scales[XRAY_LAYERS];

struct xray_box {
    int x, y, width, height; /* pixels of the sheet, from the top left */
};
struct xray_panel {
    struct xray_box title, image,
        scale; /* above one another; the image has the shape of the painting, the title may be wider */
};
/* Three columns on a landscape sheet, two on a portrait one, of sheets of 64 pixels a side and more. */
void xray_layout(int width, int height, int cells_x, int cells_y, struct xray_panel panels[XRAY_LAYERS]);
/* Height of text that fits the boxes, pixels. */
int xray_text(int width, int height);

/* The colour of `value` (0 at low, 1 at high; beyond, the end) of a scalar layer, sRGB: lightness rises evenly in OKLab
 * (Ottosson 2020) and the hue turns, so that equal steps look equal, in grey too. */
void xray_colour(enum xray_layer layer, float value, uint8_t rgb[3]);
/* The same of a vector (x right, y down) as a share of `high`: dark where it rests, its direction as hue. */
void xray_vector_colour(float x, float y, uint8_t rgb[3]);
/* The ground that panels lie on. */
extern const uint8_t xray_ground[3];

#endif
