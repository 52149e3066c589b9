/* Pieces of picture laid over a finished sheet, each from RGBA bytes at a place of its own: palettes, texts, cursors.
 * A piece costs an upload when its bytes are set, and its own pixels a frame, no more. Lives in the GL context that is
 * current when it is made; every call wants that context. After a context is lost: destroy, create, set all anew (the
 * bytes are not kept here). */
#ifndef FROND_OVERLAY_H
#define FROND_OVERLAY_H

#include <stdbool.h>
#include <stdint.h>

#include "program.h"

enum { OVERLAY_PIECES = 48 };

struct overlay;

/* Where a piece lies. Whole pixels and its own size show its bytes as they are; anything between is filtered linearly,
 * with edges that cover their share of a pixel. To less than half of its size it is better drawn anew. */
struct overlay_place {
    float x, y;          /* pixels of the sheet, of its top left corner; may lie beyond the edges */
    float width, height; /* pixels; 0: those of its bytes */
    float opacity;       /* 0..1; 0: not drawn */
};

/* NULL with the reason in `error`. `folder` NULL: the embedded sources. */
struct overlay *overlay_create(const struct shader_folder *folder, struct shader_error *error);
void overlay_destroy(struct overlay *overlay); /* takes NULL */
/* The bytes of a piece (0..OVERLAY_PIECES - 1), copied: sRGB, multiplied by alpha as Cairo means it, R first, row by
 * row from the top left. NULL takes the piece away. The place stays; that of a piece never placed is the top left
 * corner, opaque. False, and the piece is away, when GL has no memory or takes no such size. */
bool overlay_set(struct overlay *overlay, int piece, const uint8_t *rgba, int width, int height);
void overlay_place(struct overlay *overlay, int piece, const struct overlay_place *place);
/* Lays all pieces, lowest number first, over what is in a framebuffer of panel_width x panel_height pixels, for a sheet
 * of sheet_width x sheet_height, turned as picture_gpu_present. Blends in sRGB, as Cairo does. Uploads nothing; leaves
 * the framebuffer bound, blending off. */
void overlay_present(const struct overlay *overlay, unsigned framebuffer, int panel_width, int panel_height,
                     int sheet_width, int sheet_height, const float turn[4]);
/* Bytes brought to the GPU since it was made. */
uint64_t overlay_uploaded(const struct overlay *overlay);

#endif
