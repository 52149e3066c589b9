#include "kiosk_look.h"

#include <math.h>
#include <string.h>

#include "hud_map.h"
#include "hud_told.h"
#include "kiosk_state.h"

enum { INVITE_US = 5000000, CURSORS = 8 };

static const float LINE_MM = 1.2f, DWELT_SHOWN = 0.15f, SLIDE_FADE_S = 1.5f;

/* Puts a piece's image with its middle at x, y. */
static void put_middle(struct kiosk *kiosk, int piece, float x, float y, float opacity)
{
    const struct hud_image *image = &kiosk->images[piece];
    kiosk->pieces.piece[piece] = (struct kiosk_piece){
        image, roundf(x - 0.5f * (float)image->width), roundf(y - 0.5f * (float)image->height), 0, 0, opacity};
}

/* Puts a piece's image where it belongs. */
static void put(struct kiosk *kiosk, int piece, float opacity)
{
    const struct hud_image *image = &kiosk->images[piece];
    kiosk->pieces.piece[piece] =
        (struct kiosk_piece){image, (float)image->x, (float)image->y, 0, 0, image->rgba ? opacity : 0};
}

static void look_at_panels(struct kiosk *kiosk, uint64_t now_us)
{
    for (int i = 0; i < kiosk->hud.count; i++) {
        const struct hud_panel *panel = &kiosk->hud.panels[i];
        float opacity = hud_opacity(&kiosk->hud, i, now_us);
        if (panel->side == SIDE_OF_NONE || panel->count == 0 || opacity <= 0) {
            continue;
        }
        hud_draw_panel(&kiosk->hud, i, &kiosk->images[LOOK_PANEL + i]);
        put(kiosk, LOOK_PANEL + i, opacity);
    }
}

/* Open maps, and what was turned last: beside the palettes, and while a visit paints. */
static void look_beside_panels(struct kiosk *kiosk, uint64_t now_us)
{
    float told = visit_paints(&kiosk->visit) ? hud_told_opacity(&kiosk->hud, now_us) : 0, place[4];
    for (int i = 0; i < kiosk->hud.count; i++) {
        float opacity = hud_opacity(&kiosk->hud, i, now_us);
        if (opacity > 0 && hud_map_place(&kiosk->hud, i, place)) {
            hud_draw_map(&kiosk->hud, i, &kiosk->images[LOOK_MAP + i]);
            put(kiosk, LOOK_MAP + i, opacity);
        }
        if (told > 0) {
            hud_draw_told(&kiosk->hud, i, &kiosk->images[LOOK_TOLD + i]);
            put(kiosk, LOOK_TOLD + i, told);
        }
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
        hud_draw_cursor(&kiosk->hud, cursors[i].ink, 0, &kiosk->images[LOOK_CURSOR + i]);
        put_middle(kiosk, LOOK_CURSOR + i, cursors[i].at.x * (float)kiosk->def.width,
                   cursors[i].at.y * (float)kiosk->def.height, 1);
    }
}

/* Rings of fingers that dwell. */
static void look_at_dwelling(struct kiosk *kiosk, uint64_t now_us)
{
    int piece = LOOK_CURSOR + CURSORS;
    for (int i = 0; i < ACCESS_POINTS && piece > LOOK_CURSOR; i++) {
        const struct access_point *point = &kiosk->access.points[i];
        float share = point->used ? access_dwelt(&kiosk->access, point->id, now_us) : 0;
        if (share <= DWELT_SHOWN) {
            continue;
        }
        int seat = hud_seat(&kiosk->hud, point->x, point->y);
        piece--;
        hud_draw_cursor(&kiosk->hud, kiosk->hud.panels[seat].ink, share, &kiosk->images[piece]);
        put_middle(kiosk, piece, point->x * (float)kiosk->def.width, point->y * (float)kiosk->def.height, 1);
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
        put_line(kiosk, LOOK_ACROSS, true, access->x);
    }
    if (access->state == ACCESS_DOWN) {
        put_line(kiosk, LOOK_DOWN, false, access->y);
    }
}

/* A picture of the gallery comes and goes; nobody waits for it. */
static void look_at_slide(struct kiosk *kiosk, uint64_t now_us)
{
    float lasts = kiosk->exhibit->gallery.slides, gone = 1e-6f * (float)(now_us - kiosk->slide_us);
    float fade = fminf(fminf(gone, lasts - gone) / SLIDE_FADE_S, 1);
    if (kiosk->slide_us == 0) {
        return;
    }
    if (gone >= lasts) {
        kiosk->slide_us = 0;
        hud_image_finish(&kiosk->images[LOOK_SLIDE]);
        return;
    }
    kiosk->pieces.piece[LOOK_SLIDE] = (struct kiosk_piece){
        &kiosk->images[LOOK_SLIDE], 0, 0, (float)kiosk->def.width, (float)kiosk->def.height, fmaxf(fade, 0)};
}

static void look_at_attract(struct kiosk *kiosk, uint64_t now_us)
{
    struct point at;
    float pressed;
    int64_t tick = kiosk->def.stage.sheet(kiosk->def.stage.context).tick;
    int phase = (int)(now_us % INVITE_US * HUD_PHASES / INVITE_US);
    hud_draw_invite(&kiosk->hud, phase, &kiosk->images[LOOK_INVITE]);
    put(kiosk, LOOK_INVITE, 1);
    if (kiosk->begun && !kiosk->washing && attract_hand(kiosk->attract, tick, &at, &pressed)) {
        hud_draw_hand(&kiosk->hud, pressed, &kiosk->images[LOOK_HAND]);
        put_middle(kiosk, LOOK_HAND, at.x * (float)kiosk->def.width, at.y * (float)kiosk->def.height, 1);
    }
}

static void look_at_sentence(struct kiosk *kiosk, enum exhibit_text text)
{
    hud_draw_sentence(&kiosk->hud, text, &kiosk->images[LOOK_SENTENCE]);
    put(kiosk, LOOK_SENTENCE, 1);
}

static void look_at_countdown(struct kiosk *kiosk, uint64_t now_us)
{
    hud_draw_countdown(&kiosk->hud, visit_countdown(&kiosk->visit, now_us), visit_left(&kiosk->visit, now_us),
                       &kiosk->images[LOOK_COUNTDOWN]);
    put(kiosk, LOOK_COUNTDOWN, 1);
}

static void look_at_status(struct kiosk *kiosk)
{
    hud_draw_status(&kiosk->hud, kiosk->lines, &kiosk->images[LOOK_STATUS]);
    put(kiosk, LOOK_STATUS, 1);
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
    look_beside_panels(kiosk, now_us);
    look_at_cursors(kiosk, now_us);
    look_at_dwelling(kiosk, now_us);
    look_at_access(kiosk);
    if (kiosk->visit.state == VISIT_ATTRACT) {
        look_at_slide(kiosk, now_us);
        look_at_attract(kiosk, now_us);
    } else if (kiosk->visit.state == VISIT_THANKS) {
        look_at_sentence(kiosk, TEXT_THANKS);
    } else if (kiosk->visit.state == VISIT_CLOSING) {
        look_at_sentence(kiosk, TEXT_CLOSED);
    } else if (kiosk->visit.state == VISIT_COUNTDOWN) {
        look_at_countdown(kiosk, now_us);
    }
    if (kiosk->visit.state != VISIT_ATTRACT) {
        kiosk->slide_us = 0;
    }
    if (kiosk->hud.status) {
        look_at_status(kiosk);
    }
    if (kiosk->trouble) {
        hud_draw_mark(&kiosk->hud, &kiosk->images[LOOK_MARK]);
        put(kiosk, LOOK_MARK, 1);
    }
    kiosk->pieces.changed = kiosk_is_covered(kiosk);
    for (int i = 0; i < KIOSK_PIECES; i++) {
        bool seen = kiosk->pieces.piece[i].opacity > 0;
        kiosk->pieces.changed = kiosk->pieces.changed || !same(&old.piece[i], &kiosk->pieces.piece[i]) ||
                                (seen && keys[i] != kiosk->images[i].key);
    }
    return &kiosk->pieces;
}
