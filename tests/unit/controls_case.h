/* Controls by the bindings of a text, with a clock of their own: what the tests of controls share. Included after
 * cmocka.h. */
#ifndef FROND_TESTS_CONTROLS_CASE_H
#define FROND_TESTS_CONTROLS_CASE_H

#include "controls.h"

enum { INKS = 3 };

struct place {
    struct inputs *inputs;
    struct controls *controls;
    uint64_t now_us;
    struct action action; /* as taken last */
    uint64_t time_us;
};

/* `bindings`: what follows `inputs: 1`. Fails with the report where they are wrong. */
struct place open_place(const char *bindings);
void close_place(struct place *place);

#endif
