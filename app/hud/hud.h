/* The heads-up palette: what it holds, where, and what a finger on it means. Pure geometry; hud_draw.h draws it.
 * Sizes are mm on the configured screen: no target is smaller than 15 mm, and all are within reach from a wheelchair
 * (ADA 308: 380 to 1220 mm over the floor; a table that lies: within 600 mm of the near edge).
 *
 * Where there is no room for everything, groups fold: the buttons of hand, reach and language into one (HUD_MORE), then
 * the tools into the chosen one, then the inks. A touch on a folded button shows its group in place of the rest; a
 * choice, or a finger on the sheet, brings the rest back.
 *
 * The palette does for itself what concerns it alone: it notes the chosen tool, ink and language, changes sides, moves
 * into the zone of a seated visitor. A press tells the kiosk what else follows. */
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
    HUD_PICTURE,  /* the next one, in scenes of trees */
    HUD_METAPHOR, /* another kind of what grows or reacts */
    HUD_HAND,     /* value, in a press: 1: the palette is on the other side now */
    HUD_SEATED,   /* value, in a press: 1: hud.seated now */
    HUD_LANGUAGE, /* value: of the language that a touch brings (words_languages) */
    HUD_MORE,     /* the last three, folded */
    HUD_EXIT,     /* staff: in the status view */
    HUD_BACK,     /* staff: back to the exhibit */
    HUD_KINDS,
};

enum { HUD_BUTTONS = 32, HUD_FINGERS = 64, HUD_THUMB = 48, HUD_TOLD = 2 };

struct hud_button {
    enum hud_kind kind;
    int value;
    bool folded;               /* stands for its group */
    float x, y, width, height; /* pixels of the sheet, from the top left */
};

/* The palette of one seat. */
struct hud_panel {
    struct hud_button buttons[HUD_BUTTONS];
    int count;
    float x, y, width, height; /* pixels: the strip behind the buttons */
    int side;                  /* enum exhibit_side, where it is now */
    int labels;                /* lines of words that there is room for under each button, 0..2 */
    int lines;                 /* of buttons: columns of a strip that stands, rows of one at the bottom */
    int open;                  /* enum hud_kind of the group that is shown in place of the rest; -1: none */
    int tool, ink;             /* chosen; to be set by hud_choose */
    bool has_picked;           /* on its map (hud_map.h): */
    float picked[2];           /* feed and kill */
    bool any_ink;              /* no ink is chosen yet, and each finger takes the next (inputs.visitors) */
    bool can_undo, can_redo;   /* set by the kiosk */
    int scanned;               /* the button that one-switch play is at; -1: none. Set by the kiosk */
    bool swapped;              /* hands: left and right change places */
    bool busy;                 /* hands are: it is out of the way */
    uint64_t busy_us;          /* since when they are, or are not */
    float busy_opacity;        /* then, 0..1 */
    bool held;                 /* a finger is on it: it is solid, and stays so for a while after */
    uint64_t held_us;          /* since when a finger is, or was */
    uint64_t left_us;          /* when the last one left */
    float held_solid;          /* at held_us: 0 as at rest, 1 solid */
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
    bool seated;
    float map_feed, map_kill; /* where the map's mark is (hud_map.h) */
    struct hud_told {         /* what was turned last (hud_told.h) */
        const struct key *key;
        float value;
        uint64_t us;
    } told[HUD_TOLD];
    int told_count;
    uint64_t told_us, told_begun_us; /* the last of them; since when the label is shown */
    struct hud_thumb {
        int width, height; /* 0: none */
        uint8_t grey[HUD_THUMB * HUD_THUMB];
    } thumb;                    /* the picture of a scene of trees, sRGB */
    bool status;                /* the staff's view is up: its two buttons are all there is. Set by the kiosk */
    struct hud_button staff[2]; /* HUD_BACK, HUD_EXIT */
    bool shown;                 /* by the visit */
    uint64_t shown_us;          /* since when it is, or is not */
    float shown_opacity;        /* then, 0..1 */
    struct hud_finger {
        bool used;
        enum event_source source;
        int slot, panel; /* panel -1: it is on the sheet below the staff's view */
        int button;      /* that it went down on; -1: none there */
        bool over;       /* it is still on it */
        bool map;        /* it is on the map of the panel */
    } fingers[HUD_FINGERS];
};

struct hud_press {
    int seat; /* 0.. */
    enum hud_kind kind;
    int value;
    uint64_t time_us;
};

/* Lays everything out; hud_layout again when the exhibit, the scene, the sheet, the language or the seat change (`def`,
 * `language`, `seated` are there to be set). What is chosen stays where it still exists. `exhibit` is only looked at,
 * and must stay. */
void hud_init(struct hud *hud, const struct hud_def *def);
void hud_layout(struct hud *hud);
/* Tool and ink of a panel, when they are chosen by other means (a button of a controller, say); -1: that one stays. */
void hud_choose(struct hud *hud, int panel, int tool, int ink);
/* The picture of a scene of trees from now on, as ACTION_STOCK has it. */
void hud_show_picture(struct hud *hud, const struct action_raster *picture);
/* A new visit: everything as at first, but what is shown, and fingers that are down stay the palette's until they
 * leave. */
void hud_reset(struct hud *hud);
/* Shown by the visit from now on, or not, with fading. */
void hud_show(struct hud *hud, bool shown, uint64_t now_us);
/* An event of a finger, in 0..1 of the sheet as it is looked at: before access_reach, since a seated visitor's palette
 * is in the zone itself. True: it is the palette's, and nobody else's. A press counts when the finger leaves on the
 * button on which it came down; that is then in `press`, `pressed` true. A press that the palette is done with itself
 * (a folded group) or that means nothing (undo when there is nothing to undo) is not told. While `status`, every finger
 * that comes down is the palette's. */
bool hud_feel(struct hud *hud, const struct event *event, struct hud_press *press, bool *pressed);
/* The same by other means: a button of a panel, or of the staff's view (panel -1), is pressed. Returns whether there is
 * something to tell. */
bool hud_press(struct hud *hud, int panel, int button, uint64_t time_us, struct hud_press *press);
/* Whether a finger is on a button, for the eye. */
bool hud_pressed(const struct hud *hud, int panel, int button);
/* Whether a button can do anything: undo when something can be undone. */
bool hud_enabled(const struct hud *hud, int panel, int button);
/* Fingers are busy on the sheet of a seat, or not; after visit.hide seconds, and no sooner than one, its palette goes
 * out of the way, and comes back a while after they have gone. Returns whether it is to be seen at all. */
bool hud_busy(struct hud *hud, int seat, bool busy, uint64_t now_us);
/* The seat whose zone holds a point in 0..1 of the sheet; where there is none, the nearest. */
int hud_seat(const struct hud *hud, float x, float y);
/* How visible a panel is, 0..1, with fading: of the whole image. At rest the exhibit's palette.opacity; solid when it
 * appears and while it is used. Its changes never flash: from least to most and back takes more than a second. */
float hud_opacity(const struct hud *hud, int panel, uint64_t now_us);
/* When hud_opacity changes next: 0 now (it is fading), -1 not by itself, else ms. */
int hud_timeout_ms(const struct hud *hud, uint64_t now_us);
/* The language that a touch on HUD_LANGUAGE brings. */
int hud_next_language(const struct hud *hud);

#endif
