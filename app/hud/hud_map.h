/* The map of feed and kill beside a palette, in scenes of chemistry while the tool of the map is chosen: a finger on it
 * picks what reacts, and where the dish is now is marked. Pure but for hud_draw_map. */
#ifndef FROND_HUD_MAP_H
#define FROND_HUD_MAP_H

#include "hud.h"
#include "hud_draw.h"
#include "scene_options.h"

/* Its card, in pixels of the sheet: left, top, width, height. False: this palette has none open. */
bool hud_map_place(const struct hud *hud, int panel, float place[4]);
/* The dish is here now. */
void hud_map_stand(struct hud *hud, const struct scene_options *options);
/* The palette whose map, to be seen at all, holds a place in pixels; -1: none. */
int hud_map_at(const struct hud *hud, float x, float y, uint64_t now_us);
/* A finger of a palette is there on its map, or beyond its edge, in pixels. */
void hud_map_pick(struct hud *hud, int panel, float x, float y);
/* The same by other means, in 0..1 of the sheet. False: there is no open map there. */
bool hud_map_tap(struct hud *hud, float x, float y, uint64_t now_us);
/* What has been picked since the last call: in scene_options_keys of chemistry, -1 where there is no such key, and the
 * values. False: nothing. */
bool hud_map_picked(struct hud *hud, int panel, int options[2], float values[2]);
/* As hud_draw_panel. */
bool hud_draw_map(const struct hud *hud, int panel, struct hud_image *image);

#endif
