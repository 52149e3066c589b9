/* Real photographs, of Debian packages (tests/packages.txt). They are never copied. */
#ifndef FROND_PHOTOGRAPH_H
#define FROND_PHOTOGRAPH_H

#include "sitter.h"

enum photograph {
    PHOTOGRAPH_ASTRONAUT, /* Eileen Collins, NASA, public domain: python3-imageio */
    PHOTOGRAPH_FACE,      /* her face alone */
    PHOTOGRAPH_CLOSE,     /* closer still, as large as a crown */
    PHOTOGRAPH_ADMIRAL,   /* Grace Hopper, US Navy, public domain: python-matplotlib-data */
    PHOTOGRAPH_FROWN,     /* her face alone */
    PHOTOGRAPH_CAT,       /* Chelsea, Stéfan van der Walt, CC0: python3-imageio */
    PHOTOGRAPHS
};

/* Whether all packages are there; if not, says so. */
bool photographs_are_there(void);
/* A square of the photograph; free() it. Stops the program when it cannot be read. */
struct sitter *photograph_sit(enum photograph photograph);

#endif
