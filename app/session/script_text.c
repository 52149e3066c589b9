#include "script_text.h"

#include <math.h>
#include <stdlib.h>

#include "pen.h"
#include "rounded.h"
#include "script_action.h"

enum { LINE = 8 }; /* cells: thick letters starve within, lines live */

#define AT(field) offsetof(struct script_text, field)

const struct key script_text_keys[] = {
    {.name = "words",
     .type = KEY_TEXT,
     .unit = "text",
     .min = 1,
     .max = 400,
     .offset = AT(words),
     .required = true,
     .meaning = "What is written; lines end as they do in the file."},
    {.name = "at",
     .type = KEY_POINT,
     .unit = "0..1 of the sheet",
     .max = 1,
     .offset = AT(at),
     .meaning = "Middle of the words; of the sheet if left out."},
    {.name = "width",
     .type = KEY_NUMBER,
     .unit = "of the sheet's width",
     .min = 0.02,
     .max = 1,
     .initial = 0.86,
     .offset = AT(width),
     .meaning = "They are as large as fits into this width, and into the height."},
    {.name = "height",
     .type = KEY_NUMBER,
     .unit = "of the sheet's height",
     .min = 0.02,
     .max = 1,
     .initial = 0.8,
     .offset = AT(height),
     .meaning = "They are as large as fits into this height, and into the width."},
    {.name = "line",
     .type = KEY_NUMBER,
     .unit = "cells",
     .max = 64,
     .initial = LINE,
     .offset = AT(line),
     .meaning = "Width of the line around each letter; 0: it is filled, as all but doses are if this is left out."},
    {.name = NULL},
};

bool script_text_is_for(enum action_verb verb)
{
    return verb == ACTION_DOSE || verb == ACTION_STYLE || verb == ACTION_STRIKE;
}

/* The middle of the block at x, y. */
static void write_words(const struct pen *pen, const struct pen_words *words, double line, double x, double y)
{
    double wide, high;
    if (!(line > 0)) {
        pen_write(pen, words, x, y);
        return;
    }
    pen_measure(pen, words, &wide, &high);
    cairo_move_to(pen->cairo, x - 0.5 * wide, y - 0.5 * high);
    pango_cairo_layout_path(pen->cairo, pen->layout);
    cairo_set_line_width(pen->cairo, line);
    cairo_set_line_join(pen->cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(pen->cairo);
}

bool script_text_draw(const struct script_text *text, int width, int height, float *values)
{
    const double probe = 100; /* pixels, to measure by */
    struct pen pen;
    double wide, high, x = (double)text->at.x * width, y = (double)text->at.y * height;
    uint8_t *rgba = malloc(4 * (size_t)width * (size_t)height);
    if (!rgba || !pen_open(&pen, width, height)) {
        free(rgba);
        return false;
    }
    struct pen_words words = {.text = text->words, .tag = "en", .size = probe, .bold = true};
    pen_measure(&pen, &words, &wide, &high);
    words.size =
        probe * fmin((double)text->width * width / fmax(wide, 1), (double)text->height * height / fmax(high, 1));
    bool middle = !(text->at.x > 0) && !(text->at.y > 0);
    pen_set(&pen, pen_dark, 1);
    write_words(&pen, &words, (double)text->line, middle ? 0.5 * width : x, middle ? 0.5 * height : y);
    pen_close(&pen, rgba);
    for (size_t i = 0; i < (size_t)width * (size_t)height; i++) {
        values[i] = 1 - rounded((float)rgba[4 * i + 3] / 255);
    }
    free(rgba);
    return true;
}

static bool read_words(struct reader *reader, const struct yaml_node *node, enum action_verb verb,
                       struct script_text *text)
{
    int before = reader->report->count + reader->report->dropped;
    key_defaults(script_text_keys, text);
    text->line = verb == ACTION_DOSE ? LINE : 0;
    if (node->kind == YAML_MAPPING) {
        mapping_read(reader, script_text_keys, node, text, NULL);
    } else if (node->kind == YAML_SCALAR && !yaml_is_nothing(node)) {
        value_read(reader, &script_text_keys[0], node, text);
    } else {
        value_wrong_kind(reader, node, "words, or {words: WORDS, at: [x, y], ...}; see frond explain text");
    }
    return reader->report->count + reader->report->dropped == before && text->words;
}

bool script_text_read(struct reader *reader, const struct yaml_node *node, struct action *action)
{
    struct script_text text = {.words = NULL};
    int width = reader->script->width, height = reader->script->height;
    size_t count = (size_t)width * (size_t)height;
    if (!read_words(reader, node, action->verb, &text) || !script_take_values(reader, node, count)) {
        return false;
    }
    float *values = reader_take(reader, count * sizeof *values);
    bool good = values && script_text_draw(&text, width, height, values);
    if (values && !good) {
        reader_problem(reader, node, "memory is short");
    }
    action->picture = (struct action_raster){values, width, height, 1};
    return good;
}
