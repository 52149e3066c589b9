#include "bolt.h"

const char *const bolt_kind_names[BOLT_KINDS + 1] = {"lightning",   "tesla", "tree",     "lichen",  "coral",
                                                     "river",       "snow",  "fracture", "vessels", "city",
                                                     "lichtenberg", "frost", NULL};

void bolt_preset(struct bolt *bolt, enum bolt_kind kind, int width, int height)
{
    *bolt = (struct bolt){.growth = laplacian_default_def()};
    bolt->look = (struct bolt_look){.trunk = 3, .tip = 0.6f, .pipe = 2, .colour = {0.3f, 0.4f, 1}, .core = {1, 1, 1}};
    bolt->growth.span = (float)(width > height ? width : height);
    (void)kind;
}
