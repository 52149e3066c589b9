#include "key.h"

#include <math.h>
#include <string.h>

#include "action.h"

/* The greatest float that an int can hold, near enough. */
static const float INTEGER_MOST = 2147483392.0f;

const struct key *key_find(const struct key *keys, const char *name)
{
    for (; keys->name; keys++) {
        if (strcmp(keys->name, name) == 0) {
            return keys;
        }
    }
    return NULL;
}

int key_count(const struct key *keys)
{
    int count = 0;
    while (keys[count].name) {
        count++;
    }
    return count;
}

enum { LONGEST_NAME = 31 };

/* Levenshtein distance of two names of at most LONGEST_NAME characters. */
static int distance(const char *a, const char *b)
{
    int row[LONGEST_NAME + 1];
    int columns = (int)strlen(b);
    for (int j = 0; j <= columns; j++) {
        row[j] = j;
    }
    for (int i = 1; a[i - 1]; i++) {
        int diagonal = row[0];
        row[0] = i;
        for (int j = 1; j <= columns; j++) {
            int best = diagonal + (a[i - 1] != b[j - 1]);
            best = row[j] + 1 < best ? row[j] + 1 : best;
            best = row[j - 1] + 1 < best ? row[j - 1] + 1 : best;
            diagonal = row[j];
            row[j] = best;
        }
    }
    return row[columns];
}

const char *key_suggest(const struct key *keys, const char *misspelt)
{
    const char *nearest = NULL;
    int length = (int)strlen(misspelt);
    int least = 4;
    if (length > LONGEST_NAME) {
        return NULL;
    }
    for (; keys->name; keys++) {
        if (strlen(keys->name) > LONGEST_NAME) { /* a word of the curator's own */
            continue;
        }
        int d = distance(misspelt, keys->name);
        if (d < least && 2 * d < length) {
            least = d;
            nearest = keys->name;
        }
    }
    return nearest;
}

void key_defaults(const struct key *keys, void *object)
{
    for (; keys->name; keys++) {
        char *at = (char *)object + keys->offset;
        switch (keys->type) {
        case KEY_NUMBER: {
            float value = (float)keys->initial;
            memcpy(at, &value, sizeof value);
            break;
        }
        case KEY_INTEGER:
        case KEY_CHOICE:
        case KEY_INK:
        case KEY_BRUSH:
        case KEY_OPTION:
        case KEY_COEFFICIENT:
        case KEY_TIME: {
            int value = (int)keys->initial;
            memcpy(at, &value, sizeof value);
            break;
        }
        case KEY_FLAG: {
            bool value = keys->initial != 0;
            memcpy(at, &value, sizeof value);
            break;
        }
        case KEY_ZONE: {
            const float zone[4] = {0, (float)keys->initial, 1, 1};
            memcpy(at, zone, sizeof zone);
            break;
        }
        case KEY_SIZE:
            memset(at, 0, 2 * sizeof(int));
            break;
        case KEY_POINT:
            memset(at, 0, sizeof(struct point));
            break;
        case KEY_PATH:
            memset(at, 0, sizeof(struct action_path));
            break;
        case KEY_TEXT:
            memset(at, 0, sizeof(const char *));
            break;
        case KEY_RASTER:
        case KEY_PICTURE:
            memset(at, 0, sizeof(struct action_raster));
            break;
        }
    }
}

float key_value(const struct key *key, const void *object)
{
    const void *at = (const char *)object + key->offset;
    switch (key->type) {
    case KEY_NUMBER:
        return *(const float *)at;
    case KEY_FLAG:
        return *(const bool *)at ? 1 : 0;
    case KEY_INTEGER:
    case KEY_CHOICE:
        return (float)*(const int *)at;
    default:
        return 0;
    }
}

static float most_of(const struct key *key)
{
    int last = 0;
    if (key->type == KEY_NUMBER || key->type == KEY_INTEGER) {
        return (float)key->max;
    }
    for (; key->type == KEY_CHOICE && key->choices[last + 1]; last++) {
    }
    return key->type == KEY_FLAG ? 1 : (float)last;
}

float key_bound(const struct key *key, float value)
{
    float least = key->type == KEY_NUMBER || key->type == KEY_INTEGER ? (float)key->min : 0;
    return value >= least ? fminf(value, most_of(key)) : least;
}

void key_take(const struct key *key, void *object, float value)
{
    char *at = (char *)object + key->offset;
    value = key_bound(key, value);
    int whole = (int)floorf(fminf(value, INTEGER_MOST) + 0.5f);
    if (key->type == KEY_NUMBER) {
        memcpy(at, &value, sizeof value);
    } else if (key->type == KEY_FLAG) {
        bool flag = whole != 0;
        memcpy(at, &flag, sizeof flag);
    } else if (key->type == KEY_INTEGER || key->type == KEY_CHOICE) {
        memcpy(at, &whole, sizeof whole);
    }
}

static int whole_at(const struct key *key, const void *object)
{
    int whole;
    memcpy(&whole, (const char *)object + key->offset, sizeof whole);
    return whole;
}

static bool is_legal(const struct key *key, const void *object)
{
    float number;
    switch (key->type) {
    case KEY_NUMBER:
        number = key_value(key, object);
        return number >= (float)key->min && number <= (float)key->max;
    case KEY_INTEGER:
        return whole_at(key, object) >= (int)key->min && whole_at(key, object) <= (int)key->max;
    case KEY_CHOICE:
        return whole_at(key, object) >= 0 && whole_at(key, object) <= (int)most_of(key);
    default:
        return true;
    }
}

bool keys_are_legal(const struct key *keys, const void *object)
{
    while (keys->name && is_legal(keys, object)) {
        keys++;
    }
    return !keys->name;
}

void keys_make_legal(const struct key *keys, void *object)
{
    for (; keys->name; keys++) {
        if (is_legal(keys, object)) {
            continue;
        }
        if (keys->type == KEY_NUMBER) {
            key_take(keys, object, key_value(keys, object));
        } else {
            int least = (int)keys->min, whole = whole_at(keys, object) < least ? least : (int)keys->max;
            whole = keys->type == KEY_CHOICE ? (int)keys->initial : whole;
            memcpy((char *)object + keys->offset, &whole, sizeof whole);
        }
    }
}
