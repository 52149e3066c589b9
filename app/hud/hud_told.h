/* What a dial has turned, for some seconds beside each palette: its name and value. */
#ifndef FROND_HUD_TOLD_H
#define FROND_HUD_TOLD_H

#include "hud.h"
#include "hud_draw.h"

/* Something has this value now; two at once at most: an axis each. */
void hud_tell(struct hud *hud, const struct key *key, float value, uint64_t now_us);
/* How visible the label is, 0..1. */
float hud_told_opacity(const struct hud *hud, uint64_t now_us);
/* When that changes next: ms, 0 now, -1 not by itself. */
int hud_told_timeout_ms(const struct hud *hud, uint64_t now_us);
/* Draws it for the palette of a seat; as hud_draw_panel. */
bool hud_draw_told(const struct hud *hud, int panel, struct hud_image *image);

#endif
