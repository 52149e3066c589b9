/* Buttons, rotary encoders and lamps on GPIO lines of the board. */
#include <stdlib.h>
#include <string.h>

#include "device_class.h"
#include "file_rows.h"
#include "source_gpio.h"
#include "word_lines.h"

enum { LINES_SHOWN = 64 };

static const struct key sections[] = {
    SECTION("gpio", "Buttons, encoders and lamps on lines of the board."),
    END,
};

static const char *const BIASES[] = {"as is", "none", "pull up", "pull down", NULL};
static const struct key gpio_keys[] = {
    SECTION("buttons", "A list of buttons."),
    SECTION("encoders", "A list of rotary encoders, each on two lines; a push button in it is a button."),
    SECTION("lamps", "A list of lamps."),
    END,
};

#define LINES    struct inputs_lines
#define LINES_ID TEXT("id", LINES, id, "a word", INPUTS_ID_BYTES, true, "What bindings call it.")
#define LINES_CHIP                                                                                                     \
    TEXT("chip", LINES, chip, "a label, name or path", INPUTS_NAME_BYTES, false,                                       \
         "Its chip, as `frond devices` prints it; any that has a line of the name if left out.")
#define LINES_BIAS(def)      CHOICE("bias", LINES, bias, BIASES, def, false, "Resistor of the board on the line.")
#define LINES_LOW(def, text) FLAG("active_low", LINES, active_low, def, text)
#define LINE_A(key, about)   TEXT(key, LINES, a.name, "a line\'s name or number", INPUTS_NAME_BYTES, true, about)
#define LINE_B(key, about)   TEXT(key, LINES, b.name, "a line\'s name or number", INPUTS_NAME_BYTES, true, about)

static const struct key button_keys[] = {
    LINES_ID,
    LINES_CHIP,
    LINE_A("line", "Its line: a name, GPIO17, or with a chip a number."),
    LINES_BIAS(INPUTS_PULL_UP),
    LINES_LOW(1, "Whether it is pressed when the line is low: a button between the line and ground."),
    WHOLE("debounce", LINES, debounce, "ms", 0, 100, 5, false, "How long the contact may bounce."),
    END,
};
static const struct key encoder_keys[] = {
    LINES_ID,
    LINES_CHIP,
    LINE_A("a", "Its first line."),
    LINE_B("b", "Its second line."),
    LINES_BIAS(INPUTS_PULL_UP),
    LINES_LOW(1, "Whether its contacts go to ground."),
    WHOLE("steps", LINES, steps, "changes a detent", 1, 4, 4, false, "1, 2 or 4."),
    FLAG("reversed", LINES, reversed, 0, "Whether it counts the other way."),
    END,
};
static const struct key lamp_keys[] = {
    LINES_ID,
    LINES_CHIP,
    LINE_A("line", "Its line: a name, GPIO17, or with a chip a number."),
    LINES_LOW(0, "Whether it is lit when the line is low."),
    TEXT("button", LINES, button_id, "the id of a button", INPUTS_ID_BYTES, false,
         "The button whose presses light it."),
    END,
};

static const struct inputs_table tables[] = {
    {"gpio", "What hangs on lines of the board.", gpio_keys},
    {"buttons", "A button on a GPIO line.", button_keys},
    {"encoders", "A rotary encoder on two GPIO lines.", encoder_keys},
    {"lamps", "A lamp on a GPIO line.", lamp_keys},
    {.name = NULL},
};

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
        value_wrong_kind(reader, item, "{id: WORD, line: GPIO17, ...}");
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

static void read(struct reader *reader, const struct yaml_node *root, struct inputs *inputs)
{
    static const char ALLOWED[] = "a list of {id: WORD, line: GPIO17, ...}";
    const struct yaml_node *gpio = yaml_get(root, "gpio");
    inputs_mapping(reader, root, "gpio", gpio_keys, inputs, "{buttons: [...], encoders: [...], lamps: [...]}");
    if (!gpio || gpio->kind != YAML_MAPPING) {
        return;
    }
    size_t length = reader_enter(reader, "gpio");
    struct lines_reading buttons = {inputs->buttons, &inputs->button_count, button_keys, inputs};
    struct lines_reading encoders = {inputs->encoders, &inputs->encoder_count, encoder_keys, inputs};
    struct lines_reading lamps = {inputs->lamps, &inputs->lamp_count, lamp_keys, inputs};
    inputs_list(reader, gpio, "buttons", INPUTS_LINES, ALLOWED, read_lines, &buttons);
    inputs_list(reader, gpio, "encoders", INPUTS_LINES, "a list of {id: WORD, a: GPIO5, b: GPIO6, ...}", read_lines,
                &encoders);
    inputs_list(reader, gpio, "lamps", INPUTS_LINES, ALLOWED, read_lines, &lamps);
    reader_leave(reader, length);
}

static struct names names_of_lines(const struct inputs_lines *lines, int count)
{
    struct names names = {.count = 0};
    for (int i = 0; i < count; i++) {
        names.names[names.count++] = lines[i].id ? lines[i].id : "";
    }
    return names;
}

static void read_button(struct reader *reader, const struct yaml_node *node, const struct inputs *inputs,
                        struct binding *binding)
{
    struct names names = names_of_lines(inputs->buttons, inputs->button_count);
    binding->control = (uint32_t)inputs_find(reader, "button", "gpio.buttons", node, &names);
}

/* Encoders are counted on after the last button, as in struct event. */
static void read_encoder(struct reader *reader, const struct yaml_node *node, const struct inputs *inputs,
                         struct binding *binding)
{
    struct names names = names_of_lines(inputs->encoders, inputs->encoder_count);
    binding->control = (uint32_t)(inputs_find(reader, "encoder", "gpio.encoders", node, &names) + inputs->button_count);
}

static bool name_lines(const struct inputs_lines *lines, int count, uint32_t index, char *text, size_t size)
{
    bool is = index < (uint32_t)count;
    if (is) {
        snprintf(text, size, "%s", lines[index].id);
    }
    return is;
}

static bool name_button(const struct inputs *inputs, uint32_t control, char *text, size_t size)
{
    return name_lines(inputs->buttons, inputs->button_count, control, text, size);
}

static bool name_encoder(const struct inputs *inputs, uint32_t control, char *text, size_t size)
{
    return name_lines(inputs->encoders, inputs->encoder_count, control - (uint32_t)inputs->button_count, text, size);
}

static const struct binding_source sources[] = {
    {.key = SECTION("button", "Source: a button on a GPIO line, by its id."),
     .source = SOURCE_GPIO,
     .read = read_button,
     .name = name_button},
    {.key = SECTION("encoder", "Source: a rotary encoder on GPIO lines, by its id."),
     .source = SOURCE_GPIO,
     .turned = true,
     .read = read_encoder,
     .name = name_encoder},
    {.key = END},
};

static struct gpio_line_def line_of(const struct inputs_lines *lines, const struct inputs_line *line)
{
    static const enum gpio_bias OF_BOARD[] = {[INPUTS_AS_IS] = GPIO_BIAS_AS_IS,
                                              [INPUTS_NO_BIAS] = GPIO_BIAS_NONE,
                                              [INPUTS_PULL_UP] = GPIO_BIAS_PULL_UP,
                                              [INPUTS_PULL_DOWN] = GPIO_BIAS_PULL_DOWN};
    return (struct gpio_line_def){.chip = lines->chip,
                                  .line = line->name,
                                  .offset = line->offset,
                                  .bias = OF_BOARD[lines->bias],
                                  .active_low = lines->active_low};
}

static struct source *create(const struct sources_def *def, struct device_error *error)
{
    const struct inputs *inputs = def->inputs;
    struct gpio_button_def buttons[INPUTS_LINES];
    struct gpio_encoder_def encoders[INPUTS_LINES];
    struct gpio_lamp_def lamps[INPUTS_LINES];
    for (int i = 0; i < inputs->button_count; i++) {
        const struct inputs_lines *from = &inputs->buttons[i];
        buttons[i] = (struct gpio_button_def){from->id, line_of(from, &from->a), from->debounce};
    }
    for (int i = 0; i < inputs->encoder_count; i++) {
        const struct inputs_lines *from = &inputs->encoders[i];
        encoders[i] = (struct gpio_encoder_def){from->id, line_of(from, &from->a), line_of(from, &from->b), from->steps,
                                                from->reversed};
    }
    for (int i = 0; i < inputs->lamp_count; i++) {
        const struct inputs_lines *from = &inputs->lamps[i];
        lamps[i] = (struct gpio_lamp_def){from->id, line_of(from, &from->a)};
    }
    const struct source_gpio_def gpio = {buttons, inputs->button_count, encoders, inputs->encoder_count,
                                         lamps,   inputs->lamp_count};
    bool used = gpio.button_count + gpio.encoder_count + gpio.lamp_count > 0;
    return used || def->look ? source_gpio_create(&gpio, error) : NULL;
}

static void print(const struct source *source, const struct device *device, FILE *out)
{
    struct gpio_line_info lines[LINES_SHOWN];
    struct word_lines words = {out, 0};
    int count = source_gpio_lines(source, device->id, lines, LINES_SHOWN);
    for (int i = 0; i < count && i < LINES_SHOWN; i++) {
        const struct gpio_line_info *line = &lines[i];
        char text[2 * GPIO_NAME + 32], taken[GPIO_NAME + 16] = "";
        if (line->used) {
            snprintf(taken, sizeof taken, " (taken%s%.60s)", *line->consumer ? " by " : "", line->consumer);
        }
        snprintf(text, sizeof text, "%d%s%.60s%s", i, *line->name ? " " : "", line->name, taken);
        word_lines_add(&words, text);
    }
    if (count > LINES_SHOWN) {
        char text[32];
        snprintf(text, sizeof text, "and %d more", count - LINES_SHOWN);
        word_lines_add(&words, text);
    }
    word_lines_end(&words);
}

const struct device_class class_gpio = {
    .source = "gpio",
    .noun = "gpio",
    .none = "no GPIO chip: the board has none, or the kernel offers none (/dev/gpiochip*)",
    .sections = sections,
    .tables = tables,
    .sources = sources,
    .read = read,
    .create = create,
    .print = print,
};
