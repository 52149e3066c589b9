#include "gray_scott.h"
#include "gray_scott_rows.h"

const char *const gray_scott_stencil_names[LAPLACIANS + 1] = {"nine", "article", "five", NULL};
const char *const gray_scott_boundary_names[BOUNDARIES + 1] = {"periodic", "no_flux", NULL};

#define GRAY_SCOTT_AT(field) offsetof(struct gray_scott_def, field)
const struct key gray_scott_keys[] = {GRAY_SCOTT_ROWS{.name = NULL}};

struct gray_scott_def gray_scott_default_def(void)
{
    struct gray_scott_def def = {0};
    key_defaults(gray_scott_keys, &def);
    return def;
}

struct gray_scott_def gray_scott_legal(const struct gray_scott_def *def)
{
    struct gray_scott_def legal = *def;
    for (const struct key *key = gray_scott_keys; key->name; key++) {
        char *place = (char *)&legal + key->offset;
        if (key->type == KEY_NUMBER) {
            float *value = (float *)(void *)place, least = (float)key->min, most = (float)key->max;
            *value = *value > least ? *value : least; /* what is no number becomes the least */
            *value = *value < most ? *value : most;
        } else if (key->type == KEY_INTEGER) {
            int *value = (int *)(void *)place;
            *value = *value < (int)key->min ? (int)key->min : *value;
        } else {
            int *value = (int *)(void *)place, choices = 0;
            while (key->choices[choices]) {
                choices++;
            }
            *value = *value < 0 || *value >= choices ? (int)key->initial : *value;
        }
    }
    return legal;
}
