#include <math.h>
#include <string.h>

#include "growth.h"

/* The greatest float that an int can hold, near enough: seeds go that far. No whole number of the table is below 0. */
static const float INTEGER_MOST = 2147483392.0f;

float growth_value(const struct growth_def *def, int key)
{
    const struct key *of = &growth_keys[key];
    const void *at = (const char *)def + of->offset;
    switch (of->type) {
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

void growth_take(struct growth_def *def, int key, float value)
{
    const struct key *of = &growth_keys[key];
    char *at = (char *)def + of->offset;
    float least = of->type == KEY_NUMBER || of->type == KEY_INTEGER ? (float)of->min : 0;
    value = value >= least ? fminf(value, most_of(of)) : least; /* NaN becomes the least */
    int whole = (int)(fminf(value, INTEGER_MOST) + 0.5f), seed = def->seed;
    if (strcmp(of->name, "metaphor") == 0) {
        *def = growth_preset((enum metaphor)whole, def->tree);
        def->seed = seed;
    } else if (strcmp(of->name, "tree") == 0) {
        *def = growth_preset((enum metaphor)def->metaphor, whole != 0);
        def->seed = seed;
    } else if (of->type == KEY_NUMBER) {
        memcpy(at, &value, sizeof value);
    } else if (of->type == KEY_FLAG) {
        bool flag = whole != 0;
        memcpy(at, &flag, sizeof flag);
    } else if (of->type == KEY_INTEGER || of->type == KEY_CHOICE) {
        memcpy(at, &whole, sizeof whole);
    }
}
