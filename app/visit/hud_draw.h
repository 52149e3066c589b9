/* What a visitor and the staff see beside the painting, drawn by Cairo and Pango: pieces of RGBA, each drawn again only
 * when it changes. */
#ifndef FROND_HUD_DRAW_H
#define FROND_HUD_DRAW_H

#include <stdbool.h>
#include <stdint.h>

#include "hud.h"

/* RGBA, sRGB, multiplied by alpha, row by row from the top left. */
struct hud_image {
    uint8_t *rgba; /* owned */
    int width, height;
    uint64_t key; /* of what it shows: another one, and it is drawn again */
};

void hud_image_finish(struct hud_image *image); /* takes a zeroed one */
/* Each draws only when `image->key` is not that of what is to be seen, and says whether it has. Sizes follow from the
 * hud's pixels a mm. */
bool hud_draw_panel(const struct hud *hud, int panel, struct hud_image *image);
/* The legend of attract, which needs no reading: a hand that drops, rings, ink that branches; `phase` 0..1 of its loop
 * in HUD_PHASES steps; under it the invitation in the language. */
enum { HUD_PHASES = 24 };
bool hud_draw_invite(const struct hud *hud, int phase, struct hud_image *image);
/* The countdown: a ring that empties, the seconds, the sentence. */
bool hud_draw_countdown(const struct hud *hud, int seconds, float share, struct hud_image *image);
/* A sentence: thanks, closed. */
bool hud_draw_sentence(const struct hud *hud, enum exhibit_text text, struct hud_image *image);
/* A cursor in the colour of an ink; with `share` of a ring filled (dwelling, scanning). */
bool hud_draw_cursor(const struct hud *hud, int ink, float share, struct hud_image *image);
/* The staff's view: lines of "name<TAB>value", and its two buttons (HUD_BACK, HUD_EXIT), whose places it gives. */
bool hud_draw_status(const struct hud *hud, const char *lines, struct hud_image *image, struct hud_button buttons[2]);
/* A mark that only the staff would notice: the exhibit's file has an error. */
bool hud_draw_mark(const struct hud *hud, struct hud_image *image);

#endif
