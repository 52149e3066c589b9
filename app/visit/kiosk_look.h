/* What is to be seen over the painting: pieces of picture, each with its place. */
#ifndef FROND_KIOSK_LOOK_H
#define FROND_KIOSK_LOOK_H

#include <stdbool.h>
#include <stdint.h>

#include "exhibit.h"
#include "hud_draw.h"

enum {
    LOOK_SLIDE,                            /* a picture of the gallery, over the whole sheet */
    LOOK_PANEL,                            /* + seat */
    LOOK_MAP = LOOK_PANEL + EXHIBIT_SEATS, /* + seat */
    LOOK_TOLD = LOOK_MAP + EXHIBIT_SEATS,  /* + seat */
    LOOK_CURSOR = LOOK_TOLD + EXHIBIT_SEATS,
    LOOK_ACROSS = LOOK_CURSOR + 8, /* lines of one-switch play */
    LOOK_DOWN,
    LOOK_HAND, /* that paints in attract */
    LOOK_INVITE,
    LOOK_SENTENCE,
    LOOK_COUNTDOWN,
    LOOK_STATUS,
    LOOK_MARK,
    KIOSK_PIECES,
};

struct kiosk_piece {
    const struct hud_image *image; /* `key` tells whether it is another one */
    float x, y, width, height;     /* pixels of the sheet, of its top left corner; width 0: the image's own */
    float opacity;                 /* 0: not to be seen */
};

struct kiosk_pieces {
    struct kiosk_piece piece[KIOSK_PIECES];
    bool changed; /* something is not as it was the last time: worth a frame */
};

struct kiosk;

/* As it is now; good until the next call. */
const struct kiosk_pieces *kiosk_look(struct kiosk *kiosk, uint64_t now_us);

#endif
