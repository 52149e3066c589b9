/* Sentences for everyone: the countdown, thanks, closed. */
#include <math.h>

#include "hud_draw.h"
#include "hud_icon.h"
#include "hud_image.h"

/* A card in the middle of the sheet; its edge on all sides is for the shadow. */
struct card {
    int width, height; /* pixels, shadow and all */
    double edge;
};

static struct card card_of(const struct hud *hud, double width, double height)
{
    double edge = ceil(4 * hud_unit(hud));
    return (struct card){(int)fmin(ceil(width + 2 * edge), hud->def.width),
                         (int)fmin(ceil(height + 2 * edge), hud->def.height), edge};
}

static void draw_card(const struct hud *hud, const struct pen *pen, const struct card *card, double alpha)
{
    pen_draw_card(pen, card->edge, card->edge, card->width - 2 * card->edge, card->height - 2 * card->edge,
                  9 * hud_unit(hud), card->edge, alpha);
}

static bool end_card(const struct hud *hud, struct hud_image *image, uint64_t key, struct pen *pen)
{
    int x = (hud->def.width - cairo_image_surface_get_width(pen->surface)) / 2;
    int y = (hud->def.height - cairo_image_surface_get_height(pen->surface)) / 2;
    return hud_image_end(image, key, x, y, pen);
}

/* Pixels that words take, before there is an image to write them on. */
static bool measure(const struct pen_words *words, int count, double *widest, double heights[])
{
    struct pen pen;
    if (!pen_open(&pen, 1, 1)) {
        return false;
    }
    *widest = 0;
    for (int i = 0; i < count; i++) {
        double width;
        pen_measure(&pen, &words[i], &width, &heights[i]);
        *widest = fmax(*widest, width);
    }
    pen_close(&pen, NULL);
    return true;
}

/* What is left of the time, from the top clockwise; behind it what has gone. */
static void draw_ring(const struct hud *hud, const struct pen *pen, double x, double y, double radius, double share)
{
    double end = -0.5 * G_PI + 2 * G_PI * share;
    cairo_new_path(pen->cairo);
    cairo_arc(pen->cairo, x, y, radius, 0, 2 * G_PI);
    pen_set(pen, pen_dark, 0.12);
    cairo_set_line_width(pen->cairo, 0.13 * radius);
    cairo_stroke(pen->cairo);
    if (share > 0) {
        pen_set(pen, hud_ink_colour(hud, 0, 1), 1);
        cairo_arc(pen->cairo, x, y, radius, -0.5 * G_PI, end);
        cairo_set_line_width(pen->cairo, 0.17 * radius);
        cairo_stroke(pen->cairo);
        pen_blot(pen, x + radius * cos(end), y + radius * sin(end), 0.15 * radius, 0.12, 5); /* water takes it away */
        cairo_fill(pen->cairo);
    }
}

bool hud_draw_countdown(const struct hud *hud, int seconds, float share, struct hud_image *image)
{
    enum { STEPS = 120, NUMBER = 0, SENTENCE = 1, STAY = 2, WORDS = 3 };
    struct pen pen;
    char number[40], sentence[400];
    double unit = hud_unit(hud), mm = (double)hud->mm, widest, heights[WORDS];
    int step = (int)lroundf(fminf(fmaxf(share, 0), 1) * STEPS);
    const char *tag = hud_tag(hud->language), *stay = hud_text(hud, TEXT_STAY);
    hud_number(hud->language, seconds, number, sizeof number);
    hud_with_seconds(hud->language, hud_text(hud, TEXT_COUNTDOWN), seconds, sentence, sizeof sentence);
    uint64_t key = pen_hash_int(pen_hash_int(hud_key(hud, PIECE_COUNTDOWN), seconds), step);
    key = pen_hash_text(pen_hash_text(key, sentence), stay);
    double radius = 27 * unit, gap = 6 * unit, room = fmin(190 * unit, 0.86 * hud->def.width);
    const struct pen_words words[WORDS] = {{number, tag, 26 * unit, 0, true},
                                           {sentence, tag, fmax(5.2 * mm, 8 * unit), room, false},
                                           {stay, tag, fmax(5.8 * mm, 10 * unit), room, true}};
    if ((image->rgba && image->key == key) || !measure(words, WORDS, &widest, heights)) {
        return false;
    }
    double high = 1.6 * gap + 2.2 * radius + gap + heights[SENTENCE] + 0.7 * gap + heights[STAY] + 1.3 * gap;
    double wide = fmax(widest, 3 * radius) + 3 * gap;
    struct card card = card_of(hud, wide, high);
    if (!hud_image_begin(image, key, card.width, card.height, &pen)) {
        return false;
    }
    double x = 0.5 * card.width, y = card.edge + 1.6 * gap + 1.1 * radius;
    draw_card(hud, &pen, &card, 0.93);
    draw_ring(hud, &pen, x, y, radius, (double)step / STEPS);
    pen_set(&pen, pen_dark, 1);
    pen_write(&pen, &words[NUMBER], x, y);
    y += 1.1 * radius + gap + 0.5 * heights[SENTENCE];
    pen_write(&pen, &words[SENTENCE], x, y);
    y += 0.5 * heights[SENTENCE] + 0.7 * gap + 0.5 * heights[STAY];
    pen_write(&pen, &words[STAY], x, y);
    return end_card(hud, image, key, &pen);
}

/* A drop that lies between two thin strokes, under a sentence. */
static void draw_ornament(const struct hud *hud, const struct pen *pen, double x, double y, double size)
{
    pen_set(pen, pen_dark, 0.45);
    for (int side = -1; side <= 1; side += 2) {
        const double points[][2] = {{x + 0.7 * side * size, y},
                                    {x + 2 * side * size, y + 0.12 * size},
                                    {x + 3.6 * side * size, y - 0.06 * size}};
        pen_brush(pen, points, 3, 0.16 * size, 0.1 * size, 0.02 * size);
    }
    pen_blot(pen, x, y, 0.34 * size, 0.14, 31);
    pen_set(pen, hud_ink_colour(hud, 0, 1), 1);
    cairo_fill(pen->cairo);
}

bool hud_draw_sentence(const struct hud *hud, enum exhibit_text text, struct hud_image *image)
{
    struct pen pen;
    double unit = hud_unit(hud), mm = (double)hud->mm, gap = 9 * unit, widest, height;
    struct pen_words words = {.text = hud_text(hud, text), .tag = hud_tag(hud->language), .bold = true};
    words.size = fmax(6 * mm, 13 * unit);
    words.width = fmin(230 * unit, 0.8 * hud->def.width);
    uint64_t key = pen_hash_text(hud_key(hud, PIECE_SENTENCE), words.text);
    if ((image->rgba && image->key == key) || !measure(&words, 1, &widest, &height)) {
        return false;
    }
    struct card card = card_of(hud, widest + 3 * gap, height + 3.4 * gap);
    if (!hud_image_begin(image, key, card.width, card.height, &pen)) {
        return false;
    }
    draw_card(hud, &pen, &card, 0.93);
    pen_set(&pen, pen_dark, 1);
    pen_write(&pen, &words, 0.5 * card.width, card.edge + 1.1 * gap + 0.5 * height);
    draw_ornament(hud, &pen, 0.5 * card.width, card.edge + 2.2 * gap + height, 0.7 * gap);
    return end_card(hud, image, key, &pen);
}
