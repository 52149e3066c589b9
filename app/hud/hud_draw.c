#include "hud_draw.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "hud_icon.h"
#include "hud_image.h"
#include "hud_layout.h"

static const struct pen_colour SCANNED = {0, 0.3, 0.95};
/* In scenes that have no inks: of leaves, of a flash, of a reagent; others are dark. */
static const struct pen_colour COLOURS[SCENE_KINDS] = {
    [SCENE_TREES] = {0.42, 0.6, 0.26}, [SCENE_LIGHTNING] = {0.55, 0.6, 0.98}, [SCENE_CHEMISTRY] = {0.93, 0.58, 0.28}};
static const double SQUEEZED_LINE = 0.83; /* letters are made narrower down to this before words take a second line */
static const double SQUEEZED = 0.68;      /* and down to this before they are left out */

/* What a drawing of a panel needs to know. */
struct board {
    const struct hud *hud;
    const struct hud_panel *panel;
    int number; /* of the panel */
    struct pen *pen;
    double mm, left, top; /* pixels; where the image begins on the sheet */
};

_Static_assert((int)ICON_UNDO == (int)ICON_DROP + (int)TOOLS, "a tool has the icon in its place");

static enum hud_icon icon_of(const struct hud *hud, const struct hud_button *button)
{
    static const enum hud_icon KINDS[SCENE_KINDS] = {[SCENE_LIGHTNING] = ICON_BOLTS, [SCENE_CHEMISTRY] = ICON_PATTERNS};
    enum hud_icon kind = KINDS[hud_kind_of_scene(hud)];
    static const enum hud_icon ICONS_OF[HUD_KINDS] = {
        [HUD_UNDO] = ICON_UNDO,       [HUD_REDO] = ICON_REDO,     [HUD_FINISH] = ICON_FINISH,
        [HUD_HAND] = ICON_HAND,       [HUD_SEATED] = ICON_SEATED, [HUD_LANGUAGE] = ICON_LANGUAGE,
        [HUD_PICTURE] = ICON_PICTURE, [HUD_MORE] = ICON_MORE,     [HUD_EXIT] = ICON_EXIT,
        [HUD_BACK] = ICON_BACK,
    };
    return button->kind == HUD_TOOL       ? (enum hud_icon)(ICON_DROP + button->value)
           : button->kind == HUD_METAPHOR ? (kind ? kind : ICON_METAPHOR)
                                          : ICONS_OF[button->kind];
}

static bool is_chosen(const struct hud *hud, const struct hud_panel *panel, const struct hud_button *button)
{
    return (button->kind == HUD_TOOL && button->value == panel->tool) ||
           (button->kind == HUD_INK && button->value == panel->ink && !panel->any_ink) ||
           (button->kind == HUD_SEATED && hud->seated);
}

static uint64_t panel_key(const struct hud *hud, int number)
{
    const struct hud_panel *panel = &hud->panels[number];
    uint64_t key = pen_hash_int(hud_key(hud, PIECE_PANEL), number);
    const float places[] = {panel->x, panel->y, panel->width, panel->height};
    key = pen_hash(key, places, sizeof places);
    key = pen_hash_int(pen_hash_int(key, panel->labels), panel->any_ink ? -1 : panel->ink);
    key = pen_hash_int(key, hud_kind_of_scene(hud));
    if (hud_kind_of_scene(hud) == SCENE_TREES) {
        key = pen_hash(key, &hud->thumb, sizeof hud->thumb);
    }
    for (int i = 0; i < panel->count; i++) {
        const struct hud_button *button = &panel->buttons[i];
        const float sizes[] = {button->x, button->y, button->width, button->height};
        const int states[] = {(int)button->kind,
                              button->value,
                              button->folded,
                              is_chosen(hud, panel, button),
                              hud_enabled(hud, number, i),
                              hud_pressed(hud, number, i),
                              panel->scanned == i};
        int language;
        key = pen_hash(pen_hash(key, sizes, sizeof sizes), states, sizeof states);
        key = pen_hash_text(key, hud_label(hud, button, &language));
    }
    return key;
}

/* The ink that icons drip: the chosen one, or that of the kind of scene, bright enough for its ground. */
static struct pen_colour wet_of(const struct board *board, bool dark)
{
    int kind = hud_kind_of_scene(board->hud);
    bool inked = kind == SCENE_PAINTING;
    struct pen_colour colour = inked ? hud_ink_colour(board->hud, board->panel->ink, 0.8) : COLOURS[kind];
    for (int i = 0; i < 8 && dark && pen_luminance(colour) < 0.18; i++) {
        colour = pen_between(colour, pen_paper, 0.2);
    }
    return colour;
}

/* Words from y down, around x, in so many lines, squeezed no more than to that. False where there is no room. */
static bool fit_label(const struct board *board, struct pen_words *words, double x, double y, double room, int lines,
                      double least)
{
    const struct pen *pen = board->pen;
    for (int step = 0; 1 - 0.05 * step > least; step++) {
        double width, height, squeeze = 1 - 0.05 * step;
        words->width = room / squeeze;
        if (pen_measure(pen, words, &width, &height) <= lines && width * squeeze <= room) {
            cairo_save(pen->cairo);
            cairo_translate(pen->cairo, x, y + 0.5 * height);
            cairo_scale(pen->cairo, squeeze, 1);
            pen_write(pen, words, 0, 0);
            cairo_restore(pen->cairo);
            return true;
        }
    }
    return false;
}

static void draw_label(const struct board *board, const struct hud_button *button, double x, double y)
{
    struct pen_words words = {.size = (double)HUD_TEXT * board->mm, .bold = true};
    double room = (double)button->width - 0.4 * board->mm;
    int language;
    words.text = hud_label(board->hud, button, &language);
    words.tag = hud_tag(language);
    if (*words.text && !fit_label(board, &words, x, y, room, 1, SQUEEZED_LINE)) {
        fit_label(board, &words, x, y, room, board->panel->labels, SQUEEZED);
    }
}

/* In the bubble: how the language that it brings is called, its first letters. */
static void draw_letters(const struct board *board, const struct hud_button *button, double x, double y, double radius)
{
    char letters[16] = "";
    size_t used = 0;
    const char *name = words_languages[button->value].name;
    for (int count = 0; *name && used + 4 < sizeof letters; name++) {
        bool begins = ((unsigned char)*name & 0xc0) != 0x80; /* of a character of UTF-8 */
        if (begins && count++ == 2) {
            break;
        }
        letters[used++] = *name;
    }
    struct pen_words words = {.text = letters, .tag = hud_tag(button->value), .size = 0.8 * radius, .bold = true};
    pen_set(board->pen, pen_dark, 1);
    pen_write(board->pen, &words, x, y - 0.14 * radius);
}

/* In the frame of its pictogram: the picture that there is. */
static void draw_thumb(const struct board *board, double x, double y, double radius)
{
    const struct hud_thumb *thumb = &board->hud->thumb;
    cairo_t *cairo = board->pen->cairo;
    if (thumb->width < 1 || thumb->height < 1) {
        return;
    }
    cairo_surface_t *picture = cairo_image_surface_create(CAIRO_FORMAT_RGB24, thumb->width, thumb->height);
    uint8_t *bytes = cairo_image_surface_get_data(picture);
    cairo_surface_flush(picture);
    for (int i = 0; bytes && i < thumb->width * thumb->height; i++) {
        uint32_t grey = thumb->grey[i] * 0x010101u;
        size_t at = (size_t)(i / thumb->width) * (size_t)cairo_image_surface_get_stride(picture) +
                    4 * (size_t)(i % thumb->width);
        memcpy(bytes + at, &grey, sizeof grey);
    }
    cairo_surface_mark_dirty(picture);
    double left = x + HUD_FRAME_LEFT * radius, top = y + HUD_FRAME_TOP * radius;
    double width = HUD_FRAME_WIDTH * radius, height = HUD_FRAME_HEIGHT * radius;
    double scale = fmax(width / thumb->width, height / thumb->height);
    cairo_save(cairo);
    cairo_rectangle(cairo, left, top, width, height);
    cairo_clip(cairo);
    cairo_translate(cairo, left + 0.5 * (width - scale * thumb->width), top + 0.5 * (height - scale * thumb->height));
    cairo_scale(cairo, scale, scale);
    cairo_set_source_surface(cairo, picture, 0, 0);
    cairo_paint(cairo);
    cairo_restore(cairo);
    cairo_surface_destroy(picture);
}

static void draw_ink(const struct board *board, const struct hud_button *button, double x, double y, double side)
{
    const struct pen *pen = board->pen;
    bool chosen = is_chosen(board->hud, board->panel, button);
    if (chosen) {
        cairo_new_path(pen->cairo);
        cairo_arc(pen->cairo, x, y, 0.5 * side - 0.6 * board->mm, 0, 2 * G_PI);
        pen_set(pen, (struct pen_colour){1, 1, 1}, 1);
        cairo_fill_preserve(pen->cairo);
        pen_set(pen, pen_dark, 1);
        cairo_set_line_width(pen->cairo, 1.2 * board->mm);
        cairo_stroke(pen->cairo);
    }
    struct pen_colour colours[3];
    for (int i = 0; i < 3; i++) {
        colours[i] = hud_ink_colour(board->hud, button->value, 0.75 + 0.375 * i);
    }
    hud_icon_ink(pen, colours, button->value, x, y, 0.44 * side, !chosen);
}

static void draw_ground(const struct board *board, int index, double x, double y)
{
    const struct pen *pen = board->pen;
    const struct hud_button *button = &board->panel->buttons[index];
    bool dark = button->kind != HUD_INK && is_chosen(board->hud, board->panel, button);
    bool pressed = hud_pressed(board->hud, board->number, index);
    double width = (double)button->width, height = (double)button->height;
    if (dark || pressed) {
        pen_card(pen, x, y, width, height, 3.4 * board->mm, 0, 0);
        pen_set(pen, pen_dark, dark ? 1 : 0.16);
        cairo_fill(pen->cairo);
    }
}

/* One-switch play is here: no eye misses it. */
static void draw_scan(const struct board *board, const struct hud_button *button, double x, double y)
{
    const struct pen *pen = board->pen;
    double mm = board->mm;
    for (int i = 0; i < 2; i++) {
        pen_card(pen, x, y, (double)button->width, (double)button->height, 3.4 * mm, 0, 0);
        pen_set(pen, i == 0 ? (struct pen_colour){1, 1, 1} : SCANNED, 1);
        cairo_set_line_width(pen->cairo, (i == 0 ? 2.8 : 1.6) * mm);
        cairo_stroke(pen->cairo);
    }
}

/* A folded button: there are more behind it. */
static void draw_fold(const struct board *board, double x, double y)
{
    for (int i = -1; i <= 1; i++) {
        cairo_new_path(board->pen->cairo);
        cairo_arc(board->pen->cairo, x + 1.7 * i * board->mm, y, 0.42 * board->mm, 0, 2 * G_PI);
        cairo_fill(board->pen->cairo);
    }
}

static void draw_button(const struct board *board, int index)
{
    const struct pen *pen = board->pen;
    const struct hud_button *button = &board->panel->buttons[index];
    double x = (double)button->x - board->left, y = (double)button->y - board->top;
    int lines = board->panel->labels;
    double label = lines > 0 ? ceil((double)(HUD_LABEL + (float)(lines - 1) * HUD_LINE) * board->mm) : 0;
    double side = fmin((double)button->width, (double)button->height - label);
    bool chosen = button->kind != HUD_INK && is_chosen(board->hud, board->panel, button);
    bool plain = lines > 0 && button->kind == HUD_INK; /* no word under it: it takes all the room */
    double middle = x + 0.5 * (double)button->width, across = y + 0.5 * (plain ? side + label : side);
    struct hud_icon_style style = {.line = chosen ? pen_paper : pen_dark, .ground = chosen ? pen_dark : pen_paper};
    style.wet = wet_of(board, chosen);
    if (button->kind == HUD_FINISH || button->kind == HUD_SEATED) {
        style.wet = pen_between(style.wet, style.ground, 0.55);
    }
    style.mirrored =
        (button->kind == HUD_UNDO || button->kind == HUD_REDO) && words_languages[board->hud->language].from_right;
    double lift = button->folded && button->kind != HUD_MORE ? 0.05 * side : 0;
    bool enabled = hud_enabled(board->hud, board->number, index);
    draw_ground(board, index, x, y);
    if (!enabled) {
        cairo_push_group(pen->cairo);
    }
    if (button->kind == HUD_INK) {
        draw_ink(board, button, middle, across - lift,
                 fmin(plain ? 1.35 * side : side, (double)button->width) - 2 * lift);
    } else {
        hud_icon_draw(pen, icon_of(board->hud, button), middle, across - lift, 0.41 * side, &style);
    }
    if (button->kind == HUD_PICTURE) {
        draw_thumb(board, middle, across - lift, 0.41 * side);
    }
    if (button->kind == HUD_LANGUAGE) {
        draw_letters(board, button, middle, across, 0.41 * side);
    }
    if (lines > 0) {
        pen_set(pen, style.line, 1);
        draw_label(board, button, middle, y + 0.97 * side);
    }
    pen_set(pen, style.line, 0.8);
    if (lift > 0) {
        draw_fold(board, middle, y + (double)button->height - 1.1 * board->mm);
    }
    if (!enabled) {
        cairo_pop_group_to_source(pen->cairo);
        cairo_paint_with_alpha(pen->cairo, 0.25);
    }
    if (board->panel->scanned == index) {
        draw_scan(board, button, x, y);
    }
}

bool hud_draw_panel(const struct hud *hud, int number, struct hud_image *image)
{
    const struct hud_panel *panel = &hud->panels[number];
    if (panel->count == 0) {
        bool had = image->rgba != NULL;
        hud_image_finish(image);
        return had;
    }
    struct pen pen;
    uint64_t key = panel_key(hud, number);
    double mm = (double)hud->mm, edge = ceil((double)HUD_EDGE * mm);
    int x = (int)floor((double)panel->x - edge), y = (int)floor((double)panel->y - edge);
    int width = (int)ceil((double)(panel->x + panel->width) + edge) - x;
    int height = (int)ceil((double)(panel->y + panel->height) + edge) - y;
    if (!hud_image_begin(image, key, width, height, &pen)) {
        return false;
    }
    struct board board = {hud, panel, number, &pen, mm, x, y};
    pen_draw_card(&pen, (double)panel->x - x, (double)panel->y - y, (double)panel->width, (double)panel->height, 5 * mm,
                  edge, 0.9);
    for (int i = 0; i < panel->count; i++) {
        draw_button(&board, i);
    }
    return hud_image_end(image, key, x, y, &pen);
}

bool hud_draw_cursor(const struct hud *hud, int ink, float share, struct hud_image *image)
{
    enum { STEPS = 60 };
    struct pen pen;
    int step = (int)lroundf(fminf(fmaxf(share, 0), 1) * STEPS);
    double mm = (double)hud->mm;
    int side = 2 * (int)ceil(9.5 * mm);
    uint64_t key = pen_hash_int(pen_hash_int(hud_key(hud, PIECE_CURSOR), ink), step);
    if (!hud_image_begin(image, key, side, side, &pen)) {
        return false;
    }
    double middle = 0.5 * side;
    struct pen_colour colour = hud_ink_colour(hud, ink, 1);
    cairo_arc(pen.cairo, middle, middle, 4.4 * mm, 0, 2 * G_PI);
    pen_set(&pen, pen_paper, 0.8);
    cairo_fill(pen.cairo);
    const double widths[] = {3.2, 2.2, 1.5};
    const struct pen_colour colours[] = {pen_paper, pen_dark, colour};
    for (int i = 0; i < 3; i++) { /* seen on any painting: dark between paper */
        cairo_new_path(pen.cairo);
        cairo_arc(pen.cairo, middle, middle, 5 * mm, 0, 2 * G_PI);
        pen_set(&pen, colours[i], i == 0 ? 0.85 : 1);
        cairo_set_line_width(pen.cairo, widths[i] * mm);
        cairo_stroke(pen.cairo);
    }
    pen_set(&pen, pen_dark, 1);
    hud_icon_mark(&pen, ink, middle, middle, 1.9 * mm);
    for (int i = 0; i < 2 && step > 0; i++) {
        cairo_new_path(pen.cairo);
        cairo_arc(pen.cairo, middle, middle, 7.6 * mm, -0.5 * G_PI, -0.5 * G_PI + 2 * G_PI * step / STEPS);
        pen_set(&pen, i == 0 ? pen_paper : pen_dark, i == 0 ? 0.9 : 1);
        cairo_set_line_width(pen.cairo, (i == 0 ? 2.6 : 1.6) * mm);
        cairo_stroke(pen.cairo);
    }
    return hud_image_end(image, key, 0, 0, &pen);
}

bool hud_draw_mark(const struct hud *hud, struct hud_image *image)
{
    struct pen pen;
    double mm = (double)hud->mm;
    int side = (int)ceil(5 * mm), edge = (int)ceil(2 * mm);
    uint64_t key = hud_key(hud, PIECE_MARK);
    if (!hud_image_begin(image, key, side, side, &pen)) {
        return false;
    }
    for (int i = 0; i < 2; i++) {
        pen_set(&pen, i == 0 ? pen_paper : pen_dark, i == 0 ? 0.5 : 0.6);
        cairo_set_line_width(pen.cairo, (i == 0 ? 0.9 : 0.4) * mm);
        cairo_move_to(pen.cairo, 0.5 * side, 0.18 * side);
        cairo_line_to(pen.cairo, 0.86 * side, 0.82 * side);
        cairo_line_to(pen.cairo, 0.14 * side, 0.82 * side);
        cairo_close_path(pen.cairo);
        cairo_move_to(pen.cairo, 0.5 * side, 0.42 * side);
        cairo_line_to(pen.cairo, 0.5 * side, 0.6 * side);
        cairo_move_to(pen.cairo, 0.5 * side, 0.71 * side);
        cairo_line_to(pen.cairo, 0.5 * side, 0.71 * side);
        cairo_stroke(pen.cairo);
    }
    return hud_image_end(image, key, (hud->def.width - side) / 2, edge, &pen);
}
