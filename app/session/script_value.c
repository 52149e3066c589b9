#include "script_value.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "ink.h"
#include "scene.h"

enum { PATH_POINTS_MAX = 10000 };

size_t reader_enter(struct reader *reader, const char *name)
{
    size_t length = strlen(reader->path);
    snprintf(reader->path + length, sizeof reader->path - length, "%s%.40s", length ? "." : "", name);
    return length;
}

size_t reader_enter_index(struct reader *reader, int index)
{
    size_t length = strlen(reader->path);
    snprintf(reader->path + length, sizeof reader->path - length, "[%d]", index);
    return length;
}

void reader_leave(struct reader *reader, size_t length)
{
    reader->path[length] = '\0';
}

void reader_problem(struct reader *reader, const struct yaml_node *at, const char *format, ...)
{
    char message[1536];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    report_add(reader->report, at->line, at->column, reader->path, "%s", message);
}

bool key_is_section(const struct key *key)
{
    return strcmp(key->unit, "section") == 0;
}

void value_wrong_kind(struct reader *reader, const struct yaml_node *node, const char *allowed)
{
    char found[128];
    if (node->kind != YAML_REFUSED) {
        reader_problem(reader, node, "%s; %s", yaml_found(node, found, sizeof found), allowed);
    }
}

bool reader_adopt(struct reader *reader, void *block)
{
    struct script_memory *memory = block ? malloc(sizeof *memory) : NULL;
    if (!memory) {
        free(block);
        report_add(reader->report, 0, 0, "", "memory is short");
        return false;
    }
    *memory = (struct script_memory){.next = reader->script->memory, .block = block};
    reader->script->memory = memory;
    return true;
}

void reader_names(const struct reader *reader, const char *path)
{
    if (reader->def->names) {
        reader->def->names(reader->def->names_data, reader->folder, path);
    }
}

void *reader_take(struct reader *reader, size_t size)
{
    void *block = calloc(1, size ? size : 1);
    return reader_adopt(reader, block) ? block : NULL;
}

const char *value_allowed(const struct key *key, char *buffer, size_t size)
{
    static const char SHEET[] = "0..1 of the sheet";
    const char *unit = key->unit;
    if (strncmp(unit, SHEET, sizeof SHEET - 1) == 0) {
        unit = "of the sheet"; /* the range stands before it */
    }
    switch (key->type) {
    case KEY_NUMBER:
    case KEY_INTEGER:
        if (key->min < key->max) {
            snprintf(buffer, size, "%.10g to %.10g%s%s", key->min, key->max, *unit ? " " : "", unit);
        } else {
            snprintf(buffer, size, "only %.10g%s%s", key->min, *unit ? " " : "", unit);
        }
        break;
    case KEY_FLAG:
        snprintf(buffer, size, "true or false");
        break;
    case KEY_POINT:
        snprintf(buffer, size, "[x, y], each %g to %g%s%s", key->min, key->max, *unit ? " " : "", unit);
        break;
    case KEY_PATH:
        snprintf(buffer, size, "1 to %d points [x, y], each %g to %g%s%s", PATH_POINTS_MAX, key->min, key->max,
                 *unit ? " " : "", unit);
        break;
    case KEY_CHOICE: {
        struct names names = names_of_choices(key->choices);
        return names_allowed(&names, "", buffer, size);
    }
    case KEY_INK:
        snprintf(buffer, size, "the name of one of the inks in use");
        break;
    case KEY_BRUSH: {
        struct names names = names_of_brushes();
        return names_allowed(&names, "", buffer, size);
    }
    case KEY_COEFFICIENT:
        snprintf(buffer, size, "the name of a coefficient");
        break;
    case KEY_OPTION:
        snprintf(buffer, size, "the name of an option of %s", scene_kind_names[(int)key->min]);
        break;
    case KEY_TEXT:
        snprintf(buffer, size, "%s, %.10g to %.10g bytes", *unit ? unit : "text", key->min, key->max);
        break;
    case KEY_RASTER:
        snprintf(buffer, size, "an expression in x and y, or two of them for a field");
        break;
    case KEY_PICTURE:
        snprintf(buffer, size, "the path of a picture in this file's folder");
        break;
    case KEY_ZONE:
        snprintf(buffer, size, "[left, top, right, bottom], each 0 to 1%s%s", *unit ? " " : "", unit);
        break;
    case KEY_SIZE:
        snprintf(buffer, size, "WxH, each %.10g to %.10g%s%s", key->min, key->max, *unit ? " " : "", unit);
        break;
    case KEY_TIME:
        snprintf(buffer, size, "a time of day, 0:00 to 24:00");
        break;
    }
    return buffer;
}

/* Decimal only: 010 is ten to one reader of YAML and eight to another, and 0x10 is a key held too long. */
static bool is_decimal(const char *text)
{
    text += *text == '-' || *text == '+';
    size_t whole = strspn(text, "0123456789");
    if (whole > 1 && *text == '0') {
        return false;
    }
    text += whole;
    size_t fraction = 0;
    if (*text == '.') {
        text++;
        fraction = strspn(text, "0123456789");
        text += fraction;
    }
    if (whole + fraction == 0) {
        return false;
    }
    if (*text == 'e' || *text == 'E') {
        text++;
        text += *text == '-' || *text == '+';
        size_t exponent = strspn(text, "0123456789");
        text += exponent;
        if (exponent == 0) {
            return false;
        }
    }
    return *text == '\0';
}

static bool is_one_of(const char *text, const char *const *words)
{
    while (*words && strcmp(*words, text) != 0) {
        words++;
    }
    return *words;
}

bool value_number(struct reader *reader, const struct key *key, const struct yaml_node *node, double *number)
{
    static const char *const ENDLESS[] = {".inf",  ".Inf",  ".INF", "+.inf", "+.Inf", "+.INF", "-.inf",
                                          "-.Inf", "-.INF", ".nan", ".NaN",  ".NAN",  NULL};
    char found[128], allowed[128];
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    value_allowed(key, allowed, sizeof allowed);
    yaml_found(node, found, sizeof found);
    if (node->kind != YAML_SCALAR || yaml_is_nothing(node)) {
        reader_problem(reader, node, "%s where a number should be; %s", yaml_found(node, found, sizeof found), allowed);
        return false;
    }
    if (!node->plain) {
        reader_problem(reader, node, "%s is text, not a number: leave the quotes out; %s", found, allowed);
        return false;
    }
    if (is_one_of(node->text, ENDLESS)) {
        reader_problem(reader, node, "%s is not finite; %s", node->text, allowed);
        return false;
    }
    if (!is_decimal(node->text)) {
        reader_problem(reader, node, "%s is not a decimal number; %s", found, allowed);
        return false;
    }
    double value = strtod(node->text, NULL);
    if (!(value >= key->min && value <= key->max)) {
        reader_problem(reader, node, "%.40s is out of range; %s", node->text, allowed);
        return false;
    }
    if (key->type == KEY_INTEGER && value != floor(value)) {
        reader_problem(reader, node, "%.40s is not a whole number; %s", node->text, allowed);
        return false;
    }
    *number = value;
    return true;
}

bool value_choice(struct reader *reader, const struct names *names, const char *what, const struct yaml_node *node,
                  int *choice)
{
    char found[128], allowed[1024];
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    if (node->kind != YAML_SCALAR || yaml_is_nothing(node)) {
        reader_problem(reader, node, "%s where a name should be; %s", yaml_found(node, found, sizeof found),
                       names_allowed(names, "", allowed, sizeof allowed));
        return false;
    }
    int index = names_find(names, node->text);
    if (index < 0) {
        reader_problem(reader, node, "unknown %s %s; %s", what, yaml_found(node, found, sizeof found),
                       names_allowed(names, node->text, allowed, sizeof allowed));
        return false;
    }
    *choice = index;
    return true;
}

static bool read_flag(struct reader *reader, const struct yaml_node *node, bool *flag)
{
    static const char *const TRUE[] = {"true", "True", "TRUE", NULL};
    static const char *const FALSE[] = {"false", "False", "FALSE", NULL};
    char found[128];
    bool word = node->kind == YAML_SCALAR && node->plain;
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    if (word && (is_one_of(node->text, TRUE) || is_one_of(node->text, FALSE))) {
        *flag = is_one_of(node->text, TRUE);
        return true;
    }
    reader_problem(reader, node, "%s is neither; true or false", yaml_found(node, found, sizeof found));
    return false;
}

static bool read_point(struct reader *reader, const struct key *key, const struct yaml_node *node, struct point *point)
{
    char found[128], allowed[128];
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    struct key coordinate = *key;
    coordinate.type = KEY_NUMBER;
    if (node->kind != YAML_LIST || node->count != 2) {
        char count[48];
        snprintf(count, sizeof count, "a list of %d", node->count);
        bool list = node->kind == YAML_LIST;
        struct key whole = *key;
        whole.type = KEY_POINT;
        reader_problem(reader, node, "%s where a point should be; %s",
                       list ? count : yaml_found(node, found, sizeof found),
                       value_allowed(&whole, allowed, sizeof allowed));
        return false;
    }
    double xy[2] = {0};
    bool good = true;
    const struct yaml_node *item = node->first;
    for (int i = 0; i < 2; i++, item = item->next) {
        size_t length = reader_enter_index(reader, i);
        good = value_number(reader, &coordinate, item, &xy[i]) && good;
        reader_leave(reader, length);
    }
    *point = (struct point){(float)xy[0], (float)xy[1]};
    return good;
}

static bool read_path(struct reader *reader, const struct key *key, const struct yaml_node *node,
                      struct action_path *path)
{
    char found[128], allowed[128];
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    if (node->kind != YAML_LIST || node->count < 1 || node->count > PATH_POINTS_MAX) {
        char count[48];
        snprintf(count, sizeof count, "a list of %d", node->count);
        reader_problem(reader, node, "%s where a path should be; %s",
                       node->kind == YAML_LIST ? count : yaml_found(node, found, sizeof found),
                       value_allowed(key, allowed, sizeof allowed));
        return false;
    }
    struct point *points = reader_take(reader, (size_t)node->count * sizeof *points);
    bool good = points;
    int i = 0;
    for (const struct yaml_node *item = node->first; points && item; item = item->next, i++) {
        size_t length = reader_enter_index(reader, i);
        good = read_point(reader, key, item, &points[i]) && good;
        reader_leave(reader, length);
    }
    *path = (struct action_path){.points = points, .count = good ? node->count : 0};
    return good;
}

static bool read_text(struct reader *reader, const struct key *key, const struct yaml_node *node, const char **text)
{
    char found[128], allowed[128];
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    value_allowed(key, allowed, sizeof allowed);
    if (node->kind != YAML_SCALAR || yaml_is_nothing(node)) {
        reader_problem(reader, node, "%s where a text should be; %s", yaml_found(node, found, sizeof found), allowed);
        return false;
    }
    size_t length = strlen(node->text);
    if ((double)length < key->min || (double)length > key->max) {
        reader_problem(reader, node, "a text of %zu bytes; %s", length, allowed);
        return false;
    }
    char *copy = reader_take(reader, length + 1);
    if (copy) {
        memcpy(copy, node->text, length + 1);
        *text = copy;
    }
    return copy;
}

/* An ink of the session; of any session where none is known. */
static bool read_ink(struct reader *reader, const struct yaml_node *node, int *ink)
{
    char found[128], allowed[1024];
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    struct names all = names_of_inks(), own = {.count = reader->script->ink_count};
    if (own.count == 0) {
        int any = 0;
        *ink = 0;
        return value_choice(reader, &all, "ink", node, &any);
    }
    for (int i = 0; i < own.count; i++) {
        own.names[i] = inks[reader->script->inks[i]].name;
    }
    bool word = node->kind == YAML_SCALAR && !yaml_is_nothing(node);
    int index = word ? ink_find(node->text) : -1;
    for (int i = 0; i < own.count && index >= 0; i++) {
        if (reader->script->inks[i] == index) {
            *ink = i;
            return true;
        }
    }
    yaml_found(node, found, sizeof found);
    if (!word) {
        reader_problem(reader, node, "%s where a name should be; %s", yaml_found(node, found, sizeof found),
                       names_allowed(&own, "", allowed, sizeof allowed));
    } else if (index >= 0) {
        reader_problem(reader, node, "%s is not among the %s inks; %s", found,
                       reader->whose ? reader->whose : "session's", names_allowed(&own, "", allowed, sizeof allowed));
    } else {
        reader_problem(reader, node, "unknown ink %s; %s", found,
                       names_allowed(&all, node->text, allowed, sizeof allowed));
    }
    return false;
}

/* Four numbers; the second pair lies beyond the first. */
static bool read_zone(struct reader *reader, const struct key *key, const struct yaml_node *node, float zone[4])
{
    char found[128], allowed[128], count[48];
    double edges[4] = {0};
    bool good = true, list = node->kind == YAML_LIST;
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    if (!list || node->count != 4) {
        snprintf(count, sizeof count, "a list of %d", node->count);
        reader_problem(reader, node, "%s where a zone should be; %s",
                       list ? count : yaml_found(node, found, sizeof found),
                       value_allowed(key, allowed, sizeof allowed));
        return false;
    }
    struct key edge = *key;
    edge.type = KEY_NUMBER;
    const struct yaml_node *item = node->first;
    for (int i = 0; i < 4; i++, item = item->next) {
        size_t length = reader_enter_index(reader, i);
        good = value_number(reader, &edge, item, &edges[i]) && good;
        reader_leave(reader, length);
    }
    if (good && !(edges[0] < edges[2] && edges[1] < edges[3])) {
        reader_problem(reader, node, "a zone without area; [left, top, right, bottom], left < right and top < bottom");
        return false;
    }
    for (int i = 0; i < 4 && good; i++) {
        zone[i] = (float)edges[i];
    }
    return good;
}

/* The whole number that a text begins with, up to `most` digits, and what follows it. */
static bool take_digits(const char **text, size_t most, int *number)
{
    size_t digits = strspn(*text, "0123456789");
    *number = digits > 0 && digits <= most ? (int)strtol(*text, NULL, 10) : -1;
    *text += digits;
    return *number >= 0;
}

static bool read_size(struct reader *reader, const struct key *key, const struct yaml_node *node, int size[2])
{
    char found[128], allowed[128];
    int width = 0, height = 0;
    const char *text = node->kind == YAML_SCALAR ? node->text : "";
    bool good = take_digits(&text, 6, &width) && *text++ == 'x' && take_digits(&text, 6, &height) && *text == '\0';
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    if (!good || width < key->min || width > key->max || height < key->min || height > key->max) {
        reader_problem(reader, node, "%s is not it; %s", yaml_found(node, found, sizeof found),
                       value_allowed(key, allowed, sizeof allowed));
        return false;
    }
    size[0] = width;
    size[1] = height;
    return true;
}

static bool read_time(struct reader *reader, const struct key *key, const struct yaml_node *node, int *minutes)
{
    char found[128], allowed[128];
    int hour = 0, minute = 0;
    const char *text = node->kind == YAML_SCALAR ? node->text : "";
    bool good = take_digits(&text, 2, &hour) && *text++ == ':' && strlen(text) == 2 && take_digits(&text, 2, &minute) &&
                *text == '\0';
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    if (!good || minute > 59 || 60 * hour + minute > (int)key->max) {
        reader_problem(reader, node, "%s is no time; %s", yaml_found(node, found, sizeof found),
                       value_allowed(key, allowed, sizeof allowed));
        return false;
    }
    *minutes = 60 * hour + minute;
    return true;
}

bool value_read(struct reader *reader, const struct key *key, const struct yaml_node *node, void *object)
{
    char *at = (char *)object + key->offset;
    double number = 0;
    int choice = 0;
    bool good = false;
    struct names names;
    switch (key->type) {
    case KEY_NUMBER:
        good = value_number(reader, key, node, &number);
        if (good) {
            float value = (float)number;
            memcpy(at, &value, sizeof value);
        }
        return good;
    case KEY_INTEGER:
        good = value_number(reader, key, node, &number);
        choice = (int)number;
        break;
    case KEY_CHOICE:
        names = names_of_choices(key->choices);
        good = value_choice(reader, &names, "choice", node, &choice);
        break;
    case KEY_BRUSH:
        names = names_of_brushes();
        good = value_choice(reader, &names, "brush", node, &choice);
        break;
    case KEY_OPTION:
        names = names_of_keys(action_options(key));
        good = value_choice(reader, &names, "option", node, &choice);
        break;
    case KEY_COEFFICIENT:
        names = names_of_keys(coefficient_keys);
        good = value_choice(reader, &names, "coefficient", node, &choice);
        break;
    case KEY_INK:
        good = read_ink(reader, node, &choice);
        break;
    case KEY_TEXT:
        return read_text(reader, key, node, (const char **)(void *)at);
    case KEY_FLAG:
        return read_flag(reader, node, (bool *)at);
    case KEY_POINT:
        return read_point(reader, key, node, (struct point *)(void *)at);
    case KEY_PATH:
        return read_path(reader, key, node, (struct action_path *)(void *)at);
    case KEY_ZONE:
        return read_zone(reader, key, node, (float *)(void *)at);
    case KEY_SIZE:
        return read_size(reader, key, node, (int *)(void *)at);
    case KEY_TIME:
        return read_time(reader, key, node, (int *)(void *)at);
    case KEY_RASTER:
    case KEY_PICTURE:
        return false; /* what they become depends on the verb: script_action.c reads them */
    }
    if (good) {
        memcpy(at, &choice, sizeof choice);
    }
    return good;
}

static bool read_pair(struct reader *reader, const struct key *key, const struct yaml_node *node, void *object,
                      const struct value_reading *reading)
{
    size_t length = reader_enter(reader, key->name);
    bool good =
        reading ? reading->read(reader, key, node, object, reading->context) : value_read(reader, key, node, object);
    reader_leave(reader, length);
    return good;
}

uint64_t mapping_read(struct reader *reader, const struct key *keys, const struct yaml_node *node, void *object,
                      const struct value_reading *reading)
{
    char text[1200];
    uint64_t given = 0;
    int lines[NAMES_MAX] = {0};
    for (const struct yaml_node *k = node->first; k && k->next; k = k->next->next) {
        if (k->kind != YAML_SCALAR) {
            continue;
        }
        const struct key *key = key_find(keys, k->text);
        if (!key) {
            size_t length = reader_enter(reader, k->text);
            struct names names = names_of_keys(keys);
            reader_problem(reader, k, "unknown key; %s",
                           names.count ? names_allowed(&names, k->text, text, sizeof text) : "it takes none");
            reader_leave(reader, length);
            continue;
        }
        int index = (int)(key - keys);
        if (given & (uint64_t)1 << index) {
            size_t length = reader_enter(reader, key->name);
            reader_problem(reader, k, "given twice, first on line %d; once is enough", lines[index]);
            reader_leave(reader, length);
            continue;
        }
        given |= (uint64_t)1 << index;
        lines[index] = k->line;
        read_pair(reader, key, k->next, object, reading);
    }
    for (int i = 0; keys[i].name; i++) {
        if (keys[i].required && !(given & (uint64_t)1 << i)) {
            size_t length = reader_enter(reader, keys[i].name);
            reader_problem(reader, node, "missing; %s", value_allowed(&keys[i], text, sizeof text));
            reader_leave(reader, length);
        }
    }
    return given;
}
