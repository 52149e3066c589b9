#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <string.h>

#include "controls_case.h"

struct place open_seats(const char *bindings, const struct exhibit_seat *seats, int seat_count)
{
    struct script_def def = script_default_def();
    struct report report;
    char text[4000];
    snprintf(text, sizeof text, "inputs: 1\n%s", bindings);
    report_init(&report, "inputs");
    struct place place = {.now_us = 1000000};
    place.inputs = inputs_parse(text, strlen(text), ".", NULL, &def, &report);
    if (!place.inputs) {
        fail_msg("%s", report_text(&report));
    }
    report_finish(&report);
    place.controls = controls_create(&(struct controls_def){.inputs = place.inputs,
                                                            .inks = INKS,
                                                            .coefficients = coefficients_default(),
                                                            .seats = seats,
                                                            .seat_count = seat_count});
    assert_non_null(place.controls);
    return place;
}

struct place open_place(const char *bindings)
{
    return open_seats(bindings, NULL, 0);
}

void close_place(struct place *place)
{
    controls_destroy(place->controls);
    inputs_destroy(place->inputs);
}

void finger(struct place *place, enum event_kind kind, int slot, float x, float y)
{
    struct event event = {.kind = kind, .source = SOURCE_TOUCH, .device = 1, .slot = slot, .x = x, .y = y};
    event.time_us = place->now_us;
    controls_feel(place->controls, &event);
}

void control(struct place *place, enum event_source source, uint32_t device, uint32_t usage, float value)
{
    struct event event = {.kind = EVENT_CONTROL, .source = source, .device = device, .control = usage, .value = value};
    event.time_us = place->now_us;
    controls_feel(place->controls, &event);
}

void wait_ms(struct place *place, int ms)
{
    place->now_us += (uint64_t)ms * MS;
    controls_run(place->controls, place->now_us);
}

bool take(struct place *place)
{
    return controls_action(place->controls, &place->action, &place->time_us);
}
