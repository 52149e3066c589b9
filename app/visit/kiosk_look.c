#include "kiosk_look.h"

#include <math.h>
#include <string.h>

#include "kiosk_state.h"
bool hud_draw_line(const struct hud *hud, struct hud_image *image);bool hud_draw_hand(const struct hud *hud, float pressed, struct hud_image *image);

enum { INVITE_US = 4000000, CURSORS = 8 };

static const float LINE_MM = 1.2f;

/* Puts a piece's image with its middle at x, y. */
static void put_middle(struct kiosk *kiosk, int piece, float x, float y, float opacity)
{
    const struct hud_image *image = &kiosk->images[piece];
    kiosk->pieces.piece[piece] = (struct kiosk_piece){
        image, roundf(x - 0.5f * (float)image->width), roundf(y - 0.5f * (float)image->height), 0, 0, opacity};
}

static void look_at_panels(struct kiosk *kiosk, uint64_t now_us)
{
    for (int i = 0; i < kiosk->hud.count; i++) {
        const struct hud_panel *panel = &kiosk->hud.panels[i];
        float opacity = hud_opacity(&kiosk->hud, i, now_us);
        if (panel->side == SIDE_OF_NONE || panel->count == 0 || opacity <= 0) {
            continue;
        }
        struct hud_image *image = &kiosk->images[PIECE_PANEL + i];
        hud_draw_panel(&kiosk->hud, i, image);
        kiosk->pieces.piece[PIECE_PANEL + i] = (struct kiosk_piece){image, panel->x, panel->y, 0, 0, opacity};
    }
}

static void look_at_cursors(struct kiosk *kiosk, uint64_t now_us)
{
    struct controls_cursor cursors[CURSORS];
    int count = kiosk->controls ? controls_cursors(kiosk->controls, now_us, cursors, CURSORS) : 0;
    for (int i = 0; i < count && i < CURSORS; i++) {
        if (!cursors[i].used) {
            continue;
        }
        hud_draw_cursor(&kiosk->hud, cursors[i].ink, 0, &kiosk->images[PIECE_CURSOR + i]);
        put_middle(kiosk, PIECE_CURSOR + i, cursors[i].at.x * (float)kiosk->def.width,
                   cursors[i].at.y * (float)kiosk->def.height, 1);
    }
}

/* A line of one-switch play, across the whole sheet. */
static void put_line(struct kiosk *kiosk, int piece, bool upright, float at)
{
    float thick = fmaxf(2, roundf(LINE_MM * kiosk->hud.mm));
    float width = (float)kiosk->def.width, height = (float)kiosk->def.height;
    struct hud_image *image = &kiosk->images[piece];
    hud_draw_line(&kiosk->hud, image);
    kiosk->pieces.piece[piece] = upright
                                     ? (struct kiosk_piece){image, roundf(at * width - thick / 2), 0, thick, height, 1}
                                     : (struct kiosk_piece){image, 0, roundf(at * height - thick / 2), width, thick, 1};
}

static void look_at_access(struct kiosk *kiosk)
{
    const struct access *access = &kiosk->access;
    if (access->state == ACCESS_ACROSS || access->state == ACCESS_DOWN) {
        put_line(kiosk, PIECE_ACROSS, true, access->x);
    }
    if (access->state == ACCESS_DOWN) {
        put_line(kiosk, PIECE_DOWN, false, access->y);
    }
}

static void look_at_attract(struct kiosk *kiosk, uint64_t now_us)
{
    struct point at;
    float pressed;
    int64_t tick = kiosk->def.stage.sheet(kiosk->def.stage.context).tick;
    int phase = (int)(now_us % INVITE_US * HUD_PHASES / INVITE_US);
    hud_draw_invite(&kiosk->hud, phase, &kiosk->images[PIECE_INVITE]);
    put_middle(kiosk, PIECE_INVITE, 0.5f * (float)kiosk->def.width,
               (float)kiosk->def.height - 0.62f * (float)kiosk->images[PIECE_INVITE].height, 1);
    if (kiosk->begun && !kiosk->washing && attract_hand(kiosk->attract, tick, &at, &pressed)) {
        hud_draw_hand(&kiosk->hud, pressed, &kiosk->images[PIECE_HAND]);
        put_middle(kiosk, PIECE_HAND, at.x * (float)kiosk->def.width, at.y * (float)kiosk->def.height, 1);
    }
}

static void look_at_sentence(struct kiosk *kiosk, enum exhibit_text text)
{
    hud_draw_sentence(&kiosk->hud, text, &kiosk->images[PIECE_SENTENCE]);
    put_middle(kiosk, PIECE_SENTENCE, 0.5f * (float)kiosk->def.width, 0.86f * (float)kiosk->def.height, 1);
}

static void look_at_countdown(struct kiosk *kiosk, uint64_t now_us)
{
    hud_draw_countdown(&kiosk->hud, visit_countdown(&kiosk->visit, now_us), visit_left(&kiosk->visit, now_us),
                       &kiosk->images[PIECE_COUNTDOWN]);
    put_middle(kiosk, PIECE_COUNTDOWN, 0.5f * (float)kiosk->def.width, 0.5f * (float)kiosk->def.height, 1);
}

static void look_at_status(struct kiosk *kiosk)
{
    struct hud_image *image = &kiosk->images[PIECE_STATUS];
    struct hud_button buttons[2];
    hud_draw_status(&kiosk->hud, kiosk->lines, image, buttons);
    put_middle(kiosk, PIECE_STATUS, 0.5f * (float)kiosk->def.width, 0.5f * (float)kiosk->def.height, 1);
}

static bool same(const struct kiosk_piece *a, const struct kiosk_piece *b)
{
    const float places[] = {a->x - b->x, a->y - b->y, a->width - b->width, a->height - b->height,
                            a->opacity - b->opacity};
    bool other = a->image != b->image;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        other = other || fabsf(places[i]) > 0;
    }
    return !other;
}

const struct kiosk_pieces *kiosk_look(struct kiosk *kiosk, uint64_t now_us)
{
    struct kiosk_pieces old = kiosk->pieces;
    uint64_t keys[KIOSK_PIECES];
    for (int i = 0; i < KIOSK_PIECES; i++) {
        keys[i] = kiosk->images[i].key;
    }
    memset(&kiosk->pieces, 0, sizeof kiosk->pieces);
    look_at_panels(kiosk, now_us);
    look_at_cursors(kiosk, now_us);
    look_at_access(kiosk);
    if (kiosk->visit.state == VISIT_ATTRACT) {
        look_at_attract(kiosk, now_us);
    } else if (kiosk->visit.state == VISIT_THANKS) {
        look_at_sentence(kiosk, TEXT_THANKS);
    } else if (kiosk->visit.state == VISIT_CLOSING) {
        look_at_sentence(kiosk, TEXT_CLOSED);
    } else if (kiosk->visit.state == VISIT_COUNTDOWN) {
        look_at_countdown(kiosk, now_us);
    }
    if (kiosk->hud.status) {
        look_at_status(kiosk);
    }
    if (kiosk->trouble) {
        hud_draw_mark(&kiosk->hud, &kiosk->images[PIECE_MARK]);
        kiosk->pieces.piece[PIECE_MARK] = (struct kiosk_piece){.image = &kiosk->images[PIECE_MARK], .opacity = 1};
    }
    for (int i = 0; i < KIOSK_PIECES; i++) {
        bool seen = kiosk->pieces.piece[i].opacity > 0;
        kiosk->pieces.changed = kiosk->pieces.changed || !same(&old.piece[i], &kiosk->pieces.piece[i]) ||
                                (seen && keys[i] != kiosk->images[i].key);
    }
    return &kiosk->pieces;
}
