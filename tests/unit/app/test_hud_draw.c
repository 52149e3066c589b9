/* What is drawn beside the painting (app/hud/hud_draw.h): when it is drawn anew, that nothing is missing, that every
 * character has a shape. What it looks like: tests/figures, figure visit. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "hud_case.h"
#include "hud_draw.h"
#include "hud_icon.h"
#include "hud_image.h"
#include "hud_layout.h"
#include "ink.h"
#include "near.h"

enum { SHIPPED = 4 };

static void open_hud(struct hud *hud, struct hud_case *place, int screen, enum exhibit_side side, int language)
{
    hud_case_init(place, &hud_screens[screen], side);
    struct hud_def def = hud_case_def(place, &hud_screens[screen]);
    hud_init(hud, &def);
    hud->language = language;
    hud_layout(hud);
    hud_show(hud, true, 0);
}

static const uint8_t *pixel(const struct hud_image *image, int x, int y)
{
    assert_true(x >= 0 && x < image->width && y >= 0 && y < image->height);
    return image->rgba + 4 * ((size_t)y * (size_t)image->width + (size_t)x);
}

/* How much darkness there is in a rectangle of an image, 0 paper .. 1 black, on average. */
static double darkness(const struct hud_image *image, double x, double y, double width, double height)
{
    double sum = 0;
    int count = 0;
    for (int j = (int)y; j < (int)(y + height); j++) {
        for (int i = (int)x; i < (int)(x + width); i++, count++) {
            const uint8_t *p = pixel(image, i, j);
            sum += p[3] ? 1 - (p[0] + p[1] + p[2]) / (3.0 * p[3]) : 0;
        }
    }
    return sum / fmax(count, 1);
}

static double button_darkness(const struct hud *hud, const struct hud_image *image, int index, double from, double to)
{
    const struct hud_button *button = &hud->panels[0].buttons[index];
    double height = (double)button->height;
    return darkness(image, (double)button->x - image->x, (double)button->y - image->y + from * height,
                    (double)button->width, (to - from) * height);
}

static int find(const struct hud *hud, enum hud_kind kind, int value)
{
    for (int i = 0; i < hud->panels[0].count; i++) {
        if (hud->panels[0].buttons[i].kind == kind && hud->panels[0].buttons[i].value == value) {
            return i;
        }
    }
    fail_msg("no button of kind %d, value %d", kind, value);
    return -1;
}

/* Draws it; says whether it was drawn, and whether that was needed once only. */
static bool redrawn(const struct hud *hud, struct hud_image *image)
{
    bool drawn = hud_draw_panel(hud, 0, image);
    assert_false(hud_draw_panel(hud, 0, image));
    return drawn;
}

static void a_panel_is_drawn_anew_when_it_changes(void **state)
{
    (void)state;
    struct hud_case place;
    struct hud hud;
    struct hud_image image = {.rgba = NULL};
    open_hud(&hud, &place, 1, SIDE_OF_LEFT, 0);
    struct hud_panel *panel = &hud.panels[0];
    assert_true(redrawn(&hud, &image));
    panel->any_ink = false;
    assert_true(redrawn(&hud, &image));
    panel->ink = 1;
    assert_true(redrawn(&hud, &image));
    panel->tool = TOOL_GUIDE;
    assert_true(redrawn(&hud, &image));
    panel->can_undo = true;
    assert_true(redrawn(&hud, &image));
    panel->scanned = 3;
    assert_true(redrawn(&hud, &image));
    hud.fingers[5].used = hud.fingers[5].over = true;
    hud.fingers[5].button = 2;
    assert_true(redrawn(&hud, &image));
    hud.fingers[5].over = false;
    assert_true(redrawn(&hud, &image));
    place.script.inks[2] = ink_find("carbon black");
    assert_true(redrawn(&hud, &image));
    hud.language = 1;
    assert_true(redrawn(&hud, &image));
    panel->swapped = true;
    hud_layout(&hud);
    assert_true(redrawn(&hud, &image));
    hud_busy(&hud, 0, true, 5000000); /* none of this is to be seen on it */
    hud.panels[0].busy_us = 77;
    hud.fingers[5].slot = 9;
    assert_false(redrawn(&hud, &image));
    panel->count = 0;
    assert_true(redrawn(&hud, &image));
    assert_null(image.rgba);
    hud_image_finish(&image);
}

static void words_are_drawn_anew_when_they_change(void **state)
{
    (void)state;
    struct hud_case place;
    struct hud hud;
    struct hud_image image = {.rgba = NULL};
    open_hud(&hud, &place, 0, SIDE_OF_LEFT, 0);
    assert_true(hud_draw_countdown(&hud, 12, 0.8f, &image));
    assert_false(hud_draw_countdown(&hud, 12, 0.8f, &image) || hud_draw_countdown(&hud, 12, 0.8005f, &image));
    assert_true(hud_draw_countdown(&hud, 11, 0.8f, &image) && hud_draw_countdown(&hud, 11, 0.7f, &image));
    place.exhibit.texts[TEXT_STAY].in[0] = "Stay?";
    assert_true(hud_draw_countdown(&hud, 11, 0.7f, &image));
    hud.language = 2;
    assert_true(hud_draw_countdown(&hud, 11, 0.7f, &image) && !hud_draw_countdown(&hud, 11, 0.7f, &image));
    hud.language = 0;
    assert_true(hud_draw_sentence(&hud, TEXT_THANKS, &image) && !hud_draw_sentence(&hud, TEXT_THANKS, &image));
    assert_true(hud_draw_sentence(&hud, TEXT_CLOSED, &image));
    assert_true(hud_draw_invite(&hud, 3, &image) && !hud_draw_invite(&hud, 3, &image));
    assert_true(hud_draw_invite(&hud, 4, &image));
    place.exhibit.texts[TEXT_INVITE].in[0] = "Do come in";
    assert_true(hud_draw_invite(&hud, 4, &image));
    assert_true(hud_draw_cursor(&hud, 1, 0, &image) && !hud_draw_cursor(&hud, 1, 0, &image));
    assert_true(hud_draw_cursor(&hud, 2, 0, &image) && hud_draw_cursor(&hud, 2, 0.5f, &image));
    assert_true(hud_draw_mark(&hud, &image) && !hud_draw_mark(&hud, &image));
    assert_true(hud_draw_status(&hud, "a\tb\n", &image) && !hud_draw_status(&hud, "a\tb\n", &image));
    assert_true(hud_draw_status(&hud, "a\tc\n", &image));
    hud_image_finish(&image);
    hud_image_finish(&image);
}

static void check_image(const struct hud *hud, const struct hud_image *image)
{
    assert_true(image->x >= 0 && image->y >= 0 && image->x + image->width <= hud->def.width);
    assert_true(image->y + image->height <= hud->def.height);
    size_t seen = 0;
    for (size_t i = 0; i < 4 * (size_t)image->width * (size_t)image->height; i += 4) {
        const uint8_t *p = image->rgba + i;
        assert_true(p[0] <= p[3] && p[1] <= p[3] && p[2] <= p[3]);
        seen += p[3] > 0;
    }
    assert_true(seen > 20);
}

static void images_are_within_the_sheet_and_multiplied_by_alpha(void **state)
{
    (void)state;
    for (int screen = 0; screen < HUD_SCREENS; screen += 2) {
        for (int language = 0; language < SHIPPED; language += 2) {
            struct hud_case place;
            struct hud hud;
            struct hud_image image = {.rgba = NULL};
            open_hud(&hud, &place, screen, SIDE_OF_BOTTOM, language);
            hud_draw_panel(&hud, 0, &image);
            check_image(&hud, &image);
            hud_draw_invite(&hud, 15, &image);
            check_image(&hud, &image);
            hud_draw_countdown(&hud, 100, 1, &image);
            check_image(&hud, &image);
            hud_draw_sentence(&hud, TEXT_CLOSED, &image);
            check_image(&hud, &image);
            hud_draw_cursor(&hud, 3, 0.3f, &image);
            check_image(&hud, &image);
            hud_draw_mark(&hud, &image);
            check_image(&hud, &image);
            hud_image_finish(&image);
        }
    }
}

static void what_is_chosen_is_unmistakable(void **state)
{
    (void)state;
    struct hud_case place;
    struct hud hud;
    struct hud_image image = {.rgba = NULL};
    open_hud(&hud, &place, 1, SIDE_OF_BOTTOM, 0);
    hud.panels[0].tool = TOOL_POUR;
    hud.panels[0].ink = 2;
    hud.panels[0].any_ink = false;
    hud_draw_panel(&hud, 0, &image);
    for (int tool = 0; tool_fits(tool, SCENE_PAINTING); tool++) {
        double dark = button_darkness(&hud, &image, find(&hud, HUD_TOOL, tool), 0, 1);
        assert_true(tool == TOOL_POUR ? dark > 0.5 : dark < 0.3);
    }
    int undo = find(&hud, HUD_UNDO, 0);
    double dim = button_darkness(&hud, &image, undo, 0, 1), ink = button_darkness(&hud, &image, 2, 0, 1);
    hud.panels[0].can_undo = true;
    hud.panels[0].ink = 0;
    hud_draw_panel(&hud, 0, &image);
    assert_true(button_darkness(&hud, &image, undo, 0, 1) > 2 * dim);
    assert_true(ink > 0.05 + button_darkness(&hud, &image, 2, 0, 1));
    hud.panels[0].scanned = undo;
    hud_draw_panel(&hud, 0, &image);
    const struct hud_button *button = &hud.panels[0].buttons[undo];
    const uint8_t *p = pixel(&image, (int)button->x - image.x, (int)(button->y + button->height / 2) - image.y);
    assert_true(p[2] > 200 && p[0] < 40);
    hud_image_finish(&image);
}

static void every_button_says_what_it_is(void **state)
{
    (void)state;
    for (int screen = 2; screen < HUD_SCREENS; screen++) {
        for (int language = 0; language < SHIPPED; language++) {
            struct hud_case place;
            struct hud hud;
            struct hud_image image = {.rgba = NULL};
            open_hud(&hud, &place, screen, SIDE_OF_RIGHT, language);
            hud.panels[0].can_undo = hud.panels[0].can_redo = true;
            hud.panels[0].tool = -1;
            hud_draw_panel(&hud, 0, &image);
            assert_true(hud.panels[0].labels > 0);
            for (int i = 0; i < hud.panels[0].count; i++) {
                const struct hud_button *button = &hud.panels[0].buttons[i];
                double side = ceil(15 * (double)hud.mm), height = (double)button->height;
                assert_true(button_darkness(&hud, &image, i, 0, side / height) > 0.03);
                assert_true(button->kind == HUD_INK || button_darkness(&hud, &image, i, side / height,
                                                                       (side + 6 * (double)hud.mm) / height) > 0.03);
            }
            hud_image_finish(&image);
        }
    }
}

static void every_character_has_a_shape(void **state)
{
    (void)state;
    struct pen pen;
    assert_true(pen_open(&pen, 8, 8));
    for (int language = 0; language < WORDS_LANGUAGES && words_languages[language].tag; language++) {
        const char *tag = words_languages[language].tag;
        char number[64];
        hud_number(language, 1234567890, number, sizeof number);
        for (int bold = 0; bold < 2; bold++) {
            const struct pen_words name = {words_languages[language].name, tag, 20, 0, bold == 1};
            const struct pen_words digits = {number, tag, 20, 0, bold == 1};
            assert_int_equal(pen_unknown(&pen, &name) + pen_unknown(&pen, &digits), 0);
            for (int text = 0; text < TEXTS && language < SHIPPED; text++) {
                const struct pen_words words = {words_shipped((enum exhibit_text)text, language), tag, 20, 0,
                                                bold == 1};
                assert_non_null(words.text);
                assert_int_equal(pen_unknown(&pen, &words), 0);
            }
        }
    }
    const struct pen_words unknown = {"a\xee\x84\xa3", "en", 20, 0, false}; /* U+E123, of nobody */
    assert_int_equal(pen_unknown(&pen, &unknown), 1);
    const struct pen_words broken = {"a\xff\xfe z", "en", 20, 0, false}; /* no UTF-8: drawn as far as it goes */
    double width, height;
    pen_measure(&pen, &broken, &width, &height);
    assert_true(width > 10);
    pen_close(&pen, NULL);
}

/* Letters of Arabic join: a word is narrower than its letters alone. */
static void arabic_is_shaped(void **state)
{
    (void)state;
    struct pen pen;
    double together, alone, height;
    assert_true(pen_open(&pen, 8, 8));
    const struct pen_words word = {"\xd8\xaa\xd8\xaa\xd8\xaa\xd8\xaa", "ar", 40, 0, true};
    const struct pen_words letters = {"\xd8\xaa\xe2\x80\x8c\xd8\xaa\xe2\x80\x8c\xd8\xaa\xe2\x80\x8c\xd8\xaa", "ar", 40,
                                      0, true}; /* U+200C between them */
    pen_measure(&pen, &word, &together, &height);
    pen_measure(&pen, &letters, &alone, &height);
    assert_true(together < 0.8 * alone);
    pen_close(&pen, NULL);
}

static void capitals_are_high_enough(void **state)
{
    (void)state;
    struct pen pen;
    struct hud_image image = {.rgba = NULL};
    enum { SIDE = 400, MM = 10 };
    assert_true(pen_open(&pen, SIDE, SIDE));
    const struct pen_words words = {"H", "en", (double)HUD_TEXT * MM, 0, true};
    pen_set(&pen, (struct pen_colour){0, 0, 0}, 1);
    pen_write(&pen, &words, 0.5 * SIDE, 0.5 * SIDE);
    assert_true(hud_image_end(&image, 1, 0, 0, &pen));
    int top = SIDE, bottom = 0;
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            if (pixel(&image, x, y)[3] > 127) {
                top = y < top ? y : top;
                bottom = y;
            }
        }
    }
    assert_in_range(bottom - top + 1, 3.5 * MM, 5 * MM);
    hud_image_finish(&image);
}

/* WCAG 1.4.11: three to one. */
static void marks_are_seen_on_every_ink(void **state)
{
    (void)state;
    for (int ink = 0; inks[ink].name; ink++) {
        for (int mixing = 0; mixing < 2; mixing++) {
            struct pen_colour colour = pen_ink(ink, mixing, 1);
            double a = pen_luminance(colour) + 0.05, b = pen_luminance(hud_icon_mark_colour(colour)) + 0.05;
            assert_true(fmax(a, b) / fmin(a, b) >= 3);
        }
    }
}

/* On the smallest screen, too, nothing is cut off: between the words and the edge of their card there is paper. */
static void sentences_fit_on_every_screen(void **state)
{
    (void)state;
    for (int screen = 0; screen < HUD_SCREENS - 1; screen++) {
        for (int language = 0; language < SHIPPED; language++) {
            for (int what = 0; what < 3; what++) {
                struct hud_case place;
                struct hud hud;
                struct hud_image image = {.rgba = NULL};
                open_hud(&hud, &place, screen, SIDE_OF_LEFT, language);
                if (what == 0) {
                    hud_draw_countdown(&hud, 88, 1, &image);
                } else {
                    hud_draw_sentence(&hud, what == 1 ? TEXT_THANKS : TEXT_CLOSED, &image);
                }
                double unit = hud_unit(&hud), inner = ceil(4 * unit) + 1.5 * unit, corner = 10 * unit;
                double wide = image.width - 2 * corner, high = image.height - 2 * corner;
                assert_true(image.width <= hud.def.width && image.height < hud.def.height);
                assert_true(darkness(&image, inner, corner, unit, high) < 0.06);
                assert_true(darkness(&image, image.width - inner - unit, corner, unit, high) < 0.06);
                assert_true(darkness(&image, corner, image.height - inner - unit, wide, unit) < 0.06);
                assert_true(darkness(&image, corner, corner, wide, high) > 0.06);
                hud_image_finish(&image);
            }
        }
    }
}

static void seconds_are_in_the_digits_of_the_language(void **state)
{
    (void)state;
    char text[64], small[8];
    hud_number(words_find("en"), 25, text, sizeof text);
    assert_string_equal(text, "25");
    hud_number(words_find("ar"), 25, text, sizeof text);
    assert_string_equal(text, "\xd9\xa2\xd9\xa5"); /* U+0662 U+0665 */
    hud_number(words_find("ja"), -1, text, sizeof text);
    assert_string_equal(text, "-1");
    hud_number(words_find("ar"), 1234567, small, sizeof small); /* cut between characters */
    assert_string_equal(small, "\xd9\xa1\xd9\xa2\xd9\xa3");
    hud_with_seconds(words_find("en"), "in {seconds} s, {seconds}", 7, text, sizeof text);
    assert_string_equal(text, "in 7 s, 7");
    hud_with_seconds(words_find("ar"), "{seconds}", 7, text, sizeof text);
    assert_string_equal(text, "\xd9\xa7");
    hud_with_seconds(words_find("en"), "soon", 7, text, sizeof text);
    assert_string_equal(text, "soon");
    hud_with_seconds(words_find("en"), "a long sentence {seconds}", 7, small, sizeof small);
    assert_string_equal(small, "a long ");
}

static void the_staffs_view_takes_any_lines(void **state)
{
    (void)state;
    struct hud_case place;
    struct hud hud;
    struct hud_image image = {.rgba = NULL};
    char many[20000] = "";
    size_t used = 0;
    for (int i = 0; i < 90; i++) {
        used += (size_t)snprintf(
            many + used, sizeof many - used, "%s",
            "a name that is long enough to be cut somewhere\ta value \xff of no characters, \xd9\x82\n");
    }
    open_hud(&hud, &place, 0, SIDE_OF_LEFT, 0);
    assert_true(hud_draw_status(&hud, "", &image));
    double empty = darkness(&image, 0, 0, image.width, (double)hud.staff[0].y);
    assert_true(empty < 0.05);
    assert_true(hud_draw_status(&hud, "no value\n\tno name\nlast\tone", &image));
    assert_true(darkness(&image, 0, 0, image.width, (double)hud.staff[0].y) > empty + 0.002);
    assert_true(hud_draw_status(&hud, many, &image));
    check_image(&hud, &image);
    for (int i = 0; i < 2; i++) {
        const struct hud_button *button = &hud.staff[i];
        hud.fingers[0] = (struct hud_finger){.used = true, .panel = -1, .button = i, .over = true};
        double before =
            darkness(&image, (double)button->x, (double)button->y, (double)button->width, (double)button->height);
        assert_true(hud_draw_status(&hud, many, &image));
        assert_true(darkness(&image, (double)button->x, (double)button->y, (double)button->width,
                             (double)button->height) > 2 * before);
        hud.fingers[0].over = false;
        assert_true(hud_draw_status(&hud, many, &image));
    }
    hud_image_finish(&image);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_panel_is_drawn_anew_when_it_changes),
        cmocka_unit_test(words_are_drawn_anew_when_they_change),
        cmocka_unit_test(images_are_within_the_sheet_and_multiplied_by_alpha),
        cmocka_unit_test(what_is_chosen_is_unmistakable),
        cmocka_unit_test(every_button_says_what_it_is),
        cmocka_unit_test(every_character_has_a_shape),
        cmocka_unit_test(arabic_is_shaped),
        cmocka_unit_test(capitals_are_high_enough),
        cmocka_unit_test(marks_are_seen_on_every_ink),
        cmocka_unit_test(sentences_fit_on_every_screen),
        cmocka_unit_test(seconds_are_in_the_digits_of_the_language),
        cmocka_unit_test(the_staffs_view_takes_any_lines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
