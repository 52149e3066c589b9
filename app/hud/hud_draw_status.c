/* The staff's view. */
#include <math.h>
#include <string.h>

#include "hud_draw.h"
#include "hud_icon.h"
#include "hud_image.h"

enum { LINES = 64, BYTES = 300 };

struct table {
    char names[LINES][BYTES], values[LINES][BYTES];
    int count;
};

static void copy(char *to, const char *from, size_t length)
{
    length = length < BYTES - 1 ? length : BYTES - 1;
    while (length > 0 && ((unsigned char)from[length] & 0xc0) == 0x80) {
        length--; /* a character of UTF-8 is not cut */
    }
    memcpy(to, from, length);
    to[length] = '\0';
}

static void split(struct table *table, const char *lines)
{
    for (table->count = 0; *lines && table->count < LINES; table->count++) {
        size_t length = strcspn(lines, "\n"), name = strcspn(lines, "\t\n");
        copy(table->names[table->count], lines, name);
        copy(table->values[table->count], lines + (name < length ? name + 1 : name),
             name < length ? length - name - 1 : 0);
        lines += length + (lines[length] == '\n');
    }
}

/* Where the lines go: in one pair of columns or in two, as large as fits and no larger than is comfortable. */
struct field {
    double x, y, width, height, line;
    int pairs, rows;
};

static struct field field_of(const struct hud *hud, int count)
{
    double mm = (double)hud->mm, edge = fmin(14 * mm, 0.06 * hud->def.width);
    struct field field = {.x = edge, .y = 0.8 * edge};
    field.width = hud->def.width - 2 * edge;
    field.height = (double)hud->staff[0].y - 0.5 * edge - field.y;
    for (field.pairs = 1; field.pairs <= 2; field.pairs++) {
        field.rows = (count + field.pairs - 1) / field.pairs;
        field.line = fmin(10 * mm, field.height / fmax(field.rows, 1));
        if (field.line >= 6.5 * mm) {
            break;
        }
    }
    field.pairs = field.pairs > 2 ? 2 : field.pairs;
    return field;
}

static void draw_lines(const struct pen *pen, const struct table *table, const struct field *field)
{
    double pair = field->width / field->pairs, name = fmin(0.36 * pair, 7.5 * field->line);
    for (int i = 0; i < table->count; i++) {
        int column = i / field->rows;
        double x = field->x + column * pair, y = field->y + (i % field->rows + 0.5) * field->line;
        struct pen_words words = {.text = table->names[i], .tag = "en", .size = 0.56 * field->line};
        pen_set(pen, pen_dark, 0.66);
        pen_write_cut(pen, &words, x, y, name - 0.3 * field->line);
        words.text = table->values[i];
        words.bold = true;
        pen_set(pen, pen_dark, 1);
        pen_write_cut(pen, &words, x + name, y, pair - name - field->line);
        pen_set(pen, pen_dark, 0.1);
        cairo_rectangle(pen->cairo, x, y + 0.5 * field->line - 1, pair - field->line, 1);
        cairo_fill(pen->cairo);
    }
}

static void draw_staff_button(const struct hud *hud, const struct pen *pen, int index)
{
    static const char *const NAMES[] = {"Back", "Exit"}; /* the staff's words are English, as in the log */
    const struct hud_button *button = &hud->staff[index];
    double x = (double)button->x, y = (double)button->y, width = (double)button->width, height = (double)button->height;
    bool pressed = hud_pressed(hud, -1, index);
    struct hud_icon_style style = {.line = pressed ? pen_paper : pen_dark, .ground = pressed ? pen_dark : pen_paper};
    struct pen_words words = {.text = NAMES[index], .tag = "en", .size = 0.36 * height, .bold = true};
    double wide, high, radius = 0.26 * height, gap = 0.26 * height;
    style.wet = style.line;
    pen_card(pen, x, y, width, height, 0.24 * height, 0, 0);
    pen_set(pen, pressed ? pen_dark : (struct pen_colour){1, 1, 1}, 1);
    cairo_fill_preserve(pen->cairo);
    pen_set(pen, pen_dark, 0.9);
    cairo_set_line_width(pen->cairo, 0.05 * height);
    cairo_stroke(pen->cairo);
    pen_measure(pen, &words, &wide, &high);
    double left = x + 0.5 * (width - 2 * radius - gap - wide);
    hud_icon_draw(pen, index == 0 ? ICON_BACK : ICON_EXIT, left + radius, y + 0.5 * height, radius, &style);
    pen_set(pen, style.line, 1);
    pen_write(pen, &words, left + 2 * radius + gap + 0.5 * wide, y + 0.5 * height);
}

bool hud_draw_status(const struct hud *hud, const char *lines, struct hud_image *image)
{
    struct pen pen;
    struct table table;
    uint64_t key = pen_hash_text(hud_key(hud, PIECE_STATUS), lines);
    key = pen_hash_int(key, hud_pressed(hud, -1, 0) + 2 * hud_pressed(hud, -1, 1));
    if (!hud_image_begin(image, key, hud->def.width, hud->def.height, &pen)) {
        return false;
    }
    pen_set(&pen, pen_paper, 0.97);
    cairo_paint(pen.cairo);
    split(&table, lines);
    struct field field = field_of(hud, table.count);
    draw_lines(&pen, &table, &field);
    for (int i = 0; i < 2; i++) {
        draw_staff_button(hud, &pen, i);
    }
    return hud_image_end(image, key, 0, 0, &pen);
}
