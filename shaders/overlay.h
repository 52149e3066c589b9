/* Pieces of picture laid over a finished sheet, each from RGBA bytes at a place of its own: palettes, texts, cursors.
 * A piece costs an upload when its bytes change, and its own pixels a frame, no more. Lives in the GL context that is
 * current when it is made; every call wants that context. */
#ifndef FROND_OVERLAY_H
#define FROND_OVERLAY_H

#include <stdbool.h>
#include <stdint.h>

#include "program.h"

enum { OVERLAY_PIECES = 32 };

struct overlay;

struct overlay_place {
    float x, y;          /* pixels of the sheet, of its top left corner */
    float width, height; /* pixels; 0: those of its bytes */
    float opacity;       /* 0: not drawn */
};

/* NULL with the reason in `error`. */
struct overlay *overlay_create(const struct shader_folder *folder, struct shader_error *error);
void overlay_destroy(struct overlay *overlay); /* takes NULL */
/* The bytes of a piece, copied: sRGB, multiplied by alpha, row by row from the top left. False when GL has no memory.
 */
bool overlay_set(struct overlay *overlay, int piece, const uint8_t *rgba, int width, int height);
void overlay_place(struct overlay *overlay, int piece, const struct overlay_place *place);
/* Lays all pieces, lowest number first, over what is in a framebuffer of panel_width x panel_height pixels, for a sheet
 * of sheet_width x sheet_height, turned as picture_gpu_present. */
void overlay_present(const struct overlay *overlay, unsigned framebuffer, int panel_width, int panel_height,
                     int sheet_width, int sheet_height, const float turn[4]);

#endif
