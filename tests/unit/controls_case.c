#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <string.h>

#include "controls_case.h"

struct place open_place(const char *bindings)
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
    place.controls = controls_create(
        &(struct controls_def){.inputs = place.inputs, .inks = INKS, .coefficients = coefficients_default()});
    assert_non_null(place.controls);
    return place;
}

void close_place(struct place *place)
{
    controls_destroy(place->controls);
    inputs_destroy(place->inputs);
}
