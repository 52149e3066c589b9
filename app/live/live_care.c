#include "live_care.h"

#include <string.h>

#include "bench.h"

static const float FRAME_MS_LEAST = 33.3f; /* thirty frames a second are enough for what grows */

bool live_care_init(struct live_care *care, const struct script *script, int display_mhz, double ticks_per_second)
{
    struct governor_def def = governor_default_def();
    float period_ms = display_mhz > 0 ? 1e6f / (float)display_mhz : 0;
    *care = (struct live_care){.ticks_wanted = (float)ticks_per_second, .thermal = thermal_create(NULL)};
    def.frame_ms = 1.2f * period_ms > FRAME_MS_LEAST ? 1.2f * period_ms : FRAME_MS_LEAST;
    for (int i = 0; script->action_count == 0 && brushes[i].name; i++) { /* of an exhibit: any brush may come */
        governor_admit_brush(&def, &brushes[i]);
    }
    for (int i = 0; i < script->action_count; i++) {
        const struct action *action = &script->actions[i];
        if (action->verb == ACTION_DROP && action->brush != BRUSH_NONE) {
            governor_admit_brush(&def, &brushes[action->brush]);
        }
    }
    care->governor = governor_start(&def, &script->coefficients);
    return care->thermal;
}

void live_care_change(struct live_care *care, const struct script *script)
{
    governor_rebase(&care->governor, &script->coefficients);
    care->sessions = 0; /* what is wanted is said again */
}

void live_care_finish(struct live_care *care)
{
    thermal_destroy(care->thermal);
    *care = (struct live_care){.thermal = NULL};
}

static void set(struct studio *studio, const char *coefficient, float value)
{
    const struct key *key = key_find(coefficient_keys, coefficient);
    struct action action = action_default(ACTION_SET);
    action.coefficient = (int)(key - coefficient_keys);
    action.value = value;
    studio_post(studio, &action);
}

/* Steps at once; another grid only while nobody paints. */
static void apply(struct live_care *care, struct studio *studio, const struct studio_report *report, bool touched)
{
    struct governor_level level = governor_level(&care->governor);
    if (care->applied != care->governor.wanted || care->sessions != report->sessions) {
        set(studio, "fluid_steps", (float)level.fluid_steps);
        set(studio, "pattern_steps", (float)level.pattern_steps);
        set(studio, "dt", level.dt);
        care->sessions = report->sessions;
    }
    bool other = level.scale < report->scale || level.scale > report->scale;
    if (other && !touched) {
        studio_scale(studio, level.scale);
    }
    if (!other) {
        care->applied = care->governor.wanted;
    }
}

const char *live_care_frame(struct live_care *care, struct studio *studio, double frame_ms, bool touched)
{
    struct studio_report report = studio_report(studio);
    int64_t now_us = (int64_t)(1e6 * bench_wall_s());
    struct thermal_reading heat = thermal_read(care->thermal, now_us);
    struct governor_sample sample = {.now_us = now_us,
                                     .frame_ms = (float)frame_ms,
                                     .tick_ms = (float)report.tick_ms,
                                     .ticks_per_second = (float)report.ticks_per_second,
                                     .ticks_wanted = report.idle ? 0 : care->ticks_wanted,
                                     .celsius = heat.celsius,
                                     .throttled = heat.throttled,
                                     .applied = care->applied};
    const char *line = governor_step(&care->governor, &sample);
    if (care->governor.wanted != care->applied || care->sessions != report.sessions) {
        apply(care, studio, &report, touched);
    }
    if (!line && heat.under_voltage != care->weak) {
        care->weak = heat.under_voltage;
        line = care->weak ? "the board's supply is too weak" : "the board's supply is strong enough again";
    }
    return line;
}
