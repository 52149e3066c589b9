/* The heads-up palette: what it holds, where, and what a finger on it means. Pure geometry; hud_draw.h draws it.
 * Sizes are mm on the configured screen: no target is smaller than 15 mm, and all are within reach from a wheelchair
 * (ADA 308: 380 to 1220 mm over the floor; a table that lies: within 600 mm of the near edge). */
#ifndef FROND_HUD_H
#define FROND_HUD_H

#include <stdbool.h>
#include <stdint.h>

#include "event.h"
#include "exhibit.h"

enum hud_kind {
    HUD_INK,  /* value: of the scene's inks */
    HUD_TOOL, /* value: enum exhibit_tool */
    HUD_UNDO,
    HUD_REDO,
    HUD_FINISH,
    HUD_HAND,
    HUD_SEATED,
    HUD_LANGUAGE,
    HUD_EXIT, /* staff: in the status view */
    HUD_BACK, /* staff: back to the exhibit */
    HUD_KINDS,
};

enum { HUD_BUTTONS = 32, HUD_FINGERS = 16 };

struct hud_button {
    enum hud_kind kind;
    int value;
    float x, y, width, height; /* pixels of the sheet, from the top left */
};

/* The palette of one seat. */
struct hud_panel {
    struct hud_button buttons[HUD_BUTTONS];
    int count;
    float x, y, width, height; /* pixels: the strip behind the buttons */
    int side;                  /* enum exhibit_side, where it is now */
    int tool, ink;             /* chosen */
    bool can_undo, can_redo;
    int scanned; /* the button that one-switch play is at; -1: none */
};

struct hud_def {
    const struct exhibit *exhibit;
    int width, height; /* pixels of the sheet */
    int scene;
};

struct hud {
    struct hud_def def;
    float mm; /* pixels of one */
    struct hud_panel panels[EXHIBIT_SEATS];
    int count;
    int language; /* index as of words.h */
    bool swapped; /* hands: left and right change places */
    bool seated;
    bool shown; /* by the visit */
    bool busy;  /* hands are: it is out of the way */
    uint64_t busy_us;
    struct hud_finger {
        int slot, seat, button; /* that went down on a button; -1: none there */
        enum event_source source;
        bool used, on_panel;
    } fingers[HUD_FINGERS];
};

struct hud_press {
    int seat;
    enum hud_kind kind;
    int value;
    uint64_t time_us;
};

/* Lays everything out; to be called again when the exhibit, the scene, the sheet, hand or seat change. What is chosen
 * stays where it still exists. */
void hud_init(struct hud *hud, const struct hud_def *def);
void hud_layout(struct hud *hud);
/* A new visit: everything as at first. */
void hud_reset(struct hud *hud);
/* An event of a finger, in 0..1 of the sheet. True: it is the palette's, and nobody else's. A press counts when the
 * finger leaves on the button on which it came down; that is then in `press`, `pressed` true. */
bool hud_feel(struct hud *hud, const struct event *event, struct hud_press *press, bool *pressed);
/* Fingers are busy on the sheet, or not; after visit.hide seconds it goes out of the way. Returns whether it is drawn.
 */
bool hud_busy(struct hud *hud, bool busy, uint64_t now_us);
/* The seat whose zone holds a point. */
int hud_seat(const struct hud *hud, float x, float y);
/* How visible, 0..1, with fading. */
float hud_opacity(const struct hud *hud, uint64_t now_us);

#endif
