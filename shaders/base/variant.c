#include "variant.h"

#include <stdio.h>
#include <string.h>

#define SPACES " \t\r"

struct word {
    const char *at;
    int length;
};

struct define {
    struct word name, value; /* a value of length 0: none */
};

struct set {
    struct define defines[VARIANT_DEFINES];
    int count;
};

static bool same(struct word a, struct word b)
{
    return a.length == b.length && strncmp(a.at, b.at, (size_t)a.length) == 0;
}

/* The next word of this line, its end moved past it; length 0 at the end of the line. */
static struct word next_word(const char **at, const char *ends)
{
    *at += strspn(*at, SPACES);
    struct word word = {*at, (int)strcspn(*at, ends)};
    *at += word.length;
    return word;
}

static const char *next_line(const char *at)
{
    const char *end = strchr(at, '\n');
    return end ? end + 1 : at + strlen(at);
}

/* What follows `#NAME` on this line, or NULL. */
static const char *after_directive(const char *line, const char *name)
{
    size_t length = strlen(name);
    line += strspn(line, SPACES);
    if (*line != '#') {
        return NULL;
    }
    line++;
    line += strspn(line, SPACES);
    if (strncmp(line, name, length) != 0 || !strchr(SPACES "\n", line[length])) { /* the final NUL is found too */
        return NULL;
    }
    return line + length;
}

bool variant_is_line(const char *line)
{
    return after_directive(line, "variant") != NULL;
}

/* How many alternatives there are in "1|2|4": one at least. */
static int count_choices(struct word values)
{
    int count = 1;
    for (int i = 0; i < values.length; i++) {
        count += values.at[i] == '|';
    }
    return count;
}

static struct word pick(struct word values, int choice)
{
    const char *at = values.at, *end = values.at + values.length;
    for (const char *bar; (bar = memchr(at, '|', (size_t)(end - at))); at = bar + 1) {
        if (choice-- == 0) {
            return (struct word){at, (int)(bar - at)};
        }
    }
    return (struct word){at, (int)(end - at)};
}

/* Set `index` of one #variant line, counted as an odometer counts; `count` sets in all. */
static struct set read_line(const char *at, int index, int *count)
{
    struct set set = {.count = 0};
    *count = 1;
    for (;;) {
        struct define define = {next_word(&at, "=" SPACES "\n"), {"", 0}};
        if (define.name.length == 0 || set.count == VARIANT_DEFINES) {
            return set;
        }
        if (*at == '=') {
            at++;
            struct word values = next_word(&at, SPACES "\n");
            int choices = count_choices(values);
            define.value = pick(values, index / *count % choices);
            *count *= choices;
        }
        set.defines[set.count++] = define;
    }
}

static bool find_set(const char *source, int index, struct set *set)
{
    bool any = false;
    for (const char *line = source; *line; line = next_line(line)) {
        const char *at = after_directive(line, "variant");
        int count = 0;
        if (!at) {
            continue;
        }
        any = true;
        *set = read_line(at, index, &count);
        if (index < count) {
            return true;
        }
        index -= count;
    }
    set->count = 0;
    return !any && index == 0;
}

bool variant_defines(const char *source, int index, char defines[VARIANT_TEXT])
{
    struct set set;
    int length = 0;
    defines[0] = '\0';
    if (!find_set(source, index, &set)) {
        return false;
    }
    for (int i = 0; i < set.count && length < VARIANT_TEXT; i++) {
        const struct define *define = &set.defines[i];
        length +=
            snprintf(defines + length, (size_t)(VARIANT_TEXT - length), "#define %.*s%s%.*s\n", define->name.length,
                     define->name.at, define->value.length ? " " : "", define->value.length, define->value.at);
    }
    return true;
}

/* False where anything but #define stands, or too many of them. */
static bool read_defines(const char *text, struct set *set)
{
    set->count = 0;
    for (const char *line = text ? text : ""; *line; line = next_line(line)) {
        const char *at = after_directive(line, "define");
        if (!at && line[strspn(line, SPACES)] == '\n') {
            continue;
        }
        if (!at || set->count == VARIANT_DEFINES) {
            return false;
        }
        struct define define = {next_word(&at, SPACES "\n"), {"", 0}};
        define.value = next_word(&at, "\n");
        while (define.value.length > 0 && strchr(SPACES, define.value.at[define.value.length - 1])) {
            define.value.length--;
        }
        set->defines[set->count++] = define;
    }
    return true;
}

static bool equal_sets(const struct set *a, const struct set *b)
{
    if (a->count != b->count) {
        return false;
    }
    for (int i = 0; i < a->count; i++) {
        bool found = false;
        for (int j = 0; j < b->count; j++) {
            found = found ||
                    (same(a->defines[i].name, b->defines[j].name) && same(a->defines[i].value, b->defines[j].value));
        }
        if (!found) {
            return false;
        }
    }
    return true;
}

bool variant_admits(const char *source, const char *defines)
{
    struct set wanted, offered;
    if (!read_defines(defines, &wanted)) {
        return false;
    }
    for (int i = 0; find_set(source, i, &offered); i++) {
        if (equal_sets(&wanted, &offered)) {
            return true;
        }
    }
    return false;
}

void variant_label(const char *defines, char label[VARIANT_TEXT])
{
    struct set set;
    int length = 0;
    label[0] = '\0';
    (void)read_defines(defines, &set);
    for (int i = 0; i < set.count && length < VARIANT_TEXT; i++) {
        const struct define *define = &set.defines[i];
        length +=
            snprintf(label + length, (size_t)(VARIANT_TEXT - length), "%s%.*s%s%.*s", i ? " " : "", define->name.length,
                     define->name.at, define->value.length ? "=" : "", define->value.length, define->value.at);
    }
}
