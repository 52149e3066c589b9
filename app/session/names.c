#include <stdio.h>
#include <string.h>

#include "action.h"
#include "brush.h"
#include "ink.h"
#include "script_value.h"

static void add(struct names *names, const char *name)
{
    if (names->count < NAMES_MAX) {
        names->names[names->count++] = name;
    }
}

struct names names_of_keys(const struct key *keys)
{
    struct names names = {.count = 0};
    for (; keys->name; keys++) {
        add(&names, keys->name);
    }
    return names;
}

struct names names_of_choices(const char *const *choices)
{
    struct names names = {.count = 0};
    for (; *choices; choices++) {
        add(&names, *choices);
    }
    return names;
}

struct names names_of_verbs(void)
{
    struct names names = {.count = 0};
    for (int i = 0; i < ACTION_VERBS; i++) {
        add(&names, action_name((enum action_verb)i));
    }
    return names;
}

struct names names_of_brushes(void)
{
    struct names names = {.count = 0};
    for (int i = 0; brushes[i].name; i++) {
        add(&names, brushes[i].name);
    }
    return names;
}

struct names names_of_inks(void)
{
    return names_of_choices(ink_names);
}

struct names names_of_palettes(void)
{
    struct names names = {.count = 0};
    for (int i = 0; palettes[i].name; i++) {
        add(&names, palettes[i].name);
    }
    return names;
}

int names_find(const struct names *names, const char *name)
{
    for (int i = 0; i < names->count; i++) {
        if (strcmp(names->names[i], name) == 0) {
            return i;
        }
    }
    return -1;
}

const char *names_allowed(const struct names *names, const char *misspelt, char *buffer, size_t size)
{
    struct key keys[NAMES_MAX + 1] = {{0}};
    for (int i = 0; i < names->count; i++) {
        keys[i].name = names->names[i];
    }
    const char *near = key_suggest(keys, misspelt);
    size_t length = 0;
    if (near) {
        length = (size_t)snprintf(buffer, size, "did you mean %s? One of ", near);
    } else {
        length = (size_t)snprintf(buffer, size, "one of ");
    }
    for (int i = 0; i < names->count && length < size; i++) {
        length += (size_t)snprintf(buffer + length, size - length, "%s%s", i ? ", " : "", names->names[i]);
    }
    return buffer;
}
