/* Exhibits and screens for the palette's tests: made by hand, with everything that a palette can hold. */
#ifndef FROND_HUD_CASE_H
#define FROND_HUD_CASE_H

#include "exhibit.h"
#include "hud.h"

struct hud_screen {
    const char *name;
    float width, height; /* mm of the picture as it is looked at */
    int columns, rows;   /* pixels */
    bool lying;
};

enum { HUD_SCREENS = 6 };
extern const struct hud_screen hud_screens[HUD_SCREENS];

struct hud_case {
    struct exhibit exhibit;
    struct script script; /* of its one scene: the inks */
};

/* Everything is offered, English, French, Arabic and Japanese, one seat with the palette at that side. Pointers of it
 * point into it. */
void hud_case_init(struct hud_case *place, const struct hud_screen *screen, enum exhibit_side side);
/* So many seats, side by side, in two rows from four on where the screen lies. */
void hud_case_seats(struct hud_case *place, int seats, bool rows, enum exhibit_side side);
struct hud_def hud_case_def(const struct hud_case *place, const struct hud_screen *screen);

#endif
