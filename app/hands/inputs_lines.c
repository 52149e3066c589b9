#include <stdlib.h>
#include <string.h>

#include "inputs_read.h"

struct lines_reading {
    struct inputs_lines *lines;
    int *count;
    const struct key *keys;
    const struct inputs *inputs;
};

/* "17" without quotes is the number of a line, all else its name. */
static void name_line(struct reader *reader, const struct yaml_node *item, const char *key, const char *chip,
                      struct inputs_line *line)
{
    enum { OFFSET_DIGITS = 4 };
    const struct yaml_node *node = yaml_get(item, key);
    if (!line->name || !node || !node->plain) {
        return;
    }
    size_t digits = strspn(line->name, "0123456789");
    if (line->name[digits]) {
        return;
    }
    size_t length = reader_enter(reader, key);
    if (digits > OFFSET_DIGITS) {
        reader_problem(reader, node, "%.40s is out of range; 0 to 9999, or a line's name", line->name);
    } else if (!chip) {
        reader_problem(reader, node, "the number of a line on no chip; chip: LABEL beside it, or the line's name");
    }
    line->offset = digits <= OFFSET_DIGITS ? (int)strtol(line->name, NULL, 10) : 0;
    line->name = NULL;
    reader_leave(reader, length);
}

static void check_steps(struct reader *reader, const struct yaml_node *item, const struct inputs_lines *lines)
{
    if (yaml_get(item, "steps") && lines->steps == 3) {
        size_t length = reader_enter(reader, "steps");
        reader_problem(reader, yaml_get(item, "steps"), "3 is not it; 1, 2 or 4 changes a detent");
        reader_leave(reader, length);
    }
}

static int find_lines(const struct inputs_lines *lines, int count, const char *id)
{
    for (int i = 0; i < count; i++) {
        if (lines[i].id && strcmp(lines[i].id, id) == 0) {
            return i;
        }
    }
    return -1;
}

static void find_button(struct reader *reader, const struct yaml_node *item, const struct inputs *inputs,
                        struct inputs_lines *lamp)
{
    char allowed[1024], found[128];
    const struct yaml_node *node = yaml_get(item, "button");
    lamp->button = lamp->button_id ? find_lines(inputs->buttons, inputs->button_count, lamp->button_id) : -1;
    if (!lamp->button_id || lamp->button >= 0) {
        return;
    }
    struct names names = {.count = 0};
    for (int i = 0; i < inputs->button_count; i++) {
        names.names[names.count++] = inputs->buttons[i].id ? inputs->buttons[i].id : "";
    }
    size_t length = reader_enter(reader, "button");
    reader_problem(reader, node, "unknown button %s; %s", yaml_found(node, found, sizeof found),
                   names.count ? names_allowed(&names, lamp->button_id, allowed, sizeof allowed)
                               : "there are none in gpio.buttons");
    reader_leave(reader, length);
}

static void read_lines(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct lines_reading *reading = context;
    struct inputs_lines *lines = &reading->lines[*reading->count];
    (void)index;
    if (item->kind != YAML_MAPPING) {
        inputs_wrong_kind(reader, item, "{id: WORD, line: GPIO17, ...}");
        return;
    }
    key_defaults(reading->keys, lines);
    mapping_read(reader, reading->keys, item, lines, NULL);
    name_line(reader, item, reading->keys == encoder_keys ? "a" : "line", lines->chip, &lines->a);
    if (reading->keys == encoder_keys) {
        name_line(reader, item, "b", lines->chip, &lines->b);
        check_steps(reader, item, lines);
    }
    lines->button = -1;
    if (reading->keys == lamp_keys) {
        find_button(reader, item, reading->inputs, lines);
    }
    if (lines->id && find_lines(reading->lines, *reading->count, lines->id) >= 0) {
        size_t length = reader_enter(reader, "id");
        reader_problem(reader, yaml_get(item, "id"), "'%s' is there already; another word", lines->id);
        reader_leave(reader, length);
    }
    (*reading->count)++;
}

void inputs_read_lines(struct reader *reader, const struct yaml_node *root, struct inputs *inputs)
{
    static const char ALLOWED[] = "a list of {id: WORD, line: GPIO17, ...}";
    const struct yaml_node *gpio = yaml_get(root, "gpio");
    if (!gpio || yaml_is_nothing(gpio)) {
        return;
    }
    size_t length = reader_enter(reader, "gpio");
    if (gpio->kind != YAML_MAPPING) {
        inputs_wrong_kind(reader, gpio, "{buttons: [...], encoders: [...], lamps: [...]}");
        reader_leave(reader, length);
        return;
    }
    struct lines_reading buttons = {inputs->buttons, &inputs->button_count, button_keys, inputs};
    struct lines_reading encoders = {inputs->encoders, &inputs->encoder_count, encoder_keys, inputs};
    struct lines_reading lamps = {inputs->lamps, &inputs->lamp_count, lamp_keys, inputs};
    inputs_list(reader, gpio, "buttons", INPUTS_LINES, ALLOWED, read_lines, &buttons);
    inputs_list(reader, gpio, "encoders", INPUTS_LINES, "a list of {id: WORD, a: GPIO5, b: GPIO6, ...}", read_lines,
                &encoders);
    inputs_list(reader, gpio, "lamps", INPUTS_LINES, ALLOWED, read_lines, &lamps);
    reader_leave(reader, length);
}
