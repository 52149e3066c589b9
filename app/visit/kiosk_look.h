/* What is to be seen over the painting: pieces of picture, each with its place. */
#ifndef FROND_KIOSK_LOOK_H
#define FROND_KIOSK_LOOK_H

#include <stdbool.h>
#include <stdint.h>

#include "exhibit.h"
#include "hud_draw.h"

enum {
    PIECE_PANEL, /* + seat */
    PIECE_CURSOR = PIECE_PANEL + EXHIBIT_SEATS,
    PIECE_ACROSS = PIECE_CURSOR + 8, /* lines of one-switch play */
    PIECE_DOWN,
    PIECE_HAND, /* that paints in attract */
    PIECE_INVITE,
    PIECE_SENTENCE,
    PIECE_COUNTDOWN,
    PIECE_STATUS,
    PIECE_MARK,
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
