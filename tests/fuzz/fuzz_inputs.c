/* Any bytes as an inputs file: a report or inputs, no value of accepted ones out of its range, and controls that stand
 * whatever those inputs are bound to. */
#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "controls.h"
#include "device_class.h"
#include "stroke.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
const char *__lsan_default_suppressions(void);

/* libfyaml 0.7.12 loses up to 4 KiB where the syntax of a long scalar is wrong; leaks of our own still count. */
const char *__lsan_default_suppressions(void)
{
    return "leak:libfyaml.so";
}

static void check_lines(const struct inputs_lines *lines, int count)
{
    assert(count >= 0 && count <= INPUTS_LINES);
    for (int i = 0; i < count; i++) {
        assert(lines[i].id && (lines[i].a.name || (lines[i].chip && lines[i].a.offset >= 0)));
        assert(lines[i].debounce >= 0 && lines[i].debounce <= 100 && lines[i].button < INPUTS_LINES);
    }
}

/* A dial turns a coefficient, or an option of a scene, choices and flags among that; not both. */
static void check_turn(const struct binding *binding)
{
    assert((binding->coefficient >= 0) != (binding->option >= 0));
    assert((binding->option >= 0) == (binding->scene != SCENE_PAINTING) && binding->scene < SCENE_KINDS);
    const struct key *options = scene_options_keys((enum scene_kind)binding->scene);
    assert(binding->option < key_count(options));
    const struct key *key = binding->option >= 0 ? &options[binding->option] : &coefficient_keys[binding->coefficient];
    double most = key->type == KEY_FLAG ? 1 : key->max;
    for (int i = 0; key->type == KEY_CHOICE && key->choices[i]; i++) {
        most = i;
    }
    assert(binding->option >= 0 || key->type != KEY_CHOICE);
    assert(binding->axis.from >= (float)key->min && binding->axis.to <= (float)most);
}

static void check_binding(const struct inputs *inputs, const struct binding *binding)
{
    assert(binding->when >= 0 && binding->when < BINDING_WHENS && binding->ms >= 1 && binding->ms <= INPUTS_MS_MAX);
    assert(binding->device >= -1 && binding->device < INPUTS_CONTROLLERS);
    int devices = 0;
    char name[200];
    if (binding->source && binding->source->devices) {
        binding->source->devices(inputs, &devices);
    }
    assert(binding->device < devices);
    assert(!binding->source || binding->source->name(inputs, binding->control, name, sizeof name));
    if (binding->what == DO_VERB) {
        assert(binding->action.verb < ACTION_VERBS && binding->action.path.count <= STROKE_POINTS);
    } else if (binding->what == DO_TURN) {
        check_turn(binding);
    }
    assert(binding->tool >= 0 && binding->tool < TOOLS);
    assert(!binding_follows(binding) || (binding->axis.dead <= 0.9f && binding->axis.steps >= 1));
}

/* Every binding hears something, and whatever comes of it is legal. */
static void shake(const struct inputs *inputs)
{
    struct controls_def def = {.inputs = inputs, .inks = 2, .coefficients = coefficients_default()};
    struct controls *controls = controls_create(&def);
    uint64_t time_us = 1000000;
    assert(controls);
    for (int i = 0; i < 4 * inputs->binding_count; i++) {
        const struct binding *binding = &inputs->bindings[i % inputs->binding_count];
        bool touch = !binding->source;
        struct event event = {.kind = touch ? (i & 4 ? EVENT_UP : EVENT_DOWN) : EVENT_CONTROL,
                              .source = touch ? SOURCE_TOUCH : binding->source->source,
                              .device = 1,
                              .slot = i & 1,
                              .x = 0.4f + 0.01f * (float)(i & 7),
                              .y = 0.5f,
                              .control = binding->control,
                              .relative = i & 2,
                              .centred = i & 8,
                              .value = i & 1 ? 1 : -1};
        event.time_us = time_us;
        struct action action;
        uint64_t from_us;
        controls_feel(controls, &event);
        event.kind = touch ? EVENT_MOVE : EVENT_CONTROL;
        event.x += 0.1f;
        event.value = -event.value / 2;
        controls_feel(controls, &event);
        time_us += 9000;
        controls_run(controls, time_us);
        while (controls_action(controls, &action, &from_us)) {
            assert(action.verb < ACTION_VERBS && action.ink >= 0 && action.ink < INPUTS_BINDINGS);
            assert(isfinite(action.value) && isfinite(action.radius) && action.path.count <= STROKE_POINTS);
        }
    }
    struct wish wish;
    while (controls_wish(controls, &wish)) {
        assert(wish.kind >= 0 && wish.kind < WISHES && wish.visitor >= 1);
    }
    struct event left = {.kind = EVENT_LEFT, .device = 1, .time_us = time_us};
    for (int source = 0; source <= SOURCE_FAKE; source++) {
        left.source = (enum event_source)source;
        controls_feel(controls, &left);
    }
    assert(!controls_are_held(controls));
    controls_destroy(controls);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct script_def def = script_default_def();
    def.raster_values_max = 1 << 14;
    struct report report;
    report_init(&report, "i.yaml");
    struct inputs *inputs = inputs_parse((const char *)data, size, ".", NULL, &def, &report);
    assert(!inputs == !report_empty(&report));
    if (inputs) {
        check_lines(inputs->buttons, inputs->button_count);
        check_lines(inputs->encoders, inputs->encoder_count);
        check_lines(inputs->lamps, inputs->lamp_count);
        for (int i = 0; i < inputs->binding_count; i++) {
            check_binding(inputs, &inputs->bindings[i]);
        }
        shake(inputs);
    }
    char *text = report_text(&report);
    assert(text);
    free(text);
    inputs_destroy(inputs);
    report_finish(&report);
    return 0;
}
