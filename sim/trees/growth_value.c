#include <string.h>

#include "growth.h"

void growth_take(struct growth_def *def, int key, float value)
{
    const struct key *of = &growth_keys[key];
    int seed = def->seed;
    key_take(of, def, value);
    if (strcmp(of->name, "metaphor") == 0 || strcmp(of->name, "tree") == 0) {
        *def = growth_preset((enum metaphor)def->metaphor, def->tree);
        def->seed = seed;
    }
}
