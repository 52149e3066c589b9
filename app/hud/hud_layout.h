/* Where the buttons of the palette are (hud.h). */
#ifndef FROND_HUD_LAYOUT_H
#define FROND_HUD_LAYOUT_H

#include "hud.h"

/* mm. */
#define HUD_TARGET 15.0f /* the least side of a button */
#define HUD_GAP    3.0f  /* between buttons */
#define HUD_LABEL  6.5f  /* of a button, for a line of words under its picture */
#define HUD_LINE   6.0f  /* for a second one */
#define HUD_TEXT   5.0f  /* size of words: capitals of 3.5 and more */
#define HUD_PAD    2.5f  /* from the buttons to the edge of the strip */
#define HUD_EDGE   2.0f  /* from the strip to the edge of its zone */

/* Lays out one panel: its strip, buttons, side, labels, lines; from its `open`, `swapped`, `tool`, `ink`. */
void hud_layout_panel(struct hud *hud, int panel);
/* The two buttons of the staff's view. */
void hud_layout_staff(struct hud *hud);
/* enum scene_kind. */
int hud_kind_of_scene(const struct hud *hud);
/* The inks that a scene offers. */
int hud_inks(const struct hud *hud);
/* The text that a button bears, in the language that it is in; "" where it bears none. */
const char *hud_label(const struct hud *hud, const struct hud_button *button, int *language);

#endif
