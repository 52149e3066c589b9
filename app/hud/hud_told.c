#include "hud_told.h"

#include <math.h>

#include "hud_image.h"
#include "hud_layout.h"
#include "hud_map.h"
#include "words_option.h"

static const float STAYS = 3, COMES = 0.2f, GOES = 0.6f; /* s */
static const double TEXT = 6;                            /* mm: size of words */

static float seconds_since(uint64_t us, uint64_t now_us)
{
    return now_us > us ? (float)(now_us - us) * 1e-6f : 0;
}

float hud_told_opacity(const struct hud *hud, uint64_t now_us)
{
    if (hud->told_count == 0) {
        return 0;
    }
    float since = seconds_since(hud->told_us, now_us), begun = seconds_since(hud->told_begun_us, now_us);
    float left = (STAYS + GOES - since) / GOES;
    return fminf(fmaxf(fminf(begun / COMES, left), 0), 1);
}

void hud_tell(struct hud *hud, const struct key *key, float value, uint64_t now_us)
{
    bool shown = hud->told_count > 0 && seconds_since(hud->told_us, now_us) < STAYS + GOES;
    int at = 0;
    if (!shown) {
        hud->told_count = 0;
        hud->told_begun_us = now_us;
    }
    while (at < hud->told_count && hud->told[at].key != key) {
        at++;
    }
    if (at == HUD_TOLD) { /* the one that was turned longer ago goes */
        at = hud->told[0].us <= hud->told[1].us ? 0 : 1;
    }
    hud->told_count = at < hud->told_count ? hud->told_count : at + 1;
    hud->told[at] = (struct hud_told){key, value, now_us};
    hud->told_us = now_us;
}

int hud_told_timeout_ms(const struct hud *hud, uint64_t now_us)
{
    float since = seconds_since(hud->told_us, now_us), begun = seconds_since(hud->told_begun_us, now_us);
    if (hud->told_count == 0 || since > STAYS + GOES) {
        return -1;
    }
    return begun < COMES || since >= STAYS ? 0 : (int)ceilf(1000 * (STAYS - since));
}

/* A name and its value, as they are measured. */
struct line {
    char name[64], value[64], option[64];
    struct pen_words words[2];
    double widths[2], height;
};

static void measure_line(const struct hud *hud, const struct hud_told *told, const struct pen *pen, struct line *line)
{
    double mm = (double)hud->mm, high;
    const char *tag = hud_tag(hud->language);
    const char *name = words_option(told->key->name, hud->language, line->option, (int)sizeof line->option);
    words_value(told->key, told->value, hud->language, line->value, (int)sizeof line->value);
    line->words[0] = (struct pen_words){name, tag, TEXT * mm, 0, false};
    line->words[1] = (struct pen_words){line->value, tag, TEXT * mm, 0, true};
    line->height = 0;
    for (int i = 0; i < 2; i++) {
        pen_measure(pen, &line->words[i], &line->widths[i], &high);
        line->height = fmax(line->height, high);
    }
}

/* Where a card of that size belongs: beside the strip at its top, above one that lies; under or over an open map. */
static void place(const struct hud *hud, int panel, int width, int height, int *x, int *y)
{
    const struct hud_panel *of = &hud->panels[panel];
    const float *zone = hud->def.exhibit->seats[panel].zone;
    float map[4], gap = 1 * hud->mm, across = (float)hud->def.width, down = (float)hud->def.height;
    float left = of->x + of->width + gap, top = of->y;
    if (hud_map_place(hud, panel, map)) {
        left = map[0] + 0.5f * (map[2] - (float)width);
        top = map[1] + map[3] + gap;
        top = top + (float)height > zone[3] * down ? map[1] - gap - (float)height : top;
    } else if (of->side == SIDE_OF_RIGHT) {
        left = of->x - gap - (float)width;
    } else if (of->side == SIDE_OF_BOTTOM) {
        left = of->x + 0.5f * (of->width - (float)width);
        top = of->y - gap - (float)height;
    } else if (of->side == SIDE_OF_NONE || of->count == 0) {
        left = 0.5f * ((zone[0] + zone[2]) * across - (float)width);
        top = zone[3] * down - gap - (float)height;
    }
    *x = (int)fminf(fmaxf(left, 0), fmaxf(across - (float)width, 0));
    *y = (int)fminf(fmaxf(top, 0), fmaxf(down - (float)height, 0));
}

static uint64_t told_key(const struct hud *hud, int panel, const struct line *lines)
{
    const struct hud_panel *of = &hud->panels[panel];
    const float places[] = {of->x, of->y, of->width, of->height};
    float map[4] = {0};
    bool open = hud_map_place(hud, panel, map);
    uint64_t key = pen_hash(pen_hash_int(hud_key(hud, PIECE_TOLD), panel), places, sizeof places);
    key = pen_hash(pen_hash_int(key, open), map, sizeof map);
    for (int i = 0; i < hud->told_count; i++) {
        key = pen_hash_text(pen_hash_text(key, lines[i].words[0].text), lines[i].value);
    }
    return key;
}

bool hud_draw_told(const struct hud *hud, int panel, struct hud_image *image)
{
    struct line lines[HUD_TOLD];
    struct pen pen;
    double mm = (double)hud->mm, gap = 4 * mm, pad = 3.5 * mm, edge = ceil(3 * mm), names = 0, values = 0, high = 0;
    if (hud->told_count == 0 || !pen_open(&pen, 1, 1)) {
        return false;
    }
    for (int i = 0; i < hud->told_count; i++) {
        measure_line(hud, &hud->told[i], &pen, &lines[i]);
        names = fmax(names, lines[i].widths[0]);
        values = fmax(values, lines[i].widths[1]);
        high += lines[i].height;
    }
    pen_close(&pen, NULL);
    values = fmax(values, 12 * mm); /* so that digits that come and go do not shake it */
    int width = (int)ceil(names + gap + values + 2 * pad + 2 * edge), height = (int)ceil(high + 1.4 * pad + 2 * edge);
    uint64_t key = told_key(hud, panel, lines);
    if (!hud_image_begin(image, key, width, height, &pen)) {
        return false;
    }
    bool mirrored = words_languages[hud->language].from_right;
    double y = edge + 0.7 * pad;
    pen_draw_card(&pen, edge, edge, width - 2 * edge, height - 2 * edge, 4 * mm, edge, 0.94);
    for (int i = 0; i < hud->told_count; i++) {
        double name = edge + pad + 0.5 * lines[i].widths[0],
               value = edge + pad + names + gap + 0.5 * lines[i].widths[1];
        y += 0.5 * lines[i].height;
        pen_set(&pen, pen_dark, 0.8);
        pen_write(&pen, &lines[i].words[0], mirrored ? width - name : name, y);
        pen_set(&pen, pen_dark, 1);
        pen_write(&pen, &lines[i].words[1], mirrored ? width - value : value, y);
        y += 0.5 * lines[i].height;
    }
    int left, top;
    place(hud, panel, width, height, &left, &top);
    return hud_image_end(image, key, left, top, &pen);
}
