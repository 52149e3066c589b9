#include "hud_case.h"

#include <string.h>

#include "ink.h"

const struct hud_screen hud_screens[HUD_SCREENS] = {
    {"7 inches", 154, 86, 800, 480, false},
    {"10 inches", 217, 136, 1280, 800, false},
    {"22 inches upright", 273, 485, 1080, 1920, false},
    {"24 inches", 530, 300, 1920, 1080, false},
    {"43 inches lying", 940, 530, 1920, 1080, true},
    {"43 inches lying, 4K", 940, 530, 3840, 2160, true},
};

void hud_case_init(struct hud_case *place, const struct hud_screen *screen, enum exhibit_side side)
{
    static const char *const INKS[PAINTING_INKS] = {"phthalo turquoise", "quinacridone magenta", "ochre",
                                                    "cobalt blue"};
    struct exhibit *exhibit = &place->exhibit;
    memset(place, 0, sizeof *place);
    exhibit->display.width = screen->width;
    exhibit->display.lying = screen->lying;
    exhibit->display.floor = 800;
    place->script.ink_count = PAINTING_INKS;
    for (int i = 0; i < PAINTING_INKS; i++) {
        place->script.inks[i] = ink_find(INKS[i]);
    }
    exhibit->scenes[0].script = &place->script;
    exhibit->scene_count = 1;
    for (int i = 0; i < 4; i++) {
        exhibit->languages[i] = i;
    }
    exhibit->language_count = 4;
    for (int i = 0; i < TOOLS; i++) {
        exhibit->palette.tools[i] = true;
    }
    exhibit->palette.undo = exhibit->palette.finish = exhibit->palette.hand = true;
    exhibit->palette.seated = exhibit->palette.language = true;
    exhibit->palette.target = 15;
    exhibit->palette.opacity = 1;
    exhibit->visit.hide = 1.5f;
    exhibit->access.zone[1] = 0.5f;
    exhibit->access.zone[2] = exhibit->access.zone[3] = 1;
    hud_case_seats(place, 1, false, side);
}

void hud_case_seats(struct hud_case *place, int seats, bool rows, enum exhibit_side side)
{
    int across = rows ? (seats + 1) / 2 : seats, down = rows ? 2 : 1;
    for (int i = 0; i < seats; i++) {
        struct exhibit_seat *seat = &place->exhibit.seats[i];
        int x = i % across, y = i / across;
        seat->zone[0] = (float)x / (float)across;
        seat->zone[2] = (float)(x + 1) / (float)across;
        seat->zone[1] = (float)y / (float)down;
        seat->zone[3] = (float)(y + 1) / (float)down;
        seat->ink = -1;
        seat->side = (int)side;
    }
    place->exhibit.seat_count = seats;
}

struct hud_def hud_case_def(const struct hud_case *place, const struct hud_screen *screen)
{
    return (struct hud_def){.exhibit = &place->exhibit, .width = screen->columns, .height = screen->rows};
}
