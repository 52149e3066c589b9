#include "hud_image.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hud_layout.h"
#include "ink.h"

static int ink_of(const struct hud *hud, int number)
{
    const struct exhibit *exhibit = hud->def.exhibit;
    return number >= 0 && number < hud_inks(hud) ? exhibit->scenes[hud->def.scene].script->inks[number] : INK_NONE;
}

void hud_image_finish(struct hud_image *image)
{
    free(image->rgba);
    cairo_surface_destroy(image->ground);
    *image = (struct hud_image){.rgba = NULL};
}

uint64_t hud_key(const struct hud *hud, enum hud_piece piece)
{
    uint64_t key = pen_hash_int(PEN_KEY, (int64_t)piece);
    key = pen_hash_int(pen_hash_int(key, hud->def.width), hud->def.height);
    key = pen_hash(key, &hud->mm, sizeof hud->mm);
    for (int i = 0; i < PAINTING_INKS; i++) {
        struct pen_colour colour = hud_ink_colour(hud, i, 1);
        key = pen_hash(pen_hash_int(key, ink_of(hud, i)), &colour, sizeof colour);
    }
    return pen_hash_text(key, hud_tag(hud->language));
}

bool hud_image_begin(struct hud_image *image, uint64_t key, int width, int height, struct pen *pen)
{
    return (!image->rgba || image->key != key) && width > 0 && height > 0 && pen_open(pen, width, height);
}

bool hud_image_end(struct hud_image *image, uint64_t key, int x, int y, struct pen *pen)
{
    int width = cairo_image_surface_get_width(pen->surface), height = cairo_image_surface_get_height(pen->surface);
    uint8_t *rgba = image->rgba;
    if (!rgba || image->width != width || image->height != height) {
        rgba = malloc(4 * (size_t)width * (size_t)height);
    }
    pen_close(pen, rgba);
    if (!rgba) {
        return false;
    }
    if (rgba != image->rgba) {
        free(image->rgba);
    }
    *image = (struct hud_image){rgba, width, height, x, y, key, image->ground, image->ground_key};
    return true;
}

double hud_unit(const struct hud *hud)
{
    double mm = (double)hud->mm;
    double share = fmin(hud->def.width / mm / 420, hud->def.height / mm / 250);
    return mm * fmin(fmax(share, 0.5), 1.5);
}

struct pen_colour hud_ink_colour(const struct hud *hud, int number, double thickness)
{
    int ink = ink_of(hud, number);
    if (ink == INK_NONE) {
        return pen_dark;
    }
    return pen_ink(ink, hud->def.exhibit->scenes[hud->def.scene].script->mode, thickness);
}

const char *hud_text(const struct hud *hud, enum exhibit_text text)
{
    return words_of(hud->def.exhibit->texts, text, hud->language);
}

const char *hud_tag(int language)
{
    return language >= 0 && language < WORDS_LANGUAGES && words_languages[language].tag ? words_languages[language].tag
                                                                                        : "en";
}

/* Whether a tag is of a language: "ar", "ar-EG". */
static bool is_language(const char *tag, const char *language)
{
    size_t length = strlen(language);
    return strncmp(tag, language, length) == 0 && (tag[length] == '\0' || tag[length] == '-');
}

void hud_number(int language, int value, char *text, size_t size)
{
    const char *tag = hud_tag(language), *zero = is_language(tag, "ar")   ? "\xd9\xa0" /* U+0660 */
                                                 : is_language(tag, "fa") ? "\xdb\xb0" /* U+06F0 */
                                                                          : NULL;
    char digits[16];
    size_t used = 0;
    snprintf(digits, sizeof digits, "%d", value);
    text[0] = '\0';
    for (const char *c = digits; *c && used + 3 <= size; c++) {
        if (zero && *c >= '0' && *c <= '9') {
            text[used++] = zero[0];
            text[used++] = (char)(zero[1] + (*c - '0'));
        } else {
            text[used++] = *c;
        }
        text[used] = '\0';
    }
}

void hud_with_seconds(int language, const char *text, int seconds, char *filled, size_t size)
{
    static const char PLACE[] = "{seconds}";
    char number[40];
    hud_number(language, seconds, number, sizeof number);
    filled[0] = '\0';
    for (const char *place; (place = strstr(text, PLACE)); text = place + sizeof PLACE - 1) {
        size_t used = strlen(filled);
        snprintf(filled + used, size - used, "%.*s%s", (int)(place - text), text, number);
    }
    size_t used = strlen(filled);
    snprintf(filled + used, size - used, "%s", text);
}
