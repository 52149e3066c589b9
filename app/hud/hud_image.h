/* What all drawings of hud_draw.h share. */
#ifndef FROND_HUD_IMAGE_H
#define FROND_HUD_IMAGE_H

#include "hud_draw.h"
#include "pen.h"

enum hud_piece {
    PIECE_PANEL,
    PIECE_INVITE,
    PIECE_COUNTDOWN,
    PIECE_SENTENCE,
    PIECE_CURSOR,
    PIECE_STATUS,
    PIECE_MARK,
    PIECE_HAND,
    PIECE_LINE,
    PIECE_TOLD,
    PIECE_MAP,
};

/* A key of a piece, with the sheet, the language and the texts' exhibit in it. */
uint64_t hud_key(const struct hud *hud, enum hud_piece piece);
/* Opens a pen on a sheet for the image, unless the image has that key; false then, and when memory is short. */
bool hud_image_begin(struct hud_image *image, uint64_t key, int width, int height, struct pen *pen);
/* Keeps what was drawn, at that place of the sheet. Returns whether it could. */
bool hud_image_end(struct hud_image *image, uint64_t key, int x, int y, struct pen *pen);

/* What scales with the screen: pixels of a mm on one of 420x250 mm, never less than half, never more than 1.5. */
double hud_unit(const struct hud *hud);
/* What an ink of the scene looks like at a thickness, as the scene mixes; dark beyond them. */
struct pen_colour hud_ink_colour(const struct hud *hud, int number, double thickness);
/* A text of the exhibit in the language, and the language's tag. */
const char *hud_text(const struct hud *hud, enum exhibit_text text);
const char *hud_tag(int language);
/* A whole number in the digits of a language. */
void hud_number(int language, int value, char *text, size_t size);
/* A text with {seconds} replaced. */
void hud_with_seconds(int language, const char *text, int seconds, char *filled, size_t size);

#endif
