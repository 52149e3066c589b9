/* Controls by the bindings of a text, with a clock of their own: what the tests of controls share. Included after
 * cmocka.h. */
#ifndef FROND_TESTS_CONTROLS_CASE_H
#define FROND_TESTS_CONTROLS_CASE_H

#include "controls.h"

enum { INKS = 3, MS = 1000 };

struct place {
    struct inputs *inputs;
    struct controls *controls;
    uint64_t now_us;
    struct action action; /* as taken last */
    uint64_t time_us;
};

/* `bindings`: what follows `inputs: 1`. Fails with the report where they are wrong. */
struct place open_place(const char *bindings);
/* With seats. */
struct place open_seats(const char *bindings, const struct exhibit_seat *seats, int seat_count);
void close_place(struct place *place);

void finger(struct place *place, enum event_kind kind, int slot, float x, float y);
void control(struct place *place, enum event_source source, uint32_t device, uint32_t usage, float value);
void wait_ms(struct place *place, int ms);
bool take(struct place *place);

#endif
