/* What a visitor and the staff see beside the painting, drawn by Cairo and Pango: pieces of RGBA, each drawn again only
 * when it changes.
 *
 *     if (hud_draw_panel(&hud, 0, &image)) { upload(image.rgba, image.width, image.height); }
 *     blend(image.x, image.y, hud_opacity(&hud, 0, now_us));
 *
 * An image is owned by who holds it; a copy of the hud may be drawn by another thread. */
#ifndef FROND_HUD_DRAW_H
#define FROND_HUD_DRAW_H

#include <stdbool.h>
#include <stdint.h>

#include "hud.h"

/* RGBA, sRGB, multiplied by alpha, row by row from the top left. */
struct hud_image {
    uint8_t *rgba;     /* owned; NULL while there is nothing to show */
    int width, height; /* pixels; 0 while there is nothing to show */
    int x, y;          /* pixels of the sheet: where its top left belongs. A cursor's middle belongs at its point */
    uint64_t key;      /* of what it shows: another one, and it is drawn again */
    void *ground;      /* what stays while the rest moves; owned, private to those who draw */
    uint64_t ground_key;
};

void hud_image_finish(struct hud_image *image); /* takes a zeroed one, and leaves one */
/* Each draws only when `image->key` is not that of what is to be seen, and says whether it has. When memory is short it
 * leaves the image as it is, and tries again the next time. Sizes follow from the hud's pixels a mm. At 1920x1080
 * on a desktop processor a panel takes 10 ms, a phase of the legend 5, a step of the countdown 5, a cursor 0.2; what
 * has not changed, microseconds. */
bool hud_draw_panel(const struct hud *hud, int panel, struct hud_image *image);
/* The legend of attract, which needs no reading: a finger that touches, rings, ink that branches; `phase` of its loop,
 * 0..HUD_PHASES - 1, of about five seconds in all; under it the invitation in the language. */
enum { HUD_PHASES = 24 };
bool hud_draw_invite(const struct hud *hud, int phase, struct hud_image *image);
/* The countdown: a ring of which `share`, 1..0, is left, the seconds, the sentence, how to go on. */
bool hud_draw_countdown(const struct hud *hud, int seconds, float share, struct hud_image *image);
/* A sentence: thanks, closed. */
bool hud_draw_sentence(const struct hud *hud, enum exhibit_text text, struct hud_image *image);
/* A cursor in the colour of an ink (of the scene's), with its mark, and `share` of a ring filled (dwelling, scanning).
 */
bool hud_draw_cursor(const struct hud *hud, int ink, float share, struct hud_image *image);
/* The staff's view: lines of "name<TAB>value", and its two buttons (hud->staff). As large as the sheet. */
bool hud_draw_status(const struct hud *hud, const char *lines, struct hud_image *image);
/* The hand that paints in attract: a fingertip, the lower (`pressed` 0..1) the nearer to the paper. Its middle belongs
 * at its point. */
bool hud_draw_hand(const struct hud *hud, float pressed, struct hud_image *image);
/* A dot of the colour of one-switch play's lines, to be drawn out to a line. */
bool hud_draw_line(const struct hud *hud, struct hud_image *image);
/* A mark that only the staff would notice: the exhibit's file has an error. */
bool hud_draw_mark(const struct hud *hud, struct hud_image *image);

#endif
