#include "gpio_definition.h"

#include <stdio.h>
#include <string.h>

/* "button 'red'", "encoder 2" */
static void say_title(const char *kind, const char *name, int number, char *title)
{
    if (name && name[0]) {
        snprintf(title, GPIO_NAME, "%s '%.40s'", kind, name);
    } else {
        snprintf(title, GPIO_NAME, "%s %d", kind, number);
    }
}

static bool check_line(const char *title, const struct gpio_line_def *line, struct device_error *error)
{
    bool by_name = line->line && line->line[0], on_chip = line->chip && line->chip[0];
    if ((by_name && strlen(line->line) >= GPIO_NAME) || (on_chip && strlen(line->chip) >= GPIO_NAME)) {
        return device_fail(error, "%s: the name of a line or chip is shorter than %d characters", title, GPIO_NAME);
    }
    if (!by_name && !on_chip) {
        return device_fail(error, "%s: name the line, or give its chip and its offset", title);
    }
    if (!by_name && line->offset < 0) {
        return device_fail(error, "%s: offset %d, but lines are counted from 0", title, line->offset);
    }
    return true;
}

static bool check_button(const struct source_gpio_def *def, int number, struct device_error *error)
{
    const struct gpio_button_def *button = &def->buttons[number];
    char title[GPIO_NAME];
    say_title("button", button->name, number, title);
    if (button->debounce_ms < 0 || button->debounce_ms > GPIO_DEBOUNCE_MS) {
        return device_fail(error, "%s: debounce %d ms; it may be 0 to %d", title, button->debounce_ms,
                           GPIO_DEBOUNCE_MS);
    }
    return check_line(title, &button->line, error);
}

static bool check_encoder(const struct source_gpio_def *def, int number, struct device_error *error)
{
    const struct gpio_encoder_def *encoder = &def->encoders[number];
    char title[GPIO_NAME];
    say_title("encoder", encoder->name, number, title);
    if (encoder->steps != 1 && encoder->steps != 2 && encoder->steps != 4) {
        return device_fail(error, "%s: %d steps in a detent; there may be 1, 2 or 4", title, encoder->steps);
    }
    return check_line(title, &encoder->a, error) && check_line(title, &encoder->b, error);
}

static bool check_lamp(const struct source_gpio_def *def, int number, struct device_error *error)
{
    char title[GPIO_NAME];
    say_title("lamp", def->lamps[number].name, number, title);
    return check_line(title, &def->lamps[number].line, error);
}

static const struct gpio_line_def *line_of(const struct source_gpio_def *def, int number, char *title)
{
    int encoder = (number - def->button_count) / 2, lamp = number - def->button_count - 2 * def->encoder_count;
    if (number < def->button_count) {
        say_title("button", def->buttons[number].name, number, title);
        return &def->buttons[number].line;
    }
    if (lamp < 0) {
        say_title("encoder", def->encoders[encoder].name, encoder, title);
        return (number - def->button_count) % 2 == 0 ? &def->encoders[encoder].a : &def->encoders[encoder].b;
    }
    say_title("lamp", def->lamps[lamp].name, lamp, title);
    return &def->lamps[lamp].line;
}

static bool same_text(const char *a, const char *b)
{
    return strcmp(a ? a : "", b ? b : "") == 0;
}

static bool same_line(const struct gpio_line_def *a, const struct gpio_line_def *b)
{
    return same_text(a->chip, b->chip) && same_text(a->line, b->line) &&
           ((a->line && a->line[0]) || a->offset == b->offset);
}

static bool check_twice(const struct source_gpio_def *def, int count, struct device_error *error)
{
    char title[GPIO_NAME], other[GPIO_NAME];
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < i; j++) {
            if (same_line(line_of(def, i, title), line_of(def, j, other))) {
                return device_fail(error, "%s wants the line that %s has", title, other);
            }
        }
    }
    return true;
}

bool gpio_definition_check(const struct source_gpio_def *def, struct device_error *error)
{
    int64_t count = (int64_t)def->button_count + 2 * (int64_t)def->encoder_count + def->lamp_count;
    if (def->button_count < 0 || def->encoder_count < 0 || def->lamp_count < 0 || count > GPIO_LINES) {
        return device_fail(error, "GPIO: %lld lines; there may be %d", (long long)count, GPIO_LINES);
    }
    for (int i = 0; i < def->button_count; i++) {
        if (!check_button(def, i, error)) {
            return false;
        }
    }
    for (int i = 0; i < def->encoder_count; i++) {
        if (!check_encoder(def, i, error)) {
            return false;
        }
    }
    for (int i = 0; i < def->lamp_count; i++) {
        if (!check_lamp(def, i, error)) {
            return false;
        }
    }
    return check_twice(def, (int)count, error);
}

void gpio_definition_lines(const struct source_gpio_def *def, struct gpio_bank *bank)
{
    bank->count = def->button_count + 2 * def->encoder_count + def->lamp_count;
    for (int i = 0; i < bank->count; i++) {
        struct bank_line *line = &bank->lines[i];
        const struct gpio_line_def *wanted = line_of(def, i, line->title);
        snprintf(line->chip, sizeof line->chip, "%s", wanted->chip ? wanted->chip : "");
        snprintf(line->name, sizeof line->name, "%s", wanted->line ? wanted->line : "");
        line->offset = wanted->offset;
        line->request = (struct gpio_line_request){
            .output = i >= def->button_count + 2 * def->encoder_count,
            .active_low = wanted->active_low,
            .bias = wanted->bias,
            .debounce_us = i < def->button_count ? (uint32_t)def->buttons[i].debounce_ms * 1000u : 0,
        };
    }
}
