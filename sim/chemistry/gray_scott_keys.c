#include "gray_scott.h"
#include "gray_scott_rows.h"

const char *const gray_scott_stencil_names[LAPLACIANS + 1] = {"nine", "article", "five", NULL};
const char *const gray_scott_boundary_names[BOUNDARIES + 1] = {"periodic", "no_flux", NULL};

#define KEY_AT(field) offsetof(struct gray_scott_def, field)
const struct key gray_scott_keys[] = {GRAY_SCOTT_ROWS, END};

struct gray_scott_def gray_scott_default_def(void)
{
    struct gray_scott_def def = {0};
    key_defaults(gray_scott_keys, &def);
    return def;
}

struct gray_scott_def gray_scott_legal(const struct gray_scott_def *def)
{
    struct gray_scott_def legal = *def;
    keys_make_legal(gray_scott_keys, &legal);
    return legal;
}
