#include "hud_map.h"

#include <math.h>
#include <string.h>

#include "dish_map.h"
#include "hud_icon.h"
#include "hud_image.h"
#include "hud_layout.h"
#include "words_option.h"

/* mm. */
static const float MOST = 150, LEAST = 60; /* side of its card */
static const float PAD = 4;                /* from the card's edge to the plot */
static const float CAPTION = 8;            /* under the plot */
static const float FELT = 0.3f;            /* how visible it must be to take a finger */

/* The part of the sheet that a palette is in: its zone, or what of it a seated visitor reaches. */
static void bounds_of(const struct hud *hud, int panel, float bounds[4])
{
    const float *zone = hud->def.exhibit->seats[panel].zone, *seated = hud->def.exhibit->access.zone;
    const float sizes[4] = {(float)hud->def.width, (float)hud->def.height, (float)hud->def.width,
                            (float)hud->def.height};
    for (int i = 0; i < 4; i++) {
        float side = i < 2 ? fmaxf(zone[i], seated[i]) : fminf(zone[i], seated[i]);
        bounds[i] = sizes[i] * (hud->seated ? side : zone[i]);
    }
}

static float clamp(float value, float least, float most)
{
    return fmaxf(fminf(value, most), least);
}

bool hud_map_place(const struct hud *hud, int panel, float place[4])
{
    const struct hud_panel *of = &hud->panels[panel];
    float bounds[4], mm = hud->mm, gap = 3 * mm, edge = HUD_EDGE * mm;
    if (of->tool != TOOL_MAP || hud_kind_of_scene(hud) != SCENE_CHEMISTRY) {
        return false;
    }
    bounds_of(hud, panel, bounds);
    bool lies = of->side == SIDE_OF_BOTTOM, stands = of->side == SIDE_OF_LEFT || of->side == SIDE_OF_RIGHT;
    float across = bounds[2] - bounds[0] - 2 * edge - (stands ? of->width + gap : 0);
    float down = bounds[3] - bounds[1] - 2 * edge - (lies ? of->height + gap : 0);
    float side = fminf(fminf(0.8f * across, down), MOST * mm);
    side = fminf(side, fmaxf(stands ? of->height : side, LEAST * mm));
    place[2] = place[3] = floorf(fmaxf(side, 1));
    place[0] = of->side == SIDE_OF_LEFT    ? of->x + of->width + gap
               : of->side == SIDE_OF_RIGHT ? of->x - gap - side
                                           : 0.5f * (bounds[0] + bounds[2] - side);
    place[1] = lies     ? of->y - gap - side
               : stands ? of->y + 0.5f * (of->height - side)
                        : 0.5f * (bounds[1] + bounds[3] - side);
    place[0] = roundf(clamp(place[0], bounds[0] + edge, bounds[2] - edge - side));
    place[1] = roundf(clamp(place[1], bounds[1] + edge, bounds[3] - edge - side));
    return true;
}

/* Where the plot is on the card: left, top, width, height. */
static void plot_of(const struct hud *hud, const float place[4], float plot[4])
{
    float pad = PAD * hud->mm;
    plot[0] = place[0] + pad;
    plot[1] = place[1] + pad;
    plot[2] = fmaxf(place[2] - 2 * pad, 1);
    plot[3] = fmaxf(place[3] - 2 * pad - CAPTION * hud->mm, 1);
}

void hud_map_stand(struct hud *hud, const struct scene_options *options)
{
    hud->map_feed = options->chemistry.reaction.feed;
    hud->map_kill = options->chemistry.reaction.kill;
}

int hud_map_at(const struct hud *hud, float x, float y, uint64_t now_us)
{
    for (int i = 0; i < hud->count; i++) {
        float place[4];
        if (hud_map_place(hud, i, place) && hud_opacity(hud, i, now_us) >= FELT && x >= place[0] &&
            x < place[0] + place[2] && y >= place[1] && y < place[1] + place[3]) {
            return i;
        }
    }
    return -1;
}

void hud_map_pick(struct hud *hud, int panel, float x, float y)
{
    float place[4], plot[4];
    if (hud_map_place(hud, panel, place)) {
        plot_of(hud, place, plot);
        struct dish_place rates = dish_map_place((struct point){(x - plot[0]) / plot[2], (y - plot[1]) / plot[3]});
        hud->panels[panel].picked[0] = rates.feed;
        hud->panels[panel].picked[1] = rates.kill;
        hud->panels[panel].has_picked = true;
    }
}

bool hud_map_tap(struct hud *hud, float x, float y, uint64_t now_us)
{
    float column = x * (float)hud->def.width, row = y * (float)hud->def.height;
    int panel = hud_map_at(hud, column, row, now_us);
    if (panel >= 0) {
        hud_map_pick(hud, panel, column, row);
    }
    return panel >= 0;
}

bool hud_map_picked(struct hud *hud, int panel, int options[2], float values[2])
{
    static const char *const NAMES[2] = {"feed", "kill"};
    const struct key *keys = scene_options_keys(SCENE_CHEMISTRY);
    struct hud_panel *of = &hud->panels[panel];
    bool picked = of->has_picked;
    for (int i = 0; i < 2; i++) {
        const struct key *key = key_find(keys, NAMES[i]);
        options[i] = key ? (int)(key - keys) : -1;
        values[i] = of->picked[i];
    }
    of->has_picked = false;
    return picked;
}

static void draw_plot(const struct pen *pen, const float plot[4])
{
    int width = (int)plot[2], height = (int)plot[3];
    cairo_surface_t *picture = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    uint8_t *bytes = cairo_image_surface_get_data(picture);
    uint8_t *rgb = malloc((size_t)width * (size_t)height * 3);
    cairo_surface_flush(picture);
    if (bytes && rgb) {
        const uint8_t *from = rgb;
        dish_map_fill(width, height, rgb);
        for (int i = 0; i < width * height; i++, from += 3) {
            uint32_t pixel = (uint32_t)from[0] << 16 | (uint32_t)from[1] << 8 | from[2];
            size_t at = (size_t)(i / width) * (size_t)cairo_image_surface_get_stride(picture) + 4 * (size_t)(i % width);
            memcpy(bytes + at, &pixel, sizeof pixel);
        }
        cairo_surface_mark_dirty(picture);
        cairo_set_source_surface(pen->cairo, picture, (double)plot[0], (double)plot[1]);
        cairo_rectangle(pen->cairo, (double)plot[0], (double)plot[1], width, height);
        cairo_fill_preserve(pen->cairo);
        pen_set(pen, pen_dark, 0.5);
        cairo_set_line_width(pen->cairo, 1);
        cairo_stroke(pen->cairo);
    }
    free(rgb);
    cairo_surface_destroy(picture);
}

/* Pearson's letters, where they belong. */
static void draw_letters(const struct hud *hud, const struct pen *pen, const float plot[4])
{
    double mm = (double)hud->mm;
    pen_set(pen, pen_paper, 1); /* the map is dark */
    for (const struct gray_scott_preset *preset = gray_scott_presets; preset->name; preset++) {
        struct point at = dish_map_at(preset->feed, preset->kill);
        struct pen_words words = {preset->letter, "el", fmax(4.2 * mm, 0.035 * (double)plot[2]), 0, true};
        if (at.x > 0 && at.x < 1 && at.y > 0 && at.y < 1) {
            pen_write(pen, &words, (double)(plot[0] + at.x * plot[2]), (double)(plot[1] + at.y * plot[3]));
        }
    }
}

static void draw_now(const struct hud *hud, const struct pen *pen, const float plot[4])
{
    struct point at = dish_map_at(hud->map_feed, hud->map_kill);
    double mm = (double)hud->mm, x = (double)(plot[0] + clamp(at.x, 0, 1) * plot[2]),
           y = (double)(plot[1] + clamp(at.y, 0, 1) * plot[3]);
    const double widths[] = {2.6, 1.4};
    const struct pen_colour colours[] = {pen_paper, pen_dark};
    for (int i = 0; i < 2; i++) {
        cairo_new_path(pen->cairo);
        cairo_arc(pen->cairo, x, y, 4 * mm, 0, 2 * G_PI);
        pen_set(pen, colours[i], 1);
        cairo_set_line_width(pen->cairo, widths[i] * mm);
        cairo_stroke(pen->cairo);
    }
}

/* Both rates, and the class that is nearest. */
static void draw_caption(const struct hud *hud, const struct pen *pen, const float place[4])
{
    static const char *const NAMES[2] = {"feed", "kill"};
    const struct key *keys = gray_scott_keys;
    const struct gray_scott_preset *preset = gray_scott_preset_near(hud->map_feed, hud->map_kill);
    const float rates[2] = {hud->map_feed, hud->map_kill};
    char text[300] = "", word[64], value[64];
    for (int i = 0; i < 2; i++) {
        const struct key *key = key_find(keys, NAMES[i]);
        words_value(key, rates[i], hud->language, value, (int)sizeof value);
        size_t used = strlen(text);
        snprintf(text + used, sizeof text - used, "%s %s   ",
                 words_option(NAMES[i], hud->language, word, (int)sizeof word), value);
    }
    size_t used = strlen(text);
    snprintf(text + used, sizeof text - used, "%s %s", preset->letter,
             words_option(preset->name, hud->language, word, (int)sizeof word));
    double mm = (double)hud->mm, room = (double)(place[2] - 2 * PAD * hud->mm), wide, high;
    struct pen_words words = {text, hud_tag(hud->language), 4.6 * mm, 0, true};
    pen_measure(pen, &words, &wide, &high);
    words.size *= wide > room ? room / wide : 1;
    pen_set(pen, pen_dark, 1);
    pen_write(pen, &words, (double)(place[0] + 0.5f * place[2]),
              (double)(place[1] + place[3]) - (0.5 * (double)CAPTION + 0.4 * (double)PAD) * mm);
}

bool hud_draw_map(const struct hud *hud, int panel, struct hud_image *image)
{
    struct pen pen;
    float place[4], plot[4];
    if (!hud_map_place(hud, panel, place)) {
        return false;
    }
    int edge = (int)ceilf(3 * hud->mm), x = (int)place[0] - edge, y = (int)place[1] - edge;
    const float rates[2] = {hud->map_feed, hud->map_kill};
    uint64_t key = pen_hash(pen_hash_int(hud_key(hud, PIECE_MAP), panel), place, sizeof place);
    key = pen_hash(key, rates, sizeof rates);
    int side = (int)place[2] + 2 * edge;
    if (!hud_image_begin(image, key, side, side, &pen)) {
        return false;
    }
    place[0] = place[1] = (float)edge;
    plot_of(hud, place, plot);
    pen_draw_card(&pen, (double)place[0], (double)place[1], (double)place[2], (double)place[3], 5 * (double)hud->mm,
                  edge, 0.96);
    draw_plot(&pen, plot);
    draw_letters(hud, &pen, plot);
    draw_now(hud, &pen, plot);
    draw_caption(hud, &pen, place);
    return hud_image_end(image, key, x, y, &pen);
}
