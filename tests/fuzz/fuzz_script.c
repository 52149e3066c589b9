/* Any bytes as a session script: a report or a script, and no value of an accepted script out of its range. */
#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "brush.h"
#include "ink.h"
#include "script.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
const char *__lsan_default_suppressions(void);

/* libfyaml 0.7.12 loses up to 4 KiB where the syntax of a long scalar is wrong; leaks of our own still count. */
const char *__lsan_default_suppressions(void)
{
    return "leak:libfyaml.so";
}

static void check(const struct key *keys, const void *object)
{
    for (; keys->name; keys++) {
        const char *at = (const char *)object + keys->offset;
        if (keys->type == KEY_NUMBER) {
            float value = 0;
            memcpy(&value, at, sizeof value);
            assert(isfinite(value) && value >= (float)keys->min && value <= (float)keys->max);
        } else if (keys->type == KEY_INTEGER || (keys->type == KEY_CHOICE && keys->choices)) {
            int value = 0, most = (int)keys->max;
            memcpy(&value, at, sizeof value);
            for (int i = 0; keys->type == KEY_CHOICE && keys->choices[i]; i++) {
                most = i;
            }
            assert(value >= (int)keys->min && value <= most);
        }
    }
}

static void check_point(struct point point)
{
    assert(point.x >= 0 && point.x <= 1 && point.y >= 0 && point.y <= 1);
}

static void check_raster(const struct action_raster *raster, const struct script *script)
{
    if (raster->values) {
        assert(raster->width == script->width && raster->height == script->height);
        size_t count = (size_t)raster->width * (size_t)raster->height * (size_t)raster->channels;
        for (size_t i = 0; i < count; i++) {
            assert(fabsf(raster->values[i]) <= 65536);
        }
    }
}

static void check_action(const struct action *action, const struct script *script)
{
    assert(action->verb < ACTION_VERBS && action->tick >= 0 && action->tick <= SCRIPT_TICKS_MAX);
    check(action_keys(action->verb), action);
    check_point(action->at);
    for (int i = 0; i < action->path.count; i++) {
        check_point(action->path.points[i]);
    }
    assert(action->ink >= 0 && action->ink < script->ink_count);
    assert(action->brush == BRUSH_NONE || brushes[action->brush].name);
    if (action->verb == ACTION_SET) {
        const struct key *key = &coefficient_keys[action->coefficient];
        bool choice = key->type == KEY_CHOICE;
        assert(choice || (action->value >= (float)key->min && action->value <= (float)key->max));
    }
    check_raster(&action->formula, script);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct script_def def = script_default_def();
    def.raster_values_max = 1 << 14; /* sheets of up to 128 x 128 have formulas: quick, and the limit is met too */
    struct report report;
    report_init(&report, "s.yaml");
    struct script *script = script_parse((const char *)data, size, ".", &def, &report);
    assert(!script == !report_empty(&report));
    if (script) {
        check(script_keys, script);
        check(canvas_keys, script);
        check(coefficient_keys, &script->coefficients);
        assert(script->ink_count >= 1 && script->ink_count <= PAINTING_INKS);
        for (int i = 0; i < script->ink_count; i++) {
            assert(script->inks[i] >= 0);
        }
        for (int i = 0; i < script->action_count; i++) {
            check_action(&script->actions[i], script);
            assert(i == 0 || script->actions[i - 1].tick <= script->actions[i].tick);
        }
    }
    char *text = report_text(&report);
    assert(text);
    free(text);
    script_destroy(script);
    report_finish(&report);
    return 0;
}
