#include "example.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "action.h"
#include "coefficients.h"
#include "exhibit.h"
#include "explain.h"
#include "inputs.h"
#include "script_structure.h"

enum { DEPTH = 24, COLUMNS = 118 };

static void add(struct example *example, const char *place, const struct key *keys)
{
    for (; keys->name; keys++) {
        assert_true(example->row_count < EXAMPLE_ROWS);
        struct example_row *row = &example->rows[example->row_count++];
        snprintf(row->place, sizeof row->place, "%s", place);
        row->key = *keys;
        row->line = -1;
    }
}

static const struct key *table(const struct inputs_table *tables, const char *name)
{
    for (; tables->name; tables++) {
        if (strcmp(tables->name, name) == 0) {
            return tables->keys;
        }
    }
    fail_msg("no table is called %s", name);
    return NULL;
}

static void add_verbs(struct example *example)
{
    struct inputs_tables inputs;
    for (int i = 0; i < ACTION_VERBS; i++) {
        enum action_verb verb = (enum action_verb)i;
        struct key keys[2] = {{.name = action_name(verb), .unit = "section", .meaning = action_meaning(verb)},
                              {.name = NULL}};
        char place[EXAMPLE_PLACE];
        if (key_find(table(inputs_tables_of(&inputs), "do"), keys->name)) {
            continue; /* the visitor's own, and no verb in a binding */
        }
        add(example, "inputs.bindings[]", keys);
        snprintf(place, sizeof place, "inputs.bindings[].%s", action_name(verb));
        add(example, place, action_keys(verb));
    }
}

/* Tables whose place is not their name. The version of an inputs file has none in an exhibit. */
static void add_tables(struct example *example)
{
    static const char *const PLACES[][2] = {
        {"exhibit", ""},
        {"palettes", "palettes[]"},
        {"scenes", "scenes[]"},
        {"structures", "scenes[].structures[]"},
        {"scene_inputs", "scenes[].inputs[]"},
        {"seats", "seats[]"},
        {"schedule", "schedule[]"},
        {"touch", "inputs.touch"},
        {"keyboards", "inputs.keyboards[]"},
        {"controllers", "inputs.controllers[]"},
        {"map", "inputs.controllers[].map[]"},
        {"lights", "inputs.controllers[].lights[]"},
        {"gpio", "inputs.gpio"},
        {"buttons", "inputs.gpio.buttons[]"},
        {"encoders", "inputs.gpio.encoders[]"},
        {"lamps", "inputs.gpio.lamps[]"},
        {"bindings", "inputs.bindings[]"},
        {"do", "inputs.bindings[]"},
        {"turn", "inputs.bindings[].turn"},
        {"dial", "inputs.bindings[].dial"},
        {"cursor", "inputs.bindings[].cursor"},
        {"length", "inputs.bindings[].length"},
    };
    struct key options[EXHIBIT_OPTIONS_KEYS], structure[SCRIPT_STRUCTURE_KEYS];
    struct inputs_tables inputs;
    const struct inputs_table *const files[] = {exhibit_tables, inputs_tables_of(&inputs)};
    for (int f = 0; f < 2; f++) {
        for (const struct inputs_table *one = files[f]; one->name; one++) {
            const char *place = one->name;
            for (size_t i = 0; i < sizeof PLACES / sizeof *PLACES; i++) {
                place = strcmp(PLACES[i][0], one->name) == 0 ? PLACES[i][1] : place;
            }
            add(example, place, one->keys + (one == inputs.tables ? 1 : 0));
        }
    }
    add(example, "scenes[].painting", coefficient_keys);
    for (int kind = SCENE_PAINTING + 1; kind < SCENE_KINDS; kind++) {
        char place[EXAMPLE_PLACE];
        snprintf(place, sizeof place, "scenes[].%s", scene_kind_names[kind]);
        exhibit_options_keys((enum scene_kind)kind, options);
        add(example, place, options);
    }
    script_structure_keys(structure);
    structure[1 + key_count(structure_keys)].name = NULL; /* options of growth stand under trees */
    add(example, "scenes[].structures[]", structure);
    add_verbs(example);
}

static int find(const struct example *example, const char *place, const char *name, size_t length)
{
    for (int i = 0; i < example->row_count; i++) {
        const struct example_row *row = &example->rows[i];
        if (strcmp(row->place, place) == 0 && strlen(row->key.name) == length &&
            strncmp(row->key.name, name, length) == 0) {
            return i;
        }
    }
    return -1;
}

/* The lists and mappings that a line is in, by their columns. */
struct nesting {
    struct {
        int column;
        char name[40];
    } levels[DEPTH];
    int count;
};

static void leave(struct nesting *nesting, int column)
{
    while (nesting->count && nesting->levels[nesting->count - 1].column >= column) {
        nesting->count--;
    }
}

static void enter(struct nesting *nesting, int column, const char *name, size_t length)
{
    assert_true(nesting->count < DEPTH && length < sizeof nesting->levels[0].name);
    nesting->levels[nesting->count].column = column;
    memcpy(nesting->levels[nesting->count].name, name, length);
    nesting->levels[nesting->count++].name[length] = '\0';
}

static void place_of(const struct nesting *nesting, char place[EXAMPLE_PLACE])
{
    size_t length = 0;
    place[0] = '\0';
    for (int i = 0; i < nesting->count; i++) {
        const char *name = nesting->levels[i].name;
        length += (size_t)snprintf(place + length, EXAMPLE_PLACE - length, "%s%s",
                                   length && strcmp(name, "[]") != 0 ? "." : "", name);
        assert_true(length < EXAMPLE_PLACE);
    }
}

/* `key: value`, `- key: value`, or either with a # right before it. */
static void read_line(struct example *example, struct nesting *nesting, int index)
{
    struct example_line *kind = &example->kinds[index];
    const char *text = example->lines[index];
    int column = (int)strspn(text, " ");
    *kind = (struct example_line){.row = -1, .column = column};
    text += column;
    kind->commented = *text == '#';
    text += kind->commented;
    bool item = strncmp(text, "- ", 2) == 0;
    if (item) {
        leave(nesting, column);
        text += 2;
    }
    size_t length = strspn(text, "abcdefghijklmnopqrstuvwxyz_0123456789");
    if (length == 0 || text[length] != ':' || (text[length + 1] != ' ' && text[length + 1] != '\0')) {
        return;
    }
    if (item) {
        enter(nesting, column, "[]", 2);
        column += 2;
    }
    leave(nesting, column);
    char place[EXAMPLE_PLACE];
    place_of(nesting, place);
    kind->row = find(example, place, text, length);
    kind->value = text + length + 1 + (text[length + 1] == ' ');
    if (kind->row >= 0 && example->rows[kind->row].line < 0) {
        example->rows[kind->row].line = index;
    }
    enter(nesting, column, text, length);
}

static char *load(const char *path)
{
    FILE *file = fopen(path, "rb");
    char *text = calloc(1, 1 << 20);
    assert_non_null(file);
    assert_non_null(text);
    assert_true(fread(text, 1, (1 << 20) - 1, file) > 0);
    fclose(file);
    return text;
}

struct example *example_read(const char *path)
{
    struct example *example = calloc(1, sizeof *example);
    struct nesting nesting = {.count = 0};
    assert_non_null(example);
    add_tables(example);
    example->text = load(path);
    for (char *line = strtok(example->text, ""); line && *line;) {
        char *end = strchr(line, '\n');
        assert_true(end && example->line_count < EXAMPLE_LINES);
        *end = '\0';
        example->lines[example->line_count] = line;
        read_line(example, &nesting, example->line_count++);
        line = end + 1;
    }
    return example;
}

void example_destroy(struct example *example)
{
    free(example->text);
    free(example);
}

static bool is_comment(const struct example *example, int line)
{
    const char *text = example->lines[line] + strspn(example->lines[line], " ");
    return strncmp(text, "# ", 2) == 0;
}

int example_comment_start(const struct example *example, int line)
{
    while (line > 0 && is_comment(example, line - 1)) {
        line--;
    }
    return line;
}

const char *example_comment(const struct example *example, int line, char *buffer, size_t size)
{
    size_t length = 0;
    buffer[0] = '\0';
    for (int i = example_comment_start(example, line); i < line && length < size; i++) {
        const char *text = strchr(example->lines[i], '#') + 2;
        length += (size_t)snprintf(buffer + length, size - length, "%s%s", length ? " " : "", text);
    }
    return buffer;
}

const char *example_wanted(const struct key *key, char *buffer, size_t size)
{
    char range[1400];
    if (key_is_section(key)) {
        snprintf(buffer, size, "%s", key->meaning);
    } else {
        snprintf(buffer, size, "%s (%s)", key->meaning, explain_range(key, range, sizeof range));
    }
    return buffer;
}

static void write_comment(FILE *file, const struct key *key, int column)
{
    char comment[EXAMPLE_COMMENT];
    int at = COLUMNS;
    example_wanted(key, comment, sizeof comment);
    for (char *word = strtok(comment, " "); word; word = strtok(NULL, " ")) {
        int length = (int)strlen(word);
        if (at + 1 + length > COLUMNS) {
            fprintf(file, "%s%*s#", at == COLUMNS && word == comment ? "" : "\n", column, "");
            at = column + 1;
        }
        fprintf(file, " %s", word);
        at += 1 + length;
    }
    fputc('\n', file);
}

/* Whether a key is one of those of a kind of scene, which --write puts in by itself. */
static bool is_option(const struct example_row *row)
{
    for (int kind = SCENE_PAINTING + 1; kind < SCENE_KINDS; kind++) {
        char place[EXAMPLE_PLACE];
        snprintf(place, sizeof place, "scenes[].%s", scene_kind_names[kind]);
        if (strcmp(row->place, place) == 0 && row->key.type != KEY_TEXT) {
            return true;
        }
    }
    return false;
}

/* A key as it is by default. */
static void write_default(FILE *file, const struct key *key, int column)
{
    if (key->type == KEY_FLAG) {
        fprintf(file, "%*s#%s: %s\n", column, "", key->name, key->initial != 0 ? "true" : "false");
    } else if (key->type == KEY_CHOICE) {
        fprintf(file, "%*s#%s: %s\n", column, "", key->name, key->choices[(int)key->initial]);
    } else {
        fprintf(file, "%*s#%s: %.10g\n", column, "", key->name, key->initial);
    }
}

/* Options that stand nowhere yet, where the last of their place stands, or its section. */
static void write_missing(FILE *file, const struct example *example, int line)
{
    const char *gap = example->kinds[line].value && *example->kinds[line].value ? "\n" : "";
    for (int i = 0; i < example->row_count; i++) {
        const struct example_row *row = &example->rows[i];
        int last = -1, column = 6;
        for (int k = 0; k < example->row_count && row->line < 0 && is_option(row); k++) {
            const struct example_row *other = &example->rows[k];
            bool section = strncmp(row->place, other->place, strlen(other->place)) == 0 &&
                           strcmp(row->place + strlen(other->place), ".") > 0 &&
                           strcmp(row->place + strlen(other->place) + 1, other->key.name) == 0;
            if ((section || strcmp(row->place, other->place) == 0) && other->line > last) {
                last = other->line;
                column = example->kinds[last].column + (section ? 2 : 0);
            }
        }
        if (last == line) {
            fputs(gap, file);
            gap = "\n";
            write_comment(file, &row->key, column);
            write_default(file, &row->key, column);
        }
    }
}

void example_write(const struct example *example, const char *path)
{
    FILE *file = fopen(path, "wb");
    bool skip[EXAMPLE_LINES] = {false};
    assert_non_null(file);
    for (int i = 0; i < example->row_count; i++) {
        int line = example->rows[i].line;
        for (int k = line < 0 ? 0 : example_comment_start(example, line); k < line; k++) {
            skip[k] = true;
        }
    }
    const char *before = ""; /* the line that was written last */
    for (int i = 0; i < example->line_count; i++) {
        int row = example->kinds[i].row, column = example->kinds[i].column;
        if (row >= 0 && example->rows[row].line == i) {
            if (*before && (int)strspn(before, " ") >= column) { /* no parent of it */
                fputc('\n', file);
            }
            write_comment(file, &example->rows[row].key, column);
        }
        bool option = row >= 0 && example->kinds[i].commented && is_option(&example->rows[row]);
        if (option) {
            write_default(file, &example->rows[row].key, column);
        } else if (!skip[i]) {
            fprintf(file, "%s\n", example->lines[i]);
        }
        before = skip[i] ? before : example->lines[i];
        write_missing(file, example, i);
    }
    fclose(file);
}
